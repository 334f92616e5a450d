/* "wirecut-facade/1" in: lattice, fields, variants, elements; then laid out. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/job_file.h>
#include <wirecut/read.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/random.h"
#include "io/facade/description.h"
#include "io/file/read_file.h"

#define FORMAT "wirecut-facade/1"

/* ---- names ---- */

char *wcut_facade_join(wcut_reader *reader, const wcut_place *at, const wcut_describing *d, const char *name) {
    if (!name || !*name) {
        wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a file's name");
        return NULL;
    }
    char *path = wcut_path_join(d->folder, *name == '/' ? 0 : strlen(d->folder), name);
    if (!path) (void)wcut_refuse_memory(reader);
    return path;
}

/* a status of another reader, which has said why */
static bool pass_status_on(wcut_reader *reader, wcut_status status) {
    if (status != WCUT_OK) reader->status = status;
    return status == WCUT_OK;
}

/* ---- lattice ---- */

static bool read_rows_of(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 1, WCUT_FACADE_ELEMENTS_MAX, &((wcut_describing *)into)->plan.rows);
}

static bool read_columns_of(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 1, WCUT_FACADE_ELEMENTS_MAX, &((wcut_describing *)into)->plan.columns);
}

static bool read_cylinder_radius(wcut_reader *reader, const wcut_place *at, void *into) {
    double *radius = &((wcut_describing *)into)->plan.radius;
    return wcut_read_finite(reader, at, radius) &&
           (*radius != 0 || wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a number other than 0"));
}

/* the one face of a STEP or IGES file */
static bool read_surface_file(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_describing *d = into;
    wcut_trimmed_set *set = NULL;
    if (!wcut_read_text(reader, at, &d->surface_path)) return false;
    char *path = wcut_facade_join(reader, at, d, d->surface_path);
    if (!path) return false;
    const wcut_status status = wcut_trimmed_set_read(path, &set, reader->error);
    wcut_free(path);
    if (!pass_status_on(reader, status)) return false;
    const bool one = set->count == 1;
    if (one) { /* the whole surface: what bounds it does not count */
        d->surface = set->face[0]->surface;
        set->face[0]->surface = NULL;
        d->plan.surface = d->surface;
    } else {
        wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a file with one surface, not %d", set->count);
    }
    wcut_trimmed_set_destroy(set);
    return one;
}

static bool skip_lattice_kind(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)reader, (void)at, (void)into;
    return true;
}

static bool read_lattice(wcut_reader *reader, const wcut_place *at, void *into) {
    static const char *const word[] = {"plane", "cylinder", "surface", "free", NULL};
    static const wcut_field fields[] = {{"kind", true, skip_lattice_kind, 0},
                                        {"rows", true, read_rows_of, 0},
                                        {"columns", true, read_columns_of, 0},
                                        {"radius_mm", true, read_cylinder_radius, 0}};
    static const wcut_field surface_fields[] = {{"kind", true, skip_lattice_kind, 0},
                                                {"rows", true, read_rows_of, 0},
                                                {"columns", true, read_columns_of, 0},
                                                {"file", true, read_surface_file, 0}};
    wcut_describing *d = into;
    int kind = 0;

    /* its kind says which keys it has */
    const wcut_place of = wcut_place_member(at, "kind");
    if (!json_is_object(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object with \"kind\"");
    if (!wcut_read_word(reader, &of, word, &kind)) return false;
    d->plan.lattice = (wcut_facade_lattice)kind;
    if (kind == WCUT_FACADE_LATTICE_FREE) return wcut_read_object(reader, at, fields, 1, d);
    const bool surface = kind == WCUT_FACADE_LATTICE_SURFACE;
    const int count = kind == WCUT_FACADE_LATTICE_PLANE ? 3 : 4;
    if (!wcut_read_object(reader, at, surface ? surface_fields : fields, count, d)) return false;
    return d->plan.rows <= WCUT_FACADE_ELEMENTS_MAX / d->plan.columns ||
           wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "at most %d cells", WCUT_FACADE_ELEMENTS_MAX);
}

/* ---- variants ---- */

