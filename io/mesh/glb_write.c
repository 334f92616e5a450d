/* Triangles to binary glTF 2.0 (Khronos): a header, the scene in JSON, then positions, normals, colours, indices. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>
#include <wirecut/write.h>

#include "base/fail.h"
#include "io/mesh/colour.h"
#include "io/mesh/mesh_write.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "binary files are written as they lie in memory");

/* lengths and offsets of the format have 32 bits */
enum { TRIANGLES_MAX = 30000000 };

enum { HEADER = 12, CHUNK = 8, ARRAY_BUFFER = 34962, INDEX_BUFFER = 34963, FLOAT = 5126, UNSIGNED = 5125 };
static const uint32_t MAGIC = 0x46546c67, JSON_CHUNK = 0x4e4f534a, BIN_CHUNK = 0x004e4942;

/* what of a mesh goes into which view of the buffer, in this order */
typedef struct view {
    const char *attribute; /* NULL: indices */
    const char *type;
    int components, target;
    size_t bytes;
} view;

typedef struct layout {
    view view[4];
    int views;
    size_t bytes;   /* of the buffer */
    wcut_vec3 from; /* [mm] positions are relative to it: the middle: an error of at most 2^-24 of the half size */
    float low[3], high[3];
} layout;

static double linear_of_srgb(double byte) {
    const double s = byte / 255;
    return s <= 0.04045 ? s / 12.92 : pow((s + 0.055) / 1.055, 2.4);
}

static void add_view(layout *l, const char *attribute, const char *type, int components, size_t count, int target) {
    const size_t bytes = count * (size_t)components * 4;
    l->view[l->views++] = (view){attribute, type, components, target, bytes};
    l->bytes += bytes;
}

static wcut_vec3 relative(const layout *l, wcut_vec3 p) {
    return (wcut_vec3){p.x - l->from.x, p.y - l->from.y, p.z - l->from.z};
}

