/* The page of a closed loop: speeds, tensions and angles with feedback and with the plan alone. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/angle.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"

enum { SPANS = 32, FIGURES = 8 };

typedef struct page {
    const wcut_rig_summary *s;
    double *target, *alpha[2]; /* of the run with feedback: samples each; alpha of the plan alone: its own */
    char verdict[400], hash[WCUT_SHA256_TEXT];
} page;

/* ---- what is said ---- */

static wcut_report_tone judge_control(page *p) {
    const wcut_rig_run *with = p->s->feedback, *plan = p->s->plan;
    char without[160];

    /* what the plan alone comes to */
    if (!plan->complete)
        snprintf(without, sizeof without, "the plan alone ends at %.1f s (%s)", plan->duration,
                 wcut_control_state_name(plan->ended));
    else if (plan->has_steady)
        snprintf(without, sizeof without, "with the plan alone its error is %.2g %%", 100 * fabs(plan->steady.mean));
    else
        snprintf(without, sizeof without, "with the plan alone the tension exceeds the target by %.1f %%",
                 100 * plan->overshoot);

    /* an early end, a cut too short for a steady phase, and the usual case */
    if (!with->complete) {
        snprintf(p->verdict, sizeof p->verdict, "With feedback the cut ends at %.1f s: %s; %s.", with->duration,
                 wcut_control_state_name(with->ended), without);
        return WCUT_REPORT_TONE_BAD;
    }
    if (!with->has_steady) {
        snprintf(p->verdict, sizeof p->verdict, "With feedback the tension stays below %.3g N; %s.",
                 with->target * (1 + with->overshoot), without);
        return WCUT_REPORT_TONE_PLAIN;
    }

    /* within 5 % of the target is good */
    const bool good = fabs(with->steady.mean) <= 0.05;
    snprintf(p->verdict, sizeof p->verdict,
             "With feedback the mean tension of the steady phase is %.4g N, %.2g %% from the target of %.3g N; %s.",
             with->target * (1 + with->steady.mean), 100 * fabs(with->steady.mean), with->target, without);

    return good ? WCUT_REPORT_TONE_GOOD : WCUT_REPORT_TONE_WARNING;
}

/* runs of samples of one phase; gives how many */
static int list_control_phases(const wcut_rig_run *run, wcut_report_span *span) {
    const double *time = run->recording.channel[WCUT_CHANNEL_TIME].value;
    const double *station = run->recording.channel[WCUT_CHANNEL_STATION].value;
    const int n = run->recording.samples;
    int count = 0;
    for (int i = 0, from = 0; i < n && count < SPANS; i++) {
        if (i + 1 < n && run->phase[i + 1] == run->phase[from]) continue;
        const int to = i + 1 < n ? i + 1 : i;
        span[count++] = (wcut_report_span){.label = wcut_phase_name(run->phase[from]),
                                           .from = {time[from], station[from]},
                                           .to = {time[to], station[to]}};
        from = i + 1;
    }
    return count;
}

static wcut_report_series rig_series(const wcut_rig_run *run, const char *label, wcut_report_mark mark,
                                     const double *y) {
    const wcut_column *c = run->recording.channel;
    return (wcut_report_series){.label = label,
                                .mark = mark,
                                .count = run->recording.samples,
                                .x = {c[WCUT_CHANNEL_TIME].value, c[WCUT_CHANNEL_STATION].value},
                                .y = y};
}

static wcut_report_chart control_chart(const char *title, const char *note, const char *label, const char *unit,
                                       int count, const wcut_report_series *of, int spans,
                                       const wcut_report_span *span) {
    return (wcut_report_chart){.title = title,
                               .note = note,
                               .x_label = {"time", "station"},
                               .x_unit = {"s", ""},
                               .y_label = label,
                               .y_unit = unit,
                               .series_count = count,
                               .series = of,
                               .span_count = spans,
                               .span = span};
}

/* ---- the page ---- */

