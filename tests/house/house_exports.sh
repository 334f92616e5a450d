# libwirecut.so exports the functions of the public headers, all of them and no symbol more; planted ones are noticed.
set -eu
check=$SOURCE_DIR/tests/house/check_exports.sh

mkdir headers
cat >headers/a.h <<'END'
/* WCUT_API int wcut_in_a_comment(void); */
WCUT_API const char *wcut_first(int a,
                                int b);
WCUT_API wcut_status
wcut_second(void);
END
# built SYMBOL...: a library that exports these functions
built() {
    for symbol in "$@"; do echo "int $symbol(void); int $symbol(void) { return 0; }"; done >planted.c
    "$CC" -shared -fPIC -o planted.so planted.c
}
refused() {
    cause=$1
    shift
    built "$@"
    if sh "$check" planted.so headers >found || ! grep -q "$cause" found; then
        echo "not noticed: $cause"
        cat found
        exit 1
    fi
}

built wcut_first wcut_second
sh "$check" planted.so headers
refused 'wcut_second: declared WCUT_API, not exported' wcut_first
refused 'wcut_third: exported, not declared' wcut_first wcut_second wcut_third
refused 'helper: exported without the prefix' wcut_first wcut_second helper

sh "$check" "$LIBRARY" "$SOURCE_DIR/kernel/include/wirecut"
