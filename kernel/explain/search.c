/* The search: recalibration, every effect alone, every pair that matters, each fitted in full. */
#include "explain/search.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "explain/decide.h"
#include "explain/scatter.h"

enum { SINGLES = 3, FIRSTS = 3, SECONDS = 3, SECONDS_MAX = 8, PAIRS = 1 };

/* a gain below this of a thousand rows' misfit is in the noise of the search over the whole library */
#define WORTH 12.0
/* what is tried in full: half of a practical size or more */
#define NEARLY 0.5
/* or what stands out so far that it is there, however small */
#define TELLS 300.0
/* [mm] of a wire over the others, beyond which its rows are not straight */
#define FAR_LENGTH 0.6
/* [standard errors] of the mean of all wires' lengths, beyond which it is an effect */
#define ALIKE 4.0
/* [standard errors] a delay that is named: its square is the gain that any other name needs. The nuisance of delays has
   taken it already, so that the likelihoods with and without the name hardly differ. */
#define LATE 8.0
/* [twice ln likelihood] what the whole library at once gains over the best that was fitted, beyond which more is fitted */
#define UNTOLD 300.0
/* a pair that gains so many times what the best single one gains */
#define HALVES 1.5
/* [twice ln likelihood] by which a displaced block must explain more than a displaced scan */
#define GAIN_SHIFT 25.0
/* and what comes near the best of the screen, whose columns are straight lines through bent responses */
#define CONTENDS 0.25

/* ---- candidates ---- */

typedef struct searching {
    wcut_screen screen;             /* of the whole library, about what candidates are held against */
    bool seconded[WCUT_CANDIDATES]; /* single ones beside which a second effect was sought */
    wcut_evidence *e;
    wcut_search *s;
    const bool *without;
    int done;
    int formed; /* candidate whose other forms were tried; -1: none */
    bool paired;
} searching;

static wcut_status search_step(searching *g, const char *stage, wcut_error *error) {
    if (!wcut_stop_step(g->e->stop, stage, g->done++)) return WCUT_OK;
    return wcut_fail(error, WCUT_INTERRUPTED, "interrupted");
}

static bool same_effects(const wcut_model *a, const wcut_model *b) {
    if (a->effects != b->effects || a->carried != b->carried) return false;
    for (int i = 0; i < a->effects; i++) {
        bool found = false;
        for (int j = 0; j < b->effects; j++)
            found = found || (a->effect[i].kind == b->effect[j].kind && a->effect[i].choice == b->effect[j].choice);
        if (!found) return false;
    }
    return true;
}

static bool tried(const wcut_search *s, const wcut_model *model) {
    for (int k = 0; k < s->count; k++)
        if (same_effects(&s->candidate[k].fit.model, model)) return true;
    return false;
}

static void compare_held_out(const wcut_evidence *e, const wcut_fitted *none, wcut_candidate *c) {
    for (int k = 0; k < e->cuts; k++) {
        if (e->cut[k].bins == 0) continue;
        const double fall = none->held_out[k] - c->fit.held_out[k];
        c->held_out += fall;
        c->better += fall > 0, c->judged++;
    }
}

/* Fit a model in full and keep it. WCUT_OK where it did not converge, too: then it is no candidate. */
static wcut_status try_model(searching *g, const wcut_model *start, wcut_error *error) {
    wcut_search *s = g->s;

    /* no model twice, and no more than there is room for */
    if (s->count == WCUT_CANDIDATES || tried(s, start)) return WCUT_OK;
    wcut_status status =
        search_step(g, start->effects > 1 ? "pairs of effects were fitted" : "effects were fitted one by one", error);
    if (status != WCUT_OK) return status;

    /* fit in full; one that does not converge is no candidate */
    wcut_candidate c = {.effects = start->effects};
    wcut_model model = *start; /* from the jobs' own wire length: without the effect it has gone where it could */
    model.length_change = 0;
    status = wcut_model_fit(g->e, &model, &c.fit, error);
    if (status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED) return status;
    if (status != WCUT_OK) return WCUT_OK;

    /* against the base: gain in likelihood, fall of the misfit */
    const wcut_fitted *base = wcut_search_base(s);
    c.effects = start->effects - base->model.effects;
    c.gain = base->cost - c.fit.cost;
    c.fall = base->misfit - c.fit.misfit;

    /* the smaller of the sizes decides whether a pair is worth its second effect */
    c.second_size = HUGE_VAL;
    for (int k = base->model.effects; k < start->effects; k++)
        c.second_size = fmin(c.second_size, wcut_effect_size(&c.fit.model.effect[k]));

    /* the same on cuts left out, and what the fit leaves */
    compare_held_out(g->e, base, &c);
    c.left = wcut_residual_stats_eval(g->e, c.fit.standard);
    s->candidate[s->count++] = c;

    return WCUT_OK;
}

