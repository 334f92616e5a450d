/* What a blade's diagnosis says in words: the verdict for an operator, and what these recordings cannot tell. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "base/alloc.h"
#include "explain/blade_diagnosis.h"

enum { LIMITS = 12 };

static void add_blade_limit(wcut_diagnosis *d, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add_blade_limit(wcut_diagnosis *d, const char *format, ...) {
    if (d->limits == LIMITS) return;
    va_list list;
    va_start(list, format);
    vsnprintf(d->limit[d->limits++], WCUT_DIAGNOSIS_TEXT, format, list);
    va_end(list);
}

/* RMSE [N] of left-out cuts; of all where none was left out */
static double left_out_rmse(const wcut_diagnosis *d, wcut_evidence_model m) {
    const wcut_evidence_score *out = &d->held_out_score[m][WCUT_EVIDENCE_CHANNEL_FORCE];
    return out->count > 0 ? out->rmse : d->score[m][WCUT_EVIDENCE_CHANNEL_FORCE].rmse;
}

/* ---- the sentence ---- */

static int put_subject(const wcut_diagnosis *d, char *to, size_t size) {
    /* the effect's first value with its interval */
    const wcut_found_effect *f = &d->effect[0];
    const wcut_estimate *e = &f->parameter[0];
    static const char *const axis[] = {"across the block (x)", "along the feed (y)", "over the height (z)"};

    /* a sentence for each kind that is tried */
    switch (f->effect.kind) {
        case WCUT_EFFECT_SLICE_SOFTENING:
            return snprintf(
                to, size,
                "Sliding along the edge was left out: the force falls with the ratio of sliding to advance, to half "
                "at a ratio of %.2f (95 %%: %.2f to %.2f).",
                e->value, e->low, e->high);
        case WCUT_EFFECT_RATE_DEPENDENCE:
            return snprintf(to, size,
                            "The force follows the speed of advance itself, with the exponent %.2f (95 %%: %.2f to "
                            "%.2f).",
                            e->value, e->low, e->high);
        case WCUT_EFFECT_FOAM_DENSITY_GRADIENT:
            return snprintf(to, size, "The foam gets denser by %.0f %% %s (95 %%: %.0f to %.0f).", 100 * e->value,
                            axis[f->effect.choice % 3], 100 * e->low, 100 * e->high);
        default:
            return snprintf(to, size, "The edge changes as it cuts, by %+.0f %% (95 %%: %+.0f to %+.0f).",
                            100 * e->value, 100 * e->low, 100 * e->high);
    }
}

/* the cut with the largest part of the mismatch, and its longest stretch */
static void put_place(const wcut_diagnosis *d, char *to, size_t size) {
    double share[WCUT_RIG_CUTS] = {0};
    int worst = -1;
    for (int k = 0; k < d->mismatches; k++) {
        const int cut = d->mismatch[k].cut;
        if (cut >= WCUT_RIG_CUTS) continue;
        share[cut] += d->mismatch[k].share;
        if (worst < 0 || share[cut] > share[worst]) worst = cut;
    }
    to[0] = 0;
    for (int k = 0; k < d->mismatches && !to[0]; k++) {
        const wcut_mismatch *m = &d->mismatch[k];
        if (m->cut == worst)
            snprintf(to, size,
                     " The largest mismatch is in cut %d, %.0f %% of all, most of it at %.0f to %.0f s (%+.1f N).",
                     worst + 1, 100 * share[worst], m->time[0], m->time[1], m->mean);
    }
}

