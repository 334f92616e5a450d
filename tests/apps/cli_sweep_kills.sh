# wirecut sweep under kills: workers and the parent end by SIGKILL, the same command goes on, and the table is the same.
. "$SOURCE_DIR/tests/apps/common.sh"
python3 "$SOURCE_DIR/tests/apps/sweep_kills.py" "$WIRECUT" "$jobs/freeform-1.json" 8 24 || fail "see above"
finish
