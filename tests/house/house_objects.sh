# Kernel and io print nothing, end no process, read no environment and keep no global state; planted ones are noticed.
set -eu
check=$SOURCE_DIR/tests/house/check_objects.sh

# refused COMPLAINT SOURCE
refused() {
    printf '#include <stdio.h>\n#include <stdlib.h>\n%s\n' "$2" >planted.c
    "$CC" -O1 -fPIC -c -o planted.o planted.c
    if sh "$check" planted.o >found || ! grep -qx "planted.o: $1" found; then
        echo "not noticed: $2"
        exit 1
    fi
}
refused 'calls printf' 'void f(int n) { printf("%d\n", n); }'
refused 'calls puts' 'void f(void) { printf("text\n"); }'
refused 'calls stderr' 'void f(void) { fputs("text", stderr); }'
refused 'calls exit' 'void f(void) { exit(1); }'
refused 'calls abort' 'void f(void) { abort(); }'
refused 'calls getenv' 'char *f(void) { return getenv("HOME"); }'
refused 'writable global calls.*' 'int f(void) { static int calls; return ++calls; }'
refused 'writable global counter' 'int counter = 1; int f(void) { return counter++; }'
refused 'writable global counter' '_Thread_local int counter; int f(void) { return counter++; }'

cat >clean.c <<'END'
#include <stdio.h>
static const char *const word[] = {"one", "two"};
int f(char *text, int n, int i);
int f(char *text, int n, int i) { return snprintf(text, n, "%s exit(1)", word[i]); }
END
"$CC" -O1 -fPIC -c -o clean.o clean.c
sh "$check" clean.o

# adapters bring the habits of their libraries; their guard, not this test, keeps those inside
for kind in shared kernel io; do
    folder=$BUILD_DIR/CMakeFiles/wirecut_${kind}_objects.dir
    find "$folder" -name '*.c.o' | LC_ALL=C sort >objects
    while read -r object; do # an object whose source is gone is left over from an earlier build
        source=${object#"$folder/"}
        [ ! -f "$SOURCE_DIR/${source%.o}" ] || echo "$object"
    done <objects
done >present
[ -s present ] || { echo "$BUILD_DIR: no objects of kernel and io"; exit 1; }
tr '\n' '\0' <present | xargs -0 sh "$check"
