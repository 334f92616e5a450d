/* Scatter of a rig in the rows of the evidence: blocks of other density, wires cut by hand, zeros of sensors, friction in
   the heads, mounts beside their path. */
#include "explain/scatter.h"

#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/random.h"
#include "base/vec3.h"
#include "explain/model_fit.h"

/* knots of a face's misplacement along the path, each with a side of mount A and one of mount B */
enum { KNOTS = 6, WAVES = 6 };

/* [mm] misplacement of a mount and its shortest and longest wave, for the slow noise that it makes */
#define PATH_ERROR 0.3
#define SHORTEST_WAVE 100.0
#define LONGEST_WAVE 600.0
/* half width of the joint's play at which its column is taken [rad] */
#define PLAY (0.2 * WCUT_PI / 180)

/* ---- columns ---- */

static double *add_scatter_column(wcut_scatter *s, size_t rows, wcut_scatter_kind kind) {
    s->kind[s->count] = kind;
    return s->column + (size_t)s->count++ * rows;
}

/* levels of a and b and the wire's length: the recalibration's own columns, free in every cut */
static wcut_status add_levels(const wcut_evidence *e, wcut_scatter *s, wcut_error *error) {
    enum { MODELS = 4 };
    static const wcut_scatter_kind kind[] = {WCUT_SCATTER_LEVEL, WCUT_SCATTER_LEVEL_B, WCUT_SCATTER_LENGTH};
    const size_t rows = (size_t)e->rows;
    wcut_model model[MODELS] = {e->at, e->at, e->at, e->at};
    model[1].a *= exp(wcut_base_step[0]);
    model[2].b *= exp(wcut_base_step[1]);
    model[3].length_change += wcut_base_step[2];
    double *all = wcut_alloc(MODELS * rows, sizeof *all);
    if (!all) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", e->rows);
    const wcut_status status = wcut_models_rows(e, MODELS, model, all, error);
    for (size_t k = 0; status == WCUT_OK && k < MODELS - 1; k++) {
        double *column = add_scatter_column(s, rows, kind[k]);
        for (size_t i = 0; i < rows; i++) column[i] = (all[(k + 1) * rows + i] - all[i]) / wcut_base_step[k];
    }
    wcut_free(all);
    return status;
}

/* a sensor's zero in one signal */
static void add_zero(const wcut_evidence *e, wcut_scatter *s, int signal) {
    const double unit = signal < 2 ? 1 : WCUT_PI / 180;
    double *column =
        add_scatter_column(s, (size_t)e->rows, signal < 2 ? WCUT_SCATTER_TENSION_ZERO : WCUT_SCATTER_ENCODER_ZERO);
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int i = 0; i < c->bins; i++) column[c->row + signal * c->bins + i] = unit;
    }
}

/* what a joint with play shows of an angle, less the angle, per degree of its half width */
static void add_friction(const wcut_evidence *e, wcut_scatter *s, int signal) {
    double *column = add_scatter_column(s, (size_t)e->rows, WCUT_SCATTER_FRICTION);
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        double shown = (double)NAN;
        for (int i = 0; i < c->bins; i++) {
            const double angle = c->predicted[signal][i];
            if (!isfinite(angle)) continue;
            shown = isfinite(shown) ? clamp(shown, angle - PLAY, angle + PLAY) : angle;
            column[c->row + signal * c->bins + i] = (shown - angle) / PLAY * (WCUT_PI / 180);
        }
    }
}

/* a scanned face moved along its normal, smoothly along the path and linearly across it */
static void add_face_scatter(const wcut_evidence *e, wcut_scatter *s, int knot, bool side_b) {
    double *column = add_scatter_column(s, (size_t)e->rows, WCUT_SCATTER_FACE);
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int i = 0; i < c->patch.count; i++) {
            const double place = c->patch.station[i] / fmax(c->job->stations - 1, 1) * (KNOTS - 1);
            const double along = fmax(1 - fabs(place - knot), 0);
            const double across = side_b ? c->patch.across[i] : 1 - c->patch.across[i];
            column[c->row + WCUT_SIGNALS * c->bins + i] = along * across;
        }
    }
}

