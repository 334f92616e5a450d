/* diagnosis.json: every key that FORMATS.md names, numbers as they are, nothing where there is nothing. */
#include <float.h>
#include <jansson.h>
#include <unistd.h>

#include <wirecut/diagnosis_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/process/correction.h"
#include "io/process/diagnosis_given.h"
#include "test.h"

static given_diagnosis given;

static json_t *printed(void) {
    char *text = NULL;
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, "c\"07\"", &text), WCUT_OK);
    ck_assert_int_eq(text[strlen(text) - 1], '\n');
    json_error_t error;
    json_t *root = json_loads(text, JSON_REJECT_DUPLICATES, &error);
    ck_assert_msg(root != NULL, "line %d: %s", error.line, error.text);
    free(text);
    return root;
}

/* a value by its path: keys, and numbers for places in lists */
static const json_t *at(const json_t *value, const char *path) {
    char part[80];
    for (const char *p = path; *p; p += *p == '.') {
        const size_t length = strcspn(p, ".");
        ck_assert_uint_lt(length, sizeof part);
        memcpy(part, p, length);
        part[length] = 0;
        value = json_is_array(value) ? json_array_get(value, (size_t)atoi(part)) : json_object_get(value, part);
        p += length;
    }
    ck_assert_msg(value != NULL, "no %s", path);
    return value;
}

static double number(const json_t *root, const char *path) {
    ck_assert_msg(json_is_number(at(root, path)), "%s is no number", path);
    return json_number_value(at(root, path));
}

static const char *string(const json_t *root, const char *path) {
    ck_assert_msg(json_is_string(at(root, path)), "%s is no text", path);
    return json_string_value(at(root, path));
}

TEST(a_correction_comes_back_as_it_was_and_a_withheld_one_says_why) {
    wcut_correction c = {.a = 999};
    wcut_error error = {0};
    give_diagnosis(&given);
    ck_assert_int_eq(wcut_diagnosis_write(&given.d, "c07", "d.json", &error), WCUT_OK);
    ck_assert_int_eq(wcut_correction_read("d.json", &c, &error), WCUT_OK);
    ck_assert(c.a == 0.09 && c.b == 8e-4 && c.length_change == 0.2 && c.kerf == 1.1 && c.kerf_per_q == 1e-4);
    ck_assert_int_eq(c.effects, 1);
    ck_assert_int_eq(c.effect[0].kind, WCUT_EFFECT_WIRE_THERMAL_LAG);
    ck_assert_double_eq(c.effect[0].value[0], 0.8);
    given.d.correction.kerf = NAN;
    ck_assert_int_eq(wcut_diagnosis_write(&given.d, "c07", "d.json", &error), WCUT_OK);
    ck_assert_int_eq(wcut_correction_read("d.json", &c, &error), WCUT_OK);
    ck_assert(isnan(c.kerf));

    /* withheld, of another format, not there */
    snprintf(given.d.withheld, sizeof given.d.withheld, "nothing was modelled");
    ck_assert_int_eq(wcut_diagnosis_write(&given.d, "c07", "d.json", &error), WCUT_OK);
    c.a = 999;
    ck_assert_int_eq(wcut_correction_read("d.json", &c, &error), WCUT_BAD_ARGUMENT);
    ck_assert_str_eq(error.text, "d.json: it withholds its correction: nothing was modelled");
    ck_assert_int_eq(wcut_correction_parse("{\"format\": \"wirecut-job/1\"}", 27, "x", &c, &error), WCUT_BAD_FORMAT);
    ck_assert_int_eq(wcut_correction_parse("{\"format\": \"wirecut-diagnosis/1\"}", 33, "x", &c, &error),
                     WCUT_BAD_FORMAT);
    ck_assert_int_eq(wcut_correction_read("missing.json", &c, &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_correction_read(NULL, &c, &error), WCUT_BAD_ARGUMENT);
    ck_assert_double_eq(c.a, 999);
    unlink("d.json");
}

TEST(what_was_modelled_is_there_with_its_equation_and_events) {
    give_diagnosis(&given);
    given.d.kind = WCUT_VERDICT_UNKNOWN;
    wcut_modelled *m = &given.d.modelled;
    m->terms = 1;
    m->term[0] = (wcut_found_effect){.effect = wcut_effect_choose(WCUT_EFFECT_EMPIRICAL_FORCE, 4), .present = true};
    m->term[0].effect.value[0] = 0.3;
    snprintf(m->equation, sizeof m->equation, "F = a exp(-b Q_eff) (1 + 0.3 sin(2 pi y / 70 mm))");
    m->rivals = 1;
    snprintf(m->rival[0], sizeof m->rival[0], "t / 100 s");
    m->events = 1;
    m->event[0] = (wcut_event){1, {12, 17}, {40, 60}, 0.8, 0.5, -0.2};
    m->recalibrated = 0.5, m->after = 0.1;
    json_t *root = printed();
    ck_assert_str_eq(string(root, "modelled.terms.0.parameters.term"), "wave_y");
    ck_assert_double_eq(number(root, "modelled.terms.0.parameters.coefficient.value"), 0.3);
    ck_assert_str_eq(string(root, "modelled.equation"), m->equation);
    ck_assert_str_eq(string(root, "modelled.alternatives.0"), "t / 100 s");
    ck_assert_double_eq(number(root, "modelled.improvement.tension_N.after"), given.d.held_out_score[2][1].rmsd);
    ck_assert_double_eq(number(root, "modelled.improvement.tension_N_with_events.recalibrated"), 0.5);
    ck_assert_double_eq(number(root, "modelled.events.0.time_s.1"), 17);
    json_decref(root);
}

TEST(what_is_too_small_to_matter_is_there_with_what_it_moves) {
    give_diagnosis(&given);
    given.d.small_effects = 1;
    given.d.small_effect = (wcut_small_effect){given.d.effect[0], 170, 0.012, NAN};
    json_t *root = printed();
    ck_assert_uint_eq(json_array_size(at(root, "small_effects")), 1);
    ck_assert_str_eq(string(root, "small_effects.0.effect.name"), "wire_thermal_lag");
    ck_assert_double_eq(number(root, "small_effects.0.effect.parameters.time_constant_s.value"), 0.8);
    ck_assert_double_eq(number(root, "small_effects.0.gain"), 170);
    ck_assert_double_eq(number(root, "small_effects.0.moves_tension_N"), 0.012);
    ck_assert(json_is_null(at(root, "small_effects.0.moves_face_mm")));
    json_decref(root);

    /* a count of what there is no place for, and an effect that is none */
    char *text = NULL;
    given.d.small_effects = 2;
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, "c07", &text), WCUT_BAD_ARGUMENT);
    given.d.small_effects = 1, given.d.small_effect.found.effect.choice = 7;
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, "c07", &text), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(text);
}

