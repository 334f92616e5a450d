# The report's committed bundle is what its sources give (skipped with a message without node or its packages).
set -eu
sh "$SOURCE_DIR/tests/report/check_bundle.sh" "$SOURCE_DIR"
