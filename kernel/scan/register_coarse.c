/* A first guess for a best fit: the scan's principal plane onto the surface's, turned about it, either side up. */
#include "scan/register_coarse.h"

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/symmetric.h"
#include "surface/foot_search.h"

enum { GRID = 24, TURNS = 24, STARTS = 2 * TURNS, TRIED = 6, FEW = 300, SOME = 600, STEPS = 40 };

static const double BETTER = 0.9; /* [1] what another start must come down to, to be taken in place of the first */

/* a centre and right-handed axes, the least spread last */
typedef struct frame {
    wcut_vec3 centre;
    mat3 axis; /* by rows */
} frame;

/* points with a weight each */
static frame principal(int count, const wcut_vec3 *point, const double *weight) {
    frame f = {{0, 0, 0}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
    double c[9] = {0}, value[3], e[9], sum = 0;
    for (int i = 0; i < count; i++) {
        f.centre = vec3_add_scaled(f.centre, weight[i], point[i]);
        sum += weight[i];
    }
    f.centre = vec3_scale(1 / sum, f.centre);
    for (int i = 0; i < count; i++) {
        const wcut_vec3 p = vec3_sub(point[i], f.centre);
        const double a[3] = {p.x, p.y, p.z};
        for (int k = 0; k < 9; k++) c[k] += weight[i] * a[k / 3] * a[k % 3];
    }
    wcut_symmetric_eigen(3, c, value, e);
    f.axis.x = vec3(e[0], e[3], e[6]);
    f.axis.y = vec3(e[1], e[4], e[7]);
    f.axis.z = vec3_cross(f.axis.x, f.axis.y);
    return f;
}

/* of the triangles' centres, by their areas */
static wcut_status frame_of_mesh(const wcut_mesh *mesh, frame *found) {
    const size_t count = (size_t)mesh->triangle_count;
    wcut_vec3 *point = wcut_alloc(count, sizeof *point);
    double *weight = wcut_alloc(count, sizeof *weight);
    const bool done = point && weight;
    for (size_t t = 0; t < count && done; t++) {
        const int *v = mesh->triangle + 3 * t;
        const wcut_vec3 a = mesh->vertex[v[0]], b = mesh->vertex[v[1]], c = mesh->vertex[v[2]];
        point[t] = vec3_scale(1.0 / 3, vec3_add(a, vec3_add(b, c)));
        weight[t] = vec3_length(vec3_cross(vec3_sub(b, a), vec3_sub(c, a)));
    }
    if (done) *found = principal(mesh->triangle_count, point, weight);
    wcut_free(weight);
    wcut_free(point);
    return done ? WCUT_OK : WCUT_NO_MEMORY;
}

static frame frame_of_surface(const wcut_surface *surface) {
    wcut_vec3 point[GRID * GRID], d[4];
    double weight[GRID * GRID], first[2], last[2];
    wcut_surface_domain(surface, first, last);
    for (int i = 0; i < GRID * GRID; i++) {
        const int column = i % GRID, row = i / GRID;
        const double s = (column + 0.5) / GRID, t = (row + 0.5) / GRID;
        /* cannot fail: the surface is valid */
        (void)wcut_surface_eval(surface, first[0] + s * (last[0] - first[0]), first[1] + t * (last[1] - first[1]), 1,
                                d);
        point[i] = d[0];
        weight[i] = vec3_length(vec3_cross(d[2], d[1]));
    }
    return principal(GRID * GRID, point, weight);
}

static wcut_status frame_of_face(const wcut_register_face *face, frame *found) {
    if (!face->projection) return frame_of_mesh(face->mesh, found);
    *found = frame_of_surface(face->projection->surface);
    return WCUT_OK;
}

static frame frame_of_cloud(const wcut_register_cloud *c) {
    for (int i = 0; i < c->count; i++) c->square[i] = 1;
    return principal(c->count, c->point, c->square);
}

/* columns of a times rows of b: sum over the axes of a_k b_k^T */
static mat3 outer_sum(mat3 a, mat3 b) {
    mat3 r = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    return mat3_add_outer(mat3_add_outer(mat3_add_outer(r, a.x, b.x), a.y, b.y), a.z, b.z);
}

/* the scan's axes onto the surface's: turned about the third, the other side up in the second half of the starts */
static wcut_motion start_of(int k, wcut_vec3 pivot, const frame *scan, const frame *surface) {
    const double angle = 2 * WCUT_PI * (k % TURNS) / TURNS, side = k < TURNS ? 1 : -1;
    mat3 to;
    to.x = vec3_add_scaled(vec3_scale(cos(angle), surface->axis.x), sin(angle), surface->axis.y);
    to.z = vec3_scale(side, surface->axis.z);
    to.y = vec3_cross(to.z, to.x);
    return wcut_motion_between(pivot, outer_sum(to, scan->axis), scan->centre, surface->centre);
}

/* the numbers of the starts that come closest, the best first */
static wcut_status rank_starts(wcut_register_cloud *few, wcut_vec3 pivot, const frame *scan, const frame *surface,
                               int best[TRIED]) {
    double rms[STARTS];
    for (int k = 0; k < STARTS; k++) {
        const wcut_motion m = start_of(k, pivot, scan, surface);
        const wcut_status status = wcut_register_closeness(few, &m, &rms[k]);
        if (status != WCUT_OK) return status;
    }
    for (int place = 0; place < TRIED; place++) {
        best[place] = 0;
        for (int k = 1; k < STARTS; k++)
            if (rms[k] < rms[best[place]]) best[place] = k;
        rms[best[place]] = INFINITY;
    }
    return WCUT_OK;
}

/* some steps from a start; where they lead, and how close that is. One that leads nowhere stays where it was. */
static wcut_status register_coarse_approach(wcut_register_cloud *some, const wcut_registration_options *o,
                                            double length, wcut_motion *motion, double *rms) {
    wcut_registration unused = wcut_registration_none();
    wcut_register_problem problem = wcut_register_fit_problem(some, o, length);
    problem.max_iterations = STEPS;
    const wcut_status status = wcut_register_solve(&problem, motion, &unused);
    if (status != WCUT_OK && status != WCUT_NOT_CONVERGED && status != WCUT_DEGENERATE) return status;
    return wcut_register_closeness(some, motion, rms);
}

/* [mm] how far apart two motions bring the points (RMS) */
static double apart(const wcut_register_cloud *c, const wcut_motion *a, const wcut_motion *b) {
    double sum = 0;
    for (int i = 0; i < c->count; i++) {
        const wcut_vec3 d = vec3_sub(motion_apply(a, c->point[i]), motion_apply(b, c->point[i]));
        sum += vec3_dot(d, d);
    }
    return sqrt(sum / c->count);
}

static wcut_status register_coarse_choose(wcut_register_cloud *few, wcut_register_cloud *some,
                                          const wcut_registration_options *options, double length, wcut_motion *motion,
                                          double *rival) {
    /* a coarse fit needs a coarse tolerance only */
    wcut_registration_options o = *options;
    wcut_motion reached[TRIED + 1];
    double rms[TRIED + 1] = {0};
    int start[TRIED], best = 0;

    /* principal frames of scan and surface; starts are ranked on few points */
    const frame scan = frame_of_cloud(some);
    frame surface;
    o.tolerance = fmax(o.tolerance, 1e-6 * length);
    wcut_status status = frame_of_face(&some->face, &surface);
    if (status == WCUT_OK) status = rank_starts(few, motion->pivot, &scan, &surface, start);

    /* fit from the present motion and from the best starts; another one must be clearly better */
    for (int k = 0; k <= TRIED && status == WCUT_OK; k++) {
        reached[k] = k ? start_of(start[k - 1], motion->pivot, &scan, &surface) : *motion;
        status = register_coarse_approach(some, &o, length, &reached[k], &rms[k]);
        const double min = (best ? 1 : BETTER) * rms[best] - (best ? 0 : 1e-6 * length);
        if (status == WCUT_OK && k && rms[k] < min) best = k;
    }
    if (status != WCUT_OK) return status;

    /* the best of those that end elsewhere is the rival, for the report */
    *rival = 0;
    for (int k = 0; k <= TRIED; k++)
        if (apart(some, &reached[k], &reached[best]) > 0.01 * length && (!(*rival > 0) || rms[k] < *rival))
            *rival = rms[k];
    *motion = reached[best];

    return WCUT_OK;
}

wcut_status wcut_register_coarse(wcut_register_face face, int count, const wcut_vec3 *point, double length,
                                 const wcut_registration_options *options, int threads, wcut_motion *motion,
                                 double *rival) {
    wcut_register_cloud few = {0}, some = {0};
    wcut_status status = wcut_register_sample(face, count, point, FEW, options->keep, threads, &few);
    if (status == WCUT_OK) status = wcut_register_sample(face, count, point, SOME, options->keep, threads, &some);
    if (status == WCUT_OK) status = register_coarse_choose(&few, &some, options, length, motion, rival);
    wcut_register_sample_clear(&few);
    wcut_register_sample_clear(&some);
    return status;
}
