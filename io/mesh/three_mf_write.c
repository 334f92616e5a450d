/* Meshes to a 3MF package (3MF core specification 1.3): named objects in millimetres, exact numbers. */
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/exchange.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "io/file/number.h"
#include "io/file/utf8.h"
#include "io/file/zip_write.h"
#include "io/mesh/mesh_write.h"

enum { DRAIN = 1 << 16 };

/* text on its way into the archive */
typedef struct sink {
    wcut_zip zip;
    wcut_text text;
} sink;

static void drain(sink *s) {
    wcut_zip_put(&s->zip, s->text.data, s->text.count);
    s->text.count = 0;
}

/* ---- what a mesh is ---- */

static uint64_t mix_bits(uint64_t h) {
    h = (h ^ h >> 33) * 0xff51afd7ed558ccdu;
    h = (h ^ h >> 33) * 0xc4ceb9fe1a85ec53u;
    return h ^ h >> 33;
}

/* Whether every directed edge is met by its opposite, which 3MF asks of a solid: the sum of edges' hashes less those of
   their opposites vanishes then, and otherwise but once in 2^64. */
static bool is_three_mf_closed(const wcut_mesh *mesh) {
    uint64_t sum = 0;
    for (size_t t = 0; t < (size_t)mesh->triangle_count; t++) {
        const int *v = mesh->triangle + 3 * t;
        for (int k = 0; k < 3; k++) {
            const uint64_t a = (uint64_t)v[k], b = (uint64_t)v[(k + 1) % 3];
            sum += mix_bits(a << 32 | b) - mix_bits(b << 32 | a);
        }
    }
    return sum == 0;
}

/* ---- XML ---- */

static void put_three_mf_escaped(wcut_text *text, const char *string) {
    for (const char *p = string; *p; p++) {
        if (*p == '&' || *p == '<' || *p == '>' || *p == '"')
            wcut_text_print(text, "&#%d;", *p);
        else
            wcut_text_put(text, p, 1);
    }
}

static size_t put_attribute(char *to, const char *name, double value) {
    const size_t n = strlen(name);
    memcpy(to, name, n);
    const size_t digits = (size_t)wcut_number_print(value, to + n);
    to[n + digits] = '"';
    return n + digits + 1;
}

static void put_vertex(wcut_text *text, wcut_vec3 v) {
    char *room = wcut_text_room(text);
    size_t used = put_attribute(room, "<vertex x=\"", v.x);
    used += put_attribute(room + used, " y=\"", v.y);
    used += put_attribute(room + used, " z=\"", v.z);
    memcpy(room + used, "/>\n", 3);
    text->count += used + 3;
}

static void put_material(wcut_text *text, const char *name, unsigned colour) {
    wcut_text_print(text, "<base name=\"");
    put_three_mf_escaped(text, name);
    wcut_text_print(text, "\" displaycolor=\"#%06X\"/>\n", colour & 0xffffff);
}

/* the group of an object's materials, numbered behind all objects */
static void put_materials(sink *s, const wcut_mesh_object *o, int id) {
    wcut_text_print(&s->text, "<basematerials id=\"%d\">\n", id);
    put_material(&s->text, o->material, o->colour);
    if (o->mark) put_material(&s->text, o->marked_material, o->marked_colour);
    wcut_text_print(&s->text, "</basematerials>\n");
}

static void put_object(sink *s, const wcut_mesh_object *o, int id, int materials) {
    const wcut_mesh *mesh = o->mesh;

    /* its name, and whether it is a body or an open surface */
    wcut_text_print(&s->text, "<object id=\"%d\" type=\"%s\" name=\"", id,
                    is_three_mf_closed(mesh) ? "model" : "surface");
    put_three_mf_escaped(&s->text, o->name);
    wcut_text_print(&s->text, "\"");
    if (o->material) wcut_text_print(&s->text, " pid=\"%d\" pindex=\"0\"", materials);

    /* vertices, handed to the file whenever the text has grown */
    wcut_text_print(&s->text, "><mesh><vertices>\n");
    for (int i = 0; i < mesh->vertex_count; i++) {
        put_vertex(&s->text, mesh->vertex[i]);
        if (s->text.count > DRAIN) drain(s);
    }

    /* triangles; a marked one has the second colour */
    wcut_text_print(&s->text, "</vertices><triangles>\n");
    for (size_t t = 0; t < (size_t)mesh->triangle_count; t++) {
        const int *v = mesh->triangle + 3 * t;
        wcut_text_print(&s->text, "<triangle v1=\"%d\" v2=\"%d\" v3=\"%d\"", v[0], v[1], v[2]);
        if (o->mark && o->mark[t]) wcut_text_print(&s->text, " pid=\"%d\" p1=\"1\"", materials);
        wcut_text_print(&s->text, "/>\n");
        if (s->text.count > DRAIN) drain(s);
    }
    wcut_text_print(&s->text, "</triangles></mesh></object>\n");
}

