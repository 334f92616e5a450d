/* From the wire's surface to one face of the cut, and the cases in which it divides nothing. */
#include "solid/cut_face.h"

#include <math.h>
#include <stdbool.h>

#include "base/fail.h"
#include "base/vec3.h"

/* stations that the cut may begin at later, points looked at along each */
enum { STARTS_MAX = 12, STARTS_SEEN = 32 };

/* [1] A face that reaches a margin beyond the block may be prolonged by this many margins more: it may lie askew. */
static const double MARGINS = 10;

/* Triangles and fit this share of the kerf from their face: those of the two sides never meet. */
static const double KERF_SHARE = 0.2;

/* What touches a face within this share of the block from its edge touches the edge. */
static const double EDGE_SHARE = 0.01;

void wcut_cut_face_clear(wcut_cut_face *face) {
    wcut_surface_destroy(face->fit.patch);
    wcut_cap_clear(&face->cap);
    *face = (wcut_cut_face){.chord_error = 0};
}

/* the next knot of v at which the wire has reached the side y low somewhere between the other two; `last`: none */
static double next_start(const wcut_sheet *sheet, wcut_sides sides) {
    const wcut_surface *s = sheet->surface;
    for (int k = s->degree_v; k < s->count_v; k++) {
        if (!(s->knots_v[k] > sheet->first[1])) continue;
        for (int i = 0; i <= STARTS_SEEN; i++) {
            const double t = (double)i / STARTS_SEEN, u = (1 - t) * sheet->first[0] + t * sheet->last[0];
            wcut_vec3 p;
            if (wcut_surface_eval(s, u, s->knots_v[k], 0, &p) == WCUT_OK && p.x >= sides.x[0] && p.x <= sides.x[1] &&
                p.y > sides.y[0])
                return s->knots_v[k];
        }
    }
    return sheet->last[1];
}

/* trim and fit one part of the surface */
static wcut_status fit_part(const wcut_sheet *sheet, wcut_sides sides, const double height[2], double prolong,
                            double tolerance, wcut_face_fit *fit, wcut_error *error) {
    wcut_trim trim;
    wcut_status status = wcut_trim_begin(sheet, sides, &trim, error);
    if (status != WCUT_OK) return status;
    status = wcut_face_fit_solve(&trim, height, prolong, tolerance, fit, error);
    wcut_trim_clear(&trim);
    return status;
}

/* A wire that meets the block at speed stops there, and the surface through its stations waves: it may pass the side
   more than once. Then the cut begins at a later station, straight before it; how far that is counts as prolonged. */
static wcut_status fit_face(wcut_sheet *sheet, wcut_sides sides, const double height[2], double prolong, bool later,
                            double tolerance, wcut_face_fit *fit, wcut_error *error) {
    wcut_status status = fit_part(sheet, sides, height, prolong, tolerance, fit, error);
    wcut_error unsaid = {.text = ""};
    for (int k = 0; later && status == WCUT_DEGENERATE && k < STARTS_MAX; k++) {
        sheet->first[1] = next_start(sheet, sides);
        if (!(sheet->first[1] < sheet->last[1])) break;
        const wcut_status again = fit_part(sheet, sides, height, prolong, tolerance, fit, &unsaid);
        if (again != WCUT_DEGENERATE) return again; /* else the first error stands: it is of the cut as it is */
    }
    return status;
}

