# Check every include of a tree against the arrows between its rooms:  check_arrows.sh TREE  (table: arrows.txt)
# Prints a line "file:line: cause" for each include that breaks one, and ends with 1 where there was any.
set -eu
table=$(cd "$(dirname "$0")" && pwd)/arrows.txt
cd "$1"
find kernel io apps samples -type f \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' \) 2>/dev/null | LC_ALL=C sort |
    awk -v table="$table" '
function complain(cause) {
    print file ":" line ": " cause
    broken++
}

# the room a file lives in: kernel/<room>, io/<room>, or the top-level folder
function room_of(path, part) {
    split(path, part, "/")
    return part[1] == "kernel" || part[1] == "io" ? part[1] "/" part[2] : part[1]
}

# C and POSIX headers by name, C++ ones by their form
function is_standard(header) {
    return header ~ /^(assert|complex|ctype|errno|fenv|float|inttypes|iso646|limits|locale|math|setjmp|signal)\.h$/ ||
           header ~ /^(stdalign|stdarg|stdatomic|stdbool|stddef|stdint|stdio|stdlib|stdnoreturn|string)\.h$/ ||
           header ~ /^(tgmath|threads|time|uchar|wchar|wctype)\.h$/ ||
           header ~ /^(dirent|fcntl|getopt|libgen|poll|pthread|strings|termios|unistd)\.h$/ || header ~ /^sys\/[a-z]+\.h$/ ||
           header == "omp.h" || header ~ /^[a-z_]+$/
}

# CGAL and Eigen stay inside the adapters that carry their name
function is_adapted(header) {
    return (header ~ /^(CGAL|boost)\// && file ~ /_cgal\.cpp$/) || (header ~ /^Eigen\// && file ~ /_(eigen|cgal)\.cpp$/)
}

function check_quoted(header, room, part) {
    if (room == "kernel/include" || room == "samples") {
        complain("\"" header "\": " room " sees <wirecut/...> alone")
    } else if (header !~ /\//) {
        if (room ~ /^kernel/) complain("\"" header "\": expected \"room/file\"")
        else if (room ~ /^io/) complain("\"" header "\": expected \"io/room/file\"")
    } else if (header ~ /^io\//) {
        split(header, part, "/")
        if (header ~ /\.\./ || !(("io/" part[2]) in sees)) complain("\"" header "\": no such room")
        else if (room != "io/" part[2] && !index(sees[room], " io/" part[2] " "))
            complain("\"" header "\": " room " does not see io/" part[2])
    } else {
        split(header, part, "/")
        if (header ~ /\.\./ || !(("kernel/" part[1]) in sees)) complain("\"" header "\": no such room")
        else if (room != "kernel/" part[1] && !index(sees[room], " " part[1] " "))
            complain("\"" header "\": " room " does not see " part[1])
    }
}

# public headers whose functions stand in libwirecut-io
function is_of_files(header) {
    return header ~ /^wirecut\/([a-z_]+_file|case|exchange|read|write|report|report_pages|study|sweep)\.h$/
}

function check_angled(header, room, count, item, i) {
    if (room ~ /^kernel\// && room != "kernel/include" && is_of_files(header))
        complain("<" header ">: the kernel does not see files")
    if (header ~ /^wirecut\// || is_standard(header) || is_adapted(header)) return
    count = split(sees[room], item, " ")
    for (i = 1; i <= count; i++) {
        if (item[i] == "<" header ">") return
        if (item[i] ~ /\/>$/ && index("<" header, substr(item[i], 1, length(item[i]) - 1)) == 1) return
    }
    complain("<" header ">: " room " does not see this library")
}

BEGIN {
    while ((status = (getline row < table)) > 0) {
        if (row ~ /^#/ || row !~ /:/) continue
        room = row
        sub(/[ \t]*:.*/, "", room)
        sub(/[^:]*:/, "", row)
        sees[room] = " " row " "
    }
    if (status < 0) { print table ": cannot be read"; exit 2 }
}

{
    file = $0
    line = 0
    files++
    room = room_of(file)
    if (!(room in sees)) { complain("room " room " is not in arrows.txt"); next }
    if (file ~ /\.(cpp|hpp)$/ && room != "samples" && file !~ /(_cgal|_eigen)\.cpp$/ && file !~ /guard\.hpp$/)
        complain("C++ outside *_cgal.cpp and *_eigen.cpp")
    while ((getline text < file) > 0) {
        line++
        if (text !~ /^[ \t]*#[ \t]*include/) continue
        if (match(text, /"[^"]*"/)) check_quoted(substr(text, RSTART + 1, RLENGTH - 2), room)
        else if (match(text, /<[^>]*>/)) check_angled(substr(text, RSTART + 1, RLENGTH - 2), room)
        else complain("neither \"...\" nor <...>")
    }
    close(file)
}

END {
    if (!files) { print "no sources found"; exit 2 }
    print files " files, " broken + 0 " broken arrows"
    exit broken > 0
}'