static wcut_model with_effects(const wcut_model *base, const wcut_screened *found) {
    wcut_model m = *base;
    for (int k = 0; k < found->groups && m.effects < WCUT_DIAGNOSIS_EFFECTS; k++)
        m.effect[m.effects++] = found->effect[k];
    m.carried = m.carried || found->carried;
    return m;
}

/* the best variant of every kind on the side that its bounds allow; gives how many */
static int best_of_kinds(const wcut_screen *screen, wcut_screened *out, wcut_error *error) {
    wcut_screened *all = wcut_alloc((size_t)screen->groups, sizeof *all);
    if (!all) {
        wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d columns", screen->groups);
        return -1;
    }
    const int n = wcut_screen_singles(screen, all);
    int count = 0;
    for (int i = 0; i < n; i++) {
        bool seen = false;
        for (int k = 0; k < count; k++) seen = seen || out[k].effect[0].kind == all[i].effect[0].kind;
        if (all[i].size[0] == 0) continue;
        if (!seen && count < WCUT_EFFECT_COUNT) out[count++] = all[i];
    }
    wcut_free(all);
    return count;
}

/* the scale of chance: what a row costs where nothing is left to explain, estimated from the best fit so far */
static double chance_scale(const wcut_search *s) {
    double min = s->left.per_row;
    for (int k = 0; k < s->count; k++) min = fmin(min, s->candidate[k].left.per_row);
    return fmax(min, 1);
}

/* whether a delay [s] stands out of what every rig has */
static bool is_late(double delay, double error) {
    const double min = wcut_explanation_view(WCUT_EFFECT_TENSION_DELAY)->gate;
    return delay >= min + fmax(2 * error, 0.01) && delay >= LATE * error;
}

/* A delay beyond what readings have in every rig: which effect it is, and how long. Readings are never early. Angles follow
   the wire without delay, so that late ones are late whatever else is wrong; a tension may follow late by its physics. */
static bool late_readings(const wcut_fitted *f, wcut_effect *effect) {
    const double tension = f->delay[0], angle = f->delay[1];
    const bool angles = is_late(angle, f->delay_error[1]), tensions = is_late(tension, f->delay_error[0]);
    const bool alike = angles || (angle > 0.5 * tension && angle > 4 * f->delay_error[1]);
    if (!angles && !tensions) return false;
    *effect = wcut_effect_default(alike ? WCUT_EFFECT_CLOCK_OFFSET : WCUT_EFFECT_TENSION_DELAY);
    effect->value[alike ? WCUT_CLOCK_OFFSET_DELAY : WCUT_TENSION_DELAY_DELAY] = angles ? angle : tension;
    return true;
}

/* Late readings before anything else: they are in every cut, and whatever is slow would be taken for them. They are kept
   where they leave noise alone; where more is wrong, late angles are one effect among others, and late tensions wait for
   what else there is (add_delay). */
static wcut_status try_delay(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    wcut_effect effect;
    if (!late_readings(&s->none, &effect) || g->without[effect.kind]) return WCUT_OK;
    wcut_model start = s->none.model;
    start.effect[start.effects++] = effect;
    const wcut_status status = try_model(g, &start, error);
    if (status != WCUT_OK || s->count == 0) return status;
    if (wcut_search_explains_delay(s, 0)) {
        s->delayed = 0, s->left = s->candidate[0].left, s->candidate[0].effects = 0;
    } else if (!is_late(s->none.delay[1], s->none.delay_error[1])) {
        s->count = 0;
        wcut_fitted_destroy(&s->candidate[0].fit);
    }
    return WCUT_OK;
}

