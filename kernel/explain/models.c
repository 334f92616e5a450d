/* Models in the rows of the evidence: what each predicts along the exogenous trajectory, every motion driven once; and what a
   scan is free to do. */
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "explain/model_fit.h"

enum { NODES_COARSE = WCUT_NODES_COARSE };

/* ---- rows ---- */

static bool same_effect(const wcut_effect *a, const wcut_effect *b) {
    if (a->kind != b->kind || a->choice != b->choice) return false;
    for (int k = 0; k < WCUT_EFFECT_VALUES; k++)
        if (a->value[k] != b->value[k]) return false;
    return true;
}

static const wcut_effect *next_moving(const wcut_model *m, int *from) {
    while (*from < m->effects) {
        const wcut_effect *e = &m->effect[(*from)++];
        if (wcut_effect_view(e->kind)->place == WCUT_EFFECT_PLACE_STEP && !wcut_effect_is_neutral(e)) return e;
    }
    return NULL;
}

bool wcut_models_same_motion(const wcut_model *a, const wcut_model *b) {
    if (a->a != b->a || a->b != b->b || a->length_change != b->length_change || a->carried != b->carried) return false;
    int i = 0, j = 0;
    for (;;) {
        const wcut_effect *x = next_moving(a, &i), *y = next_moving(b, &j);
        if (!x || !y) return !x && !y;
        if (!same_effect(x, y)) return false;
    }
}

/* rows of one model in one cut; `moved`: what the first model's drive gave, or NULL */
static wcut_status model_rows(const wcut_evidence *e, int cut, const wcut_model *model, const wcut_response *moved,
                              double *rows, wcut_error *error) {
    if (moved) return wcut_evidence_rows(e, cut, model, moved, rows);
    const wcut_evidence_cut *c = &e->cut[cut];
    wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
    const wcut_job job = wcut_model_job(e, model, cut, effect);
    wcut_response d = {0};
    wcut_status status = wcut_response_run(&job, NODES_COARSE, &c->exogenous, c->patch.count > 0, e->stop, &d, error);
    if (status == WCUT_OK) status = wcut_evidence_rows(e, cut, model, &d, rows);
    wcut_response_destroy(&d);
    return status;
}

/* where a model's motion is known already: that of the evidence, -1; of an earlier model of the list; itself */
static int motion_of(const wcut_evidence *e, const wcut_model *model, int k) {
    if (wcut_models_same_motion(&e->at, &model[k])) return -1;
    for (int j = 0; j < k; j++)
        if (wcut_models_same_motion(&model[j], &model[k])) return j;
    return k;
}

wcut_status wcut_models_rows(const wcut_evidence *e, int count, const wcut_model *model, double *rows,
                             wcut_error *error) {
    const int tasks = count * e->cuts;
    wcut_error *failed = wcut_alloc((size_t)tasks, sizeof *failed);
    int *motion = wcut_alloc((size_t)count, sizeof *motion);
    /* an earlier model's drive is kept where a later one moves alike: the first of a list of instruments */
    wcut_response *kept = wcut_alloc((size_t)e->cuts, sizeof *kept);
    int shared = -2;
    wcut_status status = failed && motion && kept ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory");

    /* which model moves the wire as an earlier one does: -1 the reference, k model k */
    for (int k = 0; status == WCUT_OK && k < count; k++) {
        motion[k] = motion_of(e, model, k);
        if (motion[k] >= 0 && motion[k] < k) shared = motion[k];
    }

    /* drive the shared motion once */
    if (status == WCUT_OK && shared >= 0) {
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
        for (int cut = 0; cut < e->cuts; cut++) {
            if (e->cut[cut].bins == 0) continue;
            wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
            const wcut_job job = wcut_model_job(e, &model[shared], cut, effect);
            failed[cut].status = wcut_response_run(&job, NODES_COARSE, &e->cut[cut].exogenous,
                                                   e->cut[cut].patch.count > 0, e->stop, &kept[cut], &failed[cut]);
        }
        for (int cut = 0; status == WCUT_OK && cut < e->cuts; cut++)
            if (failed[cut].status != WCUT_OK) status = wcut_fail(error, failed[cut].status, "%s", failed[cut].text);
    }

    /* the rows of every model in every cut; one whose motion is known is not driven again */
    if (status == WCUT_OK) {
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
        for (int task = 0; task < tasks; task++) {
            const int k = task / e->cuts, cut = task % e->cuts;
            if (e->cut[cut].bins == 0) continue;
            const wcut_response *moved = motion[k] == -1       ? &e->cut[cut].reference
                                         : motion[k] == shared ? &kept[cut]
                                                               : NULL;
            failed[task].status =
                model_rows(e, cut, &model[k], moved, rows + (size_t)k * (size_t)e->rows, &failed[task]);
        }
    }

    /* the first failure in the order of the tasks */
    for (int task = 0; status == WCUT_OK && task < tasks; task++)
        if (failed[task].status != WCUT_OK) status = wcut_fail(error, failed[task].status, "%s", failed[task].text);

    /* release the kept responses */
    for (int cut = 0; kept && cut < e->cuts; cut++) wcut_response_destroy(&kept[cut]);

    wcut_free(kept);
    wcut_free(motion);
    wcut_free(failed);
    return status;
}

/* ---- nuisances ---- */

int wcut_nuisance_count(const wcut_evidence *e) {
    int scans = 0;
    for (int k = 0; k < e->cuts; k++) scans += e->cut[k].patch.count > 0;
    return WCUT_DELAYS + (scans > 0);
}

/* what a second of delay changes in the bins of a signal: the fall over a bin, over its width */
static void delay_column(const wcut_evidence_cut *c, int signal, double *column) {
    const wcut_trajectory *t = &c->exogenous;
    const double half = WCUT_BIN_WIDTH / 2;
    for (int i = 0; i < c->bins && c->reference.signal[signal]; i++) {
        const double late = wcut_between(t->count, t->time, c->reference.signal[signal], c->middle[i] + half);
        const double early = wcut_between(t->count, t->time, c->reference.signal[signal], c->middle[i] - half);
        column[c->row + signal * c->bins + i] = (early - late) / WCUT_BIN_WIDTH;
    }
}

void wcut_nuisance_columns(const wcut_evidence *e, double *column, double *spread) {
    const int count = wcut_nuisance_count(e);
    const size_t rows = (size_t)e->rows;
    memset(column, 0, (size_t)count * rows * sizeof *column);
    for (int k = 0; k < WCUT_DELAYS; k++) spread[k] = e->delay_spread[k];
    for (int k = 0; k < e->cuts; k++)
        for (int s = 0; s < WCUT_SIGNALS; s++) delay_column(&e->cut[k], s, column + (s < 2 ? 0 : rows));
    if (count == WCUT_DELAYS) return;
    double *kerf = column + (size_t)WCUT_DELAYS * rows;
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int i = 0; i < c->patch.count; i++) kerf[c->row + WCUT_SIGNALS * c->bins + i] = -0.5;
    }
    spread[WCUT_DELAYS] = WCUT_KERF_SPREAD;
}
