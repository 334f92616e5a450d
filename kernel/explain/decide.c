/* The decision: one effect, two, an instrument, nothing, ambiguous, or unknown. */
#include "explain/decide.h"

#include <stddef.h>

#include "base/numbers.h"
#include "explain/confidence.h"

/* A model is adequate where what it leaves over four seconds is what noise and the scatter of a rig leave: over all channels,
   in what both tensions share (mounts beside their path move both), in the worst of some thirty channels, in a scan's
   patches, and in the largest single window of four seconds of some two thousand. Nulls of the second laboratory leave 1.7,
   4.2, 5.6, 1.9, 17 at most. */
#define SLOW_MAX 2.2
#define COMMON_MAX 5.0
#define WORST_MAX 8.0
#define PATCHES_MAX 2.2
#define PEAK_MAX 35.0

/* gains below this are within chance over the whole library: the 0.999 quantile of chi-square (2) over 200 columns; and what
   the simulator's own error gains, which grows with the cuts up to so many rows, when nulls of the labelled cases reach 57 */
#define GAIN_CHANCE 25.0
#define GAIN_ERROR 35.0
#define GAIN_ERROR_ROWS 4000.0
/* what is below its gate of practical size is named only where it cannot be the simulator's own error */
#define GAIN_SMALL 300.0
/* a gain of candidates that may not be named, beyond which something is there all the same; nulls reach 102 */
#define GAIN_UNTOLD 150.0
/* the same of the whole library at once, some sixty columns; nulls reach 702 */
#define GAIN_TOGETHER 800.0
/* misfit over rows under the noise that all share, beyond which scatter may stand for an effect */
#define MISFIT_LARGE 1.15
/* what moves scans alone: a shift that all scans have in common against one of each */
#define GAIN_SCAN 25.0
/* of the fall of the misfit, the part that cuts which were not fitted must show: right names show 0.94 and more, an
   impostor that takes what belongs to another shows a tenth */
#define HELD_OUT_MIN 0.5
/* a second effect must fall below the misfit by more than the simulator's own error makes of the first: 2 % */
#define MODEL_ERROR 0.02
/* a second effect on the force takes what another form of the first leaves: up to 15 % of what the first
   explains where the first was alone, 25 % and more where there are two */
#define FORM_ERROR 0.2
/* rivals within so much of the best score explain it equally */
#define RIVAL 12.0
/* a pair of which neither is named alone, and the part of the misfit beyond noise that it must take */
#define GAIN_PAIR 100.0
#define PAIR_TAKES 0.7
/* the part of what the first leaves beyond noise that a second must take: on the force, where what is left may be another
   form of the first; on sensors and scans */
#define SECOND_TAKES 0.55
#define SENSOR_TAKES 0.3
/* of the bounds of the scatter */
#define PLAUSIBLE 0.95
/* [s] late readings beside which nothing is wrong */
#define DELAY_MAX 1.0
/* price of a coordinate in units of cost */
#define PRICE 4.0
/* an effect of another form: the part of the misfit beyond noise that it takes, and how far it leads the next kind */
#define FORM_TAKES 0.5
/* a value at its bound is a form that is not the library's: it must take this part all the same */
#define BOUND_TAKES 0.85
#define FORM_LEADS 1.3

/* whether the scatter of a fit is that of a rig: not at the end of what blocks, wires and sensors differ by */
static bool scatter_is_plausible(const wcut_fitted *f) {
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++)
        if (f->noise.scatter[k] > PLAUSIBLE * wcut_scatter_view(&f->noise, (wcut_scatter_kind)k)->max) return false;
    return true;
}

/* whether what is left of the recordings, the scans aside, is noise */
static bool recordings_are_noise(const wcut_residual_stats *left) {
    return left->slow <= SLOW_MAX && left->common <= COMMON_MAX && left->worst <= WORST_MAX && left->peak <= PEAK_MAX;
}

