/* Kerf by heat per area, and its spline: values at the knots' averages are its control points (Schoenberg 1967), so
   that it never leaves their range. */
#include "solid/kerf.h"

#include <limits.h>
#include <stdbool.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"

static const double W_MM_S_PER_J_M2 = 1000; /* Q [W/m] / v [mm/s] in J/m^2 */

wcut_status wcut_history_kerf(const wcut_job *job, const wcut_history *history, double *field) {
    if (!job || !history || !field || history->stations < 2 || history->nodes < 2 || !history->row || !history->speed ||
        !is_positive(job->heat) || !is_positive(job->speed_min) || !isfinite(job->kerf_width) || job->kerf_width < 0 ||
        !isfinite(job->kerf_per_q) || job->kerf_per_q < 0 ||
        !all_finite(history->stations * history->nodes, history->speed))
        return WCUT_BAD_ARGUMENT;
    for (int j = 0; j < history->stations; j++) {
        const int station = j > 0 ? j : 1;
        const double heat = wcut_job_heat_eval(job, history->row[station].time);
        for (int i = 0; i < history->nodes; i++) {
            const double speed = fmax(history->speed[(ptrdiff_t)station * history->nodes + i], job->speed_min);
            field[(ptrdiff_t)j * history->nodes + i] =
                job->kerf_width + job->kerf_per_q * W_MM_S_PER_J_M2 * heat / speed;
        }
    }
    return WCUT_OK;
}

static double knot_average(int degree, const double *knots, int k) {
    double sum = 0;
    for (int r = 1; r <= degree; r++) sum += knots[k + r];
    return sum / degree;
}

/* Greville's parameters of every control point, u over [0, 1] */
static void fill_parameters(const wcut_surface *s, double *uv) {
    const double first = s->knots_u[s->degree_u], wide = s->knots_u[s->count_u] - first;
    for (int j = 0; j < s->count_v; j++)
        for (int i = 0; i < s->count_u; i++) {
            double *to = uv + 2 * ((ptrdiff_t)j * s->count_u + i);
            to[0] = (knot_average(s->degree_u, s->knots_u, i) - first) / wide;
            to[1] = knot_average(s->degree_v, s->knots_v, j);
        }
}

/* the field's value for every control point; `min` and `max` of them */
static wcut_status sample_field(const wcut_surface *s, const wcut_mould_options *o, wcut_vec3 *control, double *min,
                                double *max) {
    const int count = s->count_u * s->count_v;
    wcut_mesh *at = NULL;
    wcut_status status = wcut_mesh_create(count, 0, WCUT_MESH_UV | WCUT_MESH_SCALAR, &at);
    if (status != WCUT_OK) return status;
    fill_parameters(s, at->uv);
    status = wcut_mesh_sample(at, o->kerf_stations, o->kerf_nodes, o->kerf_parameter, o->kerf_field);
    for (int k = 0; status == WCUT_OK && k < count; k++) {
        control[k] = vec3(0, 0, at->scalar[k]);
        *min = fmin(*min, at->scalar[k]);
        *max = fmax(*max, at->scalar[k]);
    }
    wcut_mesh_destroy(at);
    return status;
}

wcut_status wcut_kerf_width(const wcut_surface *surface, const wcut_mould_options *options, wcut_surface **width,
                            wcut_error *error) {
    /* one width everywhere */
    const int count = surface->count_u * surface->count_v;
    const bool given = options->thickness > 0;
    const double even = given ? options->thickness : options->kerf;
    double min = even, max = min;
    wcut_vec3 *control = wcut_alloc((size_t)count, sizeof *control);
    wcut_status status = control ? WCUT_OK : WCUT_NO_MEMORY;
    wcut_surface *made = NULL;
    for (int k = 0; status == WCUT_OK && k < count; k++) control[k] = vec3(0, 0, even);

    /* or a field of widths, as control points at the knots' averages */
    if (status == WCUT_OK && !given && options->kerf_stations > 0) {
        min = INFINITY, max = -INFINITY;
        status = sample_field(surface, options, control, &min, &max);
        if (status != WCUT_OK) wcut_fail(error, status, "kerf: the field does not fit its stations and nodes");
    }

    /* a kerf that is 0 in places would leave both halves joined there */
    if (status == WCUT_OK && (min < 0 || (max > 0 && !(min > 0))))
        status = wcut_fail(error, WCUT_BAD_ARGUMENT,
                           "kerf: found %.4g to %.4g mm, expected 0 everywhere or more than 0 everywhere", min, max);

    if (status == WCUT_OK && max > 0)
        status = wcut_surface_create(surface->degree_u, surface->degree_v, surface->count_u, surface->count_v,
                                     surface->knots_u, surface->knots_v, control, NULL, &made);
    if (status == WCUT_OK) *width = made;

    wcut_free(control);
    return status;
}
