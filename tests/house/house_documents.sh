# Documents, files, functions and tests that documents and comments name exist; planted ones that do not are noticed.
set -eu
check=$SOURCE_DIR/tests/house/check_documents.py

# plant: a tree in which everything named exists
plant() {
    rm -rf tree
    mkdir -p tree/kernel/cut tree/kernel/include/wirecut tree/tests/house tree/apps tree/io
    echo 'cut : base' | sed 's,cut,kernel/cut,' >tree/tests/house/arrows.txt
    echo '/* The whole (FORMATS.md, Job). */' >tree/kernel/cut/step.c
    echo 'int wcut_step(int a) { return a; }' >>tree/kernel/cut/step.c
    echo '    X(LAG, "lag", STEP)' >tree/kernel/include/wirecut/effects.h
    printf '#define APP_VERB_LIST(X) \\\n    X(cut)\n\n' >tree/apps/command.h
    echo '| `wirecut cut JOB` | cuts, [formats](kernel/FORMATS.md#job) |' >tree/README.md
    echo '## Job' >tree/kernel/FORMATS.md
    printf '| (1) to (11) | a = b | `kernel/cut/step.c:wcut_step` |\n| `lag` | t | `kernel/cut/step.c` |\n' >tree/kernel/NOTATION.md
    printf '| cut | [Why: so?](#2026-01-02-why-so) | `kernel/cut/step.c` |\n\n## 2026-01-02 Why: so?\n' >tree/kernel/DECISIONS.md
    echo '| `kernel/cut` | one step | base |' >tree/kernel/README.md
}
refused() {
    if python3 "$check" tree >found; then
        echo "not noticed: $1"
        exit 1
    fi
    grep -qF -- "$1" found || { echo "not named: $1"; cat found; exit 1; }
}

plant
python3 "$check" tree >found || { echo "wrongly refused"; cat found; exit 1; }
none=LAWS # a document that is not there
echo "/* as $none.md says */" >>tree/kernel/cut/step.c
refused "kernel/cut/step.c:3: $none.md is not in the repository"
plant
echo '/* as FORMATS says */' >>tree/kernel/cut/step.c
refused 'kernel/cut/step.c:3: the comment names FORMATS'
plant
echo '/* see FORMATS.md, Scan */' >>tree/kernel/cut/step.c
refused 'FORMATS.md has no section "Scan"'
plant
sed -i 's/wcut_step(int/wcut_stride(int/' tree/kernel/cut/step.c
refused '`kernel/cut/step.c` defines no function wcut_step'
plant
mv tree/kernel/cut/step.c tree/kernel/cut/stride.c
refused '`kernel/cut/step.c` does not exist'
plant
echo 'by wcut_stride' >>tree/README.md
refused 'wcut_stride is nowhere in the code'
plant
echo '[there](kernel/FORMATS.md#scan)' >>tree/README.md
refused 'link to kernel/FORMATS.md#scan: no such heading'
plant
echo '[there](kernel/LAWS.svg)' >>tree/README.md
refused 'link to kernel/LAWS.svg: no such file'
plant
echo 'held by `test_nothing`' >>tree/README.md
refused '`test_nothing`: there is no such test'
plant
sed -i 's/(1) to (11)/(1) to (10)/' tree/kernel/NOTATION.md
refused 'equation (11) has no row'
plant
echo '    X(DRIFT, "drift", STEP)' >>tree/kernel/include/wirecut/effects.h
refused 'effect drift has no row'
plant
echo '## 2026-01-03 And then' >>tree/kernel/DECISIONS.md
refused 'not in the index: add a row to the table By room: | room | [And then](#2026-01-03-and-then) |'
plant
sed -i 's/ | `kernel.cut.step.c` |$/ | |/' tree/kernel/DECISIONS.md
refused 'its row in the index names no file'
plant
mkdir tree/kernel/foam
refused 'room `kernel/foam` has no row'
plant
sed -i 's/: base/: base wire/' tree/tests/house/arrows.txt
refused 'room `kernel/cut`: it sees base, wire'
plant
sed -i 's/X(cut)/X(cut) X(sew)/' tree/apps/command.h
refused 'verb sew has no row'

python3 "$check" "$SOURCE_DIR"
