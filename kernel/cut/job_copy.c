/* A deep copy of a job. */
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "cut/setup.h"

static bool copy_job_text(const char *from, char **to) {
    if (!from) return true;
    return (*to = wcut_copy_text(from)) != NULL;
}

static bool copy_array(const void *from, int count, size_t size, void **to) {
    if (!from) return true;
    return (*to = wcut_copy(from, (size_t)count, size)) != NULL;
}

static bool copy_curve(const wcut_curve *c, wcut_curve **to) {
    return !c || wcut_curve_create(c->degree, c->control_count, c->knots, c->control, c->weights, to) == WCUT_OK;
}

wcut_job *wcut_job_copy(const wcut_job *job) {
    wcut_job *copy = wcut_copy(job, 1, sizeof *job);
    if (!copy) return NULL;

    /* pointers of the original are not the copy's: clear them, so that destroy is safe at any point */
    copy->name = copy->foam_material = copy->wire_material = NULL;
    copy->mount_a = copy->mount_b = NULL;
    copy->tool = NULL;
    copy->feed.speed = copy->feed.time = NULL;
    copy->edge_a = copy->edge_b = NULL;
    copy->extra_u = copy->extra_length = NULL;
    copy->dither = NULL;
    copy->heat_step = NULL;
    copy->effect = NULL;

    /* copy what each points to */
    const bool whole =
        copy_job_text(job->name, &copy->name) && copy_job_text(job->foam_material, &copy->foam_material) &&
        copy_job_text(job->wire_material, &copy->wire_material) &&
        copy_array(job->mount_a, job->stations, sizeof *job->mount_a, (void **)&copy->mount_a) &&
        copy_array(job->mount_b, job->stations, sizeof *job->mount_b, (void **)&copy->mount_b) &&
        copy_array(job->tool, job->stations, sizeof *job->tool, (void **)&copy->tool) &&
        copy_array(job->feed.speed, job->feed.count, sizeof(double), (void **)&copy->feed.speed) &&
        copy_array(job->feed.time, job->feed.count, sizeof(double), (void **)&copy->feed.time) &&
        copy_curve(job->edge_a, &copy->edge_a) && copy_curve(job->edge_b, &copy->edge_b) &&
        copy_array(job->extra_u, job->extra_count, sizeof(double), (void **)&copy->extra_u) &&
        copy_array(job->extra_length, job->extra_count, sizeof(double), (void **)&copy->extra_length) &&
        copy_array(job->dither, job->dither_count, sizeof *job->dither, (void **)&copy->dither) &&
        copy_array(job->heat_step, job->heat_step_count, sizeof *job->heat_step, (void **)&copy->heat_step) &&
        copy_array(job->effect, job->effect_count, sizeof *job->effect, (void **)&copy->effect);
    if (whole) return copy;

    wcut_job_destroy(copy);
    return NULL;
}

void wcut_job_reverse(wcut_job *job) {
    for (int i = 0, j = job->stations - 1; i < j; i++, j--) {
        const wcut_vec3 a = job->mount_a[i], b = job->mount_b[i];
        job->mount_a[i] = job->mount_a[j], job->mount_b[i] = job->mount_b[j];
        job->mount_a[j] = a, job->mount_b[j] = b;
        if (!job->tool) continue;
        const wcut_pose tool = job->tool[i];
        job->tool[i] = job->tool[j];
        job->tool[j] = tool;
    }

    /* the speed of a step is that of the station at its other end */
    double *speed = job->feed.kind == WCUT_FEED_KIND_STATIONS ? job->feed.speed : NULL;
    for (int i = 1, j = job->stations - 1; speed && i < j; i++, j--) {
        const double v = speed[i];
        speed[i] = speed[j], speed[j] = v;
    }
}

bool wcut_job_name(wcut_job *job, const char *behind) {
    const char *name = job->name ? job->name : "cut";
    const size_t size = strlen(name) + strlen(behind) + 1;
    char *text = wcut_alloc(size, 1);
    if (!text) return false;
    snprintf(text, size, "%s%s", name, behind);
    wcut_free(job->name);
    job->name = text;
    return true;
}