/* the screen about what candidates are held against, where that has a delay */
static wcut_status screen_base(searching *g, wcut_error *error) {
    if (g->s->delayed < 0) return WCUT_OK;
    wcut_screen about;
    if (wcut_screen_about(g->e, &g->screen, wcut_search_base(g->s), &about) != WCUT_OK)
        return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a screen beside a delay");
    wcut_screen_destroy(&g->screen);
    g->screen = about;
    return WCUT_OK;
}

static wcut_status try_singles(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    wcut_screen *screen = &g->screen;

    /* columns of the whole library about the recalibrated model */
    wcut_status status = search_step(g, "the library was screened", error);
    if (status == WCUT_OK) status = wcut_screen_create(g->e, &s->none.model, s->none.open, g->without, screen, error);
    if (status != WCUT_OK) return status;

    /* noise under a saturated model, so that no effect is taken for scatter */
    double saturated = HUGE_VAL;
    status = wcut_screen_saturate(g->e, screen, &saturated);
    if (status == WCUT_NOT_CONVERGED) status = WCUT_OK; /* the noise stays what it began as */
    if (status != WCUT_OK) return wcut_fail(error, status, "no memory for the saturated model");

    /* recalibration again, under the noise that is known now */
    wcut_fitted again = {0};
    status = wcut_model_fit(g->e, &s->none.model, &again, error);
    if (status != WCUT_OK) return status;
    wcut_fitted_destroy(&s->none);
    s->none = again;

    /* what recalibration leaves, and how many rows and cuts count */
    s->left = wcut_residual_stats_eval(g->e, s->none.standard);
    s->saturated = saturated < HUGE_VAL ? s->none.cost - saturated : 0;
    s->rows = s->cuts = 0;
    for (int k = 0; k < g->e->cuts; k++) s->cuts += g->e->cut[k].bins > 0;
    for (int i = 0; i < g->e->rows; i++) s->rows += isfinite(screen->missing[i]) != 0;

    /* late readings join the base if they leave noise alone */
    status = try_delay(g, error);
    if (status == WCUT_OK) status = screen_base(g, error);
    if (status != WCUT_OK) return status;

    /* the best variant of each kind, and the best pairs */
    s->screened = best_of_kinds(screen, s->single, error);
    s->pairs = wcut_screen_pairs(screen, WCUT_SCREENED, s->pair);
    if (s->screened < 0) return WCUT_NO_MEMORY;

    /* fit in full what contends with the best and is large enough to be named */
    for (int k = 0, full = 0; status == WCUT_OK && k < s->screened && full < SINGLES; k++) {
        if (s->single[k].gain < fmax(WORTH * s->left.slow, CONTENDS * s->single[0].gain)) continue;
        if (s->single[k].size[0] < NEARLY && s->single[k].gain < TELLS) continue;
        const wcut_model start = with_effects(&wcut_search_base(s)->model, &s->single[k]);
        status = try_model(g, &start, error);
        full++;
    }

    return status;
}

static int best_candidate(const wcut_search *s, int effects) {
    int best = -1;
    for (int k = 0; k < s->count; k++)
        if (s->candidate[k].effects == effects && k != s->delayed && !s->candidate[k].form &&
            (best < 0 || s->candidate[k].gain > s->candidate[best].gain))
            best = k;
    return best;
}

/* The other forms of the best single effect, where it leaves more than noise: they come before another effect. Of mounts
   all are kept, of other families what explains more than the first. */
static wcut_status try_forms(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    const int best = best_candidate(s, 1);
    if (best < 0 || best == g->formed || wcut_search_leaves_noise(s, best)) return WCUT_OK;
    g->formed = best;
    const wcut_model about = s->candidate[best].fit.model;
    const int at = about.effects - 1;
    const bool mounts = about.effect[at].kind == WCUT_EFFECT_MOUNT_COMPLIANCE;

    /* behind the pairs: what is explained needs no other form, but for mounts, which bend too far for a screen */
    const int chosen = g->paired ? wcut_search_decide(s).chosen : -1;
    if (chosen >= 0 && !mounts && wcut_search_leaves_noise(s, chosen)) return WCUT_OK;
    wcut_status status = WCUT_OK;
    for (int nth = 0; status == WCUT_OK; nth++) {
        wcut_model start = about;
        if (!wcut_effect_form(&about.effect[at], nth, &start.effect[at])) return WCUT_OK;
        const int count = s->count;
        status = try_model(g, &start, error);
        if (mounts || s->count == count) continue;
        s->candidate[count].form = true;
        if (wcut_search_leaves_noise(s, count) || s->candidate[count].gain > s->candidate[best].gain + WORTH) continue;
        wcut_fitted_destroy(&s->candidate[count].fit);
        s->count = count;
    }

    return status;
}

