/* The empirical terms of the force: what a dictionary of quantities makes of F where no named effect does. */
#ifndef WCUT_FOAM_EMPIRICAL_H
#define WCUT_FOAM_EMPIRICAL_H

#include "foam/block.h"
#include "foam/locality.h"

/* Terms of empirical_force, in the order of its choices; the text is the word in files. */
#define WCUT_TERM_LIST(X)                        \
    X(POSITION_X, "position_x", wcut_term_first) \
    X(POSITION_Y, "position_y", wcut_term_first) \
    X(POSITION_Z, "position_z", wcut_term_first) \
    X(WAVE_X, "wave_x", wave)                    \
    X(WAVE_Y, "wave_y", wave)                    \
    X(WAVE_Z, "wave_z", wave)                    \
    X(BAND_X, "band_x", band)                    \
    X(BAND_Y, "band_y", band)                    \
    X(BAND_Z, "band_z", band)                    \
    X(DIRECTION_X, "direction_x", direction)     \
    X(DIRECTION_Y, "direction_y", direction)     \
    X(DIRECTION_Z, "direction_z", direction)     \
    X(HEAT_STEP, "q_eff_step", heat_step)        \
    X(HEAT_HINGE, "q_eff_hinge", heat_step)      \
    X(HEAT_INVERSE, "q_eff_inverse", heat_unit)  \
    X(LOG_SPEED, "ln_speed", speed_unit)         \
    X(CURVATURE, "curvature", radius)            \
    X(ENTRY, "entry", constant)                  \
    X(WAY, "way", way)                           \
    X(CLOCK, "time", start)                      \
    X(ORDER, "cut_order", order)                 \
    X(WINDOW, "window", window)                  \
    X(SPEED_MEMORY, "speed_memory", constant)    \
    X(HEAT_MEMORY, "heat_memory", constant)

#define WCUT_TERM_ENTRY(name, text, list) WCUT_TERM_##name,
typedef enum wcut_term { WCUT_TERM_LIST(WCUT_TERM_ENTRY) WCUT_TERM_COUNT } wcut_term;
#undef WCUT_TERM_ENTRY

/* terms with a memory that a wire may have at once: as many as a node keeps */
enum { WCUT_TERM_MEMORIES = 2 };

/* words of the terms, ended by NULL; the parameters of the first, and of any */
extern const char *const wcut_term_name[WCUT_TERM_COUNT + 1];
extern const wcut_effect_parameter wcut_term_first[];
const wcut_effect_parameter *wcut_term_parameters(int term);

/* whether a term looks back in time, by a kernel */
bool wcut_term_remembers(int term);

/* the node that a factor is asked for */
typedef struct wcut_term_node {
    const wcut_block *block;
    wcut_vec3 x;
    int n, i;
    double rate, speed; /* of the step: 1 / its duration; [mm/s] > 0 */
    double heat, heat_by_speed, heat_by_log_rate;
    wcut_vec3 heat_by_position; /* [W/m] that reaches the foam, and how it changes */
} wcut_term_node;

/* 1 + sum c phi over the empirical terms at work, kept positive; and its change */
typedef struct wcut_term_factor {
    double value, by_speed, by_log_rate;
    wcut_vec3 by_position;
} wcut_term_factor;

/* the factor on F; false where no empirical term is at work */
bool wcut_term_factor_eval(const wcut_locality *at, const wcut_term_node *node, wcut_term_factor *out);

/* what the memories of a node hold after a step that ends at this speed and heat; held: WCUT_TERM_MEMORIES */
void wcut_term_remember(const wcut_locality *at, double rate, double speed, double heat, int i, double *held);

#endif
