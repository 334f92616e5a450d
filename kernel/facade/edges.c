/* One edge for a joint: heights from fields or from the jobs' own edges, and the job that cuts an element to them. */
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"
#include "facade/field.h"
#include "facade/layout.h"

enum {
    LAST = WCUT_FACADE_SAMPLES - 1,
    EVERY = 2,  /* samples between points of a job's edge */
    BEYOND = 2, /* points of an edge before the block, and as many behind it */
    POINTS = LAST / EVERY + 1 + 2 * BEYOND,
    EXTRAS = 9,    /* points of the extra length */
    DOUBLINGS = 40 /* of a weight that is looked for */
};

/* heights of all lines that the wire's ends follow: columns of the lattice where the feed runs along v, else rows */
typedef struct edge_lines {
    const wcut_layout *of;
    bool mixed; /* elements are fed both ways: lines are the fields as they are */
    int axis;   /* 0: lines are columns, along v; 1: rows, along u */
    int count;
    double weight;  /* of wcut_match_smooth */
    double *height; /* count, room */
} edge_lines;

static double rounded_height(double height) { return round(height / WCUT_FACADE_STEP) * WCUT_FACADE_STEP; }

static double field_at(const wcut_layout *l, int axis, double across, double along) {
    return wcut_facade_field_sum(l->plan->heights, l->plan->height, l->total, axis ? along : across,
                                 axis ? across : along);
}

/* the height [mm] of a line at a place along it, in the facade's sense */
static wcut_status line_height(const edge_lines *lines, int axis, int line, double along, double *height) {
    const wcut_layout *l = lines->of;
    if (!(lines->weight > 0) || axis != lines->axis) {
        *height = rounded_height(field_at(l, axis, line * l->pitch[axis], along));
        return WCUT_OK;
    }
    for (int k = 0; k < lines->count; k++) lines->height[k] = field_at(l, axis, k * l->pitch[axis], along);
    const wcut_status status = wcut_match_smooth(lines->count, lines->weight, lines->height);
    *height = rounded_height(lines->height[line]);
    return status;
}

/* ---- the weight of a match ---- */

/* the largest move of any line at a weight */
static wcut_status largest_move(edge_lines *lines, double weight, double *move) {
    const wcut_layout *l = lines->of;
    const int axis = lines->axis, steps = 8 * (axis ? l->plan->columns : l->plan->rows);
    *move = 0;
    for (int s = 0; s <= steps; s++) {
        const double along = l->total[1 - axis] * s / steps;
        for (int k = 0; k < lines->count; k++) lines->height[k] = field_at(l, axis, k * l->pitch[axis], along);
        const wcut_status status = wcut_match_smooth(lines->count, weight, lines->height);
        if (status != WCUT_OK) return status;
        for (int k = 0; k < lines->count; k++)
            *move = fmax(*move, fabs(lines->height[k] - field_at(l, axis, k * l->pitch[axis], along)));
    }
    return WCUT_OK;
}

/* the greatest weight, up to 1e6, at which no height moves further than asked */
static wcut_status choose_weight(edge_lines *lines) {
    const double asked = lines->of->plan->match_move;
    double low = 0, high = 1e6, move;
    wcut_status status = largest_move(lines, high, &move);
    if (status == WCUT_OK && move <= asked) low = high;
    for (int k = 0; k < DOUBLINGS && status == WCUT_OK && low < high; k++) {
        const double middle = low > 0 ? sqrt(low * high) : high * 1e-3;
        status = largest_move(lines, middle, &move);
        if (move <= asked) {
            low = middle;
        } else {
            high = middle;
        }
    }

    /* what it moves is reported */
    lines->weight = low;
    if (status == WCUT_OK) status = largest_move(lines, low, &lines->of->facade->moved);
    return status;
}

