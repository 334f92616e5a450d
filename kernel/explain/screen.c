/* The screen: every effect of the library as a column, every single one and every pair solved at once. */
#include "explain/screen.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "explain/inclusions.h"
#include "explain/variance.h"

/* groups of the saturated model, and places of inclusions among them */
enum { SATURATING = 36, PLACES = 6 };

static wcut_coordinate first_coordinate(const wcut_effect *effect, int part) {
    return wcut_effect_coordinate(effect, wcut_explanation_view(effect->kind)->count > part ? part : 0);
}

static double start_strength(const wcut_effect *effect, int part) {
    const wcut_coordinate c = first_coordinate(effect, part);
    return wcut_scale_in(c.scale, effect->value[c.at]);
}

static void set_strength(wcut_effect *effect, int part, double x) {
    const wcut_coordinate c = first_coordinate(effect, part);
    effect->value[c.at] = wcut_scale_out(c.scale, clamp(x, c.low, c.high));
}

static double neutral_of(const wcut_effect *effect, int part) {
    return first_coordinate(effect, part).at == 0 ? wcut_explanation_neutral(effect->kind) : 0;
}

/* ---- columns ---- */

typedef struct making {
    const wcut_evidence *e;
    const wcut_model *about;
    wcut_screen *s;
    wcut_model *model; /* 1 + base + variants' parts */
    double *rows;      /* as many x rows of the evidence */
} making;

static void add_screen_column(wcut_screen *s, const wcut_variant *v, int part, bool grouped) {
    if (!grouped) s->groups++;
    s->column[s->columns++] = (wcut_screen_column){v->effect, v->carried, part, s->groups - 1};
}

/* the models of base coordinates and of variants: each column's own model is model[1 + base + column] */
static bool list_models(making *m, int variants, const wcut_variant *variant) {
    wcut_screen *s = m->s;
    const wcut_model *at = m->about;

    /* the base model, and one with each base coordinate moved */
    for (int k = 0; k <= WCUT_BASE; k++) m->model[k] = *at;
    m->model[1].a *= exp(wcut_base_step[0]), m->model[2].b *= exp(wcut_base_step[1]),
        m->model[3].length_change += wcut_base_step[2];
    if (at->effects == WCUT_DIAGNOSIS_EFFECTS) return false;

    /* one model for each variant; an offset of a scan has one for each direction */
    for (int k = 0; k < variants; k++) {
        const int parts = variant[k].effect.kind == WCUT_EFFECT_SCAN_OFFSET ? 3 : 1;
        for (int p = 0; p < parts; p++) {
            wcut_model *model = &m->model[1 + WCUT_BASE + s->columns];
            *model = *at;
            wcut_effect effect = variant[k].effect;
            if (parts == 3) effect.value[WCUT_SCAN_OFFSET_SHIFT + p] = 1;

            /* the effect of the variant is added to those of the model */
            model->effect[model->effects++] = effect;
            model->carried = model->carried || variant[k].carried;
            add_screen_column(s, &variant[k], p, p > 0);
            s->column[s->columns - 1].effect = effect;
        }
    }

    return true;
}

/* an effect the model has already is no variant of itself: its own column is its first coordinate moved */
static int drop_known(const wcut_model *about, int variants, wcut_variant *variant) {
    int kept = 0;
    for (int k = 0; k < variants; k++) {
        bool known = false;
        for (int j = 0; j < about->effects; j++) {
            const wcut_effect *has = &about->effect[j], *v = &variant[k].effect;
            if (has->kind != v->kind) continue;
            known = known || !wcut_effect_view(v->kind)->repeats || has->choice == v->choice;
        }
        if (!known) variant[kept++] = variant[k];
    }
    return kept;
}

static wcut_status fill_screen_columns(making *m, wcut_error *error) {
    wcut_screen *s = m->s;
    const size_t rows = (size_t)m->e->rows;
    const int simulated = WCUT_BASE + s->columns;
    wcut_status status = wcut_models_rows(m->e, 1 + simulated, m->model, m->rows, error);
    for (int k = 0; status == WCUT_OK && k < simulated; k++) {
        const int place = k < WCUT_BASE ? k : k + s->nuisances;
        double *column = s->plain + (size_t)place * rows, step = k < WCUT_BASE ? wcut_base_step[k] : 0;
        if (k >= WCUT_BASE) {
            const wcut_screen_column *c = &s->column[k - WCUT_BASE];
            step = start_strength(&c->effect, c->part) - neutral_of(&c->effect, c->part);
        }
        for (size_t i = 0; i < rows; i++) column[i] = (m->rows[(size_t)(1 + k) * rows + i] - m->rows[i]) / step;
    }
    return status;
}

