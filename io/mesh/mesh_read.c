/* Meshes in: which format a file has, and what is the same for all of them. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/look.h"
#include "io/file/unit.h"
#include "io/mesh/mesh_formats.h"

enum { SNIFF = 512 };

wcut_mesh_read_options wcut_mesh_read_options_default(void) {
    return (wcut_mesh_read_options){
        .format = WCUT_MESH_FORMAT_ANY, .unit = WCUT_LENGTH_UNIT_MM, .max_triangles = 20000000, .seconds = 60};
}

static bool mesh_options_are_usable(const wcut_mesh_read_options *o) {
    return (unsigned)o->format < WCUT_MESH_FORMAT_COUNT && (unsigned)o->unit < WCUT_LENGTH_UNIT_COUNT &&
           o->max_triangles >= 1 && o->max_triangles <= INT_MAX / 3 && o->seconds >= 1 && o->seconds <= 3600;
}

/* the ending of a file's name with its point, "" where it has none */
static const char *ending_of(const char *name) {
    const char *point = strrchr(name, '.');
    return point && !strchr(point, '/') ? point : "";
}

/* OFF, COFF, STOFF and the like */
static bool begins_off(const char *at) {
    const char *word = strstr(at, "OFF");
    return word && word - at <= 4 && strspn(at, "STCN4n") >= (size_t)(word - at);
}

static wcut_mesh_format find_mesh_format(const wcut_source *s) {
    static const struct {
        const char *ending;
        wcut_mesh_format format;
    } known[] = {{".stl", WCUT_MESH_FORMAT_STL}, {".ply", WCUT_MESH_FORMAT_PLY},  {".obj", WCUT_MESH_FORMAT_OBJ},
                 {".off", WCUT_MESH_FORMAT_OFF}, {".glb", WCUT_MESH_FORMAT_GLTF}, {".gltf", WCUT_MESH_FORMAT_GLTF}};
    const char *at = (const char *)s->stream.data + s->stream.at, *ending = ending_of(s->label);
    if (strncmp(at, "ply\n", 4) == 0 || strncmp(at, "ply\r", 4) == 0) return WCUT_MESH_FORMAT_PLY;
    if (strncmp(at, "glTF", 4) == 0) return WCUT_MESH_FORMAT_GLTF;
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (strcasecmp(ending, known[k].ending) == 0) return known[k].format;
    if (strncmp(at, "\xef\xbb\xbf", 3) == 0) at += 3;
    at += strspn(at, " \t\r\n");
    if (strncasecmp(at, "solid", 5) == 0) return WCUT_MESH_FORMAT_STL;
    return begins_off(at) ? WCUT_MESH_FORMAT_OFF : WCUT_MESH_FORMAT_ANY;
}

static bool fill_mesh(wcut_source *s, wcut_mesh_builder *g, wcut_mesh_format format, int seconds) {
    const bool is_binary = s->stream.end - s->stream.at >= 4 && memcmp(s->stream.data + s->stream.at, "glTF", 4) == 0;

    /* a reader for each format; glTF is read by assimp */
    switch (format) {
        case WCUT_MESH_FORMAT_STL:
            return wcut_mesh_fill_stl(s, g);
        case WCUT_MESH_FORMAT_PLY:
            return wcut_mesh_fill_ply(s, g);
        case WCUT_MESH_FORMAT_OBJ:
            return wcut_mesh_fill_obj(s, g);
        case WCUT_MESH_FORMAT_OFF:
            return wcut_mesh_fill_off(s, g);
        case WCUT_MESH_FORMAT_GLTF:
            return wcut_mesh_fill_foreign(s, g, is_binary ? ".glb" : ".gltf", seconds);
        default:
            break;
    }

    /* no mesh: another known format is named in the message */
    const char *at = (const char *)s->stream.data + s->stream.at;
    if (wcut_look_refuse(at, s->stream.end - s->stream.at, s->label, "a mesh: STL, PLY, OBJ, OFF or glTF",
                         &s->failure) != WCUT_OK)
        return false;
    return wcut_source_refuse(s, "found no mesh in a known format, expected STL, PLY, OBJ, OFF or glTF");
}

static bool read(wcut_source *s, wcut_mesh_builder *g, const wcut_mesh_read_options *o, wcut_mesh **mesh,
                 wcut_mesh_read_info *info) {
    s->scale = wcut_unit_length(o->unit);
    if (wcut_stream_fill(&s->stream, SNIFF) == 0) return wcut_source_refuse_end(s, "a mesh");
    info->format = o->format != WCUT_MESH_FORMAT_ANY ? o->format : find_mesh_format(s);
    return fill_mesh(s, g, info->format, o->seconds) && wcut_mesh_builder_finish(g, mesh, info);
}

/* the bytes, opened, are closed here */
static wcut_status read_source(wcut_source s, const wcut_mesh_read_options *o, wcut_mesh **mesh,
                               wcut_mesh_read_info *info, wcut_error *error) {
    wcut_mesh_builder g = {.source = &s, .max = o->max_triangles};
    wcut_mesh_read_info found = {0};
    wcut_mesh *made = NULL;
    if (read(&s, &g, o, &made, &found)) {
        *mesh = made;
        if (info) *info = found;
    }
    const wcut_status status = s.failure.status;
    if (status != WCUT_OK && error) *error = s.failure;
    wcut_mesh_builder_free(&g);
    wcut_source_close(&s);
    return status;
}

wcut_status wcut_mesh_read(const char *path, const wcut_mesh_read_options *options, wcut_mesh **mesh,
                           wcut_mesh_read_info *info, wcut_error *error) {
    const wcut_mesh_read_options o = options ? *options : wcut_mesh_read_options_default();
    if (!path || !mesh || !mesh_options_are_usable(&o)) return WCUT_BAD_ARGUMENT;
    wcut_source source;
    const wcut_status status = wcut_source_open(path, &source, error);
    return status == WCUT_OK ? read_source(source, &o, mesh, info, error) : status;
}

wcut_status wcut_mesh_read_memory(const void *bytes, size_t size, size_t window, const char *label,
                                  const wcut_mesh_read_options *options, wcut_mesh **mesh, wcut_mesh_read_info *info,
                                  wcut_error *error) {
    wcut_source source;
    const wcut_status status = wcut_source_open_memory(bytes, size, window, label, &source, error);
    return status == WCUT_OK ? read_source(source, options, mesh, info, error) : status;
}