bool wcut_residual_is_noise(const wcut_fitted *f, const wcut_residual_stats *left) {
    return recordings_are_noise(left) && left->patches <= PATCHES_MAX && scatter_is_plausible(f);
}

/* the least gain of what may be named */
static double gain_min(const wcut_search *s) { return GAIN_CHANCE + GAIN_ERROR * fmin(s->rows / GAIN_ERROR_ROWS, 1); }

/* whether recalibration, with the delay of late readings, leaves noise and scatter alone */
static bool is_null(const wcut_search *s) { return wcut_residual_is_noise(wcut_search_base(s), &s->left); }

bool wcut_search_explains_delay(const wcut_search *s, int candidate) {
    const wcut_candidate *c = &s->candidate[candidate];
    const wcut_effect *delay = &c->fit.model.effect[c->fit.model.effects - 1];
    return delay->value[0] < DELAY_MAX && wcut_effect_size(delay) >= 1 && c->gain > -GAIN_CHANCE &&
           wcut_residual_is_noise(&c->fit, &c->left);
}

bool wcut_search_leaves_noise(const wcut_search *s, int candidate) {
    return wcut_residual_is_noise(&s->candidate[candidate].fit, &s->candidate[candidate].left);
}

double wcut_candidate_score(const wcut_search *s, int candidate) {
    if (candidate < 0) return 0;
    const wcut_candidate *c = &s->candidate[candidate];
    return c->gain - PRICE * (c->fit.count - wcut_search_base(s)->count);
}

static bool moves_scans_alone(const wcut_candidate *c, int from) {
    for (int k = from; k < c->fit.model.effects; k++) {
        const wcut_effect_place place = wcut_effect_view(c->fit.model.effect[k].kind)->place;
        if (place == WCUT_EFFECT_PLACE_STEP || place == WCUT_EFFECT_PLACE_SENSOR) return false;
    }
    return true;
}

