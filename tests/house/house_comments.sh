# No function over 25 lines without a comment inside; a planted one is noticed.
set -eu
check=$SOURCE_DIR/tests/house/check_comments.sh

# plant LINES COMMENT: a file with one function of so many statements
plant() {
    rm -rf tree
    mkdir -p tree/kernel/base
    {
        printf 'static int one(int a,\n    int b) {\n%s\n' "$2"
        seq -f '    a += %.0f;' "$1"
        printf '    return a;\n}\n'
    } >tree/kernel/base/a.c
}
plant 30 ''
if sh "$check" tree >found || ! grep -q '^kernel/base/a.c:1: one: 3. lines' found; then
    echo "not noticed: a function without a comment"
    cat found
    exit 1
fi
plant 30 '    /* what follows */'
sh "$check" tree
plant 15 ''
sh "$check" tree

sh "$check" "$SOURCE_DIR"
