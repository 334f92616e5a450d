/* "wirecut-score/1" and residuals.csv: what scores say in the units of files. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/score.h>
#include <wirecut/score_file.h>
#include <wirecut/version.h>

#include <wirecut/angle.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/text.h"

/* from the API's unit to the file's */
static double score_unit_of(int scored) {
    return strcmp(wcut_scored_unit((wcut_scored)scored), "deg") == 0 ? WCUT_DEG_PER_RAD : 1;
}

/* ---- scores ---- */

/* a figure, or null where there is none */
static void put_score_number(wcut_text *text, const char *before, bool there, double value) {
    wcut_text_put_word(text, before);
    if (there)
        wcut_text_number(text, value);
    else
        wcut_text_put_word(text, "null");
}

static void put_score(wcut_text *text, const wcut_score *s, double unit) {
    put_score_number(text, "\"rmsd\": ", s->count > 0, s->rmsd * unit);
    put_score_number(text, ", \"nrmsd\": ", s->range > 0, s->nrmsd);
    put_score_number(text, ", \"rmse_over_range\": ", s->range > 0, s->rmse_over_range);
    put_score_number(text, ", \"bias\": ", s->count > 0, s->bias * unit);
    put_score_number(text, ", \"rmse\": ", s->count > 0, s->rmse * unit);
    put_score_number(text, ", \"range\": ", s->count > 0, s->range * unit);
    put_score_number(text, ", \"correlation\": ", s->correlated, s->correlation);
    wcut_text_print(text, ", \"count\": %d", s->count);
}

/* {CHANNEL: {...}, ...}; channels without samples and phases without samples are left out */
static void put_scores(wcut_text *text, const char *before, const wcut_scores *scores, const char *indent) {
    bool first = true;
    wcut_text_print(text, "%s{", before);
    for (int k = 0; k < WCUT_SCORED_COUNT; k++) {
        const wcut_score *of = scores->of[k];
        if (of[WCUT_PART_ALL].count < 1) continue;
        wcut_text_print(text, "%s\n%s\"%s\": {", first ? "" : ",", indent, wcut_scored_name((wcut_scored)k));
        first = false;
        put_score(text, &of[WCUT_PART_ALL], score_unit_of(k));
        for (int part = WCUT_PART_ENTRY; part < WCUT_PART_COUNT; part++) {
            if (of[part].count < 1) continue;
            wcut_text_print(text, ",\n%s  \"%s\": {", indent, wcut_part_name((wcut_part)part));
            put_score(text, &of[part], score_unit_of(k));
            wcut_text_put_word(text, "}");
        }
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "}");
}

/* ---- cuts ---- */

/* what a prediction did not reach, and why */
static void put_prediction(wcut_text *text, const char *before, const wcut_prediction *p, const double *time) {
    wcut_text_print(text, "%s{\"without_motion\": %d, \"standing\": %d, \"failed\": %d", before, p->without_motion,
                    p->standing, p->failed);
    if (p->failed > 0) {
        wcut_text_put_number(text, ", \"first_failed_s\": ", time[p->first_failed]);
        wcut_text_put_string(text, ", \"cause\": ", p->cause.text);
    }
}

static void put_score_cut(wcut_text *text, const wcut_scored_cut *cut, bool first) {
    const wcut_comparison *c = cut->comparison;

    /* the names of the cut and its files */
    wcut_text_put_word(text, first ? "\n    {" : ",\n    {");
    if (cut->of_case) {
        wcut_text_put_string(text, "\"case\": ", cut->of_case);
        wcut_text_put_word(text, ", ");
    }
    wcut_text_put_string(text, "\"cut\": ", cut->name);
    wcut_text_put_string(text, ", \"job\": ", cut->job);
    wcut_text_put_string(text, ", \"recording\": ", cut->recording);

    /* a cut that was not scored has its error instead */
    if (!c) {
        wcut_text_put_string(text, ",\n     \"error\": ", cut->error ? cut->error->text : "");
        wcut_text_put_word(text, "}");
        return;
    }

    /* the samples counted, and the predictions of both kinds */
    const double *time = cut->samples->channel[WCUT_CHANNEL_TIME].value;
    wcut_text_print(text, ",\n     \"samples\": %d, \"counted\": %d", c->samples, c->counted_samples);
    wcut_text_put_number(text, ", \"time_s\": {\"contact\": ", c->contact);
    wcut_text_put_number(text, ", \"leave\": ", c->leave);
    wcut_text_put_number(text, ", \"from\": ", c->from);
    wcut_text_put_number(text, ", \"to\": ", c->to);
    put_prediction(text, "},\n     \"plan\": ", c->planned, time);
    put_prediction(text, "},\n     \"replay\": ", c->replayed, time);
    wcut_text_put_number(text, ", \"motion_scatter\": ", c->replayed->scatter);
    wcut_text_print(text, ", \"iterations\": %d}", c->replayed->iterations);

    /* scores of both predictions, by channel and part of the cut */
    put_scores(text, ",\n     \"planned\": ", &c->planned_score, "      ");
    put_scores(text, ",\n     \"replayed\": ", &c->replayed_score, "      ");
    wcut_text_put_word(text, "}");
}

