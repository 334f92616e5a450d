/* The page of recordings beside their predictions: scores by channel, phase and cut, then every channel over time. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"
#include "io/report/page_memory.h"

enum {
    CHARTS = 8,
    SPANS_MAX = 64,
    FIGURES = 8,      /* numbers in a row of a table of scores */
    PLOTTED_MAX = 24, /* cuts: beyond them a page is slow to open */
    PLOTTED_BYTES = 18000000
};

/* how much of the page a sample of a cut takes: its columns as base64 of doubles */
#define BYTES_A_SAMPLE (42 * 8 * 4 / 3)

typedef struct page {
    const wcut_report_score *of;
    wcut_page_memory memory;
} page;

static char *join_score(page *p, const char *a, const char *between, const char *b) {
    const size_t size = strlen(a) + strlen(between) + strlen(b) + 1;
    char *text = wcut_page_take(&p->memory, size, 1);
    if (text) snprintf(text, size, "%s%s%s", a, between, b);
    return text;
}

/* "case, cut", or the cut alone */
static const char *scored_cut_name(page *p, const wcut_scored_cut *cut) {
    return cut->of_case ? join_score(p, cut->of_case, ", ", cut->name) : cut->name;
}

static double score_larger(double a, double b) { return a > b ? a : b; }

static double unit_of(int scored) {
    return strcmp(wcut_scored_unit((wcut_scored)scored), "deg") ? 1 : WCUT_DEG_PER_RAD;
}

/* ---- tables ---- */

static double or_dash(bool there, double value) { return there ? value : NAN; }

/* a table of scores: a row a channel, the phases' NRMSD at the end */
static wcut_report_table channel_table(page *p, const char *title, const char *note, const wcut_scores *scores) {
    /* columns: channel, unit, figures */
    static const char *const label[FIGURES] = {"RMSD",        "NRMSD",       "RMSE / range", "bias",
                                               "correlation", "entry NRMSD", "steady NRMSD", "exit NRMSD"};
    wcut_report_column *column = wcut_page_take(&p->memory, FIGURES + 2, sizeof *column);
    const char **name = wcut_page_take(&p->memory, WCUT_SCORED_COUNT, sizeof *name),
               **unit = wcut_page_take(&p->memory, WCUT_SCORED_COUNT, sizeof *unit);
    double *number = wcut_page_take(&p->memory, (size_t)FIGURES * WCUT_SCORED_COUNT, sizeof *number);
    wcut_report_table table = {.title = title, .note = note, .columns = FIGURES + 2, .column = column};
    if (!column || !name || !unit || !number) return table;

    /* a row for each channel that was scored */
    for (int k = 0; k < WCUT_SCORED_COUNT; k++) {
        const wcut_score *s = scores->of[k], *all = s;
        if (all->count < 1) continue;
        const double figure[FIGURES] = {all->rmsd * unit_of(k),
                                        or_dash(all->range > 0, all->nrmsd),
                                        or_dash(all->range > 0, all->rmse_over_range),
                                        all->bias * unit_of(k),
                                        or_dash(all->correlated, all->correlation),
                                        or_dash(s[WCUT_PART_ENTRY].range > 0, s[WCUT_PART_ENTRY].nrmsd),
                                        or_dash(s[WCUT_PART_STEADY].range > 0, s[WCUT_PART_STEADY].nrmsd),
                                        or_dash(s[WCUT_PART_EXIT].range > 0, s[WCUT_PART_EXIT].nrmsd)};
        name[table.rows] = wcut_scored_name((wcut_scored)k);
        unit[table.rows] = wcut_scored_unit((wcut_scored)k);
        for (int f = 0; f < FIGURES; f++) number[f * WCUT_SCORED_COUNT + table.rows] = figure[f];
        table.rows++;
    }

    /* names and units, then the figures */
    column[0] = (wcut_report_column){.label = "channel", .text = name};
    column[1] = (wcut_report_column){.label = "unit", .text = unit};
    for (int f = 0; f < FIGURES; f++)
        column[f + 2] = (wcut_report_column){.label = label[f], .number = number + (size_t)f * WCUT_SCORED_COUNT};

    return table;
}

/* the columns of the table by case or cut: both mounts together */
typedef struct group_column {
    const char *label;
    bool replayed;
    wcut_scored scored;
} group_column;

static const group_column by_group[] = {
    {"planned speed", false, WCUT_SCORED_SPEED},     {"planned tension", false, WCUT_SCORED_TENSION},
    {"planned alpha", false, WCUT_SCORED_ALPHA},     {"planned beta", false, WCUT_SCORED_BETA},
    {"replayed tension", true, WCUT_SCORED_TENSION}, {"replayed alpha", true, WCUT_SCORED_ALPHA},
    {"replayed beta", true, WCUT_SCORED_BETA}};
