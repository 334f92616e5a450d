/* A point's deviation from a face: the signed distance to its closest point, and whether that counts. */
#include <wirecut/deviation.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "scan/mesh_distance.h"
#include "surface/query_batch.h"

/* The distance is all height where the foot is inside. Below this share of it no side can be told; at an edge of two
   faces at right angles, whose normal is between theirs, the share is 0.7. */
static const double SIDE = 0.5, NEAR = 1e-9; /* [1]; [mm] nearer than this there is no side to tell */

wcut_deviation_options wcut_deviation_options_default(void) {
    return (wcut_deviation_options){
        .low = {-INFINITY, -INFINITY, -INFINITY}, .high = {INFINITY, INFINITY, INFINITY}, .border = 1};
}

const char *wcut_place_name(wcut_place place) {
    static const char *const text[] = {"inside", "border", "beyond", "ambiguous"};
    return (unsigned)place < WCUT_PLACE_COUNT ? text[place] : NULL;
}

static bool deviation_are_usable(const wcut_deviation_options *o) {
    return o->low.x <= o->high.x && o->low.y <= o->high.y && o->low.z <= o->high.z && isfinite(o->border) &&
           o->border >= 0 && isfinite(o->reach) && o->reach >= 0;
}

static inline double deviation_smaller(double a, double b) { return a < b ? a : b; }

/* how far a foot is inside the window's sides: negative outside */
static inline double depth_of(const wcut_deviation_options *o, wcut_vec3 p) {
    const double x = deviation_smaller(p.x - o->low.x, o->high.x - p.x),
                 y = deviation_smaller(p.y - o->low.y, o->high.y - p.y);
    return deviation_smaller(deviation_smaller(x, y), deviation_smaller(p.z - o->low.z, o->high.z - p.z));
}

/* a foot on either kind of reference, before it is judged */
typedef struct finding {
    wcut_vec3 foot;
    double distance, height;
    bool border, beyond, tied;
} finding;

static void deviation_judge(const wcut_deviation_options *o, const finding *f, wcut_deviation *d) {
    const double depth = depth_of(o, f->foot);
    const bool aside = fabs(f->height) < SIDE * f->distance && f->distance > NEAR;
    d->foot = f->foot;
    d->distance = (f->height < 0) == (o->flip != 0) ? f->distance : -f->distance;
    if (f->distance == 0) d->distance = 0;
    if (f->beyond || depth < 0 || (o->reach > 0 && f->distance > o->reach))
        d->place = WCUT_PLACE_BEYOND;
    else if (f->tied || aside)
        d->place = WCUT_PLACE_AMBIGUOUS;
    else
        d->place = f->border || depth < o->border ? WCUT_PLACE_BORDER : WCUT_PLACE_INSIDE;
}

/* where feet become deviations */
typedef struct desk {
    const wcut_deviation_options *options;
    wcut_deviation *deviation;
    wcut_foot *foot; /* NULL: not asked for */
} desk;

static void judge_feet(void *to, int count, const int *index, const void *feet) {
    const desk *d = to;
    const wcut_foot *foot = feet;
    for (int k = 0; k < count; k++) {
        const wcut_foot *from = &foot[k];
        wcut_deviation *of = &d->deviation[index[k]];
        const finding f = {.foot = from->point,
                           .distance = from->distance,
                           .height = from->height,
                           .beyond = from->beyond != 0,
                           .tied = from->gap > 0};
        of->u = from->u, of->v = from->v, of->triangle = -1;
        deviation_judge(d->options, &f, of);
        if (d->foot) d->foot[index[k]] = *from;
    }
}

wcut_status wcut_deviation_from_surface(const wcut_projection *projection, int count, const wcut_vec3 *point,
                                        const wcut_deviation_options *options, int threads, wcut_deviation *deviation,
                                        wcut_foot *foot) {
    const wcut_deviation_options o = options ? *options : wcut_deviation_options_default();
    if (!projection || count < 0 || threads < 1 || !deviation_are_usable(&o) ||
        (count > 0 && (!point || !deviation || !wcut_are_near(count, point))))
        return WCUT_BAD_ARGUMENT;
    desk d = {.options = &o, .deviation = deviation, .foot = foot};
    const wcut_query_batch batch = {.locate = wcut_projection_locate_batch,
                                    .on = projection,
                                    .take = judge_feet,
                                    .to = &d,
                                    .result = deviation,
                                    .size = sizeof *deviation};
    return wcut_query_batch_run(&batch, count, point, threads);
}

static void judge_mesh_feet(void *to, int count, const int *index, const void *feet) {
    const desk *d = to;
    const wcut_mesh_foot *foot = feet;
    for (int k = 0; k < count; k++) {
        const wcut_mesh_foot *from = &foot[k];
        wcut_deviation *of = &d->deviation[index[k]];
        const finding f = {.foot = from->point,
                           .distance = from->distance,
                           .height = from->height,
                           .border = from->border != 0,
                           .beyond = from->beyond != 0};
        of->u = from->b, of->v = from->c, of->triangle = from->triangle;
        deviation_judge(d->options, &f, of);
    }
}

wcut_status wcut_deviation_from_mesh(const wcut_mesh_tree *tree, int count, const wcut_vec3 *point,
                                     const wcut_deviation_options *options, int threads, wcut_deviation *deviation) {
    const wcut_deviation_options o = options ? *options : wcut_deviation_options_default();
    if (!tree || count < 0 || threads < 1 || !deviation_are_usable(&o) ||
        (count > 0 && (!point || !deviation || !wcut_are_near(count, point))))
        return WCUT_BAD_ARGUMENT;
    desk d = {.options = &o, .deviation = deviation};
    const wcut_query_batch batch = {.locate = wcut_mesh_tree_locate_batch,
                                    .on = tree,
                                    .take = judge_mesh_feet,
                                    .to = &d,
                                    .result = deviation,
                                    .size = sizeof *deviation};
    return wcut_query_batch_run(&batch, count, point, threads);
}

wcut_status wcut_deviation_onto_surface(const wcut_mesh *mesh, int count, wcut_deviation *deviation) {
    if (!mesh || !mesh->uv || count < 0 || (count > 0 && !deviation)) return WCUT_BAD_ARGUMENT;
    for (int i = 0; i < count; i++)
        if (deviation[i].triangle < 0 || deviation[i].triangle >= mesh->triangle_count) return WCUT_BAD_ARGUMENT;
    for (int i = 0; i < count; i++) {
        wcut_deviation *d = &deviation[i];
        const double share[3] = {1 - d->u - d->v, d->u, d->v};
        d->u = d->v = 0;
        for (int k = 0; k < 3; k++) {
            const double *uv = &mesh->uv[2 * (size_t)mesh->triangle[3 * (size_t)d->triangle + k]];
            d->u += share[k] * uv[0];
            d->v += share[k] * uv[1];
        }
        d->triangle = -1;
    }
    return WCUT_OK;
}
