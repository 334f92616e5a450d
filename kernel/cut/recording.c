/* Recordings beside their job: which rig they are of, and at which station each sample is where the file does not say. */
#include <wirecut/recording.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* mounts come no further from sample to sample than this many times the way they moved, and this much [mm] */
#define AHEAD 3.0
#define AHEAD_MM 20.0

bool wcut_recording_has_force(const wcut_recording *recording) {
    return recording && recording->channel[WCUT_CHANNEL_FORCE_X].name;
}

static bool has_place(const wcut_recording *r, int i) {
    for (int k = WCUT_CHANNEL_A_X; k <= WCUT_CHANNEL_B_Z; k++)
        if (r->channel[k].present && !r->channel[k].present[i]) return false;
    return true;
}

static wcut_vec3 mount_place(const wcut_recording *r, int channel, int i) {
    return vec3(r->channel[channel].value[i], r->channel[channel + 1].value[i], r->channel[channel + 2].value[i]);
}

/* squared distance of both mounts from the chords of a segment, and where on it */
static double distance_from_step(const wcut_job *job, int j, wcut_vec3 a, wcut_vec3 b, double *share) {
    const wcut_vec3 da = vec3_sub(job->mount_a[j + 1], job->mount_a[j]);
    const wcut_vec3 db = vec3_sub(job->mount_b[j + 1], job->mount_b[j]);
    const wcut_vec3 ea = vec3_sub(a, job->mount_a[j]), eb = vec3_sub(b, job->mount_b[j]);
    const double square = vec3_dot(da, da) + vec3_dot(db, db);
    *share = square > 0 ? clamp((vec3_dot(ea, da) + vec3_dot(eb, db)) / square, 0, 1) : 0;
    const wcut_vec3 ra = vec3_add_scaled(ea, -*share, da), rb = vec3_add_scaled(eb, -*share, db);
    return vec3_dot(ra, ra) + vec3_dot(rb, rb);
}

/* the way of the faster mount over a segment [mm] */
static double segment_way(const wcut_job *job, int j) {
    return fmax(vec3_distance(job->mount_a[j], job->mount_a[j + 1]),
                vec3_distance(job->mount_b[j], job->mount_b[j + 1]));
}

/* the nearest place of the path from one station behind the last one, as far ahead as the mounts can have come */
static double next_station(const wcut_job *job, double last, double reach, wcut_vec3 a, wcut_vec3 b) {
    double best = HUGE_VAL, station = last, way = 0;
    for (int j = (int)fmax(last - 1, 0); j < job->stations - 1 && way <= reach; j++) {
        double share;
        const double distance = distance_from_step(job, j, a, b, &share);
        if (distance < best) best = distance, station = j + share;
        if (j >= (int)last) way += segment_way(job, j);
    }
    return station;
}

wcut_status wcut_recording_place(const wcut_job *job, wcut_recording *recording, wcut_error *error) {
    if (!job || !recording || recording->samples < 1 || job->mode != WCUT_MODE_PATH || !job->mount_a || !job->mount_b ||
        job->stations < 2)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a job with the mounts' path and a recording are expected");

    /* only a recording of mounts without the channel gets one */
    wcut_column *station = &recording->channel[WCUT_CHANNEL_STATION];
    if (station->name || wcut_recording_has_force(recording)) return WCUT_OK;
    for (int k = WCUT_CHANNEL_A_X; k <= WCUT_CHANNEL_B_Z; k++)
        if (!recording->channel[k].name)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "a recording without station: expected %s",
                             wcut_channel_name((wcut_channel)k));

    /* a column like those that were read */
    const size_t n = (size_t)recording->samples;
    wcut_column made = {
        .name = wcut_copy_text("station"), .value = wcut_alloc(n, sizeof(double)), .present = wcut_alloc(n, 1)};
    if (!made.name || !made.value || !made.present) {
        wcut_free(made.name), wcut_free(made.value), wcut_free(made.present);
        return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d samples", recording->samples);
    }

    /* the first sample may be anywhere, each later one ahead of the one before it */
    double last = 0;
    int before = -1;
    for (int i = 0; i < recording->samples; i++) {
        made.present[i] = has_place(recording, i);
        if (!made.present[i]) {
            made.missing++;
            continue;
        }

        /* reach: as far as the mounts can have come since the last place */
        const wcut_vec3 a = mount_place(recording, WCUT_CHANNEL_A_X, i),
                        b = mount_place(recording, WCUT_CHANNEL_B_X, i);
        const double moved = before < 0 ? HUGE_VAL
                                        : fmax(vec3_distance(a, mount_place(recording, WCUT_CHANNEL_A_X, before)),
                                               vec3_distance(b, mount_place(recording, WCUT_CHANNEL_B_X, before)));
        last = made.value[i] = next_station(job, last, AHEAD * moved + AHEAD_MM, a, b);
        before = i;
    }
    *station = made;

    return WCUT_OK;
}
