/* Derivatives of coarse runs for a search on finer ones: a defect correction (Stetter 1978), whose residuals are those of
   the finer runs. */
#include "base/threads.h"
#include "inverse/trial.h"

wcut_status wcut_trial_borrow(wcut_trial *s, wcut_trial *coarse, const wcut_design_curves *c) {
    /* a run of these curves: the last one that was tried may be of others */
    wcut_history *h = NULL;
    const wcut_status status = wcut_trial_run(coarse, c, true, &h);
    wcut_history_destroy(h);
    if (status != WCUT_OK) return status == WCUT_NO_MEMORY ? status : WCUT_OK;

    /* at every node of the finer face what the coarser one has at the same share of the feed and of the wire */
    const wcut_wire_face face = {coarse->stations, coarse->nodes, NULL};
    const size_t from = (size_t)coarse->stations * (size_t)coarse->nodes, to = (size_t)s->stations * (size_t)s->nodes;
    const int unknowns = wcut_design_unknowns(c);
#pragma omp parallel for schedule(static) num_threads(wcut_threads(s->threads))
    for (int j = 0; j < s->stations; j++) {
        const double station = (double)j * (coarse->stations - 1) / (s->stations - 1);
        for (int i = 0; i < s->nodes; i++) {
            const double node = (double)i * (coarse->nodes - 1) / (s->nodes - 1);
            const wcut_stencil at = wcut_wire_stencil(&face, station, node);
            wcut_vec3 *by = s->by + (size_t)j * (size_t)s->nodes + i;
            for (int u = 0; u < unknowns; u++)
                by[(size_t)u * to] = wcut_stencil_eval(&at, coarse->nodes, coarse->by + (size_t)u * from);
        }
    }
    s->borrowed = true;
    return WCUT_OK;
}