/* whether another form of one effect leaves noise and explains as much as any pair of the screen promises, which is a fall of
   the misfit under the scatter that all share */
static bool form_suffices(const wcut_search *s) {
    for (int k = 0; k < s->count; k++)
        if (s->candidate[k].form && wcut_search_leaves_noise(s, k) &&
            (s->pairs == 0 || s->candidate[k].fall >= s->pair[0].gain))
            return true;
    return false;
}

/* whether the candidate that gains the most leaves noise */
static bool best_leaves_noise(const wcut_search *s) {
    const int single = best_candidate(s, 1), pair = best_candidate(s, 2);
    if (single < 0) return true;
    const bool paired = pair >= 0 && s->candidate[pair].gain > s->candidate[single].gain;
    return wcut_search_leaves_noise(s, paired ? pair : single);
}

/* A pair to try: a single one that was fitted, and what the screen about it would add. */
typedef struct second {
    int first; /* candidate */
    wcut_screened found;
    double gain; /* fall of the misfit by both, under the noise that all share */
} second;

enum { SECONDS_LISTED = FIRSTS * WCUT_EFFECT_COUNT };

/* what the screen about a single one would add, put into a list in order of what both gain */
static wcut_status list_seconds(searching *g, int first, int *count, second *list, wcut_error *error) {
    wcut_search *s = g->s;
    wcut_screened found[WCUT_EFFECT_COUNT];
    wcut_screen about;
    wcut_status status = search_step(g, "the library was screened for a second effect", error);
    if (status != WCUT_OK) return status;
    if (wcut_screen_about(g->e, &g->screen, &s->candidate[first].fit, &about) != WCUT_OK)
        return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a second screen");
    const int kinds = best_of_kinds(&about, found, error);
    wcut_screen_destroy(&about);
    if (kinds < 0) return WCUT_NO_MEMORY;

    /* what is more than chance, and large enough or plain to see */
    const double chance = WORTH * chance_scale(s);
    for (int k = 0; k < kinds && *count < SECONDS_LISTED; k++) {
        const wcut_screened *f = &found[k];
        if (f->gain < chance || (f->size[0] < NEARLY && f->gain < TELLS)) continue;
        const second add = {first, *f, s->candidate[first].fall + f->gain};
        int at = (*count)++;
        for (; at > 0 && list[at - 1].gain < add.gain; at--) list[at] = list[at - 1];
        list[at] = add;
    }

    /* of the best one the list is kept */
    if (first == best_candidate(s, 1)) {
        s->next = kinds;
        memcpy(s->second, found, (size_t)kinds * sizeof *found);
    }

    return WCUT_OK;
}

/* What to add to the best single ones, beside which nothing was sought yet: a second effect lost to another variant or kind of
   the first is found beside its own. */
static wcut_status try_seconds(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    second *list = wcut_alloc(SECONDS_LISTED, sizeof *list);
    if (!list) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for pairs of effects");
    wcut_status status = WCUT_OK;
    int count = 0;
    for (int n = 0; status == WCUT_OK && n < FIRSTS; n++) {
        const int best = best_candidate(s, 1);
        int first = -1;
        for (int k = 0; k < s->count; k++)
            if (s->candidate[k].effects == 1 && k != s->delayed && !g->seconded[k] && !s->candidate[k].form &&
                s->candidate[k].fit.model.effects < WCUT_DIAGNOSIS_EFFECTS &&
                (first < 0 || s->candidate[k].gain > s->candidate[first].gain))
                first = k;
        if (first < 0 || s->candidate[first].gain < CONTENDS * s->candidate[best].gain) break;
        g->seconded[first] = true;
        status = list_seconds(g, first, &count, list, error);
    }

    /* the best of them in full, more of them while what explains the most leaves more than noise; two orders of the same pair
       are one */
    for (int k = 0, full = 0; status == WCUT_OK && k < count && full < SECONDS_MAX; k++) {
        if (full >= SECONDS && best_leaves_noise(s)) break;
        const wcut_model start = with_effects(&s->candidate[list[k].first].fit.model, &list[k].found);
        if (tried(s, &start)) continue;
        status = try_model(g, &start, error);
        full++;
    }
    wcut_free(list);
    return status;
}

