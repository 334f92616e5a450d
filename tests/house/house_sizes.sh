# A file is one idea: no source of kernel, io or apps is longer than 600 lines, no public header than 400.
set -eu
cd "$SOURCE_DIR"

# too_long LIMIT: of the files named on stdin, those with more lines
too_long() {
    while read -r file; do
        lines=$(wc -l <"$file")
        [ "$lines" -le "$1" ] || echo "$file: $lines lines, at most $1"
    done
}
seq 601 >"$OLDPWD/long.c"
[ -n "$(echo "$OLDPWD/long.c" | too_long 600)" ] || { echo "not noticed: a file of 601 lines"; exit 1; }

find kernel io apps -type f \( -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' \) | LC_ALL=C sort >"$OLDPWD/sources"
[ -s "$OLDPWD/sources" ] || { echo "no sources"; exit 1; }
complaints=$(too_long 600 <"$OLDPWD/sources"; grep '^kernel/include/' "$OLDPWD/sources" | too_long 400)
[ -z "$complaints" ] || { echo "$complaints"; exit 1; }
echo "$(wc -l <"$OLDPWD/sources") files"
