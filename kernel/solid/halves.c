/* The solids below, above and between the faces of a cut. */
#include "solid/halves.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/vec3.h"
#include "solid/boolean.h"
#include "solid/cap_flat.h"
#include "solid/check.h"
#include "solid/keys.h"
#include "surface/mesh_volume.h"

static void part_clear(wcut_part *p) {
    wcut_mesh_destroy(p->mesh);
    wcut_free(p->tag);
    *p = (wcut_part){.mesh = NULL};
}

void wcut_parts_clear(wcut_parts *parts) {
    part_clear(&parts->lower);
    part_clear(&parts->upper);
    part_clear(&parts->kerf);
}

/* the level face of a half with the keys that are on it */
static wcut_status key_face(const wcut_division *d, wcut_sides sides, int upper, double z, wcut_cap *cap,
                            wcut_error *error) {
    wcut_key *own;
    int count;
    wcut_status status = wcut_keys_of(d->options, upper, &own, &count);
    if (status != WCUT_OK) return status;
    status = wcut_cap_flat(sides, z, count, own, d->options->chord_tolerance, cap);
    if (status == WCUT_BAD_ARGUMENT)
        wcut_fail(error, status, "keys of the %s half: two of them meet, or one reaches the block's side",
                  upper ? "upper" : "lower");
    wcut_free(own);
    return status;
}

/* the solid between two caps; the cut's triangles are the ceiling's, the floor's or both (sum of 1 and 2) */
static wcut_status halves_enclose(const wcut_cap *floor, const wcut_cap *ceiling, int cut, int lugs,
                                  const wcut_cap_lug *lug, wcut_part *part) {
    wcut_part p = {.mesh = NULL};
    wcut_status status = wcut_cap_enclose(floor, ceiling, lugs, lug, &p.mesh);
    if (status != WCUT_OK) return status;
    p.tag = wcut_alloc((size_t)p.mesh->triangle_count, sizeof *p.tag);
    if (!p.tag) {
        part_clear(&p);
        return WCUT_NO_MEMORY;
    }
    if (cut & 1) memset(p.tag, 1, (size_t)ceiling->triangle_count);
    if (cut & 2) memset(p.tag + ceiling->triangle_count, 1, (size_t)floor->triangle_count);
    *part = p;
    return WCUT_OK;
}

/* Two caps that are met once by every vertical line and lie one above the other make a solid that nowhere meets itself:
   its sides are parts of planes. Otherwise CGAL looks. */
static wcut_status prove_simple(int proven, wcut_part *part, wcut_error *error) {
    if (proven) return WCUT_OK;
    return wcut_self_intersections(part->mesh, &part->self_intersections, &part->place, error);
}

/* a border that crosses itself leaves no region on its side */
static wcut_status name_enclosure(wcut_status status, wcut_error *error) {
    if (status == WCUT_DEGENERATE)
        wcut_fail(error, status, "the cut folds over itself: its border crosses itself on a side of the block");
    return status;
}

static void clear_lugs(wcut_cap_lug lug[2][WCUT_LUGS]) {
    for (int upper = 0; upper < 2; upper++)
        for (int k = 0; k < WCUT_LUGS; k++) {
            wcut_cap_clear(&lug[upper][k].floor);
            wcut_cap_clear(&lug[upper][k].ceiling);
        }
}

/* the caps of all lugs; a zeroed array, also on failure to be cleared */
static wcut_status make_lugs(const wcut_division *d, const wcut_lug (*place)[WCUT_LUGS],
                             wcut_cap_lug lug[2][WCUT_LUGS]) {
    wcut_status status = WCUT_OK;
    for (int upper = 0; place && upper < 2; upper++)
        for (int k = 0; status == WCUT_OK && k < WCUT_LUGS; k++) {
            wcut_cap_lug *l = &lug[upper][k];
            l->side = place[upper][k].side;
            status = wcut_lug_caps(&place[upper][k], upper, d->options->chord_tolerance, &l->floor, &l->ceiling);
        }
    return status;
}

