/* "wirecut-job/1" in: a table a JSON object, each key with its unit, its range and its place in the job. */
#include "io/process/job.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <wirecut/job_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/json_read.h"
#include "io/file/read_file.h"
#include "io/process/curve_json.h"
#include "io/process/effect_json.h"
#include "io/process/rig_json.h"

#define FORMAT "wirecut-job/1"
enum { POINTS_MAX = WCUT_JOB_STATIONS_MAX, PROGRAMME_MAX = 10000 };

#define READ_OBJECT(fields, into) wcut_read_object(reader, at, fields, (int)(sizeof(fields) / sizeof *(fields)), into)
#define IN(type, member, key, required, read) \
    { key, required, read, offsetof(type, member) }
#define IN_JOB(member, key, required, read) IN(wcut_job, member, key, required, read)
#define PART(key, required, read) \
    { key, required, read, 0 } /* an object that fills several members of the job */

/* ---- block, wire, process ---- */

static bool read_block_size(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_vec3 size;
    if (!wcut_read_point(reader, at, &size)) return false;
    double edge[3] = {size.x, size.y, size.z};
    for (size_t k = 0; k < 3; k++) {
        wcut_place place = {at, NULL, k, json_array_get(at->value, k)};
        if (!wcut_read_positive(reader, &place, &edge[k])) return false;
    }
    *(wcut_vec3 *)into = size;
    return true;
}

static bool read_block(wcut_reader *reader, const wcut_place *at, void *job) {
    static const wcut_field fields[] = {
        IN_JOB(block_size, "size_mm", true, read_block_size),
        IN_JOB(foam_material, "material", false, wcut_read_text),
    };
    return READ_OBJECT(fields, job);
}

static bool read_nodes(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 3, WCUT_JOB_NODES_MAX, into);
}

static bool read_emissivity(wcut_reader *reader, const wcut_place *at, void *into) {
    double emissivity;
    if (!wcut_read_positive(reader, at, &emissivity)) return false;
    if (emissivity > 1) return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a number greater than 0 and at most 1");
    *(double *)into = emissivity;
    return true;
}

static bool read_wire(wcut_reader *reader, const wcut_place *at, void *job) {
    static const wcut_field fields[] = {
        IN_JOB(wire_diameter, "diameter_mm", true, wcut_read_positive),
        IN_JOB(wire_density, "density_kg_per_m3", false, wcut_read_not_negative),
        IN_JOB(wire_material, "material", false, wcut_read_text),
        IN_JOB(wire_cold_strength, "cold_strength_MPa", false, wcut_read_positive),
        IN_JOB(wire_hot_strength, "hot_strength_MPa", false, wcut_read_positive),
        IN_JOB(wire_emissivity, "emissivity", false, read_emissivity),
        IN_JOB(nodes, "nodes", true, read_nodes),
        IN_JOB(wire_length, "length_mm", false, wcut_read_positive),
    };
    if (!READ_OBJECT(fields, job)) return false;
    return true;
}

bool wcut_read_force_law(wcut_reader *reader, const wcut_place *at, void *law) {
    static const wcut_field fields[] = {
        IN(wcut_force_law, a, "a_N_per_mm", true, wcut_read_positive),
        IN(wcut_force_law, b, "b_m2_per_J", true, wcut_read_positive),
    };
    return READ_OBJECT(fields, law);
}

bool wcut_read_tension_law(wcut_reader *reader, const wcut_place *at, void *law) {
    static const wcut_field fields[] = {
        IN(wcut_tension_law, a, "a_N_per_mm", true, wcut_read_positive),
        IN(wcut_tension_law, b, "b_m2_per_J", true, wcut_read_positive),
        IN(wcut_tension_law, c, "c_N_per_mm", true, wcut_read_finite),
    };
    return READ_OBJECT(fields, law);
}

