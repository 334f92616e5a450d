/* One state of a search: the run of some curves, measured against the target, with the normal equations. */
#include "inverse/trial.h"

#include <stdlib.h>
#include <string.h>
#include <wirecut/face.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"

#define STEP_MAX 0.25        /* [1] of the span: a step's largest change */
#define PATH_STEP_MAX 0.05   /* [1] the same of a correction of paths */
#define SAG_RATE 0.6         /* [1] largest gain of sag over the feed */
#define LAG_RATE 1.2         /* [1] largest change of the lag over the feed */
#define SAG_MIN 0.008        /* [1] of the span */
#define RATE_WEIGHT 20.0     /* [mm] what a rate beyond its bound by 1 costs */
#define ANGLE_WEIGHT 60.0    /* [mm] and an angle by 1 rad */
#define HEIGHT_MARGIN 0.5    /* [mm] of the edges from the block's top and bottom */
#define EDGE_BEYOND 0.95     /* [1] of the span: so far before and behind the block may edges run */
#define LIMIT 3.0            /* [1] of derivatives from step to step: first contact is no matter of derivatives */
#define SLACK_MIN 1e-3       /* [1] of the wire's length that it is longer than its mounts' distance */
#define SLACK_PRICE 20.0     /* [1] of slack that is missing */
#define FIXED_PRICE 5.0      /* [1] of an edge off the target's border */
#define MERGE 1e-3           /* [mm] of sections of the face */
#define EVEN 0.003           /* [1] of the rms: what second differences of the coefficients cost */
#define STRAY_SCALE_MIN 1e-3 /* [mm] */

enum { BOUNDS = 40 }; /* places of the feed at which bounds are held */

wcut_status wcut_trial_create(const wcut_design_target *target, const wcut_job *job, double angle_max, int threads,
                              int stations, int nodes, int unknowns_max, wcut_trial *s) {
    const size_t m = (size_t)stations, n = (size_t)nodes, u = (size_t)unknowns_max, points = (size_t)target->count;
    *s = (wcut_trial){.target = target,
                      .job = job,
                      .angle_max = angle_max,
                      .threads = threads,
                      .stations = stations,
                      .nodes = nodes,
                      .unknowns_max = unknowns_max,
                      .options = wcut_cut_options_default()};
    s->longest = STEP_MAX * target->block.x;
    s->options.max_halvings = 3; /* a run that needs more is no candidate */
    s->end_a = wcut_alloc(m, sizeof *s->end_a);
    s->end_b = wcut_alloc(m, sizeof *s->end_b);
    s->length = wcut_alloc(m, sizeof *s->length);
    s->by_a = wcut_alloc(u * m, sizeof *s->by_a);
    s->by_b = wcut_alloc(u * m, sizeof *s->by_b);
    s->by_length = wcut_alloc(u * m, sizeof *s->by_length);
    s->by = wcut_alloc(u * m * n, sizeof *s->by);
    s->foot = wcut_alloc(points, sizeof *s->foot);
    s->weight = wcut_alloc(points, sizeof *s->weight);
    s->room = wcut_alloc(points + u, sizeof *s->room);
    if (s->end_a && s->end_b && s->length && s->by_a && s->by_b && s->by_length && s->by && s->foot && s->weight &&
        s->room) {
        for (size_t k = 0; k < points; k++) s->weight[k] = 1;
        return WCUT_OK;
    }
    wcut_trial_destroy(s);
    return WCUT_NO_MEMORY;
}

/* whether what a job cuts is not where its wire was */
static bool has_face(const wcut_job *job) {
    bool acts = job->kerf_width > 0 || job->kerf_per_q > 0;
    for (int e = 0; e < job->effect_count; e++)
        acts = acts || (wcut_effect_view(job->effect[e].kind)->place == WCUT_EFFECT_PLACE_FACE &&
                        !wcut_effect_is_neutral(&job->effect[e]));
    return acts;
}

