/* Physics outside the library, modelled: empirical terms of the force chosen step by step, each confirmed on other cuts. */
#include "explain/empirical.h"

#include <string.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "foam/empirical.h"

/* a step must be so unlikely by chance, over the whole dictionary */
#define LEVEL 1e-4
/* of its gain on the cuts it was fitted to, what it must gain on each left out in turn */
#define HOLDS 0.5
/* [standard errors] of its coefficient */
#define STANDS_OUT 4.0
/* of the slow misfit beyond noise: a step must take away so much, a third one so much */
#define TAKES 0.25
#define HALVES 0.5
/* rivals within so much of the gain, and so many units of noise, explain it as well */
#define RIVAL 12.0
#define RIVAL_SHARE 0.05
/* entries of a step that are fitted in full */
enum { TRIED = 3 };
/* and what of the best one's gain by the screen they have */
#define CONTENDS 0.4

typedef struct searching {
    const wcut_evidence *e;
    int entries, nuisances, n; /* n: base, nuisances, entries */
    wcut_entry *entry;
    double *scale;  /* entries: of each to a mean square of 1 over the bins */
    double *max;    /* entries: largest abs(phi) of a bin, unscaled */
    double *column; /* n x rows, whitened; those of entries are 0 in patches */
    wcut_normal_equations normal;
    double *centre, *precision; /* n */
    int cuts;                   /* with bins */
} searching;

/* an entry, or a sine with its cosine, and what it gains by the screen */
typedef struct pick {
    int entry, width;
    double gain, t[2];
} pick;

typedef struct trial {
    wcut_fitted fit;
    wcut_residual_stats left;
    pick pick;
    double gain, held_out, noise;
    int better, judged;
    bool broken;
} trial;

static void searching_destroy(searching *g) {
    wcut_free(g->entry);
    wcut_free(g->scale);
    wcut_free(g->max);
    wcut_free(g->column);
    wcut_free(g->centre);
    wcut_free(g->precision);
    wcut_normal_equations_destroy(&g->normal);
}

static bool searching_create(const wcut_evidence *e, searching *g) {
    *g = (searching){.e = e, .entry = wcut_alloc(WCUT_ENTRIES_MAX, sizeof(wcut_entry))};
    if (!g->entry) return false;
    for (int k = 0; k < e->cuts; k++) g->cuts += e->cut[k].bins > 0;
    g->entries = wcut_dictionary_list(e, g->entry);
    g->nuisances = wcut_nuisance_count(e);
    g->n = WCUT_BASE + g->nuisances + g->entries;
    g->scale = wcut_alloc((size_t)g->entries, sizeof(double));
    g->max = wcut_alloc((size_t)g->entries, sizeof(double));
    g->column = wcut_alloc((size_t)g->n * (size_t)e->rows, sizeof(double));
    g->centre = wcut_alloc((size_t)g->n, sizeof(double));
    g->precision = wcut_alloc((size_t)g->n, sizeof(double));
    return g->scale && g->max && g->column && g->centre && g->precision &&
           wcut_normal_equations_create(g->n, e->scatter.count, e->cuts, &g->normal) == WCUT_OK;
}

/* ---- columns ---- */

static double *column_of_entry(const searching *g, int k) { return g->column + (size_t)k * (size_t)g->e->rows; }

/* changes of the prediction with the base coordinates, not whitened */
static wcut_status base_columns(searching *g, const wcut_model *about, wcut_error *error) {
    wcut_model model[1 + WCUT_BASE] = {*about, *about, *about, *about};
    const size_t rows = (size_t)g->e->rows;
    double *all = wcut_alloc((1 + WCUT_BASE) * rows, sizeof *all);
    if (!all) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", g->e->rows);
    model[1].a *= exp(wcut_base_step[0]), model[2].b *= exp(wcut_base_step[1]);
    model[3].length_change += wcut_base_step[2];
    const wcut_status status = wcut_models_rows(g->e, 1 + WCUT_BASE, model, all, error);
    for (int k = 0; status == WCUT_OK && k < WCUT_BASE; k++)
        for (size_t i = 0; i < rows; i++)
            column_of_entry(g, k)[i] = (all[(size_t)(1 + k) * rows + i] - all[i]) / wcut_base_step[k];
    wcut_free(all);
    return status;
}

