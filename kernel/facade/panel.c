/* The panel cast on a face: between it and its offset, cut off at the block's sides, as triangles and exactly. */
#include <wirecut/curvature.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "facade/layout.h"
#include "solid/boolean.h"
#include "solid/check.h"
#include "solid/cut_face.h"
#include "solid/kerf.h"
#include "solid/solid_brep.h"
#include "surface/mesh_volume.h"

/* places a face's bend is looked at, each way: two for each sample */
enum { LOOKS = 2 * WCUT_FACADE_SAMPLES - 1 };

/* the offset folds where the face bends towards it with a radius no larger than the thickness: refused with the place */
static wcut_status check_bend(const wcut_element_face *face, double thickness, wcut_error *error) {
    double max = 0;
    wcut_vec3 at = {0, 0, 0};
    for (int k = 0; k < LOOKS * LOOKS; k++) {
        double larger, smaller;
        const int row = k / LOOKS, column = k % LOOKS;
        const double u = (double)column / (LOOKS - 1), v = (double)row / (LOOKS - 1);
        wcut_status status = wcut_surface_curvature(face->surface, u, v, &larger, &smaller);
        const double bend = fmax(larger * thickness, smaller * thickness) / fabs(thickness);
        if (status == WCUT_OK && bend > max) {
            max = bend;
            status = wcut_surface_eval(face->surface, u, v, 0, &at);
        }
        if (status != WCUT_OK) return wcut_fail(error, status, "panel: %s", wcut_status_text(status));
    }
    if (max * fabs(thickness) < 1) return WCUT_OK;
    return wcut_fail(error, WCUT_DEGENERATE,
                     "panel of %.6g mm: its offset folds: at (%.6g, %.6g, %.6g) mm of the block the face bends with a "
                     "radius of %.4g mm, expected more than the thickness",
                     fabs(thickness), at.x, at.y, at.z, 1 / max);
}

/* both sheets of the panel, the face and the one beside it */
static wcut_status solve_sheets(const wcut_element_face *face, double thickness, double chord_tolerance,
                                wcut_cut_face sheet[2], wcut_error *error) {
    wcut_mould_options options = wcut_mould_default();
    options.chord_tolerance = chord_tolerance;
    options.prolong = fmax(options.prolong, 4 * fabs(thickness));
    options.kerf = 2 * fabs(thickness);

    /* half of twice the thickness to one side */
    wcut_surface *width = NULL;
    wcut_division d = {.surface = face->surface, .block = face->block, .options = &options};
    wcut_status status = wcut_cut_face_solve(&d, 0, 0, &sheet[0], error);
    if (status == WCUT_OK) status = wcut_kerf_width(face->surface, &options, &width, error);
    d.width = width;
    if (status == WCUT_OK) status = wcut_cut_face_solve(&d, thickness > 0 ? 0.5 : -0.5, 0, &sheet[1], error);
    wcut_surface_destroy(width);
    return status;
}

/* closed, oriented, free of intersections, or refused with the place */
static wcut_status check_panel(const wcut_mesh *mesh, wcut_error *error) {
    wcut_half_report r = {.closed = 0};
    int pairs = 0;
    wcut_vec3 at = {0, 0, 0};
    wcut_status status = wcut_check_boundary(mesh, &r);
    if (status == WCUT_OK && (!r.closed || !r.oriented))
        return wcut_fail(error, WCUT_DEGENERATE, "panel: its faces do not close, so that the offset folds");
    if (status == WCUT_OK) status = wcut_self_intersections(mesh, &pairs, &at, error);
    if (status == WCUT_OK && pairs > 0)
        return wcut_fail(error, WCUT_DEGENERATE,
                         "panel: the offset crosses itself near (%.6g, %.6g, %.6g) mm of the block; expected a "
                         "thickness below the radius of curvature there",
                         at.x, at.y, at.z);
    return status;
}

wcut_status wcut_panel_create(const wcut_element_face *face, double thickness, double chord_tolerance,
                              wcut_panel **panel, wcut_error *error) {
    if (!face || !face->surface || !isfinite(thickness) || thickness == 0 || !is_positive(chord_tolerance) || !panel)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "panel: expected a face, a thickness other than 0 and a positive tolerance");
    wcut_cut_face sheet[2] = {{.chord_error = 0}, {.chord_error = 0}};
    wcut_error cause = {.text = ""};
    wcut_status status = check_bend(face, thickness, error);
    if (status != WCUT_OK) return status;
    status = solve_sheets(face, thickness, chord_tolerance, sheet, &cause);
    if (status != WCUT_OK)
        wcut_fail(error, status, "panel of %.6g mm: %s", fabs(thickness),
                  cause.text[0] ? cause.text : wcut_status_text(status));

    /* the lower sheet is the floor */
    const wcut_cut_face *floor = &sheet[thickness > 0 ? 0 : 1], *ceiling = &sheet[thickness > 0 ? 1 : 0];
    wcut_panel *p = NULL;
    if (status == WCUT_OK) {
        p = wcut_alloc(1, sizeof *p);
        status = p ? wcut_cap_enclose(&floor->cap, &ceiling->cap, 0, NULL, &p->mesh) : WCUT_NO_MEMORY;
        if (status != WCUT_OK)
            wcut_fail(error, status, "panel of %.6g mm: %s", fabs(thickness),
                      status == WCUT_DEGENERATE ? "the offset's border crosses the face's, so that it folds"
                                                : wcut_status_text(status));
    }
    if (status == WCUT_OK) status = check_panel(p->mesh, error);
    if (status == WCUT_OK) {
        status = wcut_brep_between(floor->fit.patch, ceiling->fit.patch, &p->solid);
        if (status != WCUT_OK) wcut_fail(error, status, "panel: %s", wcut_status_text(status));
    }

    /* its figures */
    if (status == WCUT_OK) {
        wcut_half_report r = {.closed = 0};
        status = wcut_check_boundary(p->mesh, &r);
        p->volume = wcut_mesh_volume(p->mesh);
        p->area = r.area;
    }
    if (status == WCUT_OK) {
        *panel = p;
    } else {
        wcut_panel_destroy(p);
    }
    wcut_cut_face_clear(&sheet[0]);
    wcut_cut_face_clear(&sheet[1]);
    return status;
}

void wcut_panel_destroy(wcut_panel *panel) {
    if (!panel) return;
    wcut_mesh_destroy(panel->mesh);
    wcut_brep_destroy(panel->solid);
    wcut_free(panel);
}