bool wcut_facade_read_turn(wcut_reader *reader, const wcut_place *at, int *turn) {
    int degrees = 0;
    if (!wcut_read_int(reader, at, 0, 270, &degrees)) return false;
    if (degrees % 90 != 0) return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "0, 90, 180 or 270");
    *turn = degrees / 90;
    return true;
}

static bool read_flag(wcut_reader *reader, const wcut_place *at, bool *flag) {
    if (!json_is_boolean(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "true or false");
    *flag = json_is_true(at->value);
    return true;
}

/* a variant with what reading it needs */
typedef struct variant_filling {
    wcut_facade_variant variant;
    const wcut_describing *of;
} variant_filling;

static bool read_variant_name(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_text(reader, at, &((variant_filling *)into)->variant.name);
}

static bool read_variant_job(wcut_reader *reader, const wcut_place *at, void *into) {
    variant_filling *to = into;
    to->variant.path = wcut_facade_join(reader, at, to->of, json_string_value(at->value));
    return to->variant.path && pass_status_on(reader, wcut_job_read(to->variant.path, &to->variant.job, reader->error));
}

static bool read_variant_turn(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_facade_read_turn(reader, at, &((variant_filling *)into)->variant.turn);
}

static bool read_variant_mirrored(wcut_reader *reader, const wcut_place *at, void *into) {
    return read_flag(reader, at, &((variant_filling *)into)->variant.mirrored);
}

/* room for one more variant */
static wcut_facade_variant *add_variant(wcut_reader *reader, const wcut_place *at, wcut_describing *d) {
    if (d->variants >= WCUT_FACADE_VARIANTS_MAX) {
        wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "at most %d variants and jobs", WCUT_FACADE_VARIANTS_MAX);
        return NULL;
    }
    wcut_facade_variant *grown = wcut_grow(d->variant, (size_t)(d->variants + 1) * sizeof *grown);
    if (!grown) {
        (void)wcut_refuse_memory(reader);
        return NULL;
    }
    d->variant = grown;
    grown[d->variants] = (wcut_facade_variant){0};
    return &grown[d->variants++];
}

static bool read_variants(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {{"name", true, read_variant_name, 0},
                                        {"job", true, read_variant_job, 0},
                                        {"turn_deg", false, read_variant_turn, 0},
                                        {"mirrored", false, read_variant_mirrored, 0}};
    wcut_describing *d = into;
    const size_t n = json_array_size(at->value);
    if (!json_is_array(at->value) || n < 1)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an array of at least one variant");
    for (size_t i = 0; i < n; i++) {
        const wcut_place item = {at, NULL, i, json_array_get(at->value, i)};
        wcut_facade_variant *v = add_variant(reader, &item, d);
        variant_filling to = {.of = d};
        if (!v) return false;
        const bool whole = wcut_read_object(reader, &item, fields, sizeof fields / sizeof *fields, &to);
        *v = to.variant;
        if (!whole) return false;
    }
    return true;
}

/* a job by its file's name: one variant however often it is named; *found: which */
static bool take_job(wcut_reader *reader, const wcut_place *at, wcut_describing *d, int *found) {
    char *path = wcut_facade_join(reader, at, d, json_string_value(at->value));
    if (!path) return false;
    for (int k = 0; k < d->variants; k++)
        if (strcmp(d->variant[k].path, path) == 0) {
            wcut_free(path);
            *found = k;
            return true;
        }
    wcut_facade_variant *v = add_variant(reader, at, d);
    if (!v) {
        wcut_free(path);
        return false;
    }
    *found = d->variants - 1;
    v->path = path;
    v->name = strdup(json_string_value(at->value));
    if (!v->name) return wcut_refuse_memory(reader);
    return pass_status_on(reader, wcut_job_read(path, &v->job, reader->error));
}

static bool read_base_job(wcut_reader *reader, const wcut_place *at, void *into) {
    int found = 0;
    return take_job(reader, at, into, &found);
}

/* ---- the rule that deals them ---- */

static bool skip_rule(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)reader, (void)at, (void)into;
    return true;
}

static bool read_deal_seed(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 0, INT32_MAX, &((wcut_describing *)into)->seed);
}

static bool read_deal_field(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_describing *d = into;
    return wcut_facade_field_locate(reader, at, d, &d->deal_field);
}

