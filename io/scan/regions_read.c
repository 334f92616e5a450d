/* Zones and sections from JSON, "wirecut-zones/1". */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/regions.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/json_read.h"
#include "io/file/read_file.h"
#include "io/scan/face_choice.h"

#define FORMAT "wirecut-zones/1"
enum { BYTES_MAX = 16 << 20 };
static const double FAR = 1e12; /* [mm] */

/* ---- values ---- */

static bool read_region_name(wcut_reader *reader, const wcut_place *at, void *into) {
    const char *name = json_string_value(at->value);
    const size_t n = name ? strlen(name) : 0;
    bool plain = n > 0 && n < WCUT_REGION_NAME;
    for (size_t k = 0; plain && k < n; k++) plain = (unsigned char)name[k] >= 0x20 && !strchr("\",;\x7f", name[k]);
    if (!plain)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a name of 1 to %d bytes without quotes, commas, semicolons",
                           WCUT_REGION_NAME - 1);
    memcpy(into, name, n + 1);
    return true;
}

static bool read_coordinate(wcut_reader *reader, const wcut_place *at, void *into) {
    double *to = into;
    if (!wcut_read_finite(reader, at, to)) return false;
    return fabs(*to) <= FAR || wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a coordinate up to 1e12 mm");
}

/* [x, y] */
static bool read_pair(wcut_reader *reader, const wcut_place *at, void *into) {
    if (json_array_size(at->value) != 2) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "two numbers, [x, y]");
    for (size_t k = 0; k < 2; k++) {
        const wcut_place item = {at, NULL, k, json_array_get(at->value, k)};
        if (!read_coordinate(reader, &item, (double *)into + k)) return false;
    }
    return true;
}

static bool read_pairs(wcut_reader *reader, const wcut_place *at, int min, int *count, double **pair) {
    return wcut_read_array(reader, at, min, WCUT_REGION_POINTS_MAX, "points [x, y]", read_pair, 2 * sizeof(double),
                           count, (void **)pair);
}

static bool read_share(wcut_reader *reader, const wcut_place *at, void *into) {
    double *to = into;
    if (!wcut_read_finite(reader, at, to)) return false;
    if (!(*to >= 0 && *to <= 100)) return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a percentage, 0 to 100");
    *to /= 100;
    return true;
}

/* ---- zones ---- */

static bool read_box(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_region *r = into;
    if (json_array_size(at->value) != 2)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "two corners, [[x, y, z], [x, y, z]]");
    const wcut_place low = {at, NULL, 0, json_array_get(at->value, 0)},
                     high = {at, NULL, 1, json_array_get(at->value, 1)};
    if (!wcut_read_point(reader, &low, &r->low) || !wcut_read_point(reader, &high, &r->high)) return false;
    return (r->low.x < r->high.x && r->low.y < r->high.y && r->low.z <= r->high.z) ||
           wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a lower corner, then an upper one");
}

/* a polygon's box in x and y, and all heights */
static void frame_polygon(wcut_region *r) {
    r->low = (wcut_vec3){INFINITY, INFINITY, -INFINITY}, r->high = (wcut_vec3){-INFINITY, -INFINITY, INFINITY};
    for (int k = 0; k < r->corners; k++) {
        const double *p = &r->corner[2 * (size_t)k];
        r->low.x = fmin(r->low.x, p[0]), r->low.y = fmin(r->low.y, p[1]);
        r->high.x = fmax(r->high.x, p[0]), r->high.y = fmax(r->high.y, p[1]);
    }
}

static bool read_polygon(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_region *r = into;
    if (!read_pairs(reader, at, 3, &r->corners, &r->corner)) return false;
    frame_polygon(r);
    return true;
}

/* ---- a face of a CAD file, seen along z ---- */

/* enough for a border within 0.005 mm; more would make every point slow */
enum { FACE_POINTS_MAX = 20000, SIDE_POINTS = 100 };

/* a border that is all of a surface: its four sides */
static wcut_status trace_surface(const wcut_surface *s, int *count, double **corner) {
    double first[2], last[2];
    double *to = wcut_alloc(4 * (size_t)SIDE_POINTS, 2 * sizeof *to);
    if (!to) return WCUT_NO_MEMORY;
    wcut_surface_domain(s, first, last);
    for (int k = 0; k < 4 * SIDE_POINTS; k++) {
        const double t = (double)(k % SIDE_POINTS) / SIDE_POINTS;
        const double share[4][2] = {{t, 0}, {1, t}, {1 - t, 1}, {0, 1 - t}};
        const double *at = share[k / SIDE_POINTS];
        wcut_vec3 p;
        const wcut_status status = wcut_surface_eval(s, first[0] + at[0] * (last[0] - first[0]),
                                                     first[1] + at[1] * (last[1] - first[1]), 0, &p);
        if (status != WCUT_OK) {
            wcut_free(to);
            return status;
        }
        to[2 * (size_t)k] = p.x, to[2 * (size_t)k + 1] = p.y;
    }
    *count = 4 * SIDE_POINTS, *corner = to;
    return WCUT_OK;
}

