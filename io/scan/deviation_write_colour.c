/* Deviations as colours: points as they come, and meshes, to binary PLY; meshes to OBJ, too. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/deviation_file.h>
#include <wirecut/version.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/vec3.h"
#include "io/file/atomic.h"
#include "io/file/number.h"
#include "io/file/text.h"
#include "io/mesh/mesh_write.h"
#include "io/scan/colour.h"

/* ---- colours ---- */

/* Blue below, orange above, grey at zero; lightness falls alike on both sides, so that the sign is told by colour and
   the size by lightness, for every kind of colour vision: Oklab (Ottosson 2020), the scale of the report. */
enum { ANCHORS = 9 };
static const unsigned char anchor[ANCHORS][3] = {{0, 79, 155},    {57, 116, 179},  {110, 153, 201},
                                                 {163, 189, 219}, {225, 225, 225}, {215, 177, 159},
                                                 {193, 133, 102}, {167, 90, 46},   {139, 44, 0}};
static const unsigned char missing[3] = {158, 163, 168};

void wcut_deviation_colour(double value, double limit, unsigned char rgb[3]) {
    const double t = value / limit, s = (t < -1 ? 0 : t > 1 ? 2 : 1 + t) * (ANCHORS - 1) / 2;
    const int low = s < ANCHORS - 2 ? (int)s : ANCHORS - 2;
    for (int k = 0; k < 3; k++)
        rgb[k] = (unsigned char)(anchor[low][k] + (s - low) * (anchor[low + 1][k] - anchor[low][k]) + 0.5);
}

static void put_scale(wcut_text *text, double limit) {
    wcut_text_print(text,
                    "colour: blue at and below -L, grey at 0, orange at and above L, darker grey unmeasured; L = ");
    wcut_text_number(text, limit);
    wcut_text_print(text, " mm\n");
}

/* a value with its colour; nan and grey where there is none */
static void put_deviation_colour_value(wcut_text *text, bool there, double value, double limit) {
    unsigned char rgb[3];
    const double shown = there ? value : NAN;
    if (there)
        wcut_deviation_colour(value, limit, rgb);
    else
        memcpy(rgb, missing, sizeof rgb);
    wcut_text_put(text, &shown, sizeof shown);
    wcut_text_put(text, rgb, sizeof rgb);
}

static const char normal_properties[] = "property double nx\nproperty double ny\nproperty double nz\n";
static const char value_properties[] =
    "property double deviation_mm\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";

/* ---- points as they come ---- */

struct wcut_deviation_stream {
    wcut_file *file;
    wcut_text text;
    double limit;
    bool normals;
    int count;
    uint64_t count_at; /* where the header has the count */
};

enum { COUNT_ROOM = 10 }; /* digits of INT_MAX */

static void put_deviation_colour_header(wcut_deviation_stream *s) {
    wcut_text *t = &s->text;
    wcut_text_print(t, "ply\nformat binary_little_endian 1.0\ncomment wirecut %s\ncomment units: mm, z up\n",
                    WCUT_VERSION);
    wcut_text_print(t, "comment place: 0 inside, 1 border, 2 beyond, 3 ambiguous; the last two do not count\ncomment ");
    put_scale(t, s->limit);
    wcut_text_print(t, "element vertex ");
    s->count_at = t->count;
    wcut_text_print(t, "%-*d\n", COUNT_ROOM, 0);
    wcut_text_print(t,
                    "property double x\nproperty double y\nproperty double z\n%s%sproperty uchar place\nend_header\n",
                    s->normals ? normal_properties : "", value_properties);
}

wcut_status wcut_deviation_stream_create(const char *path, double limit, int normals, wcut_deviation_stream **stream,
                                         wcut_error *error) {
    if (!path || !stream || !isfinite(limit) || limit <= 0)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_deviation_stream *s = wcut_alloc(1, sizeof *s);
    if (!s) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    s->limit = limit, s->normals = normals != 0;
    wcut_status status = wcut_file_create(path, &s->file, error);
    if (status == WCUT_OK && !wcut_text_create(&s->text, s->file))
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    if (status != WCUT_OK) {
        wcut_deviation_stream_destroy(s);
        return status;
    }
    put_deviation_colour_header(s);
    *stream = s;
    return WCUT_OK;
}

