/* "wirecut-job/1" out: shortest exact numbers, parsed back before anything reaches the disk. */
#include <stdlib.h>
#include <string.h>

#include <wirecut/job_file.h>
#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/text.h"
#include "io/process/effect_json.h"
#include "io/process/job.h"
#include "io/process/rig_json.h"

static void put_job_points(wcut_text *text, const char *before, int count, const wcut_vec3 *point) {
    wcut_text_print(text, "%s[", before);
    for (int i = 0; i < count; i++) {
        if (i) wcut_text_put(text, ", ", 2);
        wcut_text_put_point(text, "[", point[i]);
    }
    wcut_text_put(text, "]", 1);
}

static void put_numbers(wcut_text *text, const char *before, int count, const double *value) {
    wcut_text_print(text, "%s[", before);
    for (int i = 0; i < count; i++) wcut_text_put_number(text, i ? ", " : "", value[i]);
    wcut_text_put(text, "]", 1);
}

static void put_block_and_wire(wcut_text *text, const wcut_job *job) {
    wcut_text_print(text, ",\n  \"block\": {\"size_mm\": ");
    wcut_text_put_point(text, "[", job->block_size);
    if (job->foam_material) wcut_text_put_string(text, ", \"material\": ", job->foam_material);
    wcut_text_put_number(text, "},\n  \"wire\": {\"diameter_mm\": ", job->wire_diameter);
    if (job->wire_material) wcut_text_put_string(text, ", \"material\": ", job->wire_material);
    if (job->wire_density > 0) wcut_text_put_number(text, ", \"density_kg_per_m3\": ", job->wire_density);
    if (job->wire_cold_strength > 0) wcut_text_put_number(text, ", \"cold_strength_MPa\": ", job->wire_cold_strength);
    if (job->wire_hot_strength > 0) wcut_text_put_number(text, ", \"hot_strength_MPa\": ", job->wire_hot_strength);
    if (job->wire_emissivity > 0) wcut_text_put_number(text, ", \"emissivity\": ", job->wire_emissivity);
    wcut_text_print(text, ", \"nodes\": %d", job->nodes);
    if (job->wire_length > 0) wcut_text_put_number(text, ", \"length_mm\": ", job->wire_length);
    wcut_text_put(text, "}", 1);
}

static void put_job_process(wcut_text *text, const wcut_job *job) {
    wcut_text_put_number(text, ",\n  \"process\": {\n    \"heat_W_per_m\": ", job->heat);
    if (job->rig.kind == WCUT_RIG_KIND_TWO_ARMS) wcut_text_put_number(text, ",\n    \"tension_N\": ", job->tension);
    wcut_text_put_number(text, ",\n    \"force_law\": {\"a_N_per_mm\": ", job->force_law.a);
    wcut_text_put_number(text, ", \"b_m2_per_J\": ", job->force_law.b);
    wcut_text_put(text, "}", 1);
    if (job->tension_law.a != 0) {
        wcut_text_put_number(text, ",\n    \"tension_law\": {\"a_N_per_mm\": ", job->tension_law.a);
        wcut_text_put_number(text, ", \"b_m2_per_J\": ", job->tension_law.b);
        wcut_text_put_number(text, ", \"c_N_per_mm\": ", job->tension_law.c);
        wcut_text_put(text, "}", 1);
    }
    wcut_text_put_number(text, "\n  },\n  \"limits\": {\"speed_max_mm_s\": ", job->speed_max);
    wcut_text_put_number(text, ", \"speed_min_mm_s\": ", job->speed_min);
    wcut_text_put_number(text, "},\n  \"kerf\": {\"width_mm\": ", job->kerf_width);
    wcut_text_put_number(text, ", \"per_J_m2_mm\": ", job->kerf_per_q);
    wcut_text_put(text, "}", 1);
}

static void put_job_curve(wcut_text *text, const char *before, const wcut_curve *curve) {
    wcut_text_print(text, "%s{\"degree\": %d", before, curve->degree);
    put_numbers(text, ", \"knots\": ", curve->control_count + curve->degree + 1, curve->knots);
    put_job_points(text, ",\n               \"control_points_mm\": ", curve->control_count, curve->control);
    if (curve->weights) put_numbers(text, ",\n               \"weights\": ", curve->control_count, curve->weights);
    wcut_text_put(text, "}", 1);
}

static void put_design(wcut_text *text, const wcut_job *job) {
    wcut_text_print(text, ",\n  \"design\": {\n");
    put_job_curve(text, "    \"edge_a\": ", job->edge_a);
    put_job_curve(text, ",\n    \"edge_b\": ", job->edge_b);
    wcut_text_print(text, ",\n    \"stations\": %d,\n    \"extra_length_mm\": [", job->stations);
    for (int i = 0; i < job->extra_count; i++) {
        wcut_text_put_number(text, i ? ", [" : "[", job->extra_u[i]);
        wcut_text_put_number(text, ", ", job->extra_length[i]);
        wcut_text_put(text, "]", 1);
    }
    wcut_text_put_number(text, "],\n    \"clearance_mm\": ", job->clearance);
    if (job->overrun > 0) wcut_text_put_number(text, ",\n    \"overrun_mm\": ", job->overrun);
    wcut_text_put(text, "\n  }", 4);
}