static void set_priors(making *m) {
    wcut_screen *s = m->s;
    for (int k = 0; k < WCUT_BASE; k++) s->precision[k] = 1 / (wcut_base_spread[k] * wcut_base_spread[k]);
    double spread[WCUT_FITTED_MAX];
    wcut_nuisance_columns(m->e, s->plain + (size_t)WCUT_BASE * (size_t)m->e->rows, spread);
    for (int k = 0; k < s->nuisances; k++) {
        s->precision[WCUT_BASE + k] = 1 / (spread[k] * spread[k]);
        s->centre[WCUT_BASE + k] = k == WCUT_DELAYS ? WCUT_KERF : 0;
    }
    for (int k = 0; k < s->columns; k++) {
        const double wide = first_coordinate(&s->column[k].effect, s->column[k].part).spread;
        s->precision[WCUT_BASE + s->nuisances + k] = 1 / (wide * wide);
    }
}

void wcut_screen_destroy(wcut_screen *s) {
    wcut_free(s->column);
    wcut_free(s->centre);
    wcut_free(s->precision);
    wcut_free(s->plain);
    wcut_free(s->white);
    wcut_free(s->residual);
    wcut_free(s->missing);
    wcut_normal_equations_destroy(&s->normal);
    *s = (wcut_screen){0};
}

static bool make_screen(const wcut_evidence *e, int variants, int inclusions, making *m, wcut_screen *s) {
    const size_t rows = (size_t)e->rows, max = (size_t)variants + 2 + (size_t)inclusions;
    const size_t n = WCUT_BASE + (size_t)s->nuisances + max;
    s->column = wcut_alloc(max, sizeof *s->column);
    s->centre = wcut_alloc(n, sizeof(double));
    s->precision = wcut_alloc(n, sizeof(double));
    s->plain = wcut_alloc(n * rows, sizeof(double));
    s->white = wcut_alloc((n + 1) * rows, sizeof(double));
    s->residual = wcut_alloc(rows, sizeof(double));
    s->missing = wcut_alloc(rows, sizeof(double));
    m->model = wcut_alloc(WCUT_BASE + 3 + (size_t)variants, sizeof *m->model);
    m->rows = wcut_alloc((WCUT_BASE + 3 + (size_t)variants) * rows, sizeof(double));
    return s->column && s->centre && s->precision && s->plain && s->white && s->residual && s->missing && m->model &&
           m->rows;
}

wcut_status wcut_screen_create(const wcut_evidence *e, const wcut_model *about, const double *residual,
                               const bool without[WCUT_EFFECT_COUNT], wcut_screen *out, wcut_error *error) {
    wcut_variant variant[WCUT_VARIANTS];
    wcut_screen s = {.base = WCUT_BASE, .nuisances = wcut_nuisance_count(e)};
    making m = {.e = e, .about = about, .s = &s};

    /* variants of the library without the kinds that the model has already */
    const int variants =
        drop_known(about, wcut_library_variants(without, e->cuts > 1, s.nuisances > WCUT_DELAYS, variant), variant);

    /* inclusions have columns of their own, one for each place */
    bool places = !without[WCUT_EFFECT_FOAM_INCLUSION] && about->effects < WCUT_DIAGNOSIS_EFFECTS;
    for (int k = 0; k < about->effects; k++) places = places && about->effect[k].kind != WCUT_EFFECT_FOAM_INCLUSION;
    wcut_inclusions inclusions = {0};
    wcut_status status = places ? wcut_inclusions_create(e, about, &inclusions, error) : WCUT_OK;
    const size_t rows = (size_t)e->rows;
    if (status == WCUT_OK && !make_screen(e, variants, inclusions.count, &m, &s))
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for the columns of %d effects", variants);

    /* residual and gaps, then the models of all columns */
    if (status == WCUT_OK) {
        wcut_evidence_residual(e, s.missing);
        memcpy(s.residual, residual, rows * sizeof(double));
        if (!list_models(&m, variants, variant)) status = WCUT_BAD_ARGUMENT;
    }

    /* drive them, and whiten */
    if (status == WCUT_OK) status = fill_screen_columns(&m, error);
    if (status == WCUT_OK) {
        /* what was simulated place by place comes last */
        for (int k = 0; k < inclusions.count; k++) {
            const wcut_variant v = {.effect = inclusions.effect[k]};
            double *column = s.plain + (size_t)(WCUT_BASE + s.nuisances + s.columns) * rows;
            memcpy(column, inclusions.column + (size_t)k * rows, rows * sizeof *column);
            add_screen_column(&s, &v, 0, false);
        }

        /* priors of the columns, and room for their normal equations */
        set_priors(&m);
        status =
            wcut_normal_equations_create(WCUT_BASE + s.nuisances + s.columns, e->scatter.count, e->cuts, &s.normal);
    }

    /* sums, then hand over */
    if (status == WCUT_OK) {
        wcut_screen_weigh(e, &s);
        *out = s;
    } else {
        wcut_screen_destroy(&s);
    }

    wcut_inclusions_destroy(&inclusions);
    wcut_free(m.model);
    wcut_free(m.rows);
    return status;
}