/* Loops as one polygon: from the first point of the first to each other loop, around it and back, so that the way there
   is run through twice and counts for nothing. */
static wcut_status trace_loops(const wcut_trimmed *t, int *count, double **corner) {
    const size_t points = (size_t)t->first[t->loops] + 2 * (size_t)t->loops;
    double *to = wcut_alloc(points, 2 * sizeof *to);
    if (!to) return WCUT_NO_MEMORY;
    int n = 0;
    for (int l = 0; l < t->loops; l++) {
        const int from = t->first[l], end = t->first[l + 1];
        for (int k = from; k <= end; k++, n++) {
            const wcut_vec3 p = t->point[k < end ? k : from];
            to[2 * (size_t)n] = p.x, to[2 * (size_t)n + 1] = p.y;
        }
        if (l == 0) continue;
        to[2 * (size_t)n] = t->point[0].x, to[2 * (size_t)n + 1] = t->point[0].y;
        n++;
    }
    *count = n, *corner = to;
    return WCUT_OK;
}

/* twice the area of a polygon */
static double polygon_area(int count, const double *corner) {
    double sum = 0;
    for (int k = 0, last = count - 1; k < count; last = k++) {
        const double *a = &corner[2 * (size_t)last], *b = &corner[2 * (size_t)k];
        sum += a[0] * b[1] - b[0] * a[1];
    }
    return fabs(sum);
}

static bool take_face(wcut_reader *reader, const wcut_place *at, const wcut_trimmed_set *set, const char *choice,
                      wcut_region *r) {
    char names[160];
    int *face = wcut_alloc((size_t)set->count, sizeof *face);
    if (!face) return wcut_refuse_memory(reader);
    const int found = wcut_face_choose(set, choice, face), chosen = face[0];
    wcut_free(face);
    wcut_face_list(set, names, sizeof names);
    if (found != 1)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "one face of the file by its name or number: %s", names);

    /* its border in the plane, and the box of that */
    const wcut_trimmed *t = set->face[chosen];
    if (t->loops > 0 && t->first[t->loops] > FACE_POINTS_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a border of up to %d points", FACE_POINTS_MAX);
    const wcut_status status =
        t->loops > 0 ? trace_loops(t, &r->corners, &r->corner) : trace_surface(t->surface, &r->corners, &r->corner);
    if (status == WCUT_NO_MEMORY) return wcut_refuse_memory(reader);
    if (status != WCUT_OK) return wcut_refuse(reader, at, status, "a face that can be evaluated");
    frame_polygon(r);
    const double wide = r->high.x - r->low.x, long_ = r->high.y - r->low.y;
    return polygon_area(r->corners, r->corner) > 1e-6 * (wide * wide + long_ * long_) ||
           wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a face that is not seen on edge along z");
}

/* a file beside that of the zones */
static bool join_path(const char *beside, const char *name, char *path, size_t size) {
    const int folder = name[0] == '/' ? 0 : (int)wcut_folder_length(beside);
    const int n = snprintf(path, size, "%.*s%s", folder, beside, name);
    return n > 0 && (size_t)n < size;
}

/* {"file": "zones.step", "face": "pad" or 2} */
static bool read_step_face(wcut_reader *reader, const wcut_place *at, void *into) {
    const wcut_place file = wcut_place_member(at, "file"), face = wcut_place_member(at, "face");
    char path[4096], number[16];
    const char *key;
    json_t *value;
    json_object_foreach((json_t *)at->value, key, value) if (strcmp(key, "file") != 0 && strcmp(key, "face") != 0) {
        const wcut_place other = wcut_place_member(at, key);
        return wcut_refuse(reader, &other, WCUT_BAD_FORMAT, "\"file\" and \"face\" alone");
    }
    if (!json_is_string(file.value) || !json_string_value(file.value)[0])
        return wcut_refuse(reader, &file, WCUT_BAD_FORMAT, "the name of a STEP or IGES file");
    const char *choice = face.value ? json_string_value(face.value) : NULL;
    const double given = json_is_number(face.value) ? json_number_value(face.value) : 0;
    if (given >= 1 && given < 1e6 && given == floor(given)) {
        snprintf(number, sizeof number, "%d", (int)given);
        choice = number;
    }
    if (face.value && !choice) return wcut_refuse(reader, &face, WCUT_BAD_FORMAT, "a name or a number from 1");
    if (!join_path(reader->label, json_string_value(file.value), path, sizeof path))
        return wcut_refuse(reader, &file, WCUT_BAD_ARGUMENT, "a shorter name");

    /* what is wrong in that file is said in its own words */
    wcut_trimmed_set *set = NULL;
    const wcut_status status = wcut_trimmed_set_read(path, &set, reader->error);
    if (status != WCUT_OK) {
        if (reader->status == WCUT_OK) reader->status = status;
        return false;
    }
    const bool taken = take_face(reader, face.value ? &face : at, set, choice, into);
    wcut_trimmed_set_destroy(set);
    return taken;
}

