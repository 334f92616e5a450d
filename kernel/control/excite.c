/* The programme of an identification cut in a plan: times and speeds that follow the dither, for programs that are run
   without feedback. */
#include <math.h>
#include <wirecut/robot.h>

#include "base/fail.h"
#include "base/numbers.h"

/* [1] of the plan's longest engagement, from which the programme runs: as the recorded time of a cut has it */
#define MOST_OF_WIRE 0.5
/* stations of a period: with fewer a speed that is even between stations flattens the sine by more than 7 % */
#define PER_PERIOD 5.0

/* [s] integral of the pace, 1 + sum A sin(2 pi t / P + phase), from 0 to t */
static double paced_time(const wcut_job *job, double t) {
    double sum = t;
    for (int k = 0; k < job->dither_count; k++) {
        const wcut_dither *d = &job->dither[k];
        const double turn = 2 * WCUT_PI / d->period;
        sum += d->amplitude / turn * (cos(d->phase) - cos(turn * t + d->phase));
    }
    return sum;
}

/* [s] that a way of `plan` seconds takes from a time on: the integral is monotone, so halving always ends */
static double excited_duration(const wcut_job *job, double from, double plan) {
    const double begun = paced_time(job, from);
    double low = 0, high = plan;
    while (paced_time(job, from + high) - begun < plan) high *= 2;
    for (int i = 0; i < 60; i++) {
        const double middle = (low + high) / 2;
        if (paced_time(job, from + middle) - begun < plan)
            low = middle;
        else
            high = middle;
    }
    return (low + high) / 2;
}

static wcut_status check_excitation(const wcut_job *job, const wcut_history *h, double from, wcut_error *error) {
    double sum = 0, shortest = INFINITY;
    for (int k = 0; k < job->dither_count; k++)
        sum += fabs(job->dither[k].amplitude), shortest = fmin(shortest, job->dither[k].period);
    if (!(sum < 1) || !(shortest > 0))
        return wcut_fail(
            error, WCUT_BAD_ARGUMENT,
            "excitation.speed: found amplitudes of %g together, expected less than 1, and positive periods", sum);
    for (int j = 1; j < h->stations && job->dither_count > 0; j++) {
        const double took = h->row[j].time - h->row[j - 1].time;
        if (h->row[j].engaged_length < from || took <= shortest / PER_PERIOD) continue;
        return wcut_fail(
            error, WCUT_BAD_ARGUMENT,
            "station %d comes %.3g s after the one before, expected %.3g s at most for a sine of %.3g s: the "
            "path needs more stations",
            j, took, shortest / PER_PERIOD, shortest);
    }
    return WCUT_OK;
}

wcut_status wcut_history_excite(const wcut_job *job, wcut_history *h, wcut_error *error) {
    if (!job || !h || !h->row || h->stations < 2)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a job and a history of at least two stations are expected");

    /* most of the wire is in the foam from half of its longest engagement on */
    double longest = 0;
    for (int j = 0; j < h->stations; j++) longest = fmax(longest, h->row[j].engaged_length);
    const double from = MOST_OF_WIRE * longest;
    const wcut_status status = check_excitation(job, h, from, error);
    if (status != WCUT_OK) return status;

    /* station after station, each from the time at which the one before is reached */
    double planned = h->row[0].time, time = planned;
    for (int j = 1; j < h->stations; j++) {
        wcut_history_row *r = &h->row[j];
        const double plan = r->time - planned;
        const bool runs = h->row[j - 1].engaged_length >= from && longest > 0;
        const double duration = runs ? excited_duration(job, time, plan) : plan;
        planned = r->time, time += duration;
        r->time = time, r->duration = duration;
        r->speed_a *= plan / duration, r->speed_b *= plan / duration;
    }
    h->row[0].speed_a = h->row[1].speed_a, h->row[0].speed_b = h->row[1].speed_b;
    return WCUT_OK;
}
