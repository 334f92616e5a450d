/* A case of a study: its values, its input, the words that run it, and the hash that tells it from every other. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>

#include "base/alloc.h"
#include "io/file/sha256.h"
#include "io/study/sample.h"
#include "io/study/study.h"

/* ---- values ---- */

/* where in [0, 1) a sample lies */
static double share_of(const wcut_study *study, int k, int parameter) {
    const wcut_study_parameter *p = &study->parameter[parameter];
    const uint64_t seed = (uint64_t)study->seed;
    if (study->combine == WCUT_COMBINE_SOBOL) return wcut_sobol_eval(parameter, (uint32_t)k, seed);
    return (p->interval[k] + wcut_latin_jitter(parameter, k, seed)) / study->info.cases;
}

static double sample(const wcut_study_parameter *p, double share) {
    const double value = p->log ? p->low * pow(p->high / p->low, share) : p->low + share * (p->high - p->low);
    if (!(p->step > 0)) return value;

    /* every multiple of the step is as likely */
    const double steps = floor((p->high - p->low) / p->step + 1e-9) + 1;
    return p->low + fmin(floor(share * steps), steps - 1) * p->step;
}

const json_t *wcut_study_value(const wcut_study *study, int k, int parameter, double *number) {
    const wcut_study_parameter *p = &study->parameter[parameter];
    if (!p->list) {
        *number = sample(p, share_of(study, k, parameter));
        return NULL;
    }
    size_t n = json_array_size(p->list), index = (size_t)k;

    /* a grid: the last parameter varies fastest */
    if (study->combine == WCUT_COMBINE_GRID) {
        for (int q = study->parameters - 1; q > parameter; q--) index /= json_array_size(study->parameter[q].list);
        index %= n;
    } else if (study->combine == WCUT_COMBINE_LATIN || study->combine == WCUT_COMBINE_SOBOL) {
        index = (size_t)(share_of(study, k, parameter) * (double)n);
    }
    return json_array_get(p->list, index < n ? index : n - 1);
}

static void put_value(wcut_text *text, const wcut_study *study, int k, int parameter) {
    double number = 0;
    const json_t *value = wcut_study_value(study, k, parameter, &number);
    if (value)
        wcut_canonical_print(text, value, NULL, NULL);
    else
        wcut_text_number(text, number);
}

/* ---- input ---- */

static void put_input(wcut_text *text, const wcut_study *study, int k) {
    size_t at = 0;
    for (int i = 0; i < study->places; i++) {
        const size_t next = study->parameter[study->order[i]].at;
        wcut_text_put(text, study->canonical + at, next - at);
        put_value(text, study, k, study->order[i]);
        at = next;
    }
    wcut_text_put_word(text, study->canonical + at);
}

/* ---- options ---- */

/* an option of a case, fixed or varied */
typedef struct case_option {
    const char *name; /* without dashes */
    int parameter;    /* -1: fixed, `value` */
    const json_t *value;
} case_option;

static int by_option(const void *a, const void *b) {
    return strcmp(((const case_option *)a)->name, ((const case_option *)b)->name);
}

/* all options in the order of their names; a varied one replaces a fixed one of the same name. NULL: no memory */
static case_option *list_options(const wcut_study *study, int *count) {
    const size_t fixed = json_object_size(study->options);
    case_option *list = wcut_alloc(fixed + (size_t)study->parameters, sizeof *list);
    *count = 0;
    if (!list) return NULL;
    for (int p = 0; p < study->parameters; p++)
        if (*study->parameter[p].name == '-')
            list[(*count)++] = (case_option){.name = study->parameter[p].name + 2, .parameter = p};
    const int varied = *count;
    for (void *i = json_object_iter(study->options); i; i = json_object_iter_next(study->options, i)) {
        const case_option o = {json_object_iter_key(i), -1, json_object_iter_value(i)};
        bool replaced = false;
        for (int v = 0; v < varied; v++) replaced = replaced || strcmp(list[v].name, o.name) == 0;
        if (!replaced) list[(*count)++] = o;
    }
    qsort(list, (size_t)*count, sizeof *list, by_option);
    return list;
}

/* the words of an option: --name=value, --name, or none where it is false */
static void put_option_words(wcut_text *text, const wcut_study *study, int k, const case_option *o) {
    double number = 0;
    const json_t *value = o->parameter < 0 ? o->value : wcut_study_value(study, k, o->parameter, &number);
    if (json_is_false(value)) return;
    wcut_text_print(text, "--%s", o->name);
    if (json_is_true(value)) {
        wcut_text_put(text, "\n", 1);
        return;
    }
    wcut_text_put(text, "=", 1);
    if (json_is_string(value))
        wcut_text_put_word(text, json_string_value(value));
    else
        wcut_text_number(text, value ? json_number_value(value) : number);
    wcut_text_put(text, "\n", 1);
}

/* ---- what the hash is of ---- */