void wcut_screen_weigh(const wcut_evidence *e, wcut_screen *s) {
    const size_t rows = (size_t)e->rows;
    const int n = s->base + s->nuisances + s->columns;
    double *white = s->white + (size_t)n * rows; /* one more row is there: the residual's */
    for (int k = 0; k < n; k++)
        wcut_evidence_whiten(e, s->missing, s->plain + (size_t)k * rows, s->white + (size_t)k * rows);
    wcut_evidence_whiten(e, s->missing, s->residual, white);
    wcut_normal_equations_fill(e, s->white, white, &s->normal);
    wcut_screened none;
    s->cost = 0;
    if (wcut_screen_solve(s, 0, NULL, &none)) s->cost = -none.gain;
}

/* whether a fit has the effect of a column already, so that the column is no variant of its own */
static bool is_known(const wcut_model *about, const wcut_effect *effect) {
    for (int j = 0; j < about->effects; j++) {
        const wcut_effect *has = &about->effect[j];
        if (has->kind != effect->kind) continue;
        if (effect->kind == WCUT_EFFECT_FOAM_INCLUSION || !wcut_effect_view(effect->kind)->repeats) return true;
        if (has->choice == effect->choice) return true;
    }
    return false;
}

/* recalibration and nuisances, then the coordinates of a fit, as nuisances too, then the columns that are no variant of
   what it has; gives how many groups there are */
static int copy_columns(const wcut_screen *from, const wcut_fitted *fitted, size_t rows, wcut_screen *to) {
    const int shared = from->base + from->nuisances, kept = shared + fitted->count;
    memcpy(to->plain, from->plain, (size_t)shared * rows * sizeof *to->plain);
    memcpy(to->centre, from->centre, (size_t)shared * sizeof *to->centre);
    memcpy(to->precision, from->precision, (size_t)shared * sizeof *to->precision);
    memcpy(to->plain + (size_t)shared * rows, fitted->column, (size_t)fitted->count * rows * sizeof *to->plain);
    for (int k = 0; k < fitted->count; k++) {
        const double spread = fitted->coordinate[k].spread;
        to->precision[shared + k] = 1 / (spread * spread);
    }

    /* groups are numbered anew */
    int groups = 0, last = -1;
    for (int c = 0; c < from->columns; c++) {
        const wcut_screen_column column = from->column[c];
        const int at = kept + to->columns;
        if (is_known(&fitted->model, &column.effect)) continue;
        if (column.group != last) groups++;
        last = column.group;
        memcpy(to->plain + (size_t)at * rows, from->plain + (size_t)(shared + c) * rows, rows * sizeof *to->plain);
        to->centre[at] = from->centre[shared + c], to->precision[at] = from->precision[shared + c];
        to->column[to->columns] = column;
        to->column[to->columns++].group = groups - 1;
    }

    return groups;
}