/* an entry's phi times the change with ln a, the force's relative change; value: WCUT_WEIGHTS x the most bins */
static wcut_status entry_column(searching *g, int k, const wcut_response *d, double *value) {
    static const wcut_weight weight[WCUT_SIGNALS] = {WCUT_WEIGHT_EVEN, WCUT_WEIGHT_EVEN, WCUT_WEIGHT_A,
                                                     WCUT_WEIGHT_A,    WCUT_WEIGHT_B,    WCUT_WEIGHT_B};

    /* the column of this entry, and the response to a change of ln a that it is made from */
    double *column = column_of_entry(g, WCUT_BASE + g->nuisances + k), square = 0;
    const double *by_force = column_of_entry(g, 0);
    int bins = 0;
    g->max[k] = 0;

    /* phi of each cut in its bins */
    for (int cut = 0; cut < g->e->cuts; cut++) {
        const wcut_evidence_cut *c = &g->e->cut[cut];
        if (c->bins == 0) continue;
        const wcut_status status = wcut_dictionary_eval(g->e, cut, &d[cut], &g->entry[k], value);
        if (status != WCUT_OK) return status;

        /* sums for the scale, and the largest value for the report */
        for (int i = 0; i < c->bins; i++) {
            square += value[i] * value[i], bins++;
            g->max[k] = fmax(g->max[k], fabs(value[i]));
        }

        /* the response to a force changed by phi is that to ln a times phi, angles weighted towards their mount */
        for (int i = 0; i < WCUT_SIGNALS * c->bins; i++)
            column[c->row + i] = by_force[c->row + i] * value[(int)weight[i / c->bins] * c->bins + i % c->bins];
    }

    /* scale the column to unit mean square; an entry that is zero everywhere is left out */
    g->scale[k] = square > 1e-12 * bins ? 1 / sqrt(square / bins) : 0;
    for (int i = 0; i < g->e->rows; i++) column[i] *= g->scale[k];

    return WCUT_OK;
}

static wcut_status drive_all(const wcut_evidence *e, const wcut_model *model, wcut_response *d, wcut_error *error) {
    wcut_error *failed = wcut_alloc((size_t)e->cuts, sizeof *failed);
    if (!failed) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d cuts", e->cuts);
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
    for (int k = 0; k < e->cuts; k++) {
        if (e->cut[k].bins == 0) continue;
        wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
        const wcut_job job = wcut_model_job(e, model, k, effect);
        failed[k].status =
            wcut_response_run(&job, WCUT_NODES_COARSE, &e->cut[k].exogenous, true, e->stop, &d[k], &failed[k]);
    }
    wcut_status status = WCUT_OK;
    for (int k = 0; status == WCUT_OK && k < e->cuts; k++)
        if (failed[k].status != WCUT_OK) status = wcut_fail(error, failed[k].status, "%s", failed[k].text);
    wcut_free(failed);
    return status;
}

static wcut_status fill_entries(searching *g, const wcut_model *about, wcut_error *error) {
    const wcut_evidence *e = g->e;
    const size_t rows = (size_t)e->rows;
    double spread[WCUT_FITTED_MAX] = {0};
    int bins = 0;

    /* room for the most bins of a cut */
    for (int k = 0; k < e->cuts; k++) bins = e->cut[k].bins > bins ? e->cut[k].bins : bins;
    wcut_response *d = wcut_alloc((size_t)e->cuts, sizeof *d);
    double *value = wcut_alloc((size_t)WCUT_WEIGHTS * (size_t)bins, sizeof *value),
           *raw = wcut_alloc(rows, sizeof *raw);

    /* columns of the base coordinates, then the wire driven once along each exogenous trajectory */
    wcut_status status = d && value && raw ? base_columns(g, about, error) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = drive_all(e, about, d, error);

    /* one column for every entry of the dictionary */
    for (int k = 0; status == WCUT_OK && k < g->entries; k++) {
        status = entry_column(g, k, d, value);
        if (wcut_stop_asked(e->stop)) status = wcut_fail(error, WCUT_INTERRUPTED, "interrupted");
    }

    /* nuisances and priors, then everything whitened alike */
    if (status == WCUT_OK) {
        wcut_nuisance_columns(e, column_of_entry(g, WCUT_BASE), spread);
        wcut_evidence_residual(e, raw);
        for (int k = 0; k < g->n; k++) {
            wcut_evidence_whiten(e, raw, column_of_entry(g, k), column_of_entry(g, k));
            const double width = k < WCUT_BASE                  ? wcut_base_spread[k]
                                 : k < WCUT_BASE + g->nuisances ? spread[k - WCUT_BASE]
                                                                : 1;
            g->precision[k] = 1 / (width * width);
        }
    }

    /* release the responses and the scratch */
    for (int k = 0; d && k < e->cuts; k++) wcut_response_destroy(&d[k]);

    wcut_free(d);
    wcut_free(value);
    wcut_free(raw);
    return status == WCUT_NO_MEMORY ? wcut_fail(error, status, "no memory for the dictionary") : status;
}

