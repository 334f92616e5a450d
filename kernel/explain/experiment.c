/* The next experiment (Hunter, Reiner 1965; Box, Hill 1967): of candidate cuts, predicted under both explanations, the
   one with the largest difference that no refit of the plain model takes away. */
#include "explain/experiment.h"

#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/least_squares.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"
#include "explain/identify.h"

/* Candidate, what is behind the job's name, and what it is for an operator. */
#define CANDIDATE_LIST(X)                                                     \
    X(AS_IT_IS, ", again", "the same cut once more")                          \
    X(DITHER, ", dithered speed", "a cut with a dithered speed")              \
    X(HEAT_STEPS, ", heater steps", "a cut with heater steps")                \
    X(BOTH, ", identification", "a cut with dithered speed and heater steps") \
    X(BACKWARDS, ", backwards", "the same path run backwards")                \
    X(NARROWER, ", narrower", "a block of three quarters of the width")       \
    X(COOLER, ", cooler", "the same cut with a fifth less heat")              \
    X(HOTTER, ", hotter", "the same cut with a quarter more heat")            \
    X(TIGHTER, ", tighter", "the same cut with a quarter more tension")       \
    X(COLD_ENTRY, ", cold entry", "a cut that enters with the heater at 85 %")

#define CANDIDATE_ENTRY(name, behind, words) name,
typedef enum candidate { CANDIDATE_LIST(CANDIDATE_ENTRY) CANDIDATES } candidate;
#undef CANDIDATE_ENTRY
#define CANDIDATE_BEHIND(name, behind, words) behind,
static const char *const behind_name[] = {CANDIDATE_LIST(CANDIDATE_BEHIND)};
#undef CANDIDATE_BEHIND
#define CANDIDATE_WORDS(name, behind, words) words,
static const char *const in_words[] = {CANDIDATE_LIST(CANDIDATE_WORDS)};
#undef CANDIDATE_WORDS

/* what both explanations are held against: the plain model and it with one number changed */
enum { PLAIN, WITH_A, WITH_B, OTHER_LAW_A, OTHER_LAW_B, LONGER, RUNS, COLUMNS = 5 };
#define WIDTH (COLUMNS + 1) /* of a row: what a refit can do, then the difference */
#define LAW_CHANGE 0.02     /* [1] of a and of b */
#define LENGTH_CHANGE 5e-4  /* [1] of the wire */

/* standard deviations; a sample every 0.2 s is worth less than an independent one, neighbours being alike */
#define NOISE_TENSION 0.02 /* [N] and 1 % of the reading */
#define NOISE_ANGLE (0.05 * WCUT_PI / 180)
#define NOISE_SCAN 0.15  /* [mm] */
#define SAMPLE_WORTH 0.4 /* [1] a correlation over 0.5 s */
#define SCAN_WORTH 50.0  /* independent points that a scan amounts to: registration and scanner err together */
#define SETTLE 2.0       /* [s] after the first contact, and ... */
#define LEAVE 1.0        /* [s] ... before the last: no model is good there, and no verdict should hang on it */
#define TOLD_APART 3.0   /* separation from which a cut tells two explanations apart */

/* prior standard deviations of what is refitted: ln a, ln b, length [1], kerf [mm], the strength of the explanation
   that is refitted [1]: it comes from cuts that left both possible */
static const double prior[COLUMNS] = {0.3, 0.3, 5e-3, 1, 0.3};

typedef struct trial {
    int count[2];
    const wcut_effect *effect[2];
    bool scan;       /* one of the explanations moves the face or the scan */
    wcut_vec3 block; /* [mm] of the candidate */
    wcut_schedule schedule;
    int first, last; /* samples of the schedule that count */
    wcut_predicted_cut run[RUNS];
    int side; /* the explanation that is taken for true; the other one is refitted */
    wcut_stop *stop;
    int rows, room;
    double *row; /* room x WIDTH, in standard deviations */
} trial;

/* ---- candidates ---- */

