/* Hostile calls of wire, foam, cut, control and explain. */
#include <wirecut/feasibility.h>

#include "hostile/sound.h"

enum { NODES = 11, TESTS = 12 };
static wcut_vec3 force[NODES], shape[NODES];
static double length[NODES], density[NODES];

/* a chain of 11 nodes over 400 mm, evenly loaded */
static bool give_chain(void) {
    for (int k = 0; k < NODES; k++) {
        force[k] = (wcut_vec3){0, 0.2, 0}, length[k] = 45, density[k] = 0.1;
        shape[k] = (wcut_vec3){40.0 * k, 0, 0};
    }
    return true;
}

/* a table of test cuts on the law 0.1 exp(-8.6e-4 q) */
static wcut_test_cut *test_cuts(void) {
    static wcut_test_cut cut[TESTS];
    for (int k = 0; k < TESTS; k++) {
        const double heat = 50 + 10 * (k % 3), speed = 5 + 2 * (k / 3), q = 1000 * heat / speed;
        const double line = 0.1 * exp(-8.6e-4 * q / 10) * (1 + 0.01 * sin(k));
        cut[k] = (wcut_test_cut){.heat = heat,
                                 .speed = speed,
                                 .engaged = 400,
                                 .tension_a = 200 * line / sin(0.5),
                                 .tension_b = 200 * line / sin(0.5),
                                 .alpha_a = 0.5,
                                 .alpha_b = 0.5,
                                 .weight = 1,
                                 .line = k + 2};
    }
    return cut;
}

static wcut_calibration *calibration(wcut_calibration_point *point) {
    static wcut_calibration c;
    static wcut_calibration_point all[TESTS];
    ck_assert_int_eq(wcut_calibration_fit(TESTS, test_cuts(), NULL, &c, all, NULL), WCUT_OK);
    if (point) memcpy(point, all, sizeof all);
    return &c;
}

static int stop_at_once(int station, int stations, void *context) {
    (void)station, (void)stations, (void)context;
    return 1;
}

static wcut_job *short_job_once(void) {
    static wcut_job *job;
    if (!job) job = short_job();
    return job;
}

/* a twelfth of the stations */
static wcut_job *coarse_job(void) {
    static wcut_job *job;
    if (job) return job;
    job = short_job();
    job->stations = 12;
    for (int j = 0; j < job->stations; j++) job->mount_a[j].y = job->mount_b[j].y = -20 + 60.0 * j;
    return job;
}

/* ---- wire ---- */

HOSTILE_VALUE(wcut_equilibrium_options_default, )
HOSTILE_VALUE(wcut_fdm_options_default, )

HOSTILE(wcut_equilibrium_solve) {
    const wcut_equilibrium_options o = wcut_equilibrium_options_default();
    wcut_equilibrium_report report = {.strain = 999};
    give_chain();
    EACH_HOSTILE_ARGUMENT(wcut_equilibrium_solve,
                          wcut_equilibrium_solve(COUNT(NODES), VALUES(force, NODES), VALUES(length, NODES - 1),
                                                 RECORD(&o), PTR(&shape[0]), PTR(&density[0]), OPT(&report)),
                          shape[5].y == 0 && density[5] == 0.1 && report.strain == 999,
                          (give_chain(), report.strain = 999));
}

HOSTILE(wcut_fdm_solve) {
    const wcut_fdm_options o = {.tolerance = 1e-6, .max_rounds = 10000};
    wcut_fdm_report report = {.strain = 999};
    give_chain();
    EACH_HOSTILE_ARGUMENT(wcut_fdm_solve,
                          wcut_fdm_solve(COUNT(NODES), VALUES(force, NODES), VALUES(length, NODES - 1), RECORD(&o),
                                         PTR(&density[0]), PTR(&shape[0]), OPT(&report)),
                          shape[5].y == 0 && density[5] == 0.1 && report.strain == 999,
                          (give_chain(), report.strain = 999));
}

/* ---- foam ---- */

