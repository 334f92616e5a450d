# admesh finds the STL halves closed and oriented, with nothing to mend.
# labels: exchange slow
. "$SOURCE_DIR/tests/exchange/exchange.sh"
need admesh admesh
for half in lower upper; do
    LC_ALL=C admesh "$half.stl" >log 2>&1 || { cat log; exit 1; }
    cat log
    # it ends with 0 over an empty file, too
    grep -q "^Number of facets  *: *$(value $half triangles) " log
    for fault in 'Total disconnected facets' 'Degenerate facets' 'Edges fixed' 'Facets removed' 'Facets added' \
        'Facets reversed' 'Backwards edges' 'Normals fixed'; do
        grep -q "^$fault  *: *0" log || { echo "$half.stl: $fault"; exit 1; }
    done
    grep -q 'Max X =  400.000000' log
    grep -q 'Max Y =  600.000000' log
done