static void narrow(wcut_job *job) {
    const double less = job->block_size.x / 4;
    double chord = 0;
    int widest = 0;
    for (int j = 0; j < job->stations; j++) {
        const double c = vec3_distance(job->mount_a[j], job->mount_b[j]);
        if (c > chord) chord = c, widest = j;
    }
    for (int j = 0; j < job->stations; j++) job->mount_b[j].x -= less;
    job->block_size.x -= less;
    /* as much longer than its longest chord as before */
    job->wire_length *= vec3_distance(job->mount_a[widest], job->mount_b[widest]) / chord;
}

/* the heater at 85 % from the start until most of the wire is in the foam */
static bool enter_cold(wcut_job *job, const wcut_schedule *s) {
    int i = 0;
    while (i < s->count - 1 && s->engaged[i] < WCUT_MOST_OF_WIRE) i++;
    job->heat_step = wcut_alloc(1, sizeof *job->heat_step);
    if (!job->heat_step) return false;
    job->heat_step[0] = (wcut_heat_step){0, (i + 1) * WCUT_PREDICTED_CUT_STEP, 0.85};
    job->heat_step_count = 1;
    return true;
}

static void change(wcut_job *job, candidate which) {
    if (which == BACKWARDS) wcut_job_reverse(job);
    if (which == NARROWER) narrow(job);
    if (which == COOLER) job->heat *= 0.8;
    if (which == HOTTER) job->heat *= 1.25;
    if (which == TIGHTER) job->tension *= 1.25;
}

/* a candidate's job, and the schedule that it is led along */
static wcut_status make_candidate(candidate which, wcut_job *job, wcut_schedule *schedule, wcut_error *error) {
    change(job, which);
    if (!wcut_job_name(job, behind_name[which])) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a name");
    wcut_status status = wcut_schedule_create(job, schedule, error);
    if (status != WCUT_OK || (which != DITHER && which != HEAT_STEPS && which != BOTH && which != COLD_ENTRY))
        return status;
    wcut_random random = wcut_random_seed(1);
    if (which == COLD_ENTRY)
        status = enter_cold(job, schedule) ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory for a step");
    else
        status = wcut_programme_create(
            job, schedule,
            (which != HEAT_STEPS ? WCUT_PROGRAMME_SPEED : 0) | (which != DITHER ? WCUT_PROGRAMME_HEAT : 0), &random,
            error);
    if (status != WCUT_OK) return status;
    wcut_schedule_destroy(schedule);
    return wcut_schedule_create(job, schedule, error);
}

/* ---- runs ---- */

static bool add_job_effects(wcut_job *job, int count, const wcut_effect *effect) {
    const int all = job->effect_count + count;
    wcut_effect *list = wcut_alloc((size_t)all, sizeof *list);
    if (!list) return false;
    if (job->effect_count > 0) memcpy(list, job->effect, (size_t)job->effect_count * sizeof *list);
    if (count > 0) memcpy(list + job->effect_count, effect, (size_t)count * sizeof *list);
    wcut_free(job->effect);
    job->effect = list;
    job->effect_count = all;
    return true;
}

static wcut_status run_variant(trial *t, const wcut_job *candidate_job, int which, wcut_error *error) {
    wcut_job *job = wcut_job_copy(candidate_job);
    const int side = which == WITH_A ? 0 : 1;
    bool made = job != NULL;
    if (made && (which == WITH_A || which == WITH_B)) made = add_job_effects(job, t->count[side], t->effect[side]);
    wcut_status status = made ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory for a copy of a job");
    if (made && which == OTHER_LAW_A) job->force_law.a *= 1 + LAW_CHANGE;
    if (made && which == OTHER_LAW_B) job->force_law.b *= 1 + LAW_CHANGE;
    if (made && which == LONGER) job->wire_length *= 1 + LENGTH_CHANGE;
    if (made) status = wcut_predicted_cut_run(job, &t->schedule, t->stop, &t->run[which], error);
    wcut_job_destroy(job);
    return status;
}

/* ---- the difference ---- */

