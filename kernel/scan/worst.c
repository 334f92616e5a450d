/* A lattice of cells over a face: their means split a deviation into offset, form and noise and show the worst areas. */

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "base/vec3.h"
#include "scan/deviation_summary.h"

enum { SIDE_MAX = 512, HELD = 8, TOLD = 2 };

static const double SHARE = 0.95; /* of the cells are not among the worst */

/* ---- cells ---- */

wcut_status wcut_lattice_create(const wcut_deviation_summary_options *options, wcut_lattice *lattice) {
    const double wide = options->high.x - options->low.x, long_side = options->high.y - options->low.y;
    wcut_lattice l = {.side = fmax(options->cell, fmax(wide, long_side) / SIDE_MAX), .low = options->low};
    l.columns = (int)clamp(ceil(wide / l.side), 1, SIDE_MAX);
    l.rows = (int)clamp(ceil(long_side / l.side), 1, SIDE_MAX);
    l.cell = wcut_alloc((size_t)l.columns * l.rows, sizeof *l.cell);
    if (!l.cell) return WCUT_NO_MEMORY;
    *lattice = l;
    return WCUT_OK;
}

void wcut_lattice_add(wcut_lattice *lattice, const wcut_deviation *deviation) {
    const wcut_vec3 p = deviation->foot;
    const int column = (int)clamp(floor((p.x - lattice->low.x) / lattice->side), 0, lattice->columns - 1);
    const int row = (int)clamp(floor((p.y - lattice->low.y) / lattice->side), 0, lattice->rows - 1);
    wcut_cell *c = &lattice->cell[row * lattice->columns + column];
    if (c->of.count == 0) c->low_z = c->high_z = p.z;
    c->low_z = fmin(c->low_z, p.z), c->high_z = fmax(c->high_z, p.z);
    c->feet = vec3_add(c->feet, p);
    wcut_moments_add(&c->of, deviation->distance);
}

/* one cell into another, their squares moved to one shift */
static void merge(wcut_cell *to, const wcut_cell *from) {
    if (from->of.count == 0) return;
    if (to->of.count == 0) {
        *to = *from;
        return;
    }
    const wcut_moments *m = &from->of;
    const double move = m->shift - to->of.shift;
    to->of.squares += m->squares + 2 * move * m->sum + m->count * move * move;
    to->of.sum += m->sum + m->count * move;
    to->of.plain_squares += m->plain_squares, to->of.sizes += m->sizes, to->of.count += m->count;
    to->of.min = fmin(to->of.min, m->min), to->of.max = fmax(to->of.max, m->max);
    to->feet = vec3_add(to->feet, from->feet);
    to->low_z = fmin(to->low_z, from->low_z), to->high_z = fmax(to->high_z, from->high_z);
}

/* are half of the cells that hold points worth a mean? */
static bool is_full(const wcut_lattice *l) {
    int there = 0, full = 0;
    for (int k = 0; k < l->columns * l->rows; k++) {
        there += l->cell[k].of.count > 0;
        full += l->cell[k].of.count >= HELD;
    }
    return 2 * full >= there;
}

/* two by two cells into one, in place: what is read is not yet written over */
static void worst_halve(wcut_lattice *l) {
    const int columns = (l->columns + 1) / 2, rows = (l->rows + 1) / 2;
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < columns; c++) {
            wcut_cell sum = {0};
            for (int k = 0; k < 4; k++) {
                const int from_row = 2 * r + k / 2, from_column = 2 * c + k % 2;
                if (from_row < l->rows && from_column < l->columns)
                    merge(&sum, &l->cell[from_row * l->columns + from_column]);
            }
            l->cell[r * columns + c] = sum;
        }
    l->columns = columns, l->rows = rows, l->side *= 2;
}

wcut_status wcut_lattice_coarsen(const wcut_lattice *fine, wcut_lattice *coarse) {
    wcut_lattice l = *fine;
    l.cell = wcut_copy(fine->cell, (size_t)fine->columns * fine->rows, sizeof *l.cell);
    if (!l.cell) return WCUT_NO_MEMORY;
    while (!is_full(&l) && (l.columns > 1 || l.rows > 1)) worst_halve(&l);
    *coarse = l;
    return WCUT_OK;
}

/* The mean of a cell without its lowest and its highest, so that one stray point does not make a bump of 12 mm noise. */
static double worst_mean_of(const wcut_cell *cell) {
    const wcut_moments *m = &cell->of;
    if (m->count < HELD / 2) return wcut_moments_mean(m);
    return m->shift + (m->sum - (m->min - m->shift) - (m->max - m->shift)) / (m->count - 2);
}

/* ---- offset, form, noise ---- */

/* The median of the cells' variances, each over the median of its chi-square (Wilson, Hilferty 1931): strays spoil few
   cells. */
static double noise_square(const wcut_lattice *l, double *scratch) {
    int count = 0;
    for (int k = 0; k < l->columns * l->rows; k++) {
        const wcut_moments *m = &l->cell[k].of;
        if (m->count < TOLD) continue;
        const double freedom = m->count - 1.0, root = 1 - 2 / (9 * freedom);
        scratch[count++] = wcut_moments_variance(m) / (root * root * root);
    }
    if (count == 0) return 0;
    wcut_sort(count, scratch);
    return sorted_median(count, scratch);
}