/* ---- means ---- */

static void put_means(wcut_text *text, int n, const wcut_comparison *const *comparison, const char *indent) {
    wcut_scores planned, replayed;
    wcut_scores_mean(n, comparison, &planned, &replayed); /* its arguments are whole */
    put_scores(text, "\"planned\": ", &planned, indent);
    put_scores(text, ", \"replayed\": ", &replayed, indent);
}

/* the mean of every case, where there are any */
static void put_cases(wcut_text *text, int n, const wcut_scored_cut *cut, const wcut_comparison *const *comparison) {
    bool first = true;
    wcut_text_put_word(text, ",\n  \"cases\": [");
    for (int i = 0, end; i < n; i = end) {
        for (end = i + 1; end < n && cut[i].of_case && cut[end].of_case && !strcmp(cut[i].of_case, cut[end].of_case);)
            end++;
        if (!cut[i].of_case) continue;
        wcut_text_put_string(text, first ? "\n    {\"case\": " : ",\n    {\"case\": ", cut[i].of_case);
        wcut_text_put_word(text, ", ");
        put_means(text, end - i, comparison + i, "      ");
        wcut_text_put_word(text, "}");
        first = false;
    }
    wcut_text_put_word(text, "]");
}

/* ---- the document ---- */

static void put_options(wcut_text *text, const wcut_comparison_options *o) {
    wcut_text_print(text, ",\n  \"options\": {\"motion\": \"%s\"",
                    o->replay.motion == WCUT_MOTION_POSITION ? "position" : "station");
    wcut_text_put_number(text, ", \"window_s\": ", o->replay.window);
    wcut_text_put_number(text, ", \"settle_s\": ", o->settle);
    wcut_text_put_number(text, ", \"leave_s\": ", o->leave);
    wcut_text_put_word(text, "}");
}

static bool are_score_usable(int n, const wcut_scored_cut *cut) {
    if (n < 1 || !cut) return false;
    for (int i = 0; i < n; i++)
        if (!cut[i].name || !cut[i].job || !cut[i].recording || !cut[i].comparison != !cut[i].samples ||
            (cut[i].samples && cut[i].samples->samples != cut[i].comparison->samples))
            return false;
    return true;
}

wcut_status wcut_score_print(int n, const wcut_scored_cut *cut, const wcut_comparison_options *options, char **text) {
    if (!are_score_usable(n, cut) || !text) return WCUT_BAD_ARGUMENT;
    const wcut_comparison_options o = options ? *options : wcut_comparison_options_default();

    /* room for the comparisons in a row */
    const wcut_comparison **comparison = wcut_alloc((size_t)n, sizeof *comparison);
    wcut_text out;
    if (!comparison || !wcut_text_create(&out, NULL)) {
        free(comparison);
        return WCUT_NO_MEMORY;
    }
    for (int i = 0; i < n; i++) comparison[i] = cut[i].comparison;

    /* options, means, cases, cuts */
    wcut_text_print(&out, "{\n  \"format\": \"wirecut-score/1\",\n  \"version\": \"%s\"", WCUT_VERSION);
    put_options(&out, &o);
    wcut_text_put_word(&out, ",\n  \"mean\": {");
    put_means(&out, n, comparison, "    ");
    wcut_text_put_word(&out, "}");

    /* figures of each case, then of each cut */
    put_cases(&out, n, cut, comparison);
    wcut_text_put_word(&out, ",\n  \"cuts\": [");
    for (int i = 0; i < n; i++) put_score_cut(&out, &cut[i], i == 0);
    wcut_text_put_word(&out, "]\n}\n");

    free(comparison);
    return wcut_text_finish(&out, text, NULL);
}