static wcut_status begin_lines(const wcut_layout *l, edge_lines *lines) {
    const wcut_facade *f = l->facade;
    *lines = (edge_lines){.of = l, .axis = f->element[0].turn % 2};
    for (int k = 0; k < f->elements; k++) lines->mixed = lines->mixed || f->element[k].turn % 2 != lines->axis;
    lines->count = (lines->axis ? l->plan->rows : l->plan->columns) + 1;
    lines->height = wcut_alloc((size_t)lines->count, sizeof *lines->height);
    if (!lines->height) return WCUT_NO_MEMORY;
    if (l->plan->match != WCUT_FACADE_MATCH_TANGENT) return WCUT_OK;
    if (lines->mixed)
        return wcut_fail(l->error, WCUT_BAD_ARGUMENT,
                         "match: tangent needs one direction of feed, found elements turned by 90 deg beside others");
    return choose_weight(lines);
}

/* ---- borders from fields ---- */

/* whether the side of a cell is straight: for an element on either side the wire lies along it where it enters or leaves */
static bool is_straight(const wcut_layout *l, int row, int column, int side) {
    const int across = side < 2;
    for (int k = 0; k < 2; k++) {
        const int r = row + (k && !across ? (side % 2 ? 1 : -1) : 0),
                  c = column + (k && across ? (side % 2 ? 1 : -1) : 0);
        if (r < 0 || c < 0 || r >= l->plan->rows || c >= l->plan->columns) continue;
        const int e = l->at[(size_t)r * (size_t)l->plan->columns + (size_t)c];
        if (e >= 0 && (l->facade->element[e].turn % 2 == 1) == across) return true;
    }
    return false;
}

/* the place of a corner of a cell's side: which line, and how far along it */
static wcut_status corner_height(const edge_lines *lines, int column, int row, double *height) {
    const wcut_layout *l = lines->of;
    return lines->axis ? line_height(lines, 1, row, column * l->pitch[0], height)
                       : line_height(lines, 0, column, row * l->pitch[1], height);
}

/* heights of a cell's side, in the facade's sense, along the lattice */
static wcut_status side_heights(const edge_lines *lines, int row, int column, int side, double *height) {
    const wcut_layout *l = lines->of;
    const int axis = side < 2 ? 0 : 1, line = (axis ? row : column) + side % 2, from = axis ? column : row;
    wcut_status status = WCUT_OK;
    if (!is_straight(l, row, column, side)) {
        for (int k = 0; k <= LAST && status == WCUT_OK; k++)
            status = line_height(lines, axis, line, (from + (double)k / LAST) * l->pitch[1 - axis], &height[k]);
        return status;
    }

    /* the straight line between the corners */
    double end[2];
    for (int k = 0; k < 2 && status == WCUT_OK; k++)
        status = corner_height(lines, axis ? from + k : line, axis ? line : from + k, &end[k]);
    for (int k = 0; k <= LAST && status == WCUT_OK; k++)
        height[k] = k == LAST ? end[1] : rounded_height(end[0] + (end[1] - end[0]) * k / LAST);
    return status;
}

/* the block holds every height, or the place is named */
static wcut_status check_heights(const wcut_layout *l, int element, int border, const double *height) {
    char name[WCUT_LAYOUT_WORDS];
    const double top = l->size.z;
    for (int k = 0; k <= LAST; k++) {
        if (height[k] > 0 && height[k] < top) continue;
        const wcut_vec3 p = wcut_border_point(l->facade->element[element].job->block_size, border, k, height[k]);
        return wcut_fail(l->error, WCUT_DEGENERATE,
                         "%s: the field leaves the block: an edge of height %.6g mm at (%.6g, %.6g) mm of the block, "
                         "expected more than 0 and less than %.6g mm",
                         wcut_layout_name(name, l->facade, element), height[k], p.x, p.y, top);
    }
    return WCUT_OK;
}

