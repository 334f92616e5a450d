/* A study's parameters: lists, ranges and rows of values, and the cases that their combination makes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/csv.h"
#include "io/file/read_file.h"
#include "io/file/utf8.h"
#include "io/study/pointer.h"
#include "io/study/sample.h"
#include "io/study/study.h"

/* steps may miss the end of their range by this part of a step */
#define STEP_SLACK 1e-9

/* ---- values ---- */

/* "from", "to" and how the way between them is divided */
typedef struct range {
    double from, to, step, count;
    int scale;
} range;

static bool read_scale(wcut_reader *reader, const wcut_place *at, void *into) {
    static const char *const word[] = {"linear", "log", NULL};
    return wcut_read_word(reader, at, word, into);
}

static bool read_count(wcut_reader *reader, const wcut_place *at, void *into) {
    int count = 0;
    if (!wcut_read_int(reader, at, 1, WCUT_STUDY_CASES_MAX, &count)) return false;
    *(double *)into = count;
    return true;
}

static bool read_range(wcut_reader *reader, const wcut_place *at, range *r) {
    static const wcut_field fields[] = {{"from", true, wcut_read_finite, offsetof(range, from)},
                                        {"to", true, wcut_read_finite, offsetof(range, to)},
                                        {"count", false, read_count, offsetof(range, count)},
                                        {"step", false, wcut_read_positive, offsetof(range, step)},
                                        {"scale", false, read_scale, offsetof(range, scale)}};
    if (!wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, r)) return false;
    if (!(r->to > r->from) || !isfinite(r->to - r->from))
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "\"to\" greater than \"from\"");
    if (r->scale && !(r->from > 0))
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "\"from\" greater than 0 on a logarithmic scale");
    return !(r->scale && r->step > 0) ||
           wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "no \"step\" on a logarithmic scale");
}

/* the values of a range as a list */
static bool list_range(wcut_reader *reader, const wcut_place *at, const range *r, wcut_study *study,
                       wcut_study_parameter *p) {
    if ((r->count > 0) == (r->step > 0))
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "either \"count\" or \"step\" beside \"from\" and \"to\"");

    /* limits of one range and of all together, before memory */
    const double steps = r->step > 0 ? floor((r->to - r->from) / r->step + STEP_SLACK) : r->count - 1;
    if (steps >= WCUT_STUDY_CASES_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "at most %d values, not %.0f", WCUT_STUDY_CASES_MAX,
                           steps + 1);
    study->listed += steps + 1;
    if (study->listed > WCUT_STUDY_VALUES_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "at most %d values of all ranges together",
                           WCUT_STUDY_VALUES_MAX);

    /* the values */
    p->list = json_array();
    for (int i = 0; i <= (int)steps; i++) {
        /* both ends exactly, the values between them by their share of the way */
        const double share = steps > 0 ? i / steps : 0;
        double value = r->step > 0 ? r->from + i * r->step : (1 - share) * r->from + share * r->to;
        if (r->scale) value = i == 0 ? r->from : i == (int)steps ? r->to : r->from * pow(r->to / r->from, share);
        if (json_array_append_new(p->list, json_real(value))) return wcut_refuse_memory(reader);
    }
    return true;
}

static bool is_sampled(const wcut_study *study) {
    return study->combine == WCUT_COMBINE_LATIN || study->combine == WCUT_COMBINE_SOBOL;
}

/* an option's value is a word of a command line */
static bool check_list(wcut_reader *reader, const wcut_place *at, const wcut_study_parameter *p) {
    for (size_t i = 0; i < json_array_size(p->list); i++) {
        const json_t *value = json_array_get(p->list, i);
        const wcut_place item = {at, NULL, i, value};
        if (json_is_string(value) && !wcut_utf8_is_plain(json_string_value(value)))
            return wcut_refuse(reader, &item, WCUT_BAD_ARGUMENT, "a text without control characters");
        if (*p->name == '-' && (json_is_object(value) || json_is_array(value) || json_is_null(value)))
            return wcut_refuse(reader, &item, WCUT_BAD_FORMAT, "a number, a text, true or false");
    }
    return true;
}

