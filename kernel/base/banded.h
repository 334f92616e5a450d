/* Banded linear systems: LU with partial pivoting, any number of right-hand sides. */
#ifndef WCUT_BASE_BANDED_H
#define WCUT_BASE_BANDED_H

#include <stdbool.h>
#include <stddef.h>

/* A square matrix with `kl` diagonals below and `ku` above the main one. Row i holds the columns i-kl .. i+ku+kl; the
   last kl of them are room for what pivoting fills in and must be zero on entry. */
typedef struct wcut_banded {
    int n, kl, ku;
    int width;     /* 2 kl + ku + 1, doubles a row */
    double *entry; /* n x width */
    int *pivot;    /* n */
} wcut_banded;

/* doubles that `entry` needs */
static inline size_t banded_size(int n, int kl, int ku) { return (size_t)n * (size_t)(2 * kl + ku + 1); }

/* the entry in row i, column j, for j in i-kl .. i+ku */
static inline double *banded_at(const wcut_banded *m, int i, int j) {
    return m->entry + (size_t)i * (size_t)m->width + (j - i + m->kl);
}

/* zero every entry */
void wcut_banded_clear(wcut_banded *m);

/* factor in place; false where a pivot is zero or not finite: the matrix is singular */
bool wcut_banded_factor(wcut_banded *m);

/* solve for one right-hand side in place, after wcut_banded_factor */
void wcut_banded_solve(const wcut_banded *m, double *b);

#endif
