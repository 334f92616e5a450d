/* wirecut facade --element: one element's cut, its face carried to the edges that it shares, its panel and moulds. */
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/wirecut.h>

#include "facade.h"
#include "results.h"
#include "simulation.h"
#include "terminal.h"

/* what a run may leave in its folder */
static const char *const result_name[] = {APP_SIMULATION_FILES, "report.html",  "panel.stl", "panel.step",
                                          "lower.stl",          "lower.step",   "upper.stl", "upper.step",
                                          "mould.json",         "element.json", NULL};

typedef struct element_run {
    app_simulation s;
    wcut_element *element;
    wcut_element_face *face;
    wcut_panel *panel;
    wcut_mould *mould;
    wcut_error refused; /* why a face, a panel or a mould is missing */
} element_run;

/* ---- what is made ---- */

/* an outcome that is told and leaves the rest of the results */
static bool is_outcome(wcut_status status) { return status == WCUT_DEGENERATE || status == WCUT_NOT_CONVERGED; }

/* the face in the block, on the shared edges */
static wcut_status make_element_face(element_run *r, wcut_error *error) {
    const wcut_history *h = r->s.history;
    const double *const border[4] = {r->element->border[0], r->element->border[1], r->element->border[2],
                                     r->element->border[3]};
    return wcut_element_face_create(r->s.surface, r->s.job->block_size, border, h->stations, h->nodes, h->position,
                                    h->force_line, &r->face, error);
}

/* cast on the lower half it lies above the face, on the upper half below it */
static wcut_status make_element_panel(element_run *r, wcut_error *error) {
    const wcut_element_options *o = &r->element->options;
    if (!(o->thickness > 0)) return WCUT_OK;
    return wcut_panel_create(r->face, r->element->upper ? -o->thickness : o->thickness, o->chord_tolerance, &r->panel,
                             error);
}

/* the halves of the block as they are cut, with the job's kerf */
static wcut_status make_element_mould(element_run *r, wcut_error *error) {
    const wcut_history *h = r->s.history;
    if (!r->element->options.moulds) return WCUT_OK;
    wcut_mould_options o = wcut_mould_default();
    double *parameter = calloc((size_t)h->stations, sizeof *parameter);
    double *kerf = calloc((size_t)h->stations * (size_t)h->nodes, sizeof *kerf);
    wcut_surface *surface = NULL;

    /* the kerf over the parameters of the stations */
    wcut_status status = parameter && kerf ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK)
        status = wcut_surface_loft(h->stations, h->nodes, h->position, APP_MERGE_MM, &surface, parameter, NULL);
    if (status == WCUT_OK) status = wcut_history_kerf(r->s.job, h, kerf);
    o.chord_tolerance = r->element->options.chord_tolerance;
    o.fit_tolerance = 0.05; /* mm: as the face of an element follows its cut */
    o.kerf_stations = h->stations, o.kerf_nodes = h->nodes;
    o.kerf_parameter = parameter, o.kerf_field = kerf;
    o.wire_diameter = r->s.job->wire_diameter;
    if (status == WCUT_OK) status = wcut_mould_create(surface, r->s.job->block_size, &o, &r->mould, error);
    wcut_surface_destroy(surface);
    free(parameter);
    free(kerf);
    return status;
}

/* all of it, as far as it goes; what is refused is said with its place */
static int make_element_parts(element_run *r) {
    wcut_error error = {0};
    wcut_status status = r->s.surface ? make_element_face(r, &error) : WCUT_OK;
    if (status == WCUT_OK && r->face) status = make_element_panel(r, &error);
    if (status == WCUT_OK && r->face) status = make_element_mould(r, &error);
    if (is_outcome(status)) r->refused = error;
    return status == WCUT_OK || is_outcome(status) ? APP_DONE : app_fail_status(status, r->s.path, &error);
}

/* ---- the files ---- */

static int add_stl(element_run *r, const char *name, const wcut_mesh *mesh) {
    wcut_error error = {0};
    const wcut_status status = wcut_mesh_write_stl(mesh, app_results_path(&r->s.results, name), &error);
    return app_results_add(&r->s.results, name, status, &error);
}

