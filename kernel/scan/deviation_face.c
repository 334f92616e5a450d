/* The simulated cut face: the wire's surface lowered by half the kerf, and what of it is in the block as a grid. */
#include <wirecut/curvature.h>
#include <wirecut/face.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

enum { HALVINGS = 60 };

static const double PER_MM = 1000;     /* Q_eff is in J/m^2, speeds are in mm/s */
static const double PATH_SHARE = 0.01; /* of a path's length: curvature is that over as much on either side */

/* what a face is made from */
typedef struct maker {
    const wcut_job *job;
    const wcut_history *history;
    double merge;
    wcut_face *face;
    wcut_vec3 *node, *normal; /* stations x nodes of the history */
    double *q_eff, *half;     /* the same */
} maker;

/* ---- the lowered nodes ---- */

/* S_u x S_v of the wire's own surface at every node; where there is none, that of the node before */
static wcut_status deviation_face_find_normals(maker *m, const wcut_surface *wire) {
    const wcut_history *h = m->history;
    wcut_vec3 last = {0, 0, 1}, d[4];
    for (int s = 0; s < h->stations; s++)
        for (int n = 0; n < h->nodes; n++) {
            const wcut_status status = wcut_surface_eval(wire, n / (h->nodes - 1.0), m->face->parameter[s], 1, d);
            if (status != WCUT_OK) return status;
            const wcut_vec3 normal = vec3_unit(vec3_cross(d[2], d[1]));
            if (vec3_length(normal) > 0) last = normal;
            m->normal[(size_t)s * h->nodes + n] = last;
        }
    return WCUT_OK;
}

/* half the kerf at every node; the first station has no speed of its own, it takes that of the second */
static void find_kerf(maker *m) {
    const wcut_history *h = m->history;
    const wcut_job *job = m->job;
    for (int s = 0; s < h->stations; s++)
        for (int n = 0; n < h->nodes; n++) {
            const size_t i = (size_t)s * h->nodes + n;
            const double speed = h->speed[s > 0 ? i : i + (size_t)h->nodes];
            m->q_eff[i] = PER_MM * job->heat / clamp(speed, job->speed_min, INFINITY);
            m->half[i] = (job->kerf_width + job->kerf_per_q * m->q_eff[i]) / 2;
        }
}

static wcut_status deviation_face_lower(maker *m) {
    const wcut_history *h = m->history;
    const size_t count = (size_t)h->stations * h->nodes;

    /* loft through the stations as they are, for the normals of the wire's surface */
    wcut_surface *wire = NULL;
    wcut_status status =
        wcut_surface_loft(h->stations, h->nodes, h->position, m->merge, &wire, m->face->parameter, NULL);
    if (status == WCUT_OK) status = deviation_face_find_normals(m, wire);
    wcut_surface_destroy(wire);
    if (status != WCUT_OK) return status;

    /* half the kerf along the normal, downwards, then what effects do to the face */
    find_kerf(m);
    for (size_t i = 0; i < count; i++) m->node[i] = vec3_add_scaled(h->position[i], -m->half[i], m->normal[i]);
    status = wcut_face_eval(m->job->effect_count, m->job->effect, m->job->block_size, (int)count, m->normal, m->q_eff,
                            m->node);

    /* the face is the loft through the lowered nodes, at the same parameters */
    wcut_loft_report report;
    if (status == WCUT_OK)
        status =
            wcut_surface_loft(h->stations, h->nodes, m->node, m->merge, &m->face->surface, m->face->parameter, &report);
    if (status == WCUT_OK) m->face->dropped = report.dropped;

    return status;
}

/* ---- the part in the block ---- */

static wcut_vec3 deviation_face_at(const wcut_face *f, double u, double v) {
    wcut_vec3 p;
    wcut_surface_eval(f->surface, u, v, 0, &p); /* its arguments are sound */
    return p;
}

/* u between `out`, where x is outside the block's width, and `in` */
static double cross_side(const wcut_face *f, double v, double out, double in, double side, bool is_low) {
    for (int k = 0; k < HALVINGS; k++) {
        const double u = (out + in) / 2, x = deviation_face_at(f, u, v).x;
        if (is_low ? x < side : x > side)
            out = u;
        else
            in = u;
    }
    return in;
}

/* the part of a station within the block's width; false: there is none */
static bool trim_row(wcut_face *f, int s) {
    const double v = f->parameter[s], step = 1.0 / (f->nodes - 1);
    int first = 0, last = f->nodes - 1;
    f->begin[s] = 0, f->end[s] = 1;
    while (first < f->nodes && deviation_face_at(f, first * step, v).x < f->low.x) first++;
    while (last >= 0 && deviation_face_at(f, last * step, v).x > f->high.x) last--;
    if (first > last) return false;
    if (first > 0) f->begin[s] = cross_side(f, v, (first - 1) * step, first * step, f->low.x, true);
    if (last < f->nodes - 1) f->end[s] = cross_side(f, v, (last + 1) * step, last * step, f->high.x, false);
    return f->begin[s] < f->end[s];
}