TEST(every_key_of_the_format_is_there_with_its_value) {
    give_diagnosis(&given);
    json_t *root = printed();
    ck_assert_str_eq(string(root, "format"), "wirecut-diagnosis/1");
    ck_assert_str_eq(string(root, "case"), "c\"07\"");
    ck_assert_str_eq(string(root, "verdict.kind"), "physics");
    ck_assert_uint_eq(json_array_size(at(root, "verdict.effects")), 1);
    ck_assert_uint_eq(json_array_size(at(root, "small_effects")), 0);
    ck_assert_str_eq(string(root, "verdict.effects.0"), "wire_thermal_lag");
    ck_assert_double_eq(number(root, "verdict.confidence"), 0.93);
    ck_assert_double_eq(number(root, "verdict.confidence_by"), 0.5);
    ck_assert_str_eq(string(root, "verdict.alternatives.0.name"), "scan_offset");
    ck_assert_double_eq(number(root, "verdict.alternatives.0.confidence"), 0.05);
    ck_assert_str_eq(string(root, "verdict.sentence"), given.d.sentence);
    ck_assert(json_is_true(at(root, "effects.0.present")) && json_is_false(at(root, "effects.1.present")));
    ck_assert_double_eq(number(root, "effects.0.parameters.time_constant_s.value"), 0.8);
    ck_assert_double_eq(number(root, "effects.0.parameters.time_constant_s.ci95.0"), 0.7);
    ck_assert_double_eq(number(root, "effects.0.parameters.time_constant_s.ci95.1"), 0.9);
    ck_assert_int_eq((int)number(root, "mismatch.0.cut"), 1);
    ck_assert_str_eq(string(root, "mismatch.0.channel"), "alpha_a_deg");
    ck_assert_double_eq(number(root, "mismatch.0.time_s.1"), 19.5);
    ck_assert_double_eq(number(root, "mismatch.0.station.0"), 30);
    ck_assert(json_is_null(at(root, "mismatch.0.wire_mm")));
    ck_assert_double_eq(number(root, "mismatch.0.block_mm.1.2"), 300);
    ck_assert_double_eq(number(root, "mismatch.0.share_of_misfit"), 0.41);
    ck_assert_double_eq(number(root, "mismatch.0.p_value"), 1e-6);
    ck_assert_double_eq(number(root, "mismatch.1.wire_mm.1"), 90);
    ck_assert(json_is_null(at(root, "mismatch.1.block_mm")));
    ck_assert_double_eq(number(root, "fit.before.speed.rmsd"), 1);
    ck_assert_double_eq(number(root, "fit.recalibrated.tension.nrmsd"), 0.06);
    ck_assert_double_eq(number(root, "fit.after.beta.rmse_over_range"), 0.04);
    ck_assert_int_eq((int)number(root, "fit.held_out_cuts.0"), 2);
    ck_assert_double_eq(number(root, "fit.held_out.after.scan.rmsd"), 0.5);
    ck_assert(json_is_null(at(root, "next_experiment")));
    json_decref(root);
}

