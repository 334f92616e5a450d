/* A correction put into a job. */
#include <wirecut/correction.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"

static wcut_status check_correction(const wcut_correction *c, const wcut_job *job, wcut_error *error) {
    if (!c || !job) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a correction and a job are expected");
    if (!is_positive(c->a) || !is_positive(c->b))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "correction: found a = %g, b = %g, expected positive ones", c->a,
                         c->b);
    if (c->effects < 0 || c->effects > WCUT_CORRECTION_EFFECTS)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "correction: found %d effects, expected 0 to %d", c->effects,
                         WCUT_CORRECTION_EFFECTS);

    /* the wire must keep a positive length; only a job with mounts has one, and a blade has none */
    const bool path = job->mode == WCUT_MODE_PATH, wire = path && job->rig.kind != WCUT_RIG_KIND_BLADE;
    if (!isfinite(c->length_change) || (wire && !is_positive(job->wire_length + c->length_change)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "correction: found a change of the wire by %g mm, the job has %g mm",
                         c->length_change, job->wire_length);

    /* NaN is a kerf that is not known */
    if ((isfinite(c->kerf) && c->kerf < 0) || !(c->kerf_per_q >= 0 && isfinite(c->kerf_per_q)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "correction: found a kerf of %g mm and %g mm m2/J, expected 0 or more", c->kerf,
                         c->kerf_per_q);

    /* a design has no mounts of its own, so that effects of mounts cannot act */
    for (int e = 0; e < c->effects && !path; e++) {
        const wcut_effect_info *info = wcut_effect_view(c->effect[e].kind);
        if (info && info->needs_mounts)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "correction: %s needs mounts, a design has none: apply it to the path that simulate makes "
                             "of the design (job-path.json)",
                             info->name);
    }

    return wcut_effects_check(c->effects, c->effect, error);
}

wcut_status wcut_correction_apply(const wcut_correction *c, wcut_job *job, wcut_error *error) {
    const wcut_status status = check_correction(c, job, error);
    if (status != WCUT_OK) return status;

    /* copy before anything of the job is changed */
    wcut_effect *effect = c->effects > 0 ? wcut_copy(c->effect, (size_t)c->effects, sizeof *effect) : NULL;
    if (c->effects > 0 && !effect) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d effects", c->effects);

    /* the law, the wire, the kerf */
    job->force_law.a = c->a, job->force_law.b = c->b;
    if (job->mode == WCUT_MODE_PATH) job->wire_length += c->length_change;
    if (isfinite(c->kerf)) job->kerf_width = c->kerf, job->kerf_per_q = c->kerf_per_q;

    /* what the job named before was what the diagnosis was asked about; an excitation belongs to one cut */
    wcut_free(job->effect);
    job->effect = effect, job->effect_count = c->effects;
    wcut_free(job->dither);
    wcut_free(job->heat_step);
    job->dither = NULL, job->heat_step = NULL;
    job->dither_count = job->heat_step_count = 0;

    return WCUT_OK;
}
