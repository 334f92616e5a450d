# Every public reader of a file has a fuzz target in tests/fuzz; a missing one is noticed.
set -eu
check=$SOURCE_DIR/tests/house/check_fuzz.sh

mkdir headers fuzz
printf 'WCUT_API wcut_status wcut_first_read(const char *path, int *a);\nWCUT_API wcut_status wcut_job_read(const char *path);\n' >headers/a.h
echo 'wcut_job_parse(a); wcut_first_reader(a);' >fuzz/a.c
if sh "$check" headers fuzz >found || ! grep -q 'wcut_first_read: no fuzz target' found || grep -q 'wcut_job_read:' found; then
    cat found
    exit 1
fi
echo 'wcut_first_read(a);' >fuzz/b.c
sh "$check" headers fuzz

sh "$check" "$SOURCE_DIR/kernel/include/wirecut" "$SOURCE_DIR/tests/fuzz"
