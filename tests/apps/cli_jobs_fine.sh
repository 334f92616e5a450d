# labels: cli slow
# All sample jobs are cut to the end at 300 and at 1,500 stations.
. "$SOURCE_DIR/tests/apps/common.sh"
for job in "$jobs"/*.json; do
    for stations in 300 1500; do
        run 0 simulate "$job" -o cut --stations $stations --chord-tolerance 2 --quiet --json
        python3 -c 'import json, sys; s = json.load(open("out")); sys.exit(not (
            s["stations"] == int(sys.argv[1]) and s["residual"]["max"] < 1e-9))' $stations ||
            fail "$called: $(cat out)"
        rm -rf cut
    done
done
finish