/* cold foam is cut by a blade alone; `at` is in the process of the job */
static bool read_heat(wcut_reader *reader, const wcut_place *at, void *into) {
    const json_t *rig = json_object_get(at->above->above->value, "rig");
    const char *kind = json_string_value(json_object_get(rig, "kind"));
    if (kind && strcmp(kind, wcut_rig_name(WCUT_RIG_KIND_BLADE)) == 0) return wcut_read_not_negative(reader, at, into);
    return wcut_read_positive(reader, at, into);
}

static bool read_process(wcut_reader *reader, const wcut_place *at, void *job) {
    static const wcut_field fields[] = {
        IN_JOB(heat, "heat_W_per_m", true, read_heat),
        IN_JOB(tension, "tension_N", false, wcut_read_positive),
        IN_JOB(force_law, "force_law", true, wcut_read_force_law),
        IN_JOB(tension_law, "tension_law", false, wcut_read_tension_law),
    };
    return READ_OBJECT(fields, job);
}

static bool read_limits(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {
        IN_JOB(speed_max, "speed_max_mm_s", false, wcut_read_positive),
        IN_JOB(speed_min, "speed_min_mm_s", false, wcut_read_positive),
    };
    if (!READ_OBJECT(fields, into)) return false;
    const wcut_job *job = into;
    if (job->speed_min < job->speed_max) return true;
    wcut_place place =
        wcut_place_member(at, json_object_get(at->value, "speed_min_mm_s") ? "speed_min_mm_s" : "speed_max_mm_s");
    return wcut_refuse(reader, &place, WCUT_BAD_ARGUMENT, "speed_min_mm_s (%g) less than speed_max_mm_s (%g)",
                       job->speed_min, job->speed_max);
}

static bool read_job_kerf(wcut_reader *reader, const wcut_place *at, void *job) {
    static const wcut_field fields[] = {
        IN_JOB(kerf_width, "width_mm", true, wcut_read_not_negative),
        IN_JOB(kerf_per_q, "per_J_m2_mm", false, wcut_read_not_negative),
    };
    return READ_OBJECT(fields, job);
}

/* ---- path mode ---- */

/* mount_a_mm comes first and sets the count that mount_b_mm must have */
static bool read_mount_a(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_job *job = into;
    return wcut_read_array(reader, at, 2, WCUT_JOB_STATIONS_MAX, "stations", wcut_read_point, sizeof(wcut_vec3),
                           &job->stations, (void **)&job->mount_a);
}

static bool read_mount_b(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_job *job = into;
    if (json_is_array(at->value) && json_array_size(at->value) != (size_t)job->stations)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "%d stations as in mount_a_mm", job->stations);
    int count;
    return wcut_read_array(reader, at, 2, WCUT_JOB_STATIONS_MAX, "stations", wcut_read_point, sizeof(wcut_vec3), &count,
                           (void **)&job->mount_b);
}

/* one tool that holds both mounts, in the place of the two lists */
static bool read_tool_path(wcut_reader *reader, const wcut_place *at, void *job) {
    static const wcut_field fields[] = {
        PART("tool", true, wcut_read_tool),
        IN_JOB(mount_a_in_tool, "mount_a_in_tool_mm", true, wcut_read_point),
        IN_JOB(mount_b_in_tool, "mount_b_in_tool_mm", true, wcut_read_point),
    };
    return READ_OBJECT(fields, job) && wcut_read_mounts(reader, at, job);
}

static bool read_path(wcut_reader *reader, const wcut_place *at, void *job) {
    static const wcut_field fields[] = {
        PART("mount_a_mm", true, read_mount_a),
        PART("mount_b_mm", true, read_mount_b),
    };
    if (json_object_get(at->value, "tool")) return read_tool_path(reader, at, job);
    return READ_OBJECT(fields, job);
}

/* ---- design mode ---- */

/* [u, extra mm] */
typedef struct extra_point {
    double u, length;
} extra_point;

