/* facade.glb: glTF 2.0, a mesh for each distinct element, a node for each element where it stands.

   All meshes have the same triangles: one view of indices serves them all. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/facade/element.h"
#include "io/mesh/colour.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "binary files are written as they lie in memory");

enum {
    N = WCUT_FACADE_SAMPLES,
    POINTS = N * N,
    TRIANGLES = 2 * (N - 1) * (N - 1),
    HEADER = 12,
    CHUNK = 8,
    ARRAY_BUFFER = 34962,
    INDEX_BUFFER = 34963,
    FLOAT = 5126,
    UNSIGNED_SHORT = 5123,
    VIEWS = 3, /* of a mesh: position, normal, colour */
    INDEX_BYTES = 3 * TRIANGLES * 2,
    VECTOR_BYTES = POINTS * 3 * 4,
    COLOUR_BYTES = POINTS * 4 * 4,
    MESH_BYTES = 2 * VECTOR_BYTES + COLOUR_BYTES
};
static const uint32_t GLB_MAGIC = 0x46546c67, GLB_JSON = 0x4e4f534a, GLB_BIN = 0x004e4942;

/* what is written */
typedef struct scene {
    const wcut_facade_results *results;
    int meshes, *mesh; /* those with a face; the mesh of each distinct element, -1: none */
    double low, high;  /* [N/mm] of the colours */
    char *json;
    size_t length; /* of it, with blanks to a multiple of four */
} scene;

static size_t buffer_bytes(const scene *s) { return INDEX_BYTES + (size_t)s->meshes * MESH_BYTES; }

/* ---- the scene ---- */

static void put_position_box(wcut_text *t, const wcut_element_face *face) {
    /* as a reader will see it, in single precision */
    float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int i = 0; i < POINTS; i++) {
        const float c[3] = {(float)face->point[i].x, (float)face->point[i].y, (float)face->point[i].z};
        for (int k = 0; k < 3; k++) low[k] = fminf(low[k], c[k]), high[k] = fmaxf(high[k], c[k]);
    }
    for (int k = 0; k < 3; k++) wcut_text_put_number(t, k ? "," : ",\"min\":[", (double)low[k]);
    for (int k = 0; k < 3; k++) wcut_text_put_number(t, k ? "," : "],\"max\":[", (double)high[k]);
    wcut_text_put(t, "]", 1);
}

/* millimetres to metres, and our z to glTF's y */
static void put_nodes(wcut_text *t, const scene *s) {
    const wcut_facade *f = s->results->description->facade;
    int children = 0;
    wcut_text_put_word(t,
                       "\"nodes\":[{\"name\":\"wirecut_mm_to_m\",\"matrix\":[0.001,0,0,0,0,0,-0.001,0,0,0.001,0,0,0,0,"
                       "0,1],\"children\":[");
    for (int k = 0; k < f->elements; k++)
        if (s->results->item[k].face) wcut_text_print(t, "%s%d", children ? "," : "", children + 1), children++;
    wcut_text_put_word(t, "]}");

    /* the block's frame of every element, by columns */
    for (int k = 0; k < f->elements; k++) {
        const wcut_facade_element *e = &f->element[k];
        if (!s->results->item[k].face) continue;
        wcut_text_print(t, ",{\"name\":\"row %d column %d\",\"mesh\":%d,\"extras\":{\"element\":%d}", e->row, e->column,
                        s->mesh[s->results->item[k].distinct], k);

        /* a frame that is the facade's own is not written: that is the default */
        const double m[16] = {e->x.x, e->x.y, e->x.z, 0, e->y.x,      e->y.y,      e->y.z,      0,
                              e->z.x, e->z.y, e->z.z, 0, e->origin.x, e->origin.y, e->origin.z, 1};
        bool moved = false;
        for (int i = 0; i < 16; i++) moved = moved || m[i] != (i % 5 == 0);
        for (int i = 0; i < 16 && moved; i++) wcut_text_put_number(t, i ? "," : ",\"matrix\":[", m[i] + 0.0);
        wcut_text_put_word(t, moved ? "]}" : "}");
    }
    wcut_text_put_word(t, "]");
}

