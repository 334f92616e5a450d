/* Both halves of a block along a surface of 209,000 triangles: by index, and by CGAL's booleans with the same cutter.
   One line each for bench_table.sh.  bench_mould [FOLDER]  also writes the cutter there, for bench_mould.mjs. */
#include <string.h>
#include <wirecut/mould.h>

#include "base/alloc.h"
#include "bench/peers/common.h"
#include "solid/boolean.h"
#include "solid/cap_flat.h"

enum { RUNS = 5, STATIONS = 600, NODES = 121 };

static const wcut_vec3 block = {400, 900, 300};

static void check(wcut_status status, const char *what) {
    if (status == WCUT_OK) return;
    fprintf(stderr, "bench_mould: %s: %s\n", what, wcut_status_text(status));
    exit(EXIT_FAILURE);
}

/* a wire's cut over the block and beyond, sagging backwards, twisted and waved */
static wcut_surface *loft(void) {
    static wcut_vec3 x[STATIONS * NODES];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) {
            const double s = i / (NODES - 1.0), t = j / (STATIONS - 1.0);
            x[j * NODES + i] = (wcut_vec3){480 * s - 40, 1100 * t - 60 - 240 * s * (1 - s),
                                           150 + 60 * sin(6.0 * t + 1.5 * s) + 80 * t * (s - 0.5)};
        }
    wcut_surface *surface;
    check(wcut_surface_loft(STATIONS, NODES, x, 0, &surface, NULL, NULL), "loft");
    return surface;
}

/* the closed solid below the cut and around the block, from the half's own cut face: what booleans are given */
static wcut_mesh *cutter_of(const wcut_mould *m, double chord_tolerance) {
    const wcut_sides sides = {{0, block.x}, {0, block.y}};
    wcut_cap face, floor;
    wcut_mesh *mesh;
    double off;
    check(wcut_cap_tessellate(m->lower.brep->face[0].surface, sides, chord_tolerance, &face, &off), "cutter");
    for (int k = 0; k < face.vertex_count; k++) { /* 1 % larger: no sides that coincide */
        face.vertex[k].x = 1.01 * (face.vertex[k].x - 200) + 200;
        face.vertex[k].y = 1.01 * (face.vertex[k].y - 450) + 450;
    }
    const wcut_sides wide = {{-2, 402}, {-4.5, 904.5}};
    check(wcut_cap_flat(wide, -10, 0, NULL, 1, &floor), "floor");
    check(wcut_cap_enclose(&floor, &face, 0, NULL, &mesh), "cutter");
    wcut_cap_clear(&floor);
    wcut_cap_clear(&face);
    return mesh;
}

static wcut_mesh *block_mesh(void) {
    const wcut_sides sides = {{0, block.x}, {0, block.y}};
    wcut_cap floor, ceiling;
    wcut_mesh *mesh;
    check(wcut_cap_flat(sides, 0, 0, NULL, 1, &floor), "block");
    check(wcut_cap_flat(sides, block.z, 0, NULL, 1, &ceiling), "block");
    check(wcut_cap_enclose(&floor, &ceiling, 0, NULL, &mesh), "block");
    wcut_cap_clear(&ceiling);
    wcut_cap_clear(&floor);
    return mesh;
}

/* the same solid, its triangles turned, in a box: what is above the cut */
static wcut_mesh *turned(const wcut_mesh *m) {
    wcut_mesh *up;
    check(wcut_mesh_create(m->vertex_count, m->triangle_count, 0, &up), "turn");
    memcpy(up->triangle, m->triangle, (size_t)m->triangle_count * 3 * sizeof *m->triangle);
    for (int k = 0; k < m->vertex_count; k++) { /* half a turn about the block's long axis, raised to where it was */
        const wcut_vec3 p = m->vertex[k];
        up->vertex[k] = (wcut_vec3){400 - p.x, p.y, 300 - p.z};
    }
    return up;
}

static void write_cutter(const wcut_mesh *m, const char *folder) {
    char path[4096];
    snprintf(path, sizeof path, "%s/cutter.bin", folder);
    FILE *f = fopen(path, "wb");
    const int head[2] = {m->vertex_count, m->triangle_count};
    const bool ok = f && fwrite(head, sizeof head, 1, f) == 1 &&
                    fwrite(m->vertex, sizeof *m->vertex, (size_t)m->vertex_count, f) == (size_t)m->vertex_count &&
                    fwrite(m->triangle, 3 * sizeof(int), (size_t)m->triangle_count, f) == (size_t)m->triangle_count;
    if (!f || fclose(f) != 0 || !ok) check(WCUT_NOT_WRITTEN, path);
}

/* both halves as booleans make them: block and cutter, block and as many triangles again from above */
static void bench_booleans(const wcut_mesh *cutter) {
    wcut_mesh *above = turned(cutter), *stock = block_mesh();
    const wcut_mesh *const side[2] = {cutter, above};
    double seconds;
    char note[80];
    TIMED(2, seconds, {
        for (int k = 0; k < 2; k++) {
            wcut_mesh *half;
            unsigned char *tag;
            check(wcut_boolean_intersect(stock, NULL, side[k], NULL, &half, &tag, NULL), "boolean");
            wcut_mesh_destroy(half);
            wcut_free(tag);
        }
    });
    snprintf(note, sizeof note, "both booleans, cutter of %d triangles", cutter->triangle_count);
    say("halves", "CGAL", seconds, note);
    wcut_mesh_destroy(stock);
    wcut_mesh_destroy(above);
}

int main(int argc, char **argv) {
    wcut_surface *surface = loft();
    wcut_mould_options o = wcut_mould_default();
    wcut_mould *m = NULL;
    wcut_error error = {.text = ""};
    double seconds;
    char note[120];
    o.chord_tolerance = 0.00253;
    TIMED(RUNS, seconds, {
        wcut_mould_destroy(m);
        m = NULL;
        check(wcut_mould_create(surface, block, &o, &m, &error), error.text);
    });
    const wcut_surface *face = m->lower.brep->face[0].surface;
    snprintf(note, sizeof note, "fit, both halves of %d and %d triangles, exact faces of %d x %d poles, every check",
             m->lower.mesh->triangle_count, m->upper.mesh->triangle_count, face->count_u, face->count_v);
    say("halves", "wirecut", seconds, note);
    wcut_mesh *cutter = cutter_of(m, o.chord_tolerance);
    if (argc > 1) write_cutter(cutter, argv[1]);
    bench_booleans(cutter);
    wcut_mesh_destroy(cutter);
    wcut_mould_destroy(m);
    wcut_surface_destroy(surface);
    return 0;
}