/* every strength two standard errors off its neutral; a shape beside it widens them, and the gain speaks for both */
static bool is_significant(const wcut_candidate *c, int from) {
    for (int e = from; e < c->fit.model.effects; e++) {
        double best = 0;
        const wcut_effect *effect = &c->fit.model.effect[e];
        const int strengths = wcut_effect_view(effect->kind)->strengths;
        for (int k = 0, nth = 0; k < c->fit.count; k++) {
            if (c->fit.effect_of[k] != e || nth++ >= strengths) continue;
            const double neutral = c->fit.coordinate[k].at == 0 ? wcut_explanation_neutral(effect->kind) : 0;
            best = fmax(best, fabs(c->fit.x[WCUT_BASE + k] - neutral) / c->fit.error[WCUT_BASE + k]);
        }
        if (best < 2) return false;
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

/* what the whole library at once would gain over what candidates are held against */
static double all_that_is_told(const wcut_search *s) {
    return s->saturated - (s->none.cost - wcut_search_base(s)->cost);
}

/* Whether it gains half of what the whole library at once does, or takes half of the misfit under the noise that all share,
   where there is one: a sensor's fault gains little where its zeros may scatter. Less is the next best of what is not in
   the library. */
static bool takes_most(const wcut_search *s, int candidate) {
    const wcut_candidate *c = &s->candidate[candidate];
    const double misfit = wcut_search_base(s)->misfit;
    return c->gain >= FORM_TAKES * all_that_is_told(s) ||
           (misfit > MISFIT_LARGE * s->rows && c->fall >= FORM_TAKES * (misfit - s->rows));
}

/* why a candidate cannot be named; NULL where it can */
static const char *objection(const wcut_search *s, int candidate) {
    const wcut_candidate *c = &s->candidate[candidate];
    const bool small = c->second_size < 1, scans = moves_scans_alone(c, wcut_search_base(s)->model.effects);
    const bool two = c->effects > 1;

    /* what it gains, by size */
    if (c->gain < GAIN_CHANCE) return "no more than chance";
    if (c->gain < gain_min(s) && !scans) return "no more than the simulator's own error may feign";
    if (c->gain < GAIN_SMALL && small) return two ? "one of the two is too small to be named" : "too small to be named";

    /* what it is, and what it does on cuts that were not fitted */
    if (!is_significant(c, wcut_search_base(s)->model.effects))
        return "a strength is within two standard errors of nothing";
    if (runs_out(c) && c->gain < BOUND_TAKES * all_that_is_told(s)) return "a value ends at the bound of its range";
    if (scans) return NULL;
    if (c->held_out < HELD_OUT_MIN * c->fall) return "shows less than half of its gain on cuts that were not fitted";
    if (2 * c->better <= c->judged) return "predicts half of the held-out cuts or fewer";
    if (!takes_most(s, candidate)) return "explains less than half of what there is";
    return NULL;
}

static bool may_be_named(const wcut_search *s, int candidate) { return objection(s, candidate) == NULL; }

/* whether an effect that cannot be named explains more than a candidate: then that one takes what is not its own */
static bool is_outdone(const wcut_search *s, int candidate) {
    const wcut_candidate *c = &s->candidate[candidate];
    const int base = wcut_search_base(s)->model.effects;
    if (moves_scans_alone(c, base)) return false; /* what explains recordings takes nothing from scans */
    for (int k = 0; k < s->count; k++) {
        const wcut_candidate *other = &s->candidate[k];
        if (k == candidate || other->effects != c->effects || other->second_size >= 1) continue;
        if (!may_be_named(s, k) && !moves_scans_alone(other, base) &&
            wcut_candidate_score(s, k) > wcut_candidate_score(s, candidate))
            return true;
    }
    return false;
}

static int best_of(const wcut_search *s, int effects) {
    int best = -1;
    for (int k = 0; k < s->count; k++)
        if (k != s->delayed && k != s->undelayed && !s->candidate[k].form && s->candidate[k].effects == effects &&
            may_be_named(s, k) && !is_outdone(s, k) &&
            (best < 0 || wcut_candidate_score(s, k) > wcut_candidate_score(s, best)))
            best = k;
    return best;
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

/* the best of the other forms: one that leaves noise before one that does not; -1 where there is none */
static int best_form(const wcut_search *s) {
    int best = -1;
    for (int k = 0; k < s->count; k++) {
        if (!s->candidate[k].form || !may_be_named(s, k) || is_outdone(s, k)) continue;
        const bool noise = wcut_search_leaves_noise(s, k), was = best >= 0 && wcut_search_leaves_noise(s, best);
        if (best < 0 || (noise && !was) || (noise == was && wcut_candidate_score(s, k) > wcut_candidate_score(s, best)))
            best = k;
    }
    return best;
}

/* Whether another form of one effect takes the place of what was chosen: where it leaves noise, of all that explains no more;
   else of the first form, which stood for the family. */
static bool form_counts(const wcut_search *s, int form, int chosen) {
    const double ahead = chosen < 0 ? 0 : wcut_candidate_score(s, form) - wcut_candidate_score(s, chosen);
    if (wcut_search_leaves_noise(s, form)) return chosen < 0 || !wcut_search_leaves_noise(s, chosen) || ahead >= 0;
    return chosen >= 0 && !wcut_search_leaves_noise(s, chosen) && ahead > RIVAL &&
           same_kinds(&s->candidate[form].fit.model, &s->candidate[chosen].fit.model);
}

/* whether a pair says more than its better half */
static bool second_counts(const wcut_search *s, int pair, int single) {
    const double noise = s->rows, paired = s->candidate[pair].fit.misfit;

    /* no single effect was found: the pair must gain by itself, and take most of what is beyond noise */
    if (single < 0) {
        const double misfit = wcut_search_base(s)->misfit;
        if (is_null(s) && (misfit < MISFIT_LARGE * noise || s->candidate[pair].gain < GAIN_UNTOLD)) return false;
        return s->candidate[pair].gain > GAIN_PAIR && s->candidate[pair].fall > PAIR_TAKES * (misfit - noise);
    }

    /* a second effect that does not act on the force is accepted more easily: the form of the force law cannot
       imitate it */
    const wcut_model *one = &s->candidate[single].fit.model, *both = &s->candidate[pair].fit.model;
    const double first = s->candidate[single].gain;
    bool off_the_force = true, scans = true;
    for (int k = 0; k < both->effects; k++) {
        const wcut_effect_place place = wcut_effect_view(both->effect[k].kind)->place;
        bool known = false;
        for (int j = 0; j < one->effects; j++) known = known || both->effect[k].kind == one->effect[j].kind;

        /* readings that are late by less than is named are scatter, which the first effect has beside it */
        if (!known && wcut_explanation_view(both->effect[k].kind)->delay && wcut_effect_size(&both->effect[k]) < 1)
            return false;
        off_the_force = off_the_force && (known || place != WCUT_EFFECT_PLACE_STEP);
        scans = scans && (known || (place != WCUT_EFFECT_PLACE_STEP && place != WCUT_EFFECT_PLACE_SENSOR));
    }

    /* the second effect must take away a given share of what the first one leaves */
    const double takes = s->candidate[single].fit.misfit - paired, leaves = s->candidate[single].fit.misfit - noise;
    if (takes < (off_the_force ? SENSOR_TAKES : SECOND_TAKES) * leaves) return false;

    /* and its gain must exceed what an error of the model's form could feign */
    const double error = off_the_force ? MODEL_ERROR : FORM_ERROR;

    const double least = fmax(scans ? GAIN_SCAN : gain_min(s), error * first);

    return wcut_candidate_score(s, pair) - wcut_candidate_score(s, single) > least;
}

static wcut_verdict_kind verdict_kind_of(const wcut_model *m) {
    bool physics = false, instrument = false;
    for (int k = 0; k < m->effects; k++) {
        const bool fault = wcut_explanation_view(m->effect[k].kind)->instrument;
        physics = physics || !fault, instrument = instrument || fault;
    }
    return physics && instrument ? WCUT_VERDICT_BOTH : physics ? WCUT_VERDICT_PHYSICS : WCUT_VERDICT_INSTRUMENT;
}

static void list_rivals(const wcut_search *s, wcut_decision *d) {
    const wcut_candidate *best = &s->candidate[d->chosen];
    d->rival[d->rivals++] = d->chosen;

    /* the simulator's own error grows with what is told apart: of a pair, what it says more than one alone */
    double told = best->gain;
    for (int k = 0; k < s->count && best->effects > 1; k++)
        if (s->candidate[k].effects == 1) told = fmin(told, fmax(best->gain - s->candidate[k].gain, 0));
    for (int k = 0; k < s->count && d->rivals < WCUT_RIVALS; k++) {
        const wcut_candidate *c = &s->candidate[k];
        if (k == d->chosen || k == s->delayed || k == s->undelayed || c->effects != best->effects ||
            !may_be_named(s, k))
            continue;
        bool listed = false;
        for (int r = 0; r < d->rivals; r++)
            listed = listed || same_kinds(&c->fit.model, &s->candidate[d->rival[r]].fit.model);
        const double behind = wcut_candidate_score(s, d->chosen) - wcut_candidate_score(s, k);
        if (!listed && behind < RIVAL + 0.01 * told) d->rival[d->rivals++] = k;
    }
}

/* the best score of a candidate of as many effects that is of other kinds; 0 where there is none */
static double next_kind(const wcut_search *s, int chosen) {
    double next = 0;
    for (int k = 0; k < s->count; k++)
        if (s->candidate[k].effects == s->candidate[chosen].effects && k != s->delayed && k != s->undelayed &&
            !same_kinds(&s->candidate[k].fit.model, &s->candidate[chosen].fit.model))
            next = fmax(next, wcut_candidate_score(s, k));
    return next;
}

/* An inadequate model of the right family: one effect that takes most of the misfit, on cuts left out too, far before any
   other kind. What moves scans alone explains no recordings. */
static bool is_of_another_form(const wcut_search *s, int chosen) {
    const wcut_candidate *c = &s->candidate[chosen];
    if (c->effects > 1 || wcut_search_base(s)->misfit <= s->rows) return false;
    if (moves_scans_alone(c, wcut_search_base(s)->model.effects) && !recordings_are_noise(&c->left)) return false;
    return takes_most(s, chosen) && wcut_candidate_score(s, chosen) > FORM_LEADS * next_kind(s, chosen);
}

bool wcut_search_tells_form(const wcut_search *s, int chosen) {
    if (!wcut_search_leaves_noise(s, chosen)) return false;
    for (int k = 0; k < s->count; k++) {
        const wcut_model *a = &s->candidate[k].fit.model, *b = &s->candidate[chosen].fit.model;
        if (k == chosen || !(s->candidate[k].form || s->candidate[chosen].form) || !same_kinds(a, b)) continue;
        if (wcut_search_leaves_noise(s, k) && wcut_candidate_score(s, chosen) - wcut_candidate_score(s, k) < RIVAL)
            return false;
    }
    return true;
}

const char *wcut_candidate_why(const wcut_search *s, const wcut_decision *d, int candidate) {
    const bool named = d->kind != WCUT_VERDICT_NONE && d->kind != WCUT_VERDICT_UNKNOWN;
    if (candidate < 0) {
        if (d->kind == WCUT_VERDICT_NONE) return "";
        if (!is_null(s)) return "leaves a misfit that is not noise";
        return named ? "another explains more" : "effects that may not be named explain more";
    }
    if (named && candidate == d->chosen) return "";
    for (int r = 0; named && r < d->rivals; r++)
        if (candidate == d->rival[r]) return "explains as much as the first";
    const wcut_candidate *c = &s->candidate[candidate];
    if (candidate == s->delayed) return "others explain more beside it";
    if (candidate == d->small) return "present, but too small to matter";
    const char *why = objection(s, candidate);
    if (why) return why;
    if (is_outdone(s, candidate)) return "an effect too small to be named explains more";
    if (!named && !wcut_search_leaves_noise(s, candidate)) return "leaves a misfit that is not noise";
    return c->effects > 1 ? "its second effect is not needed" : "explains less";
}

/* what is left over its limit: the worst of all that noise and scatter are held against */
static double over_limits(const wcut_search *s) {
    const wcut_residual_stats *left = &s->left;
    double worst = fmax(left->slow / SLOW_MAX, left->common / COMMON_MAX);
    worst = fmax(worst, fmax(left->worst / WORST_MAX, fmax(left->patches / PATCHES_MAX, left->peak / PEAK_MAX)));
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++)
        worst = fmax(worst, s->none.noise.scatter[k] /
                                (PLAUSIBLE * wcut_scatter_view(&s->none.noise, (wcut_scatter_kind)k)->max));
    return worst;
}

/* what the confidence goes by (confidence.c) */
static double confidence_by(const wcut_search *s, const wcut_decision *d) {
    if (d->kind == WCUT_VERDICT_NONE) return log1p(fmax(all_that_is_told(s), 0)) / 5;
    if (d->kind == WCUT_VERDICT_UNKNOWN) return fmin(over_limits(s), 3);
    return d->chosen >= 0 && s->candidate[d->chosen].fit.model.effects > 1;
}

/* whether every effect is below its size of consequence */
static bool is_small(const wcut_search *s, int candidate) {
    const wcut_model *m = &s->candidate[candidate].fit.model;
    for (int k = wcut_search_base(s)->model.effects; k < m->effects; k++)
        if (wcut_effect_size(&m->effect[k]) >= 1) return false;
    return true;
}

/* The best score of what is there beside a bound: a value that ends at one is a fit of something else. What is small and
   leaves noise is no sign of more than itself. */
static double best_score(const wcut_search *s) {
    double best = 0;
    for (int k = 0; k < s->count; k++)
        if (k != s->delayed && k != s->undelayed && !runs_out(&s->candidate[k]) &&
            !(is_small(s, k) && wcut_search_leaves_noise(s, k)))
            best = fmax(best, wcut_candidate_score(s, k));
    return best;
}

/* An effect below its size of consequence that stands out all the same, where nothing is named: the best single one, farther
   than nulls do, on cuts left out too, leaving noise. Where that holds for the next best alone, it takes what is not its own. */
static int find_small(const wcut_search *s, const wcut_decision *d) {
    int best = -1;
    if (d->kind != WCUT_VERDICT_NONE) return best;
    for (int k = 0; k < s->count; k++)
        if (s->candidate[k].effects == 1 && k != s->delayed && k != s->undelayed &&
            (best < 0 || wcut_candidate_score(s, k) > wcut_candidate_score(s, best)))
            best = k;
    if (best < 0 || !is_small(s, best)) return -1;
    const wcut_candidate *c = &s->candidate[best];
    const bool stands_out =
        c->gain > GAIN_UNTOLD && !runs_out(c) && is_significant(c, wcut_search_base(s)->model.effects);
    const bool holds = c->held_out >= HELD_OUT_MIN * c->fall && 2 * c->better > c->judged;
    return stands_out && holds && wcut_search_leaves_noise(s, best) ? best : -1;
}

/* the verdict before late readings are looked at */
static wcut_decision decide_effects(const wcut_search *s) {
    /* the best single effect, unless a pair says more */
    wcut_decision d = {.kind = WCUT_VERDICT_NONE, .chosen = -1, .small = -1, .adequacy = s->left.slow};
    const int single = best_of(s, 1), pair = best_of(s, 2);
    d.chosen = single;
    if (pair >= 0 && wcut_search_leaves_noise(s, pair) && second_counts(s, pair, single)) d.chosen = pair;

    /* another form of one effect comes before a pair that explains no more */
    const int form = best_form(s);
    if (form >= 0 && form_counts(s, form, d.chosen)) d.chosen = form;

    /* no candidate: either nothing is there, or something that no effect explains */
    if (d.chosen < 0) {
        if (!is_null(s) || best_score(s) > GAIN_UNTOLD || all_that_is_told(s) > GAIN_TOGETHER)
            d.kind = WCUT_VERDICT_UNKNOWN;
        return d;
    }

    /* what is named must leave noise, or be the right family in another form */
    const wcut_candidate *best = &s->candidate[d.chosen];
    d.adequacy = best->left.slow;
    if (!wcut_search_leaves_noise(s, d.chosen) && !is_of_another_form(s, d.chosen)) {
        d.kind = WCUT_VERDICT_UNKNOWN;
        return d;
    }

    /* several effects that explain the data equally well make the verdict ambiguous */
    d.kind = verdict_kind_of(&best->fit.model);
    list_rivals(s, &d);
    if (d.rivals > 1) d.kind = WCUT_VERDICT_AMBIGUOUS;

    return d;
}

wcut_decision wcut_search_decide(const wcut_search *s) {
    wcut_decision d = decide_effects(s);

    /* late readings alone; or a verdict that needs no delay any more */
    if (d.chosen < 0 && d.kind == WCUT_VERDICT_NONE && s->delayed >= 0) {
        d.chosen = d.rival[0] = s->delayed, d.rivals = 1;
        d.kind = WCUT_VERDICT_INSTRUMENT;
    }
    if (s->undelayed >= 0 && d.chosen == s->undelayed_from && d.kind != WCUT_VERDICT_AMBIGUOUS &&
        d.kind != WCUT_VERDICT_UNKNOWN) {
        d.chosen = d.rival[0] = s->undelayed, d.rivals = 1;
        d.adequacy = s->candidate[s->undelayed].left.slow;
        d.kind = verdict_kind_of(&s->candidate[s->undelayed].fit.model);
    }
    d.small = find_small(s, &d);
    d.confidence_by = confidence_by(s, &d);
    d.confidence = wcut_confidence_eval(d.kind, d.confidence_by);
    return d;
}
