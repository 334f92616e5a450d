/* A design's edges drawn in another program: two curves of a file in the place of the job's own. */
#include <stdlib.h>
#include <wirecut/edit.h>
#include <wirecut/job.h>
#include <wirecut/job_file.h>
#include <wirecut/read.h>

#include "base/fail.h"

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
    wcut_vec3 end[2][2];
    char shown[WCUT_QUOTE_SIZE];
    if (!job || !path || job->mode != WCUT_MODE_DESIGN)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "edges: expected a job in design mode and a file");

    /* two open curves */
    wcut_status status = wcut_curve_set_read(path, NULL, &set, error);
    if (status != WCUT_OK) return status;
    wcut_quote(shown, path, WCUT_LABEL_MAX, 1);
    if (set->count != 2 || !find_ends(set->curve[0], end[0]) || !find_ends(set->curve[1], end[1]))
        status = wcut_fail(error, WCUT_BAD_FORMAT, "%s: found %d curves, %d left out, expected two edges", shown,
                           set->count, set->left_out);

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