static bool read_deal_values(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_describing *d = into;
    void *list = NULL;
    const bool whole = wcut_read_array(reader, at, d->variants, d->variants, "numbers, one for each variant",
                                       wcut_read_finite, sizeof(double), &d->deal_values, &list);
    d->deal_value = list;
    return whole;
}

static bool read_deal(wcut_reader *reader, const wcut_place *at, void *into) {
    static const char *const word[] = {"checkerboard", "random", "nearest", NULL};
    static const wcut_field fields[] = {{"rule", true, skip_rule, 0}, {"seed", true, read_deal_seed, 0}};
    static const wcut_field nearest[] = {
        {"rule", true, skip_rule, 0}, {"field", true, read_deal_field, 0}, {"values", true, read_deal_values, 0}};
    wcut_describing *d = into;
    int rule = 0;
    const wcut_place of = wcut_place_member(at, "rule");
    if (!json_is_object(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object with \"rule\"");
    if (!wcut_read_word(reader, &of, word, &rule)) return false;
    d->deal = (wcut_deal)(WCUT_DEAL_CHECKERBOARD + rule);
    if (d->deal == WCUT_DEAL_NEAREST) return wcut_read_object(reader, at, nearest, 3, d);
    return wcut_read_object(reader, at, fields, d->deal == WCUT_DEAL_RANDOM ? 2 : 1, d);
}

/* a variant for every cell, by the rule; without one all follow the one job */
static bool deal_cells(wcut_reader *reader, const wcut_place *at, wcut_describing *d) {
    const int rows = d->plan.rows, columns = d->plan.columns;
    d->placements = rows * columns;
    d->placement = wcut_alloc((size_t)d->placements, sizeof *d->placement);
    if (!d->placement) return wcut_refuse_memory(reader);
    wcut_random random = wcut_random_seed((uint64_t)d->seed);
    const double size[2] = {columns, rows}; /* a grid is laid over the cells, whatever their size; so are the others */
    for (int k = 0; k < d->placements; k++) {
        const int r = k / columns, c = k % columns;
        int which = 0;
        if (d->deal == WCUT_DEAL_CHECKERBOARD) which = (r + c) % d->variants;
        if (d->deal == WCUT_DEAL_RANDOM) which = wcut_random_below(&random, d->variants);
        if (d->deal == WCUT_DEAL_NEAREST) {
            /* in mm, at the middle of the cell */
            const wcut_vec3 block = d->variant[0].job->block_size;
            const double pu = block.x + d->plan.joint, pv = block.y + d->plan.joint,
                         all[2] = {size[0] * pu, size[1] * pv};
            double value;
            if (wcut_facade_field_eval(1, &d->field[d->deal_field].field, all, (c + 0.5) * pu, (r + 0.5) * pv,
                                       &value) != WCUT_OK)
                return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a field with a value everywhere");
            for (int v = 1; v < d->variants; v++)
                if (fabs(d->deal_value[v] - value) < fabs(d->deal_value[which] - value)) which = v;
        }
        const wcut_facade_variant *v = &d->variant[which];
        d->placement[k] =
            (wcut_facade_placement){.row = r, .column = c, .turn = v->turn, .mirrored = v->mirrored, .job = which};
    }
    return true;
}

/* ---- elements ---- */

typedef struct element_filling {
    wcut_facade_placement placement;
    wcut_describing *of;
    bool has_job;
} element_filling;

static bool read_element_row(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 0, WCUT_FACADE_ELEMENTS_MAX, &((element_filling *)into)->placement.row);
}

static bool read_element_column(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 0, WCUT_FACADE_ELEMENTS_MAX, &((element_filling *)into)->placement.column);
}

static bool read_own_job(wcut_reader *reader, const wcut_place *at, void *into) {
    element_filling *to = into;
    if (to->has_job) return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "one of \"job\" and \"variant\"");
    to->has_job = true;
    return take_job(reader, at, to->of, &to->placement.job);
}

static bool read_own_variant(wcut_reader *reader, const wcut_place *at, void *into) {
    element_filling *to = into;
    const wcut_describing *d = to->of;
    const char *name = json_string_value(at->value);
    if (to->has_job) return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "one of \"job\" and \"variant\"");
    for (int k = 0; name && k < d->variants; k++)
        if (strcmp(d->variant[k].name, name) == 0) {
            to->has_job = true;
            to->placement.job = k;
            to->placement.turn = d->variant[k].turn;
            to->placement.mirrored = d->variant[k].mirrored;
            return true;
        }
    return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "the name of one of \"variants\"");
}

