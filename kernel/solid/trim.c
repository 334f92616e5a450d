/* Where the cut meets the block's sides: crossings seen on a coarse net, then made exact by Newton's method. */
#include "solid/trim.h"

#include <limits.h>
#include <stdbool.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"

enum { RIBS = 65, LINES_MIN = 96, NEWTON_MAX = 40 };

/* Crossings are solved until they are this share of the block's size from their plane. */
static const double SOLVED = 1e-13;

/* A side counts as reached where this share of the size is missing: rounding of a wire drawn onto the side. */
static const double REACHED = 1e-9;

/* points of the unprolonged sheet on a net of parameters */
typedef struct net {
    int columns, rows;
    double *u, *v;
    wcut_vec3 *at; /* rows x columns */
} net;

/* a point between two columns of a row */
typedef struct crossing {
    double u;
    wcut_vec3 at;
} crossing;

static void net_clear(net *n) {
    wcut_free(n->u);
    wcut_free(n->v);
    wcut_free(n->at);
    *n = (net){.columns = 0};
}

/* every span of the knots from `first` on in equal parts, so that there are at least LINES_MIN; gives their number */
static int net_lines(int degree, int count, const double *knots, double first, double **line) {
    int spans = 0, made = 0;
    for (int k = degree; k < count; k++) spans += fmax(knots[k], first) < knots[k + 1];
    const int parts = spans > 0 ? (LINES_MIN + spans - 1) / spans : 1; /* a valid surface has a span */
    double *l = wcut_alloc((size_t)spans * (size_t)parts + 1, sizeof *l);
    *line = l;
    if (!l) return 0;
    for (int k = degree; k < count; k++) {
        const double from = fmax(knots[k], first);
        for (int i = 0; from < knots[k + 1] && i < parts; i++) l[made++] = from + (knots[k + 1] - from) * i / parts;
    }
    l[made++] = knots[count];
    return made;
}

static wcut_status net_fill(const wcut_sheet *sheet, net *n) {
    const wcut_surface *s = sheet->surface;
    n->columns = net_lines(s->degree_u, s->count_u, s->knots_u, sheet->first[0], &n->u);
    n->rows = net_lines(s->degree_v, s->count_v, s->knots_v, sheet->first[1], &n->v);
    if (!n->u || !n->v) return WCUT_NO_MEMORY;
    if (n->columns > INT_MAX / n->rows) return WCUT_BAD_ARGUMENT;
    n->at = wcut_alloc((size_t)n->columns * (size_t)n->rows, sizeof *n->at);
    if (!n->at) return WCUT_NO_MEMORY;
    return wcut_surface_eval_grid(s, n->columns, n->u, n->rows, n->v, n->at);
}

/* Where row j crosses the plane x, on its polygon; beyond its ends on its first or last edge, prolonged. *edge: where
   to begin, then the edge found. False where that edge does not run towards larger x. */
static bool cross_row(const net *n, int j, double x, int *edge, crossing *found) {
    const wcut_vec3 *row = n->at + (ptrdiff_t)j * n->columns;
    int i = *edge;
    while (i > 0 && row[i].x > x) i--;
    while (i < n->columns - 2 && row[i + 1].x <= x) i++;
    *edge = i;
    const double wide = row[i + 1].x - row[i].x, t = (x - row[i].x) / wide;
    if (!(wide > 0)) return false;
    *found = (crossing){n->u[i] + t * (n->u[i + 1] - n->u[i]), vec3_mix(row[i], row[i + 1], t)};
    return true;
}

static double trim_size_of(const wcut_trim *m) {
    return fmax(m->sides.x[1] - m->sides.x[0], m->sides.y[1] - m->sides.y[0]);
}

/* Newton's method for x(u, v) = x, y(u, v) = y; `u`, `v`: a guess, then the solution */
static bool solve_corner(const wcut_trim *m, double x, double y, double *u, double *v) {
    /* [mm] how close the corner must come */
    const double held = SOLVED * (trim_size_of(m) + fabs(x) + fabs(y));
    double a = *u, b = *v, best = INFINITY;
    for (int k = 0; k < NEWTON_MAX; k++) {
        const wcut_sheet_point p = wcut_sheet_eval(m->sheet, a, b);
        const double f = p.at.x - x, g = p.at.y - y, miss = fmax(fabs(f), fabs(g));
        /* at rest to what is asked for, or to what rounding allows */
        if (miss <= held || (miss < 100 * held && miss >= best)) {
            *u = a, *v = b;
            return true;
        }
        best = fmin(best, miss);

        /* Newton's step in (u, v) */
        const double det = p.along_u.x * p.along_v.y - p.along_u.y * p.along_v.x;
        if (!(fabs(det) > 0)) return false;
        a -= (f * p.along_v.y - g * p.along_v.x) / det;
        b -= (g * p.along_u.x - f * p.along_u.y) / det;
        if (!isfinite(a) || !isfinite(b)) return false;
    }

    return false;
}

