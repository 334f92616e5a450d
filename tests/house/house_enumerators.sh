# Public enumerators carry their type: those of wcut_phase begin with WCUT_PHASE_. A final _kind of the type's name may be
# left out. Statuses are exempt: they are the words of every call, WCUT_OK as SQLITE_OK.
set -eu

# untyped FOLDER: the enumerators of FOLDER/wirecut/wirecut.h that do not begin with the name of their type
untyped() {
    "$CC" -std=c11 -E -P -I"$1" "$1/wirecut/wirecut.h" | tr '\n' ' ' | sed 's/typedef enum/\n&/g' | awk '
    /^typedef enum wcut_[a-z0-9_]+ \{/ {
        type = $3
        sub(/^wcut_/, "", type)
        types++
        if (type == "status") next
        prefix = "WCUT_" toupper(type) "_"
        short = prefix
        sub(/_KIND_$/, "_", short)
        body = $0
        sub(/^[^{]*\{/, "", body)
        sub(/\}.*/, "", body)
        count = split(body, entry, ",")
        for (i = 1; i <= count; i++) {
            name = entry[i]
            gsub(/[ \t]|=.*/, "", name)
            if (name != "" && index(name, prefix) != 1 && index(name, short) != 1)
                print name ": not of the form " prefix "..., the type is wcut_" type
        }
    }
    END { if (!types) print "no enumeration found" }'
}
plant() {
    mkdir -p planted/wirecut
    printf '%b' "$1" >planted/wirecut/wirecut.h
}
plant 'typedef enum wcut_phase { WCUT_PHASE_A, WCUT_PHASE_B } wcut_phase;\ntypedef enum wcut_a_kind { WCUT_A_X = 1 } wcut_a_kind;\n'
[ -z "$(untyped planted)" ] || { echo "refused: good names"; untyped planted; exit 1; }
plant 'typedef enum wcut_phase { WCUT_PHASE_A, WCUT_B } wcut_phase;\n'
[ -n "$(untyped planted)" ] || { echo "not noticed: a name without its type"; exit 1; }
plant '#define LIST(X) X(A) X(B)\n#define ENTRY(n) WCUT_##n,\ntypedef enum wcut_phase { LIST(ENTRY) } wcut_phase;\n'
[ -n "$(untyped planted)" ] || { echo "not noticed: a name made by a list"; exit 1; }

untyped "$SOURCE_DIR/kernel/include" >complaints
cat complaints
[ ! -s complaints ]
