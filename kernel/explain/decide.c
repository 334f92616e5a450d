/* The decision: one effect, two, an instrument, nothing, ambiguous, or unknown. */
#include "explain/decide.h"

#include <stddef.h>

#include "base/numbers.h"

/* A model is adequate where what it leaves over four seconds is what sensors alone leave. The whitening takes a quarter
   of the noise's variance to be slow; sensors with three times as much come to these mean squares: over all channels,
   in what both tensions share, in the worst of some thirty channels, and in a scan's patches. */
#define SLOW_MOST 2.2
#define COMMON_MOST 4.0
#define WORST_MOST 8.0
#define PATCHES_MOST 1.8

/* gains below this are within chance over the whole library: the 0.999 quantile of chi-square (2) over 200 columns, twice
   over since neighbours in time are not quite independent */
#define GAIN_LEAST 50.0
/* a scan's own registration is known by its prior alone */
#define GAIN_SCAN 60.0
/* a second effect must fall below the misfit by more than the simulator's own error makes of the first: 2 % */
#define MODEL_ERROR 0.02
/* rivals within so much of the best score explain it equally */
#define RIVAL 12.0
/* price of a coordinate in units of cost */
#define PRICE 4.0
/* of an inadequate model: the part of the slow misfit it must take away to be named all the same, and what it may leave
   at most: more, and it is the next best of what is not in the library */
#define TAKES_AWAY 0.85
#define LEAVES_MOST 2.0

static double excess(const wcut_residual_stats *left) {
    return fmax(left->slow - 1.1, 0) + fmax(left->common - 1.5, 0) / 3 + fmax(left->patches - 1.1, 0);
}

static bool is_adequate(const wcut_residual_stats *left) {
    return left->slow <= SLOW_MOST && left->common <= COMMON_MOST && left->worst <= WORST_MOST &&
           left->patches <= PATCHES_MOST;
}

/* the size of chance: slow misfit of the best of all fits, one at least */
static double chance(const wcut_search *s) {
    double least = s->left.slow;
    for (int k = 0; k < s->count; k++) least = fmin(least, s->candidate[k].left.slow);
    return clamp(least, 1, 3);
}

double wcut_candidate_score(const wcut_search *s, int candidate) {
    if (candidate < 0) return 0;
    const wcut_candidate *c = &s->candidate[candidate];
    return c->gain / chance(s) - PRICE * c->fit.count;
}

static bool moves_scans_alone(const wcut_candidate *c) {
    for (int k = 0; k < c->fit.model.effects; k++) {
        const wcut_effect_place place = wcut_effect_view(c->fit.model.effect[k].kind)->place;
        if (place == WCUT_EFFECT_PLACE_STEP || place == WCUT_EFFECT_PLACE_SENSOR) return false;
    }
    return true;
}

/* every strength two standard errors off its neutral; a shape beside it widens them, and the gain speaks for both */
static bool is_significant(const wcut_candidate *c, double allowance) {
    for (int e = 0; e < c->fit.model.effects; e++) {
        double best = 0;
        const wcut_effect *effect = &c->fit.model.effect[e];
        const int strengths = wcut_effect_view(effect->kind)->strengths;
        for (int k = 0, nth = 0; k < c->fit.count; k++) {
            if (c->fit.effect_of[k] != e || nth++ >= strengths) continue;
            const double neutral = c->fit.coordinate[k].at == 0 ? wcut_explanation_neutral(effect->kind) : 0;
            best = fmax(best, fabs(c->fit.x[WCUT_BASE + k] - neutral) / c->fit.error[WCUT_BASE + k]);
        }
        if (best < 2 * allowance) return false;
    }
    return true;
}

/* a spot as wide as the block is no spot: whatever is fitted must stay inside the range it is plausible in */
static bool runs_out(const wcut_candidate *c) {
    for (int k = 0; k < c->fit.count; k++) {
        const wcut_coordinate *q = &c->fit.coordinate[k];
        const double x = c->fit.x[WCUT_BASE + k], wide = 1e-6 * (q->high - q->low);
        if (x < q->low + wide || x > q->high - wide) return true;
    }
    return false;
}

static bool may_be_named(const wcut_search *s, int candidate) {
    const wcut_candidate *c = &s->candidate[candidate];
    const double gain = c->gain / chance(s);
    if (c->second_size < 1 || !is_significant(c, sqrt(chance(s))) || runs_out(c)) return false;
    if (moves_scans_alone(c)) return gain > GAIN_SCAN;
    return gain > GAIN_LEAST && c->held_out > 0 && 2 * c->better > c->judged;
}

static int best_of(const wcut_search *s, int effects) {
    int best = -1;
    for (int k = 0; k < s->count; k++)
        if (s->candidate[k].effects == effects && may_be_named(s, k) &&
            (best < 0 || wcut_candidate_score(s, k) > wcut_candidate_score(s, best)))
            best = k;
    return best;
}

/* whether a pair says more than its better half */
static bool second_counts(const wcut_search *s, int pair, int single) {
    if (single < 0) return true;
    const double first = s->candidate[single].gain / chance(s);
    return wcut_candidate_score(s, pair) - wcut_candidate_score(s, single) > fmax(GAIN_LEAST, MODEL_ERROR * first);
}

