/* force_law.json: a calibration as the blocks of a job, with what is known about them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/calibration.h>
#include <wirecut/calibration_file.h>

#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/text.h"

static const char *const key[3] = {"a_N_per_mm", "b_m2_per_J", "c_N_per_mm"};

/* {"a_N_per_mm": ..., "b_m2_per_J": ...} without the closing brace */
static void put_keyed(wcut_text *text, int parameters, const double *value) {
    for (int j = 0; j < parameters; j++) {
        wcut_text_print(text, "%s\"%s\": ", j ? ", " : "{", key[j]);
        wcut_text_number(text, value[j]);
    }
}

static void put_intervals(wcut_text *text, int parameters, const wcut_law_fit *fit) {
    for (int j = 0; j < parameters; j++) {
        wcut_text_print(text, "%s\"%s\": ", j ? ", " : "{", key[j]);
        wcut_text_put_number(text, "[", fit->low[j]);
        wcut_text_put_number(text, ", ", fit->high[j]);
        wcut_text_put_word(text, "]");
    }
    wcut_text_put_word(text, "}");
}

static void put_covariance(wcut_text *text, int parameters, const wcut_law_fit *fit) {
    for (int i = 0; i < parameters; i++) {
        wcut_text_put_word(text, i ? ", " : "[");
        for (int j = 0; j < parameters; j++) wcut_text_put_number(text, j ? ", " : "[", fit->covariance[3 * i + j]);
        wcut_text_put_word(text, "]");
    }
    wcut_text_put_word(text, "]");
}

static void put_lack_of_fit(wcut_text *text, const wcut_law_fit *fit) {
    static const char *const against[] = {"untested", "replicates", "flexible law"};
    wcut_text_print(text, ",\n    \"lack_of_fit\": {\"against\": \"%s\", \"degrees\": [%d, %d]", against[fit->lack],
                    fit->lack_degrees[0], fit->lack_degrees[1]);
    wcut_text_put_number(text, ", \"f\": ", fit->lack_f);
    wcut_text_put_number(text, ", \"p\": ", fit->lack_p);
    wcut_text_put_word(text, "}");
}

static void put_law(wcut_text *text, const char *name, int parameters, const wcut_law_fit *fit,
                    const wcut_calibration *c, double confidence) {
    const double value[3] = {fit->a, fit->b, fit->c};

    /* values, standard errors, covariances */
    wcut_text_print(text, ",\n  \"%s\": ", name);
    put_keyed(text, parameters, value);
    wcut_text_put_word(text, ",\n    \"standard_error\": ");
    put_keyed(text, parameters, fit->standard_error);
    wcut_text_put_word(text, "},\n    \"covariance\": ");
    put_covariance(text, parameters, fit);

    /* confidence and the intervals it gives, the range that was cut */
    wcut_text_put_number(text, ",\n    \"confidence\": ", confidence);
    wcut_text_put_word(text, ", \"interval\": ");
    put_intervals(text, parameters, fit);
    wcut_text_put_number(text, ",\n    \"range_J_per_m2\": [", c->q_eff_low);
    wcut_text_put_number(text, ", ", c->q_eff_high);

    /* scatter and the tests of the fit */
    wcut_text_put_number(text, "],\n    \"scale\": ", fit->scale);
    wcut_text_print(text, ", \"degrees\": %d", fit->degrees);
    if (parameters > 2) wcut_text_print(text, ", \"c_held\": %s", fit->c_held ? "true" : "false");
    wcut_text_put_number(text, ",\n    \"leave_one_out\": {\"rms\": ", fit->leave_one_out);
    wcut_text_print(text, ", \"cuts\": %d}", fit->left_out);
    put_lack_of_fit(text, fit);
    wcut_text_put_number(text, ",\n    \"log_likelihood_relative_less_absolute\": ", fit->evidence);
    wcut_text_put_word(text, "}");
}

/* the laws alone, as they stand in a job's "process" */
static void put_force_law_process(wcut_text *text, const wcut_calibration *c) {
    const double force[2] = {c->force.a, c->force.b}, tension[3] = {c->tension.a, c->tension.b, c->tension.c};
    wcut_text_put_word(text, ",\n  \"process\": {\"force_law\": ");
    put_keyed(text, 2, force);
    wcut_text_put_word(text, "}");
    if (c->tension_fitted) {
        wcut_text_put_word(text, ", \"tension_law\": ");
        put_keyed(text, 3, tension);
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "}");
}

static void put_reference(wcut_text *text, const wcut_calibration *c) {
    wcut_text_put_number(text, ",\n  \"reference\": {\"force_N_per_mm\": ", c->reference_force);
    wcut_text_put_number(text, ", \"heat_W_per_m\": ", c->reference_heat);
    wcut_text_put_number(text, ", \"speed_mm_s\": ", c->reference_speed);
    wcut_text_put_number(text, ", \"speed_standard_error_mm_s\": ", c->reference_speed_error);
    wcut_text_put_number(text, ",\n    \"exponent\": ", c->exponent);
    wcut_text_put_number(text, ", \"exponent_standard_error\": ", c->exponent_error);
    wcut_text_put_number(text, ", \"correlation_a_b\": ", c->correlation);
    wcut_text_print(text, "},\n  \"cuts\": {\"heats\": %d, \"speeds\": %d, \"q_effs\": %d, \"a_b_separable\": %s, ",
                    c->heats, c->speeds, c->q_effs, c->separable ? "true" : "false");
    wcut_text_print(text, "\"large_angles\": %d}", c->large_angles);
}