wcut_status wcut_halves_by_index(const wcut_division *d, const wcut_cut_face *lower, const wcut_cut_face *upper,
                                 const wcut_lug (*place)[WCUT_LUGS], wcut_parts *parts, wcut_error *error) {
    /* level faces with keys at bottom and top */
    const wcut_sides sides = {{0, d->block.x}, {0, d->block.y}};
    wcut_cap bottom = {.vertex_count = 0}, top = {.vertex_count = 0};
    wcut_parts p = {.lower = {.mesh = NULL}};
    wcut_cap_lug lug[2][WCUT_LUGS] = {{{.side = 0}}};
    const int lugs = place ? WCUT_LUGS : 0;
    wcut_status status = key_face(d, sides, 0, 0, &bottom, error);
    if (status == WCUT_OK) status = key_face(d, sides, 1, d->block.z, &top, error);
    if (status == WCUT_OK) status = make_lugs(d, place, lug);

    /* lower half, upper half, and the kerf between them */
    if (status == WCUT_OK) {
        status = halves_enclose(&bottom, &lower->cap, 1, lugs, lug[0], &p.lower);
        if (status == WCUT_OK) status = halves_enclose(&upper->cap, &top, 2, lugs, lug[1], &p.upper);
        if (status == WCUT_OK && d->width) status = halves_enclose(&lower->cap, &upper->cap, 3, 0, NULL, &p.kerf);
        name_enclosure(status, error);
    }

    /* a face that is a graph over the plane proves the half simple; else intersections are searched */
    if (status == WCUT_OK) status = prove_simple(wcut_cap_is_graph(&lower->cap), &p.lower, error);
    if (status == WCUT_OK) status = prove_simple(wcut_cap_is_graph(&upper->cap), &p.upper, error);
    if (status == WCUT_OK) {
        *parts = p;
    } else {
        wcut_parts_clear(&p);
    }

    clear_lugs(lug);
    wcut_cap_clear(&top);
    wcut_cap_clear(&bottom);

    return status;
}

/* ---- booleans ---- */

/* the block with its keys, or the stock */
static wcut_status make_stock(const wcut_division *d, wcut_part *stock, wcut_error *error) {
    const wcut_sides sides = {{0, d->block.x}, {0, d->block.y}};
    wcut_cap bottom = {.vertex_count = 0}, top = {.vertex_count = 0};
    wcut_status status = key_face(d, sides, 0, 0, &bottom, error);
    if (status == WCUT_OK) status = key_face(d, sides, 1, d->block.z, &top, error);
    if (status == WCUT_OK) status = halves_enclose(&bottom, &top, 0, 0, NULL, stock);
    wcut_cap_clear(&top);
    wcut_cap_clear(&bottom);
    return status;
}

/* the space below, above or between the faces, far enough down and up; sides as those of the faces */
static wcut_status make_space(const wcut_division *d, const wcut_cap *floor, const wcut_cap *ceiling, double margin,
                              const double height[2], wcut_part *space, wcut_error *error) {
    /* a level face where the space has no cut face on that side */
    const wcut_sides sides = {{0 - margin, d->block.x + margin}, {0 - margin, d->block.y + margin}};
    wcut_cap flat = {.vertex_count = 0};
    const int cut = (ceiling ? 1 : 0) + (floor ? 2 : 0);
    wcut_status status = WCUT_OK;
    if (cut != 3) status = wcut_cap_flat(sides, ceiling ? height[0] : height[1], 0, NULL, 1, &flat);
    if (status == WCUT_OK) {
        status = halves_enclose(floor ? floor : &flat, ceiling ? ceiling : &flat, cut, 0, NULL, space);
        name_enclosure(status, error);
    }
    wcut_cap_clear(&flat);
    if (status != WCUT_OK) return status;

    /* two graphs that do not meet prove it simple */
    const int graph = (!floor || wcut_cap_is_graph(floor)) && (!ceiling || wcut_cap_is_graph(ceiling));
    status = prove_simple(graph && cut != 3, space, error);
    if (status == WCUT_OK && space->self_intersections > 0)
        status = wcut_fail(error, WCUT_DEGENERATE, "the cut folds over itself near (%.6g, %.6g, %.6g) mm",
                           space->place.x, space->place.y, space->place.z);
    if (status != WCUT_OK) part_clear(space);

    return status;
}

/* how far a point is from a cap along z, INFINITY beside it */
static double cap_distance(const wcut_cap *cap, wcut_vec3 p) {
    double least = INFINITY;
    for (int t = 0; t < cap->triangle_count; t++) {
        const int *c = cap->triangle + 3 * (ptrdiff_t)t;
        const wcut_vec3 a = cap->vertex[c[0]], b = cap->vertex[c[1]], d = cap->vertex[c[2]];
        if (p.x < fmin(a.x, fmin(b.x, d.x)) || p.x > fmax(a.x, fmax(b.x, d.x)) || p.y < fmin(a.y, fmin(b.y, d.y)) ||
            p.y > fmax(a.y, fmax(b.y, d.y)))
            continue;
        const wcut_vec3 n = vec3_cross(vec3_sub(b, a), vec3_sub(d, a));
        if (fabs(n.z) > 0) least = fmin(least, fabs(vec3_dot(vec3_sub(p, a), n) / n.z));
    }
    return least;
}