wcut_status wcut_trial_create_path(const wcut_design_target *target, const wcut_setup *base, int threads, int nodes,
                                   int unknowns_max, wcut_trial *s) {
    const wcut_status status =
        wcut_trial_create(target, base->job, WCUT_PI / 2, threads, base->stations, nodes, unknowns_max, s);
    if (status != WCUT_OK) return status;
    s->base = base;
    s->longest = PATH_STEP_MAX * target->block.x;
    s->options = base->options;
    if (!has_face(base->job)) return WCUT_OK;
    s->face = wcut_alloc((size_t)base->stations * (size_t)nodes, sizeof *s->face);
    if (s->face) return WCUT_OK;
    wcut_trial_destroy(s);
    return WCUT_NO_MEMORY;
}

void wcut_trial_destroy(wcut_trial *s) {
    wcut_free(s->end_a);
    wcut_free(s->end_b);
    wcut_free(s->length);
    wcut_free(s->by_a);
    wcut_free(s->by_b);
    wcut_free(s->by_length);
    wcut_free(s->by);
    wcut_free(s->foot);
    wcut_free(s->weight);
    wcut_free(s->room);
    wcut_free(s->face);
    *s = (wcut_trial){0};
}

/* ---- rows of the least squares ---- */

typedef struct equations {
    int unknowns;
    double *normal, *gradient; /* may be NULL: the cost alone */
    double cost;
} equations;

/* a residual and its derivatives by the unknowns first .. first + count - 1 */
static void add_equation(equations *e, double residual, int first, int count, const double *row) {
    e->cost += residual * residual;
    if (!e->normal) return;
    for (int p = 0; p < count; p++) {
        if (row[p] == 0) continue;
        double *to = e->normal + (size_t)(first + p) * (size_t)e->unknowns + first;
        for (int q = 0; q <= p; q++) to[q] += row[p] * row[q];
        e->gradient[first + p] += row[p] * residual;
    }
}

/* whether a point is neither over the face nor near its border */
static bool is_beside(const wcut_wire_foot *f) { return f->beside > fabs(f->height) + 1; }

/* the points: signed distance over the face; where the face does not reach, what is missing */
static void add_target_points(wcut_trial *s, equations *e, wcut_reached *reached) {
    const size_t face = (size_t)s->stations * (size_t)s->nodes;
    const wcut_wire_face shape = {s->stations, s->nodes, NULL};
    double *row = s->room + s->target->count, sum = 0;
    for (int k = 0; k < s->target->count; k++) {
        const wcut_wire_foot *f = &s->foot[k];
        const bool beside = is_beside(f);
        const double value = beside ? f->beside / 2 : f->height, weight = s->weight[k];
        reached->uncovered += beside;
        reached->strays += !(weight > 0);
        if (!beside && weight > 0) {
            reached->used++;
            sum += value * value;
            reached->max = fmax(reached->max, fabs(value));
        }
        if (!(weight > 0)) continue;

        /* the envelope theorem: a foot slides along the face, its height does not see that */
        const double root = sqrt(weight);
        if (e->normal) {
            const wcut_stencil at = wcut_wire_stencil(&shape, f->station, f->node);
            const wcut_vec3 along = beside ? vec3_scale(0.5, f->outward) : f->normal;
            for (int u = 0; u < e->unknowns; u++)
                row[u] = -root * vec3_dot(along, wcut_stencil_eval(&at, s->nodes, s->by + (size_t)u * face));
        }
        add_equation(e, root * value, 0, e->unknowns, row);
    }
    reached->rms = reached->used > 0 ? sqrt(sum / reached->used) : HUGE_VAL;
}

/* side * (value - limit) <= 0 as a bound */
static void put_bound(wcut_bound *to, int first, const double weight[4], double side, double excess, double price) {
    *to = (wcut_bound){.first = first, .excess = price * side * excess};
    for (int r = 0; r < 4; r++) to->row[r] = price * side * weight[r];
}

