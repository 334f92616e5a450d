# Every public function has a docstring, and one that gives a status says in it which:  check_statuses.sh HEADER_FOLDER
# Prints a line for each that does not, and ends with 1 where there was any.
set -eu
awk '
FNR == 1 { comment = "" }
/^\/\*\*/ { inside = 1; comment = "" }
inside { comment = comment $0; if (/\*\//) inside = 0; next }
/^WCUT_API/ && comment == "" { print FILENAME ": " $0 ": no docstring"; broken = 1 }
/^WCUT_API wcut_status/ {
    functions++
    name = $3
    sub(/\(.*/, "", name)
    if (comment !~ /@return/) { print FILENAME ": " name ": no @return that names its statuses"; broken = 1 }
}
/;[ \t]*$/ { comment = "" }
END {
    if (!functions) { print "no function that gives a status"; exit 2 }
    print functions " functions"
    exit broken
}' "$1"/*.h
