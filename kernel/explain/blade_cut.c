/* A recording of a blade in bins: positions, the edge's direction, passes, the sensor's zero, and how sliding follows force. */
#include "explain/blade_cut.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "base/vec3.h"

#define JUMP 8.0      /* [mm] from sample to sample: the tool was led back for another pass */
#define BACK 3.0      /* [mm] against the advance: the same */
#define TURN_MAX 0.02 /* [rad] of a blade that keeps its direction */
enum { BINS_MIN = 20, AIR_BINS = 5 };

void wcut_blade_cut_destroy(wcut_blade_cut *c) {
    wcut_free(c->time), wcut_free(c->station), wcut_free(c->way), wcut_free(c->advance), wcut_free(c->slide);
    wcut_free(c->force), wcut_free(c->along), wcut_free(c->pass), wcut_free(c->place);
    *c = (wcut_blade_cut){0};
}

static bool make_blade_bins(int bins, wcut_blade_cut *c) {
    const size_t n = (size_t)bins;
    double **column[] = {&c->time, &c->station, &c->way, &c->advance, &c->slide, &c->force, &c->along};
    bool whole = true;
    for (size_t k = 0; k < sizeof column / sizeof *column; k++) {
        *column[k] = wcut_alloc(n, sizeof(double));
        whole = whole && *column[k];
    }
    c->pass = wcut_alloc(n, sizeof *c->pass);
    c->place = wcut_alloc(n, sizeof *c->place);
    return whole && c->pass && c->place;
}

/* ---- the tool ---- */

static wcut_vec3 turn_vector(const wcut_pose *pose, wcut_vec3 v) {
    return vec3_sub(wcut_pose_point(pose, v), wcut_pose_point(pose, vec3(0, 0, 0)));
}

/* the edge's direction, and that it keeps it */
static wcut_status find_edge(const wcut_job *job, wcut_blade_cut *c, wcut_error *error) {
    const wcut_vec3 a = job->mount_a_in_tool, b = job->mount_b_in_tool;
    const wcut_vec3 own = vec3_unit(vec3_sub(b, a));
    c->line.edge = vec3_unit(turn_vector(&job->tool[0], own));
    c->line.from = vec3_dot(own, a), c->line.to = vec3_dot(own, b);
    for (int j = 1; j < job->stations; j++)
        if (vec3_distance(vec3_unit(turn_vector(&job->tool[j], own)), c->line.edge) > TURN_MAX)
            return wcut_fail(error, WCUT_DEGENERATE,
                             "the blade turns by more than %.2g rad along its path: such recordings "
                             "are not diagnosed",
                             TURN_MAX);
    return WCUT_OK;
}

/* ---- samples ---- */

/* what is there of a recording, sample by sample */
typedef struct samples {
    const wcut_job *job;
    const wcut_recording *r;
    double *way;      /* along the path, where only the speed is known [mm] */
    wcut_vec3 at;     /* last place */
    wcut_vec3 normal; /* across the edge */
} samples;

static bool there(const wcut_recording *r, int channel, int i) {
    const wcut_column *c = &r->channel[channel];
    return c->value && (!c->present || c->present[i]);
}

static double value(const wcut_recording *r, int channel, int i) { return r->channel[channel].value[i]; }

/* the path at a length along it, straight between stations */
static wcut_vec3 path_point(const wcut_job *job, double way) {
    for (int j = 0; j < job->stations - 1; j++) {
        const double length = vec3_distance(job->tool[j].at, job->tool[j + 1].at);
        if (way <= length || j == job->stations - 2)
            return vec3_mix(job->tool[j].at, job->tool[j + 1].at, length > 0 ? fmin(way / length, 1) : 0);
        way -= length;
    }
    return job->tool[0].at;
}

/* the tool's origin: measured, or by the station, or by the speed along the path */
static bool find_blade_place(samples *s, int i, wcut_vec3 *place) {
    const wcut_recording *r = s->r;
    if (r->channel[WCUT_CHANNEL_TOOL_X].value) {
        for (int k = 0; k < 3; k++)
            if (!there(r, WCUT_CHANNEL_TOOL_X + k, i)) return false;
        *place =
            vec3(value(r, WCUT_CHANNEL_TOOL_X, i), value(r, WCUT_CHANNEL_TOOL_Y, i), value(r, WCUT_CHANNEL_TOOL_Z, i));
        return true;
    }
    if (there(r, WCUT_CHANNEL_STATION, i)) {
        const double station = clamp(value(r, WCUT_CHANNEL_STATION, i), 0, s->job->stations - 1);
        const int j = (int)fmin(station, s->job->stations - 2);
        *place = vec3_mix(s->job->tool[j].at, s->job->tool[j + 1].at, station - j);
        return true;
    }
    if (!there(r, WCUT_CHANNEL_SPEED, i)) return false;
    *place = path_point(s->job, s->way[i]);
    return true;
}