static bool read_extra_point(wcut_reader *reader, const wcut_place *at, void *into) {
    extra_point *extra = into;
    if (!json_is_array(at->value) || json_array_size(at->value) != 2)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a pair [u, extra length in mm]");
    wcut_place u = {at, NULL, 0, json_array_get(at->value, 0)}, length = {at, NULL, 1, json_array_get(at->value, 1)};
    if (!wcut_read_not_negative(reader, &u, &extra->u)) return false;
    if (extra->u > 1) return wcut_refuse(reader, &u, WCUT_BAD_ARGUMENT, "a parameter u from 0 to 1");
    return wcut_read_not_negative(reader, &length, &extra->length);
}

static bool check_extra(wcut_reader *reader, const wcut_place *at, int count, const extra_point *extra) {
    for (int i = 1; i < count; i++) {
        if (extra[i].u > extra[i - 1].u) continue;
        wcut_place item = {at, NULL, (size_t)i, json_array_get(at->value, (size_t)i)};
        wcut_place u = {&item, NULL, 0, json_array_get(item.value, 0)};
        return wcut_refuse(reader, &u, WCUT_BAD_ARGUMENT, "u to increase, beyond %g", extra[i - 1].u);
    }
    return true;
}

static bool read_extra(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_job *job = into;
    extra_point *extra = NULL;
    int count = 0;
    bool ok = wcut_read_array(reader, at, 1, POINTS_MAX, "pairs [u, mm]", read_extra_point, sizeof *extra, &count,
                              (void **)&extra) &&
              check_extra(reader, at, count, extra);
    if (ok) {
        job->extra_u = wcut_alloc((size_t)count, sizeof(double));
        job->extra_length = wcut_alloc((size_t)count, sizeof(double));
        if (!job->extra_u || !job->extra_length) ok = wcut_refuse_memory(reader);
    }
    if (ok) {
        job->extra_count = count;
        for (int i = 0; i < count; i++) job->extra_u[i] = extra[i].u, job->extra_length[i] = extra[i].length;
    }
    free(extra);
    return ok;
}

static bool read_stations(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 2, WCUT_JOB_STATIONS_MAX, into);
}

static bool read_design(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {
        IN_JOB(edge_a, "edge_a", true, wcut_read_curve),
        IN_JOB(edge_b, "edge_b", true, wcut_read_curve),
        IN_JOB(stations, "stations", true, read_stations),
        PART("extra_length_mm", true, read_extra),
        IN_JOB(clearance, "clearance_mm", true, wcut_read_not_negative),
        IN_JOB(overrun, "overrun_mm", false, wcut_read_not_negative),
    };
    ((wcut_job *)into)->mode = WCUT_MODE_DESIGN;
    return READ_OBJECT(fields, into);
}

/* ---- identification cuts ---- */

static bool read_dither(wcut_reader *reader, const wcut_place *at, void *dither) {
    static const wcut_field fields[] = {
        IN(wcut_dither, amplitude, "amplitude", true, wcut_read_finite),
        IN(wcut_dither, period, "period_s", true, wcut_read_positive),
        IN(wcut_dither, phase, "phase_rad", true, wcut_read_finite),
    };
    return READ_OBJECT(fields, dither);
}

static bool read_speed_programme(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_job *job = into;
    if (!wcut_read_array(reader, at, 0, PROGRAMME_MAX, "sines", read_dither, sizeof(wcut_dither), &job->dither_count,
                         (void **)&job->dither))
        return false;
    double sum = 0;
    for (int i = 0; i < job->dither_count; i++) sum += fabs(job->dither[i].amplitude);
    if (sum < 1) return true;
    return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT,
                       "amplitudes that sum to less than 1 (not %g): the speed stays "
                       "positive",
                       sum);
}

static bool read_heat_step(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {
        IN(wcut_heat_step, from, "from_s", true, wcut_read_not_negative),
        IN(wcut_heat_step, to, "to_s", true, wcut_read_positive),
        IN(wcut_heat_step, factor, "factor", true, wcut_read_positive),
    };
    if (!READ_OBJECT(fields, into)) return false;
    const wcut_heat_step *step = into;
    wcut_place to = wcut_place_member(at, "to_s");
    return step->from < step->to || wcut_refuse(reader, &to, WCUT_BAD_ARGUMENT, "more than from_s (%g)", step->from);
}

