/* A set of curves that grows as a file is read, and how a reader of curves refuses. */
#include "io/cad/curve_set.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/edit.h>
#include <wirecut/reshape.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/locale.h"
#include "io/file/number.h"

bool wcut_curves_refuse(wcut_curve_reader *r, const char *format, ...) {
    char label[WCUT_QUOTE_SIZE], text[300], shown[WCUT_QUOTE_SIZE];
    va_list arguments;
    if (r->failure.status != WCUT_OK) return false;
    va_start(arguments, format);
    locale_t before = wcut_locale_plain();
    vsnprintf(text, sizeof text, format, arguments);
    wcut_locale_restore(before);
    va_end(arguments);
    wcut_fail(&r->failure, WCUT_BAD_FORMAT, "%s: %s", wcut_quote(label, r->label, WCUT_LABEL_MAX, 1),
              wcut_quote(shown, text, WCUT_QUOTE_SIZE - 20, 0));
    return false;
}

bool wcut_curves_refuse_memory(wcut_curve_reader *r) {
    char label[WCUT_QUOTE_SIZE];
    if (r->failure.status == WCUT_OK)
        wcut_fail(&r->failure, WCUT_NO_MEMORY, "%s: %s", wcut_quote(label, r->label, WCUT_LABEL_MAX, 1),
                  wcut_status_text(WCUT_NO_MEMORY));
    return false;
}

/* ---- the set ---- */

static char *copy_name(const char *name, size_t length) {
    char *copy = wcut_alloc(length + 1, 1);
    size_t used = 0;
    for (size_t k = 0; copy && k < length; k++)
        if ((unsigned char)name[k] >= 0x20 && name[k] != 0x7f) copy[used++] = name[k];
    return copy;
}

static bool make_curve_set_room(wcut_curve_reader *r) {
    if ((size_t)r->set->count < r->room) return true;
    const size_t room = r->room ? 2 * r->room : 16;
    wcut_curve **curve = wcut_grow(r->set->curve, room * sizeof *curve);
    if (curve) r->set->curve = curve;
    char **name = curve ? wcut_grow(r->set->name, room * sizeof *name) : NULL;
    if (!name) return false;
    r->set->name = name;
    r->room = room;
    return true;
}

bool wcut_curves_add(wcut_curve_reader *r, wcut_curve *curve, const char *name, size_t length) {
    char *copy = NULL;
    bool ok = r->set->count < r->options->max_curves ||
              wcut_curves_refuse(r, "found more than %d curves, expected at most that", r->options->max_curves);
    if (ok) {
        copy = copy_name(name, length);
        ok = (copy && make_curve_set_room(r)) || wcut_curves_refuse_memory(r);
    }
    if (!ok) {
        free(copy);
        wcut_curve_destroy(curve);
        return false;
    }
    r->set->curve[r->set->count] = curve;
    r->set->name[r->set->count++] = copy;
    return true;
}

void wcut_curves_use_accuracy(wcut_curve_reader *r, double accuracy) { r->accuracy = fmin(accuracy, 0.1); }

/* [mm] 1e-3 is what CAD programs call one point; an accuracy is not met to its last digit */
static double gap_of(const wcut_curve_reader *r) { return fmax(1e-3, 1.001 * r->accuracy); }

bool wcut_curves_add_chain(wcut_curve_reader *r, int count, wcut_curve **curve, const char *name, size_t length) {
    wcut_curve *whole = NULL;
    bool ok = true;
    const wcut_status status = wcut_curve_join(count, (const wcut_curve *const *)curve, gap_of(r), &whole, NULL);
    if (status == WCUT_NO_MEMORY) ok = wcut_curves_refuse_memory(r);
    if (status == WCUT_OK) ok = wcut_curves_add(r, whole, name, length);
    for (int k = 0; k < count; k++) {
        if (status != WCUT_OK && ok)
            ok = wcut_curves_add(r, curve[k], name, length);
        else
            wcut_curve_destroy(curve[k]);
    }
    free(curve);
    return ok;
}

/* ---- loose pieces ---- */

/* an end of a curve: where it is, and the unit direction that leads out of the curve there */
typedef struct curve_end {
    wcut_vec3 point, out;
} curve_end;

static curve_end curve_set_end_of(const wcut_curve *curve, int which) {
    double first, last;
    wcut_vec3 d[2] = {{0, 0, 0}, {0, 0, 0}};
    wcut_curve_domain(curve, &first, &last);
    wcut_curve_eval(curve, which ? last : first, 1, d); /* within its domain: cannot fail */
    const double size = sqrt(d[1].x * d[1].x + d[1].y * d[1].y + d[1].z * d[1].z);
    const double scale = size > 0 ? (which ? 1 : -1) / size : 0;
    return (curve_end){d[0], {scale * d[1].x, scale * d[1].y, scale * d[1].z}};
}

