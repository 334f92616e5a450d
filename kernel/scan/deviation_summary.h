/* A summary's parts: sums of zones, a lattice of cells, sums of relations. */
#ifndef WCUT_SCAN_DEVIATION_SUMMARY_H
#define WCUT_SCAN_DEVIATION_SUMMARY_H

#include <wirecut/deviation_summary.h>

/* sums over deviations; those about a first one lose no digits to a constant offset */
typedef struct wcut_moments {
    int count;
    double shift, sum, squares, plain_squares, sizes, min, max;
} wcut_moments;

/* sums of a zone */
typedef struct wcut_zone_sums {
    wcut_moments of;
    wcut_vec3 low, high; /* of the feet */
    int within[WCUT_BANDS_MAX];
} wcut_zone_sums;

/* a cell of the lattice */
typedef struct wcut_cell {
    wcut_moments of;
    wcut_vec3 feet; /* their sum */
    double low_z, high_z;
} wcut_cell;

/* cells in x and y, row by row */
typedef struct wcut_lattice {
    int columns, rows;
    double side; /* [mm] */
    wcut_vec3 low;
    wcut_cell *cell;
} wcut_lattice;

/* sums of a pair of quantities */
typedef struct wcut_pair_sums {
    double n, x, y, xx, yy, xy;
} wcut_pair_sums;

enum { WCUT_PARTS = 3, WCUT_RELATIONS = 3 }; /* entry, steady, exit; time, path, bend */

struct wcut_deviation_summary {
    wcut_deviation_summary_options options;
    const wcut_face *face; /* or NULL */
    wcut_histogram *histogram;
    int place[WCUT_PLACE_COUNT];
    int patch_columns, patch_rows, parts; /* parts: WCUT_PARTS or 0 */
    wcut_zone_sums *zone;                 /* parts, then patches */
    wcut_lattice lattice;
    wcut_pair_sums relation[WCUT_RELATIONS][2]; /* of d, of |d| */
    wcut_zone *found_zone;
    wcut_worst found_worst[WCUT_WORST_MAX];
    wcut_deviation_summary_result result;
};

static inline void wcut_moments_add(wcut_moments *m, double d) {
    if (m->count == 0) m->shift = m->min = m->max = d;
    const double r = d - m->shift;
    m->count++;
    m->sum += r, m->squares += r * r, m->plain_squares += d * d, m->sizes += d < 0 ? -d : d;
    if (d < m->min) m->min = d;
    if (d > m->max) m->max = d;
}

/* zones.c: sums into figures; one zone takes in a deviation */
void wcut_zone_add(wcut_zone_sums *zone, const wcut_deviation_summary_options *options,
                   const wcut_deviation *deviation);
double wcut_moments_mean(const wcut_moments *m);
double wcut_moments_variance(const wcut_moments *m); /* of n - 1; 0 below two */
void wcut_zones_fill(const wcut_deviation_summary *summary, wcut_zone *zone);

/* worst.c: cells */
wcut_status wcut_lattice_create(const wcut_deviation_summary_options *options, wcut_lattice *lattice);
void wcut_lattice_add(wcut_lattice *lattice, const wcut_deviation *deviation);
/* cells large enough to have means: the lattice itself is left as it was. WCUT_NO_MEMORY */
wcut_status wcut_lattice_coarsen(const wcut_lattice *fine, wcut_lattice *coarse);
wcut_status wcut_lattice_split(const wcut_lattice *lattice, wcut_split *split); /* WCUT_NO_MEMORY */
/* at most WCUT_WORST_MAX areas; WCUT_NO_MEMORY */
wcut_status wcut_worst_list(const wcut_lattice *lattice, int *count, wcut_worst *worst);

#endif