enum { BY_GROUP = sizeof by_group / sizeof *by_group };

static wcut_report_table group_table(page *p, const char *title, const char *note, bool with_bias) {
    const wcut_report_score *of = p->of;

    /* a row for each case or cut */
    wcut_report_column *column = wcut_page_take(&p->memory, BY_GROUP + 1, sizeof *column);
    double *number = wcut_page_take(&p->memory, (size_t)BY_GROUP * (size_t)of->groups, sizeof *number);
    wcut_report_table table = {
        .title = title, .note = note, .rows = of->groups, .columns = BY_GROUP + 1, .column = column};
    if (!column || !number) return table;

    /* names first, then a column for each prediction */
    column[0] = (wcut_report_column){.label = of->group_label, .text = of->group_name};
    for (int c = 0; c < BY_GROUP; c++) {
        double *to = number + (size_t)c * (size_t)of->groups;
        const wcut_scores *scores = by_group[c].replayed ? of->replayed : of->planned;
        for (int g = 0; g < of->groups; g++) {
            const wcut_score *s = &scores[g].of[by_group[c].scored][WCUT_PART_ALL];
            to[g] = or_dash(s->range > 0, with_bias ? s->rmse_over_range : s->nrmsd);
        }
        column[c + 1] = (wcut_report_column){.label = by_group[c].label, .number = to};
    }

    return table;
}

/* cuts that could not be scored, and samples that were not predicted */
static wcut_report_table trouble_table(page *p) {
    const wcut_report_score *of = p->of;

    /* columns: cut and reason */
    wcut_report_column *column = wcut_page_take(&p->memory, 2, sizeof *column);
    const char **name = wcut_page_take(&p->memory, (size_t)of->cuts, sizeof *name),
               **text = wcut_page_take(&p->memory, (size_t)of->cuts, sizeof *text);
    wcut_report_table table = {.title = "What was not scored", .columns = 2, .column = column};
    if (!column || !name || !text) return table;

    /* only the cuts of which something is missing */
    for (int i = 0; i < of->cuts; i++) {
        const wcut_scored_cut *cut = &of->cut[i];

        /* samples that were not predicted, by cause; a cut without any is not listed */
        char said[200] = "";
        if (cut->comparison) {
            const wcut_prediction *plan = cut->comparison->planned, *replay = cut->comparison->replayed;
            if (plan->failed + replay->failed + replay->without_motion + replay->standing == 0) continue;
            snprintf(said, sizeof said,
                     "%d samples without motion, %d standing; not reached by the plan: %d, by the replay: %d",
                     replay->without_motion, replay->standing, plan->failed, replay->failed);
        }
        name[table.rows] = scored_cut_name(p, cut);
        text[table.rows++] = cut->comparison ? join_score(p, said, "", "") : cut->error ? cut->error->text : "";
    }

    /* two columns: which cut, and why */
    column[0] = (wcut_report_column){.label = "cut", .text = name};
    column[1] = (wcut_report_column){.label = "why", .text = text};

    return table;
}

/* ---- charts ---- */

/* The samples of a cut that are drawn: from the first contact to the last that counts. Before and behind, the plan
   feeds at the highest speed and the wire whips out of the foam: the rest would shrink to a line. */
typedef struct drawn {
    int first, count;
    const double *time, *station; /* count */
} drawn;

static drawn choose_samples(const wcut_scored_cut *cut) {
    const wcut_comparison *c = cut->comparison;
    const double *time = cut->samples->channel[WCUT_CHANNEL_TIME].value;
    int first = 0, end = c->samples;

    /* from half of the time to settle to the last sample that counts */
    while (first < c->samples && time[first] < (c->contact + c->from) / 2) first++;
    while (end > first && time[end - 1] > c->to) end--;
    return end - first > 1 ? (drawn){.first = first, .count = end - first} : (drawn){.first = 0, .count = c->samples};
}

/* runs of drawn samples of one phase */
static int list_score_phases(const wcut_comparison *c, const drawn *d, wcut_report_span *span) {
    const wcut_phase *phase = c->phase + d->first;
    int count = 0;
    for (int i = 0, from = 0; i < d->count && count < SPANS_MAX; i++) {
        if (i + 1 < d->count && phase[i + 1] == phase[from]) continue;
        const int to = i + 1 < d->count ? i + 1 : i;
        span[count++] = (wcut_report_span){
            wcut_phase_name(phase[from]), {d->time[from], d->station[from]}, {d->time[to], d->station[to]}};
        from = i + 1;
    }
    return count;
}