static bool is_one_place(wcut_vec3 a, wcut_vec3 b, double gap) {
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return sqrt(x * x + y * y + z * z) <= gap;
}

/* the one other end, 2 k or 2 k + 1 of curve k, in the place of end `at`, if the curves run on there without a corner of
   more than 60 deg; -1: none, or several ends are there */
static int find_partner(int ends, const curve_end *end, int at, double gap) {
    int found = -1;
    for (int k = 0; k < ends; k++) {
        if (k == at || !is_one_place(end[k].point, end[at].point, gap)) continue;
        if (found >= 0) return -1;
        found = k;
    }
    if (found < 0) return -1;
    const wcut_vec3 a = end[at].out, b = end[found].out;
    return a.x * b.x + a.y * b.y + a.z * b.z < -0.5 ? found : -1;
}

/* ends of loose curves: where each meets its one partner, and which curves a chain has taken */
typedef struct loose {
    int curves;
    wcut_curve **curve; /* of the set, from its first loose one on; NULL: gone into a chain */
    int *partner;       /* 2 curves */
    wcut_curve **piece; /* curves: a chain in its order */
    bool *is_turned;    /* curves */
} loose;

/* the chain that begins at an end without a partner; gives its length */
static int collect_chain(loose *l, int start) {
    int count = 0, at = start;
    for (;;) {
        l->piece[count] = l->curve[at / 2];
        l->is_turned[count++] = at % 2 == 1;
        l->curve[at / 2] = NULL;
        const int next = l->partner[at ^ 1];
        if (next < 0) break;
        at = next;
    }
    return count;
}

/* one curve from the pieces of a chain, which are taken; NULL: no memory */
static wcut_curve *join_chain(const wcut_curve_reader *r, loose *l, int count) {
    wcut_curve *whole = NULL;
    wcut_status status = WCUT_OK;
    for (int k = 0; k < count && status == WCUT_OK; k++) {
        wcut_curve *turned = NULL;
        if (!l->is_turned[k]) continue;
        status = wcut_curve_reverse(l->piece[k], &turned);
        if (status != WCUT_OK) break;
        wcut_curve_destroy(l->piece[k]);
        l->piece[k] = turned;
    }

    /* no curve where a piece cannot be turned, or the pieces do not meet */
    if (status == WCUT_OK &&
        wcut_curve_join(count, (const wcut_curve *const *)l->piece, gap_of(r), &whole, NULL) != WCUT_OK)
        whole = NULL;
    for (int k = 0; k < count; k++) wcut_curve_destroy(l->piece[k]);
    return whole;
}

/* every chain becomes one curve in the place of one of its ends; the set closes up behind them */
static bool join_chains(wcut_curve_reader *r, int first, loose *l) {
    wcut_curve_set *set = r->set;
    bool done = true;

    /* an end without a partner begins a chain */
    for (int e = 0; done && e < 2 * l->curves; e++) {
        if (!l->curve[e / 2] || l->partner[e] >= 0 || l->partner[e ^ 1] < 0) continue;

        /* the chain's pieces become one curve, in the slot of its first piece */
        const int count = collect_chain(l, e);
        wcut_curve *whole = join_chain(r, l, count);
        l->curve[e / 2] = whole;
        done = whole || wcut_curves_refuse_memory(r);
    }

    /* close the gaps that joined pieces leave in the set */
    int kept = first;
    for (int k = 0; k < l->curves; k++) {
        if (!l->curve[k]) {
            wcut_free(set->name[first + k]);
            continue;
        }
        set->name[kept] = set->name[first + k];
        set->curve[kept++] = l->curve[k];
    }
    set->count = kept;

    return done;
}

bool wcut_curves_join_loose(wcut_curve_reader *r, int first) {
    enum { PIECES_MAX = 2000 };
    loose l = {.curves = r->set->count - first};
    const size_t n = (size_t)l.curves;

    /* two curves cannot be pieces of edges; too many are no edges */
    if (l.curves <= 2 || l.curves > PIECES_MAX) return true;

    /* ends of all curves, and the partner of each end within the gap */
    curve_end *end = wcut_alloc(2 * n, sizeof *end);
    l.curve = wcut_copy(r->set->curve + first, n, sizeof *l.curve);
    l.piece = wcut_alloc(n, sizeof(wcut_curve *));
    l.partner = wcut_alloc(2 * n, sizeof *l.partner);
    l.is_turned = wcut_alloc(n, sizeof *l.is_turned);
    bool done = end && l.curve && l.piece && l.partner && l.is_turned;
    if (!done) wcut_curves_refuse_memory(r);
    int joints = 0;

    /* an end and the one that it meets; a curve that meets itself is closed */
    for (int k = 0; done && k < 2 * l.curves; k++) end[k] = curve_set_end_of(l.curve[k / 2], k % 2);
    for (int k = 0; done && k < 2 * l.curves; k++) {
        l.partner[k] = find_partner(2 * l.curves, end, k, gap_of(r));
        if (l.partner[k] == (k ^ 1)) l.partner[k] = -1; /* a closed curve */
        joints += l.partner[k] >= 0;
    }

    /* two curves at least are left, else they are edges that meet */
    if (done && joints > 0 && l.curves - joints / 2 >= 2) done = join_chains(r, first, &l);

    wcut_free(end);
    wcut_free(l.curve);
    wcut_free(l.piece);
    wcut_free(l.partner);
    wcut_free(l.is_turned);
    return done;
}

