/* Faces in: surfaces of CAD files with the loops that bound them, which format a file has. */
#include "io/cad/face_set.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/look.h"
#include "io/file/read_file.h"

#define BYTES_MAX ((size_t)256 << 20)

/* [mm] what is nearer is one place: edges of CAD programs lie within 1e-2 of their surfaces */
static const double GAP = 1e-2;

/* ---- loops ---- */

bool wcut_face_loops_begin(wcut_face_reader *r, wcut_face_loops *l) {
    if (l->loops == l->room_loops) {
        const int room = l->room_loops ? 2 * l->room_loops : 8;
        int *grown = room <= 2 * WCUT_FACE_CURVES_MAX ? wcut_grow(l->count, (size_t)room * sizeof *grown) : NULL;
        if (!grown) return wcut_curves_refuse_memory(r->curves);
        l->count = grown;
        l->room_loops = room;
    }
    l->count[l->loops++] = 0;
    return true;
}

bool wcut_face_loops_add(wcut_face_reader *r, wcut_face_loops *l, wcut_curve *curve) {
    bool done = l->curves < WCUT_FACE_CURVES_MAX ||
                wcut_curves_refuse(r->curves, "found a face of more than %d edges", WCUT_FACE_CURVES_MAX);
    if (done && l->curves == l->room_curves) {
        const int room = l->room_curves ? 2 * l->room_curves : 16;
        wcut_curve **grown = wcut_grow(l->curve, (size_t)room * sizeof *grown);
        done = grown || wcut_curves_refuse_memory(r->curves);
        if (grown) l->curve = grown, l->room_curves = room;
    }
    if (!done) return wcut_curve_destroy(curve), false;
    l->curve[l->curves++] = curve;
    l->count[l->loops - 1]++;
    return true;
}

void wcut_face_loops_clear(wcut_face_loops *l) {
    for (int k = 0; k < l->curves; k++) wcut_curve_destroy(l->curve[k]);
    wcut_free(l->curve);
    wcut_free(l->count);
    *l = (wcut_face_loops){0};
}

/* ---- faces ---- */

static bool make_face_room(wcut_face_reader *r) {
    if (r->set->count < r->room) return true;
    const int room = r->room ? 2 * r->room : 16;
    wcut_trimmed **face = wcut_grow(r->set->face, (size_t)room * sizeof *face);
    if (face) r->set->face = face;
    char **name = face ? wcut_grow(r->set->name, (size_t)room * sizeof *name) : NULL;
    if (!name) return false;
    r->set->name = name;
    r->room = room;
    return true;
}

bool wcut_faces_add(wcut_face_reader *r, wcut_surface *surface, const wcut_face_loops *l, const char *name,
                    size_t length) {
    wcut_trimmed *face = NULL;
    wcut_error error = {WCUT_OK, ""};

    /* the face, or why it is none */
    const wcut_status status =
        wcut_trimmed_create(surface, l->loops, l->count, (const wcut_curve *const *)l->curve, GAP, &face, &error);
    if (status != WCUT_OK) wcut_surface_destroy(surface);
    if (status == WCUT_NO_MEMORY) return wcut_curves_refuse_memory(r->curves);
    if (status != WCUT_OK) return wcut_curves_leave_out(r->curves, error.text), true;

    /* its place in the set */
    char *copy = wcut_alloc(length + 1, 1);
    bool done = r->set->count < WCUT_FACES_MAX ||
                wcut_curves_refuse(r->curves, "found more than %d faces, expected at most that", WCUT_FACES_MAX);
    if (done) done = (copy && make_face_room(r)) || wcut_curves_refuse_memory(r->curves);
    if (!done || !copy) {
        wcut_free(copy);
        wcut_trimmed_destroy(face);
        return false;
    }

    /* the name, without control characters */
    size_t used = 0;
    for (size_t k = 0; k < length; k++)
        if ((unsigned char)name[k] >= 0x20 && name[k] != 0x7f) copy[used++] = name[k];
    r->set->face[r->set->count] = face;
    r->set->name[r->set->count++] = copy;
    return true;
}

