# No function over 25 lines without a comment inside:  check_comments.sh TREE
# Prints a line "FILE:LINE: cause" for each, and ends with 1.
set -eu
LC_ALL=C
export LC_ALL
here=$(cd "$(dirname "$0")" && pwd)
cd "$1"
find kernel io apps -type f \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' \) 2>/dev/null | sort |
    xargs awk -f "$here/functions.awk" | awk '
    { functions++ }
    $4 > 25 && $5 == 0 { found++; print $1 ":" $2 ": " $3 ": " $4 " lines without a comment inside" }
    END {
        if (!functions) { print "no functions found"; exit 2 }
        print functions " functions, " found + 0 " over 25 lines without a comment inside"
        exit found > 0
    }'
