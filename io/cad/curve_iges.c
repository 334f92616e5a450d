/* Curves from IGES files: which entities are edges. Pieces of composite curves (102) and members of subfigures (308) are
   read with what they belong to, instances (408) are set in place, hidden entities are left out. */
#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "io/cad/iges_curves.h"

enum { INSTANCES_MAX = 8 };
static const double INCREDIBLE = 1e12; /* [mm] */

static bool refuse_curve_iges_data(wcut_iges *f, const wcut_iges_entry *e) {
    return wcut_curves_refuse(f->reader, "line %d: found too few values, or values of another kind, for this entity",
                              e->at + 1);
}

static int curve_iges_max_values(const wcut_iges_cursor *c) { return (c->end - c->line) * 32; }

static wcut_curve *leave_out_nested(wcut_iges *f) {
    wcut_curves_leave_out(f->reader, "a composite curve in a composite curve");
    return NULL;
}

/* ---- which ---- */

static bool is_curve(const wcut_iges_entry *e) {
    static const int type[] = {100, 102, 104, 106, 110, 112, 126, 130};
    for (size_t k = 0; k < sizeof type / sizeof *type; k++)
        if (e->type == type[k]) return e->type != 106 || e->form <= 3 || (e->form >= 11 && e->form <= 13);
    return false;
}

/* the pieces of a composite curve; one that is left out leaves out all */
static bool add_composite(wcut_iges *f, const wcut_iges_entry *e) {
    wcut_iges_cursor c;

    /* the number of members, limited by what the entity can hold */
    int count = 0, made = 0, number = 0;
    if (!wcut_iges_open(f, e, &c)) return false;
    if (!wcut_iges_int(&c, 1, curve_iges_max_values(&c), &count)) return refuse_curve_iges_data(f, e);

    /* the members, each in the place of the whole */
    wcut_curve **piece = wcut_alloc((size_t)count, sizeof *piece);
    if (!piece) return wcut_curves_refuse_memory(f->reader);
    for (bool ok = true; ok && made < count;) {
        wcut_iges_entry of = {0};
        if (!wcut_iges_int(&c, 1, 9999999, &number)) {
            refuse_curve_iges_data(f, e);
            break;
        }
        if (!wcut_iges_find_named(f, e, number, &of)) break;
        wcut_curve *curve = of.type == 102 ? leave_out_nested(f) : wcut_iges_curve(f, &of);
        ok = curve != NULL;
        if (ok) piece[made++] = curve;
        if (ok) ok = wcut_iges_transform(f, e, curve);
    }

    /* either the whole chain is added or none of it */
    const bool whole = made == count && f->reader->failure.status == WCUT_OK;
    if (whole) return wcut_curves_add_chain(f->reader, count, piece, "", 0);
    for (int k = 0; k < made; k++) wcut_curve_destroy(piece[k]);

    free(piece);
    return f->reader->failure.status == WCUT_OK;
}

/* ---- how entities use each other ---- */

/* the list of entries that one names at its cursor: each gets a mark */
static bool mark_all(wcut_iges *f, const wcut_iges_entry *e, wcut_iges_cursor *c, int mark) {
    int count = 0, number = 0;
    if (!wcut_iges_int(c, 0, curve_iges_max_values(c), &count)) return refuse_curve_iges_data(f, e);
    for (int k = 0; k < count && wcut_iges_int(c, 1, f->data - f->directory, &number); k++)
        f->mark[number / 2] |= (unsigned char)mark;
    return true;
}

static bool is_hidden_entry(const wcut_iges_entry *e) { return e->status[1] == '1'; }

/* composite curves, subfigures, groups; anything else is passed over */
static bool mark_members(wcut_iges *f, const wcut_iges_entry *e) {
    static const int is_group[] = {1, 7, 14, 15};
    wcut_iges_cursor c;
    bool groups = false;
    for (int k = 0; k < 4; k++) groups = groups || (e->type == 402 && e->form == is_group[k]);
    if (e->type != 102 && e->type != 308 && !groups) return true;
    if (!wcut_iges_open(f, e, &c)) return false;
    if (e->type == 102) return mark_all(f, e, &c, WCUT_IGES_PIECE);
    if (groups) return mark_all(f, e, &c, WCUT_IGES_GROUPED | (is_hidden_entry(e) ? WCUT_IGES_HIDDEN : 0));

    /* depth and name come before a subfigure's members */
    wcut_iges_pass(&c);
    wcut_iges_pass(&c);
    return mark_all(f, e, &c, WCUT_IGES_MEMBER);
}

/* ---- which curves ---- */

static bool add_iges_entity(wcut_iges *f, const wcut_iges_entry *e, int depth);