HOSTILE_VALUE(wcut_calibration_options_default, )
HOSTILE_VALUE(wcut_q_eff_eval, ANY_NUM(60), ANY_NUM(10))
HOSTILE_VALUE(wcut_force_law_eval, &sound_job()->force_law, ANY_NUM(60), ANY_NUM(10))
HOSTILE_VALUE(wcut_tension_law_eval, &sound_job()->tension_law, ANY_NUM(60), ANY_NUM(10))
HOSTILE_OUT(wcut_force_law_speed, double, RECORD(&sound_job()->force_law), NUM(60), NUM(0.01))
static const wcut_tension_law tension_law = {0.02, 4e-4, 0};
HOSTILE_OUT(wcut_tension_law_speed, double, RECORD(&tension_law), NUM(60), NUM(0.005))
HOSTILE_VALUE(wcut_test_cut_force, &test_cuts()[0])
HOSTILE_VALUE(wcut_test_cut_tension, &test_cuts()[0])
HOSTILE_VALUE(wcut_test_cut_destroy, NULL)
HOSTILE_ARRAY(wcut_gaussian_scores, double, TESTS, COUNT(TESTS), VALUES((double *)test_cuts(), TESTS))

HOSTILE(wcut_calibration_slips) {
    const wcut_calibration_options o = wcut_calibration_options_default();
    int count;
    wcut_slip slip[TESTS];
    hostile_fill(&count, sizeof count), hostile_fill(slip, sizeof slip);
    EACH_HOSTILE_ARGUMENT(wcut_calibration_slips,
                          wcut_calibration_slips(COUNT(TESTS), PTR(test_cuts()), RECORD(&o), PTR(&count), PTR(&slip[0]),
                                                 OPT((wcut_error *)NULL)),
                          hostile_is_filled(&count, sizeof count) && hostile_is_filled(slip, sizeof slip),
                          (hostile_fill(&count, sizeof count), hostile_fill(slip, sizeof slip)));
}

HOSTILE(wcut_recording_check) {
    int count;
    wcut_doubt doubt[WCUT_DOUBTS_MAX];
    hostile_fill(&count, sizeof count), hostile_fill(doubt, sizeof doubt);
    EACH_HOSTILE_ARGUMENT(wcut_recording_check,
                          wcut_recording_check(PTR(sound_job()), PTR(sound_recording()), PTR(&count), PTR(&doubt[0])),
                          hostile_is_filled(&count, sizeof count) && hostile_is_filled(doubt, sizeof doubt),
                          (hostile_fill(&count, sizeof count), hostile_fill(doubt, sizeof doubt)));
}

HOSTILE(wcut_calibration_fit) {
    const wcut_calibration_options o = wcut_calibration_options_default();
    wcut_calibration c;
    wcut_calibration_point point[TESTS];
    hostile_fill(&c, sizeof c), hostile_fill(point, sizeof point);
    EACH_HOSTILE_ARGUMENT(
        wcut_calibration_fit,
        wcut_calibration_fit(COUNT(TESTS), PTR(test_cuts()), RECORD(&o), PTR(&c), OPT(&point[0]), OPT(NULL)),
        hostile_is_filled(&c, sizeof c) && hostile_is_filled(point, sizeof point),
        (hostile_fill(&c, sizeof c), hostile_fill(point, sizeof point)));
}

HOSTILE(wcut_law_fit_eval) {
    const double q[3] = {4000, 6000, 8000};
    double fitted[3], low[3], high[3];
    hostile_fill(fitted, sizeof fitted), hostile_fill(low, sizeof low), hostile_fill(high, sizeof high);
    EACH_HOSTILE_ARGUMENT(wcut_law_fit_eval,
                          wcut_law_fit_eval(PTR(&calibration(NULL)->force), NUM(0.95), COUNT(3), VALUES(q, 3),
                                            OPT(&fitted[0]), OPT(&low[0]), OPT(&high[0])),
                          hostile_is_filled(fitted, sizeof fitted) && hostile_is_filled(low, sizeof low),
                          (hostile_fill(fitted, sizeof fitted), hostile_fill(low, sizeof low)));
}

/* ---- effects ---- */