/* a prediction with a band of two RMSE to either side */
static void fill_score_series(page *p, const wcut_comparison *c, const wcut_prediction *from, const wcut_scores *scores,
                              int k, const drawn *d, wcut_report_series *to) {
    static const wcut_scored of_signal[WCUT_SIGNAL_COUNT] = {
        WCUT_SCORED_SPEED_A, WCUT_SCORED_SPEED_B, WCUT_SCORED_TENSION_A, WCUT_SCORED_TENSION_B,
        WCUT_SCORED_ALPHA_A, WCUT_SCORED_BETA_A,  WCUT_SCORED_ALPHA_B,   WCUT_SCORED_BETA_B};

    /* the band is drawn where the score has samples */
    const wcut_score *score = scores ? &scores->of[of_signal[k]][WCUT_PART_ALL] : NULL;
    const bool band = score && score->count > 0;

    /* speeds and tensions keep their unit, angles become deg */
    const double unit = k < 4 ? 1 : WCUT_DEG_PER_RAD;
    double *y = wcut_page_take(&p->memory, (size_t)d->count, sizeof *y);
    double *low = band ? wcut_page_take(&p->memory, (size_t)d->count, sizeof *low) : NULL;
    double *high = band ? wcut_page_take(&p->memory, (size_t)d->count, sizeof *high) : NULL;
    if (p->memory.failed) return;

    /* missing where nothing was predicted; the band where the score counts */
    for (int i = 0; i < d->count; i++) {
        const int sample = d->first + i;
        y[i] = from->present[sample] ? from->value[k][sample] * unit : NAN;
        if (!band) continue;
        low[i] = c->counted[sample] ? y[i] - 2 * score->rmse * unit : NAN;
        high[i] = c->counted[sample] ? y[i] + 2 * score->rmse * unit : NAN;
    }

    to->y = y, to->low = low, to->high = high;
}

static void fill_score_chart(page *p, const wcut_scored_cut *cut, int k, const drawn *d, int spans,
                             const wcut_report_span *span, wcut_report_chart *chart) {
    static const char *const title[WCUT_SIGNAL_COUNT] = {"Speed, mount A",   "Speed, mount B", "Tension, mount A",
                                                         "Tension, mount B", "Alpha, mount A", "Beta, mount A",
                                                         "Alpha, mount B",   "Beta, mount B"};
    static const char *const label[WCUT_SIGNAL_COUNT] = {"speed", "speed", "tension", "tension",
                                                         "alpha", "beta",  "alpha",   "beta"};

    /* a speed is planned, but not replayed */
    const wcut_comparison *c = cut->comparison;
    const wcut_column *channel = &cut->samples->channel[WCUT_CHANNEL_SPEED_A + k];
    const bool replayed = k >= 2;
    wcut_report_series *series = wcut_page_take(&p->memory, 3, sizeof *series);
    double *measured = wcut_page_take(&p->memory, (size_t)d->count, sizeof *measured);
    if (p->memory.failed) return;

    /* what was measured, in the units of files */
    for (int i = 0; i < d->count; i++) {
        const int sample = d->first + i;
        const bool there = !channel->present || channel->present[sample];
        measured[i] = there ? channel->value[sample] * (k < 4 ? 1 : WCUT_DEG_PER_RAD) : NAN;
    }

    /* the series over the same abscissae; a speed is not replayed */
    for (int s = 0; s < 3; s++) series[s] = (wcut_report_series){.count = d->count, .x = {d->time, d->station}};
    series[0].label = "measured", series[0].mark = WCUT_REPORT_MARK_LINE, series[0].y = measured;
    series[1].label = "planned", series[1].mark = WCUT_REPORT_MARK_DASHED;
    series[2].label = "replayed", series[2].mark = WCUT_REPORT_MARK_LINE;
    fill_score_series(p, c, c->planned, replayed ? NULL : &c->planned_score, k, d, &series[1]);
    if (replayed) fill_score_series(p, c, c->replayed, &c->replayed_score, k, d, &series[2]);

    /* two abscissae, and the unit of files */
    *chart = (wcut_report_chart){.title = title[k],
                                 .x_label = {"time", "station"},
                                 .x_unit = {"s", ""},
                                 .y_label = label[k],
                                 .y_unit = k < 2   ? "mm/s"
                                           : k < 4 ? "N"
                                                   : "deg",
                                 .series_count = replayed ? 3 : 2,
                                 .series = series,
                                 .span_count = spans,
                                 .span = span};
}

