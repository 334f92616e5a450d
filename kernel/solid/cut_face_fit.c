/* The fit of the cut face: x is linear in s by construction, y and z are interpolated, knots follow the lines. */
#include "solid/cut_face_fit.h"

#include <limits.h>
#include <stdbool.h>
#include <string.h>
#include <wirecut/curvature.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/interpolate.h"

enum { LINES_FIRST = 9, CONTROL_MAX = 1000000, ROUNDS_MAX = 14, DEGREE = 3 };

/* Between two lines the error is seen at the middle, where that of a cubic is largest but for a few percent. */
static const double SEEN_SHARE = 0.9;

/* An area element this small beside its sides has no direction: the surface is folded flat. */
static const double FOLDED = 1e-7;

/* Prolonged by less than this share of the block is not prolonged. */
static const double ROUNDING = 1e-11;

/* a direction's lines over [0, 1] */
typedef struct lines {
    int count;
    double *at;
    bool *coarse; /* count - 1: the interval is to be halved */
} lines;

/* the sheet on a grid of lines */
typedef struct sampled {
    int columns, rows;
    wcut_vec3 *at; /* rows x columns */
    double *u, *v; /* rows x columns: parameters of the sheet */
} sampled;

static void cut_face_fit_lines_clear(lines *l) {
    wcut_free(l->at);
    wcut_free(l->coarse);
    *l = (lines){.count = 0};
}

static wcut_status cut_face_fit_lines_new(int count, lines *l) {
    *l = (lines){.count = count, .at = wcut_alloc((size_t)count, sizeof *l->at)};
    l->coarse = wcut_alloc((size_t)count, sizeof *l->coarse);
    if (l->at && l->coarse) return WCUT_OK;
    cut_face_fit_lines_clear(l);
    return WCUT_NO_MEMORY;
}

/* halve the coarse intervals, and those that would be left more than twice as wide as a neighbour */
static wcut_status cut_face_fit_lines_refine(lines *l) {
    const int count = l->count;

    /* an interval more than twice as wide as its neighbour is marked too */
    for (bool more = true; more;) {
        more = false;
        for (int k = 0; k + 1 < count; k++) {
            if (l->coarse[k]) continue;
            const double wide = l->at[k + 1] - l->at[k];
            for (int o = k - 1; o <= k + 1; o += 2) {
                if (o < 0 || o + 1 >= count || !l->coarse[o]) continue;
                if (wide > 2.1 * (l->at[o + 1] - l->at[o]) / 2) l->coarse[k] = more = true;
            }
        }
    }

    /* the new lines: a middle in every marked interval */
    int made = 0, halved = 0;
    for (int k = 0; k + 1 < count; k++) halved += l->coarse[k];
    lines fine;
    const wcut_status status = cut_face_fit_lines_new(count + halved, &fine);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < count; k++) {
        fine.at[made++] = l->at[k];
        if (k + 1 < count && l->coarse[k]) fine.at[made++] = (l->at[k] + l->at[k + 1]) / 2;
    }
    cut_face_fit_lines_clear(l);
    *l = fine;

    return WCUT_OK;
}

static void sampled_clear(sampled *g) {
    wcut_free(g->at);
    wcut_free(g->u);
    wcut_free(g->v);
    *g = (sampled){.columns = 0};
}

static wcut_status sampled_new(int columns, int rows, sampled *g) {
    const size_t count = (size_t)columns * (size_t)rows;
    *g = (sampled){.columns = columns, .rows = rows, .at = wcut_alloc(count, sizeof *g->at)};
    g->u = wcut_alloc(count, sizeof *g->u);
    g->v = wcut_alloc(count, sizeof *g->v);
    if (g->at && g->u && g->v) return WCUT_OK;
    sampled_clear(g);
    return WCUT_NO_MEMORY;
}

static double x_of(const wcut_trim *trim, double s) { return (1 - s) * trim->sides.x[0] + s * trim->sides.x[1]; }