HOSTILE_VALUE(wcut_effect_view, ANY_ENUM(WCUT_EFFECT_WIRE_THERMAL_LAG))
HOSTILE_VALUE(wcut_effect_default, ANY_ENUM(WCUT_EFFECT_WIRE_THERMAL_LAG))
HOSTILE_VALUE(wcut_effect_choose, ANY_ENUM(WCUT_EFFECT_WIRE_THERMAL_LAG), ANY_INT(0))
HOSTILE_OUT(wcut_effect_locate, wcut_effect_kind, PTR("wire_thermal_lag"))

static wcut_effect *lag(void) {
    static wcut_effect e;
    e = wcut_effect_default(WCUT_EFFECT_WIRE_THERMAL_LAG);
    e.value[0] = 0.4;
    return &e;
}

HOSTILE_VALUE(wcut_effect_parameters, lag())
HOSTILE_VALUE(wcut_effect_is_neutral, lag())
HOSTILE_STATUS(wcut_effects_check, COUNT(1), RECORD(lag()), OPT(NULL))

HOSTILE(wcut_sensors_eval) {
    static double time[3] = {0, 1, 2}, value[WCUT_SENSED_COUNT][3];
    static const unsigned char present[3] = {1, 1, 1};
    double *all[WCUT_SENSED_COUNT];
    for (int k = 0; k < WCUT_SENSED_COUNT; k++) all[k] = value[k];
    wcut_effect e = wcut_effect_default(WCUT_EFFECT_CLOCK_OFFSET);
    e.value[0] = 0.1;
    EACH_HOSTILE_ARGUMENT(
        wcut_sensors_eval,
        wcut_sensors_eval(COUNT(1), RECORD(&e), COUNT(3), VALUES(time, 3), OPT(&present[0]), PTR(&all[0])),
        value[0][0] == 0, (void)0);
}

HOSTILE(wcut_face_eval) {
    wcut_effect e = wcut_effect_default(WCUT_EFFECT_KERF_GROWTH);
    e.value[0] = 1e-4;
    const wcut_vec3 normal[2] = {{0, 0, 1}, {0, 0, 1}};
    const double q[2] = {5000, 6000};
    wcut_vec3 point[2] = {{1, 2, 3}, {4, 5, 6}};
    EACH_HOSTILE_ARGUMENT(wcut_face_eval,
                          wcut_face_eval(COUNT(1), RECORD(&e), VEC(sound_job()->block_size), COUNT(2),
                                         VALUES(normal, 2), VALUES(q, 2), PTR(&point[0])),
                          point[0].x == 1 && point[1].y == 5,
                          (point[0] = (wcut_vec3){1, 2, 3}, point[1] = (wcut_vec3){4, 5, 6}));
}

/* ---- cuts ---- */

static const wcut_pose *sound_pose(void) {
    static const wcut_pose pose = {{1, 2, 3}, {0.6, 0.8, 0, 0}};
    return &pose;
}

static const wcut_feed *sound_feed(void) {
    static double speed[] = {5, 6};
    static const wcut_feed feed = {WCUT_FEED_KIND_STATIONS, 2, speed, NULL};
    return &feed;
}

/* a bow and its run; made once, freed with the process */
static wcut_setup *bow_setup(void) {
    static wcut_setup *setup;
    if (setup) return setup;
    wcut_job *job = coarse_job();
    static double feed[] = {20};
    const wcut_rig rig = job->rig;
    job->rig =
        (wcut_rig){.kind = WCUT_RIG_KIND_BOW, .pretension = 8, .stiffness = 8, .wire_stiffness = 3500, .expansion = 0};
    job->feed = (wcut_feed){WCUT_FEED_KIND_CONSTANT, 1, feed, NULL};
    wcut_setup_create(job, NULL, &setup, NULL);
    job->rig = rig;
    job->feed = (wcut_feed){WCUT_FEED_KIND_NONE, 0, NULL, NULL};
    return setup;
}

static wcut_history *bow_history(void) {
    static wcut_history *h;
    if (!h) wcut_setup_run(bow_setup(), NULL, NULL, &h, NULL);
    return h;
}

/* a job with one pose; made once, freed with the process */
static wcut_job *tool_job_once(void) {
    static wcut_job *job;
    if (job || wcut_job_create(&job) != WCUT_OK) return job;
    job->stations = 1;
    job->tool = wcut_alloc(1, sizeof *job->tool);
    if (job->tool) job->tool[0] = *sound_pose();
    return job;
}