static bool read_region(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {
        {"name", true, read_region_name, offsetof(wcut_region, name)},
        {"box_mm", false, read_box, 0},
        {"polygon_mm", false, read_polygon, 0},
        {"step_face", false, read_step_face, 0},
        {"tolerance_mm", false, wcut_read_positive, offsetof(wcut_region, tolerance)},
        {"share_percent", false, read_share, offsetof(wcut_region, share)},
    };
    wcut_region *r = into;
    const char *const shape[] = {"box_mm", "polygon_mm", "step_face"};
    int shapes = 0;
    for (int k = 0; k < 3; k++) shapes += json_object_get(at->value, shape[k]) != NULL;
    r->share = 0.95;
    if (json_is_object(at->value) && shapes != 1)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "one of \"box_mm\", \"polygon_mm\", \"step_face\"");
    return wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, r);
}

/* ---- sections ---- */

static bool read_section_line(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_section *s = into;
    if (!read_pairs(reader, at, 2, &s->points, &s->point)) return false;
    for (int k = 0; k + 1 < s->points; k++) {
        const double *p = &s->point[2 * (size_t)k];
        if (p[0] == p[2] && p[1] == p[3]) return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "neighbours apart");
    }
    return true;
}

static bool read_section(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {
        {"name", true, read_region_name, offsetof(wcut_section, name)},
        {"line_mm", true, read_section_line, 0},
        {"width_mm", false, wcut_read_positive, offsetof(wcut_section, width)},
        {"step_mm", false, wcut_read_positive, offsetof(wcut_section, step)},
    };
    wcut_section *s = into;
    s->width = 10, s->step = 10;
    return wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, s);
}

/* ---- the whole ---- */

static bool read_zone_list(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_regions *r = into;
    return wcut_read_array(reader, at, 0, WCUT_REGIONS_MAX, "zones", read_region, sizeof(wcut_region), &r->regions,
                           (void **)&r->region);
}

static bool read_section_list(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_regions *r = into;
    return wcut_read_array(reader, at, 0, WCUT_SECTIONS_MAX, "sections", read_section, sizeof(wcut_section),
                           &r->sections, (void **)&r->section);
}

static bool read_zones_format(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)into;
    return wcut_read_format(reader, at, FORMAT);
}

static bool read_regions(wcut_reader *reader, const wcut_place *root, wcut_regions *r) {
    static const wcut_field fields[] = {{"format", true, read_zones_format, 0},
                                        {"zones", false, read_zone_list, 0},
                                        {"sections", false, read_section_list, 0}};
    const wcut_place format = wcut_place_member(root, "format");
    if (json_is_object(root->value) && !wcut_read_format(reader, &format, FORMAT)) return false;
    if (!wcut_read_object(reader, root, fields, sizeof fields / sizeof *fields, r)) return false;
    return r->regions + r->sections > 0 || wcut_refuse(reader, root, WCUT_BAD_FORMAT, "a zone or a section at least");
}

void wcut_regions_destroy(wcut_regions *r) {
    if (!r) return;
    for (int k = 0; r->region && k < r->regions; k++) wcut_free(r->region[k].corner);
    for (int k = 0; r->section && k < r->sections; k++) wcut_free(r->section[k].point);
    wcut_free(r->region);
    wcut_free(r->section);
    wcut_free(r);
}

wcut_status wcut_regions_read(const char *path, wcut_regions **regions, wcut_error *error) {
    if (!path || !regions) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    char *text = NULL;
    size_t length = 0;
    const wcut_status status = wcut_file_read(path, BYTES_MAX, &text, &length, error);
    if (status != WCUT_OK) return status;

    /* the zones and sections of the text */
    wcut_reader reader = {path, error, WCUT_OK};
    json_t *json = wcut_json_load(&reader, text, length);
    free(text);
    if (!json) return reader.status;
    const wcut_place root = {.value = json};
    wcut_regions *r = wcut_alloc(1, sizeof *r);
    const bool done = r ? read_regions(&reader, &root, r) : wcut_refuse_memory(&reader);
    json_decref(json);
    if (done) {
        *regions = r;
        return WCUT_OK;
    }
    wcut_regions_destroy(r);
    return reader.status;
}
