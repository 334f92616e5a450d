# A file is one idea: no source of kernel, io or apps has more than 540 lines of code, no public header more than 400 lines.
# Blank lines and lines of comment alone do not count as code: nobody saves on them.
set -eu
cd "$SOURCE_DIR"

# too_long LIMIT FILTER: of the files named on stdin, those of which FILTER leaves more lines
too_long() {
    while read -r file; do
        lines=$($2 <"$file" | wc -l)
        [ "$lines" -le "$1" ] || echo "$file: $lines lines, at most $1"
    done
}

# lines of code: neither blank nor inside a comment that begins its line
code() {
    awk '
        inside { if (/\*\//) inside = 0; next }
        /^[ \t]*\/\*/ { if (!/\*\//) inside = 1; if (!/\*\/[ \t]*[^ \t]/) next }
        !/^[ \t]*$/ && !/^[ \t]*\/\//'
}
seq 541 >"$OLDPWD/long.c"
[ -n "$(echo "$OLDPWD/long.c" | too_long 540 code)" ] || { echo "not noticed: a file of 541 lines"; exit 1; }
{ seq 540; printf '\n/* one\n   two */\n    // three\n'; } >"$OLDPWD/long.c"
[ -z "$(echo "$OLDPWD/long.c" | too_long 540 code)" ] || { echo "blank lines and comments are counted"; exit 1; }

find kernel io apps -type f \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' \) | LC_ALL=C sort >"$OLDPWD/sources"
[ -s "$OLDPWD/sources" ] || { echo "no sources"; exit 1; }
complaints=$(too_long 540 code <"$OLDPWD/sources"; grep '^kernel/include/' "$OLDPWD/sources" | too_long 400 cat)
[ -z "$complaints" ] || { echo "$complaints"; exit 1; }
echo "$(wc -l <"$OLDPWD/sources") files"
