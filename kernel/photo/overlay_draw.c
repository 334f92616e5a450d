/* Simulated wires over a photograph: rectified, or in its own perspective. */
#include <string.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "photo/camera.h"
#include "photo/draw.h"

/* where a place is in the picture that is drawn in */
typedef struct view {
    const wcut_camera *camera; /* NULL: seen from above */
    double resolution, length; /* [mm] of the rectified picture; length of the block */
} view;

wcut_overlay_style wcut_overlay_style_default(void) { return (wcut_overlay_style){.by_force = true, .width = 2}; }

static wcut_pixel pixel_of(const view *v, wcut_vec3 place) {
    if (v->camera) return wcut_camera_pixel(v->camera, place);
    return (wcut_pixel){place.x / v->resolution - 0.5, (v->length - place.y) / v->resolution - 0.5, 1};
}

static void draw_edge(wcut_picture *p, const view *v, wcut_vec3 a, wcut_vec3 b, double width, wcut_colour colour) {
    const wcut_pixel from = pixel_of(v, a), to = pixel_of(v, b);
    if (from.depth > 0 && to.depth > 0) wcut_draw_line(p, from.u, from.v, to.u, to.v, width, colour);
}

static bool is_in_block(wcut_vec3 p, wcut_vec3 block) {
    return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x <= block.x && p.y <= block.y && p.z <= block.z;
}

/* the part of an edge whose middle is in the block; ends are cut at the block's sides in x */
static void draw_wire(wcut_picture *p, const view *v, wcut_vec3 block, const wcut_history *h, int station,
                      double highest, const wcut_overlay_style *style) {
    const wcut_vec3 *row = h->position + (size_t)station * h->nodes;
    const double *force = h->force_line + (size_t)station * h->nodes;
    for (int n = 0; n + 1 < h->nodes; n++) {
        wcut_vec3 a = row[n], b = row[n + 1];
        const double dx = b.x - a.x;
        if (fabs(dx) > 0) {
            const double from = clamp((0 - a.x) / dx, 0, 1), to = clamp((block.x - a.x) / dx, 0, 1);
            const wcut_vec3 start = vec3_mix(a, b, fmin(from, to)), end = vec3_mix(a, b, fmax(from, to));
            a = start, b = end;
        }
        if (!is_in_block(vec3_mix(a, b, 0.5), block)) continue;
        const double share = highest > 0 ? (force[n] + force[n + 1]) / 2 / highest : 0;
        draw_edge(p, v, a, b, style->width,
                  style->by_force ? wcut_colour_of(share) : wcut_colour_of_phase(h->row[station].phase));
    }
}

/* twelve edges of the block, each in short pieces so that a distorted picture bends them */
static void draw_block(wcut_picture *p, const view *v, wcut_vec3 block, double width) {
    enum { PIECES = 32 };
    static const wcut_colour white = {255, 255, 255};
    const double size[3] = {block.x, block.y, block.z};
    for (int axis = 0; axis < 3; axis++)
        for (int corner = 0; corner < 4; corner++)
            for (int k = 0; k < PIECES; k++) {
                double a[3], b[3];
                a[axis] = size[axis] * k / PIECES, b[axis] = size[axis] * (k + 1) / PIECES;
                a[(axis + 1) % 3] = b[(axis + 1) % 3] = corner & 1 ? size[(axis + 1) % 3] : 0;
                a[(axis + 2) % 3] = b[(axis + 2) % 3] = corner & 2 ? size[(axis + 2) % 3] : 0;
                draw_edge(p, v, vec3(a[0], a[1], a[2]), vec3(b[0], b[1], b[2]), width, white);
            }
}

/* ways of both mounts */
static void draw_mounts(wcut_picture *p, const view *v, const wcut_history *h, double width) {
    static const wcut_colour colour = {255, 0, 200};
    for (int s = 0; s + 1 < h->stations; s++)
        for (int side = 0; side < 2; side++) {
            const size_t node = side ? (size_t)h->nodes - 1 : 0;
            draw_edge(p, v, h->position[(size_t)s * h->nodes + node], h->position[(size_t)(s + 1) * h->nodes + node],
                      width, colour);
        }
}

static void draw_all(wcut_picture *p, const view *v, const wcut_overlay *o, wcut_vec3 block, const wcut_history *h,
                     const wcut_overlay_style *style) {
    double highest = 0;
    for (int k = 0; k < h->stations * h->nodes; k++) highest = fmax(highest, h->force_line[k]);
    draw_block(p, v, block, style->width / 2);
    if (v->camera) draw_mounts(p, v, h, style->width);
    for (int k = 0; k < o->curve_count; k++) draw_wire(p, v, block, h, o->curve[k].station, highest, style);
}

static bool is_drawable(const wcut_overlay *o, wcut_vec3 block, const wcut_history *h,
                        const wcut_overlay_style *style) {
    if (!o || !o->rectified || !o->rectified->pixel || !is_positive(o->resolution) || !is_positive(block.x) ||
        !is_positive(block.y) || !is_positive(block.z) || !h || !h->position || !h->force_line || !h->row ||
        !is_positive(style->width) || style->width > 1000)
        return false;
    for (int k = 0; k < o->curve_count; k++)
        if (o->curve[k].station < 0 || o->curve[k].station >= h->stations) return false;
    return true;
}

