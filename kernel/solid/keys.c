/* Where keys are, how many corners their circles get, and how far the cut stays from them. */
#include "solid/keys.h"

#include <math.h>
#include <stdbool.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* corners of a circle: a multiple of four, so that the exact circle's pieces meet at corners */
enum { ARCS_MIN = 16, ARCS_MAX = 1024 };

/* A key that is nearer to the cut than this share of the block touches it. */
static const double TOUCHING = 1e-9;

static const double TAN_FLANK = 0.36397023426620234; /* tan 20 deg */

wcut_status wcut_keys_at_corners(wcut_vec3 block_size, double radius, double height, wcut_key *key) {
    if (!is_positive(block_size.x) || !is_positive(block_size.y) || !is_positive(block_size.z) ||
        !is_positive(radius) || !isfinite(height) || height == 0 || !key || !(fabs(height) * TAN_FLANK < radius))
        return WCUT_BAD_ARGUMENT;
    const double in = 1.5 * radius, x[3] = {in, block_size.x - in, in}, y[3] = {in, in, block_size.y - in};
    for (int k = 0; k < WCUT_KEYS_AT_CORNERS; k++)
        key[k] = (wcut_key){.upper = k / 3,
                            .x = x[k % 3],
                            .y = y[k % 3],
                            .radius = radius,
                            .tip_radius = radius - fabs(height) * TAN_FLANK,
                            .height = height};
    return WCUT_OK;
}

double wcut_key_rise(const wcut_key *key) { return key->upper ? key->height : -key->height; }

int wcut_key_arcs(const wcut_key *key, double chord_tolerance) {
    const double share = fmin(chord_tolerance / key->radius, 0.5), arcs = WCUT_PI / acos(1 - share);
    return arcs < ARCS_MIN ? ARCS_MIN : arcs > ARCS_MAX ? ARCS_MAX : 4 * (int)ceil(arcs / 4);
}

wcut_status wcut_keys_of(const wcut_mould_options *options, int upper, wcut_key **own, int *count) {
    wcut_key *k = wcut_alloc((size_t)options->key_count, sizeof *k);
    if (!k) return WCUT_NO_MEMORY;
    int made = 0;
    for (int i = 0; i < options->key_count; i++)
        if (!options->key[i].upper == !upper) k[made++] = options->key[i];
    *own = k;
    *count = made;
    return WCUT_OK;
}

/* a frustum between similar polygons */
double wcut_key_volume(const wcut_key *key, double chord_tolerance) {
    const int arcs = wcut_key_arcs(key, chord_tolerance);
    const double share = arcs / 2.0 * sin(2 * WCUT_PI / arcs), r = key->radius, q = key->tip_radius;
    return share * key->height / 3 * (r * r + r * q + q * q);
}

double wcut_keys_volume(const wcut_mould_options *o, int upper) {
    double sum = 0;
    for (int k = 0; k < o->key_count; k++)
        if (!o->key[k].upper == !upper) sum += wcut_key_volume(&o->key[k], o->chord_tolerance);
    return sum;
}

/* The least and the greatest z of a triangle over a circle, or beyond them: of its corners, and of its plane there.
   False where the triangle's box is beside the circle. */
static bool heights_over(const wcut_cap *l, int t, const wcut_key *key, double *low, double *high) {
    const int *c = l->triangle + 3 * (ptrdiff_t)t;
    const wcut_vec3 a = l->vertex[c[0]], b = l->vertex[c[1]], d = l->vertex[c[2]];
    const double x = clamp(key->x, fmin(a.x, fmin(b.x, d.x)), fmax(a.x, fmax(b.x, d.x)));
    const double y = clamp(key->y, fmin(a.y, fmin(b.y, d.y)), fmax(a.y, fmax(b.y, d.y)));
    if (hypot(key->x - x, key->y - y) > key->radius) return false;
    *low = fmin(a.z, fmin(b.z, d.z)), *high = fmax(a.z, fmax(b.z, d.z));
    const wcut_vec3 n = vec3_cross(vec3_sub(b, a), vec3_sub(d, a));
    if (fabs(n.z) > 0) {
        const double at = a.z - (n.x * (key->x - a.x) + n.y * (key->y - a.y)) / n.z;
        const double rise = key->radius * hypot(n.x, n.y) / fabs(n.z);
        *low = fmax(*low, at - rise), *high = fmin(*high, at + rise);
    }
    return true;
}

wcut_status wcut_keys_check(const wcut_division *d, int upper, const wcut_cut_face *face, wcut_error *error) {
    for (int k = 0; k < d->options->key_count; k++) {
        const wcut_key *key = &d->options->key[k];
        if (!key->upper != !upper) continue;
        const double level = upper ? d->block.z : 0, rise = wcut_key_rise(key);
        const double reach = upper ? fmin(level, level + rise) : fmax(level, level + rise);
        for (int t = 0; t < face->cap.triangle_count; t++) {
            double low, high;
            if (!heights_over(&face->cap, t, key, &low, &high)) continue;
            const double left = upper ? reach - high : low - reach;
            if (!(left > TOUCHING * d->block.z))
                return wcut_fail(error, WCUT_BAD_ARGUMENT,
                                 "the key at x = %.6g, y = %.6g mm reaches the cut face, at z = %.6g mm", key->x,
                                 key->y, upper ? high : low);
        }
    }
    return WCUT_OK;
}
