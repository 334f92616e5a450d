/* Meshes that assimp reads as clouds: their vertices, from its process, held as a whole. */
#include "io/scan/cloud_foreign.h"

#include <string.h>
#include <strings.h>

#include <wirecut/cloud_file.h>
#include "io/mesh/mesh_formats.h"
#include "io/scan/cloud_source.h"

/* of vertices, 480 MB; and the time that assimp has */
enum { MAX = 20000000, SECONDS = 60 };

static const char *const known[] = {".glb", ".gltf"};

const char *wcut_cloud_foreign_ending(const char *begin, const char *name) {
    const char *dot = strrchr(name, '.');
    if (strncmp(begin, "glTF", 4) == 0) return ".glb";
    for (size_t k = 0; dot && k < sizeof known / sizeof *known; k++)
        if (strcasecmp(dot, known[k]) == 0) return known[k];
    return NULL;
}

static bool fill_foreign(wcut_cloud_source *s, wcut_batch *b) {
    const double *position = s->state;
    for (; s->left > 0 && b->count < b->capacity; s->left--) {
        double value[WCUT_FIELDS] = {0};
        memcpy(value, position + 3 * (s->info.stated - s->left), 3 * sizeof *value);
        if (!wcut_cloud_take(s, b, value)) return false;
    }
    return true;
}

bool wcut_cloud_begin_foreign(wcut_cloud_source *s) {
    double *position = NULL;
    const char *ending = wcut_cloud_foreign_ending((const char *)s->in.stream.data + s->in.stream.at, s->in.label);
    if (!wcut_mesh_vertices_foreign(&s->in, ending ? ending : known[1], MAX, SECONDS, &position, &s->info.stated))
        return false;
    s->state = position;
    s->left = s->info.stated;
    s->fill = fill_foreign;
    return true;
}