TEST(what_was_weighed_is_there_too) {
    give_diagnosis(&given);
    json_t *root = printed();
    ck_assert_double_eq(number(root, "recalibrated.a_N_per_mm.value"), 0.09);
    ck_assert_double_eq(number(root, "recalibrated.a_N_per_mm.job"), 0.1);
    ck_assert(json_is_null(at(root, "recalibrated.kerf_mm.value")));
    ck_assert_str_eq(string(root, "ranking.1.set_aside"), "explains less");
    ck_assert_uint_eq(json_array_size(at(root, "ranking.2.effects")), 0);
    ck_assert_str_eq(string(root, "limits.1"), given.limit[1]);
    ck_assert_str_eq(string(root, "dependences.0.quantity"), "ln speed");
    ck_assert_double_eq(number(root, "adequacy.p_value"), 0.4);
    ck_assert(json_is_null(at(root, "noise.scan")));
    ck_assert_str_eq(string(root, "naive.which"), "clock_offset");
    ck_assert_double_eq(number(root, "fit.black_box.tension.rmsd"), 0.4);
    ck_assert_ptr_null(json_object_get(at(root, "fit.black_box"), "scan"));
    json_decref(root);
}

TEST(choices_are_words_points_are_lists_and_open_ends_are_the_parameters_own) {
    give_diagnosis(&given);
    given.d.effects = 4;
    given.d.effect[2] = given_effect(WCUT_EFFECT_ANGLE_OFFSET, true, 0.5);
    given.d.effect[2].effect.choice = 2;
    given.d.effect[3] = given_effect(WCUT_EFFECT_MOUNT_COMPLIANCE, true, 0.5);
    given.d.effect[3].effect.value[0] = 3;
    given.d.effect[3].parameter[0] = (wcut_estimate){3, 2, INFINITY};
    given.d.effect[3].estimated[0] = true;
    json_t *root = printed();
    ck_assert_str_eq(string(root, "effects.2.parameters.channel"), "alpha_b_deg");
    ck_assert(json_is_null(at(root, "effects.2.parameters.offset_deg.ci95")));
    ck_assert_double_eq(number(root, "effects.1.parameters.shift_mm.value.2"), 2);
    ck_assert_double_eq(number(root, "effects.1.parameters.shift_mm.ci95.2.1"), 2.5);
    ck_assert_double_eq(number(root, "effects.1.parameters.shift_mm.ci95.0.0"), -1000);
    ck_assert_double_eq(number(root, "effects.3.parameters.stiffness_N_per_mm.ci95.1"), DBL_MAX);
    ck_assert_str_eq(string(root, "effects.3.parameters.stiffness_N_per_mm.open"), "high");
    json_decref(root);
}

TEST(verdicts_that_name_nothing_hold_no_effects_and_all_their_alternatives) {
    static const wcut_verdict_kind kind[] = {WCUT_VERDICT_NONE, WCUT_VERDICT_AMBIGUOUS, WCUT_VERDICT_UNKNOWN};
    for (int k = 0; k < 3; k++) {
        give_diagnosis(&given);
        given.d.kind = kind[k];
        json_t *root = printed();
        ck_assert_uint_eq(json_array_size(at(root, "verdict.effects")), 0);
        ck_assert_uint_eq(json_array_size(at(root, "verdict.alternatives")), 2);
        json_decref(root);
    }
}

