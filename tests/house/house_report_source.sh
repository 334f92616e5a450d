# The report page's source keeps to 120 columns and to its linter; a planted long line and an unused name are noticed.
set -eu
check=$SOURCE_DIR/tests/report/check_source.sh
sh "$check" "$SOURCE_DIR"

# plant TEXT: a tree whose page is one file of this text
plant() {
    rm -rf tree
    mkdir -p tree/apps/report/src
    cp "$SOURCE_DIR/apps/report/build.mjs" "$SOURCE_DIR/apps/report/biome.json" "$SOURCE_DIR/apps/report/src/page.css" tree/
    mv tree/build.mjs tree/biome.json tree/apps/report/
    mv tree/page.css tree/apps/report/src/
    printf '%s\n' "$1" >tree/apps/report/src/main.js
    [ ! -d "$SOURCE_DIR/apps/report/node_modules" ] || ln -s "$SOURCE_DIR/apps/report/node_modules" tree/apps/report/
}
plant "const a = '$(seq -s , 60)';"
if sh "$check" tree >found 2>&1 || ! grep -q '^src/main.js:1: 1.. columns' found; then
    echo "not noticed: a long line"
    cat found
    exit 1
fi
[ -x "$SOURCE_DIR/apps/report/node_modules/.bin/biome" ] || exit 0
plant "import {number} from './text.js';"
if sh "$check" tree >found 2>&1 || ! grep -q 'noUnusedImports' found; then
    echo "not noticed: an unused import"
    cat found
    exit 1
fi
