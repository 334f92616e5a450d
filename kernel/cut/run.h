/* One run of a cut: the wire as it is, the wire as it is being tried, and the solver's memory. */
#ifndef WCUT_CUT_RUN_H
#define WCUT_CUT_RUN_H

#include <wirecut/cut.h>

#include "cut/setup.h"
#include "cut/solve.h"

/* A wire at one moment, with what the step that led to it left behind. */
typedef struct wcut_wire {
    wcut_vec3 *x;       /* n [mm] */
    double *s;          /* n-1 [N] edge tensions */
    wcut_vec3 *pattern; /* n [N] the load that shaped it last: a wire that nothing touches keeps it, hence its shape */
    wcut_vec3 *force;   /* n [N] of the foam */
    double *line;       /* n [N/mm] */
    double *speed;      /* n [mm/s] */
    double *engaged;    /* n [1] */
    double length;      /* [mm] */
    double front_speed; /* [mm/s] of the faster end */
    bool loaded;        /* the foam touches it */
    double required_tension; /* [N] tension that the foam's force asks for */
    wcut_condition condition;
    wcut_vec3 *accumulated;       /* n [N s] heun's memory; unused by implicit */
    double step_duration;         /* [s] heun's h_j of the step that led here; 0 before the first */
    wcut_vec3 end_a, end_b;       /* [mm] where its ends were led to: they are there unless mounts give way */
    wcut_node_state *state;       /* n: effects' memory */
    wcut_vec3 offset[2], pull[2]; /* [mm] [N] of the mounts */
    double age;                   /* [s] since it entered the foam; 0 outside */
    double clock;                 /* [s] of the run, or of the recording that it replays */
    bool pulled;                  /* offset and pull are there */
} wcut_wire;

/* What a wire does that comes to touch while it hangs loose. */
typedef enum wcut_contact_rule {
    WCUT_CONTACT_BY_WEIGHT, /* it leans; where that leaves it without tension it has a weight from then on */
    WCUT_CONTACT_HEAVY      /* it has a weight from station 0 on */
} wcut_contact_rule;

struct wcut_cut {
    const wcut_setup *setup;
    int index;               /* of the station it is at */
    double time;             /* [s] */
    double duration;         /* [s] of the last step */
    double speed_a, speed_b; /* [mm/s] of the ends over the last step */
    int iterations, substeps;
    double residual;
    bool touched; /* the wire has been in contact */
    bool over;    /* a step failed: the run cannot go on */
    wcut_contact_rule contact_rule;
    bool weighted; /* a loose wire has a weight and a drag: the slower way through a first contact, see implicit.c */
    wcut_wire now, next;
    wcut_vec3 *was;           /* n: where the nodes come from in the sub-step being tried */
    wcut_vec3 *hanging_shape; /* n: the wire under its last load between its new ends */
    double *hanging_tension;  /* n-1 */
    wcut_vec3 *kept;          /* n [N] the pattern before the foam was tried on it */
    wcut_vec3 *contact;       /* n [N] what the foam may load a loose wire with */
    wcut_vec3 *dead_load;     /* n [N] the weight of a loose wire */
    wcut_vec3 *softer;        /* n: the last solution while a face is being hardened */
    double *softer_tension;   /* n-1 */
    double *edge;             /* n-1 [mm] lengths of the edges of the hung wire */
    double *rest;             /* n-1 [mm] the same without tension: other than edge where the wire stretches */
    wcut_solver solver;
    wcut_bow_frame frame; /* of a bow at the target of the sub-step being tried, after wcut_cut_fit */
    double taut;          /* [N] tension of a bow's straight wire there, 0: it is slack, or no bow */
    double part;          /* [1] where on the way from station to station the sub-step being tried ends */
    struct wcut_sensitivity *sensitivity; /* follows the run where it is asked for; NULL: nobody asks */
};

/* how a run deals with first contact; before its first step */
void wcut_contact_rule_set(wcut_cut *cut, wcut_contact_rule rule);

/* Where a step or sub-step is to lead. */
typedef struct wcut_target {
    wcut_vec3 end_a, end_b;
    double length;   /* [mm] of wire between them */
    double duration; /* [s]; 0: tension-driven, the solver finds it */
    double heat;     /* [W/m] */
} wcut_target;

/* advance cut->next, which is a copy of cut->now, to the target; the time taken is added to *elapsed */
wcut_status wcut_implicit_advance(wcut_cut *cut, const wcut_target *target, double *elapsed, wcut_error *error);
wcut_status wcut_heun_advance(wcut_cut *cut, const wcut_target *target, double *elapsed, wcut_error *error);

#endif