/* p -> scale p + shift of the set's curves from the `first` on, then by the instance's transformation */
static bool set_in_place(wcut_iges *f, const wcut_iges_entry *e, int first, double scale, wcut_vec3 shift) {
    wcut_curve_set *set = f->reader->set;
    for (int k = first; k < set->count; k++) {
        wcut_curve *c = set->curve[k];
        for (int i = 0; i < c->control_count; i++) {
            wcut_vec3 *p = &c->control[i];
            *p = (wcut_vec3){scale * p->x + shift.x, scale * p->y + shift.y, scale * p->z + shift.z};
            if (!(fabs(p->x) <= INCREDIBLE && fabs(p->y) <= INCREDIBLE && fabs(p->z) <= INCREDIBLE))
                return wcut_curves_refuse(f->reader, "line %d: found a curve moved beyond 1e12 mm", e->at + 1);
        }
        if (!wcut_iges_transform(f, e, c)) return false;
    }
    return true;
}

/* the members of a subfigure where its instance says */
static bool add_curve_iges_instance(wcut_iges *f, const wcut_iges_entry *e, int depth) {
    wcut_iges_cursor c, m;
    wcut_iges_entry figure = {0};
    double shift[3], scale = 1;
    int number = 0, count = 0;

    /* instances are limited in depth, because a file may nest them in a circle */
    const int first = f->reader->set->count;
    if (depth == 0) return wcut_curves_refuse(f->reader, "line %d: found instances nested too deep", e->at + 1);
    if (!wcut_iges_open(f, e, &c)) return false;

    /* the figure, where it stands and its scale */
    if (!wcut_iges_int(&c, 1, 9999999, &number) || !wcut_iges_reals(&c, 3, shift)) return refuse_curve_iges_data(f, e);
    if (!wcut_iges_real(&c, &scale)) scale = 1;
    if (!wcut_iges_find_named(f, e, number, &figure) || !wcut_iges_open(f, &figure, &m)) return false;
    if (figure.type != 308 || !(scale > 0)) return refuse_curve_iges_data(f, e);

    /* depth and name come before the members */
    wcut_iges_pass(&m);
    wcut_iges_pass(&m);
    if (!wcut_iges_int(&m, 0, curve_iges_max_values(&m), &count)) return refuse_curve_iges_data(f, &figure);
    for (int k = 0; k < count; k++) {
        wcut_iges_entry member = {0};
        if (!wcut_iges_int(&m, 1, 9999999, &number)) return refuse_curve_iges_data(f, &figure);
        if (!wcut_iges_find_named(f, &figure, number, &member) || !add_iges_entity(f, &member, depth - 1)) return false;
    }

    /* everything that was added since `first` is moved */
    return set_in_place(f, e, first, scale, (wcut_vec3){shift[0] * f->scale, shift[1] * f->scale, shift[2] * f->scale});
}

static bool add_iges_entity(wcut_iges *f, const wcut_iges_entry *e, int depth) {
    const int mark = f->mark[(e->at - f->directory) / 2];
    const bool depends = e->status[3] == '1' || e->status[3] == '3';
    if ((!is_curve(e) && e->type != 408) || (depends && (mark & WCUT_IGES_PIECE))) return true;

    /* what the file does not show, and what belongs to an entity that is not read */
    if (is_hidden_entry(e) || (mark & WCUT_IGES_HIDDEN))
        return wcut_curves_leave_out(f->reader, "a hidden entity"), true;
    const bool belongs = depends && !(mark & (WCUT_IGES_MEMBER | WCUT_IGES_GROUPED));
    if (belongs || (e->status[4] == '0' && e->status[5] == '5'))
        return wcut_curves_leave_out(f->reader, "a piece of another entity"), true;
    if (e->type == 408) return add_curve_iges_instance(f, e, depth);
    if (e->type == 102) return add_composite(f, e);
    wcut_curve *curve = wcut_iges_curve(f, e);
    if (curve) return wcut_curves_add(f->reader, curve, "", 0);
    return f->reader->failure.status == WCUT_OK;
}

bool wcut_curves_fill_iges(wcut_curve_reader *r, char *text, size_t length) {
    wcut_iges f;
    bool done = wcut_iges_begin(r, text, length, &f);
    for (int pass = 0; pass < 2; pass++)
        for (int at = f.directory; done && at < f.data; at += 2) {
            wcut_iges_entry entry;
            done = wcut_iges_find(&f, at, &entry);
            if (done && pass == 0) done = mark_members(&f, &entry);

            /* members of a subfigure are seen through its instances alone */
            else if (done && !(f.mark[(at - f.directory) / 2] & WCUT_IGES_MEMBER))
                done = add_iges_entity(&f, &entry, INSTANCES_MAX);
        }
    wcut_iges_end(&f);
    return done && wcut_curves_join_loose(r, 0);
}