wcut_status wcut_deviation_stream_append(wcut_deviation_stream *stream, int count, const wcut_vec3 *point,
                                         const wcut_vec3 *normal, const wcut_deviation *deviation, wcut_error *error) {
    if (!stream || count < 0 || count > INT32_MAX - stream->count ||
        (count > 0 && (!point || !deviation || stream->normals != (normal != NULL))) ||
        !vec3_all_finite(count, point) || (normal && !vec3_all_finite(count, normal)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    for (int i = 0; i < count; i++) {
        const bool there = deviation[i].place <= WCUT_PLACE_BORDER;
        const unsigned char place = (unsigned char)deviation[i].place;
        wcut_text_put(&stream->text, &point[i], sizeof point[i]);
        if (normal) wcut_text_put(&stream->text, &normal[i], sizeof normal[i]);
        put_deviation_colour_value(&stream->text, there, deviation[i].distance, stream->limit);
        wcut_text_put(&stream->text, &place, 1);
    }
    stream->count += count;
    return wcut_file_check(stream->file, error);
}

wcut_status wcut_deviation_stream_commit(wcut_deviation_stream *stream, wcut_error *error) {
    char digits[COUNT_ROOM + 1];
    if (!stream) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_text_flush(&stream->text);
    snprintf(digits, sizeof digits, "%-*d", COUNT_ROOM, stream->count);
    wcut_file_write_at(stream->file, stream->count_at, digits, COUNT_ROOM);
    return wcut_file_commit(stream->file, error);
}

void wcut_deviation_stream_destroy(wcut_deviation_stream *stream) {
    if (!stream) return;
    wcut_text_destroy(&stream->text);
    wcut_file_destroy(stream->file);
    free(stream);
}

/* ---- meshes ---- */

/* what the writers of a mesh share */
typedef struct coloured {
    const double *value;
    const unsigned char *present;
    double limit;
} coloured;

static bool is_deviation_colour_there(const coloured *c, int i) { return !c->present || c->present[i]; }

static void put_coloured_ply(wcut_text *text, const wcut_mesh *mesh, const void *context) {
    const coloured *c = context;

    /* the header: units, the scale of the colours, what a vertex and a face have */
    wcut_text_print(text, "ply\nformat binary_little_endian 1.0\ncomment wirecut %s\ncomment units: mm, z up\ncomment ",
                    WCUT_VERSION);
    put_scale(text, c->limit);
    wcut_text_print(text, "element vertex %d\nproperty double x\nproperty double y\nproperty double z\n%s%s",
                    mesh->vertex_count, mesh->normal ? normal_properties : "", value_properties);
    wcut_text_print(text, "element face %d\nproperty list uchar int vertex_indices\nend_header\n",
                    mesh->triangle_count);

    /* vertices, then triangles */
    for (int i = 0; i < mesh->vertex_count; i++) {
        wcut_text_put(text, &mesh->vertex[i], sizeof mesh->vertex[i]);
        if (mesh->normal) wcut_text_put(text, &mesh->normal[i], sizeof mesh->normal[i]);
        put_deviation_colour_value(text, is_deviation_colour_there(c, i), c->value[i], c->limit);
    }
    for (size_t t = 0; t < (size_t)mesh->triangle_count; t++) {
        const unsigned char three = 3;
        wcut_text_put(text, &three, 1);
        wcut_text_put(text, mesh->triangle + 3 * t, 3 * sizeof *mesh->triangle);
    }
}

/* "v x y z r g b", colours from 0 to 1 as most programs read them */
static void put_coloured(wcut_text *text, const coloured *c, const wcut_mesh *mesh, int i) {
    unsigned char rgb[3];
    if (is_deviation_colour_there(c, i))
        wcut_deviation_colour(c->value[i], c->limit, rgb);
    else
        memcpy(rgb, missing, sizeof rgb);
    wcut_text_put(text, "v", 1);
    for (int k = 0; k < 3; k++) {
        wcut_text_put(text, " ", 1);
        wcut_text_number(text, (&mesh->vertex[i].x)[k]);
    }
    for (int k = 0; k < 3; k++) wcut_text_print(text, " 0.%03d", rgb[k] * 999 / 255);
    wcut_text_put(text, "\n", 1);
}

static void put_coloured_obj(wcut_text *text, const wcut_mesh *mesh, const void *context) {
    const coloured *c = context;
    wcut_text_print(text, "# wirecut %s\n# units: mm, z up\n# %d vertices, %d triangles\n# ", WCUT_VERSION,
                    mesh->vertex_count, mesh->triangle_count);
    put_scale(text, c->limit);
    wcut_text_print(text, "o deviation\n");
    for (int i = 0; i < mesh->vertex_count; i++) put_coloured(text, c, mesh, i);
    for (size_t t = 0; t < (size_t)mesh->triangle_count; t++) {
        const int *v = mesh->triangle + 3 * t;
        wcut_text_print(text, "f %d %d %d\n", v[0] + 1, v[1] + 1, v[2] + 1);
    }
}

static wcut_status write_coloured(const wcut_mesh *mesh, wcut_mesh_put *put, const coloured *c, const char *path,
                                  wcut_error *error) {
    bool sound = mesh && c->value && isfinite(c->limit) && c->limit > 0;
    for (int i = 0; sound && i < mesh->vertex_count; i++) sound = isfinite(c->value[i]);
    if (!sound)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a mesh of deviations: found no mesh, or a value that is not finite");
    return wcut_mesh_write(mesh, put, c, path, error);
}

wcut_status wcut_deviation_mesh_write_ply(const wcut_mesh *mesh, const double *value, const unsigned char *present,
                                          double limit, const char *path, wcut_error *error) {
    const coloured c = {value, present, limit};
    return write_coloured(mesh, put_coloured_ply, &c, path, error);
}

wcut_status wcut_deviation_mesh_write_obj(const wcut_mesh *mesh, const double *value, const unsigned char *present,
                                          double limit, const char *path, wcut_error *error) {
    const coloured c = {value, present, limit};
    return write_coloured(mesh, put_coloured_obj, &c, path, error);
}
