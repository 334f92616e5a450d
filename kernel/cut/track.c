/* The track of a recording: when the mounts were where, smoothed, and never backwards. */
#include "cut/track.h"

#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* ---- smoothing ---- */

/* c0 of the parabola c0 + c1 u + c2 u^2 from the sums s[k] of u^k, r[k] of u^k y; false where it is undetermined */
static bool parabola_middle(const double s[5], const double r[3], double *c0) {
    /* Cholesky, the constant last: its coefficient comes out first */
    const double a = s[4], b = s[3] / a, c = s[2] / a;
    const double d = s[2] - b * s[3], e = s[1] - b * s[2];
    if (!(a > 0) || !(d > 1e-10 * s[2])) return false;
    const double f = s[0] - c * s[2] - e * e / d;
    if (!(f > 1e-10 * s[0])) return false;
    const double y1 = r[1] - b * r[2];
    *c0 = (r[0] - c * r[2] - e / d * y1) / f;
    return true;
}

void wcut_smooth(int n, const double *t, const double *y, double width, double *smooth) {
    const double half = width / 2 * (1 + 1e-9); /* a sample on the border is in, however its time was rounded */
    int first = 0, end = 0;
    for (int i = 0; i < n; i++) {
        while (t[i] - t[first] > half) first++;
        while (end < n && t[end] - t[i] <= half) end++;
        double s[5] = {0}, r[3] = {0}, middle;
        for (int j = first; j < end; j++) {
            const double u = (t[j] - t[i]) / half, u2 = u * u, value = y[j] - y[i];
            s[0] += 1, s[1] += u, s[2] += u2, s[3] += u2 * u, s[4] += u2 * u2;
            r[0] += value, r[1] += u * value, r[2] += u2 * value;
        }
        smooth[i] = end - first >= 4 && parabola_middle(s, r, &middle) ? y[i] + middle : y[i];
    }
}

/* ---- the path ---- */

/* the path's derivative at station j: half the chord of its neighbours, at most three times the shorter of the
   two chords that meet there, so that the path never runs backwards between stations (Fritsch, Carlson 1980) */
static wcut_vec3 tangent_at(int m, const wcut_vec3 *p, int j) {
    if (j == 0) return vec3_sub(p[1], p[0]);
    if (j == m - 1) return vec3_sub(p[m - 1], p[m - 2]);
    const wcut_vec3 v = vec3_scale(0.5, vec3_sub(p[j + 1], p[j - 1]));
    const double max = 3 * fmin(vec3_distance(p[j], p[j - 1]), vec3_distance(p[j + 1], p[j])), length = vec3_length(v);
    return length > max ? vec3_scale(max / length, v) : v;
}

wcut_vec3 wcut_path_at(int m, const wcut_vec3 *p, double station) {
    const int j = (int)clamp(floor(station), 0, m - 2);
    const double t = clamp(station - j, 0, 1), s = 1 - t;
    const wcut_vec3 a = tangent_at(m, p, j), b = tangent_at(m, p, j + 1);
    const wcut_vec3 way = vec3_sub(p[j + 1], p[j]);
    /* Hermite's cubic, as what it adds to its first point: equal points stay equal to the last digit */
    wcut_vec3 x = vec3_add_scaled(p[j], t * t * (3 - 2 * t), way);
    x = vec3_add_scaled(x, t * s * s, a);
    return vec3_add_scaled(x, -t * t * s, b);
}

/* ---- the recording ---- */

static bool track_has(const wcut_column *c, int i) { return !c->present || c->present[i]; }

wcut_status wcut_track_check(int stations, const wcut_recording *recording, wcut_error *error) {
    /* the channels of two arms, with their stations */
    for (int k = WCUT_CHANNEL_TIME; k <= WCUT_CHANNEL_BETA_B; k++)
        if (!recording->channel[k].value)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "found a recording without %s, expected one of two arms%s",
                             wcut_channel_name((wcut_channel)k),
                             k == WCUT_CHANNEL_STATION ? " with stations (wcut_recording_place)" : "");

    /* stations on the path, forward */
    const wcut_column *station = &recording->channel[WCUT_CHANNEL_STATION];
    const int *line = recording->further->line;
    double furthest = -HUGE_VAL;

    /* stations must lie on the path and go forward, but for jitter of one station */
    for (int i = 0; i < recording->samples; i++) {
        const double s = station->value[i];
        if (!track_has(station, i)) continue;
        if (!(s >= -1 && s <= stations))
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "line %d: station: found %.6g, expected 0 .. %d of the job's path", line[i], s,
                             stations - 1);
        if (s < furthest - 1)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "line %d: station: found %.6g after %.6g, expected no more than one station back", line[i],
                             s, furthest);
        furthest = fmax(furthest, s);
    }
    if (furthest > -HUGE_VAL) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT,
                     "station: found no sample of it, expected the mounts' way along the path");
}

/* the samples whose motion is there; gives how many */
static int gather_samples(const wcut_recording *recording, int channels, const wcut_channel *channel, int *sample,
                          double *time) {
    int count = 0;
    for (int i = 0; i < recording->samples; i++) {
        bool whole = true;
        for (int k = 0; k < channels; k++) whole = whole && track_has(&recording->channel[channel[k]], i);
        if (!whole) continue;
        sample[count] = i;
        time[count++] = recording->channel[WCUT_CHANNEL_TIME].value[i];
    }
    return count;
}