/* a cut: its channels over time, and its own scores */
static void fill_score_section(page *p, const wcut_scored_cut *cut, wcut_report_section *section) {
    static const int order[CHARTS] = {0, 1, 2, 3, 4, 6, 5, 7};

    /* arrays of the page */
    const wcut_comparison *c = cut->comparison;
    const wcut_column *recorded = &cut->samples->channel[WCUT_CHANNEL_STATION];
    wcut_report_chart *chart = wcut_page_take(&p->memory, CHARTS, sizeof *chart);
    wcut_report_table *table = wcut_page_take(&p->memory, 2, sizeof *table);
    wcut_report_span *span = wcut_page_take(&p->memory, SPANS_MAX, sizeof *span);
    drawn d = choose_samples(cut);
    double *time = wcut_page_take(&p->memory, (size_t)d.count, sizeof *time),
           *station = wcut_page_take(&p->memory, (size_t)d.count, sizeof *station);
    char *note = wcut_page_take(&p->memory, 300, 1);
    if (p->memory.failed) return;

    /* the abscissae of what is drawn */
    for (int i = 0; i < d.count; i++) {
        const int sample = d.first + i;
        const bool there = !recorded->present || recorded->present[sample];
        time[i] = cut->samples->channel[WCUT_CHANNEL_TIME].value[sample];
        /* lines go forward, whatever the encoder's noise */
        station[i] = score_larger(i ? station[i - 1] : 0, there ? recorded->value[sample] : 0);
    }
    d.time = time, d.station = station;

    /* a chart for each channel, then what the scores rest on */
    const int spans = list_score_phases(c, &d, span);
    for (int k = 0; k < CHARTS; k++) fill_score_chart(p, cut, order[k], &d, spans, span, &chart[k]);
    snprintf(note, 300,
             "Scored from %.1f s to %.1f s, %d of %d samples; half of the settling time before it is shown. The band "
             "is two RMSE to either side of the replayed prediction, for speeds of the planned one.",
             c->from, c->to, c->counted_samples, c->samples);
    table[0] = channel_table(p, "Replayed", NULL, &c->replayed_score);
    table[1] = channel_table(p, "Planned", NULL, &c->planned_score);

    /* the section of this cut */
    *section = (wcut_report_section){.title = scored_cut_name(p, cut),
                                     .note = note,
                                     .chart_count = CHARTS,
                                     .chart = chart,
                                     .table_count = 2,
                                     .table = table};
}

/* how badly a cut fits, to show the worst where not all can be shown */
static double badness(const wcut_comparison *c) {
    double worst = 0;
    if (!c) return -1;
    for (int k = WCUT_SCORED_TENSION; k <= WCUT_SCORED_BETA; k++)
        worst = score_larger(worst, c->replayed_score.of[k][WCUT_PART_ALL].rmse_over_range);
    return worst;
}

/* which cuts are shown: 1 in `shown`; gives how many */
static int choose_score(const wcut_report_score *of, unsigned char *shown) {
    size_t bytes = 0;
    int count = 0;
    for (;;) {
        int worst = -1;
        for (int i = 0; i < of->cuts; i++)
            if (of->cut[i].comparison && !shown[i] &&
                (worst < 0 || badness(of->cut[i].comparison) > badness(of->cut[worst].comparison)))
                worst = i;
        if (worst < 0 || count >= PLOTTED_MAX) return count;
        bytes += (size_t)of->cut[worst].comparison->samples * BYTES_A_SAMPLE;
        if (bytes > PLOTTED_BYTES) return count;
        shown[worst] = 1;
        count++;
    }
}

/* ---- the page ---- */

static void fill_overview(page *p, const char *note, wcut_report_section *section) {
    const wcut_report_score *of = p->of;
    wcut_report_table *table = wcut_page_take(&p->memory, 5, sizeof *table);
    if (p->memory.failed) return;
    table[0] = group_table(p, "NRMSD", "RMSD over the range of the measured data: excludes a bias.", false);
    table[1] = group_table(p, "RMSE over range", "Includes a bias.", true);
    table[2] = channel_table(p, "Replayed: mean over the cuts", "The speed is an input of the replay.",
                             &of->replayed[of->groups]);
    table[3] = channel_table(p, "Planned: mean over the cuts", NULL, &of->planned[of->groups]);
    table[4] = trouble_table(p);
    *section = (wcut_report_section){
        .title = "Scores", .note = note, .table_count = table[4].rows > 0 ? 5 : 4, .table = table};
}

