/* facade.csv and facade.json: what came of every element and of every joint. */
#include <math.h>
#include <stdlib.h>
#include <wirecut/angle.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "io/facade/element.h"
#include "io/study/sweep.h"

/* the largest angle at an element's borders, and the largest step */
static void joints_of(const wcut_facade_results *r, int element, double *angle, double *step) {
    const wcut_facade_element *e = &r->description->facade->element[element];
    *angle = *step = NAN;
    for (int b = 0; b < 4; b++) {
        if (e->joint[b] < 0) continue;
        *angle = fmax(*angle, r->joint[e->joint[b]].angle_max);
        *step = fmax(*step, r->joint[e->joint[b]].step_max);
    }
}

static const char *verdict_of(const wcut_facade_item *item) {
    if (item->feasible) return "feasible";
    return item->state == WCUT_SWEEP_STATE_DONE ? "infeasible" : wcut_sweep_state_name(item->state);
}

/* ---- the table ---- */

/* a number, or an empty field */
static void put_cell(wcut_text *text, double value) {
    wcut_text_put(text, ",", 1);
    if (isfinite(value)) wcut_text_number(text, value);
}

static bool put_facade_csv(wcut_text *text, const void *context) {
    const wcut_facade_results *r = context;
    const wcut_facade *f = r->description->facade;
    wcut_text_put_word(
        text,
        "element,row,column,turn_deg,mirrored,variant,panel_half,distinct,hash,verdict,reason,duration_s,"
        "speed_min_mm_s,speed_max_mm_s,radius_min_mm,foam_lower_mm3,foam_upper_mm3,area_mm2,"
        "panel_mm3,panel_kg,moved_max_mm,joint_step_max_mm,joint_angle_max_deg\n");
    for (int k = 0; k < f->elements; k++) {
        const wcut_facade_element *e = &f->element[k];
        const wcut_facade_item *item = &r->item[k];
        double angle, step;
        joints_of(r, k, &angle, &step);

        /* where it is, and how it ended */
        wcut_text_print(text, "%d,%d,%d,%d,%d,", k, e->row, e->column, 90 * e->turn, e->mirrored);
        wcut_sweep_put_field(text, r->description->variant_name[r->description->variant[k]]);
        wcut_text_print(text, ",%s,%d,%s,%s,", e->mirrored ? "upper" : "lower", item->distinct, item->hash,
                        verdict_of(item));
        wcut_sweep_put_field(text, item->reason);

        /* its figures */
        const double number[] = {item->duration,
                                 item->speed_min,
                                 item->speed_max,
                                 item->radius_min,
                                 item->foam_lower,
                                 item->foam_upper,
                                 item->area,
                                 item->panel_volume,
                                 item->panel_mass,
                                 item->moved_max,
                                 step,
                                 angle * WCUT_DEG_PER_RAD};
        for (size_t i = 0; i < sizeof number / sizeof *number; i++) put_cell(text, number[i]);
        wcut_text_put(text, "\n", 1);
    }
    return !text->failed;
}

