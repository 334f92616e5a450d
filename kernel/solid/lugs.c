/* Where locating lugs are and how large: level boxes on two sides of the block, clear of the border of the cut. */
#include "solid/lugs.h"

#include <math.h>
#include <stddef.h>

#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "solid/cap_flat.h"
#include "solid/keys.h"

static const double TAN_FLANK = 0.36397023426620234; /* tan 20 deg */

/* shares of the cone's radius: width of a lug, its distance from the cut's border and from the block's edges, the least
   radius of a cone's end */
static const double WIDTH = 3, CLEAR = 0.2, TIP_MIN = 0.5;

/* a cone longer than this share of its radius is a pin that breaks */
static const double SLENDER = 6;

/* places that are tried in a window of a side */
enum { PLACES = 64 };

/* the windows, as shares of the block's length: a half fits in one way only */
static const double window[WCUT_LUGS][2] = {{0.02, 0.4}, {0.6, 0.98}, {0.3, 0.7}};
static const int side_of[WCUT_LUGS] = {0, 0, 1};

/* least and greatest z of a cap's border between two places of y */
static void border_range(const wcut_cap *cap, int side, double y0, double y1, double *low, double *high) {
    *low = INFINITY, *high = -INFINITY;
    const int *border = cap->border[side];
    for (int k = 1; k < cap->border_count[side]; k++) {
        const wcut_vec3 p = cap->vertex[border[k - 1]], q = cap->vertex[border[k]];
        const double first = fmax(fmin(p.y, q.y), y0), last = fmin(fmax(p.y, q.y), y1);
        if (!(first <= last)) continue;
        for (int end = 0; end < 2; end++) {
            const double y = end ? last : first, t = q.y != p.y ? clamp((y - p.y) / (q.y - p.y), 0, 1) : end;
            *low = fmin(*low, p.z + t * (q.z - p.z)), *high = fmax(*high, p.z + t * (q.z - p.z));
        }
    }
}

/* the place of a window where the faces are nearest to each other over a lug's width */
static double choose_place(const wcut_division *d, const wcut_cap *lower, const wcut_cap *upper, int k, double wide,
                           double *under, double *over) {
    const double first = window[k][0] * d->block.y, last = fmax(window[k][1] * d->block.y - wide, first);
    double best = first, least = INFINITY;
    for (int i = 0; i <= PLACES; i++) {
        const double y = first + (last - first) * i / PLACES;
        double low, high, unused;
        border_range(lower, side_of[k], y, y + wide, &low, &unused);
        border_range(upper, side_of[k], y, y + wide, &unused, &high);
        if (high - low < least) least = high - low, best = y, *under = low, *over = high;
    }
    return best;
}

static void set_lug_corners(const wcut_division *d, int side, double y, double wide, wcut_vec3 corner[4]) {
    const double x = side ? d->block.x : 0, out = side ? x + wide : x - wide;
    const double first = side ? y + wide : y, second = side ? y : y + wide;
    corner[0] = vec3(x, first, 0), corner[1] = vec3(x, second, 0);
    corner[2] = vec3(out, second, 0), corner[3] = vec3(out, first, 0);
}

wcut_status wcut_lugs_place(const wcut_division *d, const wcut_cap *lower, const wcut_cap *upper,
                            wcut_lug lug[2][WCUT_LUGS], wcut_error *error) {
    const wcut_mould_options *o = d->options;
    const double r = o->lug_radius, wide = WIDTH * r, clear = CLEAR * r, thick = o->lug_height + r;
    wcut_lug made[2][WCUT_LUGS];
    for (int k = 0; k < WCUT_LUGS; k++) {
        /* the lower half's lug ends below the border, the upper half's begins above it */
        double under = 0, over = 0;
        const double y = choose_place(d, lower, upper, k, wide, &under, &over);
        const double low = under - clear, high = over + clear, rise = high - low + o->lug_height;
        const double x = side_of[k] ? d->block.x : 0;
        if (y + wide > d->block.y - clear || low - thick < clear || high + thick > d->block.z - clear)
            return wcut_fail(
                error, WCUT_BAD_ARGUMENT,
                "lugs: no room at x = %.6g, y = %.6g to %.6g mm, where the cut's border lies at z = %.6g to "
                "%.6g mm; expected %.6g mm below it and above it, and as much of the side",
                x, y, y + wide, under, over, thick + 2 * clear);
        if (rise > SLENDER * r)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "lugs: at x = %.6g, y = %.6g to %.6g mm the cones would be %.6g mm long, more than %g of "
                             "their radius; expected a larger radius",
                             x, y, y + wide, rise, SLENDER);

        /* one cone from the lower lug into the upper: flanks of 20 deg, steeper where it is long */
        const double slope = fmin(TAN_FLANK, (1 - TIP_MIN) * r / rise);
        wcut_lug *a = &made[0][k], *b = &made[1][k];
        *a = (wcut_lug){.side = side_of[k], .level = low, .far = low - thick};
        set_lug_corners(d, side_of[k], y, wide, a->corner);
        a->key = (wcut_key){.upper = 1,
                            .x = x + (side_of[k] ? wide : -wide) / 2,
                            .y = y + wide / 2,
                            .radius = r,
                            .tip_radius = r - rise * slope,
                            .height = rise};
        *b = *a;
        b->level = high, b->far = high + thick;
        b->key.radius = r - (high - low) * slope + o->lug_clearance;
        b->key.tip_radius = a->key.tip_radius + o->lug_clearance;
        b->key.height = o->lug_height;
    }
    for (int upper_half = 0; upper_half < 2; upper_half++)
        for (int k = 0; k < WCUT_LUGS; k++) lug[upper_half][k] = made[upper_half][k];
    return WCUT_OK;
}

/* a box with a cone on it, or less a pocket */
double wcut_lug_volume(const wcut_lug *lug, int upper, double chord_tolerance) {
    const wcut_vec3 *c = lug->corner;
    const double box = fabs(c[2].x - c[1].x) * fabs(c[1].y - c[0].y) * fabs(lug->level - lug->far);
    const double cone = wcut_key_volume(&lug->key, chord_tolerance);
    return upper ? box - cone : box + cone;
}

wcut_status wcut_lug_caps(const wcut_lug *lug, int upper, double chord_tolerance, wcut_cap *floor, wcut_cap *ceiling) {
    const wcut_vec3 *c = lug->corner;
    const wcut_sides sides = {{fmin(c[0].x, c[2].x), fmax(c[0].x, c[2].x)},
                              {fmin(c[0].y, c[1].y), fmax(c[0].y, c[1].y)}};
    wcut_cap keyed, plain;
    wcut_status status = wcut_cap_flat(sides, lug->level, 1, &lug->key, chord_tolerance, &keyed);
    if (status != WCUT_OK) return status;
    status = wcut_cap_flat(sides, lug->far, 0, NULL, chord_tolerance, &plain);
    if (status != WCUT_OK) {
        wcut_cap_clear(&keyed);
        return status;
    }
    *floor = upper ? keyed : plain, *ceiling = upper ? plain : keyed;
    return WCUT_OK;
}
