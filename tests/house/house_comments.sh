# No function over 25 lines without a comment inside, but for those of before the rule; a planted one is noticed.
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
if sh "$check" tree 0 >found || ! grep -q '^kernel/base/a.c:1: one: 3. lines' found; then
    echo "not noticed: a function without a comment"
    cat found
    exit 1
fi
sh "$check" tree 1
plant 30 '    /* what follows */'
sh "$check" tree 0
plant 15 ''
sh "$check" tree 0

sh "$check" "$SOURCE_DIR" 75