/* what to add to the best single ones, and the best pairs of the screen */
static wcut_status try_pairs(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    const int best = best_candidate(s, 1);
    if (best < 0 || form_suffices(s)) return WCUT_OK;
    wcut_status status = try_seconds(g, error);

    /* the best pairs of the screen that beat every single one */
    const double chance = WORTH * chance_scale(s);
    for (int k = 0, full = 0; status == WCUT_OK && k < s->pairs && full < PAIRS; k++) {
        const wcut_screened *p = &s->pair[k];
        if (p->gain < s->candidate[best].gain + chance || fmin(p->size[0], p->size[1]) < 1) continue;
        const wcut_model start = with_effects(&wcut_search_base(s)->model, p);
        status = try_model(g, &start, error);
        full++;
    }

    return status;
}

/* A pair that explains far more than any single one, though one of the two is small: the other alone. The screen's columns
   are straight, and what bends far, as soft mounts do, shows beside another first. */
static wcut_status try_halves(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    const int single = best_candidate(s, 1), pair = best_candidate(s, 2);
    if (single < 0 || pair < 0 || s->candidate[pair].gain < HALVES * s->candidate[single].gain) return WCUT_OK;
    const wcut_model both = s->candidate[pair].fit.model;
    wcut_status status = WCUT_OK;
    for (int half = wcut_search_base(s)->model.effects; status == WCUT_OK && half < both.effects; half++) {
        if (wcut_effect_size(&both.effect[half]) < 1) continue;
        wcut_model start = wcut_search_base(s)->model;
        start.effect[start.effects++] = both.effect[half];
        start.carried = both.carried;
        status = try_model(g, &start, error);
    }

    return status;
}

static int single_of_kind(const wcut_search *s, wcut_effect_kind kind) {
    for (int c = 0; c < s->count; c++) {
        const wcut_model *m = &s->candidate[c].fit.model;
        if (s->candidate[c].effects == 1 && c != s->delayed && m->effect[m->effects - 1].kind == kind) return c;
    }

    return -1;
}

/* the start of a kind whose shape is farthest from that of an effect; false where all have its own */
static bool farthest_start(wcut_effect *effect) {
    const wcut_explanation *x = wcut_explanation_view(effect->kind);
    const double own = effect->value[1];
    double far = 0;
    for (int k = 0; k < x->starts && own > 0; k++) {
        const double shape = x->start[k].value[1];
        if (x->start[k].choice != effect->choice || !(shape > 0) || fabs(log(shape / own)) <= far) continue;
        far = fabs(log(shape / own));
        effect->value[0] = x->start[k].value[0], effect->value[1] = shape;
    }

    return far > 0;
}

/* Where nothing that was fitted explains the case, the best of every other kind in full: what bends far, as overheating
   does, is low in a screen of straight lines. */
static wcut_status try_rest(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    const int before = best_candidate(s, 1);
    const wcut_verdict_kind kind = wcut_search_decide(s).kind;
    const bool more = s->saturated > UNTOLD + (before < 0 ? 0 : s->candidate[before].gain);
    if (kind != WCUT_VERDICT_UNKNOWN && !(kind == WCUT_VERDICT_NONE && more)) return WCUT_OK;
    const wcut_model *base = &wcut_search_base(s)->model;
    wcut_status status = WCUT_OK;
    for (int k = 0; status == WCUT_OK && k < s->screened; k++) {
        wcut_screened found = s->single[k];
        if (found.gain < WORTH || single_of_kind(s, found.effect[0].kind) >= 0) continue;
        wcut_model start = with_effects(base, &found);
        status = try_model(g, &start, error);

        /* from another shape, where that is fitted too */
        const int at = single_of_kind(s, found.effect[0].kind);
        if (status != WCUT_OK || at < 0 || !farthest_start(&found.effect[0])) continue;
        const wcut_candidate kept = s->candidate[at];
        s->count = at;
        start = with_effects(base, &found);
        status = try_model(g, &start, error);
        const bool better = s->count > at && s->candidate[at].gain > kept.gain;
        wcut_fitted other = better ? kept.fit : s->count > at ? s->candidate[at].fit : (wcut_fitted){0};
        if (!better) s->candidate[at] = kept;
        wcut_fitted_destroy(&other);
        s->count = at + 1;
    }
    return status;
}

