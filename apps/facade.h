/* What the two halves of wirecut facade share: a facade of elements, and one element by itself. */
#ifndef APP_FACADE_H
#define APP_FACADE_H

#include "command.h"

#define APP_FACADE_FORMATS "vtp,stl,obj,ply,glb,csv,step"

/* facade_element.c: one element, its results into the folder; an exit code */
int app_facade_element(const app_call *call);

#endif
