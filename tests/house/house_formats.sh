# Every key that the code reads or writes stands in kernel/FORMATS.md, and every key there in the code; planted ones that
# do not are noticed.
set -eu
check=$SOURCE_DIR/tests/house/check_formats.py

# plant: a tree with one format, whole
plant() {
    rm -rf tree
    mkdir -p tree/kernel tree/io/process tree/apps
    cat >tree/io/process/part_read.c <<'END'
static const wcut_field fields[] = {
    IN_JOB(size, "size_mm", true, read_size), PART("name", false, read_name), {"law", true, read_law, 0}};
static const wcut_known_column known[] = {{"heat_W_per_m", "heat", "W_per_m", true}};
END
    cat >tree/io/process/part_write.c <<'END'
wcut_text_print(text, "{\"size_mm\": %d, "
                      "\"mean\": %d}", a, b);
put_half(text, "lower", half);
wcut_text_print(text, "time_s,phase,a_x_mm\n");
END
    cat >tree/kernel/FORMATS.md <<'END'
## Part

Source: `io/process/part_read.c`,
`io/process/part_write.c`

| key | meaning |
|---|---|
| `size_mm`, `lower.name` | |
| `law`, `mean`, `lower` | |

Columns: `heat_W_per_m`, `time_s`, `phase`, `a_x_mm`.
END
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
sed -i 's/`size_mm`, //' tree/kernel/FORMATS.md
refused 'io/process/part_read.c: key "size_mm" is not in kernel/FORMATS.md: add a row'
refused 'io/process/part_write.c: key "size_mm"'
plant
sed -i 's/`law`, //' tree/kernel/FORMATS.md
refused 'key "law"'
plant
sed -i 's/lower/upper/g' tree/kernel/FORMATS.md
refused 'key "lower"'
refused '`upper` is in none of io/process/part_read.c, io/process/part_write.c: rename or remove the row'
plant
sed -i 's/, `a_x_mm`/, a_x_mm/' tree/kernel/FORMATS.md
refused 'key "a_x_mm"'
plant
sed -i 's/`heat_W_per_m`, //' tree/kernel/FORMATS.md
refused 'key "heat_W_per_m"'
plant
cat >>tree/kernel/FORMATS.md <<'END'

| what | key |
|---|---|
| of old | `old_key` |
END
refused '`old_key` is in none of'
plant
printf 'wcut_text_print(text, "{\\"new\\": 1}");\n' >tree/apps/verb.c
refused 'apps/verb.c: has keys (new) that no section of kernel/FORMATS.md documents'
plant
mv tree/io/process/part_write.c tree/io/process/half_write.c
refused 'names io/process/part_write.c, which does not exist'
plant
sed -i 's/^/    /' tree/kernel/FORMATS.md
sed -i '1s/.*/```text/' tree/kernel/FORMATS.md
refused 'has keys'

python3 "$check" "$SOURCE_DIR" >found || { cat found; exit 1; }
# so many at least: fewer mean that readers or writers are written in a way that the check does not see
keys=$(sed -n 's/^\([0-9]*\) keys, 0 faults$/\1/p' found)
[ "$keys" -ge 850 ] || { echo "$keys keys found, expected 850 or more: teach check_formats.py how keys are written"; exit 1; }
cat found