/* A displaced scan, or a displaced block: both move the face of every scan, but the block meets the wire elsewhere, too. It
   is named only where that shows. */
static wcut_status try_shift(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    const int chosen = wcut_search_decide(s).chosen;
    if (chosen < 0 || g->without[WCUT_EFFECT_BLOCK_SHIFT]) return WCUT_OK;
    wcut_model start = s->candidate[chosen].fit.model;
    const int count = s->count;
    int at = -1;
    for (int e = 0; e < start.effects; e++)
        if (start.effect[e].kind == WCUT_EFFECT_SCAN_OFFSET) at = e;
    if (at < 0) return WCUT_OK;

    /* a face lies behind where its scan is seen */
    const wcut_effect scan = start.effect[at];
    start.effect[at] = wcut_effect_default(WCUT_EFFECT_BLOCK_SHIFT);
    for (int k = 0; k < 3; k++) start.effect[at].value[k] = -scan.value[k];
    const wcut_status status = try_model(g, &start, error);
    if (s->count == count || s->candidate[count].gain > s->candidate[chosen].gain + GAIN_SHIFT) return status;
    wcut_fitted_destroy(&s->candidate[count].fit);
    s->count = count;
    return status;
}

/* the verdict with the delay that its nuisances show */
static wcut_status add_delay(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    const wcut_decision d = wcut_search_decide(s);
    wcut_effect effect;
    if (s->delayed >= 0 || d.chosen < 0) return WCUT_OK;
    const wcut_fitted *f = &s->candidate[d.chosen].fit;
    if (f->model.effects == WCUT_DIAGNOSIS_EFFECTS || !late_readings(f, &effect) || g->without[effect.kind])
        return WCUT_OK;
    wcut_model start = f->model;
    start.effect[start.effects++] = effect;
    const int count = s->count;
    const wcut_status status = try_model(g, &start, error);
    if (s->count > count && wcut_search_explains_delay(s, count) &&
        wcut_effect_size(&s->candidate[count].fit.model.effect[start.effects - 1]) >= 1)
        s->undelayed = count, s->undelayed_from = d.chosen;
    return status;
}

/* the verdict without a delay that its own effects have made needless */
static wcut_status drop_delay(searching *g, wcut_error *error) {
    wcut_search *s = g->s;
    const wcut_decision d = wcut_search_decide(s);
    if (s->delayed < 0 || d.chosen < 0 || d.chosen == s->delayed) return WCUT_OK;
    const wcut_model *m = &s->candidate[d.chosen].fit.model;
    if (wcut_effect_size(&m->effect[0]) >= 1) return WCUT_OK;
    wcut_model start = *m;
    start.effects--;
    memmove(start.effect, start.effect + 1, (size_t)start.effects * sizeof *start.effect);
    const int count = s->count;
    const wcut_status status = try_model(g, &start, error);
    if (s->count > count) s->undelayed = count, s->undelayed_from = d.chosen, s->candidate[count].effects++;
    return status;
}

/* whether wires are longer, or shorter, all alike: that is no scatter; a hot wire is longer than a cold one */
static bool are_alike(int n, const double *length) {
    double mean = 0, square = 0;
    if (n < 3) return false;
    for (int k = 0; k < n; k++) mean += length[k] / n;
    for (int k = 0; k < n; k++) square += (length[k] - mean) * (length[k] - mean) / (n - 1);
    return fabs(mean) > ALIKE * sqrt(square / n);
}

/* Lengths of the cuts' wires that stand out; gives whether one is farther from the others than a straight line holds for.
   room: as many as cuts. */