static void put_excitation(wcut_text *text, const wcut_job *job) {
    wcut_text_print(text, ",\n  \"excitation\": {\n    \"speed\": [");
    for (int i = 0; i < job->dither_count; i++) {
        wcut_text_put_number(text,
                             i ? ",\n              {\"amplitude\": " : "{\"amplitude\": ", job->dither[i].amplitude);
        wcut_text_put_number(text, ", \"period_s\": ", job->dither[i].period);
        wcut_text_put_number(text, ", \"phase_rad\": ", job->dither[i].phase);
        wcut_text_put(text, "}", 1);
    }
    wcut_text_print(text, "],\n    \"heat\": [");
    for (int i = 0; i < job->heat_step_count; i++) {
        wcut_text_put_number(text, i ? ",\n             {\"from_s\": " : "{\"from_s\": ", job->heat_step[i].from);
        wcut_text_put_number(text, ", \"to_s\": ", job->heat_step[i].to);
        wcut_text_put_number(text, ", \"factor\": ", job->heat_step[i].factor);
        wcut_text_put(text, "}", 1);
    }
    wcut_text_print(text, "]\n  }");
}

static void put_job(wcut_text *text, const wcut_job *job) {
    wcut_text_put_string(text, "{\n  \"format\": \"wirecut-job/1\",\n  \"name\": ", job->name);
    put_block_and_wire(text, job);
    put_job_process(text, job);
    wcut_put_rig(text, job);
    if (job->tool) {
        wcut_put_tool(text, job);
    } else if (job->mode == WCUT_MODE_PATH) {
        put_job_points(text, ",\n  \"path\": {\n    \"mount_a_mm\": ", job->stations, job->mount_a);
        put_job_points(text, ",\n    \"mount_b_mm\": ", job->stations, job->mount_b);
        wcut_text_put(text, "\n  }", 4);
    } else {
        put_design(text, job);
    }
    if (job->dither_count > 0 || job->heat_step_count > 0) put_excitation(text, job);
    wcut_put_effects(text, job->effect_count, job->effect);
    wcut_text_print(text, "\n}\n");
}

/* whether every array is there that the counts promise */
static bool is_job_whole(const wcut_job *job) {
    if (!job->name || job->stations < 0 || job->dither_count < 0 || job->heat_step_count < 0) return false;
    if ((job->dither_count > 0 && !job->dither) || (job->heat_step_count > 0 && !job->heat_step)) return false;
    if (job->feed.count < 0 || (job->feed.count > 0 && !job->feed.speed)) return false;
    if (job->feed.kind == WCUT_FEED_KIND_TIME && job->feed.count > 0 && !job->feed.time) return false;
    if (job->mode == WCUT_MODE_PATH) return job->mount_a && job->mount_b;
    return job->edge_a && job->edge_b && job->extra_u && job->extra_length;
}

wcut_status wcut_job_print(const wcut_job *job, const char *label, char **text, size_t *length, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];

    /* a job that cannot be written is refused before any text is made */
    wcut_quote(name, label, WCUT_LABEL_MAX, 1);
    if (!is_job_whole(job))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found a job without its name, path or design", name);
    const wcut_status known = wcut_effects_check(job->effect_count, job->effect, error);
    if (known != WCUT_OK) return known;

    /* the text */
    wcut_text out;
    bool made = wcut_text_create(&out, NULL);
    if (made) put_job(&out, job);
    if (!made || out.failed) {
        wcut_text_destroy(&out);
        return wcut_fail(error, WCUT_NO_MEMORY, "%s: %s", name, wcut_status_text(WCUT_NO_MEMORY));
    }
    /* what the reader would refuse is not written: its message says which key is wrong */
    wcut_job *again = NULL;
    wcut_status status = wcut_job_parse(out.data, out.count, label, &again, error);
    wcut_job_destroy(again);
    if (status != WCUT_OK) {
        wcut_text_destroy(&out);
        if (status == WCUT_BAD_FORMAT && error) error->status = WCUT_BAD_ARGUMENT;
        return status == WCUT_BAD_FORMAT ? WCUT_BAD_ARGUMENT : status;
    }

    *text = out.data;
    *length = out.count;

    return WCUT_OK;
}

wcut_status wcut_job_write(const wcut_job *job, const char *path, wcut_error *error) {
    if (!job || !path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "wcut_job_write: job or path is NULL");
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_job_print(job, path, &text, &length, error);
    if (status == WCUT_OK) status = wcut_file_write_whole(path, text, length, error);
    free(text);
    return status;
}