/* the sheet where lines cross, column by column; the coordinate that a side fixes is exactly the side's */
static wcut_status cut_face_fit_sample(const wcut_trim *trim, int columns, const double *s, int rows, const double *t,
                                       sampled *g, wcut_error *error) {
    wcut_status status = sampled_new(columns, rows, g);
    for (int i = 0; status == WCUT_OK && i < columns; i++) {
        /* a column of s: its rib gives v at both sides */
        const double x = x_of(trim, s[i]);
        wcut_rib rib;
        status = wcut_trim_rib(trim, x, &rib, error);

        /* each t: the point on the rib, with u continued from the columns before */
        for (int j = 0; status == WCUT_OK && j < rows; j++) {
            const ptrdiff_t k = (ptrdiff_t)j * columns + i;
            wcut_sheet_point p;
            g->v[k] = (1 - t[j]) * rib.v[0] + t[j] * rib.v[1];
            g->u[k] = i > 0 ? g->u[k - 1] : (1 - t[j]) * rib.u[0] + t[j] * rib.u[1];
            if (i > 1) g->u[k] += (g->u[k - 1] - g->u[k - 2]) * (s[i] - s[i - 1]) / (s[i - 1] - s[i - 2]);
            status = wcut_trim_point(trim, x, g->v[k], &g->u[k], &p, error);
            if (status != WCUT_OK) break;

            /* a fold has no face */
            if (!(p.facing > FOLDED))
                status = wcut_fail(error, WCUT_DEGENERATE, "the cut%s folds over itself at (%.6g, %.6g, %.6g) mm",
                                   trim->sheet->width ? "'s kerf" : "", p.at.x, p.at.y, p.at.z);

            /* exact coordinates on the sides */
            g->at[k] = vec3(x, p.at.y, p.at.z);
            if (t[j] == 0) g->at[k].y = trim->sides.y[0];
            if (t[j] == 1) g->at[k].y = trim->sides.y[1];
        }
    }
    if (status != WCUT_OK) sampled_clear(g);

    return status;
}

/* the bicubic surface through a sampled grid */
static wcut_status cut_face_fit_interpolate(const wcut_trim *trim, const lines *s, const lines *t, const sampled *g,
                                            wcut_surface **patch) {
    const size_t count = (size_t)g->columns * (size_t)g->rows;

    /* knots as averages of the lines; control points by interpolation in both directions */
    double *knots_s = wcut_alloc((size_t)g->columns + DEGREE + 1, sizeof *knots_s);
    double *knots_t = wcut_alloc((size_t)g->rows + DEGREE + 1, sizeof *knots_t);
    wcut_vec3 *control = wcut_copy(g->at, count, sizeof *control);
    wcut_status status = knots_s && knots_t && control ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        wcut_knots_average(DEGREE, g->columns, s->at, knots_s);
        wcut_knots_average(DEGREE, g->rows, t->at, knots_t);
        status = wcut_interpolate_rows(DEGREE, g->columns, knots_s, s->at, g->rows, control);
    }
    if (status == WCUT_OK) status = wcut_interpolate_columns(DEGREE, g->rows, knots_t, t->at, g->columns, control);

    for (int j = 0; status == WCUT_OK && j < g->rows; j++)
        for (int i = 0; i < g->columns; i++) { /* what is known is set exactly: x is linear in s (Greville 1967) */
            wcut_vec3 *c = &control[(ptrdiff_t)j * g->columns + i];
            c->x = x_of(trim, (knots_s[i + 1] + knots_s[i + 2] + knots_s[i + 3]) / 3);
            if (i == 0) c->x = trim->sides.x[0];
            if (i == g->columns - 1) c->x = trim->sides.x[1];
            if (j == 0) c->y = trim->sides.y[0];
            if (j == g->rows - 1) c->y = trim->sides.y[1];
        }

    if (status == WCUT_OK)
        status = wcut_surface_create(DEGREE, DEGREE, g->columns, g->rows, knots_s, knots_t, control, NULL, patch);

    wcut_free(control);
    wcut_free(knots_t);
    wcut_free(knots_s);
    return status;
}

/* the middles of the intervals between lines */
static wcut_status middles(const lines *l, lines *middle) {
    const wcut_status status = cut_face_fit_lines_new(l->count - 1, middle);
    for (int k = 0; status == WCUT_OK && k + 1 < l->count; k++) middle->at[k] = (l->at[k] + l->at[k + 1]) / 2;
    return status;
}

/* Compare patch and sheet on the grid of s and t; *most grows; where too far apart, the intervals that a sample is the
   middle of are marked coarse (either may be NULL). */