HOSTILE_VALUE(wcut_cut_options_default, )
HOSTILE_VALUE(wcut_phase_name, ANY_ENUM(WCUT_PHASE_ENTRY))
HOSTILE_VALUE(wcut_condition_name, ANY_ENUM(WCUT_CONDITION_TENSION))
HOSTILE_MADE(wcut_job_create, wcut_job, wcut_job_destroy, PTR(&made))
HOSTILE_VALUE(wcut_job_destroy, NULL)
HOSTILE_VALUE(wcut_job_heat_eval, sound_job(), ANY_NUM(3))
HOSTILE_VALUE(wcut_job_pace_eval, sound_job(), ANY_NUM(3))
HOSTILE_STATUS(wcut_job_resample, PTR(short_job_once()), INT(81))
HOSTILE_STATUS(wcut_job_place_mounts, PTR(tool_job_once()), OPT(NULL))
HOSTILE_VALUE(wcut_pose_point, sound_pose(), (wcut_vec3){1, 2, 3})
HOSTILE_VALUE(wcut_feed_chart_bows, )
HOSTILE_VALUE(wcut_bow_results_destroy, NULL)
HOSTILE_VALUE(wcut_bow_file_name, ANY_ENUM(WCUT_BOW_FILE_MAP))

HOSTILE(wcut_bow_results_create) {
    const wcut_robot_limits limits = wcut_robot_limits_default(sound_job());
    wcut_bow_results *made = MARK;
    EACH_HOSTILE_ARGUMENT(
        wcut_bow_results_create,
        wcut_bow_results_create(PTR(bow_setup()), PTR(bow_history()), RECORD(&limits), PTR(&made), OPT(NULL)),
        made == MARK, (wcut_bow_results_destroy(made), made = MARK));
}

static wcut_bow_results *bow_results(void) {
    static wcut_bow_results *r;
    if (!r) wcut_bow_results_create(bow_setup(), bow_history(), NULL, &r, NULL);
    return r;
}

HOSTILE_FILE(wcut_bow_results_write, PTR(bow_results()), PTR(bow_history()), ENUM(WCUT_BOW_FILE_STATIONS),
             PTR(OUT_FILE), OPT(NULL))
HOSTILE_VALUE(wcut_rig_name, ANY_ENUM(WCUT_RIG_KIND_BOW))
HOSTILE_VALUE(wcut_wire_material_view, OPT("NiCr"))
HOSTILE_OUT(wcut_feed_eval, double, PTR(sound_feed()), INT(1), NUM(2.0), NUM(3.0))
static wcut_correction *correction(void) {
    static wcut_correction c;
    c = (wcut_correction){.a = 0.05, .b = 6e-4, .length_change = 0.1, .kerf = 1, .effects = 1};
    c.effect[0] = *lag();
    return &c;
}

HOSTILE_STATUS(wcut_correction_apply, RECORD(correction()), PTR(short_job_once()), OPT(NULL))
HOSTILE_VALUE(wcut_setup_destroy, NULL)
HOSTILE_VALUE(wcut_setup_job, sound_setup())
HOSTILE_VALUE(wcut_setup_options, sound_setup())
HOSTILE_VALUE(wcut_setup_stations, sound_setup())
HOSTILE_MADE(wcut_setup_path_job, wcut_job, wcut_job_destroy, PTR(sound_setup()), PTR(&made))
HOSTILE_MADE(wcut_cut_create, wcut_cut, wcut_cut_destroy, PTR(sound_setup()), PTR(&made), OPT(NULL))
HOSTILE_VALUE(wcut_cut_destroy, NULL)
HOSTILE_VALUE(wcut_history_destroy, NULL)
HOSTILE_VALUE(wcut_prediction_destroy, NULL)
HOSTILE_VALUE(wcut_comparison_destroy, NULL)
HOSTILE_VALUE(wcut_recording_destroy, NULL)
HOSTILE_VALUE(wcut_recording_has_force, OPT(sound_recording()))
HOSTILE_STATUS(wcut_recording_place, PTR(sound_job()), PTR(sound_recording()), OPT((wcut_error *)NULL))
HOSTILE_MADE(wcut_setup_run, wcut_history, wcut_history_destroy, PTR(sound_setup()), NULL, NULL, PTR(&made), OPT(NULL))
HOSTILE_OUT(wcut_summary_eval, wcut_summary, PTR(sound_history()))
HOSTILE_VALUE(wcut_replay_options_default, )
HOSTILE_VALUE(wcut_comparison_options_default, )
HOSTILE_MADE(wcut_prediction_plan, wcut_prediction, wcut_prediction_destroy, PTR(sound_history()),
             PTR(sound_recording()), PTR(&made), OPT(NULL))

