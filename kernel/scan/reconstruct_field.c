/* A thin plate through scattered heights (Duchon 1977) in bilinear elements; preconditioned conjugate gradients. */
#include "scan/reconstruct_field.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"

enum { CORNERS = 4, MAX_STEPS = 5000 };

static const double REDUCED = 1e-6; /* [1] of the residual, in the preconditioner's norm */
static const double THIN = 0.25;    /* [1] of the mean spacing: narrower cells are no stiffer than that */

/* A symmetric matrix whose rows reach to the next but one node along u and v and to the next one across: the entries of
   node k with k + offset. Vectors and entries have zeros before and behind, so that no row looks for its border. */
enum { SELF, RIGHT, RIGHT2, UP_LEFT, UP, UP_RIGHT, UP2, OFFSETS };

typedef struct plate {
    const wcut_lattice *lattice;
    int columns, rows, threads;
    size_t pad;                           /* zeros at either end */
    double *entry[OFFSETS];               /* nodes: of the quadratic form, padded */
    double *right, *inverse;              /* nodes, padded: right side, inverse of the diagonal */
    double *residual, *direction, *image; /* nodes, padded */
    double *row_sum;                      /* rows */
    unsigned char *active;                /* nodes */
} plate;

static void corner_weights(wcut_lattice_place p, double w[CORNERS]) {
    const double s = (double)p.s, t = (double)p.t;
    w[0] = (1 - s) * (1 - t), w[1] = s * (1 - t), w[2] = (1 - s) * t, w[3] = s * t;
}

static void corners_of(const plate *p, int cell, int corner[CORNERS]) {
    corner[0] = cell, corner[1] = cell + 1, corner[2] = cell + p->columns, corner[3] = cell + p->columns + 1;
}

static double square(double x) { return x * x; }

/* add w w^T of the four corners of a cell, the root of an element's share of the form */
static void add_cell(plate *p, int cell, const double w[CORNERS]) {
    const int up = cell + p->columns;
    p->entry[SELF][cell] += w[0] * w[0];
    p->entry[SELF][cell + 1] += w[1] * w[1];
    p->entry[SELF][up] += w[2] * w[2];
    p->entry[SELF][up + 1] += w[3] * w[3];
    p->entry[RIGHT][cell] += w[0] * w[1];
    p->entry[RIGHT][up] += w[2] * w[3];
    p->entry[UP][cell] += w[0] * w[2];
    p->entry[UP][cell + 1] += w[1] * w[3];
    p->entry[UP_RIGHT][cell] += w[0] * w[3];
    p->entry[UP_LEFT][cell + 1] += w[1] * w[2];
}

/* ---- which nodes ---- */

/* mark everything within `reach` cells along u, then v, of what is marked */
static void dilate(const plate *p, int reach, unsigned char *mark, unsigned char *scratch) {
    const int columns = p->columns, rows = p->rows;
    memcpy(scratch, mark, (size_t)columns * rows);
    for (int j = 0; j < rows; j++)
        for (int i = 0, last = -2 * reach - 1; i < columns + reach; i++) {
            if (i < columns && scratch[j * columns + i]) last = i;
            const int k = i - reach;
            if (k >= 0 && last >= k - reach) mark[j * columns + k] = 1;
        }
    memcpy(scratch, mark, (size_t)columns * rows);
    for (int i = 0; i < columns; i++)
        for (int j = 0, last = -2 * reach - 1; j < rows + reach; j++) {
            if (j < rows && scratch[j * columns + i]) last = j;
            const int k = j - reach;
            if (k >= 0 && last >= k - reach) mark[k * columns + i] = 1;
        }
}

