/* The one residual of the wire in the foam: equilibrium of every free node under (3) at the new shape, edge lengths,
   and the tension condition (4), with its banded Jacobian. Tension-driven and time-driven steps share it. */
#ifndef WCUT_CUT_SYSTEM_H
#define WCUT_CUT_SYSTEM_H

#include "base/banded.h"
#include "cut/bow.h"
#include "cut/compliance.h"
#include "foam/resistance.h"

/* What one step is asked to do. */
typedef struct wcut_step {
    const wcut_foam *foam;
    double heat;                       /* [W/m] */
    double tension;                    /* [N] k */
    double edge;                       /* [mm] new rest length of an edge */
    const double *lengths;             /* n-1 [mm] of the edges that the foam acts on; NULL: all `edge` */
    int n;                             /* nodes */
    const wcut_vec3 *was;              /* n: where each node comes from */
    const wcut_vec3 *dead_load;        /* n [N] what else loads the free nodes; NULL: nothing */
    bool heavy;                        /* the dead load is a weight: it counts in (4) */
    double drag;                       /* [N s/mm] of the air on a free node; 0: none */
    const wcut_compliance *compliance; /* NULL: the wire keeps its length and its ends stay where they are put */
    const wcut_bow_frame *frame; /* a bow, at a given rate: its closing u and equation take the place of ln r and (4) */
} wcut_step;

/* Unknowns in the order S_0, X_1, S_1, X_2, .., X_{n-2}, S_{n-2} (S edge tensions [N]); the equations in the same
   order: length of edge e where S_e stands, equilibrium of node i where X_i stands. The band reaches 6 to
   either side. */
typedef struct wcut_system {
    int n, size; /* nodes; 4 n - 7 */
    wcut_banded jacobian;
    double *residual;    /* size: [N] and [mm] */
    double *by_log_rate; /* size: d residual / d ln r; of a bow d u */
    double *border;      /* size: d condition / d unknown */
    double condition;    /* [N] |sum f| - k |t_0 + t_{n-1}|; of a bow [mm] (T - P) / k_b - u */
    double condition_by_log_rate;
    double load;           /* [N] sum |f_i| */
    double pull;           /* [N] |sum f| / |t_0 + t_{n-1}|: the tension that the foam's force asks for */
    double chord_pull;     /* [N] T of a bow: pull of both end edges along the chord */
    wcut_resistance *node; /* n: the foam's force on each node, as of the last evaluation */
} wcut_system;

/* how the residual is measured: largest parts, each relative */
typedef struct wcut_misfit {
    double balance;   /* [1] unbalanced force of a node over the load */
    double strain;    /* [1] */
    double condition; /* [1] of (4), over k; of a bow's closing, over an edge */
} wcut_misfit;

bool wcut_system_create(int n, wcut_system *y);
void wcut_system_destroy(wcut_system *y);

/* where mounts give way: put both ends of x where tensions and rate have them; else nothing */
void wcut_system_place_ends(const wcut_step *step, const double *s, double log_rate, wcut_vec3 *x);

/* evaluate at shape x (n, ends in place), edge tensions s (n-1) and ln r; with `slopes` Jacobian and borders too */
void wcut_system_eval(wcut_system *y, const wcut_step *step, const wcut_vec3 *x, const double *s, double log_rate,
                      bool slopes);

wcut_misfit wcut_system_misfit(const wcut_system *y, const wcut_step *step);

#endif
