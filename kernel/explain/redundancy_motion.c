/* Whether stations, speeds and measured places tell of one motion, and whether the mounts are on their path. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/track.h"
#include "explain/redundancy.h"

/* [1] a scale that is off by more is no chance: labelled cases have 0.0014 at most by their speeds, 2e-4 by their places */
#define SCALE_MAX 0.0025
/* [1] the least standard error of a scale by one speed, by one mount's places */
#define SPEED_ERROR 1e-3
#define PLACE_ERROR 3e-4
/* [mm] a mean place beside the path: smooth misplacement of a robot is a third of it */
#define BESIDE_MAX 1.0
/* stations between two that way is summed over, for paths with few of them */
enum { PARTS = 4, SAMPLES_MIN = 20 };

/* stations over the truth, by one way of measuring: mean over cuts and mounts with its error */
typedef struct scale {
    int count;
    double sum, square, mean, error;
} scale;

static void scale_add(scale *s, double value) { s->count++, s->sum += value, s->square += value * value; }

static void scale_end(scale *s, double least) {
    if (s->count == 0) return;
    s->mean = s->sum / s->count;
    const double variance = s->count > 1 ? fmax(s->square - s->sum * s->mean, 0) / (s->count - 1) : 0;
    s->error = sqrt(fmax(variance, least * least) / s->count);
}

static bool scale_is_off(const scale *s) {
    return s->count > 0 && fabs(s->mean - 1) > SCALE_MAX && fabs(s->mean - 1) > 4 * s->error;
}

static wcut_vec3 place_of(const wcut_job *job, int mount, double station) {
    return wcut_path_at(job->stations, mount ? job->mount_b : job->mount_a, clamp(station, 0, job->stations - 1));
}

/* [mm] way of a mount from one station to another along its path */
static double way_between(const wcut_job *job, int mount, double from, double to) {
    const int parts = (int)fmax(ceil(PARTS * fabs(to - from)), 1);
    wcut_vec3 last = place_of(job, mount, from);
    double way = 0;
    for (int k = 1; k <= parts; k++) {
        const wcut_vec3 next = place_of(job, mount, from + (to - from) * k / parts);
        way += vec3_distance(next, last);
        last = next;
    }
    return way;
}

/* way by stations over the integral of a mount's speed, both from the first to the last sample with all of it */
static void add_speed(const wcut_job *job, const wcut_recording *r, int mount, scale *out) {
    const wcut_channel channel = mount ? WCUT_CHANNEL_SPEED_B : WCUT_CHANNEL_SPEED_A;
    double from = 0, to = 0, sum = 0, last_time = 0, last_speed = 0;
    int count = 0;
    for (int i = 0; i < r->samples; i++) {
        double time, station, speed;
        if (!wcut_sample_at(r, WCUT_CHANNEL_TIME, i, &time) || !wcut_sample_at(r, WCUT_CHANNEL_STATION, i, &station) ||
            !wcut_sample_at(r, channel, i, &speed) || station < 0 || station > job->stations - 1)
            continue;
        if (count++ == 0)
            from = station;
        else
            sum += (speed + last_speed) / 2 * (time - last_time);
        to = station, last_time = time, last_speed = speed;
    }
    if (count < SAMPLES_MIN || !(sum > 0) || !(to > from)) return;
    scale_add(out, way_between(job, mount, from, to) / sum);
}

/* sums of a line through (way, measured place less the path's along it), and of the place beside the path */
typedef struct placing {
    double n, w, e, ww, we;
    wcut_vec3 beside;
} placing;

static bool measured_place(const wcut_recording *r, int mount, int i, wcut_vec3 *p) {
    const int first = mount ? WCUT_CHANNEL_B_X : WCUT_CHANNEL_A_X;
    return wcut_sample_at(r, (wcut_channel)first, i, &p->x) && wcut_sample_at(r, (wcut_channel)(first + 1), i, &p->y) &&
           wcut_sample_at(r, (wcut_channel)(first + 2), i, &p->z);
}

static placing placing_of(const wcut_job *job, const wcut_recording *r, int mount) {
    placing s = {0};
    double way = 0, last = 0;
    const double end = job->stations - 1;
    for (int i = 0; i < r->samples; i++) {
        double station;
        wcut_vec3 p;
        if (!wcut_sample_at(r, WCUT_CHANNEL_STATION, i, &station) || !measured_place(r, mount, i, &p)) continue;

        /* way along the path, with the sign of the motion */
        if (station < 0 || station > end) continue;
        if (s.n > 0) way += copysign(way_between(job, mount, last, station), station - last);
        last = station;

        /* along the path and beside it */
        const wcut_vec3 tangent = vec3_unit(
            vec3_sub(place_of(job, mount, fmin(station + 0.5, end)), place_of(job, mount, fmax(station - 0.5, 0))));
        const wcut_vec3 off = vec3_sub(p, place_of(job, mount, station));
        const double along = vec3_dot(off, tangent);
        s.n++, s.w += way, s.e += along, s.ww += way * way, s.we += way * along;
        s.beside = vec3_add(s.beside, off);
    }
    if (s.n > 0) s.beside = vec3_scale(1 / s.n, s.beside);
    return s;
}

/* stations over the truth by the places of a mount: off along the path = (1 / scale - 1) way */
static void add_places(const placing *s, scale *out) {
    const double square = s->ww - s->w * s->w / fmax(s->n, 1);
    if (s->n < SAMPLES_MIN || !(square > 0)) return;
    scale_add(out, 1 / (1 + (s->we - s->w * s->e / s->n) / square));
}

/* ---- what is said ---- */

