# A symbol that users link does not go away unannounced: kernel/symbols.txt lists what the libraries export.
set -eu
LC_ALL=C
export LC_ALL

# gone LIST EXPORTED: a line for each listed symbol that is not exported
gone() {
    grep -v '^#' "$1" | sort -u >listed
    comm -23 listed "$2" | sed 's/$/: gone: say so in CHANGELOG.md and take it out of kernel\/symbols.txt/'
}

printf 'wcut_a\nwcut_b\n' >planted_list
printf 'wcut_b\nwcut_c\n' >planted_exports
[ "$(gone planted_list planted_exports | cut -d: -f1)" = wcut_a ] || { echo "not noticed: a symbol that went away"; exit 1; }

for library in "$LIBRARY" "$IO_LIBRARY"; do nm -D --defined-only "$library"; done |
    awk '$3 ~ /^wcut_/ { print $3 }' | sort -u >exported
gone "$SOURCE_DIR/kernel/symbols.txt" exported >missing
cat missing
[ ! -s missing ]
comm -13 listed exported | sed 's/$/: new: add it to kernel\/symbols.txt/' >added
cat added
[ ! -s added ]
