/* What faulty instruments make of a prediction: offsets, gains, drifts, and a clock that runs behind. */
#include <wirecut/effects.h>

#include "base/alloc.h"
#include "base/numbers.h"

typedef struct span { /* the samples that are there */
    int samples;
    const double *time;
    const unsigned char *present;
} span;

static bool span_has(const span *s, int i) { return !s->present || s->present[i]; }

/* sensor "a", "b" or "both" */
static bool is_meant(const wcut_effect *e, int mount) { return e->choice == mount || e->choice == 2; }

static void offset_angle(const wcut_effect *e, const span *s, double *const value[WCUT_SENSED_COUNT]) {
    double *angle = value[WCUT_SENSED_ALPHA_A + e->choice];
    for (int i = 0; angle && i < s->samples; i++)
        if (span_has(s, i)) angle[i] += e->value[WCUT_ANGLE_OFFSET_OFFSET] * WCUT_PI / 180;
}

/* drift [N]: d t / 100 s, or d (1 - exp(-t/tau)) */
static double drift_at(const wcut_effect *e, double time) {
    const double drift = e->value[WCUT_TENSION_DRIFT_DRIFT], tau = e->value[WCUT_TENSION_DRIFT_TIME_CONSTANT];
    return tau > 0 ? -drift * expm1(-time / tau) : drift * time / 100;
}

/* what a joint with friction shows: it follows once the angle has left its play (Prandtl 1928) */
static void hold_angles(const wcut_effect *e, const span *s, double *const value[WCUT_SENSED_COUNT]) {
    const double half = e->value[WCUT_ENCODER_FRICTION_HALF_WIDTH] * WCUT_PI / 180;
    for (int k = WCUT_SENSED_ALPHA_A; k < WCUT_SENSED_COUNT; k++) {
        double *angle = value[k], shown = 0;
        bool begun = false;
        for (int i = 0; angle && i < s->samples; i++) {
            if (!span_has(s, i)) continue;
            shown = begun ? clamp(shown, angle[i] - half, angle[i] + half) : angle[i];
            angle[i] = shown, begun = true;
        }
    }
}

static void scale_angle(const wcut_effect *e, const span *s, double *const value[WCUT_SENSED_COUNT]) {
    double *angle = value[WCUT_SENSED_ALPHA_A + e->choice];
    for (int i = 0; angle && i < s->samples; i++)
        if (span_has(s, i)) angle[i] *= 1 + e->value[WCUT_ANGLE_GAIN_GAIN];
}

static void spoil_tension(const wcut_effect *e, const span *s, double *const value[WCUT_SENSED_COUNT]) {
    for (int mount = 0; mount < 2; mount++) {
        double *tension = value[WCUT_SENSED_TENSION_A + mount];
        if (!tension || !is_meant(e, mount)) continue;
        for (int i = 0; i < s->samples; i++) {
            if (!span_has(s, i)) continue;
            if (e->kind == WCUT_EFFECT_TENSION_GAIN)
                tension[i] *= 1 + e->value[WCUT_TENSION_GAIN_GAIN];
            else if (e->kind == WCUT_EFFECT_TENSION_ZERO)
                tension[i] += e->value[WCUT_TENSION_ZERO_OFFSET];
            else
                tension[i] += drift_at(e, s->time[i] - s->time[0]);
        }
    }
}

/* offset and slope between two times, in the channel's unit */
static void add_reading(const wcut_effect *e, const span *s, double *const value[WCUT_SENSED_COUNT]) {
    double *signal = value[WCUT_SENSED_TENSION_A + e->choice];
    const double from = e->value[WCUT_EMPIRICAL_READING_FROM], to = e->value[WCUT_EMPIRICAL_READING_TO];
    const double offset = e->value[WCUT_EMPIRICAL_READING_OFFSET], slope = e->value[WCUT_EMPIRICAL_READING_SLOPE];
    const double unit = e->choice < 2 ? 1 : WCUT_PI / 180;
    for (int i = 0; signal && i < s->samples; i++)
        if (span_has(s, i) && s->time[i] >= from && s->time[i] <= to)
            signal[i] += unit * (offset + slope * (s->time[i] - fmax(from, s->time[0])) / 100);
}

