# No function over 25 lines without a comment inside:  check_comments.sh TREE ALLOWED
# ALLOWED: so many may still be without one; the number may only shrink. Prints a line "FILE:LINE: cause" for each where
# there are more, and ends with 1.
set -eu
LC_ALL=C
export LC_ALL
here=$(cd "$(dirname "$0")" && pwd)
allowed=$2
cd "$1"
find kernel io apps -type f \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' \) 2>/dev/null | sort |
    xargs awk -f "$here/functions.awk" | awk -v allowed="$allowed" '
    { functions++ }
    $4 > 25 && $5 == 0 { found++; text = text $1 ":" $2 ": " $3 ": " $4 " lines without a comment inside\n" }
    END {
        if (!functions) { print "no functions found"; exit 2 }
        if (found > allowed) printf "%s", text
        print functions " functions, " found + 0 " over 25 lines without a comment inside, at most " allowed
        exit found > allowed
    }'