wcut_status wcut_overlay_draw(const wcut_overlay *overlay, wcut_vec3 block, const wcut_history *history,
                              const wcut_overlay_style *style, wcut_picture **picture) {
    const wcut_overlay_style s = style ? *style : wcut_overlay_style_default();
    if (!picture || !is_drawable(overlay, block, history, &s)) return WCUT_BAD_ARGUMENT;
    const wcut_picture *from = overlay->rectified;
    wcut_picture *made = NULL;
    const wcut_status status = wcut_picture_create(from->width, from->height, 4, &made);
    if (status != WCUT_OK) return status;

    memcpy(made->pixel, from->pixel, (size_t)from->width * from->height * 4);
    const view v = {.resolution = overlay->resolution, .length = block.y};
    draw_all(made, &v, overlay, block, history, &s);
    *picture = made;
    return WCUT_OK;
}

wcut_status wcut_overlay_draw_photo(const wcut_overlay *overlay, wcut_vec3 block, const wcut_history *history,
                                    const wcut_overlay_style *style, const wcut_camera *camera,
                                    const wcut_picture *photo, wcut_picture **picture) {
    const wcut_overlay_style s = style ? *style : wcut_overlay_style_default();
    wcut_vec3 origin = {0, 0, 0};
    double pixel[2];
    if (!picture || !is_drawable(overlay, block, history, &s) || !photo || !photo->pixel ||
        wcut_camera_project(camera, 1, &origin, pixel, NULL) != WCUT_OK)
        return WCUT_BAD_ARGUMENT;
    wcut_picture *made = NULL;
    const wcut_status status = wcut_picture_create(photo->width, photo->height, 3, &made);
    if (status != WCUT_OK) return status;

    /* the photograph in three channels, then the wires as the camera sees them */
    for (size_t k = 0; k < (size_t)photo->width * photo->height; k++)
        for (int c = 0; c < 3; c++)
            made->pixel[3 * k + c] = photo->pixel[photo->channels * k + (photo->channels == 1 ? 0 : c)];
    const view v = {.camera = camera};
    draw_all(made, &v, overlay, block, history, &s);
    *picture = made;
    return WCUT_OK;
}

/* ---- details ---- */

/* the middle of the wire halfway through a phase; false: no wire of that phase is in the block */
static bool middle_of_phase(const wcut_history *h, wcut_vec3 block, wcut_phase phase, wcut_vec3 *place) {
    int count = 0, seen = 0;
    for (int s = 0; s < h->stations; s++) count += h->row[s].phase == phase && h->row[s].engaged_length > 0;
    for (int s = 0; s < h->stations; s++) {
        if (h->row[s].phase != phase || !(h->row[s].engaged_length > 0)) continue;
        if (seen++ < count / 2) continue;

        /* the node in the block that is nearest to its middle in x */
        const wcut_vec3 *row = h->position + (size_t)s * h->nodes;
        int best = -1;
        for (int n = 0; n < h->nodes; n++)
            if (is_in_block(row[n], block) &&
                (best < 0 || fabs(row[n].x - block.x / 2) < fabs(row[best].x - block.x / 2)))
                best = n;
        if (best < 0) continue;
        *place = row[best];
        return true;
    }
    return false;
}

/* a square of side pixels around (u, v) into the columns from `left` on */
static void copy_square(const wcut_picture *from, int u, int v, int side, wcut_picture *to, int left) {
    for (int j = 0; j < side; j++)
        for (int i = 0; i < side; i++) {
            const int column = u - side / 2 + i, row = v - side / 2 + j;
            if (column < 0 || row < 0 || column >= from->width || row >= from->height) continue;
            memcpy(to->pixel + ((size_t)j * to->width + left + i) * 4,
                   from->pixel + ((size_t)row * from->width + column) * 4, 4);
        }
}

wcut_status wcut_overlay_details(const wcut_overlay *o, wcut_vec3 block, const wcut_history *h,
                                 const wcut_picture *drawn, double side, wcut_picture **picture) {
    enum { GAP = 8, PHASES = 3 };
    static const wcut_phase phase[PHASES] = {WCUT_PHASE_ENTRY, WCUT_PHASE_STEADY, WCUT_PHASE_EXIT};
    const wcut_overlay_style style = wcut_overlay_style_default();
    if (!picture || !is_drawable(o, block, h, &style) || !drawn || !drawn->pixel || drawn->channels != 4 ||
        !is_positive(side) || drawn->width != o->rectified->width || drawn->height != o->rectified->height)
        return WCUT_BAD_ARGUMENT;

    /* only the phases that the cut has */
    wcut_vec3 place[PHASES];
    int count = 0;
    for (int k = 0; k < PHASES; k++) count += middle_of_phase(h, block, phase[k], &place[count]);
    if (count == 0) return WCUT_DEGENERATE;
    const int pixels = (int)fmin(ceil(side / o->resolution), fmin(drawn->width, drawn->height));
    wcut_picture *made = NULL;
    const wcut_status status = wcut_picture_create(count * pixels + (count - 1) * GAP, pixels, 4, &made);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < count; k++)
        copy_square(drawn, (int)(place[k].x / o->resolution), (int)((block.y - place[k].y) / o->resolution), pixels,
                    made, k * (pixels + GAP));
    *picture = made;
    return WCUT_OK;
}