/* a first height for nodes without a point around them: the mean of their neighbours', ring by ring */
static void reconstruct_field_spread(const plate *p, int reach, unsigned char *ring_of, double *height) {
    const int columns = p->columns, rows = p->rows;
    for (int ring = 1; ring <= 2 * reach && ring < 255; ring++)
        for (int k = 0; k < columns * rows; k++) {
            double sum = 0;
            int count = 0;
            if (!p->active[k] || ring_of[k]) continue;
            for (int b = k / columns - 1; b <= k / columns + 1; b++)
                for (int a = k % columns - 1; a <= k % columns + 1; a++)
                    if (a >= 0 && a < columns && b >= 0 && b < rows && ring_of[b * columns + a] == ring)
                        sum += height[b * columns + a], count++;
            if (count) height[k] = sum / count, ring_of[k] = (unsigned char)(ring + 1);
        }
}

/* the points' share of the form, the nodes within reach of them, and a first height for each */
static wcut_status take_points(plate *p, int count, const wcut_lattice_place *place, const double *height, int reach,
                               double *start) {
    /* nodes with weight, marked in `scratch` */
    const int nodes = p->columns * p->rows;
    unsigned char *scratch = wcut_alloc((size_t)nodes, 1);
    if (!scratch) return WCUT_NO_MEMORY;
    double *weight = p->image; /* free until the solution begins */

    /* each point: its bilinear weights go into matrix, right side and weight of four nodes */
    for (int k = 0; k < count; k++) {
        double w[CORNERS];
        int corner[CORNERS];
        corner_weights(place[k], w);
        corners_of(p, place[k].cell, corner);
        add_cell(p, place[k].cell, w);
        for (int a = 0; a < CORNERS; a++) {
            p->active[corner[a]] = 1;
            p->right[corner[a]] += w[a] * height[k];
            weight[corner[a]] += w[a];
        }
    }

    /* nodes within reach join in */
    dilate(p, reach, p->active, scratch);

    /* a first height: the mean of the points at a node, spread to nodes without one */
    for (int k = 0; k < nodes; k++) {
        start[k] = weight[k] > 0 ? p->right[k] / weight[k] : 0;
        scratch[k] = weight[k] > 0;
    }
    reconstruct_field_spread(p, reach, scratch, start);

    wcut_free(scratch);
    return WCUT_OK;
}

/* ---- bending ---- */

/* [mm] between nodes, narrow cells as if they were wider */
static double reconstruct_field_apart(const plate *p, int k, int other, double thin) {
    return fmax(vec3_distance(p->lattice->point[k], p->lattice->point[other]), thin);
}

/* the square of the second difference of nodes k - step, k, k + step over the area around k, `across` wide:
   h_xx = 2 / (a + b) ((h_a - h) / a + (h_b - h) / b) */
static void add_line(plate *p, int k, int step, int near, int far, double across, double root, double thin) {
    const double a = reconstruct_field_apart(p, k, k - step, thin), b = reconstruct_field_apart(p, k, k + step, thin);
    const double share = root * sqrt(across * (a + b) / 2);
    const double x = 2 * share / (a * (a + b)), y = 2 * share / (b * (a + b)), z = -x - y;
    p->entry[SELF][k - step] += x * x;
    p->entry[SELF][k] += z * z;
    p->entry[SELF][k + step] += y * y;
    p->entry[near][k - step] += x * z;
    p->entry[near][k] += y * z;
    p->entry[far][k - step] += x * y;
}

/* [mm] mean distance of the neighbours that node k has, `place` of 0 .. last, in a direction */
static double width(const plate *p, int k, int place, int last, int step, double thin) {
    const double a = place > 0 ? reconstruct_field_apart(p, k, k - step, thin) : 0,
                 b = place < last ? reconstruct_field_apart(p, k, k + step, thin) : 0;
    return (a + b) / ((place > 0) + (place < last));
}