static bool whole_sample(samples *s, int i, wcut_vec3 *place) {
    for (int k = 0; k < 3; k++)
        if (!there(s->r, WCUT_CHANNEL_FORCE_X + k, i)) return false;
    return find_blade_place(s, i, place);
}

/* the way gone at every sample, by the speed */
static bool integrate_speed(samples *s) {
    const wcut_recording *r = s->r;
    s->way = wcut_alloc((size_t)r->samples, sizeof(double));
    if (!s->way) return false;
    double way = 0, before = r->channel[WCUT_CHANNEL_TIME].value[0];
    for (int i = 0; i < r->samples; i++) {
        const double time = r->channel[WCUT_CHANNEL_TIME].value[i];
        if (there(r, WCUT_CHANNEL_SPEED, i)) way += value(r, WCUT_CHANNEL_SPEED, i) * (time - before);
        s->way[i] = way, before = time;
    }
    return true;
}

/* across the edge, the way the tool goes in the mean without its jumps */
static wcut_status find_normal(samples *s, wcut_blade_cut *c, wcut_error *error) {
    wcut_vec3 sum = {0}, last = {0}, at;
    bool first = true;
    for (int i = 0; i < s->r->samples; i++) {
        if (!whole_sample(s, i, &at)) continue;
        const wcut_vec3 step = vec3_sub(at, last);
        if (!first && vec3_length(step) < JUMP) sum = vec3_add(sum, step);
        last = at, first = false;
    }
    const wcut_vec3 across = vec3_add_scaled(sum, -vec3_dot(sum, c->line.edge), c->line.edge);
    if (!(vec3_length(across) > 10))
        return wcut_fail(error, WCUT_DEGENERATE, "the tool advances across its edge by %.3g mm, expected 10 mm or more",
                         vec3_length(across));
    s->normal = c->line.normal = vec3_unit(across);
    return WCUT_OK;
}

/* ---- bins ---- */

/* the forces of a sample in the block frame */
static wcut_vec3 force_of(const samples *s, int i) {
    const wcut_vec3 read = vec3(value(s->r, WCUT_CHANNEL_FORCE_X, i), value(s->r, WCUT_CHANNEL_FORCE_Y, i),
                                value(s->r, WCUT_CHANNEL_FORCE_Z, i));
    return s->job->rig.force_in_block ? read : turn_vector(&s->job->tool[0], read);
}

/* a bin being filled: sums over its samples, and where it began */
typedef struct filling {
    int count;
    double time, begin;
    wcut_vec3 place, force, start;
} filling;

/* means of a bin; its motion is that from its first place to the one behind it */
static void close_bin(const filling *f, double end, wcut_vec3 next, wcut_blade_cut *c) {
    const int b = c->bins++;
    const double part = 1.0 / f->count, duration = fmax(end - f->begin, 1e-9);
    const wcut_vec3 step = vec3_sub(next, f->start), force = vec3_scale(part, f->force);
    c->time[b] = part * f->time;
    c->place[b] = vec3_scale(part, f->place);
    c->advance[b] = vec3_dot(step, c->line.normal) / duration;
    c->slide[b] = fabs(vec3_dot(step, c->line.edge)) / duration;
    c->way[b] = fmax(vec3_dot(step, c->line.normal), 0);
    c->force[b] = -vec3_dot(force, c->line.normal);
    c->along[b] = vec3_dot(force, c->line.edge);
    c->pass[b] = c->passes;
}

static void fill_bins(samples *s, wcut_blade_cut *c) {
    filling f = {0};
    wcut_vec3 at, last = {0};
    double before = 0;
    for (int i = 0; i < s->r->samples; i++) {
        if (!whole_sample(s, i, &at)) continue;

        /* whether the tool was led back for another pass */
        const double time = value(s->r, WCUT_CHANNEL_TIME, i);
        const wcut_vec3 step = vec3_sub(at, last);
        const bool led_back = f.count > 0 && (vec3_length(step) > JUMP || vec3_dot(step, s->normal) < -BACK);

        /* a bin ends in time, or where the tool is led back */
        if (f.count > 0 && (led_back || time - f.begin >= WCUT_BLADE_BIN)) {
            close_bin(&f, led_back ? before : time, led_back ? last : at, c);
            f.count = 0;
        }
        c->passes += led_back;

        /* the sample belongs to the bin that is open, or opens one */
        if (f.count == 0) f = (filling){.begin = time, .start = at};
        f.count++, f.time += time;
        f.place = vec3_add(f.place, at), f.force = vec3_add(f.force, force_of(s, i));
        last = at, before = time;
    }

    /* the last bin ends with the recording */
    if (f.count > 1) close_bin(&f, before, last, c);
    c->passes++;
}

