/* Directions to a shape: the difference of the slopes of rill and wire, integrated along the wire. */
#include "photo/rill_curve.h"

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

enum { GAP_MAX = 2, STRETCH_MIN = 3 };

static const double GAP_SIGMA = 3; /* a patch between readable ones is known so many times worse */
static const double STEEP = 0.2;   /* cosine: a wire nearer to the y direction has no slope over x */
static const double DIFFERS = 4;   /* standard deviations */

/* a node's slope against the simulated wire */
typedef struct rill_slope {
    bool known;
    double value, sigma, systematic; /* [1] dy/dx */
} rill_slope;

/* the wire at x, and its direction there; false: it does not get there inside the block */
static bool wire_at(const wcut_history *h, int station, double x, wcut_vec3 block, wcut_vec3 *place,
                    double *direction) {
    const wcut_vec3 *row = h->position + (size_t)station * h->nodes;
    for (int n = 0; n + 1 < h->nodes; n++) {
        const double a = row[n].x, b = row[n + 1].x;
        if (!((a <= x && x < b) || (b < x && x <= a))) continue;
        *place = vec3_mix(row[n], row[n + 1], (x - a) / (b - a));
        if (place->y < 0 || place->y > block.y || place->z < 0 || place->z > block.z) return false;

        /* the chord to either side: the direction in the middle of three edges */
        const wcut_vec3 from = row[n > 0 ? n - 1 : 0], to = row[n + 2 < h->nodes ? n + 2 : n + 1];
        *direction = atan((to.y - from.y) / (to.x - from.x));
        return true;
    }
    return false;
}

static rill_slope slope_of(const wcut_patch_grid *g, wcut_vec3 place, double direction) {
    const int column = (int)floor((place.x - g->x0) / g->side), row = (int)floor((place.y - g->y0) / g->side);
    if (column < 0 || row < 0 || column >= g->columns || row >= g->rows) return (rill_slope){0};
    const wcut_rill_patch *p = &g->patch[(size_t)row * g->columns + column];
    const double c = cos(direction), turned = cos(direction + p->angle);
    if (!p->readable || c < STEEP || turned < STEEP) return (rill_slope){0};
    return (rill_slope){true, tan(direction + p->angle) - tan(direction), p->sigma / (turned * turned),
                        p->systematic / (turned * turned)};
}

/* single patches between readable ones take their slope from both sides */
static void bridge_gaps(int count, rill_slope *slope) {
    for (int i = 0; i < count; i++) {
        if (!slope[i].known || i + 1 >= count || slope[i + 1].known) continue;
        int next = i + 1;
        while (next < count && !slope[next].known) next++;
        if (next >= count || next - i - 1 > GAP_MAX) continue;
        for (int k = i + 1; k < next; k++) {
            const double t = (double)(k - i) / (next - i);
            slope[k].known = true;
            slope[k].value = (1 - t) * slope[i].value + t * slope[next].value;
            slope[k].sigma = GAP_SIGMA * fmax(slope[i].sigma, slope[next].sigma);
            slope[k].systematic = fmax(slope[i].systematic, slope[next].systematic);
        }
    }
}

/* the longest stretch of known slopes */
static int longest_stretch(int count, const rill_slope *slope, int *first) {
    int best = 0;
    for (int i = 0, run = 0; i < count; i++) {
        run = slope[i].known ? run + 1 : 0;
        if (run > best) best = run, *first = i - run + 1;
    }
    return best;
}

/* weight of slope j in the deviation of node i of a stretch of n, step h: trapezoids, less the mean over the stretch */
static double trapezoid(int i, int j, double h) {
    if (j > i || i == 0) return 0;
    return j == 0 || j == i ? h / 2 : h;
}

static void weights_of(int n, int i, double h, double *weight) {
    for (int j = 0; j < n; j++) {
        double mean = 0;
        for (int k = 0; k < n; k++) mean += trapezoid(k, j, h) / n;
        weight[j] = trapezoid(i, j, h) - mean;
    }
}

