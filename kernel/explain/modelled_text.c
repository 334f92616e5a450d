/* What was modelled, in words and as an equation. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/numbers.h"
#include "explain/modelled.h"
#include "foam/empirical.h"

static const char *const axis_name[3] = {"across the block (x)", "along the feed (y)", "upwards (z)"};

typedef struct writer {
    char *to;
    int size, at;
} writer;

static void put_words(writer *w, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void put_words(writer *w, const char *format, ...) {
    va_list list;
    va_start(list, format);
    const int length = vsnprintf(w->to + w->at, (size_t)(w->size - w->at), format, list);
    va_end(list);
    if (length > 0) w->at = w->at + length < w->size ? w->at + length : w->size - 1;
}

/* which of three axes a term of place, wave, band or direction is along */
static int axis_of_term(int term) { return term < WCUT_TERM_HEAT_STEP ? term % 3 : 1; }

void wcut_term_formula(const wcut_effect *e, char *to, int size) {
    const double *v = e->value, turn = atan2(v[WCUT_EMPIRICAL_FORCE_COSINE], v[WCUT_EMPIRICAL_FORCE_COEFFICIENT]);

    /* a term of waves has an amplitude and a phase */
    const char axis = "xyz"[axis_of_term(e->choice)], length = "WLH"[axis_of_term(e->choice)];
    switch (e->choice) {
        case WCUT_TERM_POSITION_X:
        case WCUT_TERM_POSITION_Y:
        case WCUT_TERM_POSITION_Z:
            snprintf(to, (size_t)size, "P%.0f(2 %c / %c - 1)", v[WCUT_EMPIRICAL_FORCE_DEGREE], axis, length);
            return;
        case WCUT_TERM_WAVE_X:
        case WCUT_TERM_WAVE_Y:
        case WCUT_TERM_WAVE_Z:
            snprintf(to, (size_t)size, "sin(2 pi %c / %.1f mm %c %.2f)", axis, v[WCUT_EMPIRICAL_FORCE_WAVELENGTH],
                     turn < 0 ? '-' : '+', fabs(turn));
            return;
        case WCUT_TERM_BAND_X:
        case WCUT_TERM_BAND_Y:
        case WCUT_TERM_BAND_Z:
            snprintf(to, (size_t)size, "[%.0f mm < %c < %.0f mm]", v[WCUT_EMPIRICAL_FORCE_FROM], axis,
                     v[WCUT_EMPIRICAL_FORCE_TO]);
            return;
        case WCUT_TERM_DIRECTION_X:
        case WCUT_TERM_DIRECTION_Y:
        case WCUT_TERM_DIRECTION_Z:
            snprintf(to, (size_t)size, "cos(%sangle of motion to %c)", v[WCUT_EMPIRICAL_FORCE_ORDER] > 1.5 ? "2 " : "",
                     axis);
            return;

        /* terms of the heat input and of the speed */
        case WCUT_TERM_HEAT_STEP:
            snprintf(to, (size_t)size, "[Q_eff > %.0f J/m2]", v[WCUT_EMPIRICAL_FORCE_AT]);
            return;
        case WCUT_TERM_HEAT_HINGE:
            snprintf(to, (size_t)size, "max(Q_eff / %.0f J/m2 - 1, 0)", v[WCUT_EMPIRICAL_FORCE_AT]);
            return;
        case WCUT_TERM_HEAT_INVERSE:
            snprintf(to, (size_t)size, "(%.0f J/m2 / Q_eff - 1)", v[WCUT_EMPIRICAL_FORCE_Q_REF]);
            return;
        case WCUT_TERM_LOG_SPEED:
            snprintf(to, (size_t)size, "ln(v / %.0f mm/s)", v[WCUT_EMPIRICAL_FORCE_SPEED_REF]);
            return;

        /* terms of the wire's shape, of the way and of the time */
        case WCUT_TERM_CURVATURE:
            snprintf(to, (size_t)size, "(curvature x %.0f mm)", v[WCUT_EMPIRICAL_FORCE_RADIUS]);
            return;
        case WCUT_TERM_ENTRY:
            snprintf(to, (size_t)size, "exp(-t / %.2f s) since entry", v[WCUT_EMPIRICAL_FORCE_TIME_CONSTANT]);
            return;
        case WCUT_TERM_WAY:
            snprintf(to, (size_t)size, "way / %.0f mm", v[WCUT_EMPIRICAL_FORCE_LENGTH]);
            return;
        case WCUT_TERM_CLOCK:
            snprintf(to, (size_t)size, "t / 100 s");
            return;
        case WCUT_TERM_ORDER:
            if (v[WCUT_EMPIRICAL_FORCE_FIRST] >= 0)
                snprintf(to, (size_t)size, "[cuts %.0f to %.0f]", v[WCUT_EMPIRICAL_FORCE_FIRST] + 1,
                         v[WCUT_EMPIRICAL_FORCE_LAST] + 1);
            else
                snprintf(to, (size_t)size, "number of the cut");
            return;
        default:
            snprintf(to, (size_t)size, "(memory of %.2f s of ln %s)", v[WCUT_EMPIRICAL_FORCE_TIME_CONSTANT],
                     e->choice == WCUT_TERM_HEAT_MEMORY ? "heat" : "speed");
    }
}

