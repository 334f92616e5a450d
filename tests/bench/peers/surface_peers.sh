# Surface jobs of this library beside its peers, in one run on this machine, as a table for README.md:
#   sh tests/bench/peers/surface_peers.sh FOLDER [all]      FOLDER holds the programs that were built
# `all` adds what takes Open CASCADE minutes: ThruSections at full size, triangles within 0.01 mm, its fit. CPU time on one
# core.
set -eu
LC_ALL=C
export LC_ALL OMP_NUM_THREADS=1
folder=$1
results=$(mktemp)
trap 'rm -f "$results"' EXIT
for peer in wirecut sisl occt; do
    program=$folder/surface_$peer
    if [ -x "$program" ]; then
        "$program" ${2:+"$2"} >>"$results"
    else
        echo "surface_$peer: not built, its library is not installed: left out" >&2
    fi
done
awk -F '\t' '
function shown(seconds) {
    return seconds < 1e-3 ? sprintf("%.3g us", 1e6 * seconds) : seconds < 1 ? sprintf("%.3g ms", 1e3 * seconds) : sprintf("%.3g s", seconds)
}
BEGIN {
    split("skin_small skin_large eval_random eval_grid closest_small closest_large tessellate_coarse tessellate_fine fit_small fit_large", order, " ")
    name["skin_small"] = "skin of 500 x 100 nodes"
    name["skin_large"] = "skin of 2000 x 200 nodes"
    name["eval_random"] = "1,000,000 points at random, 2000 x 200"
    name["eval_grid"] = "1,000,000 points on a grid"
    name["closest_small"] = "closest point, each, 500 x 100"
    name["closest_large"] = "closest point, each, 2000 x 200"
    name["tessellate_coarse"] = "triangles within 0.1 mm"
    name["tessellate_fine"] = "triangles within 0.01 mm"
    name["fit_small"] = "fit of 500 x 100 nodes within 0.01 mm"
    name["fit_large"] = "fit of 2000 x 200 nodes within 0.01 mm"
    print "| job | wirecut | SISL | OCCT | faster by |"
    print "|---|---|---|---|---|"
}
{
    peer = $2
    sub(/ .*/, "", peer)
    extra = $2 == "OCCT ThruSections"
    if (extra) { thru[$1] = $3 } else { took[$1, peer] = $3 }
    note[++notes] = $1 " " $2 ": " $4
}
END {
    for (i = 1; i in order; i++) {
        job = order[i]
        own = took[job, "wirecut"]
        if (own == "") continue
        sisl = ((job, "SISL") in took) ? shown(took[job, "SISL"]) : "-"
        occt = ((job, "OCCT") in took) ? shown(took[job, "OCCT"]) : "-"
        by = ""
        if ((job, "SISL") in took) by = sprintf("%.3g x SISL", took[job, "SISL"] / own)
        if ((job, "OCCT") in took) by = by (by == "" ? "" : ", ") sprintf("%.3g x OCCT", took[job, "OCCT"] / own)
        if (job in thru) {
            occt = occt "; ThruSections " shown(thru[job])
            by = by sprintf(", %.3g x ThruSections", thru[job] / own)
        }
        printf "| %s | %s | %s | %s | %s |\n", name[job], shown(own), sisl, occt, by
    }
    print ""
    for (i = 1; i <= notes; i++) print note[i]
}' "$results"
