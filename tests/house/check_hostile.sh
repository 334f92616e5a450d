# Every public function has a hostile call:  check_hostile.sh HEADER_FOLDER TEST_FOLDER
# An entry begins a line with HOSTILE(NAME) or another macro of hostile.h whose first argument is the function. Prints a line
# for each function without one and each entry without a function, and ends with 1 where there was any.
set -eu
LC_ALL=C
export LC_ALL
cat "$1"/*.h | awk '
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
[ -s declared ] || { echo "$1: no WCUT_API function found"; exit 2; }
sed -n 's/^HOSTILE[A-Z_]*(\(wcut_[a-z0-9_]*\).*/\1/p' "$2"/*.c | sort >entries
uniq -d entries | sed 's/$/: two entries/' >complaints
comm -23 declared entries | sed "s|\$|: no hostile call, see tests/hostile/hostile.h|" >>complaints
sort -u entries | comm -13 declared - | sed 's/$/: a hostile call of no public function/' >>complaints
cat complaints
echo "$(wc -l <declared) functions, $(wc -l <entries) entries"
[ ! -s complaints ]