static bool read_own_turn(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_facade_read_turn(reader, at, &((element_filling *)into)->placement.turn);
}

static bool read_own_mirrored(wcut_reader *reader, const wcut_place *at, void *into) {
    return read_flag(reader, at, &((element_filling *)into)->placement.mirrored);
}

static bool read_origin(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_point(reader, at, &((element_filling *)into)->placement.origin);
}

static bool read_x_axis(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_point(reader, at, &((element_filling *)into)->placement.x);
}

static bool read_y_axis(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_point(reader, at, &((element_filling *)into)->placement.y);
}

/* how an element of a lattice is given, and how a free one */
static const wcut_field cell_key[] = {{"row", true, read_element_row, 0},    {"column", true, read_element_column, 0},
                                      {"job", false, read_own_job, 0},       {"variant", false, read_own_variant, 0},
                                      {"turn_deg", false, read_own_turn, 0}, {"mirrored", false, read_own_mirrored, 0}};
static const wcut_field free_key[] = {{"origin_mm", true, read_origin, 0},      {"x_axis", false, read_x_axis, 0},
                                      {"y_axis", false, read_y_axis, 0},        {"job", false, read_own_job, 0},
                                      {"variant", false, read_own_variant, 0},  {"turn_deg", false, read_own_turn, 0},
                                      {"mirrored", false, read_own_mirrored, 0}};

static bool read_elements(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_describing *d = into;
    const bool free = d->plan.lattice == WCUT_FACADE_LATTICE_FREE;
    const size_t n = json_array_size(at->value);
    if (!json_is_array(at->value) || n < 1 || n > WCUT_FACADE_ELEMENTS_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an array of 1 to %d elements", WCUT_FACADE_ELEMENTS_MAX);
    d->placement = wcut_alloc(n, sizeof *d->placement);
    if (!d->placement) return wcut_refuse_memory(reader);

    /* free ones are numbered as columns of one row */
    for (size_t i = 0; i < n; i++) {
        const wcut_place item = {at, NULL, i, json_array_get(at->value, i)};
        element_filling to = {.of = d};
        to.placement.x.x = to.placement.y.y = 1;
        to.placement.column = (int)i;
        if (!wcut_read_object(
                reader, &item, free ? free_key : cell_key,
                free ? (int)(sizeof free_key / sizeof *free_key) : (int)(sizeof cell_key / sizeof *cell_key), &to))
            return false;
        if (!to.has_job && d->variants != 1)
            return wcut_refuse(reader, &item, WCUT_BAD_FORMAT, "\"job\" or \"variant\": there is no one job for all");
        d->placement[d->placements++] = to.placement;
    }
    return true;
}

/* ---- the design ---- */

/* a field's name, or a list of them, whose sum is meant */
static bool read_sum(wcut_reader *reader, const wcut_place *at, const wcut_describing *d, int *count, int *which) {
    if (json_is_string(at->value)) {
        *count = 1;
        return wcut_facade_field_locate(reader, at, d, which);
    }
    const size_t n = json_array_size(at->value);
    if (n < 1 || n > WCUT_FACADE_SUM_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "the name of a field, or 1 to %d names in a list",
                           WCUT_FACADE_SUM_MAX);
    for (size_t i = 0; i < n; i++) {
        const wcut_place item = {at, NULL, i, json_array_get(at->value, i)};
        if (!wcut_facade_field_locate(reader, &item, d, &which[(*count)++])) return false;
    }
    return true;
}

static bool read_heights(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_describing *d = into;
    return read_sum(reader, at, d, &d->heights, d->height);
}

static bool read_extras(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_describing *d = into;
    return read_sum(reader, at, d, &d->extras, d->extra);
}

static bool read_design_overrun(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_not_negative(reader, at, &((wcut_describing *)into)->plan.overrun);
}

static bool read_facade_design(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {{"height_mm", true, read_heights, 0},
                                        {"extra_length_mm", true, read_extras, 0},
                                        {"overrun_mm", false, read_design_overrun, 0}};
    return wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, into);
}

