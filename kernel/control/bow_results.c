/* What users of a bow ask of a cut: bow of the wire, force on the tool, departure of the face from the ruled surface. */
#include <string.h>
#include <wirecut/bow.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "control/feed_chart.h"
#include "control/robot_limits.h"

/* ---- the ruled surface ---- */

/* closest point of a triangle (Ericson, Real-Time Collision Detection, 2005, 5.1.5) */
static wcut_vec3 closest_of_triangle(wcut_vec3 p, const wcut_vec3 t[3]) {
    const wcut_vec3 ab = vec3_sub(t[1], t[0]), ac = vec3_sub(t[2], t[0]);
    const wcut_vec3 ap = vec3_sub(p, t[0]), bp = vec3_sub(p, t[1]), cp = vec3_sub(p, t[2]);
    const double d1 = vec3_dot(ab, ap), d2 = vec3_dot(ac, ap), d3 = vec3_dot(ab, bp), d4 = vec3_dot(ac, bp),
                 d5 = vec3_dot(ab, cp), d6 = vec3_dot(ac, cp);

    /* corners */
    if (d1 <= 0 && d2 <= 0) return t[0];
    if (d3 >= 0 && d4 <= d3) return t[1];
    if (d6 >= 0 && d5 <= d6) return t[2];

    /* edges */
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return vec3_add_scaled(t[0], d1 / (d1 - d3), ab);
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return vec3_add_scaled(t[0], d2 / (d2 - d6), ac);
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return vec3_add_scaled(t[1], (d4 - d3) / (d4 - d3 + d5 - d6), vec3_sub(t[2], t[1]));

    /* inside */
    const double sum = va + vb + vc;
    return sum > 0 ? vec3_add_scaled(vec3_add_scaled(t[0], vb / sum, ab), vc / sum, ac) : t[0];
}

/* the mounts at station m; before station 0 the first step goes on backwards by `back` mm at m = -1 */
static void rule_at(const wcut_setup *setup, int m, double back, wcut_vec3 *a, wcut_vec3 *b) {
    const int at = m > 0 ? m : 0;
    *a = setup->end_a[at], *b = setup->end_b[at];
    if (m >= 0) return;
    const wcut_vec3 move_a = vec3_sub(setup->end_a[0], setup->end_a[1]),
                    move_b = vec3_sub(setup->end_b[0], setup->end_b[1]);
    const double scale = back / fmax(vec3_length(move_a), vec3_length(move_b));
    *a = vec3_add_scaled(*a, scale, move_a);
    *b = vec3_add_scaled(*b, scale, move_b);
}

/* Signed distance of p, a node of station j that trails by at most `bow`, from the ruled surface: the strips from j back
   until both mounts have gone twice as far, and the one ahead. */
static double departure_of(const wcut_setup *setup, int j, wcut_vec3 p, double bow) {
    double nearest = INFINITY, departure = 0, way = 0;
    for (int m = j + 1 < setup->stations ? j + 1 : j; m >= 0 && way <= 2 * bow + 1; m--) {
        /* a strip between two rulings, in two triangles */
        wcut_vec3 a, b, c, d;
        rule_at(setup, m - 1, 2 * bow + 1, &a, &b);
        rule_at(setup, m, 0, &c, &d);
        const wcut_vec3 half[2][3] = {{a, b, c}, {d, c, b}};
        for (int k = 0; k < 2; k++) {
            const wcut_vec3 off = vec3_sub(p, closest_of_triangle(p, half[k]));
            const double distance = vec3_length(off);
            if (!(distance < nearest)) continue;
            const wcut_vec3 normal =
                vec3_cross(vec3_sub(half[k][1], half[k][0]), vec3_sub(half[k][2], half[k][0])); /* x cross feed */
            nearest = distance;
            departure = vec3_dot(normal, off) < 0 ? -distance : distance;
        }
        if (m <= j) way += fmin(vec3_distance(a, c), vec3_distance(b, d)) + 1e-9 * bow;
    }
    return departure;
}

/* ---- a station ---- */

/* a vector of the block in the frame of a tool: turned back */
static wcut_vec3 in_tool(const wcut_pose *pose, wcut_vec3 v) {
    const wcut_pose back = {{0, 0, 0}, {pose->turn[0], -pose->turn[1], -pose->turn[2], -pose->turn[3]}};
    return wcut_pose_point(&back, v);
}

