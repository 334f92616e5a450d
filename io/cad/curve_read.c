/* Curves in: which format a file has, and, where a file is refused, how one looks that is not. */
#include "io/cad/curve_set.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/alloc.h"
#include "io/file/look.h"
#include "io/file/read_file.h"
#include "io/process/curve_json.h"

#define BYTES_MAX ((size_t)256 << 20)

wcut_curve_read_options wcut_curve_read_options_default(void) {
    return (wcut_curve_read_options){.format = WCUT_CURVE_FORMAT_ANY, .interpolate = 1, .max_curves = 10000};
}

/* a text that begins with a bracket is JSON, but for a row of three numbers in brackets */
static bool begins_as_json(const char *text, size_t length) {
    size_t at = length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (at < length && strchr(" \t\r\n", text[at])) at++;
    if (at == length || (text[at] != '{' && text[at] != '[')) return false;
    const size_t line = strcspn(text + at, "\r\n");
    return text[at] == '{' ? memchr(text + at, '"', length - at) != NULL
                           : line < 2 || text[at + 1] == '[' || text[at + 1] == '{';
}

static wcut_curve_format find_curve_format(const char *text, size_t length, const char *label) {
    static const struct {
        const char *ending;
        wcut_curve_format format;
    } known[] = {
        {".step", WCUT_CURVE_FORMAT_STEP},    {".stp", WCUT_CURVE_FORMAT_STEP},  {".p21", WCUT_CURVE_FORMAT_STEP},
        {".igs", WCUT_CURVE_FORMAT_IGES},     {".iges", WCUT_CURVE_FORMAT_IGES}, {".json", WCUT_CURVE_FORMAT_JSON},
        {".geojson", WCUT_CURVE_FORMAT_JSON}, {".csv", WCUT_CURVE_FORMAT_CSV},   {".tsv", WCUT_CURVE_FORMAT_CSV},
        {".txt", WCUT_CURVE_FORMAT_CSV},      {".xyz", WCUT_CURVE_FORMAT_CSV},   {".asc", WCUT_CURVE_FORMAT_CSV},
        {".dat", WCUT_CURVE_FORMAT_CSV}};

    /* the ending decides, except that a STEP file shows itself and a table may contain JSON */
    const size_t n = strlen(label);
    if (strncmp(text, "ISO-10303-21;", 13) == 0) return WCUT_CURVE_FORMAT_STEP;
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        const size_t m = strlen(known[k].ending);
        if (n <= m || strcasecmp(label + n - m, known[k].ending) != 0) continue;
        if (known[k].format == WCUT_CURVE_FORMAT_CSV && begins_as_json(text, length)) return WCUT_CURVE_FORMAT_JSON;
        return known[k].format;
    }

    /* without a known ending: the section letter of IGES in column 73, or the first character of JSON */
    if (length > 80 && text[72] == 'S' && (text[80] == '\n' || text[80] == '\r')) return WCUT_CURVE_FORMAT_IGES;
    return begins_as_json(text, length) ? WCUT_CURVE_FORMAT_JSON : WCUT_CURVE_FORMAT_ANY;
}

static bool fill_curve(wcut_curve_reader *r, char *text, size_t length) {
    static wcut_curves_fill *const by_format[] = {NULL, wcut_curves_fill_step, wcut_curves_fill_iges,
                                                  wcut_curves_fill_json, wcut_curves_fill_csv};
    wcut_curve_set *set = r->set;
    set->format =
        r->options->format != WCUT_CURVE_FORMAT_ANY ? r->options->format : find_curve_format(text, length, r->label);
    if (set->format == WCUT_CURVE_FORMAT_ANY &&
        wcut_look_refuse(text, length, r->label, "curves: STEP, IGES, JSON or a table", &r->failure) != WCUT_OK)
        return false;
    if (set->format == WCUT_CURVE_FORMAT_ANY)
        return wcut_curves_refuse(r, "found no curves in a known format, expected STEP, IGES, JSON or a table");
    if (!by_format[set->format](r, text, length)) return false;
    if (set->count > 0) return true;
    return set->left_out
               ? wcut_curves_refuse(r, "found no curve that is read, %d left out: %s", set->left_out, set->why)
               : wcut_curves_refuse(r, "found no curve, expected at least one");
}

/* a text that is refused gets a small example of what is read behind its refusal */
static void show_form(wcut_error *failure, wcut_curve_format format) {
    static const char *const form[WCUT_CURVE_FORMAT_COUNT] = {
        [WCUT_CURVE_FORMAT_JSON] = (WCUT_CURVES_FORM_JSON),
        [WCUT_CURVE_FORMAT_CSV] = (WCUT_CURVES_FORM_CSV),
    };
    const size_t used = strlen(failure->text);
    if (failure->status == WCUT_BAD_FORMAT && form[format])
        snprintf(failure->text + used, sizeof failure->text - used, "; two edges are written as %s", form[format]);
}

wcut_status wcut_curve_set_read_memory(char *text, size_t length, const char *label,
                                       const wcut_curve_read_options *options, wcut_curve_set **set,
                                       wcut_error *error) {
    wcut_curve_reader r = {.label = label, .options = options, .set = wcut_alloc(1, sizeof(wcut_curve_set))};
    if (r.set && fill_curve(&r, text, length)) {
        *set = r.set;
        return WCUT_OK;
    }
    if (!r.set) wcut_curves_refuse_memory(&r);
    if (r.set) show_form(&r.failure, r.set->format);
    wcut_curve_set_destroy(r.set);
    if (error) *error = r.failure;
    return r.failure.status;
}

wcut_status wcut_curve_set_read(const char *path, const wcut_curve_read_options *options, wcut_curve_set **set,
                                wcut_error *error) {
    const wcut_curve_read_options o = options ? *options : wcut_curve_read_options_default();
    char *text = NULL;
    size_t length = 0;
    if (!path || !set || (unsigned)o.format >= WCUT_CURVE_FORMAT_COUNT || o.max_curves < 1 ||
        (unsigned)o.interpolate > 1)
        return WCUT_BAD_ARGUMENT;
    wcut_status status = wcut_file_read(path, BYTES_MAX, &text, &length, error);
    if (status == WCUT_OK) status = wcut_curve_set_read_memory(text, length, path, &o, set, error);
    free(text);
    return status;
}
