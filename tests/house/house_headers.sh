# Every public header stands alone, as C11 and as C++17, without a warning, and is in the umbrella; planted ones are not.
set -eu

# alone FOLDER: compile each FOLDER/wirecut/*.h on its own, in both languages
alone() {
    warnings='-Wall -Wextra -Wpedantic -Werror'
    count=0
    for header in "$1"/wirecut/*.h; do
        name=$(basename "$header")
        printf '#include <wirecut/%s>\n#include <wirecut/%s>\nextern int alone;\n' "$name" "$name" >alone.c
        cp alone.c alone.cpp
        # shellcheck disable=SC2086 # the warnings are several words
        "$CC" -std=c11 $warnings -Wstrict-prototypes -fsyntax-only -I"$1" alone.c || return 1
        # shellcheck disable=SC2086
        "$CXX" -std=c++17 $warnings -fsyntax-only -I"$1" alone.cpp || return 1
        grep -q 'extern "C"' "$header" || ! grep -q WCUT_API "$header" || [ "$name" = export.h ] ||
            { echo "$name: functions without extern \"C\""; return 1; }
        [ "$name" = wirecut.h ] || grep -q "^#include <wirecut/$name>" "$1/wirecut/wirecut.h" ||
            { echo "$name: not in wirecut.h"; return 1; }
        count=$((count + 1))
    done
    echo "$count headers"
}
plant() {
    mkdir -p planted/wirecut
    printf '#include <wirecut/a.h>\n' >planted/wirecut/wirecut.h
    printf '%b' "$1" >planted/wirecut/a.h
}
refused() {
    plant "$2"
    if alone planted >found 2>&1; then
        echo "not noticed: $1"
        exit 1
    fi
}

plant 'int wcut_count(void);\n'
alone planted
refused 'a missing include' 'size_t wcut_count(void);\n'
refused 'a word of C++' 'int wcut_count(int class);\n'
refused 'no include guard' 'struct wcut_a { int b; };\n'
refused 'no prototype' 'int wcut_count();\n'
refused 'C++ linkage' '#define WCUT_API\nWCUT_API int wcut_count(void);\n'

alone "$SOURCE_DIR/kernel/include"