TEST(an_empty_diagnosis_and_one_cut_short_are_whole_files) {
    memset(&given, 0, sizeof given);
    given.d.interrupted = true;
    json_t *root = printed();
    ck_assert(json_is_true(at(root, "interrupted")));
    ck_assert_str_eq(string(root, "verdict.kind"), "none");
    ck_assert(json_is_null(at(root, "naive")));
    ck_assert_uint_eq(json_object_size(at(root, "fit.after")), 0);
    ck_assert_uint_eq(json_array_size(at(root, "fit.held_out_cuts")), 0);
    json_decref(root);
}

TEST(the_next_experiment_is_named_with_its_reason) {
    give_diagnosis(&given);
    wcut_job job = {.name = (char *)"wider"};
    given.d.next_experiment = &job;
    snprintf(given.d.next_reason, sizeof given.d.next_reason, "tells both apart");
    json_t *root = printed();
    ck_assert_str_eq(string(root, "next_experiment.job"), "next-experiment.json");
    ck_assert_str_eq(string(root, "next_experiment.name"), "wider");
    ck_assert_str_eq(string(root, "next_experiment.reason"), "tells both apart");
    json_decref(root);
}

TEST(what_is_no_diagnosis_is_refused_and_nothing_is_written) {
    wcut_error error = {0};
    char *text = (char *)"999";
    give_diagnosis(&given);
    ck_assert_int_eq(wcut_diagnosis_print(NULL, "c", &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, NULL, &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, "c", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_diagnosis_write(&given.d, "c", NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_diagnosis_write(&given.d, "c", "no/such/folder/d.json", &error), WCUT_NOT_WRITTEN);
    given.d.effect[1].effect.choice = 1;
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, "c", &text), WCUT_BAD_ARGUMENT);
    give_diagnosis(&given);
    given.d.kind = WCUT_VERDICT_COUNT;
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, "c", &text), WCUT_BAD_ARGUMENT);
    give_diagnosis(&given);
    given.d.mismatch = NULL;
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, "c", &text), WCUT_BAD_ARGUMENT);
    give_diagnosis(&given);
    given.hypothesis[1].count = 3;
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, "c", &text), WCUT_BAD_ARGUMENT);
    ck_assert_str_eq(text, "999");
}

TEST(wherever_memory_ends_nothing_is_written) {
    give_diagnosis(&given);
    char *text = NULL;
    EACH_FAILED_ALLOCATION(wcut_diagnosis_print(&given.d, "c", &text), !text);
    free(text);
}