wcut_status wcut_score_write(int n, const wcut_scored_cut *cut, const wcut_comparison_options *options,
                             const char *path, wcut_error *error) {
    char *text = NULL;
    wcut_status status = path ? wcut_score_print(n, cut, options, &text) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_fail(error, status, "scores: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, strlen(text), error);
    free(text);
    return status;
}

/* ---- residuals.csv ---- */

/* A name as a field, quoted where need be (RFC 4180), and as a text, never as a formula: spreadsheets run what begins with =, +, - or @, so it gets an apostrophe.
   Control characters are shown as \xNN. */
static void put_score_field(wcut_text *text, const char *field) {
    const bool formula = *field && strchr("=+-@", *field);
    const bool quoted = strpbrk(field, ",\"#") != NULL;
    if (quoted) wcut_text_put_word(text, "\"");
    if (formula) wcut_text_put_word(text, "'");
    for (const char *p = field; *p; p++) {
        const unsigned char c = (unsigned char)*p;
        if (c < 0x20 || c == 0x7f)
            wcut_text_print(text, "\\x%02x", c);
        else
            wcut_text_put(text, c == '"' ? "\"\"" : p, c == '"' ? 2 : 1);
    }
    if (quoted) wcut_text_put_word(text, "\"");
}

static const char *signal_column(int signal) {
    return wcut_channel_name((wcut_channel)(WCUT_CHANNEL_SPEED_A + signal));
}

/* the speed is what a replay is driven by: it has no residual */
static bool is_replayed(int signal) { return signal >= 2; }

static void put_score_header(wcut_text *text) {
    wcut_text_put_word(text, "case,cut,time_s,station,phase,counted");
    for (int k = 0; k < WCUT_SIGNAL_COUNT; k++) {
        const char *name = signal_column(k);
        wcut_text_print(text, ",%s,planned_%s,planned_residual_%s", name, name, name);
        if (is_replayed(k)) wcut_text_print(text, ",replayed_%s,replayed_residual_%s", name, name);
    }
    wcut_text_put_word(text, "\n");
}

/* a comma and a value to a millionth of its unit, a tenth of what any sensor of the rig resolves; nothing where there
   is none */
static void put_score_value(wcut_text *text, bool there, double value) {
    wcut_text_put_word(text, ",");
    if (there) wcut_text_number(text, round(value * 1e6) / 1e6 + 0.0);
}

static void put_score_row(wcut_text *text, const wcut_scored_cut *cut, int i) {
    const wcut_comparison *c = cut->comparison;
    const wcut_column *channel = cut->samples->channel, *station = &channel[WCUT_CHANNEL_STATION];

    /* which sample of which cut */
    put_score_field(text, cut->of_case ? cut->of_case : "");
    wcut_text_put_word(text, ",");
    put_score_field(text, cut->name);
    put_score_value(text, true, channel[WCUT_CHANNEL_TIME].value[i]);
    const bool placed = !station->present || station->present[i];
    put_score_value(text, placed, station->value[i]);
    wcut_text_print(text, ",%s,%d", placed ? wcut_phase_name(c->phase[i]) : "", c->counted[i]);

    /* each signal: measured, planned, replayed, and what is between */
    for (int k = 0; k < WCUT_SIGNAL_COUNT; k++) {
        const wcut_column *x = &channel[WCUT_CHANNEL_SPEED_A + k];
        const double unit = k < 4 ? 1 : WCUT_DEG_PER_RAD;
        const bool measured = !x->present || x->present[i];
        const bool planned = c->planned->present[i], replayed = c->replayed->present[i];
        put_score_value(text, measured, x->value[i] * unit);
        put_score_value(text, planned, c->planned->value[k][i] * unit);
        put_score_value(text, measured && planned, (x->value[i] - c->planned->value[k][i]) * unit);
        if (!is_replayed(k)) continue;
        put_score_value(text, replayed, c->replayed->value[k][i] * unit);
        put_score_value(text, measured && replayed, (x->value[i] - c->replayed->value[k][i]) * unit);
    }

    /* one line for each sample */
    wcut_text_put_word(text, "\n");
}

typedef struct scored {
    int count;
    const wcut_scored_cut *cut; /* count */
} scored;

static bool put_residuals(wcut_text *text, const void *context) {
    const scored *whole = context;
    put_score_header(text);
    for (int k = 0; k < whole->count; k++) {
        const wcut_scored_cut *cut = &whole->cut[k];
        for (int i = 0; cut->comparison && i < cut->comparison->samples; i++) put_score_row(text, cut, i);
    }
    return true;
}

wcut_status wcut_residuals_write(int n, const wcut_scored_cut *cut, const char *path, wcut_error *error) {
    if (!are_score_usable(n, cut) || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "residuals: %s", wcut_status_text(WCUT_BAD_ARGUMENT));
    const scored whole = {n, cut};
    return wcut_text_write_file(path, put_residuals, &whole, error);
}
