/* Whether a recording can be of its job in the units that its columns say: way over time against speed, mounts against the
   path, tensions and angles against the balance of forces. Not a score: what it doubts is off by a factor. */
#include <math.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/plausible.h>

#include "base/alloc.h"
#include "base/fail.h"

#define SPEED_MARGIN 1.3  /* [1] a clock or a speed that is off by less is for the diagnosis */
#define FACTOR_MARGIN 1.4 /* [1] how near a ratio must be to that of a unit */
#define CERTAIN 5.0       /* [1] no machine is off by that */
#define COVERED_MIN 0.3   /* [1] of the stations: less may be the approach alone */
#define PLACE_MARGIN 0.25 /* [1] of the block's longest side: a mount that is off by more is in another frame or unit */

typedef struct check {
    const wcut_job *job;
    const wcut_recording *recording;
    int count;
    wcut_doubt *doubt;
} check;

/* a unit that a column may be in, and what its values are then multiplied with */
typedef struct other_unit {
    double ratio; /* found over expected */
    const char *name;
} other_unit;

static const char *nearest_unit(int n, const other_unit *unit, double ratio) {
    for (int k = 0; k < n; k++)
        if (ratio > unit[k].ratio / FACTOR_MARGIN && ratio < unit[k].ratio * FACTOR_MARGIN) return unit[k].name;
    return NULL;
}

static bool column_has(const wcut_column *c, int i) { return c->value && (!c->present || c->present[i]); }

static wcut_doubt *add_doubt(check *c, wcut_channel channel, double ratio, bool certain) {
    wcut_doubt *d = &c->doubt[c->count++];
    *d = (wcut_doubt){.channel = channel, .ratio = ratio, .certain = certain};
    return d;
}

/* ---- clock and speed ---- */

static double distance_between(wcut_vec3 a, wcut_vec3 b) {
    return sqrt(pow(a.x - b.x, 2) + pow(a.y - b.y, 2) + pow(a.z - b.z, 2));
}