static void tell_scale(wcut_contradiction *c, const scale *s, const char *by) {
    c->found = s->mean, c->expected = 1, c->error = s->error, c->fault = true, c->common = true;
    snprintf(c->unit, sizeof c->unit, "share");
    snprintf(c->text, sizeof c->text, "%s reads %.2f +- %.2f %% %s than %s.%s", c->column, 100 * fabs(s->mean - 1),
             196 * s->error, s->mean > 1 ? "more" : "less", by, c->repaired ? " The diagnosis corrects it." : "");
}

static wcut_status rescale_stations(wcut_redundancy *all, double by) {
    for (int cut = 0; cut < all->cuts; cut++) {
        if (!wcut_redundancy_has(all, cut)) continue;
        double *station = wcut_redundancy_column(all, cut, WCUT_CHANNEL_STATION);
        if (!station) return WCUT_NO_MEMORY;
        for (int i = 0; i < all->recording[cut].samples; i++) station[i] /= by;
    }
    return WCUT_OK;
}

/* two that agree against the third: stations, speeds, places */
static wcut_status judge(wcut_redundancy *all, const scale *speed, const scale *place) {
    const bool by_speed = scale_is_off(speed), by_place = scale_is_off(place);
    const double apart = fabs(speed->mean - place->mean);
    const bool alike = by_speed && by_place && apart < SCALE_MAX + 4 * hypot(speed->error, place->error);
    const bool stations = alike || (by_speed && place->count == 0);

    /* the column that the two others contradict */
    if (!by_speed && !by_place) return WCUT_OK;
    const char *column = stations ? "station" : by_place ? "a_x_mm .. b_z_mm" : "speed_a_mm_s, speed_b_mm_s";
    wcut_contradiction *c = wcut_contradiction_add(all,
                                                   stations   ? WCUT_CONTRADICTION_STATION
                                                   : by_place ? WCUT_CONTRADICTION_PLACES
                                                              : WCUT_CONTRADICTION_SPEED,
                                                   column);
    if (!c) return WCUT_OK;
    for (int cut = 0; cut < all->cuts; cut++)
        if (wcut_redundancy_has(all, cut)) wcut_contradiction_add_cut(c, cut);

    /* stations are what the mounts are driven by: they alone need to be set right */
    c->repaired = stations;
    scale other = by_place ? *place : *speed;
    if (!stations) other.mean = 1 / other.mean;
    tell_scale(c, &other,
               alike                  ? "the speeds and the measured places of both mounts"
               : stations             ? "the speeds of both mounts over time_s"
               : by_place && by_speed ? "the stations, and the speeds contradict both"
               : by_place             ? "the stations and the speeds"
                                      : "the stations and the measured places (or time_s has this error)");
    return stations ? rescale_stations(all, other.mean) : WCUT_OK;
}

/* a mount whose measured places are beside its path in the mean, cut by cut */
static void find_beside(wcut_redundancy *all, int mount, const wcut_vec3 *beside) {
    wcut_contradiction *c = NULL;
    wcut_vec3 sum = {0, 0, 0};
    char column[] = "a_x_mm .. a_z_mm", cuts[WCUT_CUT_LIST];
    if (mount) column[0] = column[10] = 'b';

    /* cuts in which the mount is farther from its path than a rig's scatter */
    for (int cut = 0; cut < all->cuts; cut++) {
        if (!(vec3_length(beside[cut]) > BESIDE_MAX)) continue;
        if (!c) c = wcut_contradiction_add(all, WCUT_CONTRADICTION_PLACES, column);
        if (!c) return;
        wcut_contradiction_add_cut(c, cut);
        sum = vec3_add(sum, beside[cut]);
    }
    if (!c) return;

    /* the mean offset over these cuts */
    sum = vec3_scale(1.0 / c->cuts, sum);
    c->found = vec3_length(sum), c->fault = true;
    snprintf(c->unit, sizeof c->unit, "mm");
    wcut_cut_list(all, c, cuts);
    snprintf(c->text, sizeof c->text,
             "Mount %c is beside its path in %s by its measured places: x %+.1f, y %+.1f, z %+.1f mm on average. The "
             "diagnosis assumes the path.",
             mount ? 'B' : 'A', cuts, sum.x, sum.y, sum.z);
}

wcut_status wcut_motion_compare(wcut_redundancy *all) {
    scale speed = {0}, place = {0};
    wcut_vec3 *beside = wcut_alloc(2 * (size_t)all->cuts, sizeof *beside);
    if (!beside) return WCUT_NO_MEMORY;

    /* of each cut and mount: speeds over stations, measured positions over the path */
    for (int cut = 0; cut < all->cuts; cut++)
        for (int mount = 0; mount < 2 && wcut_redundancy_has(all, cut); mount++) {
            const wcut_job *job = all->cut[cut].job;
            const wcut_recording *r = all->cut[cut].recording;
            const placing s = placing_of(job, r, mount);
            add_speed(job, r, mount, &speed);
            add_places(&s, &place);
            if (s.n >= SAMPLES_MIN) beside[mount * all->cuts + cut] = s.beside;
        }

    /* means and standard errors over the cuts, then the verdict */
    scale_end(&speed, SPEED_ERROR);
    scale_end(&place, PLACE_ERROR);
    const wcut_status status = judge(all, &speed, &place);

    /* a scale moves the mean too: it is said once */
    if (status == WCUT_OK && !scale_is_off(&place))
        for (int mount = 0; mount < 2; mount++) find_beside(all, mount, beside + (ptrdiff_t)mount * all->cuts);
    wcut_free(beside);
    return status;
}
