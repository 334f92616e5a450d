# Sourced by the tests of exchange: what is to be exchanged, written under a locale with decimal commas.
set -eu

# need COMMAND PACKAGE: end with 77, which ctest shows as skipped, where the other program is not here
need() {
    command -v "$1" >/dev/null || { echo "skipped: no $1 here (Debian package $2)"; exit 77; }
}

# need_module MODULE PACKAGE: the same for a module of Debian's own python
need_module() {
    /usr/bin/python3 -c "$1" 2>/dev/null || { echo "skipped: python has no ${1#import } here (Debian package $2)"; exit 77; }
}

"$WRITE_GIVEN" "$PWD" de_DE.UTF-8

# value HALF KEY: a figure of given.json
value() { /usr/bin/python3 -c 'import json, sys; print(json.load(open("given.json"))[sys.argv[1]][sys.argv[2]])' "$1" "$2"; }