static wcut_status fill_borders(const edge_lines *lines, int element) {
    const wcut_layout *l = lines->of;
    wcut_facade_element *e = &l->facade->element[element];
    for (int b = 0; b < 4; b++) {
        bool reversed;
        double height[WCUT_FACADE_SAMPLES];
        const int side = wcut_cell_side(e->turn, e->mirrored, b, &reversed);
        wcut_status status = side_heights(lines, e->row, e->column, side, height);
        if (status != WCUT_OK) return status;

        /* as the block sees it: turned over, from its other face */
        e->border[b] = wcut_alloc(WCUT_FACADE_SAMPLES, sizeof **e->border);
        if (!e->border[b]) return WCUT_NO_MEMORY;
        for (int k = 0; k <= LAST; k++) {
            const double h = height[reversed ? LAST - k : k];
            e->border[b][k] = e->mirrored ? l->size.z - h : h;
        }
        status = check_heights(l, element, b, e->border[b]);
        if (status != WCUT_OK) return status;
    }
    return WCUT_OK;
}

/* ---- jobs from fields ---- */

/* an edge of the block beyond its ends: the line goes on as its field does, or straight */
static wcut_status height_beyond(const edge_lines *lines, const wcut_facade_element *e, int border, double j,
                                 double *height) {
    const wcut_layout *l = lines->of;
    const double *own = e->border[border];
    bool reversed;
    const int side = wcut_cell_side(e->turn, e->mirrored, border, &reversed);
    if (is_straight(l, e->row, e->column, side)) {
        *height = own[0] + j * (own[LAST] - own[0]);
        return WCUT_OK;
    }

    /* along the line, in the facade's sense and back */
    const int axis = side < 2 ? 0 : 1, line = (axis ? e->row : e->column) + side % 2;
    const double share = reversed ? 1 - j : j, from = axis ? e->column : e->row;
    const wcut_status status = line_height(lines, axis, line, (from + share) * l->pitch[1 - axis], height);
    if (e->mirrored) *height = l->size.z - *height;
    *height = clamp(*height, 0, l->size.z);
    return status;
}

static wcut_status make_edge(const edge_lines *lines, const wcut_facade_element *e, int border, double overrun,
                             wcut_curve **edge) {
    const wcut_vec3 block = e->job->block_size;
    const int before = overrun > 0 ? BEYOND : 0, count = POINTS - 2 * (BEYOND - before);
    wcut_vec3 point[POINTS];
    for (int k = 0; k < count; k++) {
        /* on the block the shared heights, beyond it what follows */
        const int inside = (k - before) * EVERY;
        const int beyond = k < before ? k - before : k - before - LAST / EVERY;
        const double way = overrun * beyond / BEYOND;
        if (inside >= 0 && inside <= LAST) {
            point[k] = wcut_border_point(block, border, inside, e->border[border][inside]);
            continue;
        }
        const double y = k < before ? way : block.y + way;
        double height;
        const wcut_status status = height_beyond(lines, e, border, y / block.y, &height);
        if (status != WCUT_OK) return status;
        point[k] = vec3(border ? block.x : 0, y, height);
    }
    return wcut_curve_interpolate(count, point, edge);
}

/* the extra length at a share of the feed, in the middle of the block */
static double extra_at_share(const wcut_layout *l, const wcut_facade_element *e, double j) {
    double share[2];
    wcut_cell_share(e->turn, e->mirrored, 0.5, j, share);
    return wcut_facade_field_sum(l->plan->extras, l->plan->extra, l->total, (e->column + share[0]) * l->pitch[0],
                                 (e->row + share[1]) * l->pitch[1]);
}

/* so far a wire of that extra length bows behind its ends: a flat arc */
static double bow_of_extra(double extra, double chord) { return sqrt(3 * extra * chord / 8); }

