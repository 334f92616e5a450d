# Every public function has a hostile call in tests/hostile; a missing one is noticed.
set -eu
check=$SOURCE_DIR/tests/house/check_hostile.sh

mkdir headers calls
printf 'WCUT_API int wcut_first(int a,\n    int b);\nWCUT_API void wcut_second(void);\n' >headers/a.h
refused() {
    printf '%b' "$2" >calls/a.c
    if sh "$check" headers calls >found || ! grep -q "$1" found; then
        echo "not noticed: $1"
        cat found
        exit 1
    fi
}
refused 'wcut_second: no hostile call' 'HOSTILE(wcut_first) {\n'
refused 'wcut_third: a hostile call of no' 'HOSTILE(wcut_first) {\nHOSTILE_VALUE(wcut_second, NULL)\nHOSTILE(wcut_third) {\n'
refused 'wcut_first: two entries' 'HOSTILE(wcut_first) {\nHOSTILE_VALUE(wcut_second, NULL)\nHOSTILE(wcut_first) {\n'
printf 'HOSTILE(wcut_first) {\nHOSTILE_VALUE(wcut_second, NULL)\n' >calls/a.c
sh "$check" headers calls

sh "$check" "$SOURCE_DIR/kernel/include/wirecut" "$SOURCE_DIR/tests/hostile"