static void tell_verdict(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    const double before = left_out_rmse(d, WCUT_EVIDENCE_MODEL_BEFORE),
                 set = left_out_rmse(d, WCUT_EVIDENCE_MODEL_RECALIBRATED);
    const double after = left_out_rmse(d, WCUT_EVIDENCE_MODEL_AFTER),
                 box = left_out_rmse(d, WCUT_EVIDENCE_MODEL_BLACK_BOX);

    /* figures of left-out cuts, where they are */
    char proof[200] = "", place[160];
    put_place(d, place, sizeof place);
    if (g->options->proof)
        snprintf(proof, sizeof proof, "%.2f N as the jobs are, %.2f N recalibrated, %.2f N by a fit without physics",
                 before, set, box);

    /* named, nothing beyond noise, or a mismatch without a name */
    if (d->kind == WCUT_VERDICT_PHYSICS) {
        const wcut_blade_candidate *x = &g->search.candidate[g->search.chosen];
        const int at = put_subject(d, d->sentence, sizeof d->sentence);
        snprintf(
            d->sentence + at, sizeof d->sentence - (size_t)at,
            " Cuts left out of the fit are predicted to %.2f N (RMSE)%s%s; %d of %d get better.%s What remains is %.0f "
            "times the sensor's noise.",
            after, proof[0] ? "; " : "", proof, x->better, x->used, place, d->adequacy);
    } else if (d->kind == WCUT_VERDICT_NONE) {
        snprintf(d->sentence, sizeof d->sentence,
                 "Nothing is wrong: what remains after recalibration, %.2f N, is no more than the sensor's noise.",
                 set);
    } else {
        const wcut_hypothesis *best = NULL;
        for (int k = 0; k < d->hypotheses && !best; k++)
            if (d->hypothesis[k].count > 0) best = &d->hypothesis[k];
        snprintf(
            d->sentence, sizeof d->sentence,
            "The forces differ from the recalibrated model by %.0f times the sensor's noise, %.2f N (RMSE%s), and no "
            "effect is named. The likeliest, %s, is set aside: %s.%s",
            d->adequacy, set, g->options->proof ? " of cuts left out of the fit" : "",
            best ? wcut_effect_view(best->effect[0].kind)->name : "none", best ? best->why : "nothing was tried",
            place);
    }
}

/* ---- limits ---- */

static void tell_limits(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    int used = 0;
    for (int k = 0; k < g->cuts; k++) {
        used += g->data.cut[k].bins > 0;
        if (g->left_out[k].text[0])
            add_blade_limit(d, "Cut %d is left out: %s.", k + 1, g->left_out[k].text);
        else if (g->data.cut[k].bins == 0)
            add_blade_limit(d, "Cut %d is left out: it has no %s.", k + 1, g->cut[k].job ? "recording" : "job");
    }

    /* what the files do not have */
    add_blade_limit(
        d,
        "The engaged length is not in the data. It is that of the job's block, less what earlier passes have cut, at a "
        "place that is fitted along the feed and up; the force builds up over a way that is fitted. These are "
        "nuisances, "
        "shared by all cuts: an error of the engaged length within a cut is a part of what remains.");
    add_blade_limit(
        d,
        "The sensor's zero is what it reads in the first second of each recording, and is taken away. A gain of one "
        "axis "
        "and a of the force law are one and the same in these forces. Friction along the edge and a turned sensor both "
        "move force from one axis to another (force_along_over_across): the force along the edge is shown, and not "
        "used.");

    /* what these cuts cannot tell */
    if (used < 3)
        add_blade_limit(
            d,
            "With %d cut%s no effect is named: it has to hold on cuts that are left out of the fit, of three or more.",
            used, used == 1 ? "" : "s");
    if (!g->search.contrast)
        add_blade_limit(
            d,
            "All cuts slide by the same strategy. Where sliding follows the force, more force goes with more sliding "
            "within a cut, whatever sliding does: its effect cannot be told. A cut with another ratio of sliding to "
            "advance would tell it.");
    if (d->kind == WCUT_VERDICT_PHYSICS && d->form_open)
        add_blade_limit(
            d, "The exponent of the effect is kept at its default: these cuts do not tell the form from the size.");
}

bool wcut_blade_tell(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    d->limit = wcut_alloc(LIMITS, sizeof *d->limit);
    if (!d->limit) return false;
    tell_verdict(g);
    tell_limits(g);
    return true;
}