/* Where a stock lies in the cut most: the middle of that triangle of its whose corners are nearest to a face of the cut. */
static wcut_status find_stock_contact(const wcut_mesh *stock, const wcut_cap *floor, const wcut_cap *ceiling,
                                      wcut_vec3 *place) {
    double *off = wcut_alloc((size_t)stock->vertex_count, sizeof *off), least = INFINITY;
    if (!off) return WCUT_NO_MEMORY;
    for (int v = 0; v < stock->vertex_count; v++) {
        off[v] = floor ? cap_distance(floor, stock->vertex[v]) : INFINITY;
        if (ceiling) off[v] = fmin(off[v], cap_distance(ceiling, stock->vertex[v]));
    }
    for (int t = 0; t < stock->triangle_count; t++) {
        const int *c = stock->triangle + 3 * (ptrdiff_t)t;
        const double most = fmax(off[c[0]], fmax(off[c[1]], off[c[2]]));
        if (most >= least && t > 0) continue;
        least = most;
        *place = vec3_scale(1.0 / 3, vec3_add(stock->vertex[c[0]], vec3_add(stock->vertex[c[1]], stock->vertex[c[2]])));
    }
    wcut_free(off);
    return WCUT_OK;
}

/* a boolean that failed, in words with a place */
static wcut_status fail_boolean(wcut_status status, const wcut_error *cause, const char *name, const wcut_mesh *stock,
                                const wcut_cap *floor, const wcut_cap *ceiling, wcut_error *error) {
    wcut_vec3 at = {0, 0, 0};
    if (cause->text[0] || status != WCUT_DEGENERATE)
        return wcut_fail(error, status, "no boolean of the %s and the stock: %s", name,
                         cause->text[0] ? cause->text : wcut_status_text(status));
    if (find_stock_contact(stock, floor, ceiling, &at) != WCUT_OK) return WCUT_NO_MEMORY;
    return wcut_fail(
        error, status,
        "no boolean of the %s and the stock: the cut runs along a face or through an edge of the stock near "
        "(%.6g, %.6g, %.6g) mm; expected a stock that it passes through or misses",
        name, at.x, at.y, at.z);
}

/* what stock and space have in common */
static wcut_status halves_intersect(const wcut_part *stock, const wcut_part *space, const char *name,
                                    const wcut_cap *floor, const wcut_cap *ceiling, wcut_part *part,
                                    wcut_error *error) {
    wcut_part p = {.mesh = NULL};
    wcut_error cause = {.text = ""};
    wcut_status status =
        wcut_boolean_intersect(stock->mesh, stock->tag, space->mesh, space->tag, &p.mesh, &p.tag, &cause);
    if (status != WCUT_OK) return fail_boolean(status, &cause, name, stock->mesh, floor, ceiling, error);
    if (p.mesh->triangle_count == 0)
        status = wcut_fail(error, WCUT_DEGENERATE, "the cut misses the block: there is no %s", name);
    if (status == WCUT_OK) status = wcut_self_intersections(p.mesh, &p.self_intersections, &p.place, error);
    if (status == WCUT_OK) {
        *part = p;
    } else {
        part_clear(&p);
    }
    return status;
}

wcut_status wcut_halves_by_boolean(const wcut_division *d, const wcut_cut_face *lower, const wcut_cut_face *upper,
                                   double margin, wcut_parts *parts, double *block_volume, wcut_error *error) {
    /* beyond the block and its keys */
    double reach = margin;
    for (int k = 0; k < d->options->key_count; k++) reach = fmax(reach, margin + fabs(d->options->key[k].height));
    const double height[2] = {fmin(0, lower->low) - reach, fmax(d->block.z, upper->high) + reach};

    /* below, above, between */
    const wcut_cap *floor[3] = {NULL, &upper->cap, &lower->cap}, *ceiling[3] = {&lower->cap, NULL, &upper->cap};
    static const char *const name[3] = {"lower half", "upper half", "kerf"};
    wcut_part stock = {.mesh = NULL};
    wcut_parts p = {.lower = {.mesh = NULL}};
    wcut_part *part[3] = {&p.lower, &p.upper, &p.kerf};
    wcut_status status = WCUT_OK;
    wcut_mesh whole = {.vertex_count = 0};

    /* the stock: given, or the block with its keys */
    if (d->options->stock) { /* borrowed, with tags of its own */
        whole = *d->options->stock;
        stock.tag = wcut_alloc((size_t)whole.triangle_count, sizeof *stock.tag);
        if (!stock.tag) return WCUT_NO_MEMORY;
    } else {
        status = make_stock(d, &stock, error);
        if (status == WCUT_OK) whole = *stock.mesh;
    }

    /* each space intersected with the stock is a part */
    const wcut_part from = {.mesh = &whole, .tag = stock.tag};
    for (int k = 0; status == WCUT_OK && k < (d->width ? 3 : 2); k++) {
        wcut_part space = {.mesh = NULL};
        status = make_space(d, floor[k], ceiling[k], margin, height, &space, error);
        if (status == WCUT_OK) status = halves_intersect(&from, &space, name[k], floor[k], ceiling[k], part[k], error);
        part_clear(&space);
    }

    /* the volume of the whole, for the balance of the parts */
    if (status == WCUT_OK) {
        *block_volume = d->options->stock ? wcut_mesh_volume(&whole) : d->block.x * d->block.y * d->block.z;
        *parts = p;
    } else {
        wcut_parts_clear(&p);
    }
    part_clear(&stock);

    return status;
}
