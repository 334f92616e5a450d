# Print the style figures of a tree:  sh measure_style.sh [TREE [BUILD]]  (this tree where none is given)
#   comments and blank lines per 10 lines in functions of 20 to 60 lines, and the share of static functions of 20 lines
#   and more without a comment inside or above, by top folder; function names defined more than once; circles of includes
#   between files (a source and its header are one), and of calls between the objects of BUILD; lines.
set -eu
LC_ALL=C
export LC_ALL
here=$(cd "$(dirname "$0")" && pwd)
build=${2:+$(realpath "$2")}
cd "${1:-$here/../..}"
tree=$(pwd)
sources() { find "$@" -type f \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' \) 2>/dev/null | sort; }

echo "folder   lines  functions  20-60  comments/10  blanks/10  bare statics  over 25 bare"
for folder in kernel io apps tests samples; do
    sources "$folder" | xargs awk -f "$here/functions.awk" | awk -v folder="$folder" -v lines="$(sources "$folder" | xargs cat | wc -l)" '
        { functions++ }
        $4 >= 20 && $4 <= 60 { count++; long += $4; comments += $5; blanks += $6 }
        $4 >= 20 && $7 { statics++; if (!$5 && !$8) bare++ }
        $4 > 25 && !$5 { silent++ }
        END {
            if (!long) long = 1
            if (!statics) statics = 1
            printf "%-7s %6d %10d %6d %12.2f %10.2f %9d of %d = %.0f %% %8d\n", folder, lines, functions, count,
                10 * comments / long, 10 * blanks / long, bare, statics, 100 * bare / statics, silent
        }'
done

sources kernel io apps | xargs awk -f "$here/functions.awk" | awk '{ print $3 }' | sort | uniq -c | sort -k1,1nr -k2 | awk '
    $1 > 1 { names++; if (names <= 12) most = most " " $2 " " $1 }
    END { print "function names defined more than once in kernel, io, apps: " names + 0 " (" substr(most, 2) ")" }'

# circles KIND: of edges "FROM TO" on stdin, who reaches whom both ways
circles() {
    sort -u | awk -v kind="$1" '
    { edge[$1] = edge[$1] " " $2; node[$1]; node[$2] }
    # everything that `start` reaches
    function reach(start, stack, top, item, count, i) {
        top = 1
        stack[1] = start
        while (top > 0) {
            count = split(edge[stack[top--]], item, " ")
            for (i = 1; i <= count; i++) if (!((start, item[i]) in reaches)) { reaches[start, item[i]] = 1; stack[++top] = item[i] }
        }
    }
    END {
        for (n in node) reach(n)
        for (n in node) {
            if (!((n, n) in reaches) || n in seen) continue
            count++
            text = ""
            for (m in node) if (((n, m) in reaches) && ((m, n) in reaches)) { seen[m]; text = text " " m }
            print "circle of " kind ":" text
        }
        print "circles of " kind ": " count + 0
    }'
}

# an edge from each file to the files that it includes, both without their ending
sources kernel io apps | xargs awk '
    FNR == 1 { from = FILENAME; sub(/\.[a-z]+$/, "", from); folder = from; sub(/\/[^\/]*$/, "", folder) }
    /^#include "/ {
        split($0, part, "\"")
        to = part[2]
        sub(/\.[a-z]+$/, "", to)
        if (to ~ /^io\// || to ~ /^apps\//) ;
        else if (to ~ /\//) to = "kernel/" to
        else to = folder "/" to
        if (to != from) print from, to
    }
    /^#include <wirecut\// {
        split($0, part, /[<>]/)
        to = "kernel/include/" part[2]
        sub(/\.h$/, "", to)
        if (to != from) print from, to
    }' | circles includes

# an edge from each object to those that define what it calls
[ -n "$build" ] || exit 0
objects=$build/CMakeFiles/wirecut_objects.dir
(cd "$objects" && find . -name '*.c.o' | sed 's|^\./||' | sort | while read -r object; do
    [ -f "$tree/${object%.o}" ] || continue # left over from an earlier build
    nm "$object" | awk -v file="${object%.c.o}" '$(NF - 1) ~ /^[TDRB]$/ { print "defines", $NF, file } $(NF - 1) == "U" { print "uses", $NF, file }'
done) | sort | awk '
    $1 == "defines" { owner[$2] = $3 }
    $1 == "uses" && ($2 in owner) && owner[$2] != $3 { print $3, owner[$2] }' | circles calls