/* a scan's registration: a shift along an axis, or a turn about it through the block's middle */
static void add_registration(const wcut_evidence *e, wcut_scatter *s, int axis, bool turn) {
    double *column = add_scatter_column(s, (size_t)e->rows, turn ? WCUT_SCATTER_SCAN_TURN : WCUT_SCATTER_SCAN_SHIFT);
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int i = 0; i < c->patch.count; i++) {
            const wcut_vec3 middle = vec3_scale(0.5, c->job->block_size), n = c->patch.normal[i];
            const wcut_vec3 v = turn ? vec3_cross(vec3_sub(c->patch.point[i], middle), n) : n;
            const double part = axis == 0 ? v.x : axis == 1 ? v.y : v.z;
            column[c->row + WCUT_SIGNALS * c->bins + i] = part * (turn ? WCUT_PI / 180 : 1);
        }
    }
}

/* ---- misplaced mounts ---- */

/* a smooth random shift of every station, PATH_ERROR in each direction */
static void misplace(const wcut_job *job, const wcut_vec3 *mount, wcut_random *random, wcut_vec3 *out) {
    /* random wave numbers and phases: evenly drawn over the logarithm of the wavelength */
    double number[3][WAVES], phase[3][WAVES];
    for (int d = 0; d < 3; d++)
        for (int w = 0; w < WAVES; w++) {
            const double share = wcut_random_uniform(random);
            number[d][w] = 2 * WCUT_PI / (SHORTEST_WAVE * pow(LONGEST_WAVE / SHORTEST_WAVE, share));
            phase[d][w] = 2 * WCUT_PI * wcut_random_uniform(random);
        }

    /* waves of equal height over the way of the mount */
    double way = 0;
    for (int i = 0; i < job->stations; i++) {
        double shift[3] = {0};
        if (i > 0) way += vec3_distance(mount[i], mount[i - 1]);
        for (int d = 0; d < 3; d++)
            for (int w = 0; w < WAVES; w++)
                shift[d] += PATH_ERROR * sqrt(2.0 / WAVES) * sin(number[d][w] * way + phase[d][w]);
        out[i] = vec3_add(mount[i], (wcut_vec3){shift[0], shift[1], shift[2]});
    }
}

/* squares of what misplaced mounts change in a cut, by group, and how many bins they are of */
static wcut_status add_path_response(const wcut_evidence *e, int cut, double *square, int *count, wcut_error *error) {
    const wcut_evidence_cut *c = &e->cut[cut];

    /* the job of this cut, and room for its mounts misplaced */
    const size_t stations = (size_t)c->job->stations;
    wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
    wcut_job job = wcut_model_job(e, &e->at, cut, effect);
    wcut_random random = wcut_random_seed((unsigned)cut + 1);
    wcut_vec3 *mount = wcut_alloc(2 * stations, sizeof *mount);
    double *bins = wcut_alloc((size_t)2 * WCUT_SIGNALS * (size_t)c->bins, sizeof *bins);
    double *plain = bins ? bins + WCUT_SIGNALS * (size_t)c->bins : NULL;
    wcut_response d = {0};
    wcut_status status = mount && bins ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory for a path");

    /* the response along the same trajectory with both mounts misplaced */
    if (status == WCUT_OK) {
        misplace(c->job, c->job->mount_a, &random, mount);
        misplace(c->job, c->job->mount_b, &random, mount + stations);
        job.mount_a = mount, job.mount_b = mount + stations;
        status = wcut_response_run(&job, WCUT_NODES_COARSE, &c->exogenous, false, e->stop, &d, error);
    }

    /* the difference to the reference, squared and summed by group of channels */
    if (status == WCUT_OK) status = wcut_evidence_bin_exogenous(c, &e->at, &d, bins);
    if (status == WCUT_OK) status = wcut_evidence_bin_exogenous(c, &e->at, &c->reference, plain);
    for (int s = 0; status == WCUT_OK && s < WCUT_SIGNALS; s++)
        for (int i = 0; i < c->bins; i++) {
            const double change = bins[s * c->bins + i] - plain[s * c->bins + i];
            square[wcut_noise_group(s)] += change * change, count[wcut_noise_group(s)]++;
        }

    wcut_response_destroy(&d);
    wcut_free(bins);
    wcut_free(mount);
    return status;
}