static wcut_status write_score_page(page *p, int compared, int shown, int sections, const wcut_report_section *section,
                                    const char *path, wcut_error *error) {
    const wcut_report_score *of = p->of;

    /* the means over all cuts stand behind those of the groups */
    const wcut_scores *planned = &of->planned[of->groups], *replayed = &of->replayed[of->groups];

    /* the verdict and the counts in words */
    char verdict[400], count[64], plots[64];
    snprintf(verdict, sizeof verdict,
             "Mean NRMSD of %d cuts: planned speed %.1f %%; replayed tension %.1f %%, alpha %.1f %%, beta %.1f %%.%s",
             compared, 100 * planned->of[WCUT_SCORED_SPEED][0].nrmsd, 100 * replayed->of[WCUT_SCORED_TENSION][0].nrmsd,
             100 * replayed->of[WCUT_SCORED_ALPHA][0].nrmsd, 100 * replayed->of[WCUT_SCORED_BETA][0].nrmsd,
             compared < of->cuts ? " Some cuts could not be scored." : "");
    snprintf(count, sizeof count, "%d of %d", compared, of->cuts);
    snprintf(plots, sizeof plots, "%d of %d%s", shown, compared, shown < compared ? ", those that fit worst" : "");

    /* facts of all cuts together, and the options they were made with */
    const wcut_comparison_options *o = of->options;
    const wcut_report_fact fact[] = {
        {"cuts scored", count, 0, ""},
        {"cuts plotted", plots, 0, ""},
        {"planned speed, RMSD", NULL, planned->of[WCUT_SCORED_SPEED][0].rmsd, "mm/s"},
        {"replayed tension, RMSD", NULL, replayed->of[WCUT_SCORED_TENSION][0].rmsd, "N"},
        {"replayed alpha, RMSD", NULL, replayed->of[WCUT_SCORED_ALPHA][0].rmsd * WCUT_DEG_PER_RAD, "deg"},
        {"replayed beta, RMSD", NULL, replayed->of[WCUT_SCORED_BETA][0].rmsd * WCUT_DEG_PER_RAD, "deg"}};
    const wcut_report_fact option[] = {
        {"motion from", o->replay.motion == WCUT_MOTION_POSITION ? "measured positions" : "station", 0, ""},
        {"window of smoothing", NULL, o->replay.window, "s"},
        {"left out after the first contact", NULL, o->settle, "s"},
        {"left out before the end", NULL, o->leave, "s"},
        {"nodes along the wire", of->nodes > 0 ? NULL : "as in the jobs", of->nodes, ""}};

    /* the whole page; a cut that could not be scored makes it a warning */
    const wcut_report report = {.verb = "score",
                                .title = of->title,
                                .tone = compared < of->cuts ? WCUT_REPORT_TONE_WARNING : WCUT_REPORT_TONE_PLAIN,
                                .verdict = verdict,
                                .fact_count = sizeof fact / sizeof *fact,
                                .fact = fact,
                                .section_count = sections,
                                .section = section,
                                .source_count = of->sources,
                                .source = of->source,
                                .option_count = sizeof option / sizeof *option,
                                .option = option};

    return wcut_report_write(&report, path, error);
}

wcut_status wcut_report_score_write(const wcut_report_score *scored, const char *path, wcut_error *error) {
    if (!scored || scored->cuts < 1 || !scored->cut || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    page p = {.of = scored};

    /* the cuts that are plotted */
    int compared = 0, shown = 0, sections = 1;
    for (int i = 0; i < scored->cuts; i++) compared += scored->cut[i].comparison != NULL;
    unsigned char *chosen = wcut_page_take(&p.memory, (size_t)scored->cuts, 1);
    if (chosen) shown = choose_score(scored, chosen);
    wcut_report_section *section = wcut_page_take(&p.memory, (size_t)shown + 1, sizeof *section);

    /* an overview of all, then a section for each of those */
    char note[200] = "";
    if (shown < compared)
        snprintf(note, sizeof note, "Below are the %d cuts that fit worst; residuals.csv holds them all.", shown);
    if (section) fill_overview(&p, note, section);
    for (int i = 0; !p.memory.failed && chosen && section && i < scored->cuts; i++)
        if (chosen[i]) fill_score_section(&p, &scored->cut[i], &section[sections++]);

    /* written last, so that a page is whole or not there */
    const wcut_status status =
        p.memory.failed ? WCUT_NO_MEMORY : write_score_page(&p, compared, shown, sections, section, path, error);

    wcut_page_free(&p.memory);
    return status;
}
