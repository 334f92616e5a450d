/* Any bytes as zones and sections of a user: refused in one printable line, or shapes of a size. */
#include <math.h>
#include <wirecut/regions.h>

#include "file_fuzz.h"

static void check_region(const wcut_region *r) {
    check(isfinite(r->tolerance) && r->tolerance >= 0 && r->share >= 0 && r->share <= 1);
    check(r->low.x <= r->high.x && r->low.y <= r->high.y);
    check(r->corners == 0 || (r->corners >= 3 && r->corners <= WCUT_REGION_POINTS_MAX));
    for (int k = 0; k < 2 * r->corners; k++) check(isfinite(r->corner[k]));
}

static void check_section(const wcut_section *s) {
    check(s->points >= 2 && s->points <= WCUT_REGION_POINTS_MAX && s->width > 0 && s->step > 0);
    for (int k = 0; k < 2 * s->points; k++) check(isfinite(s->point[k]));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    const char *path = fuzz_file(data, size, "json");
    wcut_regions *r = NULL;
    wcut_error error = {WCUT_OK, ""};
    if (!path) return 0;
    const wcut_status status = wcut_regions_read(path, &r, &error);
    check_refusal(status, r != NULL, &error);
    for (int k = 0; r && k < r->regions; k++) check_region(&r->region[k]);
    for (int k = 0; r && k < r->sections; k++) check_section(&r->section[k]);
    wcut_regions_destroy(r);
    remove(path);
    return 0;
}