/* an object in its place: by rows of a matrix that stands behind a row of coordinates */
static void put_three_mf_item(wcut_text *text, const wcut_mesh_object *o, int id) {
    wcut_text_print(text, "<item objectid=\"%d\"", id);
    if (o->turned || o->move.x != 0 || o->move.y != 0 || o->move.z != 0) {
        const double turn = o->turned ? -1 : 1,
                     m[12] = {1, 0, 0, 0, turn, 0, 0, 0, turn, o->move.x, o->move.y, o->move.z};
        wcut_text_print(text, " transform=\"");
        for (int k = 0; k < 12; k++) {
            if (k) wcut_text_put(text, " ", 1);
            wcut_text_number(text, m[k] + 0.0);
        }
        wcut_text_print(text, "\"");
    }
    wcut_text_print(text, "/>\n");
}

static void put_model(sink *s, int count, const wcut_mesh_object *object) {
    wcut_text_print(&s->text,
                    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" "
                    "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
                    "<metadata name=\"Application\">wirecut %s</metadata>\n<resources>\n",
                    WCUT_VERSION);
    for (int k = 0; k < count; k++)
        if (object[k].material) put_materials(s, &object[k], count + 1 + k);
    for (int k = 0; k < count; k++) put_object(s, &object[k], k + 1, count + 1 + k);
    wcut_text_print(&s->text, "</resources>\n<build>\n");
    for (int k = 0; k < count; k++) {
        put_three_mf_item(&s->text, &object[k], k + 1);
        if (s->text.count > DRAIN) drain(s);
    }
    wcut_text_print(&s->text, "</build>\n</model>\n");
    drain(s);
}

/* ---- the package ---- */

static const char content_types[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
    "</Types>\n";
static const char relationships[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n"
    "<Relationship Id=\"rel0\" Target=\"/3D/3dmodel.model\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>\n"
    "</Relationships>\n";

/* false: longer than 4 GiB */
static bool put_package(sink *s, int count, const wcut_mesh_object *object) {
    wcut_zip_begin(&s->zip, "[Content_Types].xml");
    wcut_zip_put(&s->zip, content_types, sizeof content_types - 1);
    wcut_zip_end(&s->zip);
    wcut_zip_begin(&s->zip, "_rels/.rels");
    wcut_zip_put(&s->zip, relationships, sizeof relationships - 1);
    wcut_zip_end(&s->zip);
    wcut_zip_begin(&s->zip, "3D/3dmodel.model");
    put_model(s, count, object);
    wcut_zip_end(&s->zip);
    return wcut_zip_finish(&s->zip);
}

static wcut_status check_three_mf(int count, const wcut_mesh_object *object, const char *path, wcut_error *error) {
    if (count < 1 || count > INT_MAX / 2 || !object)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "found no mesh to write to a 3MF");
    for (int k = 0; k < count; k++) {
        const wcut_mesh_object *o = &object[k];
        const wcut_status status = wcut_mesh_check(o->mesh, path, error);
        if (status != WCUT_OK) return status;
        if (!o->name || !wcut_utf8_is_plain(o->name) || (o->material && !wcut_utf8_is_plain(o->material)) ||
            (o->marked_material && !wcut_utf8_is_plain(o->marked_material)))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "mesh %d: found a name that is not plain UTF-8", k);
        if (o->mark && (!o->material || !o->marked_material))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "mesh %d: found marked triangles, expected two materials", k);
        if (!isfinite(o->move.x) || !isfinite(o->move.y) || !isfinite(o->move.z))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "mesh %d: found a place that is not finite", k);
    }
    return WCUT_OK;
}

wcut_status wcut_mesh_write_3mf(int count, const wcut_mesh_object *object, const char *path, wcut_error *error) {
    wcut_file *file = NULL;

    /* the file appears only once the package is whole */
    wcut_status status = check_three_mf(count, object, path, error);
    if (status == WCUT_OK) status = wcut_file_create(path, &file, error);
    if (status != WCUT_OK) return status;

    /* the objects are packed one after the other */
    sink s = {0};
    const bool ready = wcut_zip_create(&s.zip, file) && wcut_text_create(&s.text, NULL);
    const bool fits = ready && put_package(&s, count, object);

    /* what went wrong: memory, the format's limit, or nothing */
    if (!ready || s.text.failed)
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    else if (!fits)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "found a model of more than 4 GiB, expected less: use STL");
    else
        status = wcut_file_commit(file, error);

    wcut_text_destroy(&s.text);
    wcut_zip_destroy(&s.zip);
    wcut_file_destroy(file);
    return status;
}
