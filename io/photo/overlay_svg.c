/* overlay.svg: wires as vectors over the rectified picture, in mm. */
#include <math.h>
#include <wirecut/overlay_file.h>

#include "base/fail.h"
#include "io/file/text.h"

typedef struct drawing {
    const wcut_overlaid *o;
    const char *link;
} drawing;

/* of a phase */
static const char *const stroke[] = {"#969696", "#1478f0", "#14b450", "#f07814", "#969696"};

static void put_xy(wcut_text *text, double x, double y) { wcut_text_print(text, " %.3f,%.3f", x, y); }

static bool is_inside(wcut_vec3 p, wcut_vec3 block) {
    return p.x >= 0 && p.x <= block.x && p.y >= 0 && p.y <= block.y && p.z >= 0 && p.z <= block.z;
}

/* the simulated wire in the block; y runs up in the block and down in the drawing */
static void put_wire(wcut_text *text, const wcut_overlaid *o, int station) {
    const wcut_history *h = o->history;
    const wcut_vec3 *row = h->position + (size_t)station * h->nodes;
    wcut_text_print(text, "<polyline class=\"wire\" stroke=\"%s\" points=\"", stroke[h->row[station].phase]);
    for (int n = 0; n < h->nodes; n++)
        if (is_inside(row[n], o->block)) put_xy(text, row[n].x, o->block.y - row[n].y);
    wcut_text_print(text, "\"><title>station %d</title></polyline>\n", station);
}

/* the wire that fits the rills, dashed */
static void put_fitted(wcut_text *text, const wcut_overlaid *o, const wcut_rill_curve *c) {
    if (c->readable == 0) return;
    wcut_text_put_word(text, "<polyline class=\"fitted\" points=\"");
    for (int k = 0; k < c->count; k++)
        if (c->node[k].readable)
            put_xy(text, c->node[k].place.x, o->block.y - c->node[k].place.y - c->node[k].deviation);
    wcut_text_print(text, "\"><title>station %d, from the rills</title></polyline>\n", c->station);
}

static bool put_drawing(wcut_text *text, const void *context) {
    const drawing *d = context;

    /* the block and a margin, in mm */
    const wcut_overlaid *o = d->o;
    const wcut_overlay *v = o->overlay;
    const double w = o->block.x, l = o->block.y, margin = fmax(w, l) / 50;
    wcut_text_print(text,
                    "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.3fmm\" height=\"%.3fmm\" viewBox=\"%.3f %.3f "
                    "%.3f %.3f\">\n",
                    w + 2 * margin, l + 2 * margin, -margin, -margin, w + 2 * margin, l + 2 * margin);
    wcut_text_put_word(text,
                       "<style>polyline{fill:none;stroke-width:.6}.fitted{stroke:#e000c0;stroke-dasharray:3 2}"
                       ".block{fill:none;stroke:#000;stroke-width:.6}</style>\n");

    /* the rectified picture below, in its place on the block */
    wcut_text_print(
        text, "<image href=\"%s\" x=\"0\" y=\"0\" width=\"%.6f\" height=\"%.6f\" preserveAspectRatio=\"none\"/>\n",
        d->link, v->rectified->width * v->resolution, v->rectified->height * v->resolution);

    /* the outline of the block */
    wcut_text_print(text, "<rect class=\"block\" x=\"0\" y=\"0\" width=\"%.3f\" height=\"%.3f\"/>\n", w, l);

    /* the simulated wire of each curve, and the one that fits the rills */
    for (int k = 0; k < v->curve_count; k++) {
        put_wire(text, o, v->curve[k].station);
        put_fitted(text, o, &v->curve[k]);
    }
    wcut_text_put_word(text, "</svg>\n");
    return !text->failed;
}

/* a file name that needs no escapes */
static bool is_plain_name(const char *name) {
    if (!*name) return false;
    for (const char *p = name; *p; p++)
        if (!((*p >= 'a' && *p <= 'z') || (*p >= 'A' && *p <= 'Z') || (*p >= '0' && *p <= '9') || *p == '.' ||
              *p == '-' || *p == '_'))
            return false;
    return true;
}

wcut_status wcut_overlay_svg_write(const wcut_overlaid *o, const char *link, const char *path, wcut_error *error) {
    if (!o || !o->overlay || !o->overlay->rectified || !o->history || !link || !path || !is_plain_name(link) ||
        !isfinite(o->block.x) || !isfinite(o->block.y) || !isfinite(o->block.z))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "overlay: expected a picture's name of letters, digits, '.', '-' and '_'");
    for (int k = 0; k < o->overlay->curve_count; k++)
        if (o->overlay->curve[k].station < 0 || o->overlay->curve[k].station >= o->history->stations)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "overlay: found a wire of station %d, expected one of the history",
                             o->overlay->curve[k].station);
    const drawing d = {o, link};
    return wcut_text_write_file(path, put_drawing, &d, error);
}