wcut_status wcut_screen_about(const wcut_evidence *e, const wcut_screen *from, const wcut_fitted *fitted,
                              wcut_screen *out) {
    const size_t rows = (size_t)e->rows;
    const size_t room = (size_t)from->base + (size_t)from->nuisances + (size_t)fitted->count + (size_t)from->columns;
    wcut_screen s = {.base = from->base, .nuisances = from->nuisances + fitted->count};

    /* one more white row is the residual's */
    s.column = wcut_alloc((size_t)from->columns + 1, sizeof *s.column); /* may be none */
    s.centre = wcut_alloc(room, sizeof *s.centre);
    s.precision = wcut_alloc(room, sizeof *s.precision);
    s.plain = wcut_alloc(room * rows, sizeof *s.plain);
    s.white = wcut_alloc((room + 1) * rows, sizeof *s.white);
    s.residual = wcut_copy(fitted->open, rows, sizeof *s.residual);
    s.missing = wcut_copy(from->missing, rows, sizeof *s.missing);
    const bool there = s.column && s.centre && s.precision && s.plain && s.white && s.residual && s.missing;
    wcut_status status = there ? WCUT_OK : WCUT_NO_MEMORY;

    /* its columns, and their sums */
    if (there) {
        s.groups = copy_columns(from, fitted, rows, &s);
        status = wcut_normal_equations_create(s.base + s.nuisances + s.columns, e->scatter.count, e->cuts, &s.normal);
    }
    if (status != WCUT_OK) {
        wcut_screen_destroy(&s);
        return status;
    }
    wcut_screen_weigh(e, &s);
    *out = s;

    return WCUT_OK;
}

/* ---- the saturated model ---- */

/* groups of the saturated model: the best of every kind, and places of inclusions beside each other */
static int saturating_groups(const wcut_screened *single, int count, int max, int *group) {
    int chosen = 0, places = 0;
    for (int i = 0; i < count && chosen < max; i++) {
        bool seen = false;
        const bool place = single[i].effect[0].kind == WCUT_EFFECT_FOAM_INCLUSION;
        for (int k = 0; k < i; k++)
            seen = seen || (single[k].effect[0].kind == single[i].effect[0].kind &&
                            single[k].effect[0].choice == single[i].effect[0].choice);
        if (place ? places >= PLACES : seen) continue;
        places += place;
        group[chosen++] = single[i].group[0];
    }
    return chosen;
}

wcut_status wcut_screen_saturate(wcut_evidence *e, wcut_screen *s, double *score) {
    const size_t rows = (size_t)e->rows;
    int group[SATURATING], column[WCUT_FITTED_MAX], n = 0;
    double centre[WCUT_FITTED_MAX], precision[WCUT_FITTED_MAX], own_score;
    wcut_screened *single = wcut_alloc((size_t)s->groups, sizeof *single);
    double *plain = wcut_alloc(WCUT_FITTED_MAX * rows, sizeof *plain),
           *white = wcut_alloc(WCUT_FITTED_MAX * rows, sizeof *white);
    double *residual = wcut_alloc(rows, sizeof *residual);

    /* a copy of the evidence, whose noise may change */
    wcut_evidence own = *e;
    own.scatter.white = wcut_alloc((size_t)e->scatter.count * rows, sizeof(double));
    wcut_normal_equations normal = {0};
    wcut_status status = single && plain && white && residual && own.scatter.white ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        /* the best groups of every kind together, beside recalibration and nuisances */
        const int singles = wcut_screen_singles(s, single);
        const int groups = saturating_groups(single, singles, SATURATING, group);
        for (int k = 0; k < s->base + s->nuisances; k++) column[n++] = k;
        for (int g = 0; g < groups; g++)
            for (int c = 0; c < s->columns && n < WCUT_FITTED_MAX; c++)
                if (s->column[c].group == group[g]) column[n++] = s->base + s->nuisances + c;

        /* their columns and priors */
        for (int k = 0; k < n; k++) {
            memcpy(plain + (size_t)k * rows, s->plain + (size_t)column[k] * rows, rows * sizeof *plain);
            centre[k] = s->centre[column[k]], precision[k] = s->precision[column[k]];
        }
        status = wcut_normal_equations_create(n, e->scatter.count, e->cuts, &normal);
    }

    /* the variances under which this model is likeliest */
    if (status == WCUT_OK) {
        const wcut_linear linear = {n, plain, s->residual, s->missing, centre, precision};
        wcut_variances_begin(&own.noise);
        status = wcut_variance_fit(&linear, &own, white, residual, &normal, &own_score);
    }

    /* they become the evidence's; everything is weighed anew */
    if (status == WCUT_OK) {
        if (score) *score = own_score;
        e->noise = own.noise;
        wcut_evidence_whiten_scatter(e, s->missing);
        wcut_screen_weigh(e, s);
    }

    wcut_normal_equations_destroy(&normal);
    wcut_free(own.scatter.white);
    wcut_free(residual);
    wcut_free(white);
    wcut_free(plain);
    wcut_free(single);
    return status;
}