wcut_status wcut_facade_write_csv(const wcut_facade_results *results, const char *path, wcut_error *error) {
    if (!results || !path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    return wcut_text_write_file(path, put_facade_csv, results, error);
}

/* ---- the document ---- */

static void put_elements(wcut_text *text, const wcut_facade_results *r) {
    const wcut_facade *f = r->description->facade;
    wcut_text_put_word(text, ",\n  \"elements\": [");
    for (int k = 0; k < f->elements; k++) {
        const wcut_facade_element *e = &f->element[k];
        const wcut_facade_item *item = &r->item[k];
        wcut_text_print(text, "%s\n    {\"row\": %d, \"column\": %d, \"turn_deg\": %d, \"mirrored\": %s, \"variant\": ",
                        k ? "," : "", e->row, e->column, 90 * e->turn, e->mirrored ? "true" : "false");
        wcut_text_string(text, r->description->variant_name[r->description->variant[k]]);
        wcut_text_print(text,
                        ", \"panel_half\": \"%s\", \"distinct\": %d, \"folder\": \"cases/%.2s/%s\", \"state\": \"%s\", "
                        "\"feasible\": %s, \"reason\": ",
                        e->mirrored ? "upper" : "lower", item->distinct, item->hash, item->hash,
                        wcut_sweep_state_name(item->state), item->feasible ? "true" : "false");
        wcut_text_string(text, item->reason);

        /* the block's frame in the facade's */
        wcut_text_put_point(text, ",\n     \"origin_mm\": [", e->origin);
        wcut_text_put_point(text, ", \"x_axis\": [", e->x);
        wcut_text_put_point(text, ", \"y_axis\": [", e->y);
        wcut_text_put_point(text, ", \"z_axis\": [", e->z);
        wcut_text_put_number(text, ",\n     \"duration_s\": ", item->duration);
        wcut_text_put_number(text, ", \"speed_mm_s\": {\"min\": ", item->speed_min);
        wcut_text_put_number(text, ", \"max\": ", item->speed_max);
        wcut_text_put_number(text, "}, \"radius_min_mm\": ", item->radius_min);
        wcut_text_put_number(text, ", \"foam_mm3\": {\"lower\": ", item->foam_lower);
        wcut_text_put_number(text, ", \"upper\": ", item->foam_upper);
        wcut_text_put_number(text, "}, \"area_mm2\": ", item->area);
        wcut_text_put_number(text, ", \"moved_max_mm\": ", item->moved_max);
        wcut_text_put_number(text, ", \"panel_mm3\": ", item->panel_volume);
        wcut_text_put_number(text, ", \"panel_kg\": ", item->panel_mass);
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "]");
}

static void put_joints(wcut_text *text, const wcut_facade_results *r) {
    const wcut_facade *f = r->description->facade;
    wcut_text_put_word(text, ",\n  \"joints\": [");
    for (int j = 0; j < f->joints; j++) {
        const wcut_facade_joint *joint = &f->joint[j];
        const wcut_joint_report *report = &r->joint[j];
        wcut_text_print(text, "%s\n    {\"elements\": [%d, %d], \"borders\": [\"%s\", \"%s\"], \"reversed\": %s",
                        j ? "," : "", joint->element[0], joint->element[1], wcut_border_key[joint->border[0]],
                        wcut_border_key[joint->border[1]], joint->reversed ? "true" : "false");
        wcut_text_put_number(text, ", \"opening_mm\": {\"min\": ", joint->opening_min);
        wcut_text_put_number(text, ", \"max\": ", joint->opening_max);
        wcut_text_put_number(text, "}, \"gap_max_mm\": ", report->gap_max);
        wcut_text_put_number(text, ", \"step_max_mm\": ", report->step_max);
        wcut_text_put_number(text, ", \"angle_deg\": {\"min\": ", report->angle_min * WCUT_DEG_PER_RAD);
        wcut_text_put_number(text, ", \"median\": ", report->angle_median * WCUT_DEG_PER_RAD);
        wcut_text_put_number(text, ", \"max\": ", report->angle_max * WCUT_DEG_PER_RAD);
        wcut_text_put_word(text, "}}");
    }
    wcut_text_put_word(text, "]");
}

wcut_status wcut_facade_print(const wcut_facade_results *results, char **text) {
    static const char *const match[] = {"none", "edge", "tangent"};
    wcut_text out;
    if (!results || !text) return WCUT_BAD_ARGUMENT;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    const wcut_facade *f = results->description->facade;

    /* the whole: counts, sums, what is left at the joints */
    int feasible = 0;
    double duration = 0, mass = 0, gap = NAN, step = NAN, angle = NAN;
    for (int k = 0; k < f->elements; k++) {
        const wcut_facade_item *item = &results->item[k];
        feasible += item->feasible;
        if (isfinite(item->duration)) duration += item->duration;
        if (isfinite(item->panel_mass)) mass += item->panel_mass;
    }
    for (int j = 0; j < f->joints; j++) {
        gap = fmax(gap, results->joint[j].gap_max);
        step = fmax(step, results->joint[j].step_max);
        angle = fmax(angle, results->joint[j].angle_max);
    }
    wcut_text_put_string(&out, "{\n  \"format\": \"wirecut-facade-result/1\",\n  \"version\": ", wcut_version_text());
    wcut_text_put_string(&out, ",\n  \"name\": ", results->description->name);
    wcut_text_print(&out, ",\n  \"placements\": %d,\n  \"distinct\": %d,\n  \"feasible\": %d,\n  \"match\": \"%s\"",
                    f->elements, results->distinct, feasible, match[f->match]);
    wcut_text_put_number(&out, ",\n  \"height_moved_max_mm\": ", f->moved);
    wcut_text_put_number(&out, ",\n  \"duration_s\": ", duration);
    wcut_text_put_number(&out, ",\n  \"panels_kg\": ", mass);
    wcut_text_put_number(&out, ",\n  \"joint\": {\"gap_max_mm\": ", gap);
    wcut_text_put_number(&out, ", \"step_max_mm\": ", step);
    wcut_text_put_number(&out, ", \"angle_max_deg\": ", angle * WCUT_DEG_PER_RAD);
    wcut_text_put_word(&out, "}");

    /* each element, each joint */
    put_elements(&out, results);
    put_joints(&out, results);
    wcut_text_put_word(&out, "\n}\n");
    return wcut_text_finish(&out, text, NULL);
}
