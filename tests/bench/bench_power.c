/* Power of the diagnosis: how often an effect is named, and how often it is merely noticed, against its strength, on three
   cuts of 35 s in closed loop with the rig's noise, the job's a and b both off.  bench_power [SEEDS [EFFECT]]
   EFFECT 0, 1, 2: that row of the table alone. */
#include "explain/machine.h"

enum { ROWS = 3, STRENGTHS = 5 };

typedef struct row {
    wcut_effect_kind kind;
    int choice;
    double strength[STRENGTHS];
} row;

static const row table[ROWS] = {{WCUT_EFFECT_WIRE_THERMAL_LAG, 0, {0.03, 0.06, 0.12, 0.25, 0.5}},
                                {WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0, {0.02, 0.04, 0.08, 0.16, 0.32}},
                                {WCUT_EFFECT_ANGLE_OFFSET, 2, {0.05, 0.1, 0.2, 0.4, 0.8}}};

typedef struct tally {
    int named, noticed; /* exactly right, the channel too; any verdict but none */
    double off;         /* [1] relative error of the strength, squared and summed over those named */
} tally;

static void add(const row *r, double strength, int seed, tally *t) {
    const machine_secret secret = {.effects = 1,
                                   .effect = {machine_effect(r->kind, r->choice, strength, 0)},
                                   .law_a = 0.9,
                                   .law_b = 1.1,
                                   .seed = 1000 + (uint64_t)seed};
    machine_case m = machine_create(MACHINE_CUTS, &secret);
    wcut_diagnosis *d = machine_diagnose(&m, NULL);
    t->noticed += d->kind != WCUT_VERDICT_NONE;
    if (machine_names(d, r->kind, r->kind) && d->effect[0].effect.choice == r->choice) {
        t->named++;
        t->off += pow(d->effect[0].effect.value[0] / strength - 1, 2);
    }
    wcut_diagnosis_destroy(d);
    machine_destroy(&m);
}

int main(int count, char **word) {
    const int seeds = count > 1 ? atoi(word[1]) : 4, only = count > 2 ? atoi(word[2]) : -1;
    if (seeds < 1 || only >= ROWS) {
        fprintf(stderr, "usage: bench_power [SEEDS [EFFECT 0 .. %d]]\n", ROWS - 1);
        return EXIT_FAILURE;
    }
    printf("%-24s %9s %9s %9s %12s\n", "effect", "strength", "named", "noticed", "rms error");
    for (int i = 0; i < ROWS; i++)
        for (int k = 0; k < STRENGTHS && (only < 0 || only == i); k++) {
            tally t = {0};
            for (int seed = 0; seed < seeds; seed++) add(&table[i], table[i].strength[k], seed, &t);
            printf("%-24s %9g %6d/%-2d %6d/%-2d", wcut_effect_view(table[i].kind)->name, table[i].strength[k], t.named,
                   seeds, t.noticed, seeds);
            if (t.named > 0) printf(" %10.1f %%", 100 * sqrt(t.off / t.named));
            printf("\n");
            fflush(stdout);
        }
    return EXIT_SUCCESS;
}
