/* A wire of one cut that is far from the length its job states: a wrong wire, where two millimetres are a wire cut by hand. */
#include "explain/cut_length.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "explain/library.h"

/* half widths at 95 % that a length must be of */
#define STANDS_OUT 3.0

static const wcut_rig_row *length_row(const wcut_diagnosis *d) {
    for (int k = 0; k < d->rig_rows; k++)
        if (strcmp(d->rig[k].name, wcut_scatter_name(WCUT_SCATTER_LENGTH)) == 0) return &d->rig[k];
    return NULL;
}

static void add_cut_length(wcut_diagnosis *d, int cut, const wcut_estimate *length) {
    wcut_found_effect *f = &d->effect[d->effects++];
    *f = (wcut_found_effect){.effect = wcut_effect_default(WCUT_EFFECT_WIRE_LENGTH),
                             .cut = cut + 1,
                             .present = true,
                             .confidence = d->confidence};
    f->effect.value[WCUT_WIRE_LENGTH_CHANGE] = length->value;
    f->parameter[WCUT_WIRE_LENGTH_CHANGE] = *length;
    f->estimated[WCUT_WIRE_LENGTH_CHANGE] = true;
    if (d->kind == WCUT_VERDICT_NONE) d->kind = WCUT_VERDICT_INSTRUMENT;
    if (d->kind == WCUT_VERDICT_PHYSICS) d->kind = WCUT_VERDICT_BOTH;
}

void wcut_cut_length_report(wcut_diagnosis *d) {
    const wcut_rig_row *row = length_row(d);
    const double least = wcut_explanation_view(WCUT_EFFECT_WIRE_LENGTH)->gate;
    if (!row || d->kind == WCUT_VERDICT_UNKNOWN || d->kind == WCUT_VERDICT_AMBIGUOUS) return;

    /* each cut whose wire stands out, and a sentence for it, as far as there is room */
    char before[WCUT_DIAGNOSIS_TEXT] = "", behind[WCUT_DIAGNOSIS_TEXT];
    size_t at = 0;
    const bool none = d->kind == WCUT_VERDICT_NONE; /* "No difference .." would contradict it */
    snprintf(behind, sizeof behind, "%s%.*s", none ? "Otherwise n" : "", (int)sizeof behind - 16, d->sentence + none);
    for (int k = 0; k < row->cuts && d->effects < WCUT_DIAGNOSIS_EFFECTS; k++) {
        const wcut_estimate *length = &row->of_cut[k];
        if (fabs(length->value) < least || fabs(length->value) < STANDS_OUT * (length->high - length->low) / 2)
            continue;
        add_cut_length(d, row->cut[k], length);
        char text[120];
        const int size = snprintf(text, sizeof text, "The wire of cut %d is %.1f mm %s than its job states. ",
                                  row->cut[k] + 1, fabs(length->value), length->value > 0 ? "longer" : "shorter");
        if (at + (size_t)size + strlen(behind) + 1 > sizeof d->sentence) continue;
        memcpy(before + at, text, (size_t)size + 1);
        at += (size_t)size;
    }
    if (at == 0) return;
    memcpy(d->sentence, before, at);
    memcpy(d->sentence + at, behind, strlen(behind) + 1);
}
