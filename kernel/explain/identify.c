/* Identification cuts: three sines on the speed and steps of the heater, so that what follows the speed, the heat, the
   time and the place do not follow each other (NOTATION.md, Identification cuts). */
#include "explain/identify.h"

#include <stdio.h>
#include <string.h>
#include <wirecut/diagnosis.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "cut/setup.h"

enum { SINES = 3, CUTS_MAX = 8, TRIES = 4 };

/* one sine of each band: no period is a multiple of another, the slowest is still a dozen in a cut of two minutes */
static const double band[SINES][2] = {{3, 4.3}, {5.1, 7.6}, {8.4, 12}};
#define AMPLITUDE_MIN 0.04
#define AMPLITUDE_MAX 0.055
#define STEP_MIN 6.0 /* [s] of the heater: longer than any lag of the wire */
#define STEP_MAX 14.0
#define GAP_MIN 5.0
#define GAP_MAX 11.0
#define STEP_SIZE 0.1
/* [1] share of the cut in which the dithered speed may meet the machine's limit, which then clips it */
#define CLIPPED_MAX 0.1
/* [1] of the target: what the tension may reach with no feedback at all, below the controller's safe stop at 2.5 */
#define TENSION_MAX 2.0

static double draw_between(wcut_random *random, double low, double high) {
    return low + (high - low) * wcut_random_uniform(random);
}

/* ---- the speed ---- */

/* [1] the largest dither for which all but a tenth of the cut stays within the limits, heat steps included; below 0
   where there is none. speed: room for schedule->count */
static double headroom(const wcut_job *job, const wcut_schedule *s, double *speed) {
    int count = 0;
    for (int i = 0; i < s->count; i++)
        if (s->held[i] && s->engaged[i] >= WCUT_MOST_OF_WIRE) speed[count++] = s->speed[i];
    if (count == 0) return 0;
    wcut_sort(count, speed);
    const int left_out = (int)(CLIPPED_MAX * (count - 1));
    const double high = speed[count - 1 - left_out] * (1 + STEP_SIZE), low = speed[left_out] * (1 - STEP_SIZE);
    return fmin(job->speed_max / high - 1, 1 - job->speed_min / low);
}

static void draw_dither(wcut_job *job, double max, wcut_random *random) {
    double sum = 0;
    for (int k = 0; k < SINES; k++) {
        job->dither[k] = (wcut_dither){.amplitude = draw_between(random, AMPLITUDE_MIN, AMPLITUDE_MAX),
                                       .period = draw_between(random, band[k][0], band[k][1]),
                                       .phase = draw_between(random, 0, 2 * WCUT_PI)};
        sum += job->dither[k].amplitude;
    }
    const double factor = fmin(1, fmax(max, 0) / sum);
    for (int k = 0; k < SINES; k++) job->dither[k].amplitude *= factor;
    job->dither_count = SINES;
}

/* ---- the heat ---- */

/* Steps from where most of the wire is in the foam to the end, as often up as down. A cut that is too short for two
   of them gets shorter ones. Gives how many; step: room for `room`. */
static int draw_heat(const wcut_schedule *s, int room, wcut_heat_step *step, wcut_random *random) {
    int first = 0, last = s->count - 1, count = 0;
    while (first < last && s->engaged[first] < WCUT_MOST_OF_WIRE) first++;
    while (last > first && s->engaged[last] < WCUT_MOST_OF_WIRE) last--;
    const double end = last * WCUT_PREDICTED_CUT_STEP, span = end - first * WCUT_PREDICTED_CUT_STEP;
    const double shorter = fmin(1, span / (2 * (STEP_MAX + GAP_MAX)));
    double time = first * WCUT_PREDICTED_CUT_STEP + shorter * draw_between(random, GAP_MIN, GAP_MAX);
    bool up = false;
    while (count < room) {
        const double to = time + shorter * draw_between(random, STEP_MIN, STEP_MAX);
        if (to > end || !(to > time)) break;
        /* of two steps one goes up and one down, in either order */
        up = count % 2 == 0 ? wcut_random_uniform(random) < 0.5 : !up;
        step[count++] = (wcut_heat_step){time, to, 1 + (up ? STEP_SIZE : -STEP_SIZE)};
        time = to + shorter * draw_between(random, GAP_MIN, GAP_MAX);
    }
    return count;
}

/* ---- limits ---- */

/* [1] the highest tension of the excited cut over the target, without feedback */
static wcut_status find_peak(const wcut_job *job, double *peak, wcut_error *error) {
    wcut_schedule excited = {0};
    wcut_predicted_cut r = {0};
    wcut_status status = wcut_schedule_create(job, &excited, error);
    if (status == WCUT_OK) status = wcut_predicted_cut_run(job, &excited, NULL, &r, error);
    double max = 0;
    for (int i = 0; status == WCUT_OK && i < r.count; i++)
        if (r.present[i] && excited.held[i] && excited.engaged[i] >= WCUT_MOST_OF_WIRE)
            max = fmax(max, (r.value[2][i] + r.value[3][i]) / 2);
    wcut_predicted_cut_destroy(&r);
    wcut_schedule_destroy(&excited);
    if (status == WCUT_OK) *peak = max / job->tension;
    return status;
}

static void weaken(wcut_job *job, double factor) {
    for (int k = 0; k < job->dither_count; k++) job->dither[k].amplitude *= factor;
    for (int k = 0; k < job->heat_step_count; k++)
        job->heat_step[k].factor = 1 + (job->heat_step[k].factor - 1) * factor;
}