static void tell_place(writer *w, const wcut_effect *e) {
    const double *v = e->value, c = 100 * v[WCUT_EMPIRICAL_FORCE_COEFFICIENT];

    /* polynomials of degree 1 are told as a difference between two faces */
    const char *axis = axis_name[axis_of_term(e->choice)];
    if (e->choice <= WCUT_TERM_POSITION_Z && v[WCUT_EMPIRICAL_FORCE_DEGREE] < 1.5)
        put_words(w, "the force changes by %+.0f %% %s from one face of the block to the other", 2 * c, axis);
    else if (e->choice <= WCUT_TERM_POSITION_Z)
        put_words(w, "the force varies by %+.0f %% %s, as a polynomial of degree %.0f", c, axis,
                  v[WCUT_EMPIRICAL_FORCE_DEGREE]);

    /* waves and bands in mm of the block */
    else if (e->choice <= WCUT_TERM_WAVE_Z)
        put_words(w, "the force varies by +-%.0f %% every %.0f mm %s (layers in the block?)",
                  100 * hypot(v[WCUT_EMPIRICAL_FORCE_COEFFICIENT], v[WCUT_EMPIRICAL_FORCE_COSINE]),
                  v[WCUT_EMPIRICAL_FORCE_WAVELENGTH], axis);
    else if (e->choice <= WCUT_TERM_BAND_Z)
        put_words(w, "the force is %+.0f %% between %.0f and %.0f mm %s", c, v[WCUT_EMPIRICAL_FORCE_FROM],
                  v[WCUT_EMPIRICAL_FORCE_TO], axis);

    /* directions: of order 2 both senses of an axis are alike, of order 1 they are opposite */
    else if (v[WCUT_EMPIRICAL_FORCE_ORDER] > 1.5)
        put_words(
            w,
            "the force depends on the direction of motion: it is %+.0f %% along %c against across it (grain of the "
            "foam?)",
            2 * c, "xyz"[axis_of_term(e->choice)]);
    else
        put_words(
            w,
            "the force depends on the direction of motion: %+.0f %% towards +%c, %+.0f %% towards -%c (grain of the "
            "foam?)",
            c, "xyz"[axis_of_term(e->choice)], -c, "xyz"[axis_of_term(e->choice)]);
}

void wcut_term_clause(const wcut_effect *e, char *to, int size) {
    const double *v = e->value, c = 100 * v[WCUT_EMPIRICAL_FORCE_COEFFICIENT];

    /* terms of place and direction have a function of their own */
    writer w = {to, size, 0};
    to[0] = 0;
    if (e->choice <= WCUT_TERM_DIRECTION_Z) {
        tell_place(&w, e);
        return;
    }

    /* terms of heat, speed, shape, time and number */
    switch (e->choice) {
        case WCUT_TERM_HEAT_STEP:
            put_words(&w,
                      "the force changes by %+.0f %% where the heat input is above %.0f J/m2 (another melting regime?)",
                      c, v[WCUT_EMPIRICAL_FORCE_AT]);
            return;
        case WCUT_TERM_HEAT_HINGE:
            put_words(&w, "beyond a heat input of %.0f J/m2 the force changes by %+.0f %% for every %.0f more",
                      v[WCUT_EMPIRICAL_FORCE_AT], c, v[WCUT_EMPIRICAL_FORCE_AT]);
            return;
        case WCUT_TERM_HEAT_INVERSE:
            put_words(&w, "the force has a part proportional to 1 / Q_eff: %+.0f %% at %.0f J/m2 against %.0f", c,
                      v[WCUT_EMPIRICAL_FORCE_Q_REF] / 2, v[WCUT_EMPIRICAL_FORCE_Q_REF]);
            return;

        /* speed and shape of the wire */
        case WCUT_TERM_LOG_SPEED:
            put_words(&w, "the force follows the speed itself: %+.0f %% for twice the speed", c * log(2));
            return;
        case WCUT_TERM_CURVATURE:
            put_words(&w, "the force follows the curvature of the wire: %+.0f %% at a radius of %.0f mm", c,
                      v[WCUT_EMPIRICAL_FORCE_RADIUS]);
            return;

        /* time, way and number of the cut: drifts, whose cause the operator may know */
        case WCUT_TERM_ENTRY:
            put_words(&w, "the force is %+.0f %% at entry and settles within %.1f s", c,
                      v[WCUT_EMPIRICAL_FORCE_TIME_CONSTANT]);
            return;
        case WCUT_TERM_WAY:
            put_words(&w, "the force changes by %+.1f %% per metre of cut", c * 1000 / v[WCUT_EMPIRICAL_FORCE_LENGTH]);
            return;
        case WCUT_TERM_CLOCK:
            put_words(&w, "the force changes by %+.1f %% in 100 s", c);
            return;
        case WCUT_TERM_ORDER:
            if (v[WCUT_EMPIRICAL_FORCE_FIRST] >= 0)
                put_words(&w, "the force is %+.0f %% in cuts %.0f to %.0f (another batch of foam, another wire?)", c,
                          v[WCUT_EMPIRICAL_FORCE_FIRST] + 1, v[WCUT_EMPIRICAL_FORCE_LAST] + 1);
            else
                put_words(&w, "the force changes by %+.1f %% from cut to cut", c);
            return;
        default:
            put_words(&w, "the force follows the %s of the last %.1f s",
                      e->choice == WCUT_TERM_HEAT_MEMORY ? "heat" : "speed", v[WCUT_EMPIRICAL_FORCE_TIME_CONSTANT]);
    }
}

