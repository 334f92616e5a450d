# Lines JOB, PEER, SECONDS, NOTE into the table of README.md; the notes to standard error.
function shown(seconds) {
    if (seconds < 1e-3) return sprintf("%.3g us", 1e6 * seconds)
    return seconds < 1 ? sprintf("%.3g ms", 1e3 * seconds) : sprintf("%.3g s", seconds)
}
# what stands behind the last colon or blank of a note that tells what came out: the same from all
function outcome(note) {
    sub(/.*(sum of z|first 5:) /, "", note)
    return note + 0
}
BEGIN {
    jobs = split("skin_large eval_random eval_grid closest_large tessellate_coarse stl step halves", order, " ")
    name["skin_large"] = "skin of 2000 x 200 nodes"
    name["eval_random"] = "1e6 points at random"
    name["eval_grid"] = "1e6 points on a grid"
    name["closest_large"] = "closest point of that surface, a query"
    name["tessellate_coarse"] = "triangles within 0.1 mm, held"
    name["stl"] = "binary STL of 1e7 triangles, 500 MB"
    name["step"] = "STEP of that surface"
    name["halves"] = "halves with a cutter of 209,000 triangles"
    peers = split("SISL OCCT ThruSections memcpy CGAL manifold", peer, " ")
    name["OCCT"] = "Open CASCADE"
    name["manifold"] = "manifold (wasm)"
    print "| CPU time on one core | wirecut | peers | faster by |"
    print "|---|---|---|---|"
}
{
    took[$1, $2] = $3
    print $1 " " $2 ": " $3 " s, " $4 > "/dev/stderr"
    if ($4 !~ /sum of z|first 5:/) next
    if (!($1 in first)) first[$1] = outcome($4)
    else if (outcome($4) > first[$1] * (1 + 1e-8) || outcome($4) < first[$1] * (1 - 1e-8)) {
        print $1 " " $2 ": not the same input, " outcome($4) " beside " first[$1] > "/dev/stderr"
        failed = 1
    }
}
END {
    for (i = 1; i <= jobs; i++) {
        own = took[order[i], "wirecut"]
        if (own == "") continue
        list = by = ""
        for (k = 1; k <= peers; k++) {
            if (!((order[i], peer[k]) in took)) continue
            theirs = took[order[i], peer[k]]
            called = peer[k] in name ? name[peer[k]] : peer[k]
            list = list (list == "" ? "" : ", ") called " " shown(theirs)
            if (peer[k] == "memcpy") factor = sprintf("1/%.2g", own / theirs)
            else factor = theirs < 10 * own ? sprintf("%.2g", theirs / own) : sprintf("%d", theirs / own)
            by = by (by == "" ? "" : ", ") factor
        }
        printf "| %s | %s | %s | %s |\n", name[order[i]], shown(own), list == "" ? "-" : list, by == "" ? "-" : by
    }
    exit failed
}
