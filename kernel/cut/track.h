/* The track of a recording: when the mounts were where, smoothed, and never backwards. */
#ifndef WCUT_CUT_TRACK_H
#define WCUT_CUT_TRACK_H

#include <wirecut/replay.h>

typedef struct wcut_track {
    int count;                    /* samples whose motion is there, at least 1 */
    int *sample;                  /* count: which of the recording */
    double *time;                 /* count [s] */
    double *station;              /* count, in 0 .. stations-1, not decreasing */
    wcut_vec3 *mount_a, *mount_b; /* count [mm] */
    double scatter;               /* [1, or mm of measured positions] RMS of what smoothing took away */
} wcut_track;

/* WCUT_OK where every recorded station lies on a path of so many stations, by one outside at most, and none is more
   than one behind those before it; else WCUT_BAD_ARGUMENT with the line */
wcut_status wcut_track_check(int stations, const wcut_recording *recording, wcut_error *error);

/* the track on a job's path; WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written */
wcut_status wcut_track_create(const wcut_job *job, const wcut_recording *recording, const wcut_replay_options *o,
                              wcut_track *out, wcut_error *error);
void wcut_track_destroy(wcut_track *track);

/* A point of the smooth path through m >= 2 points, at a real-valued station in 0 .. m-1: a cubic between every two
   (Catmull, Rom 1974). The mounts move on curves: with chords between stations their direction would jump at each. */
wcut_vec3 wcut_path_at(int m, const wcut_vec3 *point, double station);

/* The local parabola of least squares over [t_i - width/2, t_i + width/2], at every t_i (Savitzky, Golay 1964, for
   uneven sampling). Where fewer than four samples, or too close a bunch of them, leave it undetermined, y as it is.
   t: n, increasing; width > 0. */
void wcut_smooth(int n, const double *t, const double *y, double width, double *smooth);

#endif
