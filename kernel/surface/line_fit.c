/* Many functions of one parameter by cubic splines over one knot vector, with few knots.

   Least squares miss a smooth function by what goes with the fourth power of the knots' distance. So knots are laid by a
   density, each piece of which is multiplied by the fourth root of what was missed there over what may be (in the spirit
   of de Boor 1978, XII, newknt): a few rounds level the errors. */
#include "surface/line_fit.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/band_fit.h"
#include "surface/grid.h"
#include "surface/interpolate.h"
#include "surface/spacing.h"

enum { PIECES_FIRST = 8, ROUNDS_MAX = 24, ROUNDS_GOOD = 8 };

static const double ENOUGH = 0.7; /* of the tolerance: a fit that misses by so much wastes few knots */
static const double AIM = 0.85;   /* of the tolerance: what the next round is to miss by */
static const double DENSE = 0.7;  /* control points per row from which on interpolation is the better way */

void wcut_line_fit_clear(wcut_line_fit *fit) {
    wcut_free(fit->knots);
    wcut_free(fit->control);
    *fit = (wcut_line_fit){.count = 0};
}

static wcut_status fit_new(int count, int columns, wcut_line_fit *fit) {
    wcut_line_fit f = {.count = count};
    f.knots = wcut_alloc((size_t)count + 4, sizeof *f.knots);
    f.control = wcut_alloc((size_t)count, (size_t)columns * sizeof *f.control);
    if (!f.knots || !f.control) {
        wcut_line_fit_clear(&f);
        return WCUT_NO_MEMORY;
    }
    *fit = f;
    return WCUT_OK;
}

/* what is fitted */
typedef struct data {
    int rows, columns;
    const double *parameter;
    const wcut_vec3 *point;
} data;

/* clamped cubic knots at the lines of a spacing, but for those with no parameter between them and the one before;
   returns how many control points */
static int lay_knots(const data *d, const wcut_spacing *lines, double *knots) {
    int made = 0, row = 0;
    for (int k = 0; k < 4; k++) knots[made++] = d->parameter[0];
    for (int i = 1; i < lines->pieces; i++) {
        int inside = 0;
        while (row < d->rows - 1 && d->parameter[row] < lines->at[i]) row++, inside++;
        if (inside > 0) knots[made++] = lines->at[i];
    }
    for (int k = 0; k < 4; k++) knots[made++] = d->parameter[d->rows - 1];
    return made - 4;
}

/* what the curves miss each row by */
static void miss(const data *d, const wcut_band_rows *a, const wcut_vec3 *control, double *missed, double *max) {
    *max = 0;
    for (int i = 0; i < d->rows; i++) {
        const double *share = a->value + (ptrdiff_t)i * a->width;
        const wcut_vec3 *p = d->point + (ptrdiff_t)i * d->columns, *c = control + (ptrdiff_t)a->first[i] * d->columns;
        double worst = 0;
        for (int k = 0; k < d->columns; k++) {
            wcut_vec3 off = p[k];
            for (int r = 0; r < 4; r++) off = vec3_add_scaled(off, -share[r], c[k + (ptrdiff_t)r * d->columns]);
            worst = fmax(worst, vec3_dot(off, off));
        }
        missed[i] = sqrt(worst);
        *max = fmax(*max, missed[i]);
    }
}

/* least squares over given knots; WCUT_SINGULAR where some of them have too few rows */
static wcut_status line_fit_solve(const data *d, wcut_line_fit *fit, double *missed) {
    wcut_axis axis;
    wcut_status status = wcut_axis_fill(3, fit->count, fit->knots, d->rows, d->parameter, 0, &axis);
    if (status != WCUT_OK) return status;
    const wcut_band_rows a = {.rows = d->rows, .width = 4, .first = axis.first, .value = axis.value};
    status = wcut_band_fit(&a, fit->count, 3 * d->columns, &d->point->x, &fit->control->x);
    if (status == WCUT_OK) miss(d, &a, fit->control, missed, &fit->error);
    wcut_axis_clear(&axis);
    return status;
}

/* every row is met exactly */
static wcut_status line_fit_interpolate(const data *d, wcut_line_fit *fit) {
    wcut_line_fit f;
    wcut_status status = fit_new(d->rows, d->columns, &f);
    if (status != WCUT_OK) return status;
    memcpy(f.control, d->point, (size_t)d->rows * (size_t)d->columns * sizeof *f.control);
    wcut_knots_average(3, d->rows, d->parameter, f.knots);
    status = wcut_interpolate_columns(3, d->rows, f.knots, d->parameter, d->columns, f.control);
    if (status == WCUT_OK) {
        *fit = f;
    } else {
        wcut_line_fit_clear(&f);
    }
    return status;
}