static void put_meshes(wcut_text *t, const scene *s) {
    wcut_text_put_word(t, ",\"meshes\":[");
    for (int d = 0; d < s->results->distinct; d++) {
        const int m = s->mesh[d], first = 1 + VIEWS * m;
        if (m < 0) continue;
        wcut_text_print(t,
                        "%s{\"name\":\"element "
                        "%d\",\"primitives\":[{\"mode\":4,\"material\":0,\"indices\":0,\"attributes\":{\"POSITION\":%d,"
                        "\"NORMAL\":%d,\"COLOR_0\":%d}}]}",
                        m ? "," : "", d, first, first + 1, first + 2);
    }
    wcut_text_put_word(t,
                       "],\"materials\":[{\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0.8},"
                       "\"doubleSided\":true}]");
}

static void put_buffers(wcut_text *t, const scene *s) {
    static const int bytes[VIEWS] = {VECTOR_BYTES, VECTOR_BYTES, COLOUR_BYTES};
    wcut_text_print(t,
                    ",\"buffers\":[{\"byteLength\":%zu}],\"bufferViews\":[{\"buffer\":0,\"byteOffset\":0,"
                    "\"byteLength\":%d,\"target\":%d}",
                    buffer_bytes(s), INDEX_BYTES, INDEX_BUFFER);
    size_t offset = INDEX_BYTES;
    for (int k = 0; k < VIEWS * s->meshes; k++) {
        wcut_text_print(t, ",{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%d,\"target\":%d}", offset,
                        bytes[k % VIEWS], ARRAY_BUFFER);
        offset += (size_t)bytes[k % VIEWS];
    }

    /* an accessor for each view; positions with their box */
    wcut_text_print(t,
                    "],\"accessors\":[{\"bufferView\":0,\"componentType\":%d,\"count\":%d,\"type\":\"SCALAR\",\"min\":["
                    "0],\"max\":[%d]}",
                    UNSIGNED_SHORT, 3 * TRIANGLES, POINTS - 1);
    for (int d = 0; d < s->results->distinct; d++) {
        if (s->mesh[d] < 0) continue;
        for (int k = 0; k < VIEWS; k++) {
            wcut_text_print(t, ",{\"bufferView\":%d,\"componentType\":%d,\"count\":%d,\"type\":\"%s\"",
                            1 + VIEWS * s->mesh[d] + k, FLOAT, POINTS, k < 2 ? "VEC3" : "VEC4");
            if (k == 0) put_position_box(t, s->results->face[d]);
            wcut_text_put(t, "}", 1);
        }
    }
    wcut_text_put_word(t, "]");
}

static void put_facade_scene(wcut_text *t, const scene *s) {
    wcut_text_put_word(t, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"wirecut " WCUT_VERSION
                          "\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],");
    put_nodes(t, s);
    put_meshes(t, s);
    put_buffers(t, s);
    wcut_text_put(t, "}", 1);
}

/* ---- the buffer ---- */

static void put_indices(wcut_text *t) {
    for (int j = 0; j < N - 1; j++)
        for (int i = 0; i < N - 1; i++) {
            const int a = j * N + i;
            const uint16_t index[6] = {(uint16_t)a, (uint16_t)(a + 1),     (uint16_t)(a + N + 1),
                                       (uint16_t)a, (uint16_t)(a + N + 1), (uint16_t)(a + N)};
            wcut_text_put(t, index, sizeof index);
        }
}