/* a path so misplaced that no wire spans it says nothing: the response stays what the other cuts have */
static wcut_status find_path_response(wcut_evidence *e, wcut_error *error) {
    double square[WCUT_NOISE_GROUPS] = {0};
    int count[WCUT_NOISE_GROUPS] = {0};
    for (int k = 0; k < e->cuts; k++) {
        if (e->cut[k].bins == 0) continue;
        const wcut_status status = add_path_response(e, k, square, count, error);
        if (status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED) return status;
    }
    for (int g = 0; g < WCUT_NOISE_GROUPS; g++)
        e->path_response[g] = count[g] ? sqrt(square[g] / count[g]) / PATH_ERROR : 0;
    return WCUT_OK;
}

/* ---- creation ---- */

/* rows by which the evidence would differ with one length for all wires */
static bool keep_own_rows(wcut_evidence *e) {
    e->own_rows = wcut_alloc((size_t)e->rows, sizeof *e->own_rows);
    if (!e->own_rows) return false;
    for (int k = 0; k < e->scatter.count; k++) {
        if (e->scatter.kind[k] != WCUT_SCATTER_LENGTH) continue;
        for (int cut = 0; cut < e->cuts; cut++) {
            const wcut_evidence_cut *c = &e->cut[cut];
            const double *column = e->scatter.column + (size_t)k * (size_t)e->rows;
            for (int i = c->row; i < c->row + WCUT_SIGNALS * c->bins + c->patch.count; i++)
                e->own_rows[i] = c->own_length * column[i];
        }
    }

    return true;
}

/* whitened columns of the scatter */
static bool whiten_scatter(wcut_evidence *e) {
    double *missing = wcut_alloc((size_t)e->rows, sizeof *missing);
    if (!missing) return false;
    wcut_evidence_residual(e, missing);
    wcut_evidence_whiten_scatter(e, missing);
    wcut_free(missing);
    return true;
}

wcut_status wcut_scatter_take_lengths(wcut_evidence *e, const double *length, wcut_error *error) {
    const wcut_model at = e->at;
    for (int k = 0; k < e->cuts; k++) e->cut[k].own_length = length ? length[k] : 0;
    wcut_status status = wcut_evidence_predict(e, &at, true, error);
    if (status == WCUT_OK) status = wcut_scatter_create(e, error);
    if (status == WCUT_OK && !((!length || keep_own_rows(e)) && whiten_scatter(e)))
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", e->rows);
    return status;
}

wcut_status wcut_scatter_create(wcut_evidence *e, wcut_error *error) {
    const size_t room = (size_t)WCUT_SCATTER_COLUMNS_MAX * (size_t)e->rows;
    wcut_scatter s = {.column = wcut_alloc(room, sizeof *s.column), .white = wcut_alloc(room, sizeof *s.white)};
    if (!s.column || !s.white) wcut_scatter_destroy(&s);
    if (!s.column) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", e->rows);

    /* columns of level and length; the response to mounts beside their path */
    wcut_status status = add_levels(e, &s, error);
    if (status == WCUT_OK) status = find_path_response(e, error);
    if (status != WCUT_OK) {
        wcut_scatter_destroy(&s);
        return status;
    }

    /* zeros of all sensors, friction of the angles */
    for (int k = 0; k < WCUT_SIGNALS; k++) add_zero(e, &s, k);
    for (int k = 2; k < WCUT_SIGNALS; k++) add_friction(e, &s, k);

    /* of scans: the shape of the face, and the registration */
    bool scans = false;
    for (int k = 0; k < e->cuts; k++) scans = scans || e->cut[k].patch.count > 0;
    for (int k = 0; scans && k < 2 * KNOTS; k++) add_face_scatter(e, &s, k / 2, k % 2);
    for (int k = 0; scans && k < 6; k++) add_registration(e, &s, k % 3, k >= 3);
    wcut_scatter_destroy(&e->scatter);
    e->scatter = s;

    return WCUT_OK;
}
