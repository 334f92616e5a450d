/* Banded linear systems: LU with partial pivoting, any number of right-hand sides. */
#include "base/banded.h"

#include <math.h>
#include <string.h>

void wcut_banded_clear(wcut_banded *m) { memset(m->entry, 0, sizeof(double) * banded_size(m->n, m->kl, m->ku)); }

static int last_row(const wcut_banded *m, int k) { return k + m->kl < m->n ? k + m->kl : m->n - 1; }

/* columns k .. k+reach of row k can be nonzero in U */
static int banded_reach_of(const wcut_banded *m, int k) {
    int reach = m->ku + m->kl;
    return k + reach < m->n ? reach : m->n - 1 - k;
}

static void swap_rows(double *restrict a, double *restrict b, int count) {
    for (int j = 0; j < count; j++) {
        double t = a[j];
        a[j] = b[j];
        b[j] = t;
    }
}

static void subtract_banded_row(double *restrict row, const double *restrict pivot_row, double factor, int count) {
    for (int j = 0; j < count; j++) row[j] -= factor * pivot_row[j];
}

bool wcut_banded_factor(wcut_banded *m) {
    for (int k = 0; k < m->n; k++) {
        const int last = last_row(m, k), reach = banded_reach_of(m, k);

        /* the largest entry of the column is the pivot */
        int p = k;
        for (int i = k + 1; i <= last; i++)
            if (fabs(*banded_at(m, i, k)) > fabs(*banded_at(m, p, k))) p = i;
        m->pivot[k] = p;
        double *row = banded_at(m, k, k);
        if (p != k) swap_rows(row, banded_at(m, p, k), reach + 1);
        if (!(fabs(row[0]) > 0) || !isfinite(row[0])) return false;

        /* subtract the pivot's row from those below */
        const double inverse = 1 / row[0];
        for (int i = k + 1; i <= last; i++) {
            double *below = banded_at(m, i, k);
            if (below[0] == 0) continue;
            below[0] *= inverse;
            subtract_banded_row(below + 1, row + 1, below[0], reach);
        }
    }

    return true;
}

void wcut_banded_solve(const wcut_banded *m, double *b) {
    for (int k = 0; k < m->n; k++) {
        const int p = m->pivot[k], last = last_row(m, k);
        double t = b[p];
        b[p] = b[k];
        b[k] = t;
        for (int i = k + 1; i <= last; i++) b[i] -= *banded_at(m, i, k) * t;
    }

    /* back substitution */
    for (int k = m->n - 1; k >= 0; k--) {
        const double *row = banded_at(m, k, k);
        const int reach = banded_reach_of(m, k);
        double sum = b[k];
        for (int j = 1; j <= reach; j++) sum -= row[j] * b[k + j];
        b[k] = sum / row[0];
    }
}