/* a row of the least squares: what changes with each number, and the difference, over the noise */
static void add_trial_row(trial *t, const double value[RUNS], bool scan, double noise) {
    if (t->rows == t->room) return; /* room was counted */
    double *row = t->row + (size_t)t->rows++ * WIDTH;
    row[0] = (value[OTHER_LAW_A] - value[PLAIN]) / LAW_CHANGE / noise;
    row[1] = (value[OTHER_LAW_B] - value[PLAIN]) / LAW_CHANGE / noise;
    row[2] = (value[LONGER] - value[PLAIN]) / LENGTH_CHANGE / noise;
    row[3] = scan ? 1 / noise : 0;
    const int refitted = t->side == 0 ? WITH_B : WITH_A;
    row[4] = (value[refitted] - value[PLAIN]) / noise;
    row[COLUMNS] = (value[WITH_A] - value[WITH_B]) / noise;
}

static bool is_counted(const trial *t, int i) {
    bool there = i >= t->first && i <= t->last;
    for (int k = 0; k < RUNS; k++) there = there && t->run[k].present[i];
    return there;
}

static void find_counted(trial *t) {
    const wcut_schedule *s = &t->schedule;
    t->first = 0, t->last = s->count - 1;
    while (t->first < t->last && !(s->engaged[t->first] > 0)) t->first++;
    while (t->last > t->first && !(s->engaged[t->last] > 0)) t->last--;
    t->first += (int)(SETTLE / WCUT_PREDICTED_CUT_STEP);
    t->last -= (int)(LEAVE / WCUT_PREDICTED_CUT_STEP);
}

static void add_recording(trial *t) {
    for (int i = 0; i < t->schedule.count; i++) {
        if (!is_counted(t, i)) continue;
        for (int c = WCUT_SENSED_TENSION_A; c < WCUT_SENSED_COUNT; c++) {
            double value[RUNS];
            for (int k = 0; k < RUNS; k++) value[k] = t->run[k].value[c][i];
            const double noise = c < WCUT_SENSED_ALPHA_A ? hypot(NOISE_TENSION, 0.01 * value[PLAIN]) : NOISE_ANGLE;
            add_trial_row(t, value, false, noise / sqrt(SAMPLE_WORTH));
        }
    }
}

/* the face's normal at a node, upwards; zero where the wire does not move */
static wcut_vec3 normal_at(const wcut_predicted_cut *r, int i, int node) {
    const wcut_vec3 *now = r->position + (size_t)i * (size_t)r->nodes, *before = now - r->nodes;
    const wcut_vec3 along = vec3_sub(now[node + 1], now[node - 1]), moved = vec3_sub(now[node], before[node]);
    const wcut_vec3 n = vec3_unit(vec3_cross(along, moved));
    return n.z < 0 ? vec3_scale(-1, n) : n;
}

/* where a node's point of the face is scanned under each model, along the plain face's normal [mm] */
static bool face_heights(const trial *t, int i, int node, double value[RUNS]) {
    const wcut_predicted_cut *plain = &t->run[PLAIN];
    const size_t at = (size_t)i * (size_t)plain->nodes + (size_t)node;
    const wcut_vec3 n = normal_at(plain, i, node);
    if (vec3_length(n) < 0.5 || plain->inside[at] < 0.99) return false;
    for (int k = 0; k < RUNS; k++) {
        wcut_vec3 p = t->run[k].position[at];
        if (!(t->run[k].speed[at] > 0)) return false;
        const double q_eff = wcut_q_eff_eval(t->schedule.heat[i], t->run[k].speed[at]);
        const int side = k == WITH_A ? 0 : 1;
        const bool with = k == WITH_A || k == WITH_B;
        if (with && wcut_face_eval(t->count[side], t->effect[side], t->block, 1, &n, &q_eff, &p) != WCUT_OK)
            return false;
        value[k] = vec3_dot(vec3_sub(p, plain->position[at]), n);
    }
    return true;
}

static void add_scan(trial *t) {
    const int first = t->rows, nodes = t->run[PLAIN].nodes;
    for (int i = 1; i < t->schedule.count; i += 2) {
        if (!is_counted(t, i) || !is_counted(t, i - 1)) continue;
        for (int node = 1; node < nodes - 1; node += 3) {
            double value[RUNS];
            if (face_heights(t, i, node, value)) add_trial_row(t, value, true, NOISE_SCAN);
        }
    }
    const double worth = sqrt(fmin(1, SCAN_WORTH / fmax(t->rows - first, 1)));
    for (int r = first; r < t->rows; r++)
        for (int c = 0; c <= COLUMNS; c++) t->row[(size_t)r * WIDTH + c] *= worth;
}