/* ---- the whole ---- */

static bool read_facade_format(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)into;
    return wcut_read_format(reader, at, FORMAT);
}

static bool read_facade_name(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_text(reader, at, &((wcut_describing *)into)->name);
}

static bool read_joint_width(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_not_negative(reader, at, &((wcut_describing *)into)->plan.joint);
}

static bool read_match(wcut_reader *reader, const wcut_place *at, void *into) {
    static const char *const word[] = {"none", "edge", "tangent", NULL};
    int found = 0;
    if (!wcut_read_word(reader, at, word, &found)) return false;
    ((wcut_describing *)into)->plan.match = (wcut_facade_match)found;
    return true;
}

static bool read_match_move(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_positive(reader, at, &((wcut_describing *)into)->plan.match_move);
}

/* what belongs together is there together */
static bool check_facade_parts(wcut_reader *reader, const wcut_place *at, const wcut_describing *d) {
    const wcut_place variants = wcut_place_member(at, "variants"), deal = wcut_place_member(at, "deal");
    const wcut_place job = wcut_place_member(at, "job"), design = wcut_place_member(at, "design");
    if (job.value && variants.value)
        return wcut_refuse(reader, &variants, WCUT_BAD_ARGUMENT, "one of \"job\" and \"variants\"");
    if (d->heights > 0 && !job.value)
        return wcut_refuse(reader, &design, WCUT_BAD_FORMAT,
                           "\"job\" beside it: the block, the wire and the process of every element");
    if (deal.value && !variants.value) return wcut_refuse(reader, &deal, WCUT_BAD_FORMAT, "\"variants\" to deal");
    if (deal.value && d->placement)
        return wcut_refuse(reader, &deal, WCUT_BAD_ARGUMENT, "one of \"deal\" and \"elements\"");
    if (d->placement) return true;
    if (d->plan.lattice == WCUT_FACADE_LATTICE_FREE || d->variants == 0 ||
        (variants.value && !deal.value && d->variants > 1)) {
        const wcut_place elements = wcut_place_member(at, "elements");
        return wcut_refuse(reader, &elements, WCUT_BAD_FORMAT,
                           "a list of elements, a \"job\" for all cells, or \"variants\" with a \"deal\"");
    }
    return true;
}

static bool read_description(wcut_reader *reader, const wcut_place *at, wcut_describing *d) {
    /* in this order: what names something comes behind it */
    static const wcut_field fields[] = {{"format", true, read_facade_format, 0},
                                        {"name", true, read_facade_name, 0},
                                        {"lattice", true, read_lattice, 0},
                                        {"joint_mm", false, read_joint_width, 0},
                                        {"match", false, read_match, 0},
                                        {"match_move_mm", false, read_match_move, 0},
                                        {"fields", false, wcut_facade_read_fields, 0},
                                        {"job", false, read_base_job, 0},
                                        {"variants", false, read_variants, 0},
                                        {"design", false, read_facade_design, 0},
                                        {"deal", false, read_deal, 0},
                                        {"elements", false, read_elements, 0}};
    const wcut_place format = wcut_place_member(at, "format");
    if (json_is_object(at->value) && !read_facade_format(reader, &format, NULL)) return false;
    if (!wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, d) || !check_facade_parts(reader, at, d))
        return false;
    const wcut_place deal = wcut_place_member(at, "deal");
    return d->placement || deal_cells(reader, &deal, d);
}

/* the plan's arrays from what was read, and the facade laid out */
static wcut_status lay_out_description(const wcut_describing *d, const char *label, wcut_facade **facade,
                                       wcut_error *error) {
    wcut_facade_field height[WCUT_FACADE_SUM_MAX], extra[WCUT_FACADE_SUM_MAX];
    const wcut_job **job = wcut_alloc((size_t)d->variants, sizeof *job);
    if (!job) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    for (int k = 0; k < d->variants; k++) job[k] = d->variant[k].job;
    for (int k = 0; k < d->heights; k++) height[k] = d->field[d->height[k]].field;
    for (int k = 0; k < d->extras; k++) extra[k] = d->field[d->extra[k]].field;

    /* a tenth of the block's height for kinks, where nothing is said */
    wcut_facade_plan p = d->plan;
    p.jobs = d->variants, p.job = job;
    p.heights = d->heights, p.height = height;
    p.extras = d->extras, p.extra = extra;
    p.placements = d->placements, p.placement = d->placement;
    if (!(p.match_move > 0)) p.match_move = job[0]->block_size.z / 10;
    wcut_error said = {.text = ""};
    char quoted[WCUT_QUOTE_SIZE];
    const wcut_status status = wcut_facade_create(&p, facade, &said);
    wcut_free(job);
    return status == WCUT_OK
               ? status
               : wcut_fail(error, status, "%s: %s", wcut_quote(quoted, label, WCUT_LABEL_MAX, 1), said.text);
}

