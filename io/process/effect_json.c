/* The effects of a job as JSON: in by the table of their parameters, out the same way. */
#include "io/process/effect_json.h"

#include <string.h>

enum { FIELDS_MAX = 2 + WCUT_EFFECT_VALUES, EFFECTS_MAX = 100 };

#define NAME(name, text, acts) text,
static const char *const names[] = {WCUT_EFFECT_LIST(NAME) NULL};

/* name and choice are read apart: their words depend on the effect */
static bool pass(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)reader, (void)at, (void)into;
    return true;
}

static int list_fields(const wcut_effect_info *info, const wcut_effect_parameter *first, wcut_field *field) {
    int count = 0;
    field[count++] = (wcut_field){"name", true, pass, 0};
    if (info->choice_key) field[count++] = (wcut_field){info->choice_key, false, pass, 0};
    for (const wcut_effect_parameter *p = first; p->key; p++)
        field[count++] = (wcut_field){p->key, p->required, p->size == 3 ? wcut_read_point : wcut_read_finite,
                                      offsetof(wcut_effect, value) + (size_t)p->at * sizeof(double)};
    return count;
}

static bool check_range(wcut_reader *reader, const wcut_place *at, const wcut_effect_parameter *p,
                        const double *value) {
    const wcut_place place = wcut_place_member(at, p->key);
    for (int k = 0; k < p->size; k++) {
        if (value[k] >= p->min && value[k] <= p->max) continue;
        return wcut_refuse(reader, &place, WCUT_BAD_ARGUMENT, "%s from %g to %g",
                           p->size == 3 ? "coordinates" : "a number", p->min, p->max);
    }
    return true;
}

static bool read_effect(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_effect *effect = into;
    wcut_place name = wcut_place_member(at, "name");
    int kind = 0;

    /* the name decides which keys may follow */
    if (!json_is_object(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an effect: {\"name\": .., ..}");
    if (!wcut_read_word(reader, &name, names, &kind)) return false;
    const wcut_effect_info *info = wcut_effect_view((wcut_effect_kind)kind);
    int chosen = 0;
    if (info->choice_key) { /* what else an effect is told by may depend on it */
        const wcut_place choice = wcut_place_member(at, info->choice_key);
        const bool first = !choice.value && !info->choice_required; /* of a kind that had one form alone */
        if (!first && !wcut_read_word(reader, &choice, info->choice, &chosen)) return false;
    }

    /* defaults first, so that keys may be left out */
    *effect = wcut_effect_choose((wcut_effect_kind)kind, chosen);
    const wcut_effect_parameter *first = wcut_effect_parameters(effect);
    wcut_field field[FIELDS_MAX];
    if (!wcut_read_object(reader, at, field, list_fields(info, first, field), effect)) return false;

    /* ranges are checked last, because a vector is read as a whole */
    for (const wcut_effect_parameter *p = first; p->key; p++)
        if (!check_range(reader, at, p, effect->value + p->at)) return false;

    return true;
}

bool wcut_read_effects(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_job *job = into;
    if (!wcut_read_array(reader, at, 0, EFFECTS_MAX, "effects", read_effect, sizeof(wcut_effect), &job->effect_count,
                         (void **)&job->effect))
        return false;
    for (int e = 0; e < job->effect_count; e++)
        for (int k = 0; k < e; k++) {
            const wcut_effect_info *info = wcut_effect_view(job->effect[e].kind);
            if (job->effect[k].kind != job->effect[e].kind || info->repeats) continue;
            const wcut_place item = {at, NULL, (size_t)e, json_array_get(at->value, (size_t)e)};
            return wcut_refuse(reader, &item, WCUT_BAD_ARGUMENT, "no second %s", info->name);
        }
    return true;
}

static void put_effect_json_effect(wcut_text *text, const wcut_effect *effect) {
    const wcut_effect_info *info = wcut_effect_view(effect->kind);
    wcut_text_print(text, "{\"name\": \"%s\"", info->name);
    if (info->choice_required || effect->choice > 0)
        wcut_text_print(text, ", \"%s\": \"%s\"", info->choice_key, info->choice[effect->choice]);
    for (const wcut_effect_parameter *p = wcut_effect_parameters(effect); p->key; p++) {
        wcut_text_print(text, ", \"%s\": %s", p->key, p->size == 3 ? "[" : "");
        for (int k = 0; k < p->size; k++) {
            if (k) wcut_text_put(text, ", ", 2);
            wcut_text_number(text, effect->value[p->at + k]);
        }
        if (p->size == 3) wcut_text_put(text, "]", 1);
    }
    wcut_text_put(text, "}", 1);
}

void wcut_put_effects(wcut_text *text, int count, const wcut_effect *effect) {
    if (count == 0) return;
    wcut_text_print(text, ",\n  \"effects\": [");
    for (int e = 0; e < count; e++) {
        if (e) wcut_text_print(text, ",\n              ");
        put_effect_json_effect(text, &effect[e]);
    }
    wcut_text_put(text, "]", 1);
}
