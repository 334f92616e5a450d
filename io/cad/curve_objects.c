/* Curves in: JSON, as our own files have it and as others write it down: lists of points, named curves, records, GeoJSON. */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/cad/curve_set.h"
#include "io/cad/point_columns.h"
#include "io/cad/point_group.h"
#include "io/file/number.h"
#include "io/file/unit.h"
#include "io/process/curve_json.h"
#include "io/process/job.h"

enum { DEPTH_MAX = 8 };

/* who reads, the unit that holds where none is stated, and how deep the values lie */
typedef struct object_reader {
    wcut_reader json;
    wcut_curve_reader *r;
    double unit; /* [mm] 0: none is stated */
    int depth;
} object_reader;

/* ---- keys ---- */

/* whether a key is a word, alone or with a unit behind it: "points", "points_m"; *unit 0: none */
static bool match_key(const char *key, const char *word, double *unit) {
    const size_t n = strlen(word);
    *unit = 0;
    if (strncasecmp(key, word, n) != 0) return false;
    if (!key[n]) return true;
    if (key[n] != '_') return false;
    *unit = wcut_unit_find(key + n + 1, strlen(key + n + 1));
    return *unit > 0;
}

/* the member whose key is a word, with or without a unit */
static const char *find_key(const json_t *object, const char *word, double *unit) {
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)object, key, value) if (match_key(key, word, unit)) return key;
    return NULL;
}

/* what is said about curves and is none */
static bool is_remark(const char *key, const json_t *value) {
    static const char *const word[] = {"name",  "title",  "comment", "comments", "description", "note",
                                       "notes", "author", "date",    "source",   "version",     "format",
                                       "label", "id",     "part",    "unit",     "units",       "closed",
                                       "color", "colour", "layer",   NULL};
    if (strncmp(key, "x-", 2) == 0) return true;
    if (json_is_array(value) || json_is_object(value)) return false;
    for (const char *const *w = word; *w; w++)
        if (strcasecmp(*w, key) == 0) return true;
    return false;
}

/* ---- points ---- */

static bool is_object_point(const json_t *value) {
    double unit;
    if (json_is_array(value)) return json_is_number(json_array_get(value, 0));
    const char *x = json_is_object(value) ? find_key(value, "x", &unit) : NULL;
    return x && !json_is_array(json_object_get(value, x)) && find_key(value, "y", &unit);
}

/* the unit that counts: of the key, else of the file, else mm */
static double scale_of(const object_reader *o, double unit) { return unit > 0 ? unit : o->unit > 0 ? o->unit : 1; }

static bool read_number_in(object_reader *o, const wcut_place *at, double scale, double *to) {
    if (!wcut_read_finite(&o->json, at, to)) return false;
    *to *= scale;
    if (*to >= -1e12 && *to <= 1e12) return true;
    return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "a coordinate up to 1e12 mm");
}

/* [x, y, z], or {"x": , "y": , "z": } */
static bool read_object_point(object_reader *o, const wcut_place *at, double scale, wcut_vec3 *point) {
    static const char *const axis[] = {"x", "y", "z"};
    double *to = &point->x, unit;

    /* an array of three numbers, in the unit of the file */
    if (json_is_array(at->value)) {
        if (json_array_size(at->value) != 3)
            return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "three numbers, [x, y, z]");
        for (size_t k = 0; k < 3; k++) {
            const wcut_place item = {at, NULL, k, json_array_get(at->value, k)};
            if (!read_number_in(o, &item, scale, &to[k])) return false;
        }
        return true;
    }

    /* an object with members x, y and z, which may name their own unit */
    for (int k = 0; k < 3; k++) {
        const char *key = json_is_object(at->value) ? find_key(at->value, axis[k], &unit) : NULL;
        if (!key) return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "a point: [x, y, z] or x, y and z");
        const wcut_place item = wcut_place_member(at, key);
        if (!read_number_in(o, &item, unit > 0 ? unit : scale, &to[k])) return false;
    }
    return true;
}