/* what the description keeps of it */
static wcut_status keep_description(wcut_describing *d, wcut_facade *facade, wcut_facade_description **description,
                                    wcut_error *error) {
    wcut_facade_description *made = wcut_alloc(1, sizeof *made);
    bool room = made != NULL;
    if (room) {
        made->facade = facade;
        made->name = d->name, d->name = NULL;
        made->variant_name = wcut_alloc((size_t)d->variants, sizeof *made->variant_name);
        made->variant = wcut_alloc((size_t)d->placements, sizeof *made->variant);
        room = made->variant_name && made->variant;
    } else {
        wcut_facade_destroy(facade);
    }
    if (!room) {
        wcut_facade_description_destroy(made);
        return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    made->variants = d->variants;
    for (int k = 0; k < d->variants; k++) made->variant_name[k] = d->variant[k].name, d->variant[k].name = NULL;
    for (int k = 0; k < d->placements; k++) made->variant[k] = d->placement[k].job;
    *description = made;
    return WCUT_OK;
}

static void clear_describing(wcut_describing *d) {
    free(d->name);
    free(d->surface_path);
    wcut_surface_destroy(d->surface);
    for (int k = 0; k < d->fields; k++) {
        wcut_free(d->field[k].name);
        wcut_free(d->field[k].field.grid);
        wcut_free(d->field[k].field.place);
    }
    for (int k = 0; k < d->variants; k++) {
        free(d->variant[k].name);
        wcut_free(d->variant[k].path);
        wcut_job_destroy(d->variant[k].job);
    }
    wcut_free(d->field);
    wcut_free(d->variant);
    wcut_free(d->deal_value);
    wcut_free(d->placement);
}

wcut_status wcut_facade_parse(const char *text, size_t length, const char *label, const char *folder,
                              wcut_facade_description **description, wcut_error *error) {
    wcut_reader reader = {label, error, WCUT_OK};
    json_t *root = wcut_json_load(&reader, text, length);
    if (!root) return reader.status;
    const wcut_place at = {NULL, NULL, 0, root};
    wcut_describing d = {.folder = folder, .plan = {.match = WCUT_FACADE_MATCH_EDGE, .overrun = -1}};
    wcut_facade *facade = NULL;

    /* read, lay out, keep */
    wcut_status status = read_description(&reader, &at, &d) ? WCUT_OK : reader.status;
    json_decref(root);
    if (status == WCUT_OK) status = lay_out_description(&d, label, &facade, error);
    if (status == WCUT_OK) status = keep_description(&d, facade, description, error);
    clear_describing(&d);
    return status;
}

wcut_status wcut_facade_read(const char *path, wcut_facade_description **description, wcut_error *error) {
    if (!path || !description)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "wcut_facade_read: path or description is NULL");
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_file_read(path, WCUT_FACADE_BYTES_MAX, &text, &length, error);
    if (status != WCUT_OK) return status;

    /* its folder, with the slash */
    char *folder = wcut_path_join(path, wcut_folder_length(path), "");
    if (folder) {
        status = wcut_facade_parse(text, length, path, folder, description, error);
    } else {
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    wcut_free(folder);
    free(text);
    return status;
}

void wcut_facade_description_destroy(wcut_facade_description *description) {
    if (!description) return;
    for (int k = 0; k < description->variants && description->variant_name; k++) free(description->variant_name[k]);
    free(description->name);
    wcut_free(description->variant_name);
    wcut_free(description->variant);
    wcut_facade_destroy(description->facade);
    wcut_free(description);
}