/* value(t - delay), linear between the samples that are there, held beyond them; t and y: room for them */
static void shift(const span *s, double delay, double *t, double *y, double *value) {
    int count = 0, j = 0;
    for (int i = 0; i < s->samples; i++)
        if (span_has(s, i)) t[count] = s->time[i], y[count++] = value[i];
    for (int i = 0; i < s->samples; i++) {
        if (!span_has(s, i)) continue;
        const double at = clamp(s->time[i] - delay, t[0], t[count - 1]);
        while (j < count - 2 && t[j + 1] <= at) j++;
        const double share = count > 1 ? (at - t[j]) / (t[j + 1] - t[j]) : 0;
        value[i] = count > 1 ? (1 - share) * y[j] + share * y[j + 1] : y[0];
    }
}

static wcut_status delay_clock(const wcut_effect *e, const span *s, double *const value[WCUT_SENSED_COUNT]) {
    double *work = wcut_alloc((size_t)s->samples, 2 * sizeof *work);
    if (!work) return WCUT_NO_MEMORY;
    const int at = e->kind == WCUT_EFFECT_TENSION_DELAY ? WCUT_TENSION_DELAY_DELAY : WCUT_CLOCK_OFFSET_DELAY;
    const int end = e->kind == WCUT_EFFECT_TENSION_DELAY ? WCUT_SENSED_ALPHA_A : WCUT_SENSED_COUNT;
    for (int k = WCUT_SENSED_TENSION_A; k < end; k++)
        if (value[k]) shift(s, e->value[at], work, work + s->samples, value[k]);
    wcut_free(work);
    return WCUT_OK;
}

wcut_status wcut_sensors_eval(int count, const wcut_effect *effect, int samples, const double *time,
                              const unsigned char *present, double *const value[WCUT_SENSED_COUNT]) {
    /* check before anything is changed: the values are changed in place */
    if (samples < 0 || !value || (samples > 0 && !time) || wcut_effects_check(count, effect, NULL) != WCUT_OK)
        return WCUT_BAD_ARGUMENT;
    for (int i = 0; i < samples; i++)
        if (!isfinite(time[i]) || (i > 0 && !(time[i] > time[i - 1]))) return WCUT_BAD_ARGUMENT;
    const span s = {samples, time, present};
    /* the delays first: they alone need memory, and their order with what is constant or grows slowly does not matter */
    for (int e = 0; e < count; e++) {
        if (effect[e].kind != WCUT_EFFECT_CLOCK_OFFSET && effect[e].kind != WCUT_EFFECT_TENSION_DELAY) continue;
        if (wcut_effect_is_neutral(&effect[e])) continue;
        const wcut_status status = delay_clock(&effect[e], &s, value);
        if (status != WCUT_OK) return status;
    }

    /* play of the joints comes before gains and offsets: it acts on the true angle */
    for (int e = 0; e < count; e++)
        if (effect[e].kind == WCUT_EFFECT_ENCODER_FRICTION) hold_angles(&effect[e], &s, value);

    /* then everything that is constant or grows slowly */
    for (int e = 0; e < count; e++) {
        if (wcut_effect_is_neutral(&effect[e])) continue;
        if (effect[e].kind == WCUT_EFFECT_EMPIRICAL_READING) add_reading(&effect[e], &s, value);
        if (effect[e].kind == WCUT_EFFECT_ANGLE_GAIN) scale_angle(&effect[e], &s, value);
        if (effect[e].kind == WCUT_EFFECT_ANGLE_OFFSET) offset_angle(&effect[e], &s, value);
        if (effect[e].kind == WCUT_EFFECT_TENSION_GAIN || effect[e].kind == WCUT_EFFECT_TENSION_DRIFT ||
            effect[e].kind == WCUT_EFFECT_TENSION_ZERO)
            spoil_tension(&effect[e], &s, value);
    }

    return WCUT_OK;
}
