/* The motion of a comparison's scan onto its face: none, by datums, or a best fit. */
#include "base/alloc.h"
#include "base/fail.h"
#include "io/scan/compare_state.h"

static wcut_status register_datum(wcut_comparing *c, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    wcut_datums *datums = NULL;

    /* pairs of points, and points of plane faces */
    wcut_status status = wcut_datums_read(c->options.datums, &datums, error);
    if (status != WCUT_OK) return wcut_compare_fail(status, c->options.datums, error);

    /* one that did not converge is told at the end */
    wcut_error told = {0};
    status = wcut_registration_solve_datum(datums->pairs, datums->pair, datums->faces, datums->face,
                                           &c->options.registration, &c->registration, &told);
    if (status == WCUT_NOT_CONVERGED) status = WCUT_OK;
    if (status != WCUT_OK)
        wcut_fail(error, status, "%s: %s", wcut_quote(name, c->options.datums, WCUT_LABEL_MAX, 1),
                  told.text[0] ? told.text : wcut_status_text(status));

    /* what is left of each, a point of a face each */
    if (status == WCUT_OK) {
        c->datums = datums->pairs + datums->faces;
        c->datum = wcut_alloc((size_t)c->datums, sizeof *c->datum);
        status = c->datum ? wcut_datum_residual_eval(&c->registration, datums->pairs, datums->pair, datums->faces,
                                                     datums->face, c->datum)
                          : WCUT_NO_MEMORY;
        if (status != WCUT_OK) wcut_compare_fail(status, c->options.datums, error);
    }
    wcut_datums_destroy(datums);
    return status;
}

static wcut_status register_fit(wcut_comparing *c, wcut_error *error) {
    const wcut_compare_face *f = &c->face;
    const wcut_compare_options *o = &c->options;
    const wcut_status status = f->surface && f->others == 0
                                   ? wcut_registration_fit(f->projection, c->cloud.count, c->cloud.point,
                                                           &o->registration, o->threads, &c->registration, error)
                                   : wcut_registration_fit_mesh(f->mesh, f->tree, c->cloud.count, c->cloud.point,
                                                                &o->registration, o->threads, &c->registration, error);

    /* the best pose is given, and that it is in doubt */
    if (status == WCUT_OK || status == WCUT_NOT_CONVERGED) return WCUT_OK;
    return wcut_compare_fail(status, "registering the scan", error);
}

wcut_status wcut_compare_register(wcut_comparing *comparing, wcut_error *error) {
    comparing->registration = wcut_registration_none();
    switch (comparing->options.method) {
        case WCUT_REGISTRATION_METHOD_DATUM:
            return register_datum(comparing, error);
        case WCUT_REGISTRATION_METHOD_FIT:
            return register_fit(comparing, error);
        default:
            return WCUT_OK;
    }
}