/* ---- what follows from them ---- */

/* what the sensor reads before the first contact, and what a bin's mean scatters by */
static void take_zero(samples *s, wcut_blade_cut *c) {
    double sum = 0, along = 0, square = 0;
    for (int b = 0; b < AIR_BINS; b++) sum += c->force[b] / AIR_BINS, along += c->along[b] / AIR_BINS;
    for (int b = 0; b < AIR_BINS; b++) square += (c->force[b] - sum) * (c->force[b] - sum);
    for (int b = 0; b < c->bins; b++) c->force[b] -= sum, c->along[b] -= along;
    c->noise = fmax(sqrt(square / (AIR_BINS - 1)), 1e-6);

    /* the same in the sensor's own axes */
    int count = 0;
    wcut_vec3 at;
    for (int i = 0; i < s->r->samples && count < AIR_BINS * 5; i++) {
        if (!whole_sample(s, i, &at)) continue;
        for (int k = 0; k < 3; k++) c->zero[k] += value(s->r, WCUT_CHANNEL_FORCE_X + k, i);
        count++;
    }
    for (int k = 0; k < 3; k++) c->zero[k] /= count > 0 ? count : 1;
}

/* how sliding follows the force: a straight line through the bins (slide against force) */
static void find_strategy(wcut_blade_cut *c) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    for (int b = 0; b < c->bins; b++) {
        if (!(c->advance[b] > 0)) continue;
        n++, x += c->force[b], y += c->slide[b];
        xx += c->force[b] * c->force[b], xy += c->force[b] * c->slide[b], yy += c->slide[b] * c->slide[b];
    }
    const double sxx = xx - x * x / fmax(n, 1), sxy = xy - x * y / fmax(n, 1), syy = yy - y * y / fmax(n, 1);
    if (!(sxx > 0) || n < 4) return;
    c->gain = sxy / sxx;
    c->gain_error = sqrt(fmax(syy - c->gain * sxy, 0) / (n - 2) / sxx);
}

static wcut_status find_levels(wcut_blade_cut *c) {
    double *sorted = wcut_copy(c->force, (size_t)c->bins, sizeof(double));
    if (!sorted) return WCUT_NO_MEMORY;
    wcut_sort(c->bins, sorted);
    c->max = sorted_quantile(c->bins, sorted, 0.95);
    wcut_free(sorted);

    /* sliding in air is what the plan has */
    double sum = 0;
    for (int b = 0; b < AIR_BINS; b++) sum += c->slide[b] / fmax(c->advance[b], 1e-6) / AIR_BINS;
    c->ratio = sum;

    return WCUT_OK;
}

/* station of a place: by the feed's direction from the first pose to the last */
static void find_stations(wcut_blade_cut *c) {
    const wcut_job *job = c->job;
    const wcut_vec3 first = job->tool[0].at, feed = vec3_sub(job->tool[job->stations - 1].at, first);
    const double square = vec3_dot(feed, feed);
    for (int b = 0; b < c->bins; b++)
        c->station[b] =
            square > 0 ? clamp(vec3_dot(vec3_sub(c->place[b], first), feed) / square, 0, 1) * (job->stations - 1) : 0;
}

wcut_status wcut_blade_cut_create(const wcut_diagnosis_cut *cut, wcut_blade_cut *out, wcut_error *error) {
    const wcut_recording *r = cut->recording;
    wcut_blade_cut c = {.job = cut->job};
    samples s = {.job = cut->job, .r = r};

    /* the edge, and across it */
    wcut_status status = find_edge(cut->job, &c, error);
    if (status == WCUT_OK && !integrate_speed(&s))
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a recording");
    if (status == WCUT_OK) status = find_normal(&s, &c, error);

    /* never more bins than samples */
    if (status == WCUT_OK && !make_blade_bins(r->samples + 1, &c))
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d samples", r->samples);
    if (status == WCUT_OK) fill_bins(&s, &c);
    if (status == WCUT_OK && c.bins < BINS_MIN)
        status = wcut_fail(error, WCUT_DEGENERATE, "found %d bins of %.1f s, expected %d or more", c.bins,
                           WCUT_BLADE_BIN, BINS_MIN);

    /* zero, strategy, stations */
    if (status == WCUT_OK) {
        take_zero(&s, &c);
        find_strategy(&c);
        find_stations(&c);
        status = find_levels(&c);
    }
    c.line.count = c.bins, c.line.place = c.place, c.line.pass = c.pass;
    wcut_free(s.way);
    if (status == WCUT_OK)
        *out = c;
    else
        wcut_blade_cut_destroy(&c);

    return status;
}
