/* A block divided along any surface: a status with its words, or two proven solids, never anything between. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/mould.h>

enum { SIDE_MAX = 8 };

static void demand(int truth) {
    if (!truth) abort();
}

/* what no half may be without */
static void check_half(const wcut_half *half) {
    const wcut_half_report *r = &half->report;
    demand(r->closed == 1 && r->oriented == 1 && r->self_intersections == 0 && r->pieces >= 1);
    demand(r->volume > 0 && isfinite(r->volume) && r->area > 0 && isfinite(r->area));
    for (int k = 0; k < half->mesh->vertex_count; k++) {
        const wcut_vec3 p = half->mesh->vertex[k];
        demand(isfinite(p.x) && isfinite(p.y) && isfinite(p.z));
    }
    for (int k = 0; k < 3 * half->mesh->triangle_count; k++)
        demand(half->mesh->triangle[k] >= 0 && half->mesh->triangle[k] < half->mesh->vertex_count);
}

/* one byte of the input, 0 at its end */
static int next(const uint8_t **data, size_t *size) {
    if (*size == 0) return 0;
    (*size)--;
    return *(*data)++;
}

/* bytes: stations, nodes, kerf, keys, prolong, then the nodes, each beside a regular net over the block */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 6) return 0;
    const int stations = next(&data, &size) % (SIDE_MAX - 1) + 2, nodes = next(&data, &size) % (SIDE_MAX - 1) + 2;
    const wcut_vec3 block = {100, 100, 100};
    wcut_mould_options o = wcut_mould_default();
    wcut_key key[WCUT_KEYS_AT_CORNERS];
    o.chord_tolerance = 2, o.fit_tolerance = 1;
    o.kerf = next(&data, &size) / 32.0;
    const int keys = next(&data, &size) - 128;
    o.prolong = next(&data, &size);
    if (keys && wcut_keys_at_corners(block, 4, keys / 16.0, key) == WCUT_OK) {
        o.key = key;
        o.key_count = WCUT_KEYS_AT_CORNERS;
    }
    const int raw = next(&data, &size) % 8 == 7; /* whole doubles instead: overflow, NaN */
    wcut_vec3 x[SIDE_MAX * SIDE_MAX];
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) {
            double p[3] = {140.0 * i / (nodes - 1) - 20, 140.0 * j / (stations - 1) - 20, 50};
            for (int k = 0; k < 3 && size > 0; k++) {
                if (raw && size >= sizeof(double)) {
                    memcpy(&p[k], data, sizeof(double));
                    data += sizeof(double), size -= sizeof(double);
                } else {
                    p[k] += (next(&data, &size) - 128) / 2.0;
                }
            }
            x[j * nodes + i] = (wcut_vec3){p[0], p[1], p[2]};
        }
    wcut_surface *s;
    if (wcut_surface_loft(stations, nodes, x, 0, &s, NULL, NULL) != WCUT_OK) return 0;
    wcut_mould *m = NULL;
    wcut_error error = {.text = ""};
    const wcut_status status = wcut_mould_create(s, block, &o, &m, &error);
    if (status == WCUT_OK) {
        check_half(&m->lower), check_half(&m->upper);
        demand(m->volume_error <= 1e-6 && m->fit_error <= o.fit_tolerance && m->chord_error <= o.chord_tolerance);
    } else {
        demand(m == NULL && error.status == status && error.text[0]);
        demand(status == WCUT_BAD_ARGUMENT || status == WCUT_DEGENERATE || status == WCUT_NOT_CONVERGED);
    }
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
    return 0;
}
