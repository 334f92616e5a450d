/* A recording beside its two predictions: which of its samples count, and the scores of each channel and phase. */
#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "cut/score.h"

#define SIGNAL_ENTRY(name, text, unit, first, last) {first, last},
static const int scored_signal[WCUT_SCORED_COUNT][2] = {WCUT_SCORED_LIST(SIGNAL_ENTRY)};

wcut_comparison_options wcut_comparison_options_default(void) {
    return (wcut_comparison_options){
        .replay = wcut_replay_options_default(), .tolerance = 1e-6, .settle = 2, .leave = 1};
}

/* ---- which samples count ---- */

static bool is_cutting(wcut_phase phase) {
    return phase == WCUT_PHASE_ENTRY || phase == WCUT_PHASE_STEADY || phase == WCUT_PHASE_EXIT;
}

/* the plan's first station in contact, and the first after its last; false where it has none */
static bool find_plan_contact(const wcut_history *plan, int *contact, int *left) {
    *contact = -1;
    for (int j = 0; j < plan->stations; j++) {
        if (!is_cutting(plan->row[j].phase)) continue;
        if (*contact < 0) *contact = j;
        *left = j + 1;
    }
    return *contact >= 0;
}

/* when the recording first passes a station; its last sample's time where it does not */
static double time_at(const wcut_recording *recording, double station) {
    const wcut_column *s = &recording->channel[WCUT_CHANNEL_STATION], *t = &recording->channel[WCUT_CHANNEL_TIME];
    for (int i = 0; i < recording->samples; i++)
        if ((!s->present || s->present[i]) && s->value[i] >= station) return t->value[i];
    return t->value[recording->samples - 1];
}

static wcut_status count_samples(const wcut_history *plan, const wcut_recording *recording,
                                 const wcut_comparison_options *o, wcut_comparison *c, wcut_error *error) {
    int contact, left;
    if (!find_plan_contact(plan, &contact, &left))
        return wcut_fail(error, WCUT_DEGENERATE, "the planned run has no contact with the block: nothing to score");

    /* the planned stations of first contact and of leaving, as times of the recording */
    c->contact = time_at(recording, contact);
    c->leave = time_at(recording, left);
    c->from = c->contact + o->settle;
    c->to = c->leave - o->leave;

    /* a sample counts between settling after contact and some time before leaving, in the phases that cut */
    const wcut_column *s = &recording->channel[WCUT_CHANNEL_STATION];
    const double *time = recording->channel[WCUT_CHANNEL_TIME].value;
    int station = 0;
    for (int i = 0; i < recording->samples; i++) {
        const bool there = !s->present || s->present[i];
        if (there) station = (int)clamp(round(s->value[i]), 0, plan->stations - 1);
        c->phase[i] = plan->row[station].phase;
        c->counted[i] = there && time[i] >= c->from && time[i] <= c->to && is_cutting(c->phase[i]);
        c->counted_samples += c->counted[i];
    }

    return WCUT_OK;
}

/* ---- scores of a cut ---- */

/* the pairs of one scored channel in one part; gives how many */
static int gather_pairs(const wcut_recording *recording, const wcut_comparison *c, const wcut_prediction *p, int scored,
                        wcut_part part, double *measured, double *predicted) {
    static const wcut_phase phase_of[WCUT_PART_COUNT] = {WCUT_PHASE_APPROACH, WCUT_PHASE_ENTRY, WCUT_PHASE_STEADY,
                                                         WCUT_PHASE_EXIT};
    const int first = scored_signal[scored][0], last = scored_signal[scored][1];
    int n = 0;
    for (int k = first; k <= last; k += last > first ? last - first : 1) {
        const wcut_column *channel = &recording->channel[WCUT_CHANNEL_SPEED_A + k];
        for (int i = 0; i < c->samples; i++) {
            if (!c->counted[i] || !p->present[i] || (channel->present && !channel->present[i])) continue;
            if (part != WCUT_PART_ALL && c->phase[i] != phase_of[part]) continue;
            measured[n] = channel->value[i];
            predicted[n++] = p->value[k][i];
        }
    }
    return n;
}

static void score_prediction(const wcut_recording *recording, const wcut_comparison *c, const wcut_prediction *p,
                             double *room, wcut_scores *scores) {
    double *measured = room, *predicted = room + 2 * (size_t)c->samples;
    for (int k = 0; k < WCUT_SCORED_COUNT; k++) {
        /* the speed is what a replay was driven by */
        if (p == c->replayed && scored_signal[k][0] < 2) continue;
        wcut_score *of = scores->of[k];
        for (int part = 0; part < WCUT_PART_COUNT; part++) {
            const int n = gather_pairs(recording, c, p, k, (wcut_part)part, measured, predicted);
            of[part] = wcut_score_of(n, measured, predicted, part == WCUT_PART_ALL ? 0 : of[WCUT_PART_ALL].range);
        }
    }
}

void wcut_comparison_destroy(wcut_comparison *c) {
    if (!c) return;
    wcut_free(c->phase);
    wcut_free(c->counted);
    wcut_prediction_destroy(c->planned);
    wcut_prediction_destroy(c->replayed);
    wcut_free(c);
}