static wcut_status cut_face_fit_compare(const wcut_trim *trim, const wcut_surface *patch, const lines *s,
                                        const lines *t, double held, bool *coarse_s, bool *coarse_t, double *max,
                                        wcut_error *error) {
    sampled g;

    /* the sheet at the same parameters */
    wcut_status status = cut_face_fit_sample(trim, s->count, s->at, t->count, t->at, &g, error);
    if (status != WCUT_OK) return status;
    wcut_vec3 *point = wcut_alloc((size_t)s->count * (size_t)t->count, sizeof *point);
    status = point ? wcut_surface_eval_grid(patch, s->count, s->at, t->count, t->at, point) : WCUT_NO_MEMORY;

    /* the distance of each sample */
    for (int j = 0; status == WCUT_OK && j < t->count; j++)
        for (int i = 0; i < s->count; i++) {
            const ptrdiff_t k = (ptrdiff_t)j * s->count + i;
            const double off = vec3_distance(point[k], g.at[k]);
            *max = fmax(*max, off);
            if (off <= held) continue;
            if (coarse_s) coarse_s[i] = true;
            if (coarse_t) coarse_t[j] = true;
        }
    wcut_free(point);
    sampled_clear(&g);

    return status;
}

/* the error of a patch, where its lines lie too far apart; samples in the middles of edges, then of cells */
static wcut_status cut_face_fit_judge(const wcut_trim *trim, const wcut_surface *patch, lines *s, lines *t,
                                      double tolerance, double *max, wcut_error *error) {
    const double held = SEEN_SHARE * tolerance;
    lines between_s = {.count = 0}, between_t = {.count = 0};
    *max = 0;
    wcut_status status = middles(s, &between_s);
    if (status == WCUT_OK) status = middles(t, &between_t);
    if (status == WCUT_OK) status = cut_face_fit_compare(trim, patch, &between_s, t, held, s->coarse, NULL, max, error);
    if (status == WCUT_OK) status = cut_face_fit_compare(trim, patch, s, &between_t, held, NULL, t->coarse, max, error);
    if (status == WCUT_OK && *max <= held)
        status = cut_face_fit_compare(trim, patch, &between_s, &between_t, held, s->coarse, t->coarse, max, error);
    cut_face_fit_lines_clear(&between_t);
    cut_face_fit_lines_clear(&between_s);
    return status;
}

/* how far the wire's surface was prolonged inside the block, how strongly it is curved, how wide the kerf is */
static wcut_status measure_extent(const wcut_trim *trim, const sampled *g, const double height[2], wcut_face_fit *fit) {
    const wcut_sheet *sheet = trim->sheet;

    /* parts that are shorter than rounding count as none */
    const double rounding = ROUNDING * fmax(trim->sides.x[1], trim->sides.y[1]);
    fit->entry = fit->exit = fit->wire = 0;
    fit->radius = fit->width_min = INFINITY;
    fit->width_max = 0;

    /* each sample of the grid */
    for (ptrdiff_t k = 0; k < (ptrdiff_t)g->columns * g->rows; k++) {
        const double u = g->u[k], v = g->v[k];
        double wire, feed, larger;
        wcut_sheet_prolonged(sheet, u, v, &wire, &feed);
        if (wire < rounding) wire = 0; /* a wire drawn onto the block's side ends there */
        if (feed < rounding) feed = 0;

        /* prolongations count inside the block only */
        if (g->at[k].z > height[0] && g->at[k].z < height[1]) {
            fit->wire = fmax(fit->wire, wire);
            if (v < sheet->first[1]) fit->entry = fmax(fit->entry, feed);
            if (v > sheet->last[1]) fit->exit = fmax(fit->exit, feed);
        }

        /* the smallest radius of curvature, where the surface was not prolonged */
        if (wire == 0 && feed == 0 && wcut_surface_curvature(sheet->surface, u, v, &larger, NULL) == WCUT_OK &&
            fabs(larger) * fit->radius > 1) {
            fit->radius = 1 / fabs(larger);
            fit->radius_place = g->at[k];
        }

        /* the width of the kerf there */
        wcut_vec3 width = {0, 0, 0};
        if (sheet->width) {
            const wcut_status status = wcut_surface_eval(sheet->width, u, v, 0, &width);
            if (status != WCUT_OK) return status;
        }
        fit->width_min = fmin(fit->width_min, width.z);
        fit->width_max = fmax(fit->width_max, width.z);
    }

    return WCUT_OK;
}