HOSTILE(wcut_setup_create) {
    const wcut_cut_options o = wcut_cut_options_default();
    wcut_setup *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_setup_create,
                          wcut_setup_create(PTR(sound_job()), RECORD_WORDS(&o, 0, 3), PTR(&made), OPT(NULL)),
                          made == MARK, (wcut_setup_destroy(made), made = MARK));
}

static wcut_cut *cut_once(void) {
    static wcut_cut *cut;
    if (!cut) ck_assert_int_eq(wcut_cut_create(sound_setup(), &cut, NULL), WCUT_OK);
    return cut;
}

HOSTILE_STATUS(wcut_cut_step, PTR(cut_once()), OPT(NULL))
HOSTILE_STATUS(wcut_cut_drive, PTR(cut_once()), VEC(sound_job()->mount_a[1]), VEC(sound_job()->mount_b[1]), NUM(0.1),
               NUM(65), OPT(NULL))

HOSTILE(wcut_cut_view) {
    wcut_station station;
    wcut_cut_view(cut_once(), &station);
    ck_assert_int_eq(station.nodes, sound_job()->nodes);
}

static wcut_vec3 *ways(void) {
    static wcut_vec3 *way;
    double of_wire;
    const size_t n = (size_t)sound_job()->stations;
    if (!way) {
        way = calloc(2 * n, sizeof *way);
        ck_assert_int_eq(wcut_history_path(sound_setup(), sound_history(), way, way + n, &of_wire, NULL), WCUT_OK);
    }
    return way;
}

HOSTILE(wcut_feasibility_eval) {
    const int n = sound_job()->stations;
    wcut_feasibility verdict = {.station = 999};
    EACH_HOSTILE_ARGUMENT(
        wcut_feasibility_eval,
        wcut_feasibility_eval(PTR(sound_job()), PTR(sound_history()), PTR(ways()), PTR(ways() + n),
                              OPT((const wcut_robot_limits *)NULL), PTR(&verdict), OPT((double *)NULL)),
        verdict.station == 999, verdict.station = 999);
}

HOSTILE_VALUE(wcut_feasibility_name, ANY_ENUM(WCUT_FEASIBILITY_VERDICT_FEASIBLE))

HOSTILE(wcut_history_path) {
    const int n = sound_job()->stations;
    wcut_vec3 *a = calloc((size_t)n, sizeof *a), *b = calloc((size_t)n, sizeof *b);
    double length_of_all = 999;
    EACH_HOSTILE_ARGUMENT(
        wcut_history_path,
        wcut_history_path(PTR(sound_setup()), PTR(sound_history()), PTR(a), PTR(b), OPT(&length_of_all), OPT(NULL)),
        a[1].x == 0 && b[1].x == 0 && length_of_all == 999,
        (memset(a, 0, (size_t)n * sizeof *a), memset(b, 0, (size_t)n * sizeof *b), length_of_all = 999));
    free(a);
    free(b);
}

HOSTILE(wcut_history_excite) {
    wcut_history_row row[3] = {{.time = 0}, {.time = 1, .speed_a = 20}, {.time = 2, .speed_a = 20}};
    wcut_history few = {.stations = 3, .row = row};
    EACH_HOSTILE_ARGUMENT(wcut_history_excite, wcut_history_excite(PTR(sound_job()), PTR(&few), OPT(NULL)),
                          row[2].time == 2, row[2].time = 2);
}