/* plan, replay and score into a comparison that holds nothing yet; `room` is 4 x samples */
static wcut_status fill_comparison(const wcut_job *job, const wcut_recording *recording,
                                   const wcut_comparison_options *o, double *room, wcut_comparison *c,
                                   wcut_error *error) {
    /* the plan: the job run by the simulator alone */
    wcut_setup *setup = NULL;
    wcut_history *plan = NULL;
    wcut_cut_options cut = wcut_cut_options_default();
    cut.tolerance = o->tolerance;
    wcut_status status = wcut_setup_create(job, &cut, &setup, error);
    if (status != WCUT_OK) return status;
    wcut_error ended = {0};
    status = wcut_setup_run(setup, NULL, NULL, &plan, &ended);
    /* a plan that ends early is one to compare with up to there */
    if (status != WCUT_OK && !(status == WCUT_NOT_CONVERGED && plan)) {
        wcut_fail(error, status, "%s", ended.text);
    } else {
        /* both predictions at the recording's samples: from the plan by station, and by a replay of the motion */
        status = wcut_prediction_plan(plan, recording, &c->planned, error);
        if (status == WCUT_OK && c->planned->failed > 0) c->planned->cause = ended;
        if (status == WCUT_OK) status = wcut_prediction_replay(setup, recording, &o->replay, &c->replayed, error);
        if (status == WCUT_OK) status = count_samples(plan, recording, o, c, error);
    }

    /* scores of both over the samples that count */
    if (status == WCUT_OK) {
        score_prediction(recording, c, c->planned, room, &c->planned_score);
        score_prediction(recording, c, c->replayed, room, &c->replayed_score);
    }

    wcut_history_destroy(plan);
    wcut_setup_destroy(setup);
    return status;
}

static bool comparison_options_are_usable(const wcut_comparison_options *o) {
    return o->settle >= 0 && isfinite(o->settle) && o->leave >= 0 && isfinite(o->leave) && is_positive(o->tolerance);
}

wcut_status wcut_comparison_create(const wcut_job *job, const wcut_recording *recording,
                                   const wcut_comparison_options *options, wcut_comparison **out, wcut_error *error) {
    const wcut_comparison_options o = options ? *options : wcut_comparison_options_default();
    if (!job || !recording || recording->samples < 1 || !recording->further || !out ||
        !comparison_options_are_usable(&o))
        return wcut_fail(
            error, WCUT_BAD_ARGUMENT,
            "a job, a recording, a place for the comparison, a positive tolerance and times of 0 s or more are "
            "expected");

    /* room for all samples */
    const size_t n = (size_t)recording->samples;
    wcut_comparison *c = wcut_alloc(1, sizeof *c);
    double *room = wcut_alloc(4 * n, sizeof *room);
    wcut_status status = WCUT_NO_MEMORY;
    if (c) {
        c->samples = recording->samples;
        c->phase = wcut_alloc(n, sizeof *c->phase);
        c->counted = wcut_alloc(n, sizeof *c->counted);
    }

    /* compare, and hand over what was made */
    if (c && room && c->phase && c->counted)
        status = fill_comparison(job, recording, &o, room, c, error);
    else
        wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d samples", recording->samples);
    wcut_free(room);
    if (status == WCUT_OK)
        *out = c;
    else
        wcut_comparison_destroy(c);

    return status;
}

wcut_status wcut_comparison_run(int n, const wcut_job *const *job, const wcut_recording *const *recording,
                                const wcut_comparison_options *options, wcut_progress progress, void *context,
                                wcut_comparison **comparison, wcut_error *error) {
    const wcut_comparison_options o = options ? *options : wcut_comparison_options_default();
    if (n < 0 || (n > 0 && (!job || !recording || !comparison || !error)) || !comparison_options_are_usable(&o))
        return WCUT_BAD_ARGUMENT;

    /* outputs are empty where a cut is missing or fails */
    int done = 0, stop = 0;
    for (int i = 0; i < n; i++) comparison[i] = NULL, error[i] = (wcut_error){0};
        /* every cut is one thread's alone, from its setup to its sums */
#pragma omp parallel for schedule(dynamic, 1)
    for (int i = 0; i < n; i++) {
        int stopped;
#pragma omp atomic read
        stopped = stop;

        /* missing cuts stay empty; after a request to stop no cut is begun */
        if (!job[i] || !recording[i]) continue;
        if (stopped) {
            wcut_fail(&error[i], WCUT_INTERRUPTED, "stopped on request");
            continue;
        }
        wcut_comparison_create(job[i], recording[i], &o, &comparison[i], &error[i]);

        /* progress is called by one thread at a time */
#pragma omp critical /* unnamed: a name would be a global of ours */
        {
            if (progress && progress(done, n, context) != 0) {
#pragma omp atomic write
                stop = 1;
            }
            done++;
        }
    }

    return stop ? WCUT_INTERRUPTED : WCUT_OK;
}
