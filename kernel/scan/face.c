/* Where the cut face is scanned when it is not where the plain model has it: kerf, springback, a misplaced scan. */
#include <stddef.h>
#include <wirecut/effects.h>

#include "base/numbers.h"
#include "base/vec3.h"

#define Q_REF 1000.0 /* [J/m^2] at which the logarithmic kerf law adds nothing */

/* [mm] more kerf than the plain model has: k1 Q, or k2 ln(Q / 1000 J/m^2) */
static double more_kerf(const wcut_effect *e, double q_eff) {
    return e->choice == 0 ? e->value[WCUT_KERF_GROWTH_PER_Q] * q_eff
                          : e->value[WCUT_KERF_GROWTH_PER_LOG] * log(q_eff / Q_REF);
}

/* Heights [1] of the block's shapes over u, v in -1 .. 1 along x and y; none of them lifts the middle of its own. */
static double shape_of(int shape, double u, double v) {
    switch (shape) {
        case 0:
            return u * u - v * v; /* saddle */
        case 1:
            return u * u; /* bent about y: curved along x */
        case 2:
            return v * v; /* curved along y */
        case 3:
            return u * u + v * v; /* bowl */
        case 4:
            return u * v; /* twist */
        case 5:
            return u * u * u; /* an S along x */
        default:
            return v * v * v; /* an S along y */
    }
}

static void move_face(const wcut_effect *e, wcut_vec3 block, const wcut_vec3 *normal, const double *q_eff, int i,
                      wcut_vec3 *p) {
    if (e->kind == WCUT_EFFECT_KERF_GROWTH) *p = vec3_add_scaled(*p, -more_kerf(e, q_eff[i]) / 2, normal[i]);
    if (e->kind == WCUT_EFFECT_BLOCK_SPRINGBACK)
        p->z += e->value[WCUT_BLOCK_SPRINGBACK_AMPLITUDE] *
                shape_of(e->choice, 2 * p->x / block.x - 1, 2 * p->y / block.y - 1);
}

static void misplace_scan(const wcut_effect *e, wcut_vec3 block, wcut_vec3 *p) {
    if (e->kind == WCUT_EFFECT_SCAN_SCALE) *p = vec3_mix(vec3_scale(0.5, block), *p, e->value[WCUT_SCAN_SCALE_SCALE]);
    const double *shift = &e->value[WCUT_SCAN_OFFSET_SHIFT];
    if (e->kind == WCUT_EFFECT_SCAN_OFFSET) *p = vec3_add(*p, vec3(shift[0], shift[1], shift[2]));
}

wcut_status wcut_face_eval(int count, const wcut_effect *effect, wcut_vec3 block, int points, const wcut_vec3 *normal,
                           const double *q_eff, wcut_vec3 *point) {
    if (points < 0 || (points > 0 && !point) || !is_positive(block.x) || !is_positive(block.y) ||
        !is_positive(block.z) || wcut_effects_check(count, effect, NULL) != WCUT_OK)
        return WCUT_BAD_ARGUMENT;
    for (int e = 0; e < count; e++)
        if (effect[e].kind == WCUT_EFFECT_KERF_GROWTH && !wcut_effect_is_neutral(&effect[e]) && points > 0 &&
            (!normal || !q_eff || !vec3_all_finite(points, normal) || !all_positive(points, q_eff)))
            return WCUT_BAD_ARGUMENT;
    for (int e = 0; e < count; e++)
        for (int i = 0; i < points && !wcut_effect_is_neutral(&effect[e]); i++)
            move_face(&effect[e], block, normal, q_eff, i, &point[i]);
    for (int e = 0; e < count; e++)
        for (int i = 0; i < points && !wcut_effect_is_neutral(&effect[e]); i++)
            misplace_scan(&effect[e], block, &point[i]);
    return WCUT_OK;
}
