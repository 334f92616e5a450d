/* Which effect explains a blade's forces. Cuts are the units of evidence: samples of one err alike, and sliding that follows
   the force is no experiment within a cut (Forssell, Ljung 1999); between cuts of other strategies it is one. */
#include "explain/blade_search.h"

#include <math.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "explain/library.h"

#define CUTS_MIN 3     /* fewer tell nothing of a cut that is not among them */
#define P_MAX 0.05     /* of the gain over cuts */
#define SHARE_MIN 0.15 /* [1] of the left-out error: less is of no consequence */
#define RIVAL 1.3      /* a name must gain so many times what the next one does */
#define SLIDES 0.1     /* [1, mm/s per N] less is no sliding */
#define LOADED 0.3     /* [1] of a cut's largest force */
#define CONTRAST 1.5   /* [1] of the ratios of sliding between cuts */

/* what is tried: an effect with its choice, its coordinate, and where the fit begins */
typedef struct trial {
    wcut_effect_kind kind;
    int choice;
    wcut_coordinate coordinate;
    double start;
} trial;

#define LINEAR WCUT_COORDINATE_SCALE_LINEAR
static const trial trials[WCUT_BLADE_CANDIDATES] = {
    {WCUT_EFFECT_SLICE_SOFTENING,
     0,
     {WCUT_SLICE_SOFTENING_RATIO, WCUT_COORDINATE_SCALE_RECIPROCAL, 0, 2, 0.1, 0, 20},
     1},
    {WCUT_EFFECT_RATE_DEPENDENCE, 0, {WCUT_RATE_DEPENDENCE_EXPONENT, LINEAR, 0, 1, 0.03, -4, 4}, 0.1},
    {WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0, {WCUT_FOAM_DENSITY_GRADIENT_CHANGE, LINEAR, 0, 1, 0.05, -1.8, 1.8}, 0.1},
    {WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 1, {WCUT_FOAM_DENSITY_GRADIENT_CHANGE, LINEAR, 0, 1, 0.05, -1.8, 1.8}, 0.1},
    {WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 2, {WCUT_FOAM_DENSITY_GRADIENT_CHANGE, LINEAR, 0, 1, 0.05, -1.8, 1.8}, 0.1},
    {WCUT_EFFECT_WIRE_FOULING, 0, {WCUT_WIRE_FOULING_CHANGE, LINEAR, 0, 1, 0.03, -0.9, 5}, 0.1},
};

/* ---- evidence ---- */

static double pooled_rmse(const wcut_blade_case *c, double *const *force) {
    double sum = 0, n = 0;
    for (int k = 0; k < c->cuts; k++)
        for (int b = 0; b < c->cut[k].bins; b++, n++) {
            const double d = c->cut[k].force[b] - force[k][b];
            sum += d * d;
        }
    return n > 0 ? sqrt(sum / n) : 0;
}

static void judge_candidate(const wcut_blade_case *c, const wcut_blade_fit *none, wcut_blade_candidate *x) {
    double sum = 0, square = 0;
    for (int k = 0; k < c->cuts; k++) {
        if (!(none->rmse_out[k] > 0) || !(x->fit.rmse_out[k] > 0)) continue;
        const double gain = log(none->rmse_out[k] / x->fit.rmse_out[k]);
        sum += gain, square += gain * gain;
        x->used++, x->better += gain > 0;
    }

    /* Student's t over the cuts */
    const int n = x->used;
    x->gain = n > 0 ? sum / n : 0;
    x->p = 1;
    const double variance = n > 1 ? fmax(square - sum * sum / n, 0) / (n - 1) / n : 0;
    if (n > 1 && variance > 0) x->p = wcut_student_tail(x->gain / sqrt(variance), n - 1);
    const double before = pooled_rmse(c, none->held_out);
    x->share = before > 0 ? 1 - pooled_rmse(c, x->fit.held_out) / before : 0;
}

/* median of sliding over advance where the blade feels a force; the first value is its own where it never does */
static double ratio_under_load(const wcut_blade_cut *cut, double *room) {
    int n = 0;
    for (int b = 0; b < cut->bins; b++)
        if (cut->force[b] > LOADED * cut->max && cut->advance[b] > 0) room[n++] = cut->slide[b] / cut->advance[b];
    if (n == 0) return cut->ratio;
    wcut_sort(n, room);
    return sorted_median(n, room);
}

/* Whether cuts slide by strategies that differ: by the gain with which sliding follows the force, by what the plan has in
   air, or, where sliding does not follow the force, by what it is under load. */
static wcut_status find_contrast(const wcut_blade_case *c, bool *contrast) {
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {0};
    int longest = 1;
    for (int k = 0; k < c->cuts; k++) longest = c->cut[k].bins > longest ? c->cut[k].bins : longest;
    double *room = wcut_alloc((size_t)longest, sizeof *room);
    if (!room) return WCUT_NO_MEMORY;

    /* the least and the largest of each over the cuts */
    for (int k = 0; k < c->cuts; k++) {
        const wcut_blade_cut *cut = &c->cut[k];
        if (cut->bins == 0) continue;
        const double gain = fabs(cut->gain) > 2 * cut->gain_error ? fmax(cut->gain, 0) : 0;
        const double value[3] = {gain, cut->ratio, ratio_under_load(cut, room)};
        for (int i = 0; i < 3; i++) low[i] = fmin(low[i], value[i]), high[i] = fmax(high[i], value[i]);
    }
    const bool follows = high[0] > SLIDES;
    *contrast = false;
    for (int i = 0; i < 3; i++)
        *contrast = *contrast || (high[i] > CONTRAST * low[i] && high[i] > SLIDES && (i < 2 || !follows));

    wcut_free(room);
    return WCUT_OK;
}