/* a curve through points, which are taken */
static bool add_points(object_reader *o, const wcut_place *at, int count, wcut_vec3 *point, const char *name) {
    wcut_curve *curve = NULL;
    const wcut_status status = count >= 2 ? wcut_curve_interpolate(count, point, &curve) : WCUT_DEGENERATE;
    wcut_free(point);
    if (status == WCUT_NO_MEMORY) return wcut_refuse_memory(&o->json);
    if (status != WCUT_OK)
        return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "two points or more of which no two neighbours coincide");
    return wcut_curves_add(o->r, curve, name, strlen(name));
}

static bool read_point_list(object_reader *o, const wcut_place *at, double unit, const char *name) {
    const size_t count = json_array_size(at->value);
    wcut_vec3 *point = count <= WCUT_JOB_STATIONS_MAX ? wcut_alloc(count, sizeof *point) : NULL;
    if (count > WCUT_JOB_STATIONS_MAX)
        return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "at most %d points", WCUT_JOB_STATIONS_MAX);
    if (!point) return wcut_refuse_memory(&o->json);
    for (size_t k = 0; k < count; k++) {
        const wcut_place item = {at, NULL, k, json_array_get(at->value, k)};
        if (read_object_point(o, &item, scale_of(o, unit), &point[k])) continue;
        wcut_free(point);
        return false;
    }
    return add_points(o, at, (int)count, point, name);
}

/* {"x": [...], "y": [...], "z": [...]} */
static bool read_point_columns(object_reader *o, const wcut_place *at, const char *name) {
    static const char *const axis[] = {"x", "y", "z"};
    wcut_place column[3];
    double unit[3];

    /* the three arrays, of equal length */
    for (int k = 0; k < 3; k++) {
        const char *key = find_key(at->value, axis[k], &unit[k]);
        column[k] = wcut_place_member(at, key ? key : axis[k]);
        if (!key || json_array_size(column[k].value) != json_array_size(column[0].value))
            return wcut_refuse(&o->json, &column[k], WCUT_BAD_FORMAT, "arrays x, y and z of one length");
    }

    /* limit before memory; the buffer of points goes to the curve, or is freed */
    const size_t count = json_array_size(column[0].value);
    if (count > WCUT_JOB_STATIONS_MAX)
        return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "at most %d points", WCUT_JOB_STATIONS_MAX);
    wcut_vec3 *point = wcut_alloc(count, sizeof *point);
    if (!point) return wcut_refuse_memory(&o->json);

    /* x, y and z of point 0, then of point 1, and so on */
    for (size_t k = 0; k < 3 * count; k++) {
        const wcut_place item = {&column[k % 3], NULL, k / 3, json_array_get(column[k % 3].value, k / 3)};
        if (read_number_in(o, &item, scale_of(o, unit[k % 3]), &point[k / 3].x + k % 3)) continue;
        wcut_free(point);
        return false;
    }
    return add_points(o, at, (int)count, point, name);
}

/* ---- records: a point a record, with what names its curve ---- */

/* the key of a first record that names the curve; NULL: none does */
static const char *find_name_key(const json_t *record) {
    const char *key;
    json_t *value;
    double unit;
    json_object_foreach((json_t *)record, key, value) {
        const bool axis = match_key(key, "x", &unit) || match_key(key, "y", &unit) || match_key(key, "z", &unit);
        if (!axis && (json_is_string(value) || json_is_number(value)) &&
            (wcut_point_label_whole(key, (int)strnlen(key, 100)) || strcasecmp(key, "id") == 0 ||
             strcasecmp(key, "name") == 0))
            return key;
    }
    return NULL;
}

/* the text of a name, a number as its digits */
static const char *name_of(const json_t *value, char digits[WCUT_NUMBER_SIZE + 1]) {
    if (json_is_string(value)) return json_string_value(value);
    if (!json_is_number(value)) return NULL;
    digits[wcut_number_print(json_number_value(value), digits)] = '\0';
    return digits;
}