int wcut_trimmed_set_find(const wcut_trimmed_set *set, const char *choice, size_t length) {
    int found = -1, number = 0;
    if (!set || !choice || length == 0) return -1;
    for (int k = 0; k < set->count; k++) {
        if (strlen(set->name[k]) != length || strncmp(set->name[k], choice, length) != 0) continue;
        if (found >= 0) return -1;
        found = k;
    }
    if (found >= 0) return found;

    /* a number from 1 */
    for (size_t k = 0; k < length; k++) {
        if (choice[k] < '0' || choice[k] > '9' || number > set->count) return -1;
        number = 10 * number + (choice[k] - '0');
    }
    return number >= 1 && number <= set->count ? number - 1 : -1;
}

void wcut_trimmed_set_destroy(wcut_trimmed_set *set) {
    if (!set) return;
    for (int k = 0; k < set->count; k++) {
        wcut_trimmed_destroy(set->face[k]);
        wcut_free(set->name[k]);
    }
    wcut_free(set->face);
    wcut_free(set->name);
    wcut_free(set);
}

/* ---- any ---- */

static bool fill_faces(wcut_face_reader *r, char *text, size_t length) {
    wcut_trimmed_set *set = r->set;

    /* the format by the first bytes; another known format is named in the message */
    if (strncmp(text, "ISO-10303-21;", 13) == 0)
        set->format = WCUT_CURVE_FORMAT_STEP;
    else if (length > 80 && text[72] == 'S' && (text[80] == '\n' || text[80] == '\r'))
        set->format = WCUT_CURVE_FORMAT_IGES;
    else if (wcut_look_refuse(text, length, r->curves->label, "a surface in STEP or IGES", &r->curves->failure) !=
             WCUT_OK)
        return false;
    else
        return wcut_curves_refuse(r->curves, "found no STEP and no IGES file, expected a surface in one of them");

    /* read the faces, and say what was left out */
    const bool done = set->format == WCUT_CURVE_FORMAT_STEP ? wcut_faces_fill_step(r, text, length)
                                                            : wcut_faces_fill_iges(r, text, length);
    set->left_out = r->curves->set->left_out;
    snprintf(set->why, sizeof set->why, "%s", r->curves->set->why);
    if (!done || set->count > 0) return done;
    return set->left_out
               ? wcut_curves_refuse(r->curves, "found no face that is read, %d left out: %s", set->left_out, set->why)
               : wcut_curves_refuse(r->curves, "found no face, expected a surface");
}

wcut_status wcut_trimmed_set_read_memory(char *text, size_t length, const char *label, wcut_trimmed_set **set,
                                         wcut_error *error) {
    const wcut_curve_read_options options = wcut_curve_read_options_default();
    wcut_curve_set *aside = wcut_alloc(1, sizeof *aside); /* holds what is left out */
    wcut_curve_reader curves = {.label = label, .options = &options, .set = aside};
    wcut_face_reader r = {.curves = &curves, .set = wcut_alloc(1, sizeof(wcut_trimmed_set))};
    bool done = (aside && r.set) || wcut_curves_refuse_memory(&curves);
    if (done && r.set) done = fill_faces(&r, text, length);
    wcut_curve_set_destroy(aside);
    if (done) {
        *set = r.set;
        return WCUT_OK;
    }
    wcut_trimmed_set_destroy(r.set);
    if (error) *error = curves.failure;
    return curves.failure.status;
}

wcut_status wcut_trimmed_set_read(const char *path, wcut_trimmed_set **set, wcut_error *error) {
    char *text = NULL;
    size_t length = 0;
    if (!path || !set) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_status status = wcut_file_read(path, BYTES_MAX, &text, &length, error);
    if (status == WCUT_OK) status = wcut_trimmed_set_read_memory(text, length, path, set, error);
    free(text);
    return status;
}
