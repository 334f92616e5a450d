/* A surface and the loops of curves that bound the part of it that counts: polygons in its parameters. */
#include <wirecut/trimmed.h>

#include <limits.h>
#include <math.h>
#include <stdbool.h>
#include <wirecut/curvature.h>
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "surface/trimmed.h"

enum { STEPS_MIN = 8, STEPS_MAX = 1 << 14, POINTS_MAX = 10000000 };

static const double CHORD = 0.005; /* [mm] of a polygon's sides */

static double trimmed_distance(wcut_vec3 a, wcut_vec3 b) {
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return sqrt(x * x + y * y + z * z);
}

static wcut_vec3 point_at(const wcut_curve *curve, double share) {
    double first, last;
    wcut_vec3 p = {0, 0, 0};
    wcut_curve_domain(curve, &first, &last);
    wcut_curve_eval(curve, share < 1 ? first + share * (last - first) : last, 0, &p); /* within its domain */
    return p;
}

/* ---- polygons ---- */

/* even steps of a curve whose chords are within CHORD of it at their middles; a straight line needs the fewest */
static int count_steps(const wcut_curve *curve) {
    const int spans = curve->control_count - curve->degree;
    if (spans == 1 && curve->degree == 1) return 1;
    int steps = spans < STEPS_MIN ? STEPS_MIN : spans < STEPS_MAX ? spans : STEPS_MAX;
    for (; steps < STEPS_MAX; steps *= 2) {
        double worst = 0;
        for (int k = 0; k < steps; k++) {
            const wcut_vec3 a = point_at(curve, (double)k / steps), b = point_at(curve, (k + 1.0) / steps);
            const wcut_vec3 middle = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
            worst = fmax(worst, trimmed_distance(middle, point_at(curve, (k + 0.5) / steps)));
        }
        if (worst <= CHORD) return steps;
    }
    return steps;
}

/* the points of all loops, and where each loop begins; each curve gives its points but the last */
static wcut_status sample_loops(wcut_trimmed *t, const int *curves, const wcut_curve *const *curve) {
    /* how many */
    long long count = 0;
    int all = 0;
    for (int loop = 0; loop < t->loops; loop++) all += curves[loop];
    int *steps = wcut_alloc((size_t)all, sizeof *steps);
    if (!steps) return WCUT_NO_MEMORY;
    for (int c = 0; c < all; c++) count += steps[c] = count_steps(curve[c]);
    if (count > POINTS_MAX) return wcut_free(steps), WCUT_DEGENERATE;

    /* the points themselves */
    t->point = wcut_alloc((size_t)count, sizeof *t->point);
    t->uv = wcut_alloc(2 * (size_t)count, sizeof *t->uv);
    if (!t->point || !t->uv) return wcut_free(steps), WCUT_NO_MEMORY;
    int at = 0, c = 0;
    for (int loop = 0; loop < t->loops; loop++) {
        t->first[loop] = at;
        for (int k = 0; k < curves[loop]; k++, c++)
            for (int step = 0; step < steps[c]; step++) t->point[at++] = point_at(curve[c], (double)step / steps[c]);
    }
    t->first[t->loops] = at;
    wcut_free(steps);
    return WCUT_OK;
}

/* each curve begins where the one before ends */
static wcut_status check_joints(int loops, const int *curves, const wcut_curve *const *curve, double gap,
                                wcut_error *error) {
    for (int loop = 0, first = 0; loop < loops; first += curves[loop++])
        for (int k = 0; k < curves[loop]; k++) {
            const wcut_vec3 end = point_at(curve[first + k], 1);
            const double off = trimmed_distance(end, point_at(curve[first + (k + 1) % curves[loop]], 0));
            if (!(off <= gap)) return wcut_fail(error, WCUT_DEGENERATE, "two curves of a loop are %.3g mm apart", off);
        }
    return WCUT_OK;
}

/* the points become points of the surface */
static wcut_status project_loops(wcut_trimmed *t, double gap, wcut_error *error) {
    const int count = t->first[t->loops];
    wcut_projection *projection = NULL;
    wcut_foot *foot = wcut_alloc((size_t)count, sizeof *foot);
    wcut_status status = foot ? wcut_projection_create(t->surface, &projection) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_projection_locate(projection, count, t->point, 1, foot);
    for (int k = 0; k < count && status == WCUT_OK; k++) {
        if (!(foot[k].distance <= gap))
            status =
                wcut_fail(error, WCUT_DEGENERATE, "a curve of a loop is %.3g mm off the surface", foot[k].distance);
        t->point[k] = foot[k].point;
        t->uv[2 * (size_t)k] = foot[k].u;
        t->uv[2 * (size_t)k + 1] = foot[k].v;
    }
    wcut_projection_destroy(projection);
    wcut_free(foot);
    return status;
}