/* the views, the place that positions are relative to, and their box, which the format asks for */
static layout lay_out_views(const wcut_mesh *mesh) {
    layout l = {.low = {FLT_MAX, FLT_MAX, FLT_MAX}, .high = {-FLT_MAX, -FLT_MAX, -FLT_MAX}};

    /* views of the buffer, in the order in which they are written */
    wcut_vec3 low = mesh->vertex[0], high = mesh->vertex[0];
    const size_t n = (size_t)mesh->vertex_count;
    add_view(&l, "POSITION", "VEC3", 3, n, ARRAY_BUFFER);
    if (mesh->normal) add_view(&l, "NORMAL", "VEC3", 3, n, ARRAY_BUFFER);
    if (mesh->scalar) add_view(&l, "COLOR_0", "VEC4", 4, n, ARRAY_BUFFER);
    add_view(&l, NULL, "SCALAR", 1, 3 * (size_t)mesh->triangle_count, INDEX_BUFFER);

    /* the box in double precision */
    for (size_t i = 0; i < n; i++) {
        const wcut_vec3 p = mesh->vertex[i];
        low = (wcut_vec3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (wcut_vec3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }

    /* positions begin at the part's own middle, in whole mm: the node's matrix leads there, in double precision */
    l.from = (wcut_vec3){round(low.x / 2 + high.x / 2), round(low.y / 2 + high.y / 2), round(low.z / 2 + high.z / 2)};

    /* the box again in single precision, as a reader will see it */
    for (size_t i = 0; i < n; i++) {
        const wcut_vec3 p = relative(&l, mesh->vertex[i]);
        const float c[3] = {(float)p.x, (float)p.y, (float)p.z};
        for (int k = 0; k < 3; k++) l.low[k] = fminf(l.low[k], c[k]), l.high[k] = fmaxf(l.high[k], c[k]);
    }

    return l;
}

/* ---- the scene ---- */

static void put_glb_triple(wcut_text *t, const char *before, const float v[3]) {
    wcut_text_print(t, "%s", before);
    for (int k = 0; k < 3; k++) {
        wcut_text_print(t, k ? "," : "[");
        wcut_text_number(t, (double)v[k]);
    }
    wcut_text_print(t, "]");
}

static void put_views(wcut_text *t, const layout *l, const wcut_mesh *mesh) {
    size_t offset = 0;
    wcut_text_print(t, "\"bufferViews\":[");
    for (int k = 0; k < l->views; k++) {
        wcut_text_print(t, "%s{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"target\":%d}", k ? "," : "", offset,
                        l->view[k].bytes, l->view[k].target);
        offset += l->view[k].bytes;
    }
    wcut_text_print(t, "],\"accessors\":[");
    for (int k = 0; k < l->views; k++) {
        const view *v = &l->view[k];
        wcut_text_print(t, "%s{\"bufferView\":%d,\"componentType\":%d,\"count\":%zu,\"type\":\"%s\"", k ? "," : "", k,
                        v->attribute ? FLOAT : UNSIGNED, v->bytes / 4 / (size_t)v->components, v->type);
        if (k == 0) put_glb_triple(t, ",\"min\":", l->low), put_glb_triple(t, ",\"max\":", l->high);
        if (!v->attribute) wcut_text_print(t, ",\"min\":[0],\"max\":[%d]", mesh->vertex_count - 1);
        wcut_text_print(t, "}");
    }
    wcut_text_print(t, "]");
}

/* millimetres to metres, and our z to glTF's y: (x, y, z) -> (x, z, -y) / 1000, by columns */
static void put_matrix(wcut_text *t, wcut_vec3 from) {
    const double s = 0.001;
    const double m[16] = {s, 0, 0, 0, 0, 0, -s, 0, 0, s, 0, 0, s * from.x, s * from.z, -s * from.y, 1};
    wcut_text_print(t, "\"matrix\":");
    for (int k = 0; k < 16; k++) {
        wcut_text_print(t, k ? "," : "[");
        wcut_text_number(t, m[k] + 0.0);
    }
    wcut_text_print(t, "]");
}

/* dull and seen from both sides: glTF's default is polished metal, black without surroundings */
static void put_glb_scene(wcut_text *t, const layout *l, const wcut_mesh *mesh) {
    wcut_text_print(t, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"wirecut " WCUT_VERSION
                       "\"},\"scene\":0,"
                       "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"name\":\"wirecut_mm_to_m\",\"children\":[1],");
    put_matrix(t, l->from);
    wcut_text_print(
        t,
        "},{\"name\":\"surface\",\"mesh\":0}],\"meshes\":[{\"name\":\"surface\",\"primitives\":[{\"mode\":4,"
        "\"material\":0,\"attributes\":{");
    for (int k = 0; k < l->views; k++)
        if (l->view[k].attribute) wcut_text_print(t, "%s\"%s\":%d", k ? "," : "", l->view[k].attribute, k);
    wcut_text_print(t,
                    "},\"indices\":%d}]}],\"materials\":[{\"pbrMetallicRoughness\":{\"metallicFactor\":0,"
                    "\"roughnessFactor\":0.8},\"doubleSided\":true}],\"buffers\":[{\"byteLength\":%zu}],",
                    l->views - 1, l->bytes);
    put_views(t, l, mesh);
    wcut_text_print(t, "}");
}

/* ---- the buffer ---- */

static void put_vectors(wcut_text *t, const layout *l, int count, const wcut_vec3 *v) {
    for (int i = 0; i < count; i++) {
        const wcut_vec3 p = l ? relative(l, v[i]) : v[i];
        const float f[3] = {(float)p.x, (float)p.y, (float)p.z};
        wcut_text_put(t, f, sizeof f);
    }
}

/* glTF's vertex colours are linear */
static void put_colours(wcut_text *t, int count, const double *scalar) {
    double min, greatest, rgb[3];
    wcut_range(count, scalar, &min, &greatest);
    for (int i = 0; i < count; i++) {
        wcut_colour(wcut_colour_parameter(scalar[i], min, greatest), rgb);
        const float f[4] = {(float)linear_of_srgb(rgb[0]), (float)linear_of_srgb(rgb[1]), (float)linear_of_srgb(rgb[2]),
                            1};
        wcut_text_put(t, f, sizeof f);
    }
}

typedef struct document {
    const layout *layout;
    const char *json;
    size_t length; /* with blanks to a multiple of four */
} document;

static void put_glb(wcut_text *t, const wcut_mesh *mesh, const void *context) {
    const document *d = context;
    const layout *l = d->layout;
    const uint32_t total = (uint32_t)(HEADER + CHUNK + d->length + CHUNK + l->bytes);
    const uint32_t head[5] = {MAGIC, 2, total, (uint32_t)d->length, JSON_CHUNK};
    const uint32_t bin[2] = {(uint32_t)l->bytes, BIN_CHUNK};
    wcut_text_put(t, head, sizeof head);
    wcut_text_put(t, d->json, d->length);
    wcut_text_put(t, bin, sizeof bin);

    /* in the order of the views */
    put_vectors(t, l, mesh->vertex_count, mesh->vertex);
    if (mesh->normal) put_vectors(t, NULL, mesh->vertex_count, mesh->normal);
    if (mesh->scalar) put_colours(t, mesh->vertex_count, mesh->scalar);
    wcut_text_put(t, mesh->triangle, 3 * (size_t)mesh->triangle_count * sizeof *mesh->triangle);
}

wcut_status wcut_mesh_write_glb(const wcut_mesh *mesh, const char *path, wcut_error *error) {
    char label[WCUT_QUOTE_SIZE];
    wcut_status status = wcut_mesh_check(mesh, path, error);
    if (status != WCUT_OK) return status;

    /* indices are 32 bits, and the file's length too */
    if (mesh->triangle_count > TRIANGLES_MAX)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found %d triangles, expected at most %d in a GLB",
                         wcut_quote(label, path, WCUT_LABEL_MAX, 1), mesh->triangle_count, TRIANGLES_MAX);

    /* the scene says how long it is before it is written: blanks fill it up to a multiple of four */
    const layout l = lay_out_views(mesh);
    document d = {.layout = &l};
    wcut_text json;
    char *text = NULL;
    if (!wcut_text_create(&json, NULL)) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    put_glb_scene(&json, &l, mesh);
    while (json.count % 4) wcut_text_put(&json, " ", 1);
    status = wcut_text_finish(&json, &text, &d.length);
    if (status != WCUT_OK) return wcut_fail(error, status, "%s", wcut_status_text(status));
    d.json = text;

    /* positions, normals, colours and indices follow the scene */
    status = wcut_mesh_write(mesh, put_glb, &d, path, error);

    free(text);
    return status;
}