static wcut_status turns_back(wcut_error *error, wcut_vec3 at) {
    return wcut_fail(error, WCUT_DEGENERATE,
                     "the cut folds over itself: near (%.6g, %.6g, %.6g) mm the wire does not run on towards larger x",
                     at.x, at.y, at.z);
}

/* Where the polygon of a rib passes y = level, from below to above, on row *j to *j + 1 or beyond the ends (-1, rows-1).
   WCUT_DEGENERATE where it does so more than once. */
static wcut_status cross_level(const net *n, const crossing *rib, double level, double reached, int *j,
                               wcut_error *error) {
    int up = 0, down = 0, at = rib[0].at.y > level ? -1 : n->rows - 1;
    for (int k = 0; k + 1 < n->rows; k++) {
        const bool low = rib[k].at.y <= level, high = rib[k + 1].at.y > level;
        if (low && high && up++ == 0) at = k;
        if (!low && !high && rib[k + 1].at.y < level - reached) {
            if (down++ == 0 && up > 0) at = k;
        }
    }
    if (down > 0)
        return wcut_fail(error, WCUT_DEGENERATE,
                         "the cut folds over itself: in the plane x = %.6g mm it passes the block's side y = %.6g mm "
                         "%d times, the last time back near z = %.6g mm",
                         rib[0].at.x, level, up + down, rib[at < 0 ? 0 : at].at.z);
    *j = at;
    return WCUT_OK;
}

/* parameters where a rib's polygon is at y = level, between rows j and j + 1 or prolonged beyond the ends */
static bool guess_level(const net *n, const crossing *rib, double level, int j, double *u, double *v) {
    const int k = j < 0 ? 0 : j > n->rows - 2 ? n->rows - 2 : j;
    const double wide = rib[k + 1].at.y - rib[k].at.y, t = (level - rib[k].at.y) / wide;
    if (!(wide > 0)) return false;
    *u = rib[k].u + t * (rib[k + 1].u - rib[k].u);
    *v = n->v[k] + t * (n->v[k + 1] - n->v[k]);
    return true;
}

/* One rib from the net: every row crossed, then both sides. */
static wcut_status find_rib(const wcut_trim *m, const net *n, double x, int *edge, crossing *polygon, wcut_rib *rib,
                            wcut_error *error) {
    const wcut_sides *s = &m->sides;

    /* where every row of the net crosses the plane of x */
    rib->x = x;
    for (int j = 0; j < n->rows; j++)
        if (!cross_row(n, j, x, &edge[j], &polygon[j]))
            return turns_back(error, n->at[(ptrdiff_t)j * n->columns + edge[j]]);

    /* both sides of the block: a guess from the net, then Newton's method */
    for (int k = 0; k < 2; k++) {
        int j = 0;
        const wcut_status status = cross_level(n, polygon, s->y[k], REACHED * trim_size_of(m), &j, error);
        if (status != WCUT_OK) return status;
        if (!guess_level(n, polygon, s->y[k], j, &rib->u[k], &rib->v[k]) ||
            !solve_corner(m, x, s->y[k], &rib->u[k], &rib->v[k])) {
            const wcut_vec3 end = polygon[k == 0 ? 0 : n->rows - 1].at;
            return wcut_fail(error, WCUT_DEGENERATE,
                             "the cut does not reach the block's side y = %.6g mm: in the plane x = %.6g mm it %s at "
                             "y = %.6g, z = %.6g mm and cannot be continued straight",
                             s->y[k], x, k == 0 ? "begins" : "ends", end.y, end.z);
        }
    }

    if (!(rib->v[0] < rib->v[1]))
        return wcut_fail(error, WCUT_DEGENERATE, "the cut runs against the feed in the plane x = %.6g mm", x);

    return WCUT_OK;
}

/* Is any of the net over the block at all? */
static wcut_status check_over(const wcut_trim *m, const net *n, wcut_error *error) {
    wcut_vec3 low = n->at[0], high = n->at[0];
    for (ptrdiff_t k = 1; k < (ptrdiff_t)n->rows * n->columns; k++) {
        const wcut_vec3 p = n->at[k];
        low = vec3(fmin(low.x, p.x), fmin(low.y, p.y), 0);
        high = vec3(fmax(high.x, p.x), fmax(high.y, p.y), 0);
    }
    const wcut_sides *s = &m->sides;
    if (high.x <= s->x[0] || low.x >= s->x[1] || high.y <= s->y[0] || low.y >= s->y[1])
        return wcut_fail(error, WCUT_DEGENERATE,
                         "the cut misses the block: it covers x from %.6g to %.6g and y from %.6g to %.6g mm", low.x,
                         high.x, low.y, high.y);
    return WCUT_OK;
}