/* a column of the table of figures: one run */
static void list_figures(const wcut_rig_run *run, double *to) {
    const bool s = run->has_steady, d = run->has_density;
    const bool settles = run->density.settled < run->density.to - run->density.from;
    const double value[FIGURES] = {run->duration,
                                   100 * run->overshoot,
                                   s ? run->target * (1 + run->steady.mean) : NAN,
                                   s ? 100 * run->steady.mean : NAN,
                                   s ? 100 * run->steady.rms : NAN,
                                   s ? 100 * run->steady.max : NAN,
                                   d ? 100 * run->density.max : NAN,
                                   d && settles ? run->density.settled : NAN};
    for (int i = 0; i < FIGURES; i++) to[i] = value[i];
}

static wcut_status write_control_page(page *p, const char *job_path, const char *path, wcut_error *error) {
    /* names of the figures, in the order in which list_figures fills them */
    static const char *const figure[FIGURES] = {"duration",
                                                "overshoot, whole cut",
                                                "mean tension, steady phase",
                                                "mean error, steady phase",
                                                "rms error, steady phase",
                                                "largest error, steady phase",
                                                "largest error after the density step",
                                                "settling within 5 % after it"};
    static const char *const unit[FIGURES] = {"s", "%", "N", "%", "%", "%", "%", "s"};

    /* both runs, with what was recorded */
    const wcut_rig_run *with = p->s->feedback, *plan = p->s->plan;
    const wcut_column *c = with->recording.channel, *d = plan->recording.channel;

    /* figures of both runs */
    double of_feedback[FIGURES], of_plan[FIGURES];
    list_figures(with, of_feedback);
    list_figures(plan, of_plan);
    wcut_report_span span[SPANS];
    const int spans = list_control_phases(with, span);

    /* what is drawn: tension, speed, readings, angle */
    const wcut_report_series tension[] = {rig_series(with, "with feedback", WCUT_REPORT_MARK_LINE, with->tension),
                                          rig_series(plan, "plan alone", WCUT_REPORT_MARK_LINE, plan->tension),
                                          rig_series(with, "aimed at", WCUT_REPORT_MARK_DASHED, p->target)};
    const wcut_report_series reading[] = {
        rig_series(with, "sensor A", WCUT_REPORT_MARK_LINE, c[WCUT_CHANNEL_TENSION_A].value),
        rig_series(with, "sensor B", WCUT_REPORT_MARK_LINE, c[WCUT_CHANNEL_TENSION_B].value)};
    const wcut_report_series speed[] = {
        rig_series(with, "commanded, with feedback", WCUT_REPORT_MARK_LINE, c[WCUT_CHANNEL_SPEED_COMMAND].value),
        rig_series(plan, "commanded, plan alone", WCUT_REPORT_MARK_LINE, d[WCUT_CHANNEL_SPEED_COMMAND].value),
        rig_series(with, "planned", WCUT_REPORT_MARK_DASHED, with->planned)};
    const wcut_report_series alpha[] = {rig_series(with, "with feedback", WCUT_REPORT_MARK_LINE, p->alpha[0]),
                                        rig_series(plan, "plan alone", WCUT_REPORT_MARK_DASHED, p->alpha[1])};

    /* phases are shaded in every chart */
    const wcut_report_chart charts[] = {
        control_chart("Tension, mean of both mounts", "The wire's own, without sensor noise.", "tension", "N", 3,
                      tension, spans, span),
        control_chart("Speed of mount A", NULL, "speed", "mm/s", 3, speed, spans, span),
        control_chart("What the controller reads", "Delayed, with noise.", "tension", "N", 2, reading, spans, span),
        control_chart("Angle alpha at mount A", NULL, "alpha", "deg", 2, alpha, spans, span)};

    /* the table beside the charts */
    const wcut_report_column column[] = {{"figure", NULL, NULL, figure},
                                         {"with feedback", NULL, of_feedback, NULL},
                                         {"plan alone", NULL, of_plan, NULL},
                                         {"unit", NULL, NULL, unit}};
    const wcut_report_table table = {.title = "How well the tension is held",
                                     .note = "Errors are relative to the target tension; phases are the plan's.",
                                     .rows = FIGURES,
                                     .columns = 4,
                                     .column = column};
    const wcut_report_section section = {.title = "Along the cut",
                                         .chart_count = sizeof charts / sizeof *charts,
                                         .chart = charts,
                                         .table_count = 1,
                                         .table = &table};

    /* the answer in numbers, and the settings */
    const wcut_control_settings *k = p->s->control;
    const wcut_rig_options *o = p->s->options;
    const wcut_report_fact fact[] = {{"target tension", NULL, k->tension, "N"},
                                     {"with feedback", wcut_control_state_name(with->ended), 0, ""},
                                     {"plan alone", wcut_control_state_name(plan->ended), 0, ""},
                                     {"a of the foam over a of the job", NULL, o->law_a, ""},
                                     {"b of the foam over b of the job", NULL, o->law_b, ""},
                                     {"density step, factor of a", NULL, o->density, ""},
                                     {"density step, from y", NULL, o->density_from, "mm"},
                                     {"heat", NULL, p->s->job->heat, "W/m"}};
    const wcut_report_fact option[] = {{"gain", NULL, k->gain, ""},
                                       {"integral rate", NULL, k->rate, "1/s"},
                                       {"filter", NULL, k->filter, "s"},
                                       {"period of the loop", NULL, o->period, "s"},
                                       {"delay of the readings", NULL, o->delay, "s"},
                                       {"lag of the mounts", NULL, o->lag, "s"},
                                       {"noise of the tension", NULL, o->noise_tension, "N"},
                                       {"acceleration", NULL, k->acceleration, "mm/s\xc2\xb2"},
                                       {"safe stop above", NULL, k->tension_stop, "N"},
                                       {"seed", NULL, (double)o->seed, ""}};

    /* where it came from, and the whole */
    const wcut_report_source source = {"job", job_path, p->hash[0] ? p->hash : NULL};
    const wcut_report report = {.verb = "control",
                                .title = p->s->job->name,
                                .tone = judge_control(p),
                                .verdict = p->verdict,
                                .fact_count = sizeof fact / sizeof *fact,
                                .fact = fact,
                                .section_count = 1,
                                .section = &section,
                                .source_count = 1,
                                .source = &source,
                                .option_count = sizeof option / sizeof *option,
                                .option = option};

    return wcut_report_write(&report, path, error);
}

