# Shared libraries export what their headers declare and nothing else:  check_exports.sh HEADER_FOLDER LIBRARY...
# A symbol stands in one of them. Prints a line for each symbol too many or too few, and ends with 1 where there was any.
set -eu
LC_ALL=C
export LC_ALL
folder=$1
shift
for library in "$@"; do nm -D --defined-only "$library"; done | awk '$2 != "A" { print $NF }' | sort >exports
sort -u exports >exported
cat "$folder"/*.h | awk -f "$(dirname "$0")/declared.awk" | sort -u >declared
[ -s declared ] || { echo "$folder: no WCUT_API function found"; exit 2; }
grep -v '^wcut_' exported | sed 's/$/: exported without the prefix wcut_/' >complaints || true
comm -23 declared exported | sed 's/$/: declared WCUT_API, not exported/' >>complaints
comm -13 declared exported | sed 's/$/: exported, not declared in a public header/' >>complaints
uniq -d exports | sed 's/$/: exported by both libraries/' >>complaints
cat complaints
echo "$(wc -l <declared) declared, $(wc -l <exported) exported"
[ ! -s complaints ]
