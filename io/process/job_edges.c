/* A design's edges drawn in another program: two curves of a file in the place of the job's own. */
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/edit.h>
#include <wirecut/job.h>
#include <wirecut/job_file.h>
#include <wirecut/read.h>

#include "base/fail.h"
#include "io/process/curve_json.h"

/* how many curves a file has where two are expected, the names of the first ones, and for a text how two are written */
static wcut_status refuse_count(const wcut_curve_set *set, const char *path, wcut_error *error) {
    char shown[WCUT_QUOTE_SIZE], names[100] = "", left_out[80] = "";
    size_t used = 0;
    for (int k = 0; k < set->count && used + 30 < sizeof names; k++) {
        if (!set->name[k][0]) continue;
        const int n = snprintf(names + used, sizeof names - used, "%s%.20s", used ? ", " : " (", set->name[k]);
        used += n > 0 ? (size_t)n : 0;
    }
    if (used > 0) snprintf(names + used, sizeof names - used, "%s", set->count > 3 ? ", ...)" : ")");
    if (set->left_out > 0) snprintf(left_out, sizeof left_out, ", %d left out: %.50s", set->left_out, set->why);
    const bool is_text = set->format == WCUT_CURVE_FORMAT_CSV || set->format == WCUT_CURVE_FORMAT_JSON;
    return wcut_fail(error, WCUT_BAD_FORMAT, "%s: found %d curve%s%s%s, expected two edges%s%s",
                     wcut_quote(shown, path, WCUT_LABEL_MAX, 1), set->count, set->count == 1 ? "" : "s", names,
                     left_out, is_text ? "; two edges are written as " : "",
                     !is_text                               ? ""
                     : set->format == WCUT_CURVE_FORMAT_CSV ? WCUT_CURVES_FORM_CSV
                                                            : WCUT_CURVES_FORM_JSON);
}

/* where a curve begins and ends; false: it is none that can be evaluated */
static bool find_ends(const wcut_curve *curve, wcut_vec3 end[2]) {
    double first, last;
    wcut_curve_domain(curve, &first, &last);
    return wcut_curve_eval(curve, first, 0, &end[0]) == WCUT_OK && wcut_curve_eval(curve, last, 0, &end[1]) == WCUT_OK;
}

/* one that runs against the feed is turned */
static wcut_status turn_job_edges(wcut_curve **curve, const wcut_vec3 end[2]) {
    wcut_curve *turned = NULL;
    if (end[0].y <= end[1].y) return WCUT_OK;
    const wcut_status status = wcut_curve_reverse(*curve, &turned);
    if (status != WCUT_OK) return status;
    wcut_curve_destroy(*curve);
    *curve = turned;
    return WCUT_OK;
}

wcut_status wcut_job_read_edges(wcut_job *job, const char *path, wcut_error *error) {
    wcut_curve_set *set = NULL;
    wcut_vec3 end[2][2] = {{{0, 0, 0}}};
    char shown[WCUT_QUOTE_SIZE];
    if (!job || !path || job->mode != WCUT_MODE_DESIGN)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "edges: expected a job in design mode and a file");

    /* two open curves */
    wcut_status status = wcut_curve_set_read(path, NULL, &set, error);
    if (status != WCUT_OK) return status;
    wcut_quote(shown, path, WCUT_LABEL_MAX, 1);
    if (set->count != 2)
        status = refuse_count(set, path, error);
    else if (!find_ends(set->curve[0], end[0]) || !find_ends(set->curve[1], end[1]))
        status = wcut_fail(error, WCUT_BAD_FORMAT, "%s: found a curve that cannot be evaluated at its ends", shown);

    /* both run the same way */
    for (int k = 0; status == WCUT_OK && k < 2; k++) {
        status = turn_job_edges(&set->curve[k], end[k]);
        if (status != WCUT_OK) wcut_fail(error, status, "%s: %s", shown, wcut_status_text(status));
    }

    /* the edge with the smaller x is the one of mount A */
    if (status == WCUT_OK) {
        const int a = end[0][0].x + end[0][1].x <= end[1][0].x + end[1][1].x ? 0 : 1;
        wcut_curve_destroy(job->edge_a);
        wcut_curve_destroy(job->edge_b);
        job->edge_a = set->curve[a];
        job->edge_b = set->curve[1 - a];
        set->curve[0] = set->curve[1] = NULL;
    }

    wcut_curve_set_destroy(set);
    return status;
}
