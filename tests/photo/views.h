/* A camera by its closed form, and pictures of a flat cut face. */
#ifndef WCUT_TESTS_PHOTO_VIEWS_H
#define WCUT_TESTS_PHOTO_VIEWS_H

#include <math.h>
#include <stdlib.h>
#include <wirecut/wirecut.h>

#include "test.h"

/* a camera that looks from `eye` at `target`, turned about its axis: rows of R are right, down, forward */
static inline wcut_camera camera_at(wcut_vec3 eye, wcut_vec3 target, double focal, int width, int height, double k1,
                                    double k2) {
    wcut_camera c = {.kind = WCUT_CAMERA_KIND_FULL,
                     .width = width,
                     .height = height,
                     .centre = eye,
                     .focal = focal,
                     .k1 = k1,
                     .k2 = k2};
    const double f[3] = {target.x - eye.x, target.y - eye.y, target.z - eye.z},
                 l = sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
    const double a[3] = {f[0] / l, f[1] / l, f[2] / l}, across = hypot(a[0], a[1]);
    const double right[3] = {a[1] / across, -a[0] / across, 0};
    const double down[3] = {a[1] * right[2] - a[2] * right[1], a[2] * right[0] - a[0] * right[2],
                            a[0] * right[1] - a[1] * right[0]};
    for (int k = 0; k < 3; k++) c.rotation[k] = right[k], c.rotation[3 + k] = down[k], c.rotation[6 + k] = a[k];
    return c;
}

/* (u, v) = middle + focal m (1 + k1 r^2 + k2 r^4), written out once more */
static inline wcut_photo_point seen_by(const wcut_camera *c, wcut_vec3 place) {
    const double d[3] = {place.x - c->centre.x, place.y - c->centre.y, place.z - c->centre.z};
    double q[3] = {0};
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) q[i] += c->rotation[3 * i + k] * d[k];
    const double x = q[0] / q[2], y = q[1] / q[2], r2 = x * x + y * y, s = 1 + c->k1 * r2 + c->k2 * r2 * r2;
    return (wcut_photo_point){(c->width - 1) / 2.0 + c->focal * x * s, (c->height - 1) / 2.0 + c->focal * y * s, place};
}

enum { FLAT_STATIONS = 81, FLAT_NODES = 41 };
#define FLAT_BLOCK ((wcut_vec3){200, 160, 100})
#define FLAT_HEIGHT 40.0
#define FLAT_BOW 4e-4 /* [1/mm] wires are y = way + FLAT_BOW (x - 100)^2 */

/* a cut whose face is flat and whose wires are parabolas */
static inline wcut_history *flat_history(void) {
    wcut_history *h = calloc(1, sizeof *h);
    const size_t n = (size_t)FLAT_STATIONS * FLAT_NODES;
    *h = (wcut_history){.stations = FLAT_STATIONS, .planned = FLAT_STATIONS, .nodes = FLAT_NODES};
    h->row = calloc(FLAT_STATIONS, sizeof *h->row);
    h->position = calloc(n, sizeof *h->position);
    h->force = calloc(n, sizeof *h->force);
    h->force_line = calloc(n, sizeof *h->force_line);
    h->speed = calloc(n, sizeof *h->speed);
    h->tension = calloc(n, sizeof *h->tension);
    for (int s = 0; s < FLAT_STATIONS; s++) {
        h->row[s].phase = s < 10 ? WCUT_PHASE_ENTRY : s < 70 ? WCUT_PHASE_STEADY : WCUT_PHASE_EXIT;
        h->row[s].engaged_length = 200;
        for (int k = 0; k < FLAT_NODES; k++) {
            const double x = -20 + 240.0 * k / (FLAT_NODES - 1);
            h->position[s * FLAT_NODES + k] =
                (wcut_vec3){x, -20 + 2.4 * s + FLAT_BOW * (x - 100) * (x - 100), FLAT_HEIGHT};
            h->force_line[s * FLAT_NODES + k] = 0.01;
        }
    }
    return h;
}

/* a photograph of that face with rills that are y = way + bow (x - 100)^2; amplitude 0: slowly changing light alone.
   A pixel's ray meets the plane where the distortion is undone by iteration. */
static inline wcut_picture *flat_photo(const wcut_camera *c, double bow, double amplitude) {
    wcut_picture *p = NULL;
    ck_assert_int_eq(wcut_picture_create(c->width, c->height, 1, &p), WCUT_OK);
    for (int v = 0; v < c->height; v++)
        for (int u = 0; u < c->width; u++) {
            const double a = (u - (c->width - 1) / 2.0) / c->focal, b = (v - (c->height - 1) / 2.0) / c->focal;
            double x = a, y = b, d[3] = {0};
            for (int k = 0; k < 10; k++) {
                const double r2 = x * x + y * y, s = 1 + c->k1 * r2 + c->k2 * r2 * r2;
                x = a / s, y = b / s;
            }
            for (int k = 0; k < 3; k++) d[k] = c->rotation[k] * x + c->rotation[3 + k] * y + c->rotation[6 + k];
            const double t = (FLAT_HEIGHT - c->centre.z) / d[2], px = c->centre.x + t * d[0],
                         py = c->centre.y + t * d[1];
            const bool in = px >= 0 && px <= 200 && py >= 0 && py <= 160;
            const double way = py - bow * (px - 100) * (px - 100);

            /* three waves, no two of one period; the light changes slowly */
            const double rills = sin(6.2831853 * way / 3.1) + 0.7 * sin(6.2831853 * way / 2.3 + 1) +
                                 0.5 * sin(6.2831853 * way / 4.7 + 2);
            const double light = 110 + 0.2 * px + 20 * sin(py / 70);
            p->pixel[(size_t)v * c->width + u] = (unsigned char)(in ? light + amplitude * rills + 0.5 : 10);
        }
    return p;
}

#endif
