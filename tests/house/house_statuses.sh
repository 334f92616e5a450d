# The docstring of every public function that gives a status names them; a planted one without is noticed.
set -eu
check=$SOURCE_DIR/tests/house/check_statuses.sh

mkdir headers
printf '/** Good.\n * @return WCUT_OK. */\nWCUT_API wcut_status wcut_good(int a);\n' >headers/a.h
sh "$check" headers
printf '/** Good.\n * @return WCUT_OK. */\nWCUT_API wcut_status wcut_good(int a);\nWCUT_API wcut_status wcut_bad(int a);\n' >headers/a.h
if sh "$check" headers >found || ! grep -q 'wcut_bad' found; then
    echo "not noticed: a function without statuses"
    exit 1
fi
printf '/** Good.\n * @return WCUT_OK. */\nWCUT_API wcut_status wcut_good(int a);\nWCUT_API int wcut_mute(void);\n' >headers/a.h
if sh "$check" headers >found || ! grep -q 'wcut_mute' found; then
    echo "not noticed: a function without a docstring"
    exit 1
fi

sh "$check" "$SOURCE_DIR/kernel/include/wirecut"