/* the bending energy of node k and of the cell above and to the right of it; only where all that it needs is active */
static void add_bending(plate *p, int k, double root, double thin) {
    const int columns = p->columns, i = k % columns, j = k / columns;
    const unsigned char *active = p->active + k;
    if (i > 0 && i < columns - 1 && active[-1] && active[1])
        add_line(p, k, 1, RIGHT, RIGHT2, width(p, k, j, p->rows - 1, columns, thin), root, thin);
    if (j > 0 && j < p->rows - 1 && active[-columns] && active[columns])
        add_line(p, k, columns, UP, UP2, width(p, k, i, columns - 1, 1, thin), root, thin);
    if (i == columns - 1 || j == p->rows - 1 || !active[1] || !active[columns] || !active[columns + 1]) return;
    const double twist =
        root *
        sqrt(2 / (reconstruct_field_apart(p, k, k + 1, thin) * reconstruct_field_apart(p, k, k + columns, thin)));
    add_cell(p, k, (double[CORNERS]){twist, -twist, -twist, twist});
}

static double mean_spacing(const wcut_lattice *l) {
    double sum = 0;
    for (int j = 0; j < l->rows; j++)
        for (int i = 1; i < l->columns; i++)
            sum += vec3_distance(l->point[j * l->columns + i], l->point[j * l->columns + i - 1]);
    return sum / ((double)l->rows * (l->columns - 1));
}

/* root: of the stiffness density s^4 */
static void stiffen(plate *p, double root) {
    const double thin = THIN * mean_spacing(p->lattice);
    const int nodes = p->columns * p->rows;
    for (int k = 0; k < nodes; k++)
        if (p->active[k]) add_bending(p, k, root, thin);
    for (int k = 0; k < nodes; k++) p->inverse[k] = p->entry[SELF][k] > 0 ? 1 / p->entry[SELF][k] : 0;
}

/* ---- conjugate gradients ---- */

/* y = A x */
static void reconstruct_field_multiply(const plate *p, const double *x, double *y) {
    const int offset[OFFSETS] = {0, 1, 2, p->columns - 1, p->columns, p->columns + 1, 2 * p->columns};
#pragma omp parallel for schedule(static) num_threads(wcut_threads(p->threads))
    for (int j = 0; j < p->rows; j++)
        for (int k = j * p->columns; k < (j + 1) * p->columns; k++) {
            double sum = p->entry[SELF][k] * x[k];
            for (int o = RIGHT; o < OFFSETS; o++)
                sum += p->entry[o][k] * x[k + offset[o]] + p->entry[o][k - offset[o]] * x[k - offset[o]];
            y[k] = sum;
        }
}

/* sum of a b c (c may be NULL): rows first, then in their order, the same for every number of threads */
static double reconstruct_field_dot(const plate *p, const double *a, const double *b, const double *c) {
#pragma omp parallel for schedule(static) num_threads(wcut_threads(p->threads))
    for (int j = 0; j < p->rows; j++) {
        double sum = 0;
        for (int k = j * p->columns; k < (j + 1) * p->columns; k++) sum += c ? a[k] * b[k] * c[k] : a[k] * b[k];
        p->row_sum[j] = sum;
    }
    double sum = 0;
    for (int j = 0; j < p->rows; j++) sum += p->row_sum[j];
    return sum;
}

/* x from a first guess to A x = right; false where that takes more than MAX_STEPS steps */
static bool reconstruct_field_solve(const plate *p, double *x, int *steps) {
    const int nodes = p->columns * p->rows;
    double *r = p->residual, *d = p->direction;
    reconstruct_field_multiply(p, x, p->image);
    for (int k = 0; k < nodes; k++) r[k] = p->right[k] - p->image[k], d[k] = r[k] * p->inverse[k];
    double rho = reconstruct_field_dot(p, r, r, p->inverse);
    /* of the first residual or, where a guess leaves next to none, of the rounding of the right side */
    const double goal = REDUCED * REDUCED * fmax(rho, 1e-16 * reconstruct_field_dot(p, p->right, p->right, p->inverse));
    for (*steps = 0; rho > goal && *steps < MAX_STEPS; (*steps)++) {
        reconstruct_field_multiply(p, d, p->image);
        const double step = rho / reconstruct_field_dot(p, d, p->image, NULL);
        for (int k = 0; k < nodes; k++) x[k] += step * d[k], r[k] -= step * p->image[k];
        const double next = reconstruct_field_dot(p, r, r, p->inverse), turn = next / rho;
        for (int k = 0; k < nodes; k++) d[k] = r[k] * p->inverse[k] + turn * d[k];
        rho = next;
    }
    return rho <= goal;
}