/* a channel at the track's samples, smoothed into `to`; `raw` is room for count; gives the sum of squares taken away */
static double smooth_channel(const wcut_recording *recording, wcut_channel channel, const wcut_track *track,
                             double width, double *raw, double *to) {
    double taken = 0;
    for (int i = 0; i < track->count; i++) raw[i] = recording->channel[channel].value[track->sample[i]];
    if (!(width > 0)) {
        memcpy(to, raw, sizeof *to * (size_t)track->count);
        return 0;
    }
    wcut_smooth(track->count, track->time, raw, width, to);
    for (int i = 0; i < track->count; i++) taken += (raw[i] - to[i]) * (raw[i] - to[i]);
    return taken;
}

/* behind the wire is its kerf: a mount that seems to go back, by the encoder's noise, stands */
static void keep_forward(const wcut_job *job, wcut_track *track) {
    double furthest = 0;
    for (int i = 0; i < track->count; i++) {
        furthest = clamp(track->station[i], furthest, job->stations - 1);
        track->station[i] = furthest;
    }
}

static void fill_track(const wcut_job *job, const wcut_recording *recording, const wcut_replay_options *o, double *room,
                       wcut_track *track) {
    /* progress along the path, smoothed and never backwards */
    double *raw = room, *smooth = room + track->count;
    double taken = smooth_channel(recording, WCUT_CHANNEL_STATION, track, o->window, raw, track->station);
    keep_forward(job, track);

    /* mounts on the path at that progress */
    for (int i = 0; i < track->count && o->motion == WCUT_MOTION_STATION; i++) {
        track->mount_a[i] = wcut_path_at(job->stations, job->mount_a, track->station[i]);
        track->mount_b[i] = wcut_path_at(job->stations, job->mount_b, track->station[i]);
    }

    /* or mounts as measured, each coordinate smoothed by itself */
    if (o->motion == WCUT_MOTION_POSITION) {
        taken = 0;
        for (int k = 0; k < 6; k++) {
            taken += smooth_channel(recording, (wcut_channel)(WCUT_CHANNEL_A_X + k), track, o->window, raw, smooth) / 6;
            wcut_vec3 *mount = k < 3 ? track->mount_a : track->mount_b;
            for (int i = 0; i < track->count; i++)
                *(k % 3 == 0 ? &mount[i].x : k % 3 == 1 ? &mount[i].y : &mount[i].z) = smooth[i];
        }
    }

    /* what smoothing took away, as a root mean square */
    track->scatter = sqrt(taken / track->count);
}

static wcut_status check_track(const wcut_job *job, const wcut_recording *recording, const wcut_replay_options *o,
                               wcut_error *error) {
    if (job->mode != WCUT_MODE_PATH)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "found a design, expected a job with the mounts' path");
    for (int k = 0; k < 6 && o->motion == WCUT_MOTION_POSITION; k++) {
        const wcut_channel channel = (wcut_channel)(WCUT_CHANNEL_A_X + k);
        if (!recording->channel[channel].name)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "found no column %s, expected the measured positions of mounts",
                             wcut_channel_name(channel));
    }
    return wcut_track_check(job->stations, recording, error);
}

wcut_status wcut_track_create(const wcut_job *job, const wcut_recording *recording, const wcut_replay_options *o,
                              wcut_track *out, wcut_error *error) {
    static const wcut_channel channel[] = {WCUT_CHANNEL_STATION, WCUT_CHANNEL_A_X, WCUT_CHANNEL_A_Y, WCUT_CHANNEL_A_Z,
                                           WCUT_CHANNEL_B_X,     WCUT_CHANNEL_B_Y, WCUT_CHANNEL_B_Z};
    const wcut_status status = check_track(job, recording, o, error);
    if (status != WCUT_OK) return status;

    /* room for all samples, though fewer may count */
    const size_t n = (size_t)recording->samples;
    wcut_track track = {0};
    double *room = wcut_alloc(2 * n, sizeof *room);
    track.sample = wcut_alloc(n, sizeof *track.sample);
    track.time = wcut_alloc(n, sizeof *track.time);
    track.station = wcut_alloc(n, sizeof *track.station);
    track.mount_a = wcut_alloc(n, sizeof *track.mount_a);
    track.mount_b = wcut_alloc(n, sizeof *track.mount_b);
    wcut_status made = WCUT_OK;
    if (!room || !track.sample || !track.time || !track.station || !track.mount_a || !track.mount_b) {
        made = wcut_fail(error, WCUT_NO_MEMORY, "no memory for the motion of %d samples", recording->samples);
    } else {
        /* samples that have all channels which the motion needs */
        track.count =
            gather_samples(recording, o->motion == WCUT_MOTION_POSITION ? 7 : 1, channel, track.sample, track.time);
        if (track.count > 0)
            fill_track(job, recording, o, room, &track);
        else
            made = wcut_fail(error, WCUT_BAD_ARGUMENT, "found no sample with a station and a measured position");
    }
    wcut_free(room);
    if (made == WCUT_OK)
        *out = track;
    else
        wcut_track_destroy(&track);

    return made;
}

void wcut_track_destroy(wcut_track *track) {
    wcut_free(track->sample);
    wcut_free(track->time);
    wcut_free(track->station);
    wcut_free(track->mount_a);
    wcut_free(track->mount_b);
    *track = (wcut_track){0};
}
