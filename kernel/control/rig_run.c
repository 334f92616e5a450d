/* What a closed-loop run holds, and its figures: tension error, overshoot, settling. */
#include "control/rig_run.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"

#define SETTLED 0.05 /* [1] of the target */

static const wcut_channel recorded[] = {WCUT_CHANNEL_TIME,    WCUT_CHANNEL_STATION,   WCUT_CHANNEL_SPEED_A,
                                        WCUT_CHANNEL_SPEED_B, WCUT_CHANNEL_TENSION_A, WCUT_CHANNEL_TENSION_B,
                                        WCUT_CHANNEL_ALPHA_A, WCUT_CHANNEL_BETA_A,    WCUT_CHANNEL_ALPHA_B,
                                        WCUT_CHANNEL_BETA_B,  WCUT_CHANNEL_HEAT,      WCUT_CHANNEL_A_X,
                                        WCUT_CHANNEL_A_Y,     WCUT_CHANNEL_A_Z,       WCUT_CHANNEL_B_X,
                                        WCUT_CHANNEL_B_Y,     WCUT_CHANNEL_B_Z,       WCUT_CHANNEL_SPEED_COMMAND};
enum { RECORDED = sizeof recorded / sizeof *recorded, FIRST_ROOM = 1024 };

/* a longer array with the old one's content; the old one stays where there is no memory */
static bool lengthen(void **array, int count, int room, size_t size) {
    void *longer = wcut_alloc((size_t)room, size);
    if (!longer) return false;
    if (count > 0) memcpy(longer, *array, (size_t)count * size);
    wcut_free(*array);
    *array = longer;
    return true;
}

bool wcut_rig_run_grow(wcut_rig_run *run) {
    const int count = run->recording.samples;
    if (count < run->room) return true;
    if (run->room > 1 << 28) return false;
    const int room = run->room > 0 ? 2 * run->room : FIRST_ROOM;
    for (int k = 0; k < RECORDED; k++) {
        wcut_column *c = &run->recording.channel[recorded[k]];
        if (!c->name) c->name = wcut_copy_text(wcut_channel_name(recorded[k]));
        if (!c->name || !lengthen((void **)&c->value, count, room, sizeof *c->value)) return false;
    }
    if (!lengthen((void **)&run->tension, count, room, sizeof *run->tension) ||
        !lengthen((void **)&run->planned, count, room, sizeof *run->planned) ||
        !lengthen((void **)&run->phase, count, room, sizeof *run->phase) ||
        !lengthen((void **)&run->state, count, room, sizeof *run->state) ||
        !lengthen((void **)&run->beyond, count, room, sizeof *run->beyond))
        return false;
    run->room = room;
    return true;
}

void wcut_rig_run_destroy(wcut_rig_run *run) {
    if (!run) return;
    for (int k = 0; k < RECORDED; k++) {
        wcut_free(run->recording.channel[recorded[k]].name);
        wcut_free(run->recording.channel[recorded[k]].value);
    }
    wcut_free(run->tension);
    wcut_free(run->planned);
    wcut_free(run->phase);
    wcut_free(run->state);
    wcut_free(run->beyond);
    wcut_free(run);
}

/* of the samples from .. to - 1 */
static wcut_rig_figures measure_samples(const wcut_rig_run *run, int from, int to) {
    const double *time = run->recording.channel[WCUT_CHANNEL_TIME].value;
    wcut_rig_figures f = {.from = time[from], .to = time[to - 1]};
    double sum = 0, squares = 0;
    for (int i = from; i < to; i++) {
        const double e = run->tension[i] / run->target - 1;
        sum += e;
        squares += e * e;
        f.max = fmax(f.max, fabs(e));
        if (fabs(e) > SETTLED) f.settled = time[i + 1 < to ? i + 1 : i] - f.from;
    }
    f.mean = sum / (to - from);
    f.rms = sqrt(squares / (to - from));
    return f;
}

void wcut_rig_run_finish(wcut_rig_run *run) {
    const int count = run->recording.samples;
    int from = 0;
    while (from < count && run->phase[from] != WCUT_PHASE_STEADY) from++;
    int to = from;
    while (to < count && run->phase[to] == WCUT_PHASE_STEADY) to++;
    if (to <= from) return;
    run->has_steady = true;
    run->steady = measure_samples(run, from, to);
    int beyond = from;
    while (beyond < to && run->beyond[beyond] < 0.5) beyond++;
    if (beyond == from || beyond == to) return;
    run->has_density = true;
    run->density = measure_samples(run, beyond, to);
}