static void put_force_law_point(wcut_text *text, const char *name, const wcut_law_fit_point *p, int fitted) {
    wcut_text_print(text, ", \"%s\": {\"measured_N_per_mm\": ", name);
    wcut_text_number(text, p->measured);
    if (fitted) {
        wcut_text_put_number(text, ", \"fitted_N_per_mm\": ", p->fitted);
        wcut_text_put_number(text, ", \"residual\": ", p->residual);
        wcut_text_put_number(text, ", \"weight\": ", p->loss_weight);
        wcut_text_put_number(text, ", \"left_out_N_per_mm\": ", p->left_out);
        wcut_text_put_number(text, ", \"leverage\": ", p->leverage);
    }
    wcut_text_put_word(text, "}");
}

static void put_force_law_residuals(wcut_text *text, int n, const wcut_test_cut *cut, const wcut_calibration *c,
                                    const wcut_calibration_point *point) {
    wcut_text_put_word(text, ",\n  \"residuals\": [");
    for (int i = 0; i < n; i++) {
        wcut_text_print(text, "%s\n    {\"line\": %d", i ? "," : "", cut[i].line);
        wcut_text_put_number(text, ", \"heat_W_per_m\": ", cut[i].heat);
        wcut_text_put_number(text, ", \"speed_mm_s\": ", cut[i].speed);
        wcut_text_put_number(text, ", \"q_eff_J_per_m2\": ", point[i].q_eff);
        put_force_law_point(text, "force", &point[i].force, 1);
        put_force_law_point(text, "tension", &point[i].tension, c->tension_fitted);
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "\n  ]");
}

/* JSON has no word for a number that is not finite: a struct that holds one did not come from the fit */
static int is_force_law_whole(const wcut_calibration *c) {
    const wcut_law_fit *law[2] = {&c->force, &c->tension};
    double sum = c->q_eff_low + c->q_eff_high + c->reference_force + c->reference_heat + c->reference_speed +
                 c->reference_speed_error + c->exponent + c->exponent_error + c->correlation;
    for (int k = 0; k < 2; k++) {
        sum += law[k]->a + law[k]->b + law[k]->c + law[k]->scale + law[k]->leave_one_out + law[k]->lack_f;
        sum += law[k]->lack_p + law[k]->evidence;
        for (int j = 0; j < 3; j++) sum += law[k]->low[j] + law[k]->high[j] + law[k]->standard_error[j];
        for (int j = 0; j < 9; j++) sum += law[k]->covariance[j];
        if ((unsigned)law[k]->lack > WCUT_LACK_OF_FIT_FLEXIBLE) return 0;
    }
    return isfinite(sum);
}

wcut_status wcut_force_law_print(int n, const wcut_test_cut *cut, const wcut_calibration_options *options,
                                 const wcut_calibration *c, const wcut_calibration_point *point, char **text) {
    if (n < 1 || !cut || !c || !point || !text || !is_force_law_whole(c)) return WCUT_BAD_ARGUMENT;
    wcut_calibration_options o = options ? *options : wcut_calibration_options_default();

    if ((unsigned)o.loss > WCUT_LOSS_TUKEY || (unsigned)o.noise > WCUT_NOISE_ABSOLUTE) return WCUT_BAD_ARGUMENT;
    static const char *const loss[] = {"square", "huber", "tukey"}, *const noise[] = {"relative", "absolute"};
    wcut_text out;

    /* format, noise and loss of the fit */
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    wcut_text_print(&out, "{\"format\": \"wirecut-force-law/1\", \"noise\": \"%s\", \"loss\": \"%s\"", noise[o.noise],
                    loss[o.loss]);

    /* process, laws and residuals */
    put_force_law_process(&out, c);
    put_law(&out, "force_law", 2, &c->force, c, o.confidence);
    if (c->tension_fitted)
        put_law(&out, "tension_law", 3, &c->tension, c, o.confidence);
    else
        wcut_text_put_word(&out, ",\n  \"tension_law\": null");
    put_reference(&out, c);
    put_force_law_residuals(&out, n, cut, c, point);
    wcut_text_put(&out, "}\n", 3); /* with its zero */

    /* the buffer goes to the caller only if it is whole */
    if (out.failed) {
        wcut_text_destroy(&out);
        return WCUT_NO_MEMORY;
    }
    *text = out.data;

    return WCUT_OK;
}

wcut_status wcut_force_law_write(int n, const wcut_test_cut *cut, const wcut_calibration_options *options,
                                 const wcut_calibration *calibration, const wcut_calibration_point *point,
                                 const char *path, wcut_error *error) {
    char *text = NULL;
    wcut_status status = path ? wcut_force_law_print(n, cut, options, calibration, point, &text) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_fail(error, status, "force law: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, strlen(text), error);
    free(text);
    return status;
}
