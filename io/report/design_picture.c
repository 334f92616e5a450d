/* The map of a target as a picture from above: x to the right, y up. */
#include <math.h>
#include <stddef.h>
#include <wirecut/design_file.h>
#include <wirecut/overlay_file.h>

#include "base/fail.h"
#include "io/scan/colour.h"

enum { LONGER_SIDE = 900 }; /* px */

#define WHY 0.75 /* [1] brightness of every other stripe where there is a reason */

enum { STRIPE = 6 }; /* px */

/* the map between its rows and columns, bilinear; at its ends the nearest */
static double bow_at_pixel(const wcut_design_map *m, double column, double row) {
    const int i = column < m->columns - 2 ? (int)column : m->columns - 2,
              j = row < m->rows - 2 ? (int)row : m->rows - 2;
    const double u = column - i, v = row - j;
    const double *low = m->bow + (size_t)j * (size_t)m->columns + i, *high = low + m->columns;
    return (1 - v) * ((1 - u) * low[0] + u * low[1]) + v * ((1 - u) * high[0] + u * high[1]);
}

wcut_status wcut_design_map_write_png(const wcut_design_map *map, double limit, const char *path, wcut_error *error) {
    const wcut_design_map *m = map;
    if (!m || !m->point || !m->bow || !m->reason || m->rows < 2 || m->columns < 2 || !(limit > 0 && isfinite(limit)) ||
        !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a map, a positive limit and a path are expected");

    /* even pixels */
    const size_t last = (size_t)m->rows * (size_t)m->columns - 1;
    const double width = m->point[last].x - m->point[0].x, length = m->point[last].y - m->point[0].y;
    const double side = fmax(width, length) / LONGER_SIDE;
    if (!(width > 0 && length > 0)) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a map that has an extent is expected");
    const int across = (int)fmax(width / side + 0.5, 2), along = (int)fmax(length / side + 0.5, 2);
    wcut_picture *picture = NULL;
    wcut_status status = wcut_picture_create(across, along, 3, &picture);
    if (status != WCUT_OK) return wcut_fail(error, status, "a picture: %s", wcut_status_text(status));

    /* colours of the bow; stripes where no wire follows */
    for (int r = 0; r < along; r++)
        for (int c = 0; c < across; c++) {
            const double column = (m->columns - 1.0) * c / (across - 1),
                         row = (m->rows - 1.0) * (along - 1 - r) / (along - 1);
            unsigned char *rgb = picture->pixel + 3 * ((size_t)r * (size_t)across + (size_t)c);
            wcut_deviation_colour(bow_at_pixel(m, column, row), limit, rgb);
            const int reason = m->reason[(size_t)(row + 0.5) * (size_t)m->columns + (size_t)(column + 0.5)];
            for (int k = 0; reason && (r + c) / STRIPE % 2 && k < 3; k++) rgb[k] = (unsigned char)(WHY * rgb[k]);
        }
    status = wcut_picture_write(picture, side, path, error);
    wcut_picture_destroy(picture);
    return status;
}
