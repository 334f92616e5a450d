/* A job in memory: its defaults, its end, another number of stations on the same path, and its programme. */
#include <math.h>
#include <wirecut/job.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

wcut_status wcut_job_create(wcut_job **job) {
    if (!job) return WCUT_BAD_ARGUMENT;
    wcut_job *made = wcut_alloc(1, sizeof *made);
    if (!made) return WCUT_NO_MEMORY;
    made->speed_max = 100;
    made->speed_min = 0.1;
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

/* both polylines at `count` equal steps of the mean way; the ends stay what they are, bit for bit */
static void sample_way(const wcut_job *job, const double *way, int count, wcut_vec3 *a, wcut_vec3 *b) {
    int m = job->stations, j = 0;
    for (int k = 0; k < count; k++) {
        double target = way[m - 1] * ((double)k / (count - 1));
        while (j < m - 2 && way[j + 1] <= target) j++;
        double t = way[j + 1] > way[j] ? (target - way[j]) / (way[j + 1] - way[j]) : 0;
        a[k] = vec3_mix(job->mount_a[j], job->mount_a[j + 1], t);
        b[k] = vec3_mix(job->mount_b[j], job->mount_b[j + 1], t);
    }
    a[count - 1] = job->mount_a[m - 1];
    b[count - 1] = job->mount_b[m - 1];
}

static wcut_status resample_path(wcut_job *job, int count) {
    int m = job->stations;
    if (m < 2 || !job->mount_a || !job->mount_b || !vec3_all_finite(m, job->mount_a) ||
        !vec3_all_finite(m, job->mount_b))
        return WCUT_BAD_ARGUMENT;
    double *way = wcut_alloc((size_t)m, sizeof *way);
    wcut_vec3 *a = wcut_alloc((size_t)count, sizeof *a);
    wcut_vec3 *b = wcut_alloc((size_t)count, sizeof *b);
    wcut_status status = WCUT_NO_MEMORY;

    /* sample both mount paths at even steps of the mean way */
    if (!way || !a || !b) goto done;
    measure_way(m, job->mount_a, job->mount_b, way);
    status = WCUT_BAD_ARGUMENT; /* a path that goes nowhere, or beyond the range of a double */
    if (!(way[m - 1] > 0) || !isfinite(way[m - 1])) goto done;
    sample_way(job, way, count, a, b);

    /* the new path takes the place of the old one */
    wcut_free(job->mount_a);
    wcut_free(job->mount_b);
    job->mount_a = a;
    job->mount_b = b;
    a = b = NULL;
    status = WCUT_OK;
done:
    wcut_free(way);
    wcut_free(a);
    wcut_free(b);
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