static bool find_lengths(const wcut_evidence *e, const wcut_fitted *f, double *length, double *room) {
    int n = 0;
    for (int cut = 0; cut < e->cuts; cut++)
        for (int k = 0; k < e->scatter.count && e->cut[cut].bins > 0; k++) {
            const int at = cut * e->scatter.count + k;
            if (e->scatter.kind[k] != WCUT_SCATTER_LENGTH) continue;
            if (fabs(f->scatter[at]) >= 3 * f->scatter_error[at]) length[cut] = f->scatter[at];
            room[n++] = length[cut];
        }
    if (n == 0 || are_alike(n, room)) return false;

    /* against the middle one */
    wcut_sort(n, room);
    const double middle = sorted_median(n, room);
    bool far = false;
    for (int cut = 0; cut < e->cuts; cut++)
        far = far || (e->cut[cut].bins > 0 && fabs(length[cut] - middle) > FAR_LENGTH);
    return far;
}

/* Wires of other lengths than the job's: the evidence about each cut's own, where that leaves noise alone. Where more is
   wrong, what came out as a length may be a part of it. */
static wcut_status take_lengths(searching *g, wcut_error *error) {
    wcut_evidence *e = g->e;
    wcut_fitted *f = &g->s->none, again = {0};
    double *length = wcut_alloc(2 * (size_t)e->cuts, sizeof *length);
    if (!length) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d cuts", e->cuts);
    const bool far = find_lengths(e, f, length, length + e->cuts);
    wcut_status status = far ? wcut_scatter_take_lengths(e, length, error) : WCUT_OK;
    wcut_free(length);
    if (!far) return WCUT_OK;

    /* a length at which no wire spans its mounts is none */
    if (status == WCUT_OK) status = wcut_model_fit(e, &e->at, &again, error);
    if (status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED) return status;
    const wcut_residual_stats left =
        status == WCUT_OK ? wcut_residual_stats_eval(e, again.standard) : (wcut_residual_stats){0};
    if (status == WCUT_OK && again.cost < f->cost && wcut_residual_is_noise(&again, &left)) {
        wcut_fitted_destroy(f);
        *f = again;
        return WCUT_OK;
    }
    wcut_fitted_destroy(&again);
    return wcut_scatter_take_lengths(e, NULL, error);
}

void wcut_search_destroy(wcut_search *s) {
    wcut_fitted_destroy(&s->none);
    for (int k = 0; k < s->count; k++) wcut_fitted_destroy(&s->candidate[k].fit);
    *s = (wcut_search){0};
}

wcut_status wcut_search_run(wcut_evidence *e, const bool without[WCUT_EFFECT_COUNT], wcut_search *out,
                            wcut_error *error) {
    wcut_search *s = wcut_alloc(1, sizeof *s);
    if (!s) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for the search");
    s->delayed = s->undelayed = -1;

    /* steps of progress follow those of the caller */
    searching g = {.e = e, .s = s, .without = without, .done = e->stop ? e->stop->done + 1 : 0, .formed = -1};

    /* the recalibration: the least that is handed out */
    wcut_status status = search_step(&g, "the recalibration was fitted", error);
    if (status == WCUT_OK) status = wcut_model_fit(e, &e->at, &s->none, error);
    const bool fitted = status == WCUT_OK;
    if (status == WCUT_OK && e->scatter.count > 0) status = take_lengths(&g, error);
    if (status == WCUT_OK) {
        s->left = wcut_residual_stats_eval(e, s->none.standard);
        status = try_singles(&g, error);
    }

    /* forms of the best, pairs, then the candidates with and without the delay of readings */
    if (status == WCUT_OK) status = try_forms(&g, error);
    if (status == WCUT_OK) status = try_pairs(&g, error);
    g.paired = true;
    if (status == WCUT_OK) status = try_halves(&g, error);
    if (status == WCUT_OK) status = try_rest(&g, error);
    if (status == WCUT_OK) status = try_seconds(&g, error);
    if (status == WCUT_OK) status = try_forms(&g, error); /* of another best one */
    if (status == WCUT_OK) status = try_shift(&g, error);
    if (status == WCUT_OK) status = drop_delay(&g, error);
    if (status == WCUT_OK) status = add_delay(&g, error);

    /* hand over what was found, also after an interruption */
    if (status == WCUT_OK || (status == WCUT_INTERRUPTED && fitted))
        *out = *s;
    else
        wcut_search_destroy(s);

    wcut_screen_destroy(&g.screen);
    wcut_free(s);
    return status;
}
