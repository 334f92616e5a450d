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

static bool read_polygon(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_region *r = into;
    if (!read_pairs(reader, at, 3, &r->corners, &r->corner)) return false;
    r->low = (wcut_vec3){INFINITY, INFINITY, -INFINITY}, r->high = (wcut_vec3){-INFINITY, -INFINITY, INFINITY};
    for (int k = 0; k < r->corners; k++) {
        const double *p = &r->corner[2 * (size_t)k];
        r->low.x = fmin(r->low.x, p[0]), r->low.y = fmin(r->low.y, p[1]);
        r->high.x = fmax(r->high.x, p[0]), r->high.y = fmax(r->high.y, p[1]);
    }
    return true;
}

static bool read_region(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {
        {"name", true, read_region_name, offsetof(wcut_region, name)},
        {"box_mm", false, read_box, 0},
        {"polygon_mm", false, read_polygon, 0},
        {"tolerance_mm", false, wcut_read_positive, offsetof(wcut_region, tolerance)},
        {"share_percent", false, read_share, offsetof(wcut_region, share)},
    };
    wcut_region *r = into;
    const bool box = json_object_get(at->value, "box_mm"), polygon = json_object_get(at->value, "polygon_mm");
    r->share = 0.95;
    if (json_is_object(at->value) && box == polygon)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "either \"box_mm\" or \"polygon_mm\"");
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