/* of corrected paths: mounts not so far apart that the wire gets straight, where it was slacker */
static int path_bounds(const wcut_trial *s, const wcut_design_curves *c, wcut_bound *bound) {
    const wcut_setup *base = s->base;
    for (int k = 0; k < WCUT_BOUNDS_MAX; k++) {
        double w[4], d[4];
        const int j = (int)((long)k * (s->stations - 1) / (WCUT_BOUNDS_MAX - 1));
        const double t = j / (s->stations - 1.0);
        const int at = wcut_design_basis(c->coefficients, t, w, d);
        const double slack = base->length[j] - vec3_distance(base->end_a[j], base->end_b[j]);
        const double room = slack - fmin(SLACK_MIN * base->length[j], slack / 2);
        const double near = wcut_design_curve_at(c, WCUT_DESIGN_CURVE_SAG, t, NULL);
        put_bound(&bound[k], at, w, -1, near + room, SLACK_PRICE);
    }
    return WCUT_BOUNDS_MAX;
}

int wcut_trial_bounds(const wcut_trial *s, const wcut_design_curves *c, wcut_bound *bound) {
    const double way = c->last - c->first, width = s->target->block.x;
    int count = 0;
    if (s->base) return path_bounds(s, c, bound);
    for (int k = 0; k < BOUNDS; k++) {
        const double t = k / (BOUNDS - 1.0);
        double w[4], d[4], sag_slope, lag_slope;
        const int at = wcut_design_basis(c->coefficients, t, w, d);
        const double sag = wcut_design_curve_at(c, WCUT_DESIGN_CURVE_SAG, t, &sag_slope);
        const double lag = wcut_design_curve_at(c, WCUT_DESIGN_CURVE_LAG, t, &lag_slope);
        for (int r = 0; r < 4; r++) d[r] /= way;
        const int sag_at = at, lag_at = c->coefficients + at;
        put_bound(&bound[count++], sag_at, w, -1, sag - SAG_MIN * width, 1);
        put_bound(&bound[count++], sag_at, d, 1, sag_slope / way - SAG_RATE, RATE_WEIGHT);
        put_bound(&bound[count++], lag_at, d, 1, lag_slope / way - LAG_RATE, RATE_WEIGHT);
        put_bound(&bound[count++], lag_at, d, -1, lag_slope / way + LAG_RATE, RATE_WEIGHT);

        /* both edges no further beyond the block than edges may be */
        const double middle = c->first + t * way;
        const double beyond = fmax(0, fmax(-middle, middle - s->target->block.y));
        const double most = 2 * fmax(0, EDGE_BEYOND * width - beyond);
        put_bound(&bound[count++], lag_at, w, 1, lag - most, 1);
        put_bound(&bound[count++], lag_at, w, -1, lag + most, 1);
    }
    return count;
}

/* edges on the target's borders: only where they are not beside the block may they leave it */
static void add_fixed_edges(const wcut_trial *s, const wcut_design_curves *c, equations *e) {
    if (c->free_edges) return;
    for (int j = 0; j < s->stations; j++) {
        double w[4], d[4], row[4];
        const double t = j / (s->stations - 1.0);
        const int at = wcut_design_basis(c->coefficients, t, w, d);
        for (int r = 0; r < 4; r++) row[r] = FIXED_PRICE * w[r];
        for (int side = 0; side < 2; side++) {
            const double y = side ? s->end_b[j].y : s->end_a[j].y;
            const wcut_design_curve which = side ? WCUT_DESIGN_CURVE_RISE_B : WCUT_DESIGN_CURVE_RISE_A;
            if (!(y >= 0 && y <= s->target->block.y)) continue;
            add_equation(e, FIXED_PRICE * wcut_design_curve_at(c, which, t, NULL), (int)which * c->coefficients + at, 4,
                         row);
        }
    }
}

/* of coefficients that the points do not determine the even ones */
static void add_evenness(const wcut_design_curves *c, double rms, equations *e) {
    static const double second[3] = {1, -2, 1};
    const double price = EVEN * fmin(rms, 10);
    for (int f = 0; f < e->unknowns / c->coefficients; f++)
        for (int k = 0; k + 2 < c->coefficients; k++) {
            const double *v = c->value[f] + k;
            double row[3];
            for (int r = 0; r < 3; r++) row[r] = price * second[r];
            add_equation(e, price * (v[0] - 2 * v[1] + v[2]), f * c->coefficients + k, 3, row);
        }
}