/* ---- a step ---- */

static bool same_family(const wcut_entry *a, const wcut_entry *b) {
    if (a->effect.choice != b->effect.choice || a->carried != b->carried) return false;
    if (a->effect.choice == WCUT_TERM_ORDER)
        return (a->effect.value[WCUT_EMPIRICAL_FORCE_FIRST] < 0) == (b->effect.value[WCUT_EMPIRICAL_FORCE_FIRST] < 0);
    if (a->effect.choice <= WCUT_TERM_POSITION_Z)
        return a->effect.value[WCUT_EMPIRICAL_FORCE_DEGREE] == b->effect.value[WCUT_EMPIRICAL_FORCE_DEGREE];
    if (a->effect.choice >= WCUT_TERM_DIRECTION_X && a->effect.choice <= WCUT_TERM_DIRECTION_Z)
        return a->effect.value[WCUT_EMPIRICAL_FORCE_ORDER] == b->effect.value[WCUT_EMPIRICAL_FORCE_ORDER];
    return true;
}

/* gain of an entry about the present residual, the base, nuisances and terms so far free beside it */
static bool screen_one(const searching *g, int fixed, int *chosen, double before, pick *p) {
    double t[WCUT_FITTED_MAX], cost;
    for (int k = 0; k < p->width; k++) chosen[fixed + k] = WCUT_BASE + g->nuisances + p->entry + k;
    if (!wcut_normal_equations_solve(&g->normal, fixed + p->width, chosen, g->centre, g->precision, -1, t, NULL, &cost))
        return false;
    p->gain = before - cost;
    for (int k = 0; k < p->width; k++) p->t[k] = t[fixed + k] * g->scale[p->entry + k];
    return true;
}

/* the entries that gain most, one of a family; gives how many there are of TRIED. fixed: columns beside */
static int screen(const searching *g, int fixed, int *chosen, pick *best) {
    double t[WCUT_FITTED_MAX], before;
    int n = 0;

    /* the cost of the columns that are in already */
    if (!wcut_normal_equations_solve(&g->normal, fixed, chosen, g->centre, g->precision, -1, t, NULL, &before))
        return 0;

    /* each entry, a sine and its cosine taken together */
    for (int k = 0; k < g->entries; k++) {
        pick p = {.entry = k, .width = g->entry[k].pair ? 2 : 1};
        if (k > 0 && g->entry[k - 1].pair) continue; /* the cosine of a pair */
        if (g->scale[k] == 0 || !screen_one(g, fixed, chosen, before, &p)) continue;

        /* keep the best of each family, so that the list is not all variants of one term */
        int at = 0;
        while (at < n && !same_family(&g->entry[best[at].entry], &g->entry[k])) at++;
        if (at < n && best[at].gain >= p.gain) continue;

        /* a full list: the new one takes the place of the last, if it is better by the criterion of Akaike (gain - 4
           a coordinate) */
        if (at == n && n == TRIED) {
            if (best[n - 1].gain - 4 * best[n - 1].width >= p.gain - 4 * p.width) continue;
            at = n - 1;
        } else if (at == n) {
            n++;
        }

        /* insert in order */
        for (; at > 0 && best[at - 1].gain - 4 * best[at - 1].width < p.gain - 4 * p.width; at--)
            best[at] = best[at - 1];
        best[at] = p;
    }

    return n;
}

static void compare_trial(const searching *g, const wcut_fitted *from, trial *t) {
    t->gain = from->misfit - t->fit.misfit;
    t->left = wcut_residual_stats_eval(g->e, t->fit.residual);
    t->noise = fmax(1, t->left.slow);
    for (int k = 0; k < g->e->cuts; k++) {
        if (g->e->cut[k].bins == 0) continue;
        /* a misfit is not negative: where it is, a wire that no solver brought through has spoilt the columns */
        if (t->fit.held_out[k] < 0 || t->fit.cut_cost[k] < 0) t->broken = true;
        const double fall = from->held_out[k] - t->fit.held_out[k];
        t->held_out += fall;
        /* a cut that the term hardly moves has no say */
        if (fabs(fall) < 2 * t->noise) continue;
        t->better += fall > 0, t->judged++;
    }
}

