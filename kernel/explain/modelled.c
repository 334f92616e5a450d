/* An unknown verdict looked into: empirical terms first, then events that cannot repeat, then what is left of them. */
#include "explain/modelled.h"

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"

/* [1] of slow misfit that noise may leave: where the rest leaves more, it is searched for terms too */
#define ADEQUATE 2.2
/* of what terms leave, what the rest without its events leaves at most */
#define HALF 0.5

static wcut_status look_at_rest(wcut_evidence *e, const wcut_fitted *recalibrated, wcut_outside *o, wcut_error *error) {
    o->kept = wcut_events_mask(&o->events, e);
    if (!o->kept) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for events");
    wcut_status status = wcut_model_fit(e, &recalibrated->model, &o->rest, error);
    if (status == WCUT_OK) o->left = wcut_residual_stats_eval(e, o->rest.residual);
    if (status == WCUT_OK && o->left.slow > ADEQUATE) status = wcut_empirical_find(e, &o->rest, &o->empirical, error);
    if (status == WCUT_OK && o->empirical.fit.residual) o->left = o->empirical.left;
    return status;
}

wcut_status wcut_outside_find(wcut_evidence *e, const wcut_fitted *recalibrated, wcut_outside *out, wcut_error *error) {
    /* empirical terms of the force that all cuts share */
    wcut_outside o = {.left = wcut_residual_stats_eval(e, recalibrated->residual)};
    wcut_status status = wcut_empirical_find(e, recalibrated, &o.empirical, error);
    if (status == WCUT_OK && o.empirical.fit.residual) o.left = o.empirical.left;

    /* what repeats comes first: a term that acts at the slow end of every cut looks like a window in each */
    wcut_outside rare = {.left = o.left};
    if (status == WCUT_OK && o.left.slow > ADEQUATE) status = wcut_events_find(e, recalibrated, &rare.events, error);
    if (status == WCUT_OK && rare.events.count > 0) status = look_at_rest(e, recalibrated, &rare, error);

    /* events are taken where they leave far less than the terms do */
    if (status == WCUT_OK && rare.events.count > 0 && rare.left.slow < HALF * o.left.slow) {
        wcut_outside_destroy(&o);
        o = rare;
        rare = (wcut_outside){.left = o.left};
    } else if (rare.kept) {
        /* otherwise the bins that were left out come back */
        wcut_events_restore(rare.kept, e);
    }
    wcut_outside_destroy(&rare);
    if (status == WCUT_OK)
        *out = o;
    else
        wcut_outside_destroy(&o);

    return status;
}

void wcut_outside_destroy(wcut_outside *o) {
    wcut_empirical_destroy(&o->empirical);
    wcut_fitted_destroy(&o->rest);
    wcut_free(o->kept);
    *o = (wcut_outside){.events = {.count = 0}};
}

const wcut_fitted *wcut_outside_fit(const wcut_outside *o) {
    return o->empirical.fit.residual ? &o->empirical.fit : o->rest.residual ? &o->rest : NULL;
}
