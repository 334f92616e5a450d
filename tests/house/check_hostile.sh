# Every public function has a hostile call:  check_hostile.sh HEADER_FOLDER TEST_FOLDER
# An entry begins a line with HOSTILE(NAME) or another macro of hostile.h whose first argument is the function. Prints a line
# for each function without one and each entry without a function, and ends with 1 where there was any.
set -eu
LC_ALL=C
export LC_ALL
cat "$1"/*.h | awk -f "$(dirname "$0")/declared.awk" | sort -u >declared
[ -s declared ] || { echo "$1: no WCUT_API function found"; exit 2; }
sed -n 's/^HOSTILE[A-Z_]*(\(wcut_[a-z0-9_]*\).*/\1/p' "$2"/*.c | sort >entries
uniq -d entries | sed 's/$/: two entries/' >complaints
comm -23 declared entries | sed "s|\$|: no hostile call, see tests/hostile/hostile.h|" >>complaints
sort -u entries | comm -13 declared - | sed 's/$/: a hostile call of no public function/' >>complaints
cat complaints
echo "$(wc -l <declared) functions, $(wc -l <entries) entries"
[ ! -s complaints ]