/* ---- the whole ---- */

static void write_equation(wcut_modelled *m) {
    writer w = {m->equation, sizeof m->equation, 0};
    put_words(&w, "F = a exp(-b Q_eff) (1");
    for (int k = 0; k < m->terms; k++) {
        const wcut_effect *e = &m->term[k].effect;
        const bool wave = e->choice >= WCUT_TERM_WAVE_X && e->choice <= WCUT_TERM_WAVE_Z;
        const double c = wave ? hypot(e->value[WCUT_EMPIRICAL_FORCE_COEFFICIENT], e->value[WCUT_EMPIRICAL_FORCE_COSINE])
                              : e->value[WCUT_EMPIRICAL_FORCE_COEFFICIENT];
        char formula[80];
        wcut_term_formula(e, formula, sizeof formula);
        put_words(&w, " %c %.3g %s", c < 0 ? '-' : '+', fabs(c), formula);
    }
    put_words(&w, ")");
}

static void tell_events(writer *w, const wcut_modelled *m) {
    const wcut_event *e = &m->event[0];
    for (int k = 1; k < m->events; k++)
        if (fabs(m->event[k].tension) > fabs(e->tension)) e = &m->event[k];
    if (m->events == 1)
        put_words(w, "In cut %d from %.0f to %.0f s", e->cut + 1, e->time[0], e->time[1]);
    else
        put_words(w, "In %d windows, most of all in cut %d from %.0f to %.0f s,", m->events, e->cut + 1, e->time[0],
                  e->time[1]);
    put_words(w,
              " the force is %+.0f %% (as with %.0f %% of the heat); no other cut repeats it there. The rest is fitted "
              "without it",
              100 * e->force, 100 * (1 + e->heat));
}

void wcut_modelled_tell(wcut_diagnosis *d) {
    wcut_modelled *m = &d->modelled;
    if (m->terms == 0 && m->events == 0) return;

    /* append to the sentence of the verdict */
    writer w = {d->sentence, sizeof d->sentence, 0};

    /* the windows that were left out */
    if (m->events > 0) {
        tell_events(&w, m);
        put_words(&w,
                  m->after < m->recalibrated
                      ? ": with a level for each window the tension misfit falls from %.3g N to %.3g N."
                      : ".",
                  m->recalibrated, m->after);
    }

    /* the terms: an equation, then each in words */
    if (m->terms == 0) return;
    write_equation(m);
    put_words(&w, "%sAn effect outside the library: ", m->events > 0 ? " " : "");
    for (int k = 0; k < m->terms; k++) {
        char clause[160];
        wcut_term_clause(&m->term[k].effect, clause, sizeof clause);
        put_words(&w, "%s%s", k ? ", and " : "", clause);
    }
    put_words(&w, ". ");

    /* what they are worth on cuts that were left out */
    const wcut_evidence_score *from =
        &d->held_out_score[WCUT_EVIDENCE_MODEL_RECALIBRATED][WCUT_EVIDENCE_CHANNEL_TENSION];
    const wcut_evidence_score *to = &d->held_out_score[WCUT_EVIDENCE_MODEL_AFTER][WCUT_EVIDENCE_CHANNEL_TENSION];
    if (from->count > 0 && to->count > 0)
        put_words(&w, "With %s the held-out tension misfit %s from %.2g N to %.2g N.",
                  m->terms > 1 ? "these terms" : "this term",
                  to->rmsd < from->rmsd ? "falls" : "does not fall:", from->rmsd, to->rmsd);
}
