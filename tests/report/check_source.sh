#!/bin/sh
# The report page's source: lines of at most 120 columns, and what biome finds in it (unused names, format):
#   sh tests/report/check_source.sh [TREE]
# biome needs node and the locked packages (npm ci in apps/report); without them only the lines are checked, and it says
# so.
set -eu
tree=$(cd "${1:-$(dirname "$0")/../..}" && pwd)
cd "$tree/apps/report"
awk 'length > 120 { print FILENAME ":" FNR ": " length " columns, expected at most 120"; found = 1 }
     END { exit found }' src/*.js src/*.css build.mjs
if ! command -v node >/dev/null 2>&1 || [ ! -x node_modules/.bin/biome ]; then
    echo "not linted: run npm ci in apps/report first"
    exit 0
fi
node_modules/.bin/biome ci --error-on-warnings --assist-enabled=false --colors=off
