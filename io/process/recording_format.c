/* How a recording's file is read: which of its columns a channel is, and in which unit, from a text or from JSON. */
#include "io/process/recording_format.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/decimal.h"

void wcut_recording_format_clear(wcut_recording_format *format) {
    if (!format) return;
    for (int k = 0; k < format->maps; k++) free(format->map[k].column);
    free(format->map);
    *format = (wcut_recording_format){0};
}

/* the channel of a name, length bytes; -1 where there is none */
static int locate_channel(const char *name, size_t length) {
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        const char *known = wcut_channel_name((wcut_channel)k);
        if (strlen(known) == length && strncmp(known, name, length) == 0) return k;
    }
    return -1;
}

static bool is_mapped(const wcut_recording_format *f, int channel) {
    for (int k = 0; k < f->maps; k++)
        if ((int)f->map[k].channel == channel) return true;
    return false;
}

/* one more map, with a copy of the column's name; false where there is no memory */
static bool add_map(wcut_recording_format *f, int channel, const char *column, size_t length) {
    wcut_column_map *grown = wcut_grow(f->map, (size_t)(f->maps + 1) * sizeof *grown);
    if (!grown) return false;
    f->map = grown;
    char *name = wcut_alloc(length + 1, 1);
    if (!name) return false;
    memcpy(name, column, length);
    grown[f->maps++] = (wcut_column_map){.channel = (wcut_channel)channel, .column = name, .factor = 1};
    return true;
}

/* ---- from a text ---- */

static wcut_status refuse_part(wcut_error *error, const char *part, size_t length, const char *expected) {
    char text[WCUT_QUOTE_SIZE], quoted[WCUT_QUOTE_SIZE];
    const size_t n = length < sizeof text - 1 ? length : sizeof text - 1;
    memcpy(text, part, n);
    text[n] = '\0';
    return wcut_fail(error, WCUT_BAD_FORMAT, "columns: found %s, expected %s",
                     wcut_quote(quoted, text, WCUT_FOUND_MAX, 0), expected);
}

/* *FACTOR, then +OFFSET or -OFFSET, up to the end of the part */
static bool read_factor(const char *at, const char *end, wcut_column_map *map) {
    if (at == end) return true;
    const char *behind = wcut_decimal_read(at + 1, &map->factor);
    if (behind == at + 1 || behind > end || !isfinite(map->factor) || map->factor == 0) return false;
    if (behind == end) return true;
    if (*behind != '+' && *behind != '-') return false;
    const char *last = wcut_decimal_read(behind, &map->offset);
    return last == end && isfinite(map->offset);
}

/* CHANNEL=COLUMN*FACTOR+OFFSET */
static wcut_status parse_map(const char *part, size_t length, wcut_recording_format *f, wcut_error *error) {
    const char *end = part + length, *equal = memchr(part, '=', length);
    if (!equal) return refuse_part(error, part, length, "CHANNEL=COLUMN");
    const int channel = locate_channel(part, (size_t)(equal - part));
    if (channel < 0) return refuse_part(error, part, (size_t)(equal - part), "the name of a channel, as force_x_N");
    if (is_mapped(f, channel)) return refuse_part(error, part, (size_t)(equal - part), "every channel once");

    /* the column's name ends at the factor */
    const char *column = equal + 1, *star = memchr(column, '*', (size_t)(end - column));
    if (!star) star = end;
    if (star == column) return refuse_part(error, part, length, "a column's name behind =");
    if (!add_map(f, channel, column, (size_t)(star - column)))
        return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    if (!read_factor(star, end, &f->map[f->maps - 1]))
        return refuse_part(error, part, length, "*FACTOR, not 0, and perhaps +OFFSET or -OFFSET behind the column");

    return WCUT_OK;
}

wcut_status wcut_recording_format_parse(const char *text, wcut_recording_format *format, wcut_error *error) {
    if (!text || !format) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_recording_format made = {0};
    wcut_status status = WCUT_OK;
    for (const char *part = text; status == WCUT_OK && *part;) {
        const size_t length = strcspn(part, ",");
        status = parse_map(part, length, &made, error);
        part += length;
        if (*part == ',' && !*++part && status == WCUT_OK)
            status = refuse_part(error, text, strlen(text), "a map behind the last comma");
    }
    if (status == WCUT_OK)
        *format = made;
    else
        wcut_recording_format_clear(&made);
    return status;
}

/* ---- from JSON ---- */

static bool read_map_column(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_text(reader, at, into);
}

static bool read_map_factor(wcut_reader *reader, const wcut_place *at, void *into) {
    double *factor = into;
    if (!wcut_read_finite(reader, at, factor)) return false;
    return *factor != 0 || wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a factor other than 0");
}

static bool read_map_offset(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_finite(reader, at, into);
}

/* a column's name, or {"column", "factor", "offset"} */
static bool read_map(wcut_reader *reader, const wcut_place *at, wcut_column_map *map) {
    static const wcut_field fields[] = {{"column", true, read_map_column, offsetof(wcut_column_map, column)},
                                        {"factor", false, read_map_factor, offsetof(wcut_column_map, factor)},
                                        {"offset", false, read_map_offset, offsetof(wcut_column_map, offset)}};
    if (!json_is_object(at->value)) return wcut_read_text(reader, at, &map->column);
    return wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, map);
}

bool wcut_read_columns(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_recording_format *f = into;
    if (!json_is_object(at->value))
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object: the columns of the file by the names of channels");
    json_t *object = (json_t *)at->value; /* jansson's iterators take no const, and change nothing */
    for (void *i = json_object_iter(object); i; i = json_object_iter_next(object, i)) {
        const char *key = json_object_iter_key(i);
        const wcut_place place = {at, key, 0, json_object_iter_value(i)};
        const int channel = locate_channel(key, strlen(key));
        if (channel < 0) return wcut_refuse(reader, &place, WCUT_BAD_FORMAT, "the name of a channel as its key");
        if (!add_map(f, channel, "", 0)) return wcut_refuse_memory(reader);
        wcut_column_map *map = &f->map[f->maps - 1];
        free(map->column);
        map->column = NULL;
        if (!read_map(reader, &place, map)) return false;
        if (!map->column[0]) return wcut_refuse(reader, &place, WCUT_BAD_ARGUMENT, "a column's name that is not empty");
    }
    return true;
}

bool wcut_read_period(wcut_reader *reader, const wcut_place *at, void *into) {
    double *period = into;
    if (!wcut_read_finite(reader, at, period)) return false;
    return (*period > 0 && *period <= 1e6) ||
           wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a period above 0 s, 1e6 at most");
}