/* a value and its standard deviation: independent parts in squares, the camera's part in step */
static void combine(int n, const double *weight, const rill_slope *slope, double *value, double *sigma) {
    double own = 0, common = 0;
    *value = 0;
    for (int j = 0; j < n; j++) {
        *value += weight[j] * slope[j].value;
        own += weight[j] * weight[j] * slope[j].sigma * slope[j].sigma;
        common += weight[j] * slope[j].systematic;
    }
    *sigma = sqrt(own + common * common);
}

/* deviations over a stretch of n slopes */
static void integrate(int n, double h, const rill_slope *slope, double *weight, wcut_rill_curve *curve,
                      wcut_rill_node *node) {
    int low = 0, high = 0;
    for (int i = 0; i < n; i++) {
        weights_of(n, i, h, weight);
        node[i].readable = true;
        combine(n, weight, slope, &node[i].deviation, &node[i].sigma);
        if (node[i].deviation < node[low].deviation) low = i;
        if (node[i].deviation > node[high].deviation) high = i;
        curve->differs = curve->differs || fabs(node[i].deviation) > DIFFERS * node[i].sigma;
    }

    /* the range, whose ends share slopes */
    for (int j = 0; j < n; j++) weight[j] = trapezoid(high, j, h) - trapezoid(low, j, h);
    combine(n, weight, slope, &curve->range, &curve->range_sigma);
    curve->readable = n;
}

/* one wire over the columns of the patches */
static wcut_status measure_curve(wcut_vec3 block, const wcut_history *h, const wcut_patch_grid *g,
                                 wcut_rill_curve *curve) {
    const int n = g->columns;
    rill_slope *slope = wcut_alloc((size_t)n, sizeof *slope);
    double *weight = wcut_alloc((size_t)n, sizeof *weight);
    curve->node = wcut_alloc((size_t)n, sizeof *curve->node);
    if (!slope || !weight || !curve->node) {
        wcut_free(slope);
        wcut_free(weight);
        return WCUT_NO_MEMORY;
    }

    /* nodes that the wire does not reach inside the block are left out at both ends */
    int first_there = -1, last_there = -2;
    for (int k = 0; k < n; k++) {
        double direction;
        wcut_vec3 place;
        if (!wire_at(h, curve->station, g->x0 + (k + 0.5) * g->side, block, &place, &direction)) continue;
        if (first_there < 0) first_there = k;
        last_there = k;
        curve->node[k].place = place;
        slope[k] = slope_of(g, place, direction);
    }
    curve->count = last_there - first_there + 1;
    for (int k = 0; k < curve->count; k++) {
        curve->node[k] = curve->node[first_there + k];
        slope[k] = slope[first_there + k];
    }

    /* short gaps are bridged; the longest stretch of slopes is integrated to a shape */
    bridge_gaps(curve->count, slope);
    int first = 0;
    const int length = longest_stretch(curve->count, slope, &first);
    if (length >= STRETCH_MIN) integrate(length, g->side, slope + first, weight, curve, curve->node + first);
    wcut_free(slope);
    wcut_free(weight);
    return WCUT_OK;
}

wcut_status wcut_rill_curves(wcut_vec3 block, const wcut_history *h, const wcut_patch_grid *grid, int curves,
                             int *count, wcut_rill_curve **curve) {
    int engaged = 0;
    for (int s = 0; s < h->stations; s++) engaged += h->row[s].engaged_length > 0;
    const int n = engaged < curves ? engaged : curves;
    wcut_rill_curve *made = wcut_alloc((size_t)n, sizeof *made);
    if (!made) return WCUT_NO_MEMORY;

    /* the k-th of n at the middle of its share of the wires in foam */
    int at = 0, seen = 0;
    wcut_status status = WCUT_OK;
    for (int s = 0; s < h->stations && status == WCUT_OK && at < n; s++) {
        if (!(h->row[s].engaged_length > 0)) continue;
        if (seen++ < (2LL * at + 1) * engaged / (2LL * n)) continue;
        made[at].station = s;
        status = measure_curve(block, h, grid, &made[at]);
        at++;
    }
    if (status != WCUT_OK) {
        wcut_rill_curves_free(at, made);
        return status;
    }
    *count = at;
    *curve = made;
    return WCUT_OK;
}

void wcut_rill_curves_free(int count, wcut_rill_curve *curve) {
    for (int k = 0; curve && k < count; k++) wcut_free(curve[k].node);
    wcut_free(curve);
}
