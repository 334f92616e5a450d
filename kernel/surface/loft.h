/* Which of a wire's stations a surface can pass through, and their parameters. */
#ifndef WCUT_SURFACE_LOFT_H
#define WCUT_SURFACE_LOFT_H

#include <wirecut/surface.h>

typedef struct wcut_sections {
    int kept;
    int *station; /* kept */
    double *v;    /* kept parameters over [0, 1] at averaged chord length */
} wcut_sections;

/* the sections that differ from the one kept before; WCUT_DEGENERATE, WCUT_NO_MEMORY: nothing was written */
wcut_status wcut_sections_pick(int stations, int nodes, const wcut_vec3 *position, double merge,
                               wcut_sections *sections);

/* v of every station: of the section kept before, where it was dropped */
void wcut_sections_spread(const wcut_sections *sections, int stations, double *parameter);

/* free what wcut_sections_pick gave; zeroed sections are allowed */
void wcut_sections_clear(wcut_sections *sections);

#endif
