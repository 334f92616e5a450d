# Results under kills, failing calls, a full disk, two runs at once: every verb, every call. See campaign.py.
# labels: cli slow
exec python3 "$SOURCE_DIR/tests/fault/campaign.py" --long
