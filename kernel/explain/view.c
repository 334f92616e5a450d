/* Where in space the worst misfit is: the wire's surface of that cut, and what its scan shows. */
#include "explain/view.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"

/* the scan's patches of a cut, with what of them lies above the recalibrated surface */
static bool view_patches(const wcut_patches *p, wcut_diagnosis_view *v) {
    if (p->count == 0) return true;
    v->point = wcut_copy(p->point, (size_t)p->count, sizeof *v->point);
    v->distance = wcut_copy(p->distance, (size_t)p->count, sizeof *v->distance);
    if (!v->point || !v->distance) return false;
    v->points = p->count;
    return true;
}

/* the cut of the worst misfit, or the first one, run along its exogenous trajectory under the model called "after" */
wcut_status wcut_view_fill(const wcut_evidence *e, const wcut_fitted *after, int mismatches,
                           const wcut_mismatch *mismatch, wcut_diagnosis_view *v, wcut_error *error) {
    /* the cut of the worst mismatch, or the first one that has bins */
    const wcut_mismatch *m = mismatches > 0 ? mismatch : NULL;
    int cut = m ? m->cut : 0;
    while (cut < e->cuts && e->cut[cut].bins == 0) cut++;
    if (cut >= e->cuts) return WCUT_OK;
    const wcut_evidence_cut *c = &e->cut[cut];

    /* run it with positions */
    wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
    const wcut_job job = wcut_model_job(e, &after->model, cut, effect);
    wcut_response d = {0};
    wcut_status status = wcut_response_run(&job, WCUT_NODES_COARSE, &c->exogenous, true, e->stop, &d, error);
    if (status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED) return status;
    if (status != WCUT_OK) return WCUT_OK; /* a picture less */

    /* the wire's surface: one row for each sample that the run reached */
    const size_t n = (size_t)d.nodes;
    v->surface = wcut_alloc((size_t)d.count * n, sizeof *v->surface);
    v->time = m && isfinite(m->time[0] + m->time[1]) ? (m->time[0] + m->time[1]) / 2 : c->middle[c->bins / 2];
    for (int i = 0; v->surface && i < d.count; i++) {
        if (!d.present[i]) continue;
        if (c->exogenous.time[i] <= v->time) v->worst = v->rows;
        memcpy(v->surface + (size_t)v->rows++ * n, d.position + (size_t)i * n, n * sizeof *v->surface);
    }

    /* the block, and the scan's patches */
    v->block = c->job->block_size, v->nodes = d.nodes, v->cut = v->rows > 1 ? cut : -1;
    status = v->surface && view_patches(&c->patch, v) ? WCUT_OK : WCUT_NO_MEMORY;

    wcut_response_destroy(&d);
    return status;
}