static int add_solid(element_run *r, const char *name, const char *shown, const wcut_brep *solid) {
    wcut_error error = {0};
    const wcut_shape shape = {.name = shown, .solid = solid};
    const wcut_status status =
        wcut_step_write(1, &shape, WCUT_STEP_SCHEMA_AP214, app_results_path(&r->s.results, name), &error);
    return app_results_add(&r->s.results, name, status, &error);
}

static int write_panel(element_run *r) {
    if (!r->panel) return APP_DONE;
    const int code = add_stl(r, "panel.stl", r->panel->mesh);
    return code == APP_DONE ? add_solid(r, "panel.step", "panel", r->panel->solid) : code;
}

/* both halves; a half made by booleans has no exact faces */
static int write_mould_files(element_run *r) {
    wcut_error error = {0};
    if (!r->mould) return APP_DONE;
    int code = add_stl(r, "lower.stl", r->mould->lower.mesh);
    if (code == APP_DONE) code = add_stl(r, "upper.stl", r->mould->upper.mesh);
    if (code == APP_DONE && r->mould->lower.brep) code = add_solid(r, "lower.step", "lower", r->mould->lower.brep);
    if (code == APP_DONE && r->mould->upper.brep) code = add_solid(r, "upper.step", "upper", r->mould->upper.brep);
    if (code != APP_DONE) return code;
    const wcut_status status =
        wcut_mould_write(r->mould, r->s.job->name, app_results_path(&r->s.results, "mould.json"), &error);
    return app_results_add(&r->s.results, "mould.json", status, &error);
}

static int write_element_report(element_run *r) {
    wcut_error error = {0};
    const wcut_report_simulate run = {.job_path = r->s.path,
                                      .integrator = "implicit",
                                      .chord_tolerance = r->element->options.chord_tolerance,
                                      .merge = APP_MERGE_MM,
                                      .ended = r->s.ended};
    const wcut_status status = wcut_report_simulate_write(&run, r->s.setup, r->s.history,
                                                          app_results_path(&r->s.results, "report.html"), &error);
    return app_results_add(&r->s.results, "report.html", status, &error);
}

static int write_element(element_run *r) {
    int code = app_simulation_write(&r->s);
    if (code == APP_DONE) code = make_element_parts(r);
    if (code == APP_DONE) code = write_panel(r);
    if (code == APP_DONE) code = write_mould_files(r);
    if (code == APP_DONE) code = write_element_report(r);
    if (code != APP_DONE) return code;

    /* with the result the others count */
    char *text = NULL;
    const char *refused = r->refused.text[0] ? r->refused.text : NULL;
    const wcut_status status =
        wcut_element_result_print(r->element, r->s.setup, r->s.history, r->face, r->panel, refused, &text);
    return app_results_commit(&r->s.results, "element.json", status, text);
}

/* ---- the run ---- */

static int load_element(element_run *r) {
    wcut_error error = {0};
    wcut_status status = wcut_element_read(r->s.path, &r->element, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);

    /* the job is the simulation's from now on */
    r->s.job = r->element->job;
    r->element->job = NULL;
    status = wcut_setup_create(r->s.job, NULL, &r->s.setup, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, r->s.path, &error);
}

int app_facade_element(const app_call *call) {
    element_run r = {.s = {.call = call, .path = call->operand[0]}};
    int ended = APP_DONE, code = load_element(&r);
    if (code == APP_DONE) code = app_results_begin(&r.s.results, app_text(call, "output"), result_name);

    /* a cut that ends early leaves what there is of it */
    if (code == APP_DONE) {
        app_catch_interrupts();
        ended = app_simulation_run(&r.s);
        if (ended != APP_INTERRUPTED && r.s.history && r.s.history->stations > 0) code = write_element(&r);
        if (code == APP_DONE) code = ended;
    }
    if (code == APP_DONE && app_given(call, "json")) fputs(r.s.results.text, stdout);

    /* what was asked for and cannot be made is outside what the element allows */
    if (code == APP_DONE && r.refused.text[0]) code = app_fail(APP_OUTSIDE, "%s: %s", r.s.path, r.refused.text);
    wcut_element_face_destroy(r.face);
    wcut_panel_destroy(r.panel);
    wcut_mould_destroy(r.mould);
    wcut_element_destroy(r.element);
    app_simulation_clear(&r.s);
    return code;
}
