/* A job in memory: its defaults, its end, another number of stations on the same path, and its programme. */
#include <math.h>
#include <wirecut/job.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/job_rig.h"

wcut_status wcut_job_create(wcut_job **job) {
    if (!job) return WCUT_BAD_ARGUMENT;
    wcut_job *made = wcut_alloc(1, sizeof *made);
    if (!made) return WCUT_NO_MEMORY;
    made->speed_max = 100;
    made->speed_min = 0.1;
    made->rig.stiffness = INFINITY;
    made->rig.expansion = -1;
    made->name = wcut_copy_text("");
    if (!made->name) {
        wcut_free(made);
        return WCUT_NO_MEMORY;
    }
    *job = made;
    return WCUT_OK;
}

void wcut_job_destroy(wcut_job *job) {
    if (!job) return;
    wcut_free(job->name);
    wcut_free(job->foam_material);
    wcut_free(job->wire_material);
    wcut_free(job->mount_a);
    wcut_free(job->mount_b);
    wcut_free(job->tool);
    wcut_free(job->feed.speed);
    wcut_free(job->feed.time);
    wcut_curve_destroy(job->edge_a);
    wcut_curve_destroy(job->edge_b);
    wcut_free(job->extra_u);
    wcut_free(job->extra_length);
    wcut_free(job->dither);
    wcut_free(job->heat_step);
    wcut_free(job->effect);
    wcut_free(job);
}

/* mean of both mounts' ways up to every station [mm] */
static void measure_way(int m, const wcut_vec3 *a, const wcut_vec3 *b, double *way) {
    way[0] = 0;
    for (int j = 1; j < m; j++)
        way[j] = way[j - 1] + 0.5 * (vec3_distance(a[j - 1], a[j]) + vec3_distance(b[j - 1], b[j]));
}

/* a path with another number of stations */
typedef struct sampled_path {
    wcut_vec3 *a, *b;
    wcut_pose *tool; /* where the job has one */
    double *speed;   /* where the job has one a station */
} sampled_path;

/* Both polylines at `count` equal steps of the mean way; the ends stay what they are, bit for bit. The speed of a step is
   that of the given step in which its middle is. */
static void sample_way(const wcut_job *job, const double *way, int count, const sampled_path *to) {
    int m = job->stations, j = 0, at = 0;
    for (int k = 0; k < count; k++) {
        double target = way[m - 1] * ((double)k / (count - 1)), middle = way[m - 1] * ((k - 0.5) / (count - 1));
        while (j < m - 2 && way[j + 1] <= target) j++;
        while (at < m - 2 && way[at + 1] <= middle) at++;
        double t = way[j + 1] > way[j] ? (target - way[j]) / (way[j + 1] - way[j]) : 0;
        to->a[k] = vec3_mix(job->mount_a[j], job->mount_a[j + 1], t);
        to->b[k] = vec3_mix(job->mount_b[j], job->mount_b[j + 1], t);

        /* a tool's mounts are where its pose has them, not on the chord between two stations */
        if (to->speed) to->speed[k] = job->feed.speed[k == 0 ? 0 : at + 1];
        if (!to->tool) continue;
        to->tool[k] = wcut_pose_mix(&job->tool[j], &job->tool[j + 1], t);
        to->a[k] = wcut_pose_point(&to->tool[k], job->mount_a_in_tool);
        to->b[k] = wcut_pose_point(&to->tool[k], job->mount_b_in_tool);
    }

    /* the last station, exactly */
    to->a[count - 1] = job->mount_a[m - 1];
    to->b[count - 1] = job->mount_b[m - 1];
    if (to->tool) to->tool[count - 1] = job->tool[m - 1];
}

static wcut_status resample_path(wcut_job *job, int count) {
    int m = job->stations;
    if (m < 2 || !job->mount_a || !job->mount_b || !vec3_all_finite(m, job->mount_a) ||
        !vec3_all_finite(m, job->mount_b))
        return WCUT_BAD_ARGUMENT;
    const bool paced = job->feed.kind == WCUT_FEED_KIND_STATIONS;
    if (paced && (job->feed.count != m || !job->feed.speed)) return WCUT_BAD_ARGUMENT;
    double *way = wcut_alloc((size_t)m, sizeof *way);
    sampled_path to = {.a = wcut_alloc((size_t)count, sizeof *to.a), .b = wcut_alloc((size_t)count, sizeof *to.b)};
    if (job->tool) to.tool = wcut_alloc((size_t)count, sizeof *to.tool);
    if (paced) to.speed = wcut_alloc((size_t)count, sizeof *to.speed);
    wcut_status status = WCUT_NO_MEMORY;

    /* sample both mount paths at even steps of the mean way */
    if (!way || !to.a || !to.b || (job->tool && !to.tool) || (paced && !to.speed)) goto done;
    measure_way(m, job->mount_a, job->mount_b, way);
    status = WCUT_BAD_ARGUMENT; /* a path that goes nowhere, or beyond the range of a double */
    if (!(way[m - 1] > 0) || !isfinite(way[m - 1])) goto done;
    sample_way(job, way, count, &to);

    /* the new path takes the place of the old one, which is freed below */
    const sampled_path old = {job->mount_a, job->mount_b, job->tool, paced ? job->feed.speed : NULL};
    job->mount_a = to.a, job->mount_b = to.b, job->tool = to.tool;
    if (paced) job->feed.speed = to.speed, job->feed.count = count;
    to = old;
    status = WCUT_OK;
done:
    wcut_free(way);
    wcut_free(to.a);
    wcut_free(to.b);
    wcut_free(to.tool);
    wcut_free(to.speed);
    return status;
}

wcut_status wcut_job_resample(wcut_job *job, int stations) {
    if (!job || stations < 2 || job->stations < 0) return WCUT_BAD_ARGUMENT;
    wcut_status status = job->mode == WCUT_MODE_PATH ? resample_path(job, stations) : WCUT_OK;
    if (status == WCUT_OK) job->stations = stations;
    return status;
}

/* ---- the programme ---- */

double wcut_job_heat_eval(const wcut_job *job, double time) {
    double heat = job->heat;
    for (int k = 0; job->heat_step && k < job->heat_step_count; k++)
        if (time >= job->heat_step[k].from && time < job->heat_step[k].to) heat *= job->heat_step[k].factor;
    return heat;
}

double wcut_job_pace_eval(const wcut_job *job, double time) {
    double pace = 1;
    for (int k = 0; job->dither && k < job->dither_count; k++)
        pace += job->dither[k].amplitude * sin(2 * WCUT_PI * time / job->dither[k].period + job->dither[k].phase);
    return pace;
}
