/* wirecut calibrate: a table of steady test cuts to the force and tension law of a job. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "results.h"
#include "terminal.h"

typedef struct calibration {
    const app_call *call;
    const char *path;    /* of the table */
    const char *weights; /* a column of it, or NULL */
    int cuts;
    wcut_test_cut *cut;
    wcut_calibration_options options;
    wcut_calibration fit;
    wcut_calibration_point *point;
    int slips;
    wcut_slip *slip;
    wcut_report_calibrate of; /* all of the above, as the page wants it */
    char (*sentence)[WCUT_REPORT_SENTENCE];
    const char **warning; /* the sentences, as the page wants them */
    app_results results;
} calibration;

enum { WARNINGS_OF_ALL = 8 }; /* beside two a cut */
#define ALPHA_IN_RADIANS 1.2  /* [deg] no table of test cuts has smaller angles throughout */

static const char *const result_name[] = {"report.html", "force_law.json", NULL};

static int load_calibrate(calibration *c) {
    wcut_error error = {0};
    c->weights = app_given(c->call, "weights") ? app_text(c->call, "weights") : NULL;
    wcut_status status = wcut_calibration_table_read(c->path, c->weights, &c->cuts, &c->cut, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    c->options = wcut_calibration_options_default();
    c->options.loss = app_given(c->call, "robust") ? WCUT_LOSS_TUKEY : WCUT_LOSS_SQUARE;
    c->options.noise = app_choice(c->call, "noise") == 1 ? WCUT_NOISE_ABSOLUTE : WCUT_NOISE_RELATIVE;
    if (app_given(c->call, "reference-force")) c->options.reference_force = app_real(c->call, "reference-force");
    if (app_given(c->call, "reference-heat")) c->options.reference_heat = app_real(c->call, "reference-heat");
    return APP_DONE;
}

static int fit_laws(calibration *c) {
    wcut_error error = {0};
    const size_t max = 2 * (size_t)c->cuts + WARNINGS_OF_ALL;
    c->point = calloc((size_t)c->cuts + 1, sizeof *c->point);
    c->sentence = calloc(max, sizeof *c->sentence);
    c->warning = calloc(max, sizeof *c->warning);
    c->slip = calloc((size_t)c->cuts + 1, sizeof *c->slip);
    if (!c->point || !c->sentence || !c->warning || !c->slip) return app_fail_status(WCUT_NO_MEMORY, c->path, NULL);
    wcut_status status = wcut_calibration_fit(c->cuts, c->cut, &c->options, &c->fit, c->point, &error);
    if (status != WCUT_OK) return app_fail_status(status, c->path, &error);

    /* a robust fit that does not come to rest has no outliers to show */
    status = wcut_calibration_slips(c->cuts, c->cut, &c->options, &c->slips, c->slip, &error);
    return status != WCUT_NO_MEMORY ? APP_DONE : app_fail_status(status, c->path, &error);
}

/* force_law.json vouches for the page beside it: both are of the same cuts */
static int write_calibrate_results(calibration *c) {
    wcut_error error = {0};
    const char *page = result_name[0];
    char *text = NULL;
    wcut_status status = wcut_report_calibrate_write(&c->of, app_results_path(&c->results, page), &error);
    const int code = app_results_add(&c->results, page, status, &error);
    if (code != APP_DONE) return code;
    status = wcut_force_law_print(c->cuts, c->cut, &c->options, &c->fit, c->point, &text);
    return app_results_commit(&c->results, result_name[1], status, text);
}

/* ---- the summary ---- */

/* how well a law fits */
static void say_quality(const calibration *c, const wcut_law_fit *law) {
    char sentence[WCUT_REPORT_SENTENCE];
    wcut_report_calibrate_scatter(&c->of, law, sentence);
    app_say("  %s", sentence);
    wcut_report_calibrate_lack(law, sentence);
    app_say("  %s", sentence);
}

static void say_laws(const calibration *c) {
    const wcut_law_fit *f = &c->fit.force, *t = &c->fit.tension;
    app_say("%s: %d cuts, %d heats, %d speeds, Q_eff %.0f to %.0f J/m^2", c->path, c->cuts, c->fit.heats, c->fit.speeds,
            c->fit.q_eff_low, c->fit.q_eff_high);
    app_say("force law: a = %.5g +- %.2g N/mm, b = %.5g +- %.2g m^2/J (standard errors)", f->a, f->standard_error[0],
            f->b, f->standard_error[1]);
    say_quality(c, f);
    app_say("  at F0 = %.4g N/mm and %.4g W/m: V0 = %.4g +- %.2g mm/s, exponent 1/ln(a/F0) = %.4g +- %.2g",
            c->fit.reference_force, c->fit.reference_heat, c->fit.reference_speed, c->fit.reference_speed_error,
            c->fit.exponent, c->fit.exponent_error);
    if (!c->fit.tension_fitted) {
        app_say("tension law: not determined by these cuts");
        return;
    }
    app_say("tension law: a = %.5g +- %.2g N/mm, b = %.5g +- %.2g m^2/J, c = %.5g%s", t->a, t->standard_error[0], t->b,
            t->standard_error[1], t->c, t->c_held ? " N/mm (held: it would be negative)" : " N/mm");
    say_quality(c, t);
}

/* ---- warnings ---- */

static void warn_of_calibration(calibration *c, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    const int k = c->of.warnings++;
    vsnprintf(c->sentence[k], WCUT_REPORT_SENTENCE, format, arguments);
    c->warning[k] = c->sentence[k];
    va_end(arguments);
}

/* cuts far off the law of the others: which line, by how much, and the slip that would explain it */
static void warn_of_slips(calibration *c) {
    /* the columns of the table, by the number of the slip */
    static const char *const column[] = {"", "heat_W_per_m", "speed_mm_s", "engaged_mm", "tension_N", "alpha_deg"};
    for (int k = 0; k < c->slips; k++) {
        const wcut_slip *s = &c->slip[k];
        const wcut_test_cut *cut = &c->cut[s->cut];
        const double value[] = {
            0, cut->heat, cut->speed, cut->engaged, cut->tension_a, cut->alpha_a * WCUT_DEG_PER_RAD};

        /* no digit explains it, or one slipped decimal point does */
        if (s->column == WCUT_SLIP_COLUMN_NONE)
            warn_of_calibration(c, "line %d is an outlier: its force is %.3g times that of the law of the other cuts%s",
                                cut->line, s->ratio,
                                c->options.loss == WCUT_LOSS_SQUARE ? "; try --robust" : "; it has almost no weight");
        else
            warn_of_calibration(
                c,
                "line %d is an outlier: its force is %.3g times that of the law of the other cuts; %s %.6g instead of "
                "%.6g would "
                "fit: "
                "check the decimal point%s",
                cut->line, s->ratio, column[s->column], value[s->column] * s->factor, value[s->column],
                c->options.loss == WCUT_LOSS_SQUARE ? ", or try --robust" : "; it has almost no weight");
    }
}

/* angles in radians pass for a foam that hardly resists */
static void warn_of_angles(calibration *c) {
    double max = 0;
    for (int i = 0; i < c->cuts; i++) {
        const double alpha = WCUT_DEG_PER_RAD * fabs(c->cut[i].alpha_a);
        max = fmax(max, alpha);
        if (alpha > 10)
            warn_of_calibration(
                c, "line %d: the wire trails by more than 10 deg, %.3g deg; in a test cut it should be nearly straight",
                c->cut[i].line, alpha);
    }
    if (max < ALPHA_IN_RADIANS)
        warn_of_calibration(
            c,
            "alpha_deg is %.3g or less in every cut: these look like radians (%.3g deg); a wire in a test cut trails "
            "by 2 "
            "to 10 deg",
            max, max * WCUT_DEG_PER_RAD);
}

/* what the user should know before cutting by these numbers */
static void find_warnings(calibration *c) {
    /* the log likelihood ratio that speaks against the chosen noise */
    const wcut_calibration *fit = &c->fit;
    bool relative = c->options.noise == WCUT_NOISE_RELATIVE;
    const double against = relative ? -fit->force.evidence : fit->force.evidence;

    /* what the cuts cannot tell: the law's parameters, the tension law, the heat, the speed */
    if (!fit->separable)
        warn_of_calibration(
            c,
            "%d levels of Q_eff over a factor of %.2f do not separate a from b (correlation %.3f): use V0 and the "
            "exponent near F0, or make cuts at more heats and speeds",
            fit->q_effs, fit->q_eff_high / fit->q_eff_low, fit->correlation);
    if (fit->tension_fitted && !(fit->tension.low[1] > 0))
        warn_of_calibration(
            c,
            "the tension law is poorly determined: the interval of its b contains 0; use it only in the range of the "
            "cuts");
    if (fit->heats < 2)
        warn_of_calibration(
            c,
            "only one heat: the cuts cannot show whether the force depends on Q_eff alone or heat is lost elsewhere");
    if (fit->speeds < 2)
        warn_of_calibration(c, "only one speed: the cuts cannot show a dependence on the speed itself");
    warn_of_slips(c);
    warn_of_angles(c);

    /* the form of the scatter is not to be seen as long as outliers make it */
    if (against > 2 && c->slips == 0)
        warn_of_calibration(c, "the scatter is rather %s (log likelihood ratio %.1f); try --noise %s",
                            relative ? "absolute" : "relative", against, relative ? "absolute" : "relative");
}

static void describe_calibration(calibration *c) {
    c->of =
        (wcut_report_calibrate){c->path, c->weights, c->cuts, c->cut, &c->options, &c->fit, c->point, 0, c->warning};
    find_warnings(c);
}

static int calibrate(const app_call *call) {
    /* read the table, and make the folder for the results */
    calibration c = {.call = call, .path = call->operand[0]};
    int code = load_calibrate(&c);
    if (code == APP_DONE) code = app_results_begin(&c.results, app_text(call, "output"), result_name);

    /* fit, then say what was found */
    app_catch_interrupts();
    if (code == APP_DONE) code = fit_laws(&c);
    if (code == APP_DONE && app_is_interrupted()) code = app_fail(APP_INTERRUPTED, "%s: interrupted", c.path);
    if (code == APP_DONE) describe_calibration(&c);
    if (code == APP_DONE) code = write_calibrate_results(&c);

    /* results for programs and for people */
    if (code == APP_DONE && app_given(call, "json")) fputs(c.results.text, stdout);
    if (code == APP_DONE && !app_given(call, "quiet")) {
        say_laws(&c);
        for (int i = 0; i < c.of.warnings; i++) app_say("warning: %s", c.warning[i]);
    }

    app_results_end(&c.results);

    free(c.slip);
    free(c.warning);
    free(c.sentence);
    free(c.point);
    wcut_test_cut_destroy(c.cut);
    return code;
}

/* ---- the table ---- */

static double calibrate_noise(void) { return wcut_calibration_options_default().noise; }

static const app_operand operand[] = {
    {.name = "TABLE",
     .kind = APP_FILE,
     .help = "steady test cuts: heat_W_per_m, speed_mm_s, engaged_mm, tension_N, alpha_deg"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    {.kind = APP_FLAG,
     .name = "robust",
     .help = "reduce the weight of outliers: Tukey's biweight, started from Huber's loss"},
    {.kind = APP_CHOICE,
     .name = "noise",
     .value = "relative|absolute",
     .library = calibrate_noise,
     .help = "scatter of the cuts: proportional to the force, or the same for all"},
    {.kind = APP_TEXT,
     .name = "weights",
     .value = "COLUMN",
     .help = "column of the table that holds the weights of the cuts"},
    {.kind = APP_REAL,
     .name = "reference-force",
     .value = "F0",
     .low = 1e-9,
     .high = 1e3,
     .help = "force at which V0 and the exponent are stated, N/mm, in place of the geometric mean of the cuts"},
    {.kind = APP_REAL,
     .name = "reference-heat",
     .value = "Q",
     .low = 1e-3,
     .high = 1e5,
     .help = "heat at which V0 is stated, W/m, in place of the median of the cuts"},
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_calibrate = {
    .name = "calibrate",
    .brief = "fit the force law and the tension law to steady test cuts",
    .about =
        "Fits F = a exp(-b Q_eff) to the force of each cut, (T_a sin alpha_a + T_b sin alpha_b) / engaged length, and "
        "T = a exp(-b Q_eff) + c to its tension per engaged length (Rust et al. 2016, (2) and (1)). Writes into DIR: "
        "force_law.json (the laws as a job has them, with standard errors, covariances, the validated range of Q_eff, "
        "the leave-one-out error, a test for lack of fit and the residual of every cut) and report.html (the same in "
        "charts and tables).\na and b are strongly correlated. Well determined are V0 = b Q / ln(a/F0), the speed at a "
        "force F0, and the exponent 1/ln(a/F0).",
    .operand = operand,
    .option = option,
    .run = calibrate,
};
