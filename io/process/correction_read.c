/* "correction" of a wirecut-diagnosis/1: what jobs should say. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/correction.h>

#include "base/fail.h"
#include "io/file/json_read.h"
#include "io/file/read_file.h"
#include "io/process/correction.h"
#include "io/process/effect_json.h"

#define FORMAT "wirecut-diagnosis/1"

/* the correction, and the job that effects are read into */
typedef struct filling {
    wcut_correction made;
    wcut_job effects;
} filling;

static bool read_kerf_correction(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {
        {"width_mm", true, wcut_read_not_negative, offsetof(wcut_correction, kerf)},
        {"per_J_m2_mm", false, wcut_read_not_negative, offsetof(wcut_correction, kerf_per_q)}};
    return json_is_null(at->value) || wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, into);
}

static bool read_effects(wcut_reader *reader, const wcut_place *at, void *into) {
    filling *of = into;
    if (!wcut_read_effects(reader, at, &of->effects)) return false;
    if (of->effects.effect_count > WCUT_CORRECTION_EFFECTS)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "%d effects at most", WCUT_CORRECTION_EFFECTS);
    of->made.effects = of->effects.effect_count;
    for (int e = 0; e < of->made.effects; e++) of->made.effect[e] = of->effects.effect[e];
    return true;
}

/* ---- intervals ---- */

/* two numbers, or null and nothing where none was estimated; *given says which */
static bool read_interval(wcut_reader *reader, const wcut_place *at, double ends[2], bool *given) {
    *given = false;
    if (!at->value || json_is_null(at->value)) return true;
    for (size_t k = 0; k < 2; k++) {
        const json_t *item = json_array_get(at->value, k);
        if (json_array_size(at->value) != 2 || !json_is_number(item) || !isfinite(json_number_value(item)))
            return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "two numbers, the ends of an interval");
        ends[k] = json_number_value(item);
    }
    *given = true;
    return true;
}

/* the interval of one size of an effect of the diagnosis */
static bool read_size_interval(wcut_reader *reader, const wcut_place *effect, const char *key, double ends[2],
                               bool *given) {
    const wcut_place all = wcut_place_member(effect, "parameters"), one = wcut_place_member(&all, key);
    const wcut_place at = wcut_place_member(&one, "ci95");
    return read_interval(reader, &at, ends, given);
}

/* the sizes of the effects at the ends of their intervals, from what the diagnosis says of each */
static bool read_intervals(wcut_reader *reader, const wcut_place *root, wcut_correction *c) {
    const wcut_place list = wcut_place_member(root, "effects");
    memcpy(c->low, c->effect, sizeof c->low);
    memcpy(c->high, c->effect, sizeof c->high);
    c->kerf_per_q_low = c->kerf_per_q_high = c->kerf_per_q;
    for (size_t k = 0; k < json_array_size(list.value); k++) {
        const wcut_place at = {&list, NULL, k, json_array_get(list.value, k)};
        const char *name = json_string_value(json_object_get(at.value, "name"));
        bool given, any = false;
        double ends[2];
        for (int e = 0; name && e < c->effects; e++) {
            const wcut_effect_info *info = wcut_effect_view(c->effect[e].kind);
            if (strcmp(info->name, name) != 0) continue;
            for (const wcut_effect_parameter *p = wcut_effect_parameters(&c->effect[e]); p->key; p++) {
                if (p->at >= info->strengths || p->size != 1) continue;
                if (!read_size_interval(reader, &at, p->key, ends, &given)) return false;
                if (!given) continue;
                c->low[e].value[p->at] = fmin(fmax(ends[0], p->min), p->max);
                c->high[e].value[p->at] = fmin(fmax(ends[1], p->min), p->max);
                any = true;
            }
        }

        /* a kerf that grows is a part of the job's kerf, not an effect */
        const wcut_effect_info *kerf = wcut_effect_view(WCUT_EFFECT_KERF_GROWTH);
        if (name && strcmp(name, kerf->name) == 0 && c->kerf_per_q > 0) {
            if (!read_size_interval(reader, &at, kerf->parameter[0].key, ends, &given)) return false;
            if (given) c->kerf_per_q_low = fmax(ends[0], 0), c->kerf_per_q_high = fmax(ends[1], 0), any = true;
        }
        c->intervals += any;
    }
    return true;
}

#define IN(name) (offsetof(filling, made) + offsetof(wcut_correction, name))

static bool read_correction(wcut_reader *reader, const wcut_place *root, filling *of) {
    static const wcut_field fields[] = {{"a_N_per_mm", true, wcut_read_positive, IN(a)},
                                        {"b_m2_per_J", true, wcut_read_positive, IN(b)},
                                        {"length_change_mm", true, wcut_read_finite, IN(length_change)},
                                        {"kerf", false, read_kerf_correction, offsetof(filling, made)},
                                        {"effects", false, read_effects, 0}};

    /* a diagnosis, which may withhold its correction and say why */
    const wcut_place format = wcut_place_member(root, "format"), at = wcut_place_member(root, "correction");
    if (!wcut_read_format(reader, &format, FORMAT)) return false;

    /* withheld: the reason is a part of the message */
    if (json_is_null(at.value)) {
        const wcut_place why = wcut_place_member(root, "withheld");
        const char *text = json_string_value(why.value);
        wcut_fail(reader->error, WCUT_BAD_ARGUMENT, "%s: it withholds its correction: %.200s", reader->label,
                  text ? text : "no reason is given");
        reader->status = WCUT_BAD_ARGUMENT;
        return false;
    }

    /* no kerf is NaN, not zero */
    of->made.kerf = (double)NAN;

    return wcut_read_object(reader, &at, fields, sizeof fields / sizeof *fields, of) &&
           read_intervals(reader, root, &of->made);
}

wcut_status wcut_correction_parse(const char *text, size_t length, const char *path, wcut_correction *correction,
                                  wcut_error *error) {
    wcut_reader reader = {path, error, WCUT_OK};
    json_t *root = wcut_json_load(&reader, text, length);
    if (!root) return reader.status;
    const wcut_place at = {NULL, NULL, 0, root};
    filling of = {.made = {.effects = 0}};
    if (read_correction(&reader, &at, &of)) *correction = of.made;
    free(of.effects.effect);
    json_decref(root);
    return reader.status;
}

wcut_status wcut_correction_read(const char *path, wcut_correction *correction, wcut_error *error) {
    if (!path || !correction)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "wcut_correction_read: path or correction is NULL");
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_file_read(path, WCUT_DIAGNOSIS_BYTES_MAX, &text, &length, error);
    if (status == WCUT_OK) status = wcut_correction_parse(text, length, path, correction, error);
    free(text);
    return status;
}