wcut_status wcut_cut_face_solve(const wcut_division *d, double side, double margin, wcut_cut_face *face,
                                wcut_error *error) {
    const wcut_mould_options *o = d->options;
    const wcut_sides sides = {{0 - margin, d->block.x + margin}, {0 - margin, d->block.y + margin}};
    const double height[2] = {0, d->block.z}, prolong = o->prolong + MARGINS * margin;

    /* fit the side's sheet: the surface, offset by half the kerf */
    wcut_sheet sheet = wcut_sheet_of(d->surface);
    sheet.width = d->width;
    sheet.side = side;
    wcut_cut_face f = {.chord_error = 0};
    wcut_status status = fit_face(&sheet, sides, height, prolong, o->prolong > 0, o->fit_tolerance, &f.fit, error);
    if (status != WCUT_OK) return status;

    /* triangles finer than the kerf, or both faces could meet */
    double tolerance = o->chord_tolerance;
    if (d->width) tolerance = fmin(tolerance, KERF_SHARE * f.fit.width_min);
    if (d->width && f.fit.fit_error > KERF_SHARE * f.fit.width_min)
        status = wcut_fail(error, WCUT_NOT_CONVERGED, "the fit of %.3g mm is too coarse for a kerf of %.3g mm",
                           f.fit.fit_error, f.fit.width_min);
    if (status == WCUT_OK) {
        status = wcut_cap_tessellate(f.fit.patch, sides, tolerance, &f.cap, &f.chord_error);
        if (status != WCUT_OK) wcut_fail(error, status, "triangulating the cut face: %s", wcut_status_text(status));
    }
    if (status != WCUT_OK) {
        wcut_cut_face_clear(&f);
        return status;
    }

    /* the range of z of the triangles */
    f.low = f.high = f.cap.vertex[0].z;
    for (int k = 1; k < f.cap.vertex_count; k++) {
        f.low = fmin(f.low, f.cap.vertex[k].z);
        f.high = fmax(f.high, f.cap.vertex[k].z);
    }
    *face = f;

    return WCUT_OK;
}

/* The face z = level is touched within `near`: which edge or corner is it, if all of it is there? */
static wcut_status say_touch(const wcut_division *d, const wcut_cap *cap, double level, double near,
                             wcut_error *error) {
    const double x[2] = {0, d->block.x}, y[2] = {0, d->block.y};
    bool at_x[2] = {true, true}, at_y[2] = {true, true};
    wcut_vec3 place = {0, 0, 0};
    double min = INFINITY;

    /* the closest vertex, and whether all that are near lie at one side of the block */
    for (int k = 0; k < cap->vertex_count; k++) {
        const wcut_vec3 p = cap->vertex[k];
        const double off = fabs(p.z - level);
        if (off > near) continue;
        if (off < min) min = off, place = p;
        for (int e = 0; e < 2; e++) {
            at_x[e] = at_x[e] && fabs(p.x - x[e]) <= EDGE_SHARE * d->block.x;
            at_y[e] = at_y[e] && fabs(p.y - y[e]) <= EDGE_SHARE * d->block.y;
        }
    }

    /* a corner, an edge, or else the face */
    const bool on_x = at_x[0] || at_x[1], on_y = at_y[0] || at_y[1];
    if (on_x && on_y)
        return wcut_fail(error, WCUT_DEGENERATE, "the cut runs through the block's corner (%.6g, %.6g, %.6g) mm",
                         at_x[0] ? x[0] : x[1], at_y[0] ? y[0] : y[1], level);
    if (on_x || on_y)
        return wcut_fail(error, WCUT_DEGENERATE,
                         "the cut runs along the block's edge %c = %.6g, z = %.6g mm near (%.6g, %.6g, %.6g) mm",
                         on_x ? 'x' : 'y', on_x ? (at_x[0] ? x[0] : x[1]) : (at_y[0] ? y[0] : y[1]), level, place.x,
                         place.y, place.z);
    return wcut_fail(error, WCUT_DEGENERATE,
                     "the cut grazes the block's face z = %.6g mm: %.3g mm from it at (%.6g, %.6g, %.6g) mm", level,
                     min, place.x, place.y, place.z);
}

wcut_status wcut_cut_face_place(const wcut_division *d, const wcut_cut_face *lower, const wcut_cut_face *upper,
                                int *leaves, wcut_error *error) {
    const double top = d->block.z, near = d->options->chord_tolerance;
    if (upper->low > top + near || lower->high < -near)
        return wcut_fail(error, WCUT_DEGENERATE, "the cut misses the block: it passes %s it, from z = %.6g to %.6g mm",
                         lower->high < -near ? "below" : "above", lower->low, upper->high);
    *leaves = lower->low < -near || upper->high > top + near;
    if (*leaves) return WCUT_OK;
    if (upper->high >= top - near) return say_touch(d, &upper->cap, top, near, error);
    if (lower->low <= near) return say_touch(d, &lower->cap, 0, near, error);
    return WCUT_OK;
}
