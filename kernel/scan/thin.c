/* Thinning on a lattice of cubes as points come in: the set of cubes seen is a hash table (linear probing). */
#include <stdint.h>
#include <wirecut/cloud.h>

#include "base/alloc.h"
#include "base/vec3.h"

enum { FIRST_BITS = 12, CELL_BITS = 50 };

static const double FAR = 1e12, MIN_VOXEL = 1e-3; /* [mm]: cells count up to 1e15 each way, below 2^50 */

/* a cube's three numbers; 0 0 0 stands for an empty place, so they are shifted to begin at 1 */
typedef struct cell {
    uint64_t x, y, z;
} cell;

struct wcut_thinning {
    double voxel;
    int bits;      /* the table has 2^bits places */
    size_t filled; /* places in use */
    cell *table;
};

wcut_status wcut_thinning_create(double voxel, wcut_thinning **thinning) {
    if (!isfinite(voxel) || voxel < MIN_VOXEL || !thinning) return WCUT_BAD_ARGUMENT;
    wcut_thinning *t = wcut_alloc(1, sizeof *t);
    if (t) t->table = wcut_alloc((size_t)1 << FIRST_BITS, sizeof *t->table);
    if (!t || !t->table) {
        wcut_free(t);
        return WCUT_NO_MEMORY;
    }
    t->voxel = voxel;
    t->bits = FIRST_BITS;
    *thinning = t;
    return WCUT_OK;
}

static inline uint64_t number(double x, double voxel) {
    return (uint64_t)((int64_t)floor(x / voxel) + ((int64_t)1 << CELL_BITS));
}

/* odd multipliers spread neighbours; the upper bits are the good ones */
static inline size_t thin_place_of(cell c, int bits) {
    uint64_t h = c.x * 0x9e3779b97f4a7c15u;
    h = (h ^ h >> 29 ^ c.y) * 0xbf58476d1ce4e5b9u;
    h = (h ^ h >> 32 ^ c.z) * 0x94d049bb133111ebu;
    return (size_t)((h ^ h >> 31) * 0x9e3779b97f4a7c15u >> (64 - bits));
}

/* 1 where the cell was not there yet */
static unsigned char thin_add(cell *table, int bits, cell c) {
    const size_t mask = ((size_t)1 << bits) - 1;
    for (size_t k = thin_place_of(c, bits);; k = (k + 1) & mask) {
        if (table[k].x == 0) {
            table[k] = c;
            return 1;
        }
        if (table[k].x == c.x && table[k].y == c.y && table[k].z == c.z) return 0;
    }
}

/* twice the places; false: no memory, the table is as it was */
static bool thin_grow(wcut_thinning *t) {
    const size_t places = (size_t)1 << t->bits;
    cell *table = wcut_alloc(2 * places, sizeof *table);
    if (!table) return false;
    for (size_t k = 0; k < places; k++)
        if (t->table[k].x != 0) thin_add(table, t->bits + 1, t->table[k]);
    wcut_free(t->table);
    t->table = table;
    t->bits++;
    return true;
}

wcut_status wcut_thinning_add(wcut_thinning *thinning, int count, const wcut_vec3 *point, unsigned char *keep) {
    if (!thinning || count < 0 || (count > 0 && (!point || !keep))) return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < count; k++)
        if (!(fabs(point[k].x) <= FAR && fabs(point[k].y) <= FAR && fabs(point[k].z) <= FAR)) return WCUT_BAD_ARGUMENT;
    const double voxel = thinning->voxel;
    for (int k = 0; k < count; k++) {
        const size_t places = (size_t)1 << thinning->bits;
        if (thinning->filled >= places - places / 3 && !thin_grow(thinning)) return WCUT_NO_MEMORY;
        const cell c = {number(point[k].x, voxel), number(point[k].y, voxel), number(point[k].z, voxel)};
        keep[k] = thin_add(thinning->table, thinning->bits, c);
        thinning->filled += keep[k];
    }
    return WCUT_OK;
}

void wcut_thinning_destroy(wcut_thinning *thinning) {
    if (!thinning) return;
    wcut_free(thinning->table);
    wcut_free(thinning);
}
