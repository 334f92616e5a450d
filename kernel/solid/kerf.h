/* The kerf along the cut: a width over the surface's parameters, as smooth as the surface. */
#ifndef WCUT_SOLID_KERF_H
#define WCUT_SOLID_KERF_H

#include <wirecut/mould.h>

/* A width [mm] in the z of a surface over the same parameters; *width is NULL where the kerf is 0 everywhere.
   WCUT_BAD_ARGUMENT (negative, or 0 at some places only), WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_kerf_width(const wcut_surface *surface, const wcut_mould_options *options, wcut_surface **width,
                            wcut_error *error);

#endif
