/* Effects against recordings of an independent laboratory: every labelled cut whose answer holds physics of the step is
   replayed with the true force law, without and with the answer's effects. What is left should be noise.

   bench_effects [CASE ..]: where ../shared is absent it says so and ends. */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/wirecut.h>

#define CASES WCUT_SOURCE_DIR "/../shared/cases/dev/"

enum { CHANNELS = 6 }; /* tension_a .. beta_b: signals 2 .. 7 */

typedef struct tally { /* squares of residuals, and of their means over a second, which noise does not reach */
    double sum[2], mean[2];
    int samples, seconds;
} tally;

/* an answer's effect as the job would name it; what the answer only derives is left */
static int effect_of(const json_t *answer, wcut_effect *effect) {
    wcut_effect_kind kind;
    const json_t *parameters = json_object_get(answer, "parameters");
    if (wcut_effect_locate(json_string_value(json_object_get(answer, "name")), &kind) != WCUT_OK) return 0;
    const wcut_effect_info *info = wcut_effect_view(kind);
    const char *choice = info->choice_key ? json_string_value(json_object_get(parameters, info->choice_key)) : NULL;
    int chosen = 0;
    for (int k = 0; choice && info->choice[k]; k++)
        if (strcmp(choice, info->choice[k]) == 0) chosen = k;
    *effect = wcut_effect_choose(kind, chosen);
    for (const wcut_effect_parameter *p = wcut_effect_parameters(effect); p->key; p++) {
        const json_t *value = json_object_get(parameters, p->key);
        for (int c = 0; value && c < p->size; c++)
            effect->value[p->at + c] = json_number_value(p->size > 1 ? json_array_get(value, (size_t)c) : value);
    }
    return 1;
}

/* the part of a recording that is compared: 2 s after the wire is taut to 1 s before the end */
static void find_span(const wcut_recording *r, const wcut_prediction *p, double *from, double *to) {
    const double *time = r->channel[WCUT_CHANNEL_TIME].value;
    int i = 0;
    while (i < r->samples - 1 && !(p->present[i] && p->value[2][i] > 0.3)) i++;
    *from = time[i] + 2, *to = time[r->samples - 1] - 1;
}

static void compare(const wcut_recording *r, wcut_prediction *const p[2], tally *t) {
    double from, to, sum[2] = {0, 0};
    find_span(r, p[0], &from, &to);
    const double *time = r->channel[WCUT_CHANNEL_TIME].value;
    for (int c = 0; c < CHANNELS; c++) {
        const wcut_column *measured = &r->channel[WCUT_CHANNEL_SPEED_A + 2 + c];
        int in_second = 0;
        double second = -1;
        for (int i = 0; i < r->samples; i++) {
            if (time[i] < from || time[i] > to || !p[0]->present[i] || !p[1]->present[i]) continue;
            if (measured->present && !measured->present[i]) continue;
            if (floor(time[i]) != second) {
                for (int k = 0; k < 2 && in_second > 10; k++) t[c].mean[k] += pow(sum[k] / in_second, 2);
                t[c].seconds += in_second > 10;
                second = floor(time[i]), in_second = 0, sum[0] = sum[1] = 0;
            }
            for (int k = 0; k < 2; k++) {
                const double d = measured->value[i] - p[k]->value[2 + c][i];
                sum[k] += d, t[c].sum[k] += d * d;
            }
            in_second++, t[c].samples++;
        }
    }
}

