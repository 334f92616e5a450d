/* The table of effects is whole: every value has a name and a range, every row its equation, source and function. */
#include <stdio.h>
#include <string.h>
#include <wirecut/effects.h>

#include "test.h"

/* a file of the source tree, the caller's to free */
static char *text_of(const char *path) {
    char name[400];
    snprintf(name, sizeof name, WCUT_SOURCE_DIR "/%s", path);
    FILE *file = fopen(name, "r");
    ck_assert_msg(file != NULL, "%s", name);
    char *text = calloc(1, 1 << 20);
    ck_assert_uint_gt(fread(text, 1, (1 << 20) - 1, file), 0);
    fclose(file);
    return text;
}

static int choices_of(const wcut_effect_info *info) {
    int count = info->choice ? 0 : 1;
    while (info->choice && info->choice[count]) count++;
    return count;
}

TEST(the_values_of_every_kind_and_choice_are_named_without_gap_or_overlap) {
    for (int kind = 0; kind < WCUT_EFFECT_COUNT; kind++) {
        const wcut_effect_info *info = wcut_effect_view((wcut_effect_kind)kind);
        for (int choice = 0; choice < choices_of(info); choice++) {
            const wcut_effect effect = wcut_effect_choose((wcut_effect_kind)kind, choice);
            int named[WCUT_EFFECT_VALUES] = {0}, last = -1;
            for (const wcut_effect_parameter *p = wcut_effect_parameters(&effect); p->key; p++) {
                ck_assert(p->at >= 0 && p->at + p->size <= WCUT_EFFECT_VALUES && (p->size == 1 || p->size == 3));
                ck_assert_msg(p->min <= p->low && p->low < p->high && p->high <= p->max, "%s.%s", info->name, p->key);
                ck_assert(p->initial >= p->min && p->initial <= p->max);
                for (int k = p->at; k < p->at + p->size; k++) named[k]++, last = k > last ? k : last;
            }
            ck_assert_int_gt(info->strengths, 0);

            /* a term without a cosine leaves the second strength unnamed; nothing else is */
            for (int k = 0; k <= last; k++)
                ck_assert_msg(named[k] == 1 || (kind == WCUT_EFFECT_EMPIRICAL_FORCE &&
                                                k == WCUT_EMPIRICAL_FORCE_COSINE && named[k] == 0),
                              "%s, choice %d: value[%d] has %d names", info->name, choice, k, named[k]);
        }
    }
}

TEST(an_enumerator_stands_for_the_key_of_its_name) {
    const struct {
        wcut_effect_kind kind;
        int at;
        const char *key;
    } sample[] = {{WCUT_EFFECT_WIRE_THERMAL_LAG, WCUT_WIRE_THERMAL_LAG_LOSS_BY_SPEED, "H1_W_s_per_mm_mK"},
                  {WCUT_EFFECT_END_COOLING, WCUT_END_COOLING_LENGTH, "length_mm"},
                  {WCUT_EFFECT_FOAM_INCLUSION, WCUT_FOAM_INCLUSION_POSITION, "position_mm"},
                  {WCUT_EFFECT_WIRE_FOULING, WCUT_WIRE_FOULING_START, "start_mm"},
                  {WCUT_EFFECT_KERF_GROWTH, WCUT_KERF_GROWTH_PER_LOG, "k2_mm"},
                  {WCUT_EFFECT_MOUNT_COMPLIANCE, WCUT_MOUNT_COMPLIANCE_SETTLING, "settling_s"},
                  {WCUT_EFFECT_EMPIRICAL_READING, WCUT_EMPIRICAL_READING_TO, "to_s"}};
    for (size_t k = 0; k < sizeof sample / sizeof *sample; k++) {
        const wcut_effect effect = wcut_effect_default(sample[k].kind);
        const wcut_effect_parameter *p = wcut_effect_parameters(&effect);
        while (p->key && p->at != sample[k].at) p++;
        ck_assert_ptr_nonnull(p->key);
        ck_assert_str_eq(p->key, sample[k].key);
    }
}

TEST(equation_source_and_function_are_those_of_the_notation) {
    char *notation = text_of("kernel/NOTATION.md");
    for (int kind = 0; kind < WCUT_EFFECT_COUNT; kind++) {
        const wcut_effect_info *info = wcut_effect_view((wcut_effect_kind)kind);
        ck_assert(strlen(info->equation) > 8 && strlen(info->source) > 8);

        /* the row of the effect: the line that begins with its name, or has it beside another's, and names its function */
        char name[80], line[2000] = "";
        snprintf(name, sizeof name, "`%s`", info->name);
        for (const char *at = strstr(notation, name); at && !strstr(line, info->where); at = strstr(at + 1, name))
            snprintf(line, sizeof line, "%.*s", (int)strcspn(at, "\n"), at);
        ck_assert_msg(strstr(line, info->where) != NULL, "%s: NOTATION.md has no row with %s", info->name, info->where);
        ck_assert_msg(strstr(line, info->equation) != NULL, "%s: not in NOTATION.md: %s", info->name, info->equation);

        /* the function is defined in that file */
        char path[120], defined[80];
        const char *colon = strrchr(info->where, ':');
        ck_assert_ptr_nonnull(colon);
        snprintf(path, sizeof path, "%.*s", (int)(colon - info->where), info->where);
        snprintf(defined, sizeof defined, " %s(", colon + 1);
        char *source = text_of(path);
        ck_assert_msg(strstr(source, defined) != NULL, "%s: no function %s", path, colon + 1);
        free(source);
    }
    free(notation);
}