static wcut_verdict_kind kind_of(const wcut_model *m) {
    bool physics = false, instrument = false;
    for (int k = 0; k < m->effects; k++) {
        const bool fault = wcut_explanation_view(m->effect[k].kind)->instrument;
        physics = physics || !fault, instrument = instrument || fault;
    }
    return physics && instrument ? WCUT_VERDICT_BOTH : physics ? WCUT_VERDICT_PHYSICS : WCUT_VERDICT_INSTRUMENT;
}

static bool same_kinds(const wcut_model *a, const wcut_model *b) {
    if (a->effects != b->effects) return false;
    for (int i = 0; i < a->effects; i++) {
        bool found = false;
        for (int j = 0; j < b->effects; j++) found = found || a->effect[i].kind == b->effect[j].kind;
        if (!found) return false;
    }
    return true;
}

static void list_rivals(const wcut_search *s, wcut_decision *d) {
    const wcut_candidate *best = &s->candidate[d->chosen];
    d->rival[d->rivals++] = d->chosen;
    for (int k = 0; k < s->count && d->rivals < WCUT_RIVALS; k++) {
        const wcut_candidate *c = &s->candidate[k];
        if (k == d->chosen || c->effects != best->effects || !may_be_named(s, k)) continue;
        bool listed = false;
        for (int r = 0; r < d->rivals; r++)
            listed = listed || same_kinds(&c->fit.model, &s->candidate[d->rival[r]].fit.model);
        const double behind = wcut_candidate_score(s, d->chosen) - wcut_candidate_score(s, k);
        if (!listed && behind < RIVAL + 0.01 * best->gain / chance(s)) d->rival[d->rivals++] = k;
    }
}

const char *wcut_candidate_why(const wcut_search *s, const wcut_decision *d, int candidate) {
    const bool named = d->kind != WCUT_VERDICT_NONE && d->kind != WCUT_VERDICT_UNKNOWN;
    if (candidate < 0) return d->kind == WCUT_VERDICT_NONE ? "" : "leaves a misfit that is not noise";
    if (named && candidate == d->chosen) return "";
    for (int r = 0; named && r < d->rivals; r++)
        if (candidate == d->rival[r]) return "explains as much as the first";
    const wcut_candidate *c = &s->candidate[candidate];
    if (c->second_size < 1) return c->effects > 1 ? "one of the two is too small to matter" : "too small to matter";
    if (!is_significant(c, sqrt(chance(s)))) return "not told from nothing";
    if (!may_be_named(s, candidate))
        return c->gain / chance(s) > GAIN_LEAST ? "does not hold on cuts that were not fitted" : "no more than chance";
    if (!is_adequate(&c->left)) return "leaves a misfit that is not noise";
    return c->effects > 1 ? "its second effect is not needed" : "explains less";
}

/* How often verdicts of a kind were right on the labelled cases, each left out in turn, as (hits + 1) / (cases + 2); less
   where the best explanation is not far from the next or hardly beyond chance. */
static double confidence(const wcut_search *s, const wcut_decision *d) {
    if (d->kind == WCUT_VERDICT_UNKNOWN) return d->adequacy > 2 * SLOW_MOST ? 0.9 : 0.8;
    if (d->kind == WCUT_VERDICT_AMBIGUOUS) return 0.5;
    if (d->kind == WCUT_VERDICT_NONE) {
        double most = 0;
        for (int k = 0; k < s->count; k++)
            if (s->candidate[k].second_size >= 1) most = fmax(most, wcut_candidate_score(s, k));
        return most > GAIN_LEAST / 4 ? 0.7 : 0.8;
    }
    const wcut_candidate *best = &s->candidate[d->chosen];
    double next = 0;
    for (int k = 0; k < s->count; k++) {
        const wcut_candidate *c = &s->candidate[k];
        if (k != d->chosen && c->effects == best->effects && !same_kinds(&c->fit.model, &best->fit.model))
            next = fmax(next, wcut_candidate_score(s, k));
    }
    const double ahead = wcut_candidate_score(s, d->chosen) - next;
    if (!is_adequate(&best->left)) return 0.7;
    return ahead > 3 * RIVAL + 0.03 * best->gain / chance(s) ? 0.97 : 0.8;
}

wcut_decision wcut_search_decide(const wcut_search *s) {
    wcut_decision d = {.kind = WCUT_VERDICT_NONE, .chosen = -1, .adequacy = s->left.slow};
    const int single = best_of(s, 1), pair = best_of(s, 2);
    d.chosen = single;
    if (pair >= 0 && second_counts(s, pair, single)) d.chosen = pair;
    if (d.chosen < 0) {
        if (!is_adequate(&s->left)) d.kind = WCUT_VERDICT_UNKNOWN;
        d.confidence = confidence(s, &d);
        return d;
    }
    const wcut_candidate *best = &s->candidate[d.chosen];
    d.adequacy = best->left.slow;
    if (!is_adequate(&best->left) &&
        (excess(&best->left) > (1 - TAKES_AWAY) * excess(&s->left) || best->left.slow > LEAVES_MOST * SLOW_MOST)) {
        d.kind = WCUT_VERDICT_UNKNOWN;
        d.confidence = confidence(s, &d);
        return d;
    }
    d.kind = kind_of(&best->fit.model);
    list_rivals(s, &d);
    if (d.rivals > 1) d.kind = WCUT_VERDICT_AMBIGUOUS;
    d.confidence = confidence(s, &d);
    return d;
}