/* has the cut been continued inside the block by more than is allowed? */
static wcut_status check_prolonged(const wcut_trim *trim, const wcut_face_fit *k, double prolong, wcut_error *error) {
    const wcut_sides *s = &trim->sides;
    const double allowed = prolong + 1e-6 * fmax(s->x[1] - s->x[0], s->y[1] - s->y[0]);
    const char *where = k->entry > allowed ? "begins" : k->exit > allowed ? "ends" : "is";
    const double max = fmax(k->entry, fmax(k->exit, k->wire));
    if (max <= allowed) return WCUT_OK;
    if (where[0] == 'i')
        return wcut_fail(
            error, WCUT_DEGENERATE,
            "the cut does not go through: the wire is %.4g mm too short for the block's sides x = %.6g and "
            "%.6g mm, and may be prolonged by %.4g mm",
            k->wire, s->x[0], s->x[1], prolong);
    return wcut_fail(error, WCUT_DEGENERATE,
                     "the cut does not go through: it %s inside the block, up to %.4g mm before the side y = %.6g mm, "
                     "and may be continued straight by %.4g mm",
                     where, where[0] == 'b' ? k->entry : k->exit, where[0] == 'b' ? s->y[0] : s->y[1], prolong);
}

/* sample, interpolate, judge and refine until the tolerance is held; the last samples are handed out */
static wcut_status cut_face_fit_refine(const wcut_trim *trim, double tolerance, lines *s, lines *t, sampled *g,
                                       wcut_face_fit *fit, wcut_error *error) {
    for (int round = 0; round < ROUNDS_MAX; round++) {
        sampled_clear(g);
        wcut_surface_destroy(fit->patch);
        fit->patch = NULL;
        wcut_status status = cut_face_fit_sample(trim, s->count, s->at, t->count, t->at, g, error);
        if (status == WCUT_OK) status = cut_face_fit_interpolate(trim, s, t, g, &fit->patch);
        if (status == WCUT_OK) status = cut_face_fit_judge(trim, fit->patch, s, t, tolerance, &fit->fit_error, error);
        if (status != WCUT_OK || fit->fit_error <= SEEN_SHARE * tolerance) return status;
        status = cut_face_fit_lines_refine(s);
        if (status == WCUT_OK) status = cut_face_fit_lines_refine(t);
        if (status != WCUT_OK) return status;
        if (s->count > CONTROL_MAX / t->count) break;
    }
    return wcut_fail(error, WCUT_NOT_CONVERGED,
                     "no bicubic cut face within %.3g mm: %.3g mm with %d x %d control points", tolerance,
                     fit->fit_error, s->count, t->count);
}

wcut_status wcut_face_fit_solve(const wcut_trim *trim, const double height[2], double prolong, double tolerance,
                                wcut_face_fit *fit, wcut_error *error) {
    /* begin with few lines in both directions */
    lines s = {.count = 0}, t = {.count = 0};
    sampled g = {.columns = 0};
    wcut_face_fit k = {.patch = NULL};
    wcut_status status = cut_face_fit_lines_new(LINES_FIRST, &s);
    if (status == WCUT_OK) status = cut_face_fit_lines_new(LINES_FIRST, &t);
    for (int i = 0; status == WCUT_OK && i < LINES_FIRST; i++) s.at[i] = t.at[i] = i / (LINES_FIRST - 1.0);

    /* refine until the patch is within the tolerance, then measure what was prolonged */
    if (status == WCUT_OK) status = cut_face_fit_refine(trim, tolerance, &s, &t, &g, &k, error);
    if (status == WCUT_OK) status = measure_extent(trim, &g, height, &k);
    if (status == WCUT_OK) status = check_prolonged(trim, &k, prolong, error);

    if (status == WCUT_OK) {
        *fit = k;
    } else {
        wcut_surface_destroy(k.patch);
    }
    sampled_clear(&g);
    cut_face_fit_lines_clear(&t);
    cut_face_fit_lines_clear(&s);

    return status;
}
