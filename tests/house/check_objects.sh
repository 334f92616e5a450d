# What the library's objects must not call or keep:  check_objects.sh OBJECT...
# Kernel and io never print, exit, abort, read the environment or the locale, and keep no writable global state: the
# object says so more surely than a search in the source. The processes that io/file/child.c and io/study/sweep_pool.c fork are
# their own and end by _exit.
# Prints a line for each, and ends with 1 where there was any.
set -eu
LC_ALL=C
export LC_ALL
[ $# -gt 0 ] || { echo "no objects"; exit 2; }
for object in "$@"; do
    nm -u "$object" | awk -v object="$object" '
        { name = $NF; sub(/@.*/, "", name); sub(/^__/, "", name); sub(/_chk$/, "", name) }
        object ~ /\/io\/(file\/child|study\/sweep_pool)\.c\.o$/ && name == "_exit" { next }
        name ~ /^(abort|exit|_exit|_Exit|quick_exit|raise|signal|sigaction|longjmp|siglongjmp)$/ ||
        name ~ /^(printf|vprintf|puts|putchar|perror|stdout|stderr|stdin)$/ ||
        name ~ /^(getenv|secure_getenv|setenv|putenv|environ|setlocale|rand|srand|random|srandom|drand48)$/ {
            print object ": calls " name
        }'
    # .data.rel.ro and .rodata are constant; allowed are the countdown of the failing test allocator
    # and the size of the team of threads that libgomp keeps waiting, one for each thread, which no result depends on
    objdump -t "$object" | awk -v object="$object" '
        NF > 4 && $(NF - 2) ~ /^(\.data|\.bss|\.tdata|\.tbss|\*COM\*)/ && $(NF - 2) !~ /^\.data\.rel\.ro/ && $(NF - 1) !~ /^0+$/ &&
        $NF !~ /^(fail_countdown|team_size)(\.[0-9]+)?$/ { print object ": writable global " $NF }'
done >complaints
cat complaints
echo "$# objects"
[ ! -s complaints ]
