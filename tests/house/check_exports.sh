# A shared library exports what its headers declare and nothing else:  check_exports.sh LIBRARY HEADER_FOLDER
# Prints a line for each symbol too many or too few, and ends with 1 where there was any.
set -eu
LC_ALL=C
export LC_ALL
nm -D --defined-only "$1" | awk '$2 != "A" { print $NF }' | sort -u >exported
# declarations run over several lines: read each header as one text, comments taken out
cat "$2"/*.h | awk '
{ text = text " " $0 }
END {
    while (match(text, /\/\*([^*]|\*+[^*\/])*\*+\//)) text = substr(text, 1, RSTART - 1) " " substr(text, RSTART + RLENGTH)
    while (match(text, /WCUT_API[^;({]*[ *]wcut_[a-z0-9_]+ *\(/)) {
        declaration = substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
        sub(/ *\($/, "", declaration)
        sub(/.*[ *]/, "", declaration)
        print declaration
    }
}' | sort -u >declared
[ -s declared ] || { echo "$2: no WCUT_API function found"; exit 2; }
grep -v '^wcut_' exported | sed 's/$/: exported without the prefix wcut_/' >complaints || true
comm -23 declared exported | sed 's/$/: declared WCUT_API, not exported/' >>complaints
comm -13 declared exported | sed 's/$/: exported, not declared in a public header/' >>complaints
cat complaints
echo "$(wc -l <declared) declared, $(wc -l <exported) exported"
[ ! -s complaints ]