/* the density of each piece by what was missed in it and beside it */
static void adapt(const data *d, const double *missed, double tolerance, bool held, wcut_spacing *lines) {
    double before = 0;
    int row = 0;
    for (int i = 0; i < lines->pieces; i++) {
        double here = 0;
        for (; row < d->rows && (d->parameter[row] <= lines->at[i + 1] || i == lines->pieces - 1); row++)
            here = fmax(here, missed[row]);
        const double max = fmax(here, before / 2);
        before = here;
        const double factor = sqrt(sqrt(max / (AIM * tolerance)));
        /* where the tolerance is not held yet nothing is made coarser in haste */
        lines->density[i] *= clamp(factor, held ? 0.6 : 0.8, 2.5);
    }
}

static wcut_status line_fit_begin(const data *d, wcut_spacing *s) {
    wcut_spacing n = {.pieces = 1};
    n.at = wcut_alloc(2, sizeof *n.at);
    n.density = wcut_alloc(1, sizeof *n.density);
    n.crease = wcut_alloc(2, sizeof *n.crease);
    if (!n.at || !n.density || !n.crease) {
        wcut_spacing_clear(&n);
        return WCUT_NO_MEMORY;
    }
    n.at[0] = d->parameter[0], n.at[1] = d->parameter[d->rows - 1];
    n.crease[0] = n.crease[1] = true;
    n.density[0] = PIECES_FIRST / (n.at[1] - n.at[0]);
    *s = n;
    return WCUT_OK;
}

/* knots by the density in `s`, which becomes that of the lines laid. *dense: interpolation is the better way */
static wcut_status next_fit(const data *d, wcut_spacing *s, double *missed, wcut_line_fit *fit, bool *dense) {
    /* lines by the density; too many are a sign that interpolation is better */
    wcut_spacing lines;
    wcut_status status = wcut_spacing_lines(s, d->rows, &lines);
    *dense = status == WCUT_NOT_CONVERGED;
    if (status != WCUT_OK) return *dense ? WCUT_OK : status;
    wcut_spacing_clear(s);
    *s = lines;

    /* knots on the lines, then least squares */
    wcut_line_fit f;
    status = fit_new(lines.pieces + 3, d->columns, &f);
    if (status != WCUT_OK) return status;
    f.count = lay_knots(d, &lines, f.knots);
    *dense = f.count > DENSE * d->rows;
    if (!*dense) status = line_fit_solve(d, &f, missed);
    if (status == WCUT_SINGULAR) *dense = true, status = WCUT_OK;

    if (status == WCUT_OK && !*dense) {
        *fit = f;
    } else {
        wcut_line_fit_clear(&f);
    }

    return status;
}

wcut_status wcut_line_fit_points(int rows, const double *parameter, int columns, const wcut_vec3 *point,
                                 double tolerance, wcut_line_fit *fit) {
    /* begin with a density from the data */
    const data d = {.rows = rows, .columns = columns, .parameter = parameter, .point = point};
    wcut_spacing s = {.pieces = 0};
    wcut_line_fit best = {.count = 0}, now = {.count = 0};
    bool dense = false;
    double *missed = wcut_alloc((size_t)rows, sizeof *missed);
    wcut_status status = missed ? line_fit_begin(&d, &s) : WCUT_NO_MEMORY;

    /* fit, and keep the smallest one that holds the tolerance */
    for (int round = 0; status == WCUT_OK && tolerance > 0 && round < ROUNDS_MAX; round++) {
        status = next_fit(&d, &s, missed, &now, &dense);
        if (status != WCUT_OK || dense) break;
        const double error = now.error;
        const bool held = error <= tolerance;
        if (held && (best.count == 0 || now.count < best.count)) {
            wcut_line_fit_clear(&best);
            best = now;
        } else {
            wcut_line_fit_clear(&now);
        }

        /* good enough, or no smaller one possible */
        if (best.count > 0 && (round >= ROUNDS_GOOD || (held && error >= ENOUGH * tolerance))) break;
        if (held && best.count <= PIECES_FIRST / 2) break; /* a plane needs no fewer */

        /* the density follows the error of this fit */
        adapt(&d, missed, tolerance, held, &s);
    }

    /* nothing held: the spline through all points */
    if (status == WCUT_OK && best.count == 0) status = line_fit_interpolate(&d, &best);
    if (status == WCUT_OK) {
        *fit = best;
    } else {
        wcut_line_fit_clear(&best);
    }
    wcut_spacing_clear(&s);

    wcut_free(missed);
    return status;
}