static wcut_status try_entry(const searching *g, const wcut_fitted *from, const pick *p, trial *t, wcut_error *error) {
    wcut_model model = from->model;
    const wcut_entry *entry = &g->entry[p->entry];
    wcut_effect *effect = &model.effect[model.effects++];
    *effect = entry->effect;
    effect->value[WCUT_EMPIRICAL_FORCE_COEFFICIENT] = clamp(p->t[0], -0.8, 0.8);
    if (p->width > 1) effect->value[WCUT_EMPIRICAL_FORCE_COSINE] = clamp(p->t[1], -0.8, 0.8);
    model.carried = model.carried || entry->carried;
    *t = (trial){.pick = *p};
    const wcut_status status = wcut_model_fit(g->e, &model, &t->fit, error);
    if (status == WCUT_OK) compare_trial(g, from, t);
    return status;
}

/* coefficient of the last term in standard errors */
static double significance(const trial *t) {
    double max = 0;
    for (int k = 0; k < t->fit.count; k++)
        if (t->fit.effect_of[k] == t->fit.model.effects - 1 && t->fit.coordinate[k].at <= WCUT_EMPIRICAL_FORCE_COSINE &&
            t->fit.coordinate[k].scale == WCUT_COORDINATE_SCALE_LINEAR)
            max = fmax(max, fabs(t->fit.x[WCUT_BASE + k]) / t->fit.error[WCUT_BASE + k]);
    return max / sqrt(t->noise);
}

/* whether the fit ended inside the range that a term may have at all */
static bool term_is_plausible(const trial *t) {
    const wcut_effect *last = &t->fit.model.effect[t->fit.model.effects - 1];
    const bool band = last->choice >= WCUT_TERM_BAND_X && last->choice <= WCUT_TERM_BAND_Z;
    if (t->broken || (band && last->value[WCUT_EMPIRICAL_FORCE_SHAPE] > last->value[WCUT_EMPIRICAL_FORCE_SHAPE + 1]))
        return false;
    for (int k = 0; k < t->fit.count; k++) {
        const wcut_coordinate *c = &t->fit.coordinate[k];
        const double x = t->fit.x[WCUT_BASE + k], wide = 1e-6 * (c->high - c->low);
        if (x < c->low + wide || x > c->high - wide) return false;
    }
    return true;
}

static bool is_confirmed(const searching *g, const trial *t, const wcut_residual_stats *before) {
    const double gain = t->gain / t->noise, excess = fmax(before->slow - 1, 0);
    const bool third = t->fit.model.effects == WCUT_EMPIRICAL_TERMS;
    if (!(wcut_chi_square_tail(gain, t->pick.width) * g->entries < LEVEL)) return false;
    if (!(t->held_out >= HOLDS * t->gain) || 3 * t->better < 2 * t->judged || t->judged == 0) return false;
    if (!(significance(t) > STANDS_OUT) || !term_is_plausible(t)) return false;
    return before->slow - t->left.slow > (third ? HALVES : TAKES) * excess;
}

static void keep_rivals(const searching *g, const trial *trial_of, int trials, int best, wcut_empirical *out) {
    const trial *b = &trial_of[best];
    for (int k = 0; k < trials && out->rivals < WCUT_EMPIRICAL_RIVALS; k++) {
        const trial *t = &trial_of[k];
        const double behind = (b->gain - t->gain) / b->noise;
        if (k == best || !t->fit.residual || !(t->held_out > 0) || !term_is_plausible(t)) continue;
        if (behind > RIVAL + RIVAL_SHARE * b->gain / b->noise) continue;
        const int last = t->fit.model.effects - 1;
        out->rival[out->rivals++] = (wcut_empirical_rival){.effect = t->fit.model.effect[last],
                                                           .carried = g->entry[t->pick.entry].carried,
                                                           .instead_of = last,
                                                           .behind = behind};
    }
}