/* Over the block a wire runs on towards larger x, else planes of x meet it more than once. */
static wcut_status check_trim_rows(const wcut_trim *m, const net *n, wcut_error *error) {
    const wcut_sides *s = &m->sides;
    for (int j = 0; j < n->rows; j++)
        for (int i = 0; i + 1 < n->columns; i++) {
            const wcut_vec3 a = n->at[(ptrdiff_t)j * n->columns + i], b = n->at[(ptrdiff_t)j * n->columns + i + 1];
            const bool over = fmax(a.x, b.x) > s->x[0] && fmin(a.x, b.x) < s->x[1] && fmax(a.y, b.y) > s->y[0] &&
                              fmin(a.y, b.y) < s->y[1];
            if (over && !(b.x > a.x)) return turns_back(error, a);
        }
    return WCUT_OK;
}

wcut_status wcut_trim_begin(const wcut_sheet *sheet, wcut_sides sides, wcut_trim *trim, wcut_error *error) {
    wcut_trim m = {.sheet = sheet, .sides = sides, .ribs = RIBS};
    net n = {.columns = 0};
    int *edge = NULL;
    crossing *polygon = NULL;

    /* the net, and room for its crossings */
    wcut_status status = net_fill(sheet, &n);
    if (status == WCUT_OK) {
        m.rib = wcut_alloc(RIBS, sizeof *m.rib);
        edge = wcut_alloc((size_t)n.rows, sizeof *edge);
        polygon = wcut_alloc((size_t)n.rows, sizeof *polygon);
        if (!m.rib || !edge || !polygon) status = WCUT_NO_MEMORY;
    }

    /* part of the sheet is over the block, and no row of it turns back along x */
    if (status == WCUT_OK) status = check_over(&m, &n, error);
    if (status == WCUT_OK) status = check_trim_rows(&m, &n, error);

    /* ribs: sections of the sheet in planes of x */
    for (int k = 0; status == WCUT_OK && k < RIBS; k++) {
        const double t = k / (RIBS - 1.0), x = (1 - t) * sides.x[0] + t * sides.x[1];
        status = find_rib(&m, &n, x, edge, polygon, &m.rib[k], error);
    }
    if (status == WCUT_OK) {
        *trim = m;
    } else {
        wcut_free(m.rib);
    }
    wcut_free(polygon);
    wcut_free(edge);
    net_clear(&n);

    return status;
}

void wcut_trim_clear(wcut_trim *trim) {
    wcut_free(trim->rib);
    *trim = (wcut_trim){.ribs = 0};
}

wcut_status wcut_trim_rib(const wcut_trim *trim, double x, wcut_rib *rib, wcut_error *error) {
    /* the neighbouring ribs give the guess */
    const wcut_sides *s = &trim->sides;
    const double place = clamp((x - s->x[0]) / (s->x[1] - s->x[0]), 0, 1) * (trim->ribs - 1);
    const int k = place < trim->ribs - 2 ? (int)place : trim->ribs - 2;
    const wcut_rib *a = &trim->rib[k], *b = a + 1;
    const double t = place - k;
    wcut_rib r = {.x = x};

    /* exact corners on both sides of the block */
    for (int e = 0; e < 2; e++) {
        r.u[e] = (1 - t) * a->u[e] + t * b->u[e];
        r.v[e] = (1 - t) * a->v[e] + t * b->v[e];
        if (!solve_corner(trim, x, s->y[e], &r.u[e], &r.v[e]))
            return wcut_fail(error, WCUT_DEGENERATE,
                             "the cut does not pass cleanly through the block's side y = %.6g mm at x = %.6g mm",
                             s->y[e], x);
    }

    if (!(r.v[0] < r.v[1]))
        return wcut_fail(error, WCUT_DEGENERATE, "the cut runs against the feed in the plane x = %.6g mm", x);
    *rib = r;

    return WCUT_OK;
}

wcut_status wcut_trim_point(const wcut_trim *trim, double x, double v, double *u, wcut_sheet_point *point,
                            wcut_error *error) {
    const double held = SOLVED * (trim_size_of(trim) + fabs(x));
    double a = *u, best = INFINITY;
    for (int k = 0; k < NEWTON_MAX; k++) {
        const wcut_sheet_point p = wcut_sheet_eval(trim->sheet, a, v);
        const double miss = p.at.x - x;
        if (!(p.along_u.x > 0)) return turns_back(error, p.at);
        if (fabs(miss) <= held || (fabs(miss) < 100 * held && fabs(miss) >= best)) {
            *u = a;
            *point = p;
            return WCUT_OK;
        }
        best = fmin(best, fabs(miss));
        a -= miss / p.along_u.x;
        if (!isfinite(a)) break;
    }
    return wcut_fail(error, WCUT_DEGENERATE, "the cut has no point at x = %.6g mm on the wire at v = %.6g", x, v);
}