static void add_priors(trial *t) {
    for (int k = 0; k < COLUMNS; k++) {
        double *row = t->row + (size_t)t->rows++ * WIDTH;
        for (int c = 0; c <= COLUMNS; c++) row[c] = c == k ? 1 / prior[k] : 0;
    }
}

/* what is left of the difference after the best refit */
static wcut_status find_left(const trial *t, double *left) {
    const size_t m = (size_t)t->rows;

    /* split the rows into the columns of the plain model and the difference of the two explanations */
    double *a = wcut_alloc(m * COLUMNS, sizeof *a), *d = wcut_alloc(m, sizeof *d), x[COLUMNS];
    wcut_status status = a && d ? WCUT_OK : WCUT_NO_MEMORY;
    for (size_t i = 0; status == WCUT_OK && i < m; i++) {
        memcpy(a + i * COLUMNS, t->row + i * WIDTH, COLUMNS * sizeof *a);
        d[i] = t->row[i * WIDTH + COLUMNS];
    }

    /* least squares: the part of the difference that a refit takes away */
    if (status == WCUT_OK) status = wcut_qr_solve(t->rows, COLUMNS, a, d, x, NULL);

    /* norm of the rest */
    double sum = 0;
    for (size_t i = 0; status == WCUT_OK && i < m; i++) {
        const double *row = t->row + i * WIDTH;
        double r = row[COLUMNS];
        for (int c = 0; c < COLUMNS; c++) r -= row[c] * x[c];
        sum += r * r;
    }
    wcut_free(d);
    wcut_free(a);
    if (status == WCUT_OK) *left = sqrt(sum);

    return status;
}

/* of both ways round, one explanation true and the other refitted, the one that leaves less; the plain model has no
   strength that a refit could take to nothing */
static wcut_status find_min(trial *t, double *separation, wcut_error *error) {
    double min = HUGE_VAL;
    find_counted(t);
    for (t->side = 0; t->side < 2; t->side++) {
        if (t->count[t->side] == 0 && t->count[1 - t->side] > 0) continue;
        double left = 0;
        t->rows = 0;
        add_recording(t);
        if (t->scan) add_scan(t);
        add_priors(t);
        const wcut_status status = find_left(t, &left);
        if (status != WCUT_OK) return wcut_fail(error, status, "%s", wcut_status_text(status));
        min = fmin(min, left);
    }
    *separation = min;
    return WCUT_OK;
}

static void clear_trial(trial *t) {
    wcut_schedule_destroy(&t->schedule);
    for (int k = 0; k < RUNS; k++) wcut_predicted_cut_destroy(&t->run[k]);
    wcut_free(t->row);
    t->row = NULL;
    t->rows = 0;
}

static wcut_status measure_separation(trial *t, candidate which, wcut_job *job, double *separation, wcut_error *error) {
    wcut_status status = make_candidate(which, job, &t->schedule, error);
    t->block = job->block_size;
    for (int k = 0; k < RUNS && status == WCUT_OK; k++) status = run_variant(t, job, k, error);
    if (status == WCUT_OK) {
        t->room =
            t->schedule.count * (WCUT_SENSED_COUNT - WCUT_SENSED_TENSION_A + (t->scan ? WCUT_PREDICTED_CUT_NODES : 0));
        t->row = wcut_alloc((size_t)(t->room + COLUMNS) * WIDTH, sizeof *t->row);
        if (!t->row) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d samples", t->schedule.count);
    }
    if (status == WCUT_OK) status = find_min(t, separation, error);
    clear_trial(t);
    return status;
}

/* ---- the choice ---- */

static bool moves_face(int count, const wcut_effect *effect) {
    for (int e = 0; e < count; e++) {
        const wcut_effect_place place = wcut_effect_view(effect[e].kind)->place;
        if (place == WCUT_EFFECT_PLACE_FACE || place == WCUT_EFFECT_PLACE_SCAN) return true;
    }
    return false;
}