/* the place of mount A at a station of the job's path */
static wcut_vec3 place_at(const wcut_job *job, double station) {
    const int last = job->stations - 1, k = station > 0 ? station < last ? (int)station : last - 1 : 0;
    const wcut_vec3 a = job->mount_a[k], b = job->mount_a[k + 1];
    const double t = fmin(fmax(station - k, 0), 1);
    return (wcut_vec3){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/* the whole way that mount A made against the sum of its speed over the times */
static void check_clock(check *c) {
    static const other_unit unit[] = {
        {1e-3, "time_s looks like milliseconds"},     {1e-6, "time_s looks like microseconds"},
        {1e-9, "time_s looks like nanoseconds"},      {60, "time_s looks like minutes, or speed_a_mm_s like m/min"},
        {1.0 / 60, "speed_a_mm_s looks like mm/min"}, {1000, "speed_a_mm_s looks like m/s"},
        {25.4, "speed_a_mm_s looks like inch/s"},     {10, "speed_a_mm_s looks like cm/s"}};

    /* way along the job's path against the recorded speed times the time */
    const wcut_column *time = &c->recording->channel[WCUT_CHANNEL_TIME];
    const wcut_column *station = &c->recording->channel[WCUT_CHANNEL_STATION];
    const wcut_column *speed = &c->recording->channel[WCUT_CHANNEL_SPEED_A];
    if (c->job->mode != WCUT_MODE_PATH || c->job->stations < 2) return;

    /* sums over the samples at which all three are there */
    double way = 0, sum = 0, span = 0;
    for (int i = 1; i < c->recording->samples; i++) {
        if (!column_has(station, i) || !column_has(station, i - 1) || !column_has(speed, i)) continue;
        const double dt = time->value[i] - time->value[i - 1];
        way += distance_between(place_at(c->job, station->value[i]), place_at(c->job, station->value[i - 1]));
        sum += speed->value[i] * dt;
        span += dt;
    }

    /* a machine that stands says nothing */
    if (!(way > 0.01 * distance_between(c->job->mount_a[0], c->job->mount_a[c->job->stations - 1])) || !(fabs(sum) > 0))
        return;

    /* their ratio is 1 in the right units */
    const double ratio = way / fabs(sum);
    if (ratio < SPEED_MARGIN && ratio > 1 / SPEED_MARGIN) return;
    const char *name = nearest_unit(sizeof unit / sizeof *unit, unit, ratio);

    /* the doubt, with the unit that would explain the ratio */
    wcut_doubt *d = add_doubt(c, WCUT_CHANNEL_TIME, ratio, ratio > CERTAIN || ratio < 1 / CERTAIN);
    wcut_fail(
        &d->error, WCUT_BAD_FORMAT,
        "time_s and speed_a_mm_s contradict each other: mount A makes %.4g mm in %.4g s, which is %.3g mm/s, where "
        "speed_a_mm_s is %.4g in the mean, a factor of %.3g%s%s",
        way, span, way / span, sum / span, ratio > 1 ? ratio : 1 / ratio, name ? ": " : "", name ? name : "");
}

/* ---- places ---- */

static void check_places(check *c) {
    static const other_unit unit[] = {{1e-3, "metres"}, {0.1, "centimetres"}, {1 / 25.4, "inches"}};

    /* measured places against the path at the recorded stations */
    const wcut_column *x = &c->recording->channel[WCUT_CHANNEL_A_X], *y = x + 1, *z = x + 2;
    const wcut_column *station = &c->recording->channel[WCUT_CHANNEL_STATION];
    if (c->job->mode != WCUT_MODE_PATH || c->job->stations < 2) return;

    /* mean distance, and mean distances of both from the origin */
    double off = 0, found = 0, expected = 0;
    int n = 0;
    for (int i = 0; i < c->recording->samples; i++) {
        if (!column_has(x, i) || !column_has(y, i) || !column_has(z, i) || !column_has(station, i)) continue;
        const wcut_vec3 at = {x->value[i], y->value[i], z->value[i]}, p = place_at(c->job, station->value[i]),
                        zero = {0, 0, 0};
        off += distance_between(at, p);
        found += distance_between(at, zero);
        expected += distance_between(p, zero);
        n++;
    }

    /* off by less than a share of the block: no doubt */
    const wcut_vec3 size = c->job->block_size;
    if (n == 0 || off / n < PLACE_MARGIN * fmax(size.x, fmax(size.y, size.z))) return;

    /* the ratio of the distances tells a unit */
    const double ratio = expected > 0 ? found / expected : 0;
    const char *name = nearest_unit(sizeof unit / sizeof *unit, unit, ratio);
    wcut_doubt *d = add_doubt(c, WCUT_CHANNEL_A_X, ratio, false);
    wcut_fail(&d->error, WCUT_BAD_FORMAT,
              "a_x_mm, a_y_mm, a_z_mm: mount A is %.4g mm off the job's path in the mean%s%s", off / n,
              name ? ": the columns look like " : ", in another frame or of another job", name ? name : "");
}

/* ---- tensions, angles, heat ---- */

/* the mean of a channel where it is there; 0 where it never is */
static double channel_mean(const check *c, wcut_channel channel, bool absolute) {
    const wcut_column *column = &c->recording->channel[channel];
    double sum = 0;
    int n = 0;
    for (int i = 0; i < c->recording->samples; i++) {
        if (!column_has(column, i)) continue;
        sum += absolute ? fabs(column->value[i]) : column->value[i];
        n++;
    }
    return n ? sum / n : 0;
}

/* whether the recording goes through enough of the path for its means to be those of a cut */
static bool is_of_a_cut(const check *c) {
    const wcut_column *station = &c->recording->channel[WCUT_CHANNEL_STATION];
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < c->recording->samples; i++) {
        if (!column_has(station, i)) continue;
        low = fmin(low, station->value[i]);
        high = fmax(high, station->value[i]);
    }
    return high - low > COVERED_MIN * (c->job->stations - 1);
}

static void check_tension(check *c, wcut_channel channel) {
    static const other_unit unit[] = {
        {101.97, "grams"}, {0.10197, "kilograms"}, {1000, "millinewtons"}, {0.2248, "pounds"}};
    const double mean = channel_mean(c, channel, false), ratio = mean / c->job->tension;
    const char *column = wcut_channel_name(channel);
    if (mean < 0 && ratio < -0.1) {
        wcut_doubt *d = add_doubt(c, channel, ratio, false);
        wcut_fail(&d->error, WCUT_BAD_FORMAT, "%s is %.4g N in the mean: a wire cannot be pushed, the sign is turned",
                  column, mean);
        return;
    }
    if (mean == 0 || (ratio < CERTAIN && ratio > 1 / CERTAIN)) return;
    const char *name = nearest_unit(sizeof unit / sizeof *unit, unit, ratio);
    wcut_doubt *d = add_doubt(c, channel, ratio, false);
    wcut_fail(&d->error, WCUT_BAD_FORMAT, "%s is %.4g N in the mean, the job aims at %.4g N%s%s", column, mean,
              c->job->tension, name ? ": it looks like " : "", name ? name : "");
}

/* the balance of forces, 2 T sin(alpha) = F L, with the job's law at the recorded speed */
static void check_angles(check *c) {
    const double alpha =
        (channel_mean(c, WCUT_CHANNEL_ALPHA_A, true) + channel_mean(c, WCUT_CHANNEL_ALPHA_B, true)) / 2;
    const double speed = channel_mean(c, WCUT_CHANNEL_SPEED_A, true), heat = channel_mean(c, WCUT_CHANNEL_HEAT, false);
    if (!(alpha > 0) || !(speed > 0) || !(c->job->tension > 0)) return;
    const double force = wcut_force_law_eval(&c->job->force_law, heat > 0 ? heat : c->job->heat, speed);
    const double expected = asin(fmin(force * c->job->block_size.x / (2 * c->job->tension), 1));
    const double ratio = alpha / expected;
    if (!(ratio > 0) || ratio > 2 / WCUT_DEG_PER_RAD || ratio < 0.3 / WCUT_DEG_PER_RAD) return;
    wcut_doubt *d = add_doubt(c, WCUT_CHANNEL_ALPHA_A, ratio, false);
    wcut_fail(&d->error, WCUT_BAD_FORMAT,
              "alpha_a_deg and alpha_b_deg are %.3g deg in the mean, the balance of forces asks for %.3g deg: they "
              "look like radians",
              alpha * WCUT_DEG_PER_RAD, expected * WCUT_DEG_PER_RAD);
}

static void doubt_heat(check *c) {
    static const other_unit unit[] = {{0.01, "W/cm"}, {1e-3, "W/mm"}, {1e3, "mW/m"}};
    const double mean = channel_mean(c, WCUT_CHANNEL_HEAT, false), ratio = mean / c->job->heat;
    if (mean == 0 || (ratio < CERTAIN && ratio > 1 / CERTAIN)) return;
    const char *name = nearest_unit(sizeof unit / sizeof *unit, unit, ratio);
    wcut_doubt *d = add_doubt(c, WCUT_CHANNEL_HEAT, ratio, false);
    wcut_fail(&d->error, WCUT_BAD_FORMAT, "heat_W_per_m is %.4g W/m in the mean, the job has %.4g W/m%s%s", mean,
              c->job->heat, name ? ": it looks like " : "", name ? name : "");
}

wcut_status wcut_recording_check(const wcut_job *job, const wcut_recording *recording, int *count, wcut_doubt *doubt) {
    if (!job || !recording || !count || !doubt || recording->samples < 1 ||
        !recording->channel[WCUT_CHANNEL_TIME].value)
        return WCUT_BAD_ARGUMENT;
    if (job->mode == WCUT_MODE_PATH && (job->stations < 2 || !job->mount_a)) return WCUT_BAD_ARGUMENT;
    check c = {.job = job, .recording = recording, .doubt = doubt};
    check_clock(&c);
    check_places(&c);
    if (is_of_a_cut(&c)) {
        check_tension(&c, WCUT_CHANNEL_TENSION_A);
        check_tension(&c, WCUT_CHANNEL_TENSION_B);
        check_angles(&c);
    }
    doubt_heat(&c);
    *count = c.count;
    return WCUT_OK;
}
