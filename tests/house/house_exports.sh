# libwirecut.so and libwirecut-io.so export the functions of the public headers, each once, and no symbol more; planted
# ones are noticed. The kernel needs no format library.
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
    if sh "$check" headers planted.so >found || ! grep -q "$cause" found; then
        echo "not noticed: $cause"
        cat found
        exit 1
    fi
}

built wcut_first wcut_second
sh "$check" headers planted.so
refused 'wcut_second: declared WCUT_API, not exported' wcut_first
refused 'wcut_third: exported, not declared' wcut_first wcut_second wcut_third
refused 'helper: exported without the prefix' wcut_first wcut_second helper

built wcut_first wcut_second
cp planted.so twice.so
if sh "$check" headers planted.so twice.so >found || ! grep -q 'wcut_first: exported by both' found; then
    echo "not noticed: a symbol in both libraries"
    exit 1
fi

sh "$check" "$SOURCE_DIR/kernel/include/wirecut" "$LIBRARY" "$IO_LIBRARY"

# a controller that computes carries no file formats
if objdump -p "$LIBRARY" | grep -E 'NEEDED.*(assimp|jansson|draco|minizip|libz)'; then
    echo "$LIBRARY needs a format library"
    exit 1
fi