/* "wire thermal lag and tension drift" */
static void name_effects(int count, const wcut_effect *effect, char *text, size_t size) {
    size_t at = 0;
    snprintf(text, size, "the plain model");
    for (int e = 0; e < count && at + 1 < size; e++) {
        snprintf(text + at, size - at, "%s%s", e ? " and " : "", wcut_effect_view(effect[e].kind)->name);
        at = strlen(text);
    }
    for (char *c = text; *c; c++)
        if (*c == '_') *c = ' ';
}

static void tell_experiment(const trial *t, int tried, candidate best, double separation, double as_it_is,
                            char reason[WCUT_DIAGNOSIS_TEXT]) {
    char a[90], b[90];
    name_effects(t->count[0], t->effect[0], a, sizeof a);
    name_effects(t->count[1], t->effect[1], b, sizeof b);
    if (separation < TOLD_APART)
        snprintf(reason, WCUT_DIAGNOSIS_TEXT,
                 "None of %d predicted cuts separates %s from %s: at best %s%s, by %.1f standard deviations.", tried, a,
                 b, in_words[best], t->scan ? ", scanned" : "", separation);
    else
        snprintf(reason, WCUT_DIAGNOSIS_TEXT,
                 "Of %d predicted cuts, %s%s separates %s from %s best: by %.0f standard deviations, against %.0f "
                 "if the cut were made once more as it is.",
                 tried, in_words[best], t->scan ? ", scanned," : "", a, b, separation, as_it_is);
}

static wcut_status check_experiment(const wcut_job *job, int count_a, const wcut_effect *a, int count_b,
                                    const wcut_effect *b, bool places, wcut_error *error) {
    if (!job || !places || job->mode != WCUT_MODE_PATH)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a job with the mounts' path and places for the choice are expected");
    const wcut_status status = wcut_effects_check(count_a, a, error);
    return status == WCUT_OK ? wcut_effects_check(count_b, b, error) : status;
}

/* a copy without the job's own excitation */
static wcut_job *copy_plain(const wcut_job *job) {
    wcut_job *copy = wcut_job_copy(job);
    if (!copy) return NULL;
    wcut_free(copy->dither);
    wcut_free(copy->heat_step);
    copy->dither = NULL, copy->heat_step = NULL;
    copy->dither_count = copy->heat_step_count = 0;
    return copy;
}

wcut_status wcut_experiment_choose(const wcut_job *job, int count_a, const wcut_effect *a, int count_b,
                                   const wcut_effect *b, wcut_stop *stop, wcut_job **best, double *separation,
                                   char reason[WCUT_DIAGNOSIS_TEXT], wcut_error *error) {
    /* check, and whether either explanation moves the face, so that a scan would help */
    wcut_status status = check_experiment(job, count_a, a, count_b, b, best && separation && reason, error);
    if (status != WCUT_OK) return status;
    trial t = {.count = {count_a, count_b}, .effect = {a, b}, .stop = stop};
    t.scan = moves_face(count_a, a) || moves_face(count_b, b);

    /* candidates: the cut as it is, then variations of it */
    wcut_job *chosen = NULL;
    candidate choice = AS_IT_IS;
    double max = -1, as_it_is = 0;
    int tried = 0;
    for (int k = 0; k < CANDIDATES; k++) {
        wcut_job *made = copy_plain(job);
        double found = 0;

        /* the separation: difference of both predictions after the best refit */
        status = made ? measure_separation(&t, (candidate)k, made, &found, error)
                      : wcut_fail(error, WCUT_NO_MEMORY, "no memory for a copy of a job");

        /* a variation that cannot be cut is passed over; the cut as it is must succeed */
        if (status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED || (status != WCUT_OK && k == AS_IT_IS)) {
            wcut_job_destroy(made);
            break;
        }

        /* keep the best one so far */
        tried += status == WCUT_OK;
        if (k == AS_IT_IS) as_it_is = found;
        const bool better = status == WCUT_OK && found > max;
        status = WCUT_OK;
        wcut_job_destroy(better ? chosen : made);
        if (better) chosen = made, choice = (candidate)k, max = found;
    }
    if (status != WCUT_OK) {
        wcut_job_destroy(chosen);
        return status;
    }

    /* the reason in words, and the job handed over */
    tell_experiment(&t, tried, choice, max, as_it_is, reason);
    *best = chosen;
    *separation = max;

    return WCUT_OK;
}