/* one step about `from`: the best confirmed trial becomes the new fit. *taken: its entry, -1 where none is confirmed */
static wcut_status confirm_term(searching *g, const wcut_fitted *from, const wcut_residual_stats *before, int fixed,
                                int *chosen, wcut_empirical *out, pick *taken, wcut_error *error) {
    pick best[TRIED] = {{0}};
    trial t[TRIED];
    memset(t, 0, sizeof t);
    /* what the fit leaves with its nuisances in, whitened as the columns are */
    double *missing = wcut_alloc((size_t)g->e->rows, sizeof *missing);
    double *open = wcut_alloc((size_t)g->e->rows, sizeof *open);
    wcut_status status = missing && open ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory for a step");
    int n = 0;
    if (status == WCUT_OK) {
        /* the screen about this residual */
        wcut_evidence_residual(g->e, missing);
        wcut_evidence_whiten(g->e, missing, from->open, open);
        wcut_normal_equations_fill(g->e, g->column, open, &g->normal);
        n = screen(g, fixed, chosen, best);
    }
    wcut_free(open);
    wcut_free(missing);

    /* fit the best in full, as long as they contend with the first and are not due to chance */
    int at = -1;
    for (int k = 0; status == WCUT_OK && k < n; k++) {
        const double chance = wcut_chi_square_tail(best[k].gain / clamp(before->slow, 1, 3), best[k].width);
        if (!(best[k].gain > CONTENDS * best[0].gain) || !(chance * g->entries < LEVEL)) break;
        status = try_entry(g, from, &best[k], &t[k], error);

        /* a trial that does not converge is no candidate */
        if (status == WCUT_NOT_CONVERGED || status == WCUT_BAD_ARGUMENT) status = WCUT_OK;

        /* confirmed on held-out cuts, and better than those before */
        if (!t[k].fit.residual || !is_confirmed(g, &t[k], before)) continue;
        if (at < 0 || t[k].gain - 4 * t[k].fit.count > t[at].gain - 4 * t[at].fit.count) at = k;
    }
    taken->width = 0;

    /* the best one becomes the fit; its rivals are kept for the report */
    if (status == WCUT_OK && at >= 0) {
        *taken = t[at].pick;
        keep_rivals(g, t, n, at, out);
        out->gain += t[at].gain, out->held_out += t[at].held_out;
        out->left = t[at].left;
        wcut_fitted_destroy(&out->fit);
        out->fit = t[at].fit;
        t[at].fit = (wcut_fitted){0};
    }

    /* release the trials that were not taken */
    for (int k = 0; k < TRIED; k++) wcut_fitted_destroy(&t[k].fit);

    return status;
}

wcut_status wcut_empirical_find(const wcut_evidence *e, const wcut_fitted *recalibrated, wcut_empirical *out,
                                wcut_error *error) {
    searching g;

    /* the dictionary's columns about the recalibrated model */
    wcut_empirical found = {.left = wcut_residual_stats_eval(e, recalibrated->residual)};
    wcut_status status = searching_create(e, &g) ? fill_entries(&g, &recalibrated->model, error)
                                                 : wcut_fail(error, WCUT_NO_MEMORY, "no memory for the dictionary");

    /* recalibration and nuisances are in every solve */
    int chosen[WCUT_FITTED_MAX], fixed = WCUT_BASE + g.nuisances;
    for (int k = 0; k < fixed && status == WCUT_OK; k++) chosen[k] = k;
    const int max = g.cuts > 1 ? WCUT_EMPIRICAL_TERMS : 0; /* one cut confirms nothing */

    /* add one term after the other, each about the fit of those before */
    for (int term = 0; status == WCUT_OK && term < max; term++) {
        pick taken = {.width = 0};
        const wcut_residual_stats before = found.left;
        status = confirm_term(&g, found.fit.residual ? &found.fit : recalibrated, &before, fixed, chosen, &found,
                              &taken, error);

        /* nothing was confirmed: the search ends */
        if (taken.width == 0) break;

        /* the columns of the term stay in from now on */
        found.size[term] = g.max[taken.entry];
        for (int k = 0; k < taken.width; k++) chosen[fixed++] = WCUT_BASE + g.nuisances + taken.entry + k;
    }

    /* hand over, or release, what was found */
    searching_destroy(&g);
    if (status == WCUT_OK)
        *out = found;
    else
        wcut_empirical_destroy(&found);

    return status;
}

void wcut_empirical_destroy(wcut_empirical *empirical) {
    wcut_fitted_destroy(&empirical->fit);
    *empirical = (wcut_empirical){.rivals = 0};
}
