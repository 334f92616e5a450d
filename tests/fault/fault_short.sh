# Results under kills, failing calls, a full disk, two runs at once: the quick verbs, every k-th call. See campaign.py.
exec python3 "$SOURCE_DIR/tests/fault/campaign.py"
