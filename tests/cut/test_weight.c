/* The weight of the wire: the catenary before the foam, the balance of all forces in it, and how little it does there. */
#include <math.h>
#include <wirecut/cut.h>
#include <wirecut/history.h>

#include "cut/setup.h"
#include "cut/trials.h"
#include "test.h"

static const double density = 7150; /* [kg/m3] Kanthal A */

/* 240 mm of foam, mounts 60 mm beside it, begun far before the block */
static wcut_job *heavy_job(int nodes, double of_wire) {
    wcut_job *job = straight_job(240, 60, 400, nodes, 41, -150, 450);
    job->block_size.y = 400;
    job->wire_density = of_wire;
    return job;
}

/* half the parameter of the catenary of this length over this span: 2 a sinh(c / 2a) = L */
static double catenary(double chord, double length) {
    double low = chord / 100, high = chord * 100;
    for (int i = 0; i < 200; i++) {
        const double a = sqrt(low * high);
        if (2 * a * sinh(chord / (2 * a)) > length)
            low = a;
        else
            high = a;
    }
    return sqrt(low * high);
}

/* largest distance of the nodes from the catenary, and the tension at mount A over that of the closed form, less 1 */
static void hang(int nodes, double *off, double *tension) {
    wcut_job *job = heavy_job(nodes, density);
    wcut_setup *setup = NULL;
    wcut_cut *cut = NULL;
    wcut_station s;
    wcut_error error = {0};
    ck_assert_msg(wcut_setup_create(job, NULL, &setup, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
    wcut_cut_view(cut, &s);

    const double chord = 360, middle = 120, a = catenary(chord, job->wire_length), end = a * cosh(chord / (2 * a));
    *off = 0;
    for (int i = 0; i < nodes; i++) {
        const double z = s.position[0].z - end + a * cosh((s.position[i].x - middle) / a);
        *off = fmax(*off, hypot(s.position[i].y - s.position[0].y, s.position[i].z - z));
    }
    *tension = s.tension_a / (setup->weight * end) - 1;
    ck_assert_double_eq_tol(s.tension_a, s.tension_b, 1e-12);
    ck_assert(s.beta_a < -0.1 && fabs(s.alpha_a) < 1e-9); /* it hangs down, and does not trail */
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

TEST(before_the_foam_it_hangs_in_a_catenary_to_second_order) {
    double off[3], tension[3];
    for (int k = 0; k < 3; k++) hang((10 << k) + 1, &off[k], &tension[k]);
    ck_assert_msg(off[2] < 0.1, "%g mm", off[2]);
    for (int k = 0; k < 2; k++) {
        ck_assert_msg(off[k] / off[k + 1] > 3.5 && off[k] / off[k + 1] < 4.5, "%g, %g mm", off[k], off[k + 1]);
        ck_assert_msg(fabs(tension[k] / tension[k + 1]) > 3.5, "%g, %g", tension[k], tension[k + 1]);
    }
}

TEST(a_wire_weighs_its_section_times_its_density) {
    const wcut_job job = {.wire_diameter = 0.15, .wire_density = 7150};
    ck_assert_double_eq_tol(wcut_wire_weight(&job), 1.2391e-6, 1e-10); /* [N/mm] */
    ck_assert_double_eq(wcut_wire_weight(&(wcut_job){.wire_diameter = 0.15}), 0);
}

/* mounts, foam and weight are in balance at every station */
TEST(all_forces_are_in_balance_and_in_the_foam_the_weight_is_next_to_nothing) {
    enum { NODES = 31 };
    wcut_job *job = heavy_job(NODES, 3 * density), *light = heavy_job(NODES, density), *plain = heavy_job(NODES, 0);
    const wcut_job *const each[3] = {job, light, plain};
    wcut_history *h[3] = {NULL};
    double weight = 0;
    for (int k = 0; k < 3; k++) {
        wcut_setup *setup = NULL;
        wcut_error error = {0};
        ck_assert_msg(wcut_setup_create(each[k], NULL, &setup, &error) == WCUT_OK, "%s", error.text);
        ck_assert_msg(wcut_setup_run(setup, NULL, NULL, &h[k], &error) == WCUT_OK, "%d: %s", k, error.text);
        if (k == 0) weight = setup->weight * job->wire_length;
        wcut_setup_destroy(setup);
    }
    int loaded = 0;
    for (int j = 0; j < h[0]->stations; j++) {
        const wcut_history_row *r = &h[0]->row[j];
        const wcut_vec3 *x = h[0]->position + (ptrdiff_t)j * NODES, *f = h[0]->force + (ptrdiff_t)j * NODES;
        const double *s = h[0]->tension + (ptrdiff_t)j * (NODES - 1);
        const wcut_vec3 a = vec3_unit(vec3_sub(x[0], x[1])), b = vec3_unit(vec3_sub(x[NODES - 1], x[NODES - 2]));
        wcut_vec3 sum = vec3_add(vec3_scale(s[0], a), vec3_scale(s[NODES - 2], b));
        for (int i = 1; i < NODES - 1; i++) sum = vec3_add(sum, f[i]);
        sum.z -= weight * (NODES - 2) / (NODES - 1);

        // a wire that leans on the face is held by it: what the face does is not known, but that it does not lift
        const bool leans = !(r->tension_a > 10 * weight) && fabs(r->alpha_a) > 1e-6;
        ck_assert_msg(fabs(sum.z) < 1e-6 && (leans || vec3_length(sum) < 1e-6), "station %d: %g %g %g N", j, sum.x,
                      sum.y, sum.z);
        loaded += r->condition == WCUT_CONDITION_TENSION;
    }
    ck_assert_int_gt(loaded, 10);

    // the speed of a wire of its own weight, in the middle of the block
    const int middle = h[1]->stations * 2 / 3;
    const double speed = h[1]->row[middle].speed_a, without = h[2]->row[middle].speed_a;
    ck_assert_int_eq(h[1]->row[middle].condition, WCUT_CONDITION_TENSION);
    ck_assert_msg(fabs(speed / without - 1) < 1e-3, "%g and %g mm/s", speed, without);
    ck_assert_double_lt(h[1]->row[middle].beta_a, h[2]->row[middle].beta_a); /* and it hangs a little */
    for (int k = 0; k < 3; k++) wcut_history_destroy(h[k]);
    wcut_job_destroy(plain);
    wcut_job_destroy(light);
    wcut_job_destroy(job);
}

TEST(a_weight_that_no_metal_has_is_refused) {
    wcut_job *job = heavy_job(21, -1);
    wcut_setup *setup = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_setup_create(job, NULL, &setup, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "wire.density_kg_per_m3"));
    job->wire_density = 7150;
    wcut_cut_options o = wcut_cut_options_default();
    o.integrator = WCUT_INTEGRATOR_HEUN;
    ck_assert_int_eq(wcut_setup_create(job, &o, &setup, &error), WCUT_BAD_ARGUMENT);
    wcut_job_destroy(job);
}