/* whether the two edges of a direction coincide: points of the seam have two parameters there */
static bool is_closed(const wcut_surface *s, bool along_u) {
    const int rows = along_u ? s->count_v : s->count_u;
    double size = 0, apart = 0;
    for (int k = 0; k < rows; k++) {
        const wcut_vec3 *a = along_u ? &s->control[(size_t)k * (size_t)s->count_u] : &s->control[k];
        const wcut_vec3 *b =
            along_u ? a + s->count_u - 1 : &s->control[(size_t)(s->count_v - 1) * (size_t)s->count_u + (size_t)k];
        apart = fmax(apart, trimmed_distance(*a, *b));
        size = fmax(size, trimmed_distance(*a, s->control[0]));
    }
    return apart <= 1e-6 * (1 + size);
}

wcut_status wcut_trimmed_create(wcut_surface *surface, int loops, const int *curves, const wcut_curve *const *curve,
                                double gap, wcut_trimmed **trimmed, wcut_error *error) {
    /* arguments */
    if (!surface || loops < 0 || (loops > 0 && (!curves || !curve)) || !(gap > 0 && gap < 1e12) || !trimmed)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    for (int loop = 0, at = 0; loop < loops; at += curves[loop++]) {
        if (curves[loop] < 1 || curves[loop] > POINTS_MAX)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "a loop: found %d curves, expected some", curves[loop]);
        for (int k = 0; k < curves[loop]; k++)
            if (!curve[at + k]) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a loop: found a curve that is NULL");
    }
    if (loops > 0 && (is_closed(surface, true) || is_closed(surface, false)))
        return wcut_fail(error, WCUT_DEGENERATE, "the surface is closed");

    /* the loops as polygons on the surface */
    wcut_trimmed *t = wcut_alloc(1, sizeof *t);
    wcut_status status = t ? check_joints(loops, curves, curve, gap, error) : WCUT_NO_MEMORY;
    if (t) *t = (wcut_trimmed){.surface = surface, .loops = loops};
    if (status == WCUT_OK) {
        t->first = wcut_alloc((size_t)loops + 1, sizeof *t->first);
        status = !t->first ? WCUT_NO_MEMORY : loops > 0 ? sample_loops(t, curves, curve) : WCUT_OK;
    }
    if (status == WCUT_OK && loops > 0) status = project_loops(t, gap, error);

    /* the surface stays the caller's where it failed */
    if (status == WCUT_OK) {
        *trimmed = t;
        return WCUT_OK;
    }
    if (t) t->surface = NULL;
    wcut_trimmed_destroy(t);
    if (error && error->status != status) wcut_fail(error, status, "%s", wcut_status_text(status));
    return status;
}

void wcut_trimmed_destroy(wcut_trimmed *t) {
    if (!t) return;
    wcut_surface_destroy(t->surface);
    wcut_free(t->first);
    wcut_free(t->point);
    wcut_free(t->uv);
    wcut_free(t);
}

/* ---- inside ---- */