/* the wire's angle at both sides of the block, and its ends' heights in the block */
static void add_end_bounds(wcut_trial *s, const wcut_history *h, equations *e) {
    const size_t m = (size_t)s->stations, n = (size_t)s->nodes;
    double *row = s->room + s->target->count;
    for (int k = 0; k < BOUNDS; k++) {
        const size_t j = (size_t)k * (m - 1) / (BOUNDS - 1);
        for (int side = 0; side < 2; side++) {
            const size_t end = side ? n - 1 : 0, next = side ? n - 2 : 1;
            const wcut_vec3 *x = h->position + j * n;
            const wcut_vec3 d = vec3_sub(x[next], x[end]);
            const double across = side ? -d.x : d.x, off = hypot(d.y, d.z);
            const double excess = atan2(off, across) - s->angle_max, square = across * across + off * off;
            if (excess > 0) {
                for (int u = 0; e->normal && u < e->unknowns; u++) {
                    const wcut_vec3 *by = s->by + ((size_t)u * m + j) * n;
                    const wcut_vec3 v = vec3_sub(by[next], by[end]);
                    const double off_by = (d.y * v.y + d.z * v.z) / fmax(off, 1e-12);
                    row[u] = ANGLE_WEIGHT * (across * off_by - off * (side ? -v.x : v.x)) / square;
                }
                add_equation(e, ANGLE_WEIGHT * excess, 0, e->unknowns, row);
            }

            /* only beside the block does the height matter */
            const double z = x[end].z, top = s->target->block.z - HEIGHT_MARGIN;
            const double y = x[end].y;
            if ((z >= HEIGHT_MARGIN && z <= top) || y < 0 || y > s->target->block.y) continue;
            for (int u = 0; e->normal && u < e->unknowns; u++) row[u] = s->by[((size_t)u * m + j) * n + end].z;
            add_equation(e, z < HEIGHT_MARGIN ? z - HEIGHT_MARGIN : z - top, 0, e->unknowns, row);
        }
    }
}

/* ---- an evaluation ---- */

static wcut_status run_curves(wcut_trial *s, const wcut_design_curves *c, bool slopes, wcut_history **history) {
    wcut_setup *plan = NULL;
    const wcut_end_motion motion = {
        wcut_design_unknowns(c), s->stations, s->by_a, s->by_b, s->by_length, s->threads, 0};
    wcut_design_place(c, s->target, s->stations, s->end_a, s->end_b, s->length, slopes ? s->by_a : NULL, s->by_b,
                      s->by_length);
    wcut_status status = wcut_plan_create_between(s->job, &s->options, s->stations, s->nodes, s->end_a, s->end_b,
                                                  s->length, &plan, NULL);
    if (status == WCUT_OK)
        status = slopes ? wcut_setup_differentiate(plan, &motion, s->by, history, NULL)
                        : wcut_setup_run(plan, NULL, NULL, history, NULL);
    wcut_setup_destroy(plan);
    return status;
}

/* the base's own setup with its ends moved and as many nodes as this trial has */
static wcut_status run_paths(wcut_trial *s, const wcut_design_curves *c, bool slopes, wcut_history **history) {
    wcut_setup moved = *s->base;
    wcut_job job = *s->base->job;
    const wcut_end_motion motion = {
        wcut_design_unknowns(c), s->stations, s->by_a, s->by_b, s->by_length, s->threads, LIMIT};
    wcut_design_correct(c, s->stations, s->base->end_a, s->base->end_b, s->end_a, s->end_b, slopes ? s->by_a : NULL,
                        s->by_b, s->by_length);
    job.nodes = s->nodes;
    moved.job = &job;
    moved.options = s->options;
    moved.end_a = s->end_a, moved.end_b = s->end_b;
    moved.feed = wcut_setup_feed(&moved);
    if (slopes && moved.effect_count == 0) return wcut_setup_differentiate(&moved, &motion, s->by, history, NULL);

    /* derivatives of the plain model: effects change a cut by little, and their memory is not differentiated */
    if (slopes) {
        wcut_setup plain = moved;
        wcut_history *unused = NULL;
        plain.effect_count = 0;
        const wcut_status status = wcut_setup_differentiate(&plain, &motion, s->by, &unused, NULL);
        wcut_history_destroy(unused);
        s->runs++;
        if (status != WCUT_OK) return status;
    }
    return wcut_setup_run(&moved, NULL, NULL, history, NULL);
}