static int replay(const char *folder, double a, double b, int count, wcut_effect *effect, tally *t, int iterations[2]) {
    char path[1000];
    wcut_job *job = NULL;
    wcut_recording *recording = NULL;
    wcut_prediction *p[2] = {NULL, NULL};
    wcut_error error = {0};
    snprintf(path, sizeof path, "%s/job.json", folder);
    int ok = wcut_job_read(path, &job, &error) == WCUT_OK;
    snprintf(path, sizeof path, "%s/recording.csv", folder);
    ok = ok && wcut_recording_read(path, NULL, &recording, &error) == WCUT_OK;
    for (int k = 0; ok && k < 2; k++) {
        wcut_setup *setup = NULL;
        job->force_law.a = a, job->force_law.b = b;
        job->effect_count = k ? count : 0, job->effect = effect;
        ok = wcut_setup_create(job, NULL, &setup, &error) == WCUT_OK &&
             wcut_prediction_replay(setup, recording, NULL, &p[k], &error) == WCUT_OK;
        if (ok && k)
            ok = wcut_sensors_eval(count, effect, recording->samples, recording->channel[WCUT_CHANNEL_TIME].value,
                                   p[k]->present, p[k]->value) == WCUT_OK;
        wcut_setup_destroy(setup);
        job->effect = NULL, job->effect_count = 0;
        if (ok && p[k]->failed) fprintf(stderr, "%s: %d samples failed: %s\n", folder, p[k]->failed, p[k]->cause.text);
        if (ok) iterations[k] += p[k]->iterations;
    }
    if (ok) compare(recording, p, t);
    if (!ok) fprintf(stderr, "%s: %s\n", folder, error.text);
    for (int k = 0; k < 2; k++) wcut_prediction_destroy(p[k]);
    wcut_recording_destroy(recording);
    wcut_job_destroy(job);
    return ok;
}

static void print_row(const char *channel, double unit, const tally *t) {
    printf("  %-12s rms %8.4f -> %8.4f   1 s means %8.4f -> %8.4f\n", channel, unit * sqrt(t->sum[0] / t->samples),
           unit * sqrt(t->sum[1] / t->samples), unit * sqrt(t->mean[0] / t->seconds),
           unit * sqrt(t->mean[1] / t->seconds));
}

static void run_case(const json_t *answer) {
    static const char *const channel[CHANNELS] = {"tension_a N", "tension_b N", "alpha_a deg",
                                                  "beta_a deg",  "alpha_b deg", "beta_b deg"};
    const char *name = json_string_value(json_object_get(answer, "case"));
    const json_t *effects = json_object_get(answer, "effects");
    wcut_effect effect[4];
    int count = 0, iterations[2] = {0, 0};
    printf("%s", name);
    for (size_t k = 0; k < json_array_size(effects) && count < 4; k++) {
        const json_t *e = json_array_get(effects, k);
        if (!effect_of(e, &effect[count])) continue;
        printf("  %s %.4g", json_string_value(json_object_get(e, "name")), effect[count++].value[0]);
    }
    printf("\n");
    tally t[CHANNELS] = {{{0, 0}, {0, 0}, 0, 0}};
    for (int cut = 1; cut <= 6; cut++) {
        char folder[500];
        snprintf(folder, sizeof folder, CASES "%s/cut-%02d", name, cut);
        if (!replay(folder, json_number_value(json_object_get(answer, "a_true")),
                    json_number_value(json_object_get(answer, "b_true")), count, effect, t, iterations))
            return;
    }
    for (int c = 0; c < CHANNELS; c++) print_row(channel[c], c < 2 ? 1 : 180 / 3.14159265358979323846, &t[c]);
    printf("  Newton iterations %d -> %d\n", iterations[0], iterations[1]);
}

static int wanted(const json_t *answer, int argc, char **argv) {
    const char *name = json_string_value(json_object_get(answer, "case"));
    for (int k = 1; k < argc; k++)
        if (strcmp(argv[k], name) == 0) return 1;
    if (argc > 1) return 0;
    const json_t *effects = json_object_get(answer, "effects");
    for (size_t k = 0; k < json_array_size(effects); k++) {
        wcut_effect effect;
        if (!effect_of(json_array_get(effects, k), &effect)) continue;
        if (wcut_effect_view(effect.kind)->place == WCUT_EFFECT_PLACE_STEP) return 1;
    }
    return 0;
}

int main(int argc, char **argv) {
    json_error_t error;
    json_t *root = json_load_file(CASES "answers.json", 0, &error);
    if (!root) {
        printf("no labelled cases beside the tree: nothing to compare with\n");
        return EXIT_SUCCESS;
    }
    const json_t *cases = json_object_get(root, "cases");
    for (size_t k = 0; k < json_array_size(cases); k++)
        if (wanted(json_array_get(cases, k), argc, argv)) run_case(json_array_get(cases, k));
    json_decref(root);
    return EXIT_SUCCESS;
}