/* ---- solving ---- */

bool wcut_screen_solve(const wcut_screen *s, int groups, const int *group, wcut_screened *out) {
    int chosen[WCUT_FITTED_MAX], count = 0;
    double t[WCUT_FITTED_MAX], cost;

    /* recalibration and nuisances are always in, beside the columns of the groups */
    for (int k = 0; k < s->base + s->nuisances; k++) chosen[count++] = k;
    for (int c = 0; c < s->columns; c++)
        for (int g = 0; g < groups; g++)
            if (s->column[c].group == group[g] && count < WCUT_FITTED_MAX) chosen[count++] = s->base + s->nuisances + c;
    if (!wcut_normal_equations_solve(&s->normal, count, chosen, s->centre, s->precision, -1, t, NULL, &cost))
        return false;

    /* the fall of the cost, and the strengths found */
    wcut_screened found = {.groups = groups, .gain = s->cost - cost};
    for (int g = 0; g < groups; g++) found.group[g] = group[g];
    for (int k = s->base + s->nuisances; k < count; k++) {
        const wcut_screen_column *c = &s->column[chosen[k] - s->base - s->nuisances];
        const int g = groups == 2 && c->group == group[1];
        if (c->part == 0) found.effect[g] = c->effect;
        set_strength(&found.effect[g], c->part, neutral_of(&c->effect, c->part) + t[k]);
        found.carried = found.carried || c->carried;
    }

    /* sizes in gates: 1 is what is worth naming */
    for (int g = 0; g < groups; g++) found.size[g] = wcut_effect_size(&found.effect[g]);
    *out = found;

    return true;
}

static int by_gain(const void *a, const void *b) {
    const wcut_screened *x = a, *y = b;
    if (x->gain != y->gain) return x->gain < y->gain ? 1 : -1;
    return x->group[0] != y->group[0] ? x->group[0] - y->group[0] : x->group[1] - y->group[1];
}

int wcut_screen_singles(const wcut_screen *s, wcut_screened *out) {
    int count = 0;
    for (int g = 0; g < s->groups; g++) count += wcut_screen_solve(s, 1, &g, &out[count]);
    qsort(out, (size_t)count, sizeof *out, by_gain);
    return count;
}

static wcut_effect_kind group_kind(const wcut_screen *s, int group, int *choice) {
    for (int c = 0; c < s->columns; c++)
        if (s->column[c].group == group) {
            *choice = s->column[c].effect.choice;
            return s->column[c].effect.kind;
        }
    return WCUT_EFFECT_COUNT;
}

int wcut_screen_pairs(const wcut_screen *s, int max, wcut_screened *out) {
    int count = 0;

    /* every pair of groups, kept in order of gain */
    for (int i = 0; i < s->groups; i++)
        for (int j = i + 1; j < s->groups; j++) {
            int first, second;
            const int group[2] = {i, j};
            const wcut_effect_kind kind = group_kind(s, i, &first);
            wcut_screened found;
            if (kind == group_kind(s, j, &second)) continue; /* two of one kind are one explanation */
            if (!wcut_screen_solve(s, 2, group, &found) || found.size[0] == 0 || found.size[1] == 0) continue;

            /* append, or replace the last one if this one gains more */
            int at = count < max ? count++ : max - 1;
            if (at == max - 1 && count == max && out[at].groups == 2 && out[at].gain >= found.gain) continue;
            out[at] = found;

            /* move it up to its place */
            while (at > 0 && by_gain(&out[at - 1], &out[at]) > 0) {
                const wcut_screened swap = out[at];
                out[at] = out[at - 1], out[at - 1] = swap, at--;
            }
        }

    return count;
}