static bool read_value_list(wcut_reader *reader, const wcut_place *at, wcut_study *study, wcut_study_parameter *p) {
    range r = {0};
    if (json_is_array(at->value)) {
        const size_t n = json_array_size(at->value);
        if (n < 1 || n > WCUT_STUDY_CASES_MAX)
            return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "1 to %d values", WCUT_STUDY_CASES_MAX);
        p->list = json_incref((json_t *)at->value);
        return check_list(reader, at, p);
    }
    if (!json_is_object(at->value))
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an array of values, or an object with \"from\" and \"to\"");
    if (!read_range(reader, at, &r)) return false;
    if (!is_sampled(study)) return list_range(reader, at, &r, study, p);
    if (r.count > 0)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "no \"count\": \"cases\" says how many samples are drawn");
    *p = (wcut_study_parameter){.name = p->name, .low = r.from, .high = r.to, .step = r.step, .log = r.scale == 1};
    return true;
}

static bool read_parameter(wcut_reader *reader, const wcut_place *at, wcut_study *study) {
    wcut_study_parameter *p = &study->parameter[study->parameters++];
    const bool pointer = *at->key != '-' && wcut_pointer_is_valid(at->key); /* "": the whole input */
    const bool option = strncmp(at->key, "--", 2) == 0 && at->key[2] &&
                        strspn(at->key, "abcdefghijklmnopqrstuvwxyz-") == strlen(at->key);
    if (!wcut_utf8_is_plain(at->key) || (!pointer && !option))
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT,
                           "a parameter's name that is a JSON pointer (/process/heat_W_per_m) or an option (--nodes)");
    p->name = wcut_copy_text(at->key);
    return (p->name || wcut_refuse_memory(reader)) && (!at->value || read_value_list(reader, at, study, p));
}

static bool make_room(wcut_reader *reader, const wcut_place *at, wcut_study *study, size_t n) {
    if (n < 1 || n > WCUT_STUDY_PARAMETERS_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "1 to %d parameters", WCUT_STUDY_PARAMETERS_MAX);
    study->parameter = wcut_alloc(n, sizeof *study->parameter);
    study->parameter_name = wcut_alloc(n, sizeof *study->parameter_name);
    return (study->parameter && study->parameter_name) || wcut_refuse_memory(reader);
}