/* ---- decision ---- */

/* whether the interval of an effect's size leaves out none; 1.96 standard errors of the jackknife */
static bool excludes_neutral(const wcut_blade_candidate *x) {
    const double size = x->fit.model.x[WCUT_BLADE_BASE], error = x->fit.error[WCUT_BLADE_BASE];
    return fabs(size) > 1.96 * error;
}

static const char *fails(const wcut_blade_search *s, const wcut_blade_candidate *x) {
    const bool slides = x->fit.model.effect.kind == WCUT_EFFECT_SLICE_SOFTENING;
    if (x->used < CUTS_MIN) return "two cuts tell nothing of a third";
    if (x->gain <= 0 || x->share <= 0) return "predicts cuts that were left out no better";
    if (x->share < SHARE_MIN) return "too small to matter";
    if (x->better < x->used - x->used / 5) return "some cuts that were left out get worse";
    if (x->p > P_MAX) return "no more than chance over the cuts";
    if (slides && !s->contrast) return "all cuts slide by the same strategy";
    if (!excludes_neutral(x)) return "its interval holds no effect";
    return "";
}

/* whether an effect predicts left-out cuts by more than chance, be it told from what it follows or not */
static bool rivals(const wcut_blade_candidate *x) {
    return x->used >= CUTS_MIN && x->gain > 0 && x->share >= SHARE_MIN && x->p <= P_MAX;
}

/* the best of those that pass; a rival that gains nearly as much takes the name away */
static void choose_candidate(wcut_blade_search *s) {
    s->chosen = -1;
    for (int k = 0; k < s->count; k++) {
        wcut_blade_candidate *x = &s->candidate[k];
        x->why = fails(s, x);
        if (x->why[0]) continue;
        if (s->chosen < 0 || x->gain > s->candidate[s->chosen].gain) s->chosen = k;
    }

    /* rivals may take the name away */
    if (s->chosen < 0) return;
    wcut_blade_candidate *best = &s->candidate[s->chosen];
    for (int k = 0; k < s->count; k++) {
        wcut_blade_candidate *x = &s->candidate[k];
        if (k == s->chosen || !rivals(x)) continue;
        if (best->gain < RIVAL * x->gain) best->why = "another effect explains the cuts as well";
        if (!x->why[0]) x->why = best->why[0] ? best->why : "explains less";
    }

    /* what is named, and how sure it is */
    if (best->why[0])
        s->chosen = -1;
    else
        s->confidence = clamp(1 - s->count * best->p, 0.5, 0.99); /* Bonferroni over what was tried */
}

/* misfit of the chosen model over the sensor's noise, in the mean over cuts */
static void find_adequacy(const wcut_blade_case *c, wcut_blade_search *s) {
    const wcut_blade_fit *f = s->chosen >= 0 ? &s->candidate[s->chosen].fit : &s->none;
    double sum = 0;
    int n = 0;
    for (int k = 0; k < c->cuts; k++)
        if (c->cut[k].bins > 0) sum += f->rmse[k] / c->cut[k].noise, n++;
    s->adequacy = n > 0 ? sum / n : 0;
}

wcut_status wcut_blade_search_run(const wcut_blade_case *c, const bool without[WCUT_EFFECT_COUNT], double a,
                                  wcut_stop *stop, wcut_blade_search *s) {
    *s = (wcut_blade_search){.chosen = -1};
    const wcut_blade_model begin = wcut_blade_model_begin(a);

    /* recalibrated: the law and what the files do not say of the block */
    wcut_status status = find_contrast(c, &s->contrast);
    if (status == WCUT_OK) status = wcut_blade_fit_run(c, &begin, &s->none);
    if (status == WCUT_OK) status = wcut_blade_fit_leave_out(c, &s->none);

    /* every effect beside it, from the recalibrated values */
    for (int k = 0; status == WCUT_OK && k < WCUT_BLADE_CANDIDATES; k++) {
        const trial *t = &trials[k];
        if (without[t->kind]) continue;
        if (wcut_stop_step(stop, "effects were fitted", 2 + k)) return WCUT_INTERRUPTED;
        wcut_blade_candidate *x = &s->candidate[s->count];
        wcut_blade_model start = s->none.model;
        start.named = true, start.effect = wcut_effect_choose(t->kind, t->choice), start.coordinate = t->coordinate;
        start.x[WCUT_BLADE_BASE] = t->start;
        s->count++;
        status = wcut_blade_fit_run(c, &start, &x->fit);
        if (status == WCUT_OK) status = wcut_blade_fit_leave_out(c, &x->fit);
        if (status != WCUT_OK) return status;
        x->fit.model.effect.value[t->coordinate.at] =
            wcut_scale_out(t->coordinate.scale, x->fit.model.x[WCUT_BLADE_BASE]);
        judge_candidate(c, &s->none, x);
    }
    if (status != WCUT_OK) return status;
    choose_candidate(s);
    find_adequacy(c, s);

    return WCUT_OK;
}

void wcut_blade_search_destroy(const wcut_blade_case *c, wcut_blade_search *s) {
    wcut_blade_fit_destroy(c, &s->none);
    for (int k = 0; k < s->count; k++) wcut_blade_fit_destroy(c, &s->candidate[k].fit);
}