/* the normal of the face at a sample, of length 1 in single precision too */
static bool put_normal(wcut_text *t, const wcut_element_face *face, int i) {
    wcut_vec3 ders[4];
    const int row = i / N, column = i % N;
    if (wcut_surface_eval(face->surface, (double)column / (N - 1), (double)row / (N - 1), 1, ders) != WCUT_OK)
        return false;
    const wcut_vec3 u = ders[2], v = ders[1];
    const wcut_vec3 n = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    const float f[3] = {length > 0 ? (float)(n.x / length) : 0, length > 0 ? (float)(n.y / length) : 0,
                        length > 0 ? (float)(n.z / length) : 1};
    wcut_text_put(t, f, sizeof f);
    return true;
}

static double linear_of(double byte) {
    const double c = byte / 255;
    return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

/* glTF's vertex colours are linear; grey where no force is known */
static void put_colour(wcut_text *t, const scene *s, const wcut_element_face *face, int i) {
    double rgb[3] = {160, 160, 160};
    if (face->force) wcut_colour(wcut_colour_parameter(face->force[i], s->low, s->high), rgb);
    const float f[4] = {(float)linear_of(rgb[0]), (float)linear_of(rgb[1]), (float)linear_of(rgb[2]), 1};
    wcut_text_put(t, f, sizeof f);
}

static bool put_facade_glb(wcut_text *t, const void *context) {
    const scene *s = context;
    const size_t bytes = buffer_bytes(s);
    const uint32_t head[5] = {GLB_MAGIC, 2, (uint32_t)(HEADER + CHUNK + s->length + CHUNK + bytes), (uint32_t)s->length,
                              GLB_JSON};
    const uint32_t bin[2] = {(uint32_t)bytes, GLB_BIN};
    wcut_text_put(t, head, sizeof head);
    wcut_text_put(t, s->json, s->length);
    wcut_text_put(t, bin, sizeof bin);
    put_indices(t);

    /* each mesh in the order of its views */
    bool whole = true;
    for (int d = 0; d < s->results->distinct && whole; d++) {
        const wcut_element_face *face = s->results->face[d];
        if (!face) continue;
        for (int i = 0; i < POINTS; i++) {
            const float f[3] = {(float)face->point[i].x, (float)face->point[i].y, (float)face->point[i].z};
            wcut_text_put(t, f, sizeof f);
        }
        for (int i = 0; i < POINTS && whole; i++) whole = put_normal(t, face, i);
        for (int i = 0; i < POINTS; i++) put_colour(t, s, face, i);
    }
    return whole;
}

/* ---- for the caller ---- */

/* the meshes that there are, and the range of all forces */
static void begin_scene(const wcut_facade_results *r, scene *s) {
    s->low = INFINITY, s->high = -INFINITY;
    for (int d = 0; d < r->distinct; d++) {
        const wcut_element_face *face = r->face[d];
        s->mesh[d] = face ? s->meshes++ : -1;
        for (int i = 0; face && face->force && i < POINTS; i++)
            s->low = fmin(s->low, face->force[i]), s->high = fmax(s->high, face->force[i]);
    }
}

wcut_status wcut_facade_write_glb(const wcut_facade_results *results, const char *path, wcut_error *error) {
    if (!results || !path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    scene s = {.results = results, .mesh = wcut_alloc((size_t)results->distinct, sizeof *s.mesh)};
    wcut_text json;
    if (!s.mesh || !wcut_text_create(&json, NULL)) {
        wcut_free(s.mesh);
        return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    begin_scene(results, &s);

    /* the scene is as long as it says: blanks fill it up to a multiple of four */
    put_facade_scene(&json, &s);
    while (json.count % 4) wcut_text_put(&json, " ", 1);
    wcut_status status = wcut_text_finish(&json, &s.json, &s.length);
    if (status != WCUT_OK)
        wcut_fail(error, status, "%s", wcut_status_text(status));
    else if (s.meshes == 0)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "facade: no element has a face, expected at least one");
    else if (buffer_bytes(&s) + s.length > UINT32_MAX - 1000)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "facade: %d distinct elements are more than a GLB of 4 GB holds",
                           s.meshes);
    else
        status = wcut_text_write_file(path, put_facade_glb, &s, error);
    free(s.json);
    wcut_free(s.mesh);
    return status;
}