static bool read_heat_programme(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_job *job = into;
    if (!wcut_read_array(reader, at, 0, PROGRAMME_MAX, "intervals", read_heat_step, sizeof(wcut_heat_step),
                         &job->heat_step_count, (void **)&job->heat_step))
        return false;
    for (int i = 1; i < job->heat_step_count; i++) {
        if (job->heat_step[i].from >= job->heat_step[i - 1].to) continue;
        wcut_place item = {at, NULL, (size_t)i, json_array_get(at->value, (size_t)i)};
        wcut_place from = wcut_place_member(&item, "from_s");
        return wcut_refuse(reader, &from, WCUT_BAD_ARGUMENT, "at least the to_s (%g) of the interval before",
                           job->heat_step[i - 1].to);
    }
    return true;
}

static bool read_excitation(wcut_reader *reader, const wcut_place *at, void *job) {
    static const wcut_field fields[] = {
        PART("speed", false, read_speed_programme),
        PART("heat", false, read_heat_programme),
    };
    return READ_OBJECT(fields, job);
}

/* ---- the whole ---- */

static bool read_job_format(wcut_reader *reader, const wcut_place *at, void *job) {
    (void)job;
    return wcut_read_format(reader, at, FORMAT);
}

static bool read_job_keys(wcut_reader *reader, const wcut_place *at, wcut_job *job) {
    /* each key of a job, and what reads it */
    static const wcut_field fields[] = {
        PART("format", true, read_job_format),     IN_JOB(name, "name", true, wcut_read_text),
        PART("block", true, read_block),           PART("wire", true, read_wire),
        PART("process", true, read_process),       PART("path", false, read_path),
        PART("design", false, read_design),        PART("limits", false, read_limits),
        PART("rig", false, wcut_read_rig),         PART("feed", false, wcut_read_feed),
        PART("kerf", false, read_job_kerf),        PART("excitation", false, read_excitation),
        PART("effects", false, wcut_read_effects),
    };
    /* the format before all else: another format has other keys */
    wcut_place format = wcut_place_member(at, "format");
    if (json_is_object(at->value) && !read_job_format(reader, &format, NULL)) return false;

    /* a job has exactly one of path and design */
    bool path = json_object_get(at->value, "path"), design = json_object_get(at->value, "design");
    if (path && design) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "either \"path\" or \"design\", not both");
    if (!READ_OBJECT(fields, job)) return false;
    if (!path && !design) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a \"path\" or a \"design\" in it");
    return wcut_read_rig_fits(reader, at, job);
}

wcut_status wcut_job_parse(const char *text, size_t length, const char *label, wcut_job **job, wcut_error *error) {
    wcut_reader reader = {label, error, WCUT_OK};
    wcut_job *made = NULL;
    json_t *root = wcut_json_load(&reader, text, length);
    if (!root) return reader.status;
    wcut_place at = {NULL, NULL, 0, root};
    bool ok = wcut_job_create(&made) == WCUT_OK ? read_job_keys(&reader, &at, made) : wcut_refuse_memory(&reader);
    json_decref(root);
    if (!ok) {
        wcut_job_destroy(made);
        return reader.status;
    }
    *job = made;
    return WCUT_OK;
}

wcut_status wcut_job_read(const char *path, wcut_job **job, wcut_error *error) {
    if (!path || !job) return wcut_fail(error, WCUT_BAD_ARGUMENT, "wcut_job_read: path or job is NULL");
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_file_read(path, WCUT_JOB_BYTES_MAX, &text, &length, error);
    if (status == WCUT_OK) status = wcut_job_parse(text, length, path, job, error);
    free(text);
    return status;
}