/* the log of the tension follows the excitation: by what its peak is too high, the excitation is too strong */
static wcut_status bound_tension(wcut_job *job, wcut_error *error) {
    for (int k = 0; k < TRIES; k++) {
        double peak = 0;
        const wcut_status status = find_peak(job, &peak, error);
        if (status != WCUT_OK || peak <= TENSION_MAX) return status;
        weaken(job, fmax(0.25, 0.97 * log(TENSION_MAX) / log(peak)));
    }
    return WCUT_OK;
}

static void forget(wcut_job *job) {
    wcut_free(job->dither);
    wcut_free(job->heat_step);
    job->dither = NULL, job->heat_step = NULL;
    job->dither_count = job->heat_step_count = 0;
}

wcut_status wcut_programme_create(wcut_job *job, const wcut_schedule *schedule, int parts, wcut_random *random,
                                  wcut_error *error) {
    /* room for the heater's steps: a duration holds so many of the shortest at most */
    const int room = (int)(schedule->count * WCUT_PREDICTED_CUT_STEP / STEP_MIN) + 2;
    double *speed = wcut_alloc((size_t)schedule->count, sizeof *speed);

    /* the plain job without any excitation, then the programme */
    forget(job);
    job->dither = wcut_alloc(SINES, sizeof *job->dither);
    job->heat_step = wcut_alloc((size_t)room, sizeof *job->heat_step);
    wcut_status status = WCUT_OK;
    if (speed && job->dither && job->heat_step) {
        /* both are drawn whatever is kept, so that the same seed makes the same dither with and without heat */
        draw_dither(job, headroom(job, schedule, speed), random);
        job->heat_step_count = draw_heat(schedule, room, job->heat_step, random);
        if (!(parts & WCUT_PROGRAMME_SPEED)) job->dither_count = 0;
        if (!(parts & WCUT_PROGRAMME_HEAT)) job->heat_step_count = 0;
        status = bound_tension(job, error);
    } else {
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a programme of %d steps", room);
    }

    wcut_free(speed);
    return status;
}

/* ---- the cuts ---- */

/* Run the path backwards where that can be planned: its last station need not be a place to begin from. WCUT_OK, with
   `turned` and then a schedule; WCUT_NO_MEMORY. */
static wcut_status reverse_schedule(wcut_job *job, bool *turned, wcut_schedule *schedule, wcut_error *error) {
    wcut_job_reverse(job);
    const wcut_status status = wcut_schedule_create(job, schedule, error);
    *turned = status == WCUT_OK;
    if (!*turned) wcut_job_reverse(job);
    return status == WCUT_NO_MEMORY ? status : WCUT_OK;
}

static wcut_status make_cut(const wcut_job *plain, const wcut_schedule *schedule, int index, wcut_random *random,
                            wcut_job **out, wcut_error *error) {
    /* the second cut runs the path backwards, so that place and time do not go together */
    wcut_job *job = wcut_job_copy(plain);
    wcut_schedule back = {0};
    if (!job) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a copy of a job");
    bool turned = false;
    wcut_status status = index == 1 ? reverse_schedule(job, &turned, &back, error) : WCUT_OK;

    /* its name says which cut it is */
    char behind[60];
    snprintf(behind, sizeof behind, ", identification %d%s", index + 1, turned ? ", backwards" : "");
    if (status == WCUT_OK && !wcut_job_name(job, behind))
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a name");

    /* the excitation: sines on the speed, steps of the heat */
    if (status == WCUT_OK)
        status = wcut_programme_create(job, turned ? &back : schedule, WCUT_PROGRAMME_SPEED | WCUT_PROGRAMME_HEAT,
                                       random, error);
    wcut_schedule_destroy(&back);

    /* hand over, or release */
    if (status == WCUT_OK)
        *out = job;
    else
        wcut_job_destroy(job);

    return status;
}

wcut_status wcut_identification_create(const wcut_job *job, int count, unsigned long long seed, wcut_job **out,
                                       wcut_error *error) {
    /* check the arguments, and that there is a path to vary */
    if (!job || count < 1 || count > CUTS_MAX || !out)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a job and 1 .. %d cuts are expected", CUTS_MAX);
    if (job->mode != WCUT_MODE_PATH)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "found a design, expected a job with the mounts' path");
    if (job->rig.kind == WCUT_RIG_KIND_BLADE)
        return wcut_fail(
            error, WCUT_BAD_ARGUMENT,
            "found a blade, expected a wire: dither and heater steps are for a hot wire; of a blade cut once "
            "more with another ratio of sliding to advance");

    /* one plan for all cuts: the job without excitation */
    wcut_job *made[CUTS_MAX] = {NULL};
    wcut_schedule schedule = {0};
    wcut_random random = wcut_random_seed(seed);
    wcut_job *plain = wcut_job_copy(job);
    wcut_status status = plain ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory for a copy of a job");
    if (status == WCUT_OK) {
        forget(plain);
        status = wcut_schedule_create(plain, &schedule, error);
    }

    /* every cut draws on from the same random numbers */
    for (int k = 0; k < count && status == WCUT_OK; k++)
        status = make_cut(plain, &schedule, k, &random, &made[k], error);

    /* write all of them or none */
    if (status == WCUT_OK) memcpy(out, made, (size_t)count * sizeof *out);
    for (int k = 0; k < count && status != WCUT_OK; k++) wcut_job_destroy(made[k]);

    wcut_schedule_destroy(&schedule);
    wcut_job_destroy(plain);
    return status;
}