static bool add_record(object_reader *o, const wcut_place *at, const char *key, wcut_point_names *names,
                       wcut_points *points, char **kept) {
    char digits[WCUT_NUMBER_SIZE + 1];
    wcut_vec3 point = {0, 0, 0};
    const wcut_place member = wcut_place_member(at, key);
    const char *name = name_of(member.value, digits);
    if (!name) return wcut_refuse(&o->json, &member, WCUT_BAD_FORMAT, "the curve's name");
    if (!read_object_point(o, at, scale_of(o, 0), &point)) return false;

    /* numbers as names live as long as the names do */
    const int count = names->count;
    int curve = wcut_point_names_locate(o->r, names, name, (int)strlen(name));
    if (curve >= 0 && names->count > count && name == digits) {
        kept[curve] = wcut_copy_text(digits);
        if (!kept[curve]) return wcut_curves_refuse_memory(o->r);
        names->name[curve].at = kept[curve];
    }
    return curve >= 0 && wcut_points_add(o->r, points, curve, (int)at->index, point);
}

static bool read_records(object_reader *o, const wcut_place *at, const char *key) {
    const size_t count = json_array_size(at->value);
    wcut_point_names names = {0};
    wcut_points points = {0};
    char **kept = count <= 100000000 ? wcut_alloc(count, sizeof *kept) : NULL;
    bool done = kept || wcut_refuse_memory(&o->json);
    for (size_t k = 0; done && k < count; k++) {
        const wcut_place item = {at, NULL, k, json_array_get(at->value, k)};
        done = add_record(o, &item, key, &names, &points, kept);
    }
    if (done) done = wcut_points_end(o->r, &points, names.count, &names, "record");
    for (size_t k = 0; kept && k < count; k++) wcut_free(kept[k]);
    wcut_free(kept);
    wcut_point_names_clear(&names);
    wcut_points_clear(&points);
    return done;
}

/* ---- curves ---- */

static bool read_node(object_reader *o, const wcut_place *at, const char *name);

static bool read_items(object_reader *o, const wcut_place *at) {
    if (!json_is_array(at->value)) return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "an array of curves");
    for (size_t k = 0; k < json_array_size(at->value); k++) {
        const wcut_place item = {at, NULL, k, json_array_get(at->value, k)};
        if (!read_node(o, &item, "")) return false;
    }
    return true;
}

/* a CURVE as in a job; a name, a remark beside it is taken out before the strict reader sees it */
static bool read_own_curve(object_reader *o, const wcut_place *at, const char *name) {
    json_t *plain = json_copy((json_t *)at->value);
    const char *key;
    json_t *value;
    void *next;
    if (!plain) return wcut_refuse_memory(&o->json);
    json_object_foreach_safe(plain, next, key, value) if (is_remark(key, value)) json_object_del(plain, key);
    const wcut_place place = {at->above, at->key, at->index, plain};
    wcut_curve *curve = NULL;
    bool done = wcut_read_curve(&o->json, &place, &curve);
    json_decref(plain);
    return done && wcut_curves_add(o->r, curve, name, strlen(name));
}

/* GeoJSON: the coordinates of its lines; "type" has told what the value is */
static bool read_geometry(object_reader *o, const wcut_place *at, const char *type, const char *name) {
    static const char *const held[][2] = {{"FeatureCollection", "features"},
                                          {"GeometryCollection", "geometries"},
                                          {"Feature", "geometry"},
                                          {"LineString", "coordinates"},
                                          {"MultiLineString", "coordinates"}};
    if (json_object_get(at->value, "crs"))
        return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "coordinates in mm, not those of a map (\"crs\")");
    for (size_t k = 0; k < sizeof held / sizeof *held; k++) {
        if (strcmp(type, held[k][0]) != 0) continue;
        const wcut_place member = wcut_place_member(at, held[k][1]);
        if (!member.value) return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "a member \"%s\"", held[k][1]);
        return k == 2   ? read_node(o, &member, name)
               : k == 3 ? read_point_list(o, &member, 0, name)
                        : read_items(o, &member);
    }
    return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "lines: LineString or MultiLineString");
}

/* a number of named curves beside each other, or a list of them under one key */
static bool read_members(object_reader *o, const wcut_place *at) {
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)at->value, key, value) {
        if (is_remark(key, value)) continue;
        const wcut_place member = wcut_place_member(at, key);
        if (!json_is_array(value) && !json_is_object(value))
            return wcut_refuse(&o->json, &member, WCUT_BAD_FORMAT, "a curve: \"points_mm\", or a list of points");
        if (!read_node(o, &member, key)) return false;
    }
    return true;
}