wcut_status wcut_lattice_split(const wcut_lattice *lattice, wcut_split *split) {
    const int count = lattice->columns * lattice->rows;
    double sum = 0, shares = 0, about = 0;

    /* the noise of a single deviation, from cells with several */
    wcut_split s = {.cell = lattice->side};
    double *scratch = wcut_alloc((size_t)count, sizeof *scratch);
    if (!scratch) return WCUT_NO_MEMORY;
    const double noise = noise_square(lattice, scratch);
    wcut_free(scratch);

    /* sums over the cells that have enough deviations */
    for (int k = 0; k < count; k++) {
        if (lattice->cell[k].of.count < TOLD) continue;
        s.cells++;
        sum += worst_mean_of(&lattice->cell[k]);
        shares += 1.0 / lattice->cell[k].of.count;
    }
    if (s.cells > 0) {
        /* offset and noise; form is the spread of the cells' means, less what noise gives them */
        s.offset = sum / s.cells;
        s.offset_error = sqrt(noise * shares) / s.cells;
        s.noise_rms = sqrt(noise);
        for (int k = 0; k < count; k++) {
            const double d = worst_mean_of(&lattice->cell[k]) - s.offset;
            if (lattice->cell[k].of.count >= TOLD) about += d * d;
        }
        s.form_rms = sqrt(fmax(about / s.cells - noise * shares / s.cells, 0));
    }
    *split = s;

    return WCUT_OK;
}

/* ---- worst areas ---- */

/* the size of mean that only the worst cells exceed; cells of a single point or two have no say unless all are such */
static double level_of(const wcut_lattice *l, double *scratch) {
    int count = 0;
    for (int k = 0; k < l->columns * l->rows; k++)
        if (l->cell[k].of.count >= TOLD) scratch[count++] = fabs(worst_mean_of(&l->cell[k]));
    if (count == 0) return INFINITY;
    wcut_sort(count, scratch);
    return sorted_quantile(count, scratch, SHARE);
}

/* 1 above the level, -1 below minus it, 0 else */
static int level_side(const wcut_lattice *l, int k, double level) {
    if (l->cell[k].of.count < TOLD) return 0;
    const double mean = worst_mean_of(&l->cell[k]);
    return fabs(mean) < level || mean == 0 ? 0 : mean > 0 ? 1 : -1;
}

/* what an area is while it grows */
typedef struct area {
    wcut_cell sum;
    int cells, left, right, front, back;
    double volume, peak; /* [mm] of the cells' means: their sum, that of largest size */
} area;

static void worst_grow(area *a, const wcut_lattice *l, int k) {
    const int column = k % l->columns, row = k / l->columns;
    if (a->cells++ == 0) a->left = a->right = column, a->front = a->back = row;
    if (column < a->left) a->left = column;
    if (column > a->right) a->right = column;
    if (row > a->back) a->back = row;
    const double mean = worst_mean_of(&l->cell[k]);
    if (fabs(mean) > fabs(a->peak)) a->peak = mean;
    a->volume += mean;
    merge(&a->sum, &l->cell[k]);
}

/* all cells of one side that touch `from` by a side; marks them */
static area flood(const wcut_lattice *l, const signed char *side, unsigned char *seen, int *stack, int from) {
    area a = {0};
    int depth = 0;
    stack[depth++] = from, seen[from] = 1;
    while (depth > 0) {
        const int k = stack[--depth], column = k % l->columns, row = k / l->columns;
        const int next[] = {column > 0 ? k - 1 : k, column < l->columns - 1 ? k + 1 : k, row > 0 ? k - l->columns : k,
                            row < l->rows - 1 ? k + l->columns : k};
        worst_grow(&a, l, k);
        for (int n = 0; n < 4; n++)
            if (!seen[next[n]] && side[next[n]] == side[from]) seen[next[n]] = 1, stack[depth++] = next[n];
    }
    return a;
}

static wcut_worst worst_area(const wcut_lattice *l, const area *a) {
    const wcut_cell *c = &a->sum;
    const double side = l->side;
    return (wcut_worst){
        .place = vec3_scale(1.0 / c->of.count, c->feet),
        .low = {l->low.x + a->left * side, l->low.y + a->front * side, c->low_z},
        .high = {l->low.x + (a->right + 1) * side, l->low.y + (a->back + 1) * side, c->high_z},
        .area = a->cells * side * side,
        .volume = a->volume * side * side,
        .mean = a->volume / a->cells,
        .peak = a->peak,
        .count = c->of.count,
    };
}

/* into a list that is in order of volume, if it is among the first */
static void place_in(wcut_worst *list, int *count, wcut_worst w) {
    int k = *count < WCUT_WORST_MAX ? (*count)++ : WCUT_WORST_MAX;
    if (k == WCUT_WORST_MAX && fabs(list[--k].volume) >= fabs(w.volume)) return;
    for (; k > 0 && fabs(list[k - 1].volume) < fabs(w.volume); k--) list[k] = list[k - 1];
    list[k] = w;
}

wcut_status wcut_worst_list(const wcut_lattice *lattice, int *count, wcut_worst *worst) {
    /* room for as many areas as there are cells */
    const int cells = lattice->columns * lattice->rows;
    double *scratch = wcut_alloc((size_t)cells, sizeof *scratch);
    int *stack = wcut_alloc((size_t)cells, sizeof *stack);
    signed char *side = wcut_alloc((size_t)cells, 1);
    unsigned char *seen = wcut_alloc((size_t)cells, 1);
    const bool there = scratch && stack && side && seen;

    /* cells beyond the level, and on which side */
    if (there) {
        const double level = level_of(lattice, scratch);
        for (int k = 0; k < cells; k++) side[k] = (signed char)level_side(lattice, k, level);

        /* connected cells of one side are one area; the worst are kept in order */
        *count = 0;
        for (int k = 0; k < cells; k++) {
            if (side[k] == 0 || seen[k]) continue;
            const area a = flood(lattice, side, seen, stack, k);
            place_in(worst, count, worst_area(lattice, &a));
        }
    }

    wcut_free(seen);
    wcut_free(side);
    wcut_free(stack);
    wcut_free(scratch);
    return there ? WCUT_OK : WCUT_NO_MEMORY;
}
