/* facade.step: an assembly of the distinct faces. */
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/exchange.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/facade/element.h"

enum { NAME_SIZE = 64 };

wcut_status wcut_facade_write_step(const wcut_facade_results *results, const char *path, wcut_error *error) {
    if (!results || !path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    const wcut_facade *f = results->description->facade;
    const size_t distinct = (size_t)results->distinct, elements = (size_t)f->elements;
    wcut_shape *shape = wcut_alloc(distinct, sizeof *shape);
    wcut_step_place *place = wcut_alloc(elements, sizeof *place);
    int *number = wcut_alloc(distinct, sizeof *number);
    char(*name)[NAME_SIZE] = wcut_alloc(distinct + elements, sizeof *name);
    int shapes = 0, places = 0;
    wcut_status status = shape && place && number && name
                             ? WCUT_OK
                             : wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));

    /* the faces that are there */
    for (size_t k = 0; status == WCUT_OK && k < distinct; k++) {
        number[k] = shapes;
        if (!results->face[k]) continue;
        snprintf(name[k], NAME_SIZE, "element %zu", k);
        shape[shapes++] = (wcut_shape){.name = name[k], .surface = results->face[k]->surface};
    }

    /* and where they stand */
    for (size_t k = 0; status == WCUT_OK && k < elements; k++) {
        const wcut_facade_element *e = &f->element[k];
        if (!results->item[k].face) continue;
        snprintf(name[distinct + k], NAME_SIZE, "row %d column %d", e->row, e->column);
        place[places++] =
            (wcut_step_place){name[distinct + k], number[results->item[k].distinct], e->origin, e->x, e->z};
    }
    if (status == WCUT_OK && shapes == 0)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "facade: no element has a face, expected at least one");
    if (status == WCUT_OK)
        status = wcut_step_write_assembly(results->description->name, shapes, shape, places, place, path, error);
    wcut_free(shape);
    wcut_free(place);
    wcut_free(number);
    wcut_free(name);
    return status;
}