bool wcut_study_read_parameters(wcut_reader *reader, const wcut_place *at, wcut_study *study) {
    if (!json_is_object(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object");
    if (!make_room(reader, at, study, json_object_size(at->value))) return false;
    for (void *i = json_object_iter((json_t *)at->value); i; i = json_object_iter_next((json_t *)at->value, i)) {
        const wcut_place member = {at, json_object_iter_key(i), 0, json_object_iter_value(i)};
        if (!read_parameter(reader, &member, study)) return false;
    }
    return true;
}

/* ---- rows ---- */

/* a field that is no number: true, false or a text */
static bool take_row_text(void *context, int row, int column, const char *text) {
    json_t *value = strcmp(text, "true") == 0    ? json_true()
                    : strcmp(text, "false") == 0 ? json_false()
                                                 : json_string_nocheck(text);
    return json_array_append_new(context, json_pack("[i,i,o]", row, column, value)) == 0;
}

/* every column is a parameter, every row a case; texts: [row, column, value] of the fields that are no numbers */
static bool take_rows(wcut_reader *reader, const wcut_place *at, wcut_study *study, const wcut_table *table,
                      const json_t *texts) {
    if (table->rows < 1 || table->rows > WCUT_STUDY_CASES_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a file of 1 to %d rows, not %d", WCUT_STUDY_CASES_MAX,
                           table->rows);
    if (!make_room(reader, at, study, (size_t)table->columns)) return false;
    for (int c = 0; c < table->columns; c++) {
        const wcut_column *column = &table->column[c];
        const wcut_place place = {at, column->name, 0, NULL};
        if (!read_parameter(reader, &place, study)) return false;
        if (column->missing > column->text)
            return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a value in every row of column %s", column->name);
        json_t *list = study->parameter[c].list = json_array();
        for (int r = 0; r < table->rows; r++)
            if (json_array_append_new(list, json_real(column->value[r]))) return wcut_refuse_memory(reader);
    }

    /* texts take the places that they left empty */
    for (size_t i = 0; i < json_array_size(texts); i++) {
        const json_t *field = json_array_get(texts, i);
        const json_int_t row = json_integer_value(json_array_get(field, 0));
        const json_int_t column = json_integer_value(json_array_get(field, 1));
        json_t *value = json_incref(json_array_get(field, 2));
        if (json_array_set_new(study->parameter[column].list, (size_t)row, value)) return wcut_refuse_memory(reader);
    }

    /* as values of a list are */
    for (int c = 0; c < table->columns; c++) {
        const wcut_place place = {at, table->column[c].name, 0, NULL};
        if (!check_list(reader, &place, &study->parameter[c])) return false;
    }
    return true;
}

bool wcut_study_read_rows(wcut_reader *reader, const wcut_place *at, wcut_study *study) {
    wcut_table *table = NULL;
    char *text = NULL, *path = wcut_study_join(study, study->rows);
    size_t length = 0;
    if (!path) return wcut_refuse_memory(reader);
    reader->status = wcut_file_read(path, WCUT_STUDY_BYTES_MAX, &text, &length, reader->error);
    json_t *texts = json_array();
    if (reader->status == WCUT_OK)
        reader->status = wcut_csv_parse_texts(text, length, path, take_row_text, texts, &table, reader->error);
    free(text);
    wcut_free(path);
    const bool whole = table && take_rows(reader, at, study, table, texts);
    json_decref(texts);
    wcut_table_destroy(table);
    return whole;
}

/* ---- cases ---- */

static int length_of(const wcut_study_parameter *p) { return (int)json_array_size(p->list); }

static bool combine_grid(wcut_reader *reader, const wcut_place *at, wcut_study *study) {
    double cases = 1;
    for (int p = 0; p < study->parameters; p++) cases *= length_of(&study->parameter[p]);
    if (cases > WCUT_STUDY_CASES_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a grid of at most %d cases, not of %.15g",
                           WCUT_STUDY_CASES_MAX, cases);
    study->info.cases = (int)cases;
    return true;
}

static bool combine_zip(wcut_reader *reader, const wcut_place *at, wcut_study *study) {
    study->info.cases = length_of(&study->parameter[0]);
    for (int p = 1; p < study->parameters; p++)
        if (length_of(&study->parameter[p]) != study->info.cases)
            return wcut_refuse(
                reader, at, WCUT_BAD_ARGUMENT, "lists of one length to be taken side by side: %s has %d values, %s %d",
                study->parameter[0].name, study->info.cases, study->parameter[p].name, length_of(&study->parameter[p]));
    return true;
}

static bool combine_samples(wcut_reader *reader, const wcut_place *at, wcut_study *study) {
    if (study->asked < 1)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "\"cases\" beside it: how many samples are drawn");
    if (study->combine == WCUT_COMBINE_SOBOL && study->parameters > WCUT_SOBOL_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "at most %d parameters of a Sobol sequence", WCUT_SOBOL_MAX);
    study->info.cases = study->asked;
    for (int p = 0; p < study->parameters && study->combine == WCUT_COMBINE_LATIN; p++) {
        int *interval = study->parameter[p].interval = wcut_alloc((size_t)study->asked, sizeof *interval);
        if (!interval) return wcut_refuse_memory(reader);
        wcut_latin_fill(p, study->asked, (uint64_t)study->seed, interval);
    }
    return true;
}

bool wcut_study_combine(wcut_reader *reader, const wcut_place *at, wcut_study *study) {
    if (!is_sampled(study) && study->asked > 0)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "no \"cases\": latin_hypercube and sobol alone draw samples");
    if (study->combine == WCUT_COMBINE_GRID) return combine_grid(reader, at, study);
    return is_sampled(study) ? combine_samples(reader, at, study) : combine_zip(reader, at, study);
}