TEST(a_file_holds_what_is_printed) {
    char path[] = "diagnosis-XXXXXX", read[20000], *text = NULL;
    give_diagnosis(&given);
    const int file = mkstemp(path);
    ck_assert_int_ge(file, 0);
    close(file);
    wcut_error error = {0};
    ck_assert_msg(wcut_diagnosis_write(&given.d, "c", path, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(wcut_diagnosis_print(&given.d, "c", &text), WCUT_OK);
    FILE *in = fopen(path, "r");
    ck_assert_ptr_nonnull(in);
    const size_t size = fread(read, 1, sizeof read - 1, in);
    read[size] = 0;
    fclose(in);
    unlink(path);
    ck_assert_str_eq(read, text);
    free(text);
}

TEST(verdicts_and_channels_have_names_and_what_is_none_has_none) {
    ck_assert_str_eq(wcut_verdict_name(WCUT_VERDICT_AMBIGUOUS), "ambiguous");
    ck_assert_str_eq(wcut_verdict_name(WCUT_VERDICT_COUNT), "");
    ck_assert_str_eq(wcut_evidence_name(WCUT_EVIDENCE_CHANNEL_BETA), "beta");
    ck_assert_str_eq(wcut_evidence_unit(WCUT_EVIDENCE_CHANNEL_SCAN), "mm");
    ck_assert_str_eq(wcut_evidence_name(WCUT_EVIDENCE_CHANNEL_COUNT), "");
    ck_assert_str_eq(wcut_evidence_unit((wcut_evidence_channel)-1), "");
    ck_assert_str_eq(wcut_scatter_name(WCUT_SCATTER_LENGTH), "wire_length_mm");
    ck_assert_str_eq(wcut_scatter_name((wcut_scatter_kind)-1), "");
    ck_assert_str_eq(wcut_contradiction_name(WCUT_CONTRADICTION_HEATER), "heater_power");
    ck_assert_str_eq(wcut_contradiction_name((wcut_contradiction_kind)-1), "");
}

TEST(a_form_that_is_not_told_is_said) {
    give_diagnosis(&given);
    json_t *root = printed();
    ck_assert(json_is_true(json_object_get(json_object_get(root, "verdict"), "form_told")));
    json_decref(root);
    given.d.form_open = true;
    root = printed();
    ck_assert(json_is_false(json_object_get(json_object_get(root, "verdict"), "form_told")));
    json_decref(root);
}

TEST(a_contradiction_is_there_and_an_instrument_s_fault_is_in_the_verdict) {
    give_diagnosis(&given);
    json_t *root = printed();
    ck_assert_str_eq(string(root, "contradictions.0.name"), "excitation_not_followed");
    ck_assert_str_eq(string(root, "contradictions.0.column"), "speed_command_mm_s");
    ck_assert_double_eq(number(root, "contradictions.0.cuts.0"), 1);
    ck_assert_double_eq(number(root, "contradictions.0.standard_error"), 0.005);
    ck_assert_str_eq(string(root, "contradictions.0.sentence"), given.d.contradiction[0].text);
    json_t *effects = json_object_get(json_object_get(root, "verdict"), "effects");
    ck_assert_uint_eq(json_array_size(effects), 1); /* the job's mistake is no effect */
    json_decref(root);

    /* a fault is named once, however many contradictions show it */
    static wcut_contradiction both[2];
    both[0] = both[1] = given.d.contradiction[0];
    for (int k = 0; k < 2; k++) both[k].kind = WCUT_CONTRADICTION_STATION, both[k].fault = true;
    given.d.contradictions = 2, given.d.contradiction = both;
    root = printed();
    effects = json_object_get(json_object_get(root, "verdict"), "effects");
    ck_assert_uint_eq(json_array_size(effects), 2);
    ck_assert_str_eq(string(root, "verdict.effects.1"), "station_scale");
    json_decref(root);
}

/* ---- the example of FORMATS.md ---- */

/* the block "```json diagnosis.json" of the document */
static json_t *example(void) {
    static char text[1 << 18];
    FILE *file = fopen(WCUT_SOURCE_DIR "/kernel/FORMATS.md", "r");
    ck_assert_ptr_nonnull(file);
    const size_t length = fread(text, 1, sizeof text - 1, file);
    fclose(file);
    ck_assert_uint_lt(length, sizeof text - 1);
    text[length] = 0;

    static const char begin[] = "```json diagnosis.json\n";
    char *from = strstr(text, begin);
    ck_assert_ptr_nonnull(from);
    from += sizeof begin - 1;
    char *end = strstr(from, "\n```");
    ck_assert_ptr_nonnull(end);
    *end = 0;

    json_error_t error;
    json_t *root = json_loads(from, JSON_REJECT_DUPLICATES, &error);
    ck_assert_msg(root != NULL, "FORMATS.md, diagnosis.json, line %d: %s", error.line, error.text);
    return root;
}

/* every key of the example is written, at the same place; the first item stands for a list */
static void compare_keys(json_t *shown, json_t *written, const char *key) {
    const char *name;
    json_t *value;
    if (json_is_null(shown) || json_is_null(written)) return;
    if (json_is_array(shown) && json_array_size(shown) > 0 && json_array_size(written) > 0)
        compare_keys(json_array_get(shown, 0), json_array_get(written, 0), key);
    if (!json_is_object(shown)) return;
    ck_assert_msg(json_is_object(written), "\"%s\" is an object in FORMATS.md, but not in what is written", key);
    json_object_foreach(shown, name, value) {
        json_t *same = json_object_get(written, name);
        ck_assert_msg(same != NULL, "\"%s\" in \"%s\" is in the example of FORMATS.md, but not written", name, key);
        compare_keys(value, same, name);
    }
}

TEST(the_example_of_the_format_has_the_keys_that_are_written) {
    const char *name;
    json_t *value;
    give_diagnosis(&given);
    json_t *written = printed(), *shown = example();
    compare_keys(shown, written, "diagnosis.json");
    json_object_foreach(written, name, value) {
        ck_assert_msg(json_object_get(shown, name) != NULL, "\"%s\" is written: put it into the example", name);
    }
    json_decref(shown);
    json_decref(written);
}
