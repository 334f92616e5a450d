/* A scan as means over patches of the face that the recorded run left. */
#include <string.h>
#include <wirecut/projection.h>
#include <wirecut/surface.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "base/vec3.h"
#include "explain/evidence.h"

enum { ALONG = 24, ACROSS = 10, POINTS = 12000, MIN = 8 };

/* what a patch of any number of points is not told better than [mm]: the encoder's noise moves whole rows */
#define FLOOR 0.03
/* points further from the face than this are not of it [mm] */
#define REACH 8.0
/* the loft takes sections at least so many seconds and stations apart: closer ones carry the encoder's noise */
#define SECTION 0.3

void wcut_patches_destroy(wcut_patches *p) {
    wcut_free(p->station);
    wcut_free(p->across);
    wcut_free(p->point);
    wcut_free(p->normal);
    wcut_free(p->distance);
    wcut_free(p->sigma);
    wcut_free(p->q_eff);
    *p = (wcut_patches){0};
}

typedef struct sums {
    int count;
    double station, across, distance, square;
    wcut_vec3 point, normal;
} sums;

/* the face as a surface: sections of the recorded run; station: of each section that the surface passes through */
typedef struct face {
    wcut_surface *surface;
    wcut_projection *projection;
    int sections;
    double *parameter, *station;
} face;

static void face_destroy(face *f) {
    wcut_projection_destroy(f->projection);
    wcut_surface_destroy(f->surface);
    wcut_free(f->parameter);
    wcut_free(f->station);
}

static wcut_status face_create(const wcut_evidence_cut *c, const wcut_response *d, face *f) {
    const wcut_trajectory *t = &c->recorded;
    const size_t n = (size_t)d->nodes;

    /* the positions of the wire as sections of a surface */
    wcut_vec3 *position = wcut_alloc((size_t)d->count * n, sizeof *position);
    f->parameter = wcut_alloc((size_t)d->count, sizeof(double));
    f->station = wcut_alloc((size_t)d->count, sizeof(double));
    wcut_status status = position && f->parameter && f->station ? WCUT_OK : WCUT_NO_MEMORY;
    double last = -HUGE_VAL;

    /* a section every SECTION seconds and stations, of the samples that the run reached */
    for (int i = 0; status == WCUT_OK && i < d->count; i++) {
        if (!d->present[i] || t->time[i] < last + SECTION) continue;
        if (f->sections > 0 && t->station[i] - f->station[f->sections - 1] < SECTION) continue;
        memcpy(position + (size_t)f->sections * n, d->position + (size_t)i * n, n * sizeof *position);
        f->station[f->sections++] = t->station[i];
        last = t->time[i];
    }

    /* loft through the sections, and prepare its closest points */
    if (status == WCUT_OK && f->sections < 4) status = WCUT_DEGENERATE;
    if (status == WCUT_OK)
        status = wcut_surface_loft(f->sections, d->nodes, position, 1e-6, &f->surface, f->parameter, NULL);
    if (status == WCUT_OK) status = wcut_projection_create(f->surface, &f->projection);

    wcut_free(position);
    return status;
}

/* add a point to its patch, if it is one of the face between the stations that count */
static void add_point(const wcut_evidence_cut *c, const face *f, double first, double last, wcut_vec3 point,
                      const wcut_foot *foot, sums *patch) {
    const double width = c->job->block_size.x;

    /* no point beyond the face, far from it, or at the edge of the block */
    if (foot->beyond || foot->distance > REACH || point.x < 5 || point.x > width - 5) return;

    /* only the stations of the bins count, because the others have no prediction */
    const double station = wcut_between(f->sections, f->parameter, f->station, foot->v);
    if (!(station > first && station < last)) return;

    /* the normal, turned upwards */
    wcut_vec3 ders[4];
    wcut_surface_eval(f->surface, foot->u, foot->v, 1, ders);
    wcut_vec3 normal = vec3_unit(vec3_cross(ders[2], ders[1]));
    const double sign = normal.z < 0 ? -1 : 1;
    normal = vec3_scale(sign, normal);
    if (normal.z < 0.2) return; /* a steep face: what is above and what beside is not told */

    /* height over the face, and the patch it belongs to */
    const double distance = sign * foot->height;
    const int row = (int)clamp((station - first) / (last - first) * ALONG, 0, ALONG - 1);
    const int column = (int)clamp(point.x / width * ACROSS, 0, ACROSS - 1);
    sums *s = &patch[row * ACROSS + column];

    /* sums for mean, standard deviation and place */
    s->count++;
    s->station += station, s->across += foot->u, s->distance += distance, s->square += distance * distance;
    s->point = vec3_add(s->point, foot->point), s->normal = vec3_add(s->normal, normal);
}