wcut_status wcut_trial_run(wcut_trial *s, const wcut_design_curves *c, bool slopes, wcut_history **history) {
    const wcut_status status = s->base ? run_paths(s, c, slopes, history) : run_curves(s, c, slopes, history);
    s->runs++;
    return status == WCUT_OK || status == WCUT_NO_MEMORY ? status : WCUT_NOT_CONVERGED;
}

/* where the face is at the nodes: a job with a kerf or effects on the face leaves it beside its wire */
static wcut_status find_trial_face(wcut_trial *s, const wcut_history *h) {
    wcut_face *face = NULL;
    wcut_status status = wcut_face_create(s->job, h, NULL, NULL, MERGE, &face);
    double *u = wcut_alloc((size_t)h->nodes, sizeof *u);
    if (status == WCUT_OK && !u) status = WCUT_NO_MEMORY;
    for (int i = 0; status == WCUT_OK && i < h->nodes; i++) u[i] = i / (h->nodes - 1.0);
    if (status == WCUT_OK)
        status = wcut_surface_eval_grid(face->surface, h->nodes, u, h->stations, face->parameter, s->face);
    wcut_free(u);
    wcut_face_destroy(face);
    return status;
}

wcut_status wcut_trial_eval(wcut_trial *s, const wcut_design_curves *c, double *normal, double *gradient,
                            wcut_reached *reached) {
    wcut_history *h = NULL;
    equations e = {.unknowns = wcut_design_unknowns(c), .normal = normal, .gradient = gradient};
    wcut_status status = wcut_trial_run(s, c, normal != NULL && !s->borrowed, &h);
    if (status == WCUT_OK && s->face) status = find_trial_face(s, h);
    if (status == WCUT_OK) {
        *reached = (wcut_reached){0};
        if (normal) {
            memset(normal, 0, (size_t)e.unknowns * (size_t)e.unknowns * sizeof *normal);
            memset(gradient, 0, (size_t)e.unknowns * sizeof *gradient);
        }

        /* feet of the target's points, then everything that costs */
        const wcut_wire_face face = {h->stations, h->nodes, s->face ? s->face : h->position};
        wcut_wire_feet(&face, s->target->count, s->target->point, s->known, s->threads, s->foot);
        s->known = true;
        add_target_points(s, &e, reached);
        if (!s->base) {
            add_fixed_edges(s, c, &e);
            add_end_bounds(s, h, &e);
        }
        add_evenness(c, reached->rms, &e);
        wcut_bound bound[WCUT_BOUNDS_MAX];
        const int bounds = wcut_trial_bounds(s, c, bound);
        for (int k = 0; k < bounds; k++) e.cost += pow(fmax(bound[k].excess, 0), 2);
        reached->cost = e.cost;
        for (int p = 0; normal && p < e.unknowns; p++)
            for (int q = p + 1; q < e.unknowns; q++)
                normal[(size_t)p * (size_t)e.unknowns + (size_t)q] = normal[(size_t)q * (size_t)e.unknowns + (size_t)p];
    }
    wcut_history_destroy(h);
    return status;
}

static int compare_sizes(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void wcut_trial_weigh(wcut_trial *s) {
    const int count = s->target->count;
    if (!s->target->robust) return;
    for (int k = 0; k < count; k++) s->room[k] = fabs(s->foot[k].height);
    qsort(s->room, (size_t)count, sizeof *s->room, compare_sizes);
    const double limit = 4.685 * fmax(1.4826 * s->room[count / 2], STRAY_SCALE_MIN);
    for (int k = 0; k < count; k++) {
        const double u = s->foot[k].height / limit;
        s->weight[k] = fabs(u) < 1 ? (1 - u * u) * (1 - u * u) : 0;
    }
}
