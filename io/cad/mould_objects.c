/* The parts of a mould as objects that say what they are: 3MF and STEP with names and colours. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/mould_file.h>

#include "base/fail.h"

enum { PARTS = 4, NAME_SIZE = 512 };

/* colours of the parts, and of what is marked on the halves */
static const unsigned CUT_COLOUR = 0x54a24b, KEY_COLOUR = 0xe45756;
static const unsigned part_colour[PARTS] = {0x4c78a8, 0xf58518, 0x9c9c9c, 0xb279a2};
static const char *const part_word[PARTS] = {"lower", "upper", "frame", "casting"};
static const char *const part_material[PARTS] = {"lower half", "upper half", "frame", "casting"};

/* between parts that lie beside each other [mm] */
static const double SPACE = 10;

static const wcut_mesh *mesh_of(const wcut_mould *m, int part) {
    const wcut_mesh *const mesh[PARTS] = {m->lower.mesh, m->upper.mesh, m->frame, m->thickness > 0 ? m->kerf : NULL};
    return mesh[part];
}

static void box_of(const wcut_mesh *mesh, wcut_vec3 *low, wcut_vec3 *high) {
    *low = *high = mesh->vertex[0];
    for (int v = 1; v < mesh->vertex_count; v++) {
        const wcut_vec3 p = mesh->vertex[v];
        *low = (wcut_vec3){fmin(low->x, p.x), fmin(low->y, p.y), fmin(low->z, p.z)};
        *high = (wcut_vec3){fmax(high->x, p.x), fmax(high->y, p.y), fmax(high->z, p.z)};
    }
}

/* On the bed of a printer, the upper half on its outer face, one part beside the other; *at: where the next begins. */
static void lay_out(wcut_mesh_object *o, int turned, double *at) {
    wcut_vec3 low, high;
    box_of(o->mesh, &low, &high);
    o->turned = turned;
    o->move = (wcut_vec3){*at - low.x, turned ? high.y : -low.y, turned ? high.z : -low.z};
    *at += high.x - low.x + SPACE;
}

static wcut_status check_parts(const wcut_mould *m, const char *name, unsigned parts, wcut_error *error) {
    if (!m || !m->lower.mesh || !m->upper.mesh || !name)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a mould and a name expected");
    if (parts == 0 || parts >= 1u << PARTS)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "parts of a mould: found %u, expected a sum of their values", parts);
    for (int k = 0; k < PARTS; k++)
        if (parts >> k & 1 && !mesh_of(m, k))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "the mould has no %s", part_word[k]);
    return WCUT_OK;
}

wcut_status wcut_mould_write_3mf(const wcut_mould *mould, const char *name, unsigned parts, int for_print,
                                 const char *path, wcut_error *error) {
    const wcut_status status = check_parts(mould, name, parts, error);
    if (status != WCUT_OK) return status;
    wcut_mesh_object object[PARTS];
    char title[PARTS][NAME_SIZE];
    int count = 0;
    double at = 0;
    for (int k = 0; k < PARTS; k++) {
        if (!(parts >> k & 1)) continue;

        /* the part in its colour, the cut face of a half in another */
        const wcut_half *half = k == 0 ? &mould->lower : k == 1 ? &mould->upper : NULL;
        wcut_mesh_object *o = &object[count];
        *o = (wcut_mesh_object){.mesh = mesh_of(mould, k),
                                .name = title[count],
                                .material = part_material[k],
                                .marked_material = half && half->cut ? "cut face" : NULL,
                                .mark = half ? half->cut : NULL,
                                .colour = part_colour[k],
                                .marked_colour = CUT_COLOUR};
        snprintf(title[count], NAME_SIZE, "%.400s %s", name, part_word[k]);
        if (for_print) lay_out(o, k == 1, &at);
        count++;
    }

    return wcut_mesh_write_3mf(count, object, path, error);
}

wcut_status wcut_mould_write_step(const wcut_mould *mould, const char *name, wcut_mould_part part,
                                  wcut_step_schema schema, const char *path, wcut_error *error) {
    /* exact faces exist for halves made by index and for the frame */
    const wcut_status status = check_parts(mould, name, part, error);
    if (status != WCUT_OK) return status;
    const wcut_brep *const brep[PARTS] = {mould->lower.brep, mould->upper.brep, mould->frame_brep, NULL};
    int k = 0;
    while (k < PARTS && part != 1u << k) k++;
    if (k == PARTS || !brep[k]) return wcut_fail(error, WCUT_BAD_ARGUMENT, "found no one part with exact faces");

    char title[NAME_SIZE];
    snprintf(title, sizeof title, "%.400s %s", name, part_word[k]);
    const wcut_shape shape = {.name = title,
                              .solid = brep[k],
                              .coloured = 1,
                              .colour = part_colour[k],
                              .cut_colour = CUT_COLOUR,
                              .key_colour = KEY_COLOUR};
    return wcut_step_write(1, &shape, schema, path, error);
}
