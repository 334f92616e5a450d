/* What a diagnosis says in words: the verdict for an operator, and what could not be told. */
#include "explain/verdict_text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "explain/library.h"
#include "explain/rig.h"

typedef struct text {
    char *to;
    size_t size, at;
} text;

static void append_text(text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void append_text(text *t, const char *format, ...) {
    va_list list;
    va_start(list, format);
    const int length = vsnprintf(t->to + t->at, t->size - t->at, format, list);
    va_end(list);
    if (length > 0) t->at = t->at + (size_t)length < t->size ? t->at + (size_t)length : t->size - 1;
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
static void add_number(text *t, const wcut_explanation *p, double value) {
    char number[64];
    snprintf(number, sizeof number, p->number, p->unit * value);
    append_text(t, " (%s)", number);
}
#pragma GCC diagnostic pop

/* change of density along an axis: by how much, and for a step from where on, for a band from where to where */
static void add_gradient_words(text *t, const wcut_diagnosis *d, const wcut_effect *e) {
    static const char *const along[] = {"across the block (x)", "along the feed (y)", "over the height (z)"};
    const int axis = e->choice % 3, form = e->choice / 3;
    const double size = axis == 0 ? d->view.block.x : axis == 1 ? d->view.block.y : d->view.block.z;
    const double percent = fabs(100 * e->value[WCUT_FOAM_DENSITY_GRADIENT_CHANGE]);
    const char *more = e->value[WCUT_FOAM_DENSITY_GRADIENT_CHANGE] < 0 ? "softer" : "denser";
    if (form == 0)
        append_text(t, "the foam gets %.0f %% %s %s", percent, more, along[axis]);
    else if (form == 1)
        append_text(t, "the foam is %.0f %% %s at its sides than in its middle, %s", percent, more, along[axis]);
    else if (form == 3) {
        const double middle = e->value[WCUT_FOAM_DENSITY_GRADIENT_STEP_AT],
                     half = e->value[WCUT_FOAM_DENSITY_GRADIENT_BAND] / 2;
        append_text(t, "the foam is %.0f %% %s from %c %.0f to %.0f mm", percent, more, "xyz"[axis],
                    (middle - half) * size, (middle + half) * size);
    } else if (size > 0)
        append_text(t, "the foam is %.0f %% %s from %c %.0f mm on", percent, more, "xyz"[axis],
                    e -> value[WCUT_FOAM_DENSITY_GRADIENT_STEP_AT] * size);
    else
        append_text(t, "the foam is %.0f %% %s from %.0f %% of its size on, %s", percent, more,
                    100 * e->value[WCUT_FOAM_DENSITY_GRADIENT_STEP_AT], along[axis]);
}

/* forms of fouling beside the first, which ends at a limit */
static const char *fouling_words(int form) {
    static const char *const words[] = {"", ", evenly", ", by its root", ", and falls off each time"};
    return words[form];
}

/* effects that are told by where and how much; false: by their phrase and first value */
static bool add_place_words(text *t, const wcut_diagnosis *d, const wcut_effect *e) {
    const double *v = e->value, *at = &v[WCUT_FOAM_INCLUSION_POSITION];
    switch (e->kind) {
        /* the foam: where it is denser, and by how much */
        case WCUT_EFFECT_FOAM_INCLUSION:
            append_text(t, "a spot %.0f %% %s at x %.0f, y %.0f, z %.0f mm, radius %.0f mm",
                        fabs(100 * v[WCUT_FOAM_INCLUSION_AMPLITUDE]),
                        v[WCUT_FOAM_INCLUSION_AMPLITUDE] < 0 ? "softer" : "denser", at[0], at[1], at[2],
                        v[WCUT_FOAM_INCLUSION_RADIUS]);
            return true;
        case WCUT_EFFECT_FOAM_DENSITY_GRADIENT:
            add_gradient_words(t, d, e);
            return true;

        /* the wire: how strong, and over what length or time it fades */
        case WCUT_EFFECT_END_COOLING:
            append_text(t, "the wire is %.0f %% cooler at its mounts, fading over %.0f mm%s",
                        100 * v[WCUT_END_COOLING_AMPLITUDE], v[WCUT_END_COOLING_LENGTH],
                        e->choice == 1 ? " like a Gaussian" : "");
            return true;
        case WCUT_EFFECT_WIRE_FOULING:
            append_text(t, "residue on the wire changes the force by %+.0f %% over %.0f mm of way%s",
                        100 * v[WCUT_WIRE_FOULING_CHANGE], v[WCUT_WIRE_FOULING_LENGTH], fouling_words(e->choice / 2));
            return true;
        case WCUT_EFFECT_AIR_OVERHEATING:
            append_text(t, "the wire enters the foam overheated by the air (%.2f times its power at first, for %.1f s)",
                        v[WCUT_AIR_OVERHEATING_RATIO], v[WCUT_AIR_OVERHEATING_TIME_CONSTANT]);
            return true;

        /* one number says it all */
        default:
            return false;
    }
}

static void add_effect(text *t, const wcut_diagnosis *d, const wcut_found_effect *f) {
    const wcut_effect_info *info = wcut_effect_view(f->effect.kind);
    const wcut_explanation *p = wcut_explanation_view(f->effect.kind);
    if (add_place_words(t, d, &f->effect)) return;
    append_text(t, "%s", p->phrase);
    if (info->choice && (info->choice_required || f->effect.choice > 0))
        append_text(t, " [%s %s]", info->choice_key, info->choice[f->effect.choice]);
    if (f->effect.kind == WCUT_EFFECT_KERF_GROWTH && f->effect.choice == 1)
        append_text(t, " (%.2f mm for e times the heat)", f->effect.value[WCUT_KERF_GROWTH_PER_LOG]);
    else
        add_number(t, p, f->effect.value[0]);
}

/* what is there, but of no consequence: what it moves */
static void add_small(text *t, const wcut_diagnosis *d) {
    const wcut_small_effect *small = &d->small_effect;
    if (d->small_effects == 0) return;
    append_text(t, " Present, but too small to matter for the cut: ");
    add_effect(t, d, &small->found);
    append_text(t, "; it moves the tensions by %.3f N at most", small->tension);
    if (isfinite(small->face)) append_text(t, " and the face by %.2f mm", small->face);
    append_text(t, ".");
}

void wcut_diagnosis_sentence(wcut_diagnosis *d) {
    /* the beginning depends on the verdict */
    text t = {d->sentence, sizeof d->sentence, 0};
    char scatter[WCUT_DIAGNOSIS_TEXT - 150];
    switch (d->kind) {
        case WCUT_VERDICT_NONE:
            append_text(&t, "No difference beyond noise: the recalibrated simulation predicts these cuts");
            wcut_rig_sentence(d, sizeof scatter, scatter);
            if (scatter[0]) append_text(&t, " within the scatter of the rig (%s)", scatter);
            append_text(&t, ".");
            add_small(&t, d);
            return;
        case WCUT_VERDICT_UNKNOWN:
            append_text(&t, "An unknown effect changes these cuts");
            if (d->mismatches > 0) {
                const wcut_mismatch *m = &d->mismatch[0];
                append_text(&t, ", most of all %s of cut %d from %.0f to %.0f s", m->column, m->cut + 1, m->time[0],
                            m->time[1]);
            }
            append_text(&t, "; no term that was tried predicts the held-out cuts.");
            return;
        case WCUT_VERDICT_AMBIGUOUS:
            append_text(&t, "Either ");
            break;
        default:
            break;
    }

    /* the effects, joined with "and", or "or" where several explain the same */
    for (int k = 0; k < d->effects; k++) {
        if (k > 0) append_text(&t, d->kind == WCUT_VERDICT_AMBIGUOUS ? ", or " : ", and ");
        add_effect(&t, d, &d->effect[k]);
    }

    /* a sentence begins with a capital letter */
    append_text(&t, ".");
    if (d->form_open)
        append_text(&t, " %s not told from these cuts: the form above leaves more than noise, or another as little.",
                    d->effects > 1 ? "Their forms are" : "Its form is");
    if (t.at > 0 && d->kind != WCUT_VERDICT_AMBIGUOUS && d->sentence[0] >= 'a' && d->sentence[0] <= 'z')
        d->sentence[0] = (char)(d->sentence[0] - 'a' + 'A');
}

/* ---- limits ---- */

enum { LIMITS_MAX = 14 };

/* [1] a filter of the amplifier and coarse digits make three of it */
#define SWIFT 5.0

static void add_limit(wcut_diagnosis *d, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add_limit(wcut_diagnosis *d, const char *format, ...) {
    if (d->limits == LIMITS_MAX) return;
    va_list list;
    va_start(list, format);
    vsnprintf(d->limit[d->limits++], WCUT_DIAGNOSIS_TEXT, format, list);
    va_end(list);
}

static bool has_commands(const wcut_recording *r) { return r->channel[WCUT_CHANNEL_SPEED_COMMAND].name != NULL; }

static int missing_channels(const wcut_recording *r) {
    int missing = 0;
    for (int k = WCUT_CHANNEL_TENSION_A; k <= WCUT_CHANNEL_BETA_B; k++) missing += r->channel[k].missing == r->samples;
    return missing;
}

static void limit_cuts(wcut_diagnosis *d, int cuts, const wcut_diagnosis_cut *cut) {
    /* count what the cuts have: scans, excitations, commanded speeds, empty channels, range of heats */
    int used = 0, scans = 0, excited = 0, commands = 0, missing = 0;
    double min = HUGE_VAL, max = 0;
    for (int k = 0; k < cuts; k++) {
        if (!cut[k].job || !cut[k].recording) {
            add_limit(d, "Cut %d is left out: it has no %s.", k + 1, cut[k].job ? "recording" : "job");
            continue;
        }
        used++, scans += cut[k].scan != NULL, commands += has_commands(cut[k].recording);
        excited += cut[k].job->dither_count > 0 || cut[k].job->heat_step_count > 0;
        missing += missing_channels(cut[k].recording);
        min = fmin(min, cut[k].job->heat), max = fmax(max, cut[k].job->heat);
    }

    /* a sentence for everything that is missing */
    if (used == 1)
        add_limit(
            d,
            "With one cut nothing can be held out, and effects of the block cannot be separated from effects of time.");
    if (scans == 0) add_limit(d, "Without a scan kerf, springback and errors of the scanner cannot be determined.");
    if (excited == 0)
        add_limit(d,
                  "No cut has an excitation: a clock offset, a short lag and a dependence on the speed can hardly be "
                  "separated (wirecut identify makes such cuts).");
    if (used > 0 && commands == 0) add_limit(d, "The commanded speed is not recorded: the diagnosis has less power.");
    if (missing > 0) add_limit(d, "%d channels of the recordings are empty.", missing);
    if (used > 0 && max < 1.05 * min)
        add_limit(d,
                  "All cuts have one heat: a and b are separated by the speed only, and they contain any loss of "
                  "heat.");
}

static void limit_calibration(wcut_diagnosis *d, int test_cuts, const wcut_test_cut *calibration) {
    wcut_calibration *fit = wcut_alloc(1, sizeof *fit);
    if (!fit) return; /* one sentence less */
    wcut_calibration_point *none = NULL;
    if (test_cuts == 0)
        add_limit(d, "There is no calibration table: a and b come from these cuts only.");
    else if (wcut_calibration_fit(test_cuts, calibration, NULL, fit, none, NULL) == WCUT_OK) {
        const double reference = fit->reference_force, speed = d->b.value * fit->reference_heat * 1000;
        const double ours = speed / log(d->a.value / reference);
        if (reference < d->a.value && fabs(ours - fit->reference_speed) > 4 * fit->reference_speed_error)
            add_limit(
                d,
                "The calibration table contradicts the cuts: at %.4f N/mm and %.0f W/m it has %.1f +- %.1f mm/s, the "
                "cuts %.1f.",
                reference, fit->reference_heat, fit->reference_speed, 2 * fit->reference_speed_error, ours);
    }
    wcut_free(fit);
}

bool wcut_diagnosis_limits(wcut_diagnosis *d, int cuts, const wcut_diagnosis_cut *cut, int test_cuts,
                           const wcut_test_cut *calibration) {
    d->limit = wcut_alloc(LIMITS_MAX, sizeof *d->limit);
    if (!d->limit) return false;
    limit_cuts(d, cuts, cut);
    if (d->swift > SWIFT)
        add_limit(d,
                  "The tension changes from one half second to the next by %.0f times what its readings say: something "
                  "faster "
                  "(ripple of the heater, vibration) counts as noise here and hides what is small.",
                  d->swift);
    if (d->droop > 0)
        add_limit(
            d,
            "The slack wires hang by their weight before they touch, which the jobs do not say (density_kg_per_m3): "
            "the first %.0f s in the foam at most are left out.",
            d->droop);
    if (d->unprofiled[0])
        add_limit(d, "Intervals are those of the misfit's curvature, not of its profile: %s.", d->unprofiled);
    if (d->unproven[0]) add_limit(d, "There is no forward proof: %s.", d->unproven);
    limit_calibration(d, test_cuts, calibration);

    /* what the named effects cannot be told from */
    for (int k = 0; k < d->effects; k++)
        if (d->effect[k].effect.kind == WCUT_EFFECT_SCAN_OFFSET)
            add_limit(
                d,
                "A block that lies displaced the other way by as much would be scanned alike: the wire's tension and "
                "directions do not tell it from the scanner here.");
    for (int k = 0; k < d->effects; k++)
        if (d->effect[k].effect.kind == WCUT_EFFECT_TENSION_GAIN && d->effect[k].effect.choice < 2)
            add_limit(d,
                      "It cannot be determined which of the two tension sensors is wrong: one gain up and the other "
                      "down differ only in a.");
    return true;
}