static void fill_bow_row(const wcut_setup *setup, const wcut_history *h, int j, wcut_bow_row *row) {
    const size_t n = (size_t)h->nodes, at = (size_t)j * n;
    const wcut_vec3 *x = h->position + at, *f = h->force + at;
    const wcut_vec3 along = vec3_unit(vec3_sub(x[n - 1], x[0]));
    const wcut_pose *tool = setup->job->tool ? &setup->job->tool[j] : NULL;
    const wcut_vec3 origin = tool ? tool->at : vec3_mix(setup->end_a[j], setup->end_b[j], 0.5);
    *row = (wcut_bow_row){.closing = setup->bow.distance - vec3_distance(x[0], x[n - 1]),
                          .tension = fmax(h->row[j].tension_a, h->row[j].tension_b)};

    /* the bow, and the sum of the foam's forces with their moment */
    for (size_t i = 0; i < n; i++) {
        const double off = vec3_length(vec3_cross(vec3_sub(x[i], x[0]), along));
        if (off > row->bow) row->bow = off, row->node = (int)i;
        row->force = vec3_add(row->force, f[i]);
        row->moment = vec3_add(row->moment, vec3_cross(vec3_sub(x[i], origin), f[i]));
    }
    if (!tool) return;
    row->force = in_tool(tool, row->force);
    row->moment = in_tool(tool, row->moment);
}

/* the departures of a station's nodes in the foam */
static void fill_departures(const wcut_setup *setup, const wcut_history *h, int j, wcut_bow_results *r) {
    const size_t n = (size_t)h->nodes;
    for (size_t i = 0; i < n; i++) {
        const size_t at = (size_t)j * n + i;
        r->departure[at] = NAN;
        if (!(h->force_line[at] > 0)) continue;
        const double d = departure_of(setup, j, h->position[at], r->row[j].bow);
        r->departure[at] = d;
        r->row[j].departure_max = fmax(r->row[j].departure_max, fabs(d));
        if (fabs(d) > fabs(r->departure_max.value)) r->departure_max = (wcut_bow_place){d, j, (int)i, h->position[at]};
    }
}

static void fill_bow_figures(const wcut_setup *setup, const wcut_history *h, wcut_bow_results *r) {
    int slack = 0;
    for (int j = 0; j < r->stations; j++) {
        wcut_bow_row *row = &r->row[j];
        fill_bow_row(setup, h, j, row);
        fill_departures(setup, h, j, r);

        /* extremes over the run */
        const size_t at = (size_t)j * (size_t)r->nodes + (size_t)row->node;
        if (row->bow > r->bow.value) r->bow = (wcut_bow_place){row->bow, j, row->node, h->position[at]};
        if (row->tension > r->tension_max) r->tension_max = row->tension, r->tension_station = j;
        r->force_max = fmax(r->force_max, vec3_length(row->force));
        r->moment_max = fmax(r->moment_max, vec3_length(row->moment));
        slack += !(row->tension > 0);
    }
    r->slack_share = (double)slack / r->stations;
}

/* ---- the whole ---- */

wcut_status wcut_bow_results_create(const wcut_setup *setup, const wcut_history *history,
                                    const wcut_robot_limits *limits, wcut_bow_results **results, wcut_error *error) {
    if (!setup || !history || !results || history->stations < 2 || history->stations > setup->stations ||
        history->nodes != setup->job->nodes)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "bow: a setup and its history of two stations are expected");
    if (!setup->bow.on)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "bow: found the rig %s, expected a bow",
                         wcut_rig_name(setup->job->rig.kind));
    const wcut_robot_limits l = limits ? *limits : wcut_robot_limits_default(setup->job);

    /* room for the rows and the map */
    const size_t stations = (size_t)history->stations, nodes = (size_t)history->nodes;
    wcut_bow_results *r = wcut_alloc(1, sizeof *r);
    if (r) r->row = wcut_alloc(stations, sizeof *r->row);
    if (r) r->departure = wcut_alloc(stations * nodes, sizeof *r->departure);
    if (!r || !r->row || !r->departure) {
        wcut_bow_results_destroy(r);
        return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a bow of %d stations", history->stations);
    }
    r->stations = history->stations, r->nodes = history->nodes;

    /* the chart is of the widest engagement; a run that met no foam has that of the block */
    double width = 0;
    for (size_t j = 0; j < stations; j++) width = fmax(width, history->row[j].engaged_length);
    if (!(width > 0)) width = setup->job->block_size.x;
    const double section = WCUT_PI / 4 * setup->job->wire_diameter * setup->job->wire_diameter;
    if (!wcut_limits_wire(setup->job, &l, &r->temperature, &r->strength) ||
        wcut_feed_chart_fill(setup, width, &l, r->chart) != WCUT_OK) {
        wcut_bow_results_destroy(r);
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "bow: limits out of range, or a wire beyond 3000 degC");
    }
    r->strength *= section;
    fill_bow_figures(setup, history, r);
    *results = r;
    return WCUT_OK;
}

void wcut_bow_results_destroy(wcut_bow_results *results) {
    if (!results) return;
    wcut_free(results->row);
    wcut_free(results->departure);
    wcut_free(results);
}