/* u of a column at a v between the stations s and s + 1 */
static double u_between(const wcut_face *f, int s, double v, double share) {
    const double step = f->parameter[s + 1] - f->parameter[s], t = step > 0 ? (v - f->parameter[s]) / step : 0;
    const double begin = f->begin[s] + t * (f->begin[s + 1] - f->begin[s]);
    return begin + share * (f->end[s] + t * (f->end[s + 1] - f->end[s]) - begin);
}

/* v between the stations s and s + 1 where a column passes y = side */
static double cross_end(const wcut_face *f, int s, double share, double side) {
    double low = f->parameter[s], high = f->parameter[s + 1];
    const bool rises = deviation_face_at(f, u_between(f, s, high, share), high).y >
                       deviation_face_at(f, u_between(f, s, low, share), low).y;
    for (int k = 0; k < HALVINGS; k++) {
        const double v = (low + high) / 2;
        if ((deviation_face_at(f, u_between(f, s, v, share), v).y < side) == rises)
            low = v;
        else
            high = v;
    }
    return (low + high) / 2;
}

/* rows of a column between `from` and `to` lie at one place: the block's edge */
static void draw_back(wcut_face *f, int column, int from, int to, wcut_vec3 place, double v) {
    for (int s = from; s < to; s++) {
        const size_t i = (size_t)s * f->nodes + column;
        f->point[i] = place, f->v[i] = v, f->inside[i] = 0;
    }
}

static void trim_column(wcut_face *f, int column) {
    const double share = column / (f->nodes - 1.0);
    int first = 0, last = f->stations - 1;
    while (first < f->stations && f->point[(size_t)first * f->nodes + column].y < f->low.y) first++;
    while (last >= 0 && f->point[(size_t)last * f->nodes + column].y > f->high.y) last--;
    if (first > last) {
        draw_back(f, column, 0, f->stations, f->point[column], f->parameter[0]);
        return;
    }
    if (first > 0) {
        const double v = cross_end(f, first - 1, share, f->low.y);
        draw_back(f, column, 0, first, deviation_face_at(f, u_between(f, first - 1, v, share), v), v);
    }
    if (last < f->stations - 1) {
        const double v = cross_end(f, last, share, f->high.y);
        draw_back(f, column, last + 1, f->stations, deviation_face_at(f, u_between(f, last, v, share), v), v);
    }
}

/* a nodal field of the history at u of station s */
static double deviation_face_along(const wcut_history *h, const double *field, int s, double u) {
    const double x = clamp(u, 0, 1) * (h->nodes - 1);
    const int n = x < h->nodes - 2 ? (int)x : h->nodes - 2;
    const double *row = field + (size_t)s * h->nodes;
    return row[n] + (x - n) * (row[n + 1] - row[n]);
}

static void deviation_face_fill_grid(maker *m) {
    wcut_face *f = m->face;
    for (int s = 0; s < f->stations; s++) {
        const bool there = trim_row(f, s);
        for (int n = 0; n < f->nodes; n++) {
            const size_t i = (size_t)s * f->nodes + n;
            const double u = f->begin[s] + n / (f->nodes - 1.0) * (f->end[s] - f->begin[s]), v = f->parameter[s];
            f->point[i] = deviation_face_at(f, u, v), f->v[i] = v;
            f->inside[i] = there && f->point[i].z >= f->low.z && f->point[i].z <= f->high.z;
            f->force[i] = deviation_face_along(m->history, m->history->force_line, s, u);
            f->half_kerf[i] = deviation_face_along(m->history, m->half, s, u);
            if (wcut_surface_curvature(f->surface, u, v, &f->curvature[i], NULL) != WCUT_OK) f->curvature[i] = 0;
        }
    }
    for (int n = 0; n < f->nodes; n++) trim_column(f, n);
}

/* ---- the stations ---- */

/* the station a share of the path's length away, as far as there is one */
static int station_away(int count, const wcut_vec3 *p, int from, int step, double length) {
    int s = from;
    for (double way = 0; way < length && s + step >= 0 && s + step < count; s += step)
        way += vec3_distance(p[s], p[s + step]);
    return s;
}

/* curvature of the circle through three points (Menger) */
static double deviation_face_bend_of(wcut_vec3 a, wcut_vec3 b, wcut_vec3 c) {
    const double ab = vec3_distance(a, b), bc = vec3_distance(b, c), ca = vec3_distance(c, a);
    const double area = vec3_length(vec3_cross(vec3_sub(b, a), vec3_sub(c, a)));
    return ab > 0 && bc > 0 && ca > 0 ? 2 * area / (ab * bc * ca) : 0;
}