HOSTILE(wcut_history_kerf) {
    const size_t n = (size_t)sound_history()->stations * (size_t)sound_history()->nodes;
    double *field = calloc(n, sizeof *field);
    EACH_HOSTILE_ARGUMENT(wcut_history_kerf, wcut_history_kerf(PTR(sound_job()), PTR(sound_history()), PTR(field)),
                          field[n / 2] == 0, memset(field, 0, n * sizeof *field));
    free(field);
}

HOSTILE(wcut_prediction_replay) {
    const wcut_replay_options o = wcut_replay_options_default();
    wcut_prediction *made = MARK;
    EACH_HOSTILE_ARGUMENT(
        wcut_prediction_replay,
        wcut_prediction_replay(PTR(sound_setup()), PTR(sound_recording()), RECORD(&o), PTR(&made), OPT(NULL)),
        made == MARK, (wcut_prediction_destroy(made), made = MARK));
}

HOSTILE(wcut_comparison_create) {
    wcut_comparison_options o = wcut_comparison_options_default();
    o.settle = o.leave = 0;
    wcut_comparison *made = MARK;
    EACH_HOSTILE_ARGUMENT(
        wcut_comparison_create,
        wcut_comparison_create(PTR(sound_job()), PTR(long_recording()), RECORD(&o), PTR(&made), OPT(NULL)),
        made == MARK, (wcut_comparison_destroy(made), made = MARK));
}

HOSTILE(wcut_comparison_run) {
    wcut_comparison_options o = wcut_comparison_options_default();
    o.settle = o.leave = 0;
    const wcut_job *const job[1] = {sound_job()};
    const wcut_recording *const recording[1] = {long_recording()};
    wcut_comparison *made[1] = {MARK};
    wcut_error error[1];
    EACH_HOSTILE_ARGUMENT(wcut_comparison_run,
                          wcut_comparison_run(COUNT(1), PTR(&job[0]), PTR(&recording[0]), RECORD(&o), NULL, NULL,
                                              PTR(&made[0]), PTR(&error[0])),
                          made[0] == MARK, (wcut_comparison_destroy(made[0]), made[0] = MARK));
}

/* ---- scores ---- */

HOSTILE_VALUE(wcut_scored_name, ANY_ENUM(WCUT_SCORED_TENSION))
HOSTILE_VALUE(wcut_scored_unit, ANY_ENUM(WCUT_SCORED_TENSION))
HOSTILE_VALUE(wcut_part_name, ANY_ENUM(WCUT_PART_ENTRY))
HOSTILE_OUT(wcut_score_eval, wcut_score, COUNT(3), VALUES(((double[3]){1, 2, 3}), 3),
            VALUES(((double[3]){1, 2.1, 3}), 3), NUM(2))

HOSTILE(wcut_score_mean) {
    wcut_score score[2], mean;
    const double x[3] = {1, 2, 4}, y[3] = {1, 2.1, 3.9};
    ck_assert_int_eq(wcut_score_eval(3, x, y, 3, &score[0]), WCUT_OK);
    score[1] = score[0];
    hostile_fill(&mean, sizeof mean);
    EACH_HOSTILE_ARGUMENT(wcut_score_mean, wcut_score_mean(COUNT(2), PTR(&score[0]), PTR(&mean)),
                          hostile_is_filled(&mean, sizeof mean), hostile_fill(&mean, sizeof mean));
}

HOSTILE(wcut_scores_mean) {
    wcut_comparison_options o = wcut_comparison_options_default();
    o.settle = o.leave = 0;
    wcut_comparison *c = NULL;
    ck_assert_int_eq(wcut_comparison_create(sound_job(), long_recording(), &o, &c, NULL), WCUT_OK);
    const wcut_comparison *const all[2] = {c, c};
    static wcut_scores planned, replayed;
    hostile_fill(&planned, sizeof planned), hostile_fill(&replayed, sizeof replayed);
    EACH_HOSTILE_ARGUMENT(wcut_scores_mean, wcut_scores_mean(COUNT(2), PTR(&all[0]), PTR(&planned), PTR(&replayed)),
                          hostile_is_filled(&planned, sizeof planned) && hostile_is_filled(&replayed, sizeof replayed),
                          (hostile_fill(&planned, sizeof planned), hostile_fill(&replayed, sizeof replayed)));
    wcut_comparison_destroy(c);
}

