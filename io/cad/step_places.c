/* Assemblies of STEP files (ISO 10303-43, -44): representations related with a transformation, or used by mapped items. */
#include "io/cad/step_places.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

enum { DEPTH_MAX = 32 };
static const double INCREDIBLE = 1e12; /* [mm] */
static bool are_equal(wcut_vec3 a, wcut_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

static const wcut_step_place here = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* ---- representations ---- */

static const char *const shape[] = {"SHAPE_REPRESENTATION",
                                    "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION",
                                    "GEOMETRICALLY_BOUNDED_SURFACE_SHAPE_REPRESENTATION",
                                    "EDGE_BASED_WIREFRAME_SHAPE_REPRESENTATION",
                                    "SHELL_BASED_WIREFRAME_SHAPE_REPRESENTATION",
                                    "MANIFOLD_SURFACE_SHAPE_REPRESENTATION",
                                    "ADVANCED_BREP_SHAPE_REPRESENTATION",
                                    "FACETED_BREP_SHAPE_REPRESENTATION",
                                    "CSG_SHAPE_REPRESENTATION"};

/* the list of arguments of a representation of shape; NULL: it is none */
static const char *find_list(const char *body) {
    for (size_t k = 0; k < sizeof shape / sizeof *shape; k++) {
        const char *list = wcut_p21_record(body, shape[k]);
        if (list && wcut_p21_length(list) == 3) return list;
    }
    return body[0] == '(' && wcut_p21_record(body, "SHAPE_REPRESENTATION") ? wcut_p21_record(body, "REPRESENTATION")
                                                                           : NULL;
}

const char *wcut_step_items(const char *body) {
    const char *list = find_list(body);
    return list ? wcut_p21_item(list, 1) : NULL;
}

static bool has_item(const char *items, long item) {
    for (const char *at = wcut_p21_item(items, 0); at; at = wcut_p21_next(at)) {
        long id = 0;
        if (wcut_p21_read_reference(at, &id) && id == item) return true;
    }
    return false;
}

static bool holds(const wcut_step_source *s, long representation, long item) {
    const char *body = wcut_p21_find(&s->file, representation), *items = body ? wcut_step_items(body) : NULL;
    return items && has_item(items, item);
}

long wcut_step_holder(const wcut_step_source *s, long item) {
    for (int k = 0; k < s->file.count; k++) {
        const char *items = wcut_step_items(s->file.instance[k].body);
        if (items && has_item(items, item)) return s->file.instance[k].id;
    }
    return 0;
}

/* ---- what a representation holds ---- */

static int record_place(const wcut_p21_file *f, long id) {
    int low = 0, high = f->count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (f->instance[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < f->count && f->instance[low].id == id ? low : -1;
}

/* every instance that references lead to from those on the stack */
static void follow_references(const wcut_p21_file *f, int *stack, int count, unsigned char *reached) {
    while (count > 0) {
        const char *p = f->instance[stack[--count]].body;
        for (; *p; p++) {
            if (*p == '\'')
                for (p++; *p && *p != '\''; p++) {
                }
            if (*p == '\0') break;
            if (*p != '#') continue;
            const int at = record_place(f, strtol(p + 1, NULL, 10));
            if (at < 0 || reached[at]) continue;
            reached[at] = 1;
            stack[count++] = at;
        }
    }
}

bool wcut_step_reach(wcut_step_source *s, const char *representation, unsigned char *reached) {
    int *stack = wcut_alloc((size_t)s->file.count + 1, sizeof *stack), count = 0;
    if (!stack) return wcut_curves_refuse_memory(s->reader);
    memset(reached, 0, (size_t)s->file.count);
    for (const char *item = wcut_p21_item(wcut_step_items(representation), 0); item; item = wcut_p21_next(item)) {
        long id = 0;
        const int at = wcut_p21_read_reference(item, &id) ? record_place(&s->file, id) : -1;

        /* mapped items are those of another representation */
        if (at < 0 || reached[at] || wcut_p21_record(s->file.instance[at].body, "MAPPED_ITEM")) continue;
        reached[at] = 1;
        stack[count++] = at;
    }
    follow_references(&s->file, stack, count, reached);
    wcut_free(stack);
    return true;
}

bool wcut_step_use_units(wcut_step_source *s, long representation) {
    const char *body = wcut_p21_find(&s->file, representation), *list = body ? find_list(body) : NULL;
    long context = 0;
    if (!list || !wcut_p21_read_reference(wcut_p21_item(list, 2), &context)) return true;
    return wcut_step_units_of(s, context);
}

/* ---- motions ---- */

static wcut_vec3 turn_step_places(const wcut_step_place *a, wcut_vec3 p) {
    const wcut_vec3 *r = a->row;
    return (wcut_vec3){r[0].x * p.x + r[0].y * p.y + r[0].z * p.z, r[1].x * p.x + r[1].y * p.y + r[1].z * p.z,
                       r[2].x * p.x + r[2].y * p.y + r[2].z * p.z};
}

/* first b, then a */
static wcut_step_place after(const wcut_step_place *a, const wcut_step_place *b) {
    const wcut_vec3 x = turn_step_places(a, (wcut_vec3){b->row[0].x, b->row[1].x, b->row[2].x});
    const wcut_vec3 y = turn_step_places(a, (wcut_vec3){b->row[0].y, b->row[1].y, b->row[2].y});
    const wcut_vec3 z = turn_step_places(a, (wcut_vec3){b->row[0].z, b->row[1].z, b->row[2].z});
    const wcut_vec3 t = turn_step_places(a, b->shift);
    return (wcut_step_place){{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}},
                             {t.x + a->shift.x, t.y + a->shift.y, t.z + a->shift.z}};
}

/* from the axes of one placement to those of another; exactly nothing where they are the same */
static bool placement_between(wcut_step_source *s, long from, long to, wcut_step_place *place) {
    wcut_vec3 o[2], x[2], y[2], z[2];
    const long axes[2] = {from, to};

    /* the axes of both placements */
    for (int k = 0; k < 2; k++) {
        if (!wcut_step_placement(s, axes[k], &o[k], &x[k], &y[k])) return false;
        z[k] = (wcut_vec3){x[k].y * y[k].z - x[k].z * y[k].y, x[k].z * y[k].x - x[k].x * y[k].z,
                           x[k].x * y[k].y - x[k].y * y[k].x};
    }
    *place = here;
    if (from == to || (are_equal(o[0], o[1]) && are_equal(x[0], x[1]) && are_equal(y[0], y[1]))) return true;

    /* p -> to_axes^T from_axes (p - from) + to */
    const wcut_step_place in = {{x[0], y[0], z[0]}, {0, 0, 0}};
    const wcut_step_place out = {{{x[1].x, y[1].x, z[1].x}, {x[1].y, y[1].y, z[1].y}, {x[1].z, y[1].z, z[1].z}},
                                 {0, 0, 0}};
    *place = after(&out, &in);
    const wcut_vec3 moved = turn_step_places(place, o[0]);
    place->shift = (wcut_vec3){o[1].x - moved.x, o[1].y - moved.y, o[1].z - moved.z};

    return true;
}

/* ---- who uses a representation ---- */

typedef struct search {
    wcut_step_place *place;
    int count;
    long way[DEPTH_MAX]; /* representations on the way up */
    int depth;
} search;

static bool climb(wcut_step_source *s, long representation, const wcut_step_place *below, search *f);

/* a user of the representation on top of the way: its place is `local` in `above` */
static bool step_places_use(wcut_step_source *s, long above, const wcut_step_place *local, const wcut_step_place *below,
                            search *f, bool *used) {
    const wcut_step_place place = after(local, below);
    for (int k = 0; k < f->depth; k++)
        if (f->way[k] == above) return true; /* the way it came */
    *used = true;
    return climb(s, above, &place, f);
}

/* #id relates two representations, with a transformation or as the same place */
static bool follow_relation(wcut_step_source *s, long id, const char *body, long representation,
                            const wcut_step_place *below, search *f, bool *used) {
    /* the relation, and what it relates */
    const char *plain = wcut_p21_record(body, "SHAPE_REPRESENTATION_RELATIONSHIP");
    const char *list = body[0] == '(' ? wcut_p21_record(body, "REPRESENTATION_RELATIONSHIP") : plain;
    const char *with = wcut_p21_record(body, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION");
    long part = 0, whole = 0, transformation = 0, axis[2];
    if (!list || !wcut_p21_read_reference(wcut_p21_item(list, 2), &part) ||
        !wcut_p21_read_reference(wcut_p21_item(list, 3), &whole))
        return true;

    /* without a transformation both stand in the same place */
    if (!with) {
        if (part == representation) return step_places_use(s, whole, &here, below, f, used);
        return whole != representation || step_places_use(s, part, &here, below, f, used);
    }

    /* the transformation, from the part into the whole */
    if (part != representation) return true;
    wcut_step_place local;
    wcut_p21_read_reference(wcut_p21_item(with, 0), &transformation);
    const char *moved = wcut_p21_find(&s->file, transformation);
    const char *item = moved ? wcut_p21_record(moved, "ITEM_DEFINED_TRANSFORMATION") : NULL;
    for (int k = 0; k < 2; k++)
        if (!wcut_p21_read_reference(wcut_p21_item(item, 2 + k), &axis[k]))
            return wcut_step_refuse(s, id, "an assembly whose parts are moved by other than placements");

    /* some programs name the placement in the whole first */
    const bool swapped = !holds(s, part, axis[0]) && holds(s, whole, axis[0]) && holds(s, part, axis[1]);
    return placement_between(s, axis[swapped], axis[!swapped], &local) &&
           step_places_use(s, whole, &local, below, f, used);
}

/* #id is a mapped item of a map of the representation: it stands wherever the item is listed */
static bool follow_map(wcut_step_source *s, long id, const char *list, long representation,
                       const wcut_step_place *below, search *f, bool *used) {
    long map = 0, target = 0, origin = 0, mapped = 0;
    if (!wcut_p21_read_reference(wcut_p21_item(list, 1), &map) ||
        !wcut_p21_read_reference(wcut_p21_item(list, 2), &target))
        return true;
    const char *body = wcut_p21_find(&s->file, map), *ends = body ? wcut_p21_record(body, "REPRESENTATION_MAP") : NULL;
    if (!ends || !wcut_p21_read_reference(wcut_p21_item(ends, 0), &origin) ||
        !wcut_p21_read_reference(wcut_p21_item(ends, 1), &mapped) || mapped != representation)
        return true;
    wcut_step_place local;
    const long holder = wcut_step_holder(s, id);
    const char *to = wcut_p21_find(&s->file, target);
    if (!to || !wcut_p21_record(to, "AXIS2_PLACEMENT_3D"))
        return wcut_step_refuse(s, id, "a mapped item that is scaled, expected one set by a placement");
    if (!placement_between(s, origin, target, &local)) return false;
    if (holder) return step_places_use(s, holder, &local, below, f, used);
    return true;
}

/* every user of a representation; where there is none it is the whole */
static bool climb(wcut_step_source *s, long representation, const wcut_step_place *below, search *f) {
    bool used = false;
    if (f->depth == DEPTH_MAX) return wcut_step_refuse(s, representation, "an assembly nested too deep");
    f->way[f->depth++] = representation;
    for (int k = 0; k < s->file.count; k++) {
        const wcut_p21_instance *at = &s->file.instance[k];
        const char *item = wcut_p21_record(at->body, "MAPPED_ITEM");
        if (item ? !follow_map(s, at->id, item, representation, below, f, &used)
                 : !follow_relation(s, at->id, at->body, representation, below, f, &used))
            return false;
    }
    f->depth--;
    if (used) return true;
    if (f->count == WCUT_STEP_PLACES_MAX)
        return wcut_step_refuse(s, representation, "a part that stands in more than 256 places");
    f->place[f->count++] = *below;
    return true;
}

bool wcut_step_find_places(wcut_step_source *s, long representation, wcut_step_place place[WCUT_STEP_PLACES_MAX],
                           int *count) {
    search f = {.place = place};
    const bool done = climb(s, representation, &here, &f);
    *count = f.count;
    return done;
}

bool wcut_step_set_in_place(wcut_step_source *s, long id, const wcut_step_place *place, wcut_curve *curve) {
    if (are_equal(place->shift, here.shift) && are_equal(place->row[0], here.row[0]) &&
        are_equal(place->row[1], here.row[1]) && are_equal(place->row[2], here.row[2]))
        return true;
    for (int k = 0; k < curve->control_count; k++) {
        const wcut_vec3 p = turn_step_places(place, curve->control[k]);
        wcut_vec3 *to = &curve->control[k];
        *to = (wcut_vec3){p.x + place->shift.x, p.y + place->shift.y, p.z + place->shift.z};
        if (!(fabs(to->x) <= INCREDIBLE && fabs(to->y) <= INCREDIBLE && fabs(to->z) <= INCREDIBLE))
            return wcut_step_refuse(s, id, "a curve moved beyond 1e12 mm");
    }
    return true;
}