/* each kind is told once */
void wcut_curves_leave_out(wcut_curve_reader *r, const char *kind) {
    char *why = r->set->why;
    const size_t used = strlen(why), max = sizeof r->set->why;
    r->set->left_out++;
    const char *told = strstr(why, kind);
    if (told && (told[strlen(kind)] == '\0' || told[strlen(kind)] == ',')) return;
    snprintf(why + used, max - used, "%s%s", used ? ", " : "", kind);
}

void wcut_curve_set_destroy(wcut_curve_set *set) {
    if (!set) return;
    for (int k = 0; k < set->count; k++) {
        wcut_curve_destroy(set->curve[k]);
        free(set->name[k]);
    }
    free(set->curve);
    free(set->name);
    free(set);
}

/* ---- curves ---- */

static bool are_near(int count, const wcut_vec3 *p) {
    for (int k = 0; k < count; k++) /* false for nan, too */
        if (!(fabs(p[k].x) <= 1e12 && fabs(p[k].y) <= 1e12 && fabs(p[k].z) <= 1e12)) return false;
    return true;
}

wcut_curve *wcut_curves_make(wcut_curve_reader *r, const char *place, int degree, int count, const double *knots,
                             const wcut_vec3 *control, const double *weights) {
    wcut_curve *curve = NULL;
    if (!are_near(count, control)) {
        wcut_curves_refuse(r, "%s: found a coordinate beyond 1e12 mm", place);
        return NULL;
    }
    const wcut_status status = wcut_curve_create(degree, count, knots, control, weights, &curve);
    if (status == WCUT_NO_MEMORY) wcut_curves_refuse_memory(r);
    if (status != WCUT_OK && status != WCUT_NO_MEMORY)
        wcut_curves_refuse(r,
                           "%s: found knots or weights that make no curve of degree %d with %d control points, "
                           "expected knots that do not decrease, span a domain and repeat at most degree times inside "
                           "it, and positive weights",
                           place, degree, count);
    return curve;
}

/* the part of a curve on one side of u, the curve itself where u is its end */
static wcut_curve *cut_side(wcut_curve_reader *r, wcut_curve *curve, double u, bool keep_low) {
    double first, last;
    wcut_curve *low = NULL, *high = NULL;
    wcut_curve_domain(curve, &first, &last);
    const double slack = 1e-9 * (last - first);
    if (keep_low ? u >= last - slack : u <= first + slack) return curve;
    if (u > first + slack && u < last - slack) {
        const wcut_status status = wcut_curve_split(curve, u, &low, &high);
        if (status != WCUT_OK) wcut_curves_refuse_memory(r);
    } else {
        wcut_curves_leave_out(r, "a trimmed curve of no length");
    }
    wcut_curve_destroy(curve);
    wcut_curve_destroy(keep_low ? high : low);
    return keep_low ? low : high;
}

wcut_curve *wcut_curves_cut(wcut_curve_reader *r, wcut_curve *curve, double from, double to) {
    curve = cut_side(r, curve, from, false);
    return curve ? cut_side(r, curve, to, true) : NULL;
}

wcut_curve *wcut_curves_polyline(wcut_curve_reader *r, const char *place, int count, const wcut_vec3 *point) {
    wcut_vec3 *control = wcut_alloc((size_t)count, sizeof *control);
    double *knots = wcut_alloc((size_t)count + 2, sizeof *knots);
    wcut_curve *curve = NULL;
    int n = 0;

    /* neighbours in one place are one point */
    if (control && knots) {
        for (int k = 0; k < count; k++) {
            const wcut_vec3 p = point[k], q = n ? control[n - 1] : p;
            if (n == 0 || p.x != q.x || p.y != q.y || p.z != q.z) control[n++] = p;
        }

        /* a line of degree 1, its parameter counts the points */
        knots[0] = 0;
        for (int k = 0; k < n; k++) knots[k + 1] = k;
        knots[n + 1] = n - 1;
        if (n >= 2)
            curve = wcut_curves_make(r, place, 1, n, knots, control, NULL);
        else
            wcut_curves_refuse(r, "%s: found %d points in one place, expected two apart", place, count);
    } else {
        wcut_curves_refuse_memory(r);
    }

    free(knots);
    free(control);
    return curve;
}
