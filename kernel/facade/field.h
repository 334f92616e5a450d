/* Fields over a facade, without the checks of the public function. */
#ifndef WCUT_FACADE_FIELD_H
#define WCUT_FACADE_FIELD_H

#include <stdbool.h>
#include <wirecut/facade.h>

/* whether a field's numbers are finite and in range, and its arrays there */
bool wcut_facade_field_is_valid(const wcut_facade_field *field);

/* the sum of valid fields; size: of the facade [mm] */
double wcut_facade_field_sum(int count, const wcut_facade_field *field, const double size[2], double u, double v);

#endif
