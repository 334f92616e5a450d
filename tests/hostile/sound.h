/* Sound arguments for hostile calls: a short cut, what comes of it, and a scan of its face. Made once a process. */
#ifndef WCUT_TESTS_HOSTILE_SOUND_H
#define WCUT_TESTS_HOSTILE_SOUND_H

#include "cut/trials.h"
#include "hostile/hostile.h"

enum { SCAN = 600 };

static inline wcut_job *sound_job(void) {
    static wcut_job *job;
    if (!job) job = short_job();
    return job;
}

static inline wcut_setup *sound_setup(void) {
    static wcut_setup *setup;
    if (!setup) setup = setup_of(sound_job(), NULL);
    return setup;
}

static inline wcut_history *sound_history(void) {
    static wcut_history *history;
    if (!history) history = run_of(sound_job());
    return history;
}

static inline wcut_recording *sound_recording(void) {
    static wcut_recording *recording;
    if (!recording) recording = driven_recording(sound_job(), 5, 0.05, 40);
    return recording;
}

/* through the whole block */
static inline wcut_recording *long_recording(void) {
    static wcut_recording *recording;
    if (!recording) recording = driven_recording(sound_job(), 3, 0.1, 140);
    return recording;
}

static inline wcut_face *sound_face(void) {
    static wcut_face *face;
    if (!face) ck_assert_int_eq(wcut_face_create(sound_job(), sound_history(), NULL, NULL, 1, &face), WCUT_OK);
    return face;
}

static inline wcut_projection *sound_projection(void) {
    static wcut_projection *projection;
    if (!projection) ck_assert_int_eq(wcut_projection_create(sound_face()->surface, &projection), WCUT_OK);
    return projection;
}

static inline wcut_mesh *sound_mesh(void) {
    static wcut_mesh *mesh;
    if (!mesh) ck_assert_int_eq(wcut_surface_tessellate(sound_face()->surface, 0.5, &mesh, NULL), WCUT_OK);
    return mesh;
}

static inline wcut_mesh_tree *sound_tree(void) {
    static wcut_mesh_tree *tree;
    if (!tree) ck_assert_int_eq(wcut_mesh_tree_create(sound_mesh(), &tree), WCUT_OK);
    return tree;
}

/* points over the face, some of them off it */
static inline wcut_vec3 *sound_scan(void) {
    static wcut_vec3 scan[SCAN];
    const wcut_surface *s = sound_face()->surface;
    double first[2], last[2];
    wcut_surface_domain(s, first, last);
    for (int k = 0; k < SCAN && scan[SCAN - 1].x == 0; k++) {
        const double u = (k % 30 + 0.5) / 30, v = (k / 30 + 0.5) / 20;
        ck_assert_int_eq(
            wcut_surface_eval(s, first[0] + u * (last[0] - first[0]), first[1] + v * (last[1] - first[1]), 0, &scan[k]),
            WCUT_OK);
        scan[k].z += 0.2 * sin(k);
    }
    return scan;
}

static inline wcut_deviation *sound_deviation(void) {
    static wcut_deviation deviation[SCAN];
    if (deviation[0].distance == 0)
        ck_assert_int_eq(wcut_deviation_from_surface(sound_projection(), SCAN, sound_scan(), NULL, 1, deviation, NULL),
                         WCUT_OK);
    return deviation;
}

#endif