static wcut_status make_job(const edge_lines *lines, int element) {
    const wcut_layout *l = lines->of;
    const wcut_facade_element *e = &l->facade->element[element];
    wcut_job *job = e->job;

    /* the extra length over the edge, overrun included */
    double overrun = l->plan->overrun;
    if (overrun < 0)
        overrun = ceil(
            1.2 * bow_of_extra(fmax(0, fmax(extra_at_share(l, e, 0), extra_at_share(l, e, 1))), job->block_size.x) + 2);
    double *u = wcut_alloc(EXTRAS, sizeof *u), *extra = wcut_alloc(EXTRAS, sizeof *extra);
    wcut_free(job->extra_u);
    wcut_free(job->extra_length);
    job->extra_u = u, job->extra_length = extra, job->extra_count = EXTRAS;
    if (!u || !extra) return WCUT_NO_MEMORY;
    for (int k = 0; k < EXTRAS; k++) {
        char name[WCUT_LAYOUT_WORDS];
        u[k] = (double)k / (EXTRAS - 1);
        const double j = (u[k] * (job->block_size.y + 2 * overrun) - overrun) / job->block_size.y;
        extra[k] = rounded_height(extra_at_share(l, e, clamp(j, 0, 1)));
        if (!(extra[k] >= 0))
            return wcut_fail(l->error, WCUT_DEGENERATE,
                             "%s: found an extra length of %.6g mm at %.4g of its feed, expected 0 or more",
                             wcut_layout_name(name, l->facade, element), extra[k], clamp(j, 0, 1));
    }

    /* both edges */
    wcut_curve *edge[2] = {NULL, NULL};
    wcut_status status = make_edge(lines, e, 0, overrun, &edge[0]);
    if (status == WCUT_OK) status = make_edge(lines, e, 1, overrun, &edge[1]);
    wcut_curve_destroy(job->edge_a);
    wcut_curve_destroy(job->edge_b);
    job->edge_a = edge[0], job->edge_b = edge[1];
    job->overrun = overrun > 0 ? overrun + 1 : 0; /* edges end within it, rounding or not */
    return status;
}

static wcut_status edges_from_fields(const wcut_layout *l) {
    edge_lines lines;
    wcut_status status = begin_lines(l, &lines);
    for (int k = 0; k < l->facade->elements && status == WCUT_OK; k++) {
        char name[WCUT_LAYOUT_WORDS];
        if (l->facade->element[k].job->mode != WCUT_MODE_DESIGN)
            status = wcut_fail(l->error, WCUT_BAD_ARGUMENT,
                               "%s: its job has a path, expected a design whose edges fields drive",
                               wcut_layout_name(name, l->facade, k));
        if (status == WCUT_OK) status = fill_borders(&lines, k);
        if (status == WCUT_OK) status = make_job(&lines, k);
    }
    wcut_free(lines.height);
    return status;
}

/* ---- edges of jobs ---- */

/* the height of an edge where it is at y, by halving; false: it does not come there */
static bool edge_height_at(const wcut_curve *edge, double y, double side, double *height) {
    double first, last;
    wcut_vec3 p, q;
    wcut_curve_domain(edge, &first, &last);
    if (wcut_curve_eval(edge, first, 0, &p) != WCUT_OK || wcut_curve_eval(edge, last, 0, &q) != WCUT_OK) return false;
    if (p.y > y + WCUT_EDGE_TOLERANCE || q.y < y - WCUT_EDGE_TOLERANCE) return false;
    for (int k = 0; k < 200 && first < last; k++) {
        const double middle = (first + last) / 2;
        if (middle <= first || middle >= last || wcut_curve_eval(edge, middle, 0, &p) != WCUT_OK) break;
        if (p.y < y) {
            first = middle;
        } else {
            last = middle;
        }
    }
    if (wcut_curve_eval(edge, y <= q.y ? last : first, 0, &p) != WCUT_OK) return false;
    *height = rounded_height(p.z);
    return fabs(p.x - side) <= WCUT_EDGE_TOLERANCE;
}