static void keep_cut_patches(const sums *patch, wcut_patches *p) {
    double deviation[ALONG * ACROSS];
    for (int k = 0; k < ALONG * ACROSS; k++) {
        const sums *s = &patch[k];
        if (s->count < MIN) continue;
        const int i = p->count++;
        const double n = s->count, mean = s->distance / n;
        p->station[i] = s->station / n, p->across[i] = s->across / n;
        p->point[i] = vec3_scale(1 / n, s->point), p->normal[i] = vec3_unit(s->normal);
        p->distance[i] = mean;
        p->sigma[i] = n; /* the count, until the spread is known */
        deviation[i] = sqrt(fmax(s->square / n - mean * mean, 0));
    }
    if (p->count == 0) return;
    wcut_sort(p->count, deviation);
    p->spread = deviation[p->count / 2];
    for (int i = 0; i < p->count; i++) p->sigma[i] = sqrt(p->spread * p->spread / p->sigma[i] + FLOOR * FLOOR);
}

/* q_eff at each patch: heat over the speed of the wire's nodes, [J/m^2] */
static void find_heat(const wcut_evidence_cut *c, wcut_patches *p) {
    const wcut_trajectory *t = &c->exogenous;
    for (int i = 0; i < p->count; i++) {
        const double heat = wcut_between(t->count, t->station, t->heat, p->station[i]);
        const double speed = wcut_response_speed(t, &c->reference, p->station[i], p->across[i]);
        p->q_eff[i] = 1000 * heat / fmax(speed, 0.5);
    }
}

wcut_status wcut_patches_create(const wcut_evidence_cut *c, const wcut_response *recorded, wcut_patches *out,
                                wcut_error *error) {
    /* a bounded number of points is enough: every stride-th one */
    const int count = c->scan->count, stride = count > POINTS ? count / POINTS + 1 : 1, n = (count - 1) / stride + 1;
    const size_t room = (size_t)ALONG * ACROSS;

    /* the points, their feet, and the sums of the patches */
    face f = {0};
    wcut_vec3 *point = wcut_alloc((size_t)n, sizeof *point);
    wcut_foot *foot = wcut_alloc((size_t)n, sizeof *foot);
    sums *patch = wcut_alloc(room, sizeof *patch);
    wcut_patches p = {.station = wcut_alloc(room, sizeof(double)),
                      .across = wcut_alloc(room, sizeof(double)),
                      .point = wcut_alloc(room, sizeof *p.point),
                      .normal = wcut_alloc(room, sizeof *p.normal),
                      .distance = wcut_alloc(room, sizeof(double)),
                      .sigma = wcut_alloc(room, sizeof(double)),
                      .q_eff = wcut_alloc(room, sizeof(double))};
    wcut_status status =
        point && foot && patch && p.station && p.across && p.point && p.normal && p.distance && p.sigma && p.q_eff
            ? WCUT_OK
            : WCUT_NO_MEMORY;

    /* the face of the recorded run, and the foot of each point on it */
    for (int i = 0; status == WCUT_OK && i < n; i++) point[i] = c->scan->point[(size_t)i * (size_t)stride];
    if (status == WCUT_OK) status = face_create(c, recorded, &f);
    if (status == WCUT_OK) status = wcut_projection_locate(f.projection, n, point, 1, foot);
    if (status == WCUT_OK) {
        /* stations at the ends of the bins */
        const double first = wcut_between(c->exogenous.count, c->exogenous.time, c->exogenous.station, c->from);
        const double last = wcut_between(c->exogenous.count, c->exogenous.time, c->exogenous.station,
                                         c->from + c->bins * WCUT_BIN_WIDTH);

        /* sums over the points, then means and errors of the patches that hold enough */
        for (int i = 0; i < n; i++) add_point(c, &f, first, last, point[i], &foot[i], patch);
        keep_cut_patches(patch, &p);
        find_heat(c, &p);
        *out = p;
    } else {
        wcut_patches_destroy(&p);
        wcut_fail(error, status, "the scan: %s", wcut_status_text(status));
    }

    face_destroy(&f);
    wcut_free(point);
    wcut_free(foot);
    wcut_free(patch);
    return status;
}