/* the unit that an object states for what it holds */
static bool use_object_unit(object_reader *o, const wcut_place *at) {
    static const char *const key[] = {"unit", "units"};
    for (int k = 0; k < 2; k++) {
        const wcut_place member = wcut_place_member(at, key[k]);
        if (!member.value) continue;
        const char *word = json_string_value(member.value);
        o->unit = word ? wcut_unit_find(word, strlen(word)) : 0;
        if (o->unit <= 0) return wcut_refuse(&o->json, &member, WCUT_BAD_FORMAT, "a unit of length such as \"mm\"");
    }
    return true;
}

static bool read_object_node(object_reader *o, const wcut_place *at, const char *name) {
    static const char *const list[] = {"points", "coordinates", "coords", "vertices", "pts", "xyz", "polyline"};
    const json_t *type = json_object_get(at->value, "type"), *own = json_object_get(at->value, "name");
    double unit;
    if (json_is_string(own)) name = json_string_value(own);

    /* a job: its design's edges */
    if (json_is_object(json_object_get(at->value, "design"))) {
        const wcut_place design = wcut_place_member(at, "design");
        const wcut_place a = wcut_place_member(&design, "edge_a"), b = wcut_place_member(&design, "edge_b");
        if (a.value && b.value) return read_node(o, &a, "edge_a") && read_node(o, &b, "edge_b");
    }

    /* a unit beside the points holds for all below it; geometry of GeoJSON has a type */
    if (!use_object_unit(o, at)) return false;
    if (json_is_string(type)) return read_geometry(o, at, json_string_value(type), name);

    /* a curve as we write it, whose unit stands in its keys */
    if (json_object_get(at->value, "points_mm") || json_object_get(at->value, "degree") ||
        json_object_get(at->value, "knots")) {
        if (o->unit > 0 && o->unit != 1)
            return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "one unit: its keys say mm, \"unit\" says another");
        return read_own_curve(o, at, name);
    }

    /* points under another name, or three columns of them */
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const char *key = find_key(at->value, list[k], &unit);
        if (!key) continue;
        const wcut_place member = wcut_place_member(at, key);
        if (json_is_array(member.value) && is_object_point(json_array_get(member.value, 0)))
            return read_point_list(o, &member, unit, name);
    }

    /* else look in the members, of which any may be a curve */
    const char *x = find_key(at->value, "x", &unit);
    if (x && json_is_array(json_object_get(at->value, x))) return read_point_columns(o, at, name);
    if (json_object_size(at->value) == 0)
        return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT,
                           "a curve: \"points_mm\", or \"degree\", \"knots\" and \"control_points_mm\"");
    return read_members(o, at);
}

static bool read_node(object_reader *o, const wcut_place *at, const char *name) {
    const double unit = o->unit;
    bool done;
    if (++o->depth > DEPTH_MAX)
        return wcut_refuse(&o->json, at, WCUT_BAD_FORMAT, "curves at most %d values deep", DEPTH_MAX);
    if (json_is_object(at->value)) {
        done = read_object_node(o, at, name);
    } else {
        const json_t *first = json_array_get(at->value, 0);
        const char *key = json_is_object(first) && is_object_point(first) ? find_name_key(first) : NULL;
        done = key                      ? read_records(o, at, key)
               : is_object_point(first) ? read_point_list(o, at, 0, name)
                                        : read_items(o, at);
    }
    o->depth--;
    o->unit = unit;
    return done;
}

bool wcut_curves_fill_json(wcut_curve_reader *r, char *text, size_t length) {
    wcut_error error = {WCUT_OK, ""};
    object_reader o = {.json = {.label = r->label, .error = &error}, .r = r};
    const bool marked = length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0;
    json_t *json = wcut_json_load(&o.json, text + (marked ? 3 : 0), length - (marked ? 3 : 0));
    const wcut_place root = {.value = json};
    const bool done = json && read_node(&o, &root, "");
    json_decref(json);
    if (!done && r->failure.status == WCUT_OK) {
        r->failure = error;
        /* a file is not an argument, however wrong its values are */
        if (r->failure.status == WCUT_BAD_ARGUMENT) r->failure.status = WCUT_BAD_FORMAT;
    }
    return done;
}
