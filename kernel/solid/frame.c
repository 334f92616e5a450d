/* A frame that holds both halves over each other: a box less the block and a clearance around it, by index. */
#include "solid/frame.h"

#include "base/alloc.h"
#include "base/vec3.h"
#include "solid/solid_brep.h"

/* vertices 8 level + 4 ring + k: level 0 below, ring 0 outside, corners counter-clockwise seen from above; edge of the
   same number runs to the next corner, upright 16 + 4 ring + k from below to above */
enum { CORNERS = 4, VERTICES = 16, EDGES = 24, FACES = 10, LOOPS = 12, COEDGES = 48, TRIANGLES = 32 };

static int frame_point(int level, int ring, int k) { return 8 * level + 4 * ring + k % CORNERS; }
static int upright(int ring, int k) { return VERTICES + 4 * ring + k % CORNERS; }

static void put_frame_vertices(wcut_vec3 block, double wall, double clearance, wcut_vec3 *vertex) {
    for (int level = 0; level < 2; level++)
        for (int ring = 0; ring < 2; ring++)
            for (int k = 0; k < CORNERS; k++) {
                const double out = clearance + (ring ? 0 : wall);
                vertex[frame_point(level, ring, k)] =
                    vec3(k == 1 || k == 2 ? block.x + out : -out, k >= 2 ? block.y + out : -out, level ? block.z : 0);
            }
}

static int *put_square(int *to, int a, int b, int c, int d) {
    const int corner[6] = {a, b, c, a, c, d};
    for (int k = 0; k < 6; k++) *to++ = corner[k];
    return to;
}

/* above, below, outside, inside */
static void put_frame_triangles(int *to) {
    for (int k = 0; k < CORNERS; k++) {
        to = put_square(to, frame_point(1, 0, k), frame_point(1, 0, k + 1), frame_point(1, 1, k + 1),
                        frame_point(1, 1, k));
        to = put_square(to, frame_point(0, 0, k), frame_point(0, 1, k), frame_point(0, 1, k + 1),
                        frame_point(0, 0, k + 1));
        to = put_square(to, frame_point(0, 0, k), frame_point(0, 0, k + 1), frame_point(1, 0, k + 1),
                        frame_point(1, 0, k));
        to = put_square(to, frame_point(0, 1, k), frame_point(1, 1, k), frame_point(1, 1, k + 1),
                        frame_point(0, 1, k + 1));
    }
}

/* ---- exactly ---- */

static void add_plane(wcut_brep *b, wcut_vec3 origin, wcut_vec3 normal) {
    b->face[b->face_count++] = (wcut_brep_face){
        .part = WCUT_BREP_PART_FRAME, .same_sense = 1, .origin = origin, .normal = normal, .first_loop = b->loop_count};
}

/* edge + 1, negative where it is run through backwards */
static void add_ring(wcut_brep *b, int a, int c, int d, int e) {
    const int coded[CORNERS] = {a, c, d, e};
    b->loop[b->loop_count++] = (wcut_brep_loop){b->coedge_count, CORNERS};
    b->face[b->face_count - 1].loop_count++;
    for (int k = 0; k < CORNERS; k++)
        b->coedge[b->coedge_count++] =
            (wcut_brep_coedge){.edge = (coded[k] < 0 ? -coded[k] : coded[k]) - 1, .reversed = coded[k] < 0};
}

static void put_frame_faces(wcut_brep *b) {
    /* above and below, each with the hole for the halves */
    for (int level = 0; level < 2; level++) {
        const int out = frame_point(level, 0, 0) + 1, in = frame_point(level, 1, 0) + 1;
        add_plane(b, b->vertex[out - 1], vec3(0, 0, level ? 1 : -1));
        if (level) {
            add_ring(b, out, out + 1, out + 2, out + 3);
            add_ring(b, -(in + 3), -(in + 2), -(in + 1), -in);
        } else {
            add_ring(b, -(out + 3), -(out + 2), -(out + 1), -out);
            add_ring(b, in, in + 1, in + 2, in + 3);
        }
    }

    /* walls, outside and inside */
    static const wcut_vec3 outwards[CORNERS] = {{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
    for (int k = 0; k < CORNERS; k++) {
        add_plane(b, b->vertex[frame_point(0, 0, k)], outwards[k]);
        add_ring(b, frame_point(0, 0, k) + 1, upright(0, k + 1) + 1, -(frame_point(1, 0, k) + 1), -(upright(0, k) + 1));
        add_plane(b, b->vertex[frame_point(0, 1, k)], vec3_scale(-1, outwards[k]));
        add_ring(b, -(frame_point(0, 1, k) + 1), upright(1, k) + 1, frame_point(1, 1, k) + 1, -(upright(1, k + 1) + 1));
    }
}

static wcut_status frame_brep(const wcut_vec3 *vertex, wcut_brep **brep) {
    wcut_brep *b = wcut_alloc(1, sizeof *b);
    if (!b) return WCUT_NO_MEMORY;
    b->vertex = wcut_copy(vertex, VERTICES, sizeof *vertex);
    b->edge = wcut_alloc(EDGES, sizeof *b->edge);
    b->coedge = wcut_alloc(COEDGES, sizeof *b->coedge);
    b->loop = wcut_alloc(LOOPS, sizeof *b->loop);
    b->face = wcut_alloc(FACES, sizeof *b->face);
    if (!b->vertex || !b->edge || !b->coedge || !b->loop || !b->face) {
        wcut_brep_destroy(b);
        return WCUT_NO_MEMORY;
    }

    /* edges around, then the uprights */
    b->vertex_count = VERTICES, b->edge_count = EDGES;
    for (int level = 0; level < 2; level++)
        for (int ring = 0; ring < 2; ring++)
            for (int k = 0; k < CORNERS; k++)
                b->edge[frame_point(level, ring, k)] =
                    (wcut_brep_edge){.from = frame_point(level, ring, k), .to = frame_point(level, ring, k + 1)};
    for (int ring = 0; ring < 2; ring++)
        for (int k = 0; k < CORNERS; k++)
            b->edge[upright(ring, k)] =
                (wcut_brep_edge){.from = frame_point(0, ring, k), .to = frame_point(1, ring, k)};
    put_frame_faces(b);
    *brep = b;
    return WCUT_OK;
}

wcut_status wcut_frame_create(wcut_vec3 block, double wall, double clearance, wcut_mesh **mesh, wcut_brep **brep) {
    wcut_mesh *m;
    wcut_status status = wcut_mesh_create(VERTICES, TRIANGLES, 0, &m);
    if (status != WCUT_OK) return status;
    put_frame_vertices(block, wall, clearance, m->vertex);
    put_frame_triangles(m->triangle);
    status = frame_brep(m->vertex, brep);
    if (status == WCUT_OK) {
        *mesh = m;
    } else {
        wcut_mesh_destroy(m);
    }
    return status;
}