/* ---- control ---- */

HOSTILE_VALUE(wcut_control_settings_default, sound_job())
HOSTILE_VALUE(wcut_control_state_name, ANY_ENUM(WCUT_CONTROL_STATE_RUN))
HOSTILE_VALUE(wcut_control_destroy, NULL)
HOSTILE_VALUE(wcut_rig_options_default, sound_job())
HOSTILE_VALUE(wcut_rig_run_destroy, NULL)

HOSTILE(wcut_control_create) {
    const wcut_control_settings s = wcut_control_settings_default(sound_job());
    wcut_control *made = MARK;
    EACH_HOSTILE_ARGUMENT(
        wcut_control_create,
        wcut_control_create(RECORD_WORDS(&s, 1, (int)sizeof s / 8), PTR(sound_history()), PTR(&made), OPT(NULL)),
        made == MARK, (wcut_control_destroy(made), made = MARK));
}

static wcut_control *control_once(void) {
    static wcut_control *c;
    const wcut_control_settings s = wcut_control_settings_default(sound_job());
    if (!c) ck_assert_int_eq(wcut_control_create(&s, sound_history(), &c, NULL), WCUT_OK);
    return c;
}

/* what sensors read may be anything */
HOSTILE_OUT(wcut_control_step, double, PTR(control_once()), ANY_NUM(0.1), ANY_NUM(1), ANY_NUM(2), ANY_NUM(2))

HOSTILE(wcut_control_look) {
    wcut_control_view view;
    wcut_control_look(control_once(), &view);
    ck_assert(isfinite(view.speed));
}

HOSTILE(wcut_rig_run_create) {
    const wcut_control_settings s = wcut_control_settings_default(sound_job());
    wcut_rig_options o = wcut_rig_options_default(sound_job());
    wcut_rig_run *made = MARK;
    EACH_HOSTILE_ARGUMENT(
        wcut_rig_run_create,
        wcut_rig_run_create(PTR(sound_job()), PTR(sound_history()), RECORD_WORDS(&s, 1, (int)sizeof s / 8),
                            RECORD_WORDS(&o, 0, (int)sizeof o / 8 - 3), stop_at_once, NULL, PTR(&made), OPT(NULL)),
        made == MARK, (made == MARK ? (void)0 : wcut_rig_run_destroy(made), made = MARK));
}

/* ---- diagnosis ---- */

HOSTILE_VALUE(wcut_diagnosis_options_default, )
HOSTILE_VALUE(wcut_diagnosis_destroy, NULL)
HOSTILE_VALUE(wcut_verdict_name, ANY_ENUM((wcut_verdict_kind)0))
HOSTILE_VALUE(wcut_evidence_name, ANY_ENUM(WCUT_EVIDENCE_CHANNEL_SPEED))
HOSTILE_VALUE(wcut_evidence_unit, ANY_ENUM(WCUT_EVIDENCE_CHANNEL_SPEED))
HOSTILE_VALUE(wcut_scatter_name, ANY_ENUM(WCUT_SCATTER_LEVEL))
HOSTILE_VALUE(wcut_rig_prior_default, )
HOSTILE_VALUE(wcut_contradiction_name, ANY_ENUM(WCUT_CONTRADICTION_STATION))

HOSTILE(wcut_diagnosis_create) {
    const wcut_diagnosis_options o = wcut_diagnosis_options_default();
    const wcut_diagnosis_cut cut = {.job = sound_job(), .recording = long_recording()};
    wcut_diagnosis *made = MARK;
    EACH_HOSTILE_ARGUMENT(wcut_diagnosis_create,
                          wcut_diagnosis_create(COUNT(1), PTR(&cut), COUNT(0), OPT(NULL), OPT(&o), stop_at_once, NULL,
                                                PTR(&made), OPT(NULL)),
                          made == MARK, (made == MARK ? (void)0 : wcut_diagnosis_destroy(made), made = MARK));
}

HOSTILE_MADE(wcut_identification_create, wcut_job, wcut_job_destroy, PTR(coarse_job()), INT(1), 1, PTR(&made),
             OPT(NULL))