/* ---- the whole ---- */

enum { ARRAYS = OFFSETS + 5 };

static void list_arrays(plate *p, double **array[ARRAYS]) {
    double **const rest[] = {&p->right, &p->inverse, &p->residual, &p->direction, &p->image};
    for (int k = 0; k < ARRAYS; k++) array[k] = k < OFFSETS ? &p->entry[k] : rest[k - OFFSETS];
}

static bool allocate(plate *p) {
    double **array[ARRAYS];
    const size_t nodes = (size_t)lattice_nodes(p->lattice);
    bool done = true;
    p->pad = 2 * (size_t)p->columns + 2;
    list_arrays(p, array);
    for (int k = 0; k < ARRAYS; k++) {
        double *room = wcut_alloc(nodes + 2 * p->pad, sizeof *room);
        *array[k] = room ? room + p->pad : NULL;
        done = done && room;
    }
    p->active = wcut_alloc(nodes, 1);
    p->row_sum = wcut_alloc((size_t)p->rows, sizeof *p->row_sum);
    return done && p->active && p->row_sum;
}

/* all but `active`, which is handed out */
static void reconstruct_field_clear(plate *p) {
    double **array[ARRAYS];
    list_arrays(p, array);
    for (int k = 0; k < ARRAYS; k++)
        if (*array[k]) wcut_free(*array[k] - p->pad);
    wcut_free(p->row_sum);
}

/* [mm] of the points about the field */
static double reconstruct_field_misfit(const plate *p, int count, const wcut_lattice_place *place, const double *height,
                                       const double *x) {
    double sum = 0;
    for (int k = 0; k < count; k++) {
        double w[CORNERS], h = -height[k];
        int corner[CORNERS];
        corner_weights(place[k], w);
        corners_of(p, place[k].cell, corner);
        for (int a = 0; a < CORNERS; a++) h += w[a] * x[corner[a]];
        sum += square(h);
    }
    return sqrt(sum / count);
}

wcut_status wcut_field_solve(const wcut_lattice *lattice, int count, const wcut_lattice_place *place,
                             const double *height, double density, double smoothing, int reach, int threads,
                             wcut_field *field) {
    /* the plate on the lattice, with a margin around it for the stencils */
    plate p = {.lattice = lattice, .columns = lattice->columns, .rows = lattice->rows, .threads = threads};
    const size_t nodes = (size_t)lattice_nodes(lattice);
    wcut_field f = {0};
    double *room = wcut_alloc(nodes + 4 * (size_t)p.columns + 4, sizeof *room);
    wcut_status status = allocate(&p) && room ? WCUT_OK : WCUT_NO_MEMORY;
    double *x = room ? room + p.pad : NULL;
    if (status == WCUT_OK) status = take_points(&p, count, place, height, reach, x);

    /* stiffness sqrt(rho) s^2 of the plate, then conjugate gradients */
    if (status == WCUT_OK) {
        stiffen(&p, sqrt(density) * smoothing * smoothing);
        if (!reconstruct_field_solve(&p, x, &f.iterations)) status = WCUT_NOT_CONVERGED;
        f.rms = reconstruct_field_misfit(&p, count, place, height, x);
    }

    /* the heights are the field's own */
    if (status == WCUT_OK) f.height = wcut_copy(x, nodes, sizeof *x);
    if (status == WCUT_OK && !f.height) status = WCUT_NO_MEMORY;
    wcut_free(room);
    reconstruct_field_clear(&p);
    f.active = p.active;
    if (status == WCUT_OK)
        *field = f;
    else
        wcut_field_clear(&f);

    return status;
}

void wcut_field_clear(wcut_field *field) {
    wcut_free(field->height);
    wcut_free(field->active);
    *field = (wcut_field){0};
}