/* {"files":{...},"input":...,"inputs":[...],"options":{...},"verb":...,"version":...}, keys sorted, no blanks */
static bool put_content(wcut_text *text, const wcut_study *study, int k) {
    int options = 0;
    case_option *option = list_options(study, &options);
    if (!option) return false;

    /* files by name and hash, the varied input whole, the others by name */
    wcut_text_put_word(text, "{\"files\":[");
    for (int i = 0; i < study->files; i++) {
        wcut_text_put_string(text, i ? "," : "", study->file[i].name);
        wcut_text_put_string(text, ",", study->file[i].hash);
    }

    /* the input with the values of the case; null where none is varied */
    wcut_text_put_word(text, "],\"input\":");
    if (study->canonical)
        put_input(text, study, k);
    else
        wcut_text_put_word(text, "null");
    wcut_text_put_word(text, ",\"inputs\":[");
    for (int i = study->canonical ? 1 : 0; i < study->inputs; i++)
        wcut_text_put_string(text, i > (study->canonical ? 1 : 0) ? "," : "", study->input[i]);

    /* what the verb is told beside */
    wcut_text_put_word(text, "],\"options\":{");
    for (int i = 0; i < options; i++) {
        wcut_text_put_string(text, i ? "," : "", option[i].name);
        wcut_text_put(text, ":", 1);
        if (option[i].parameter < 0)
            wcut_canonical_print(text, option[i].value, NULL, NULL);
        else
            put_value(text, study, k, option[i].parameter);
    }

    /* verb and version change the result as well */
    wcut_text_put_string(text, "},\"verb\":", study->verb);
    wcut_text_put_string(text, ",\"version\":", wcut_version_text());
    wcut_text_put(text, "}", 1);
    wcut_free(option);
    return true;
}

/* ---- for the caller ---- */

static bool is_case(const wcut_study *study, int k) { return study && k >= 0 && k < study->info.cases; }

wcut_status wcut_study_value_print(const wcut_study *study, int k, int parameter, char **text) {
    wcut_text out;
    if (!is_case(study, k) || parameter < 0 || parameter >= study->parameters || !text) return WCUT_BAD_ARGUMENT;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    put_value(&out, study, k, parameter);
    return wcut_text_finish(&out, text, NULL);
}

wcut_status wcut_study_input_print(const wcut_study *study, int k, char **text) {
    wcut_text out;
    if (!is_case(study, k) || !text) return WCUT_BAD_ARGUMENT;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    if (study->canonical) put_input(&out, study, k);
    return wcut_text_finish(&out, text, NULL);
}

wcut_status wcut_study_hash_eval(const wcut_study *study, int k, char *hash) {
    wcut_text out;
    char *text = NULL;
    size_t length = 0;

    /* the canonical text of everything that determines the result */
    if (!is_case(study, k) || !hash) return WCUT_BAD_ARGUMENT;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    if (!put_content(&out, study, k)) {
        wcut_text_destroy(&out);
        return WCUT_NO_MEMORY;
    }
    if (wcut_text_finish(&out, &text, &length) != WCUT_OK) return WCUT_NO_MEMORY;

    /* its SHA-256 in hexadecimal digits */
    wcut_sha256 sum;
    uint8_t digest[WCUT_SHA256_SIZE];
    wcut_sha256_begin(&sum);
    wcut_sha256_add(&sum, text, length);
    wcut_sha256_end(&sum, digest);
    for (int i = 0; i < WCUT_SHA256_SIZE; i++) snprintf(hash + 2 * (size_t)i, 3, "%02x", digest[i]);
    free(text);
    return WCUT_OK;
}

wcut_status wcut_study_call_print(const wcut_study *study, int k, const char *folder, char **text) {
    wcut_text out;
    int options = 0;
    if (!is_case(study, k) || !folder || !*folder || strchr(folder, '\n') || !text) return WCUT_BAD_ARGUMENT;

    /* fixed and varied options of the case, by name */
    case_option *option = list_options(study, &options);
    if (!option) return WCUT_NO_MEMORY;
    if (!wcut_text_create(&out, NULL)) {
        wcut_free(option);
        return WCUT_NO_MEMORY;
    }

    /* verb and inputs, the varied one from the case's folder */
    wcut_text_put_word(&out, study->verb);
    wcut_text_put(&out, "\n", 1);
    if (study->canonical) {
        wcut_text_put_word(&out, folder);
        wcut_text_put_word(&out, study->recorded ? "/input/case.json\n" : "/input.json\n");
    }
    for (int i = study->canonical ? 1 : 0; i < study->inputs; i++) {
        wcut_text_put_word(&out, study->input[i]);
        wcut_text_put(&out, "\n", 1);
    }

    /* output folder and options; --quiet keeps the last words of a case to its errors */
    wcut_text_put_word(&out, "-o\n");
    wcut_text_put_word(&out, folder);
    wcut_text_put(&out, "\n", 1);
    for (int i = 0; i < options; i++) put_option_words(&out, study, k, &option[i]);
    wcut_text_put_word(&out, "--quiet\n");
    wcut_free(option);
    return wcut_text_finish(&out, text, NULL);
}
