/* What a diagnosis is given: checked before anything looks into it. */
#include "explain/diagnosis_check.h"

#include "base/fail.h"
#include "explain/redundancy.h"
#include "explain/scatter.h"

bool wcut_diagnosis_is_of_blade(int cuts, const wcut_diagnosis_cut *cut) {
    for (int k = 0; k < cuts; k++)
        if (cut[k].job) return cut[k].job->rig.kind == WCUT_RIG_KIND_BLADE;
    return false;
}

/* what a rig's recording must have before anything looks into it */
static wcut_status check_recorded_rig(int k, const wcut_diagnosis_cut *cut, wcut_error *error) {
    if (!cut->job || !cut->recording || cut->job->rig.kind == WCUT_RIG_KIND_BLADE) return WCUT_OK;

    /* a bow's recordings have no model of their own */
    if (cut->job->rig.kind == WCUT_RIG_KIND_BOW)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "cut %d: found a bow, expected two arms or a blade: recordings of bows are "
                         "not diagnosed",
                         k + 1);

    /* two arms: the clock, stations, speeds, tensions and angles */
    for (int c = WCUT_CHANNEL_TIME; c <= WCUT_CHANNEL_BETA_B; c++)
        if (!cut->recording->channel[c].value)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "cut %d: found a recording without %s, expected one of two arms",
                             k + 1, wcut_channel_name((wcut_channel)c));
    return WCUT_OK;
}

wcut_status wcut_diagnosis_check(int cuts, const wcut_diagnosis_cut *cut, int test_cuts,
                                 const wcut_test_cut *calibration, const wcut_diagnosis_options *o,
                                 wcut_diagnosis **out, wcut_error *error) {
    if (cuts < 1 || !cut || !out || test_cuts < 0 || (test_cuts > 0 && !calibration))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "cuts and a place for the diagnosis are expected");
    if (o->threads < 1) return wcut_fail(error, WCUT_BAD_ARGUMENT, "found %d threads, expected 1 or more", o->threads);
    for (int k = 0; k < cuts; k++) {
        if (cut[k].job && cut[k].job->mode != WCUT_MODE_PATH)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "cut %d: found a design, expected a job with the mounts' path",
                             k + 1);
        if (cut[k].recording && (cut[k].recording->samples < 1 || !cut[k].recording->further))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "cut %d: expected a recording with samples and their lines",
                             k + 1);
        const wcut_status status = check_recorded_rig(k, &cut[k], error);
        if (status != WCUT_OK) return status;
    }
    const wcut_status status = wcut_scatter_check(o->rig, error);
    return status == WCUT_OK ? wcut_redundancy_check(o->still, error) : status;
}
