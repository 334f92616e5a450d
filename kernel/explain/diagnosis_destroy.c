/* A diagnosis forgotten, with everything that it owns. */
#include <wirecut/diagnosis.h>

#include "base/alloc.h"

void wcut_diagnosis_destroy(wcut_diagnosis *d) {
    if (!d) return;

    /* arrays of each residual over time */
    for (int k = 0; k < d->traces; k++) {
        wcut_free(d->trace[k].time);
        wcut_free(d->trace[k].station);
        wcut_free(d->trace[k].measured);
        wcut_free(d->trace[k].before);
        wcut_free(d->trace[k].recalibrated);
        wcut_free(d->trace[k].after);
    }

    /* owned tables, then the two jobs */
    wcut_free(d->trace);
    wcut_free(d->hypothesis);
    wcut_free(d->mismatch);
    wcut_free(d->view.surface);
    wcut_free(d->view.point);
    wcut_free(d->view.distance);
    wcut_free(d->dependence);
    wcut_free(d->held_out);
    wcut_free(d->rig);
    wcut_free(d->contradiction);
    wcut_free(d->limit);
    wcut_job_destroy(d->improved);
    wcut_job_destroy(d->next_experiment);
    wcut_free(d);
}