static wcut_status borders_of_job(const wcut_layout *l, int element) {
    char name[WCUT_LAYOUT_WORDS];
    wcut_facade_element *e = &l->facade->element[element];
    const wcut_vec3 block = e->job->block_size;
    if (e->job->mode != WCUT_MODE_DESIGN)
        return wcut_fail(l->error, WCUT_BAD_ARGUMENT,
                         "%s: its job has a path, expected a design with edges to share, or \"match\": \"none\"",
                         wcut_layout_name(name, l->facade, element));
    for (int b = 0; b < 4; b++) {
        e->border[b] = wcut_alloc(WCUT_FACADE_SAMPLES, sizeof **e->border);
        if (!e->border[b]) return WCUT_NO_MEMORY;
    }

    /* both edges at even steps of the feed */
    for (int b = 0; b < 2; b++)
        for (int k = 0; k <= LAST; k++) {
            const double y = block.y * k / LAST;
            if (edge_height_at(b ? e->job->edge_b : e->job->edge_a, y, b ? block.x : 0, &e->border[b][k])) continue;
            return wcut_fail(
                l->error, WCUT_BAD_ARGUMENT,
                "%s: edge_%c is not on its side of the block at y = %.6g mm, expected it there from y = 0 to %.6g mm",
                wcut_layout_name(name, l->facade, element), b ? 'b' : 'a', y, block.y);
        }

    /* straight lines between them where the wire enters and leaves */
    for (int b = 2; b < 4; b++) {
        const double *a = e->border[0], *c = e->border[1];
        const double end[2] = {a[b == 3 ? LAST : 0], c[b == 3 ? LAST : 0]};
        for (int k = 0; k <= LAST; k++)
            e->border[b][k] = k == LAST ? end[1] : rounded_height(end[0] + (end[1] - end[0]) * k / LAST);
    }
    return WCUT_OK;
}

/* what of a second element's borders lies at the ends of a border follows it */
static void set_corners(wcut_facade_element *e, int border) {
    const double *h = e->border[border];
    const int low = border < 2 ? 2 : 0, k = border % 2 ? LAST : 0;
    e->border[low][k] = h[0];
    e->border[low + 1][k] = h[LAST];
}

/* one edge for both sides of a joint: the first element's */
static wcut_status share_edge(const wcut_layout *l, int joint) {
    char one[WCUT_LAYOUT_WORDS], two[WCUT_LAYOUT_WORDS];
    const wcut_facade_joint *j = &l->facade->joint[joint];
    const wcut_facade_element *a = &l->facade->element[j->element[0]];
    wcut_facade_element *b = &l->facade->element[j->element[1]];
    const double *from = a->border[j->border[0]];
    double *to = b->border[j->border[1]];

    /* heights above the facade's base */
    const double top_a = a->job->block_size.z, top_b = b->job->block_size.z;
    for (int k = 0; k <= LAST; k++) {
        const int i = j->reversed ? LAST - k : k;
        const double first = a->mirrored ? top_a - from[k] : from[k], second = b->mirrored ? top_b - to[i] : to[i];
        if (fabs(first - second) > WCUT_FACADE_SAME + WCUT_FACADE_STEP) {
            const wcut_vec3 p = wcut_element_point(a, wcut_border_point(a->job->block_size, j->border[0], k, from[k]));
            return wcut_fail(l->error, WCUT_BAD_ARGUMENT,
                             "%s and %s: their edges are %.6g mm apart near (%.6g, %.6g, %.6g) mm; expected one edge "
                             "for both, or \"match\": \"none\"",
                             wcut_layout_name(one, l->facade, j->element[0]),
                             wcut_layout_name(two, l->facade, j->element[1]), fabs(first - second), p.x, p.y, p.z);
        }
        to[i] = b->mirrored ? top_b - first : first;
    }
    set_corners(b, j->border[1]);
    return WCUT_OK;
}

wcut_status wcut_layout_edges(wcut_layout *layout) {
    wcut_status status = WCUT_OK;
    if (layout->plan->heights > 0) {
        status = edges_from_fields(layout);

        /* an element of its own keeps the edges that it is cut along, not those of a joint */
        for (int k = 0; k < 4 * layout->facade->elements && layout->plan->match == WCUT_FACADE_MATCH_NONE; k++) {
            wcut_free(layout->facade->element[k / 4].border[k % 4]);
            layout->facade->element[k / 4].border[k % 4] = NULL;
        }
        return status;
    }
    if (layout->plan->match == WCUT_FACADE_MATCH_NONE) return WCUT_OK;
    for (int k = 0; k < layout->facade->elements && status == WCUT_OK; k++) status = borders_of_job(layout, k);
    for (int j = 0; j < layout->facade->joints && status == WCUT_OK; j++) status = share_edge(layout, j);
    return status;
}