static void add_bend(wcut_face *f, const wcut_vec3 *p) {
    double length = 0;
    for (int s = 1; s < f->stations; s++) length += vec3_distance(p[s - 1], p[s]);
    for (int s = 0; s < f->stations; s++) {
        const int before = station_away(f->stations, p, s, -1, PATH_SHARE * length);
        const int after = station_away(f->stations, p, s, 1, PATH_SHARE * length);
        f->path_bend[s] += deviation_face_bend_of(p[before], p[s], p[after]) / 2;
    }
}

static void deviation_face_fill_stations(maker *m) {
    const wcut_history *h = m->history;
    double entry = h->row[0].time;
    for (int s = h->stations - 1; s >= 0; s--)
        if (h->row[s].phase != WCUT_PHASE_APPROACH) entry = h->row[s].time;
    for (int s = 0; s < h->stations; s++) {
        m->face->time[s] = h->row[s].time - entry;
        m->face->phase[s] = h->row[s].phase;
    }
}

/* ---- making ---- */

static bool deviation_face_make_room(maker *m) {
    wcut_face *f = m->face;
    const size_t rows = (size_t)f->stations, count = rows * (size_t)f->nodes;
    double **const of_rows[] = {&f->parameter, &f->begin, &f->end, &f->time, &f->path_bend};
    double **const of_all[] = {&f->v, &f->force, &f->curvature, &f->half_kerf, &m->q_eff, &m->half};
    bool there = true;
    for (size_t k = 0; k < sizeof of_rows / sizeof *of_rows; k++)
        there = (*of_rows[k] = wcut_alloc(rows, sizeof **of_rows[k])) && there;
    for (size_t k = 0; k < sizeof of_all / sizeof *of_all; k++)
        there = (*of_all[k] = wcut_alloc(count, sizeof **of_all[k])) && there;
    f->point = wcut_alloc(count, sizeof *f->point);
    f->inside = wcut_alloc(count, 1);
    f->phase = wcut_alloc(rows, sizeof *f->phase);
    m->node = wcut_alloc(count, sizeof *m->node);
    m->normal = wcut_alloc(count, sizeof *m->normal);
    return there && f->point && f->inside && f->phase && m->node && m->normal;
}

void wcut_face_destroy(wcut_face *face) {
    if (!face) return;
    double *const array[] = {face->parameter, face->begin, face->end,       face->time,     face->path_bend,
                             face->v,         face->force, face->curvature, face->half_kerf};
    for (size_t k = 0; k < sizeof array / sizeof *array; k++) wcut_free(array[k]);
    wcut_free(face->point);
    wcut_free(face->inside);
    wcut_free(face->phase);
    wcut_surface_destroy(face->surface);
    wcut_free(face);
}

static bool deviation_face_is_usable(const wcut_job *job, const wcut_history *h) {
    return job && h && h->stations >= 2 && h->nodes >= 2 && h->row && h->position && h->force_line && h->speed &&
           is_positive(job->heat) && is_positive(job->speed_min) && is_positive(job->block_size.x) &&
           is_positive(job->block_size.y) && is_positive(job->block_size.z) && isfinite(job->kerf_width) &&
           isfinite(job->kerf_per_q);
}

wcut_status wcut_face_create(const wcut_job *job, const wcut_history *history, const wcut_vec3 *mount_a,
                             const wcut_vec3 *mount_b, double merge, wcut_face **face) {
    if (!face || !deviation_face_is_usable(job, history) || !mount_a != !mount_b || !(merge >= 0))
        return WCUT_BAD_ARGUMENT;

    /* room for the face and what it is made from */
    maker m = {.job = job, .history = history, .merge = merge, .face = wcut_alloc(1, sizeof *m.face)};
    if (!m.face) return WCUT_NO_MEMORY;
    m.face->stations = history->stations, m.face->nodes = history->nodes, m.face->high = job->block_size;
    wcut_status status = deviation_face_make_room(&m) ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = deviation_face_lower(&m);

    /* grid, stations and bends; a face of fewer than four nodes inside the block cannot be compared */
    if (status == WCUT_OK) {
        deviation_face_fill_grid(&m);
        deviation_face_fill_stations(&m);
        if (mount_a) add_bend(m.face, mount_a), add_bend(m.face, mount_b);
        size_t inside = 0;
        for (size_t i = 0; i < (size_t)m.face->stations * m.face->nodes; i++) inside += m.face->inside[i];
        if (inside < 4) status = WCUT_DEGENERATE;
    }

    /* release the scratch, and hand the face over */
    void *const scratch[] = {m.q_eff, m.half, m.node, m.normal};
    for (size_t k = 0; k < sizeof scratch / sizeof *scratch; k++) wcut_free(scratch[k]);
    if (status == WCUT_OK)
        *face = m.face;
    else
        wcut_face_destroy(m.face);

    return status;
}
