/* A whole cut in memory. */
#include <string.h>
#include <wirecut/history.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "cut/run.h"
#include "cut/sensitivity.h"

static wcut_history *create_history(int stations, int nodes) {
    const size_t m = (size_t)stations, n = (size_t)nodes;
    wcut_history *h = wcut_alloc(1, sizeof *h);
    if (!h) return NULL;
    h->planned = stations;
    h->nodes = nodes;
    h->row = wcut_alloc(m, sizeof *h->row);
    h->position = wcut_alloc(m * n, sizeof *h->position);
    h->force = wcut_alloc(m * n, sizeof *h->force);
    h->force_line = wcut_alloc(m * n, sizeof *h->force_line);
    h->speed = wcut_alloc(m * n, sizeof *h->speed);
    h->tension = wcut_alloc(m * (n - 1), sizeof *h->tension);
    if (h->row && h->position && h->force && h->force_line && h->speed && h->tension) return h;
    wcut_history_destroy(h);
    return NULL;
}

void wcut_history_destroy(wcut_history *h) {
    if (!h) return;
    wcut_free(h->row);
    wcut_free(h->position);
    wcut_free(h->force);
    wcut_free(h->force_line);
    wcut_free(h->speed);
    wcut_free(h->tension);
    wcut_free(h);
}

static void append_station(wcut_history *h, const wcut_cut *cut) {
    wcut_station s;
    wcut_cut_view(cut, &s);

    /* arrays of the nodes go behind those of the last station */
    const size_t n = (size_t)h->nodes, at = (size_t)h->stations * n;
    if (cut->sensitivity) wcut_sensitivity_store(cut->sensitivity, h->stations);
    memcpy(h->position + at, s.position, n * sizeof *s.position);
    memcpy(h->force + at, s.force, n * sizeof *s.force);
    memcpy(h->force_line + at, s.force_line, n * sizeof *s.force_line);
    memcpy(h->speed + at, s.speed, n * sizeof *s.speed);
    memcpy(h->tension + (size_t)h->stations * (n - 1), s.tension, (n - 1) * sizeof *s.tension);

    /* scalars of the station as a row */
    h->row[h->stations++] = (wcut_history_row){.time = s.time,
                                               .duration = s.duration,
                                               .speed_a = s.speed_a,
                                               .speed_b = s.speed_b,
                                               .tension_a = s.tension_a,
                                               .tension_b = s.tension_b,
                                               .alpha_a = s.alpha_a,
                                               .beta_a = s.beta_a,
                                               .alpha_b = s.alpha_b,
                                               .beta_b = s.beta_b,
                                               .engaged_length = s.engaged_length,
                                               .residual = s.residual,
                                               .iterations = s.iterations,
                                               .substeps = s.substeps,
                                               .phase = s.phase,
                                               .condition = s.condition};
}

/* run a cut to its end, or as far as it goes; h->ended says why it went no further */
static wcut_status fill_history(wcut_cut *cut, wcut_progress progress, void *context, wcut_history *h) {
    wcut_status status = WCUT_OK;
    h->stations = 0;
    h->ended = (wcut_error){.status = WCUT_OK};
    append_station(h, cut);
    while (status == WCUT_OK && h->stations < h->planned) {
        status = wcut_cut_step(cut, &h->ended);
        if (status != WCUT_OK) break;
        append_station(h, cut);
        if (progress && progress(h->stations, h->planned, context) != 0)
            status = wcut_fail(&h->ended, WCUT_INTERRUPTED, "station %d of %d: stopped on request", h->stations - 1,
                               h->planned);
    }
    return status;
}

/* A run that found no way on, once more with a weight from station 0 on; it is kept if it comes further. */
static wcut_status run_heavy(const wcut_setup *setup, wcut_progress progress, void *context, wcut_history **history) {
    wcut_cut *cut = NULL;

    /* a history of its own, because the first one may be the longer */
    wcut_history *h = create_history((*history)->planned, (*history)->nodes);
    wcut_status status = h ? wcut_cut_create(setup, &cut, NULL) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        wcut_contact_rule_set(cut, WCUT_CONTACT_HEAVY);
        status = fill_history(cut, progress, context, h);
    }

    if (h && h->stations > (*history)->stations) {
        wcut_history *shorter = *history;
        *history = h;
        h = shorter;
    } else {
        status = (*history)->ended.status;
    }

    wcut_history_destroy(h);
    wcut_cut_destroy(cut);
    return status;
}

wcut_status wcut_setup_run(const wcut_setup *setup, wcut_progress progress, void *context, wcut_history **history,
                           wcut_error *error) {
    if (!setup || !history) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a setup and a place for the history expected");
    wcut_cut *cut = NULL;
    wcut_status status = wcut_cut_create(setup, &cut, error);
    if (status != WCUT_OK) return status;

    /* a history of the planned size */
    const int nodes = setup->job->nodes;
    wcut_history *h = create_history(setup->stations, nodes);
    if (!h) {
        wcut_cut_destroy(cut);
        return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a history of %d stations of %d nodes", setup->stations,
                         nodes);
    }
    status = fill_history(cut, progress, context, h);
    wcut_cut_destroy(cut);

    /* where it ends early in path mode: with a weight from the beginning */
    const bool other = !setup->foam.embedded && !setup->bow.on &&
                       setup->options.integrator == WCUT_INTEGRATOR_IMPLICIT && !setup->options.weighted;
    if (other && status == WCUT_NOT_CONVERGED) status = run_heavy(setup, progress, context, &h);

    /* a design whose plan went no further */
    if (status == WCUT_OK && setup->plan_ended.status != WCUT_OK) {
        status = setup->plan_ended.status;
        h->ended = setup->plan_ended;
        h->planned += setup->job->stations - (setup->part_last - setup->part_first + 1);
    }
    if (error && status != WCUT_OK) *error = h->ended;
    *history = h;

    return status;
}

wcut_status wcut_setup_differentiate(const wcut_setup *setup, const wcut_end_motion *motion, wcut_vec3 *by,
                                     wcut_history **history, wcut_error *error) {
    wcut_cut *cut = NULL;
    wcut_sensitivity s = {0};
    wcut_status status = wcut_cut_create(setup, &cut, error);
    if (status != WCUT_OK) return status;
    wcut_history *h = create_history(setup->stations, setup->job->nodes);
    if (h && wcut_sensitivity_create(setup, motion, by, &s)) {
        cut->sensitivity = &s;
        wcut_sensitivity_begin(cut);
        status = fill_history(cut, NULL, NULL, h);
        if (status == WCUT_OK && s.failed)
            status = wcut_fail(&h->ended, WCUT_SINGULAR, "a step of the run has no derivative");
        if (error && status != WCUT_OK) *error = h->ended;
        *history = h;
    } else {
        wcut_history_destroy(h);
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a history of %d stations with its derivatives",
                           setup->stations);
    }
    wcut_sensitivity_destroy(&s);
    wcut_cut_destroy(cut);
    return status;
}