int wcut_trimmed_inside(const wcut_trimmed *t, double u, double v) {
    if (!t || t->loops == 0) return t != NULL;
    int inside = 0;

    /* sides that a ray along +u crosses; each end belongs to the side above it */
    for (int loop = 0; loop < t->loops; loop++)
        for (int k = t->first[loop], last = t->first[loop + 1] - 1; k < t->first[loop + 1]; last = k++) {
            const double *a = &t->uv[2 * (size_t)last], *b = &t->uv[2 * (size_t)k];
            if ((a[1] > v) == (b[1] > v)) continue;
            inside ^= u < a[0] + (v - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
        }
    return inside;
}

/* how far p is outside of the box of a and b along one axis, at most */
static double outside_of(double p, double a, double b) {
    const double below = (a < b ? a : b) - p, above = p - (a > b ? a : b);
    return below > above ? below : above;
}

double wcut_trimmed_border_within(const wcut_trimmed *t, wcut_vec3 p, double limit) {
    double least = limit;
    for (int loop = 0; t && loop < t->loops; loop++)
        for (int k = t->first[loop], last = t->first[loop + 1] - 1; k < t->first[loop + 1]; last = k++) {
            const wcut_vec3 a = t->point[last], b = t->point[k];
            if (outside_of(p.x, a.x, b.x) > least || outside_of(p.y, a.y, b.y) > least ||
                outside_of(p.z, a.z, b.z) > least)
                continue;
            const wcut_vec3 d = {b.x - a.x, b.y - a.y, b.z - a.z}, e = {p.x - a.x, p.y - a.y, p.z - a.z};
            const double size = d.x * d.x + d.y * d.y + d.z * d.z, along = d.x * e.x + d.y * e.y + d.z * e.z;
            const double share = size > 0 ? fmin(fmax(along / size, 0), 1) : 0;
            const wcut_vec3 foot = {a.x + share * d.x, a.y + share * d.y, a.z + share * d.z};
            const double away = trimmed_distance(p, foot);
            if (away < least) least = away;
        }
    return least;
}

double wcut_trimmed_border(const wcut_trimmed *t, wcut_vec3 p) {
    return t && t->loops > 0 ? wcut_trimmed_border_within(t, p, INFINITY) : -1;
}

/* ---- triangles ---- */

/* cells that a direction of a trimmed face has at least, so that its border is no coarser than that */
enum { CELLS_MIN = 200 };

/* a parameter of a grid whose lines are those of a tessellation, each cell in `parts` */
static double grid_line(const wcut_mesh *of, int columns, bool along_u, int parts, int k) {
    const size_t at = (size_t)(k / parts) * (along_u ? 1 : (size_t)columns);
    const double *from = &of->uv[2 * at + (along_u ? 0 : 1)];
    if (k % parts == 0) return from[0];
    const double to = from[2 * (along_u ? 1 : (size_t)columns)];
    return from[0] + (to - from[0]) * (k % parts) / parts;
}

/* triangles of the grid whose middle is inside; number holds a vertex's place + 1, or 0 */
static wcut_status fill_grid(const wcut_trimmed *t, const double *u, const double *v, int columns, int rows,
                             int *number, wcut_mesh **mesh) {
    int used = 0, kept = 0;
    wcut_mesh *made = NULL;

    /* which triangles, and the vertices that they use */
    for (int pass = 0; pass < 2; pass++) {
        kept = 0;
        for (int k = 0; k < 2 * (columns - 1) * (rows - 1); k++) {
            const int i = k / 2 % (columns - 1), j = k / 2 / (columns - 1), upper = k % 2;
            const int corner[3] = {j * columns + i + (upper ? columns + 1 : 0), j * columns + i + (upper ? columns : 1),
                                   j * columns + i + (upper ? 0 : columns + 1)};
            const double third = upper ? 1 / 3.0 : 2 / 3.0;
            if (!wcut_trimmed_inside(t, u[i] + third * (u[i + 1] - u[i]), v[j] + (1 - third) * (v[j + 1] - v[j])))
                continue;
            for (int c = 0; c < 3; c++) {
                if (pass == 0 && !number[corner[c]]) number[corner[c]] = ++used;
                if (pass == 1) made->triangle[3 * kept + c] = number[corner[c]] - 1;
            }
            kept++;
        }
        if (pass == 0 && kept == 0) return WCUT_DEGENERATE;
        if (pass == 1) break;
        const wcut_status status = wcut_mesh_create(used, kept, WCUT_MESH_NORMAL | WCUT_MESH_UV, &made);
        if (status != WCUT_OK) return status;
    }

    /* their places */
    for (int k = 0; k < columns * rows; k++) {
        if (!number[k]) continue;
        const int to = number[k] - 1;
        const double at[2] = {u[k % columns], v[k / columns]};
        wcut_surface_eval(t->surface, at[0], at[1], 0, &made->vertex[to]); /* within its domain */
        if (wcut_surface_normal(t->surface, at[0], at[1], &made->normal[to]) != WCUT_OK)
            made->normal[to] = (wcut_vec3){0, 0, 1};
        made->uv[2 * (size_t)to] = at[0];
        made->uv[2 * (size_t)to + 1] = at[1];
    }
    *mesh = made;
    return WCUT_OK;
}

wcut_status wcut_trimmed_mesh(const wcut_trimmed *t, double chord_tolerance, wcut_mesh **mesh) {
    wcut_mesh *all = NULL;
    wcut_tessellation_report report;
    if (!t || !mesh) return WCUT_BAD_ARGUMENT;

    /* without loops the whole surface is the face */
    wcut_status status = wcut_surface_tessellate(t->surface, chord_tolerance, &all, &report);
    if (status != WCUT_OK || t->loops == 0) {
        if (status == WCUT_OK) *mesh = all;
        return status;
    }

    /* the tessellation's lines, and more between them where they are few */
    const int parts_u = CELLS_MIN / (report.columns - 1) + 1, parts_v = CELLS_MIN / (report.rows - 1) + 1;
    const int columns = parts_u * (report.columns - 1) + 1, rows = parts_v * (report.rows - 1) + 1;
    double *line = wcut_alloc((size_t)columns + (size_t)rows, sizeof *line);
    int *number = wcut_alloc((size_t)columns * (size_t)rows, sizeof *number);

    /* the cells of this grid that the loops leave, clipped along them */
    if (line && number && columns <= INT_MAX / 8 / rows) {
        for (int k = 0; k < columns; k++) line[k] = grid_line(all, report.columns, true, parts_u, k);
        for (int k = 0; k < rows; k++) line[columns + k] = grid_line(all, report.columns, false, parts_v, k);
        status = fill_grid(t, line, line + columns, columns, rows, number, mesh);
    } else {
        status = WCUT_NO_MEMORY;
    }
    wcut_free(line);
    wcut_free(number);
    wcut_mesh_destroy(all);
    return status;
}
