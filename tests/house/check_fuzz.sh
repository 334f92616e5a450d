# Every public reader of a file is fuzzed:  check_fuzz.sh HEADER_FOLDER FUZZ_FOLDER
# A reader is a function ..._read of a path; its target calls it, or one of the functions that it is made of, which stand
# here. Prints a line for each reader without a target, and ends with 1 where there was any.
set -eu
LC_ALL=C
export LC_ALL
made_of() {
    case $1 in
        wcut_cloud_read) echo wcut_cloud_source_create_memory ;;
        wcut_curve_set_read | wcut_mesh_read | wcut_trimmed_set_read) echo "$1_memory" ;;
        wcut_table_read) echo wcut_csv_parse ;;
        wcut_job_read_edges) echo wcut_curve_set_read_memory ;;
        wcut_case_read | wcut_correction_read | wcut_element_read | wcut_facade_read | wcut_format_read | wcut_job_read | \
            wcut_picture_read | wcut_rig_prior_read | wcut_study_read)
            echo "${1%_read}_parse" ;;
        *) echo "$1" ;;
    esac
}
sed -n 's/.*WCUT_API wcut_status \(wcut_[a-z_]*read[a-z_]*\)(.*const char \*path.*/\1/p' "$1"/*.h | sort -u >readers
[ -s readers ] || { echo "$1: no reader found"; exit 2; }
while read -r reader; do
    grep -qw "$(made_of "$reader")" "$2"/*.[ch] || echo "$reader: no fuzz target calls $(made_of "$reader")"
done <readers >without
cat without
echo "$(wc -l <readers) readers"
[ ! -s without ]