static double *in_degrees(const wcut_rig_run *run) {
    double *to = calloc((size_t)run->recording.samples, sizeof *to);
    for (int i = 0; to && i < run->recording.samples; i++)
        to[i] = run->recording.channel[WCUT_CHANNEL_ALPHA_A].value[i] * WCUT_DEG_PER_RAD;
    return to;
}

wcut_status wcut_report_control_write(const wcut_rig_summary *summary, const char *job_path, const char *path,
                                      wcut_error *error) {
    if (!summary || !summary->job || !summary->control || !summary->options || !summary->feedback || !summary->plan ||
        !job_path || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    page p = {.s = summary};
    const int samples = summary->feedback->recording.samples;

    /* what the page shows and the summary has not */
    p.target = calloc((size_t)samples, sizeof *p.target);
    p.alpha[0] = in_degrees(summary->feedback);
    p.alpha[1] = in_degrees(summary->plan);
    wcut_status status = p.target && p.alpha[0] && p.alpha[1] ? WCUT_OK : WCUT_NO_MEMORY;
    for (int i = 0; !status && i < samples; i++) p.target[i] = summary->control->tension;

    /* the page names the job with its hash */
    if (!status) status = wcut_source_hash(job_path, p.hash, error);

    if (!status) status = write_control_page(&p, job_path, path, error);

    free(p.target);
    free(p.alpha[0]);
    free(p.alpha[1]);
    return status;
}
