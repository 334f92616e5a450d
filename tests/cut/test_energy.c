/* Work done by the mounts over a step is work of the foam force on the nodes, and what the turning edges take.

   Every free node is in equilibrium, S_e u_e - S_{e-1} u_{e-1} + f_i = 0 with u_e = E_e / l. Summed against the nodes'
   displacements and by parts, with E_new.(E_new - E_old) = |E_new - E_old|^2 / 2 for edges of one length l:
       mounts' work + sum f_i.dX_i = sum_e S_e |dE_e|^2 / (2 l).
   The last is of second order in the step: none in the steady state. labels: property */
#include "cut/cuts.h"
#include "test.h"

typedef struct work {
    double mounts, foam, turning; /* [N mm] */
} work;

static work work_of_step(const wcut_history *h, double edge, int j) {
    const int n = h->nodes;
    const wcut_vec3 *x = nodes_at(h, j), *was = nodes_at(h, j - 1), *f = forces_at(h, j);
    const double *s = tensions_at(h, j);
    const wcut_vec3 pull_a = vec3_scale(-s[0] / edge, vec3_sub(x[1], x[0]));
    const wcut_vec3 pull_b = vec3_scale(s[n - 2] / edge, vec3_sub(x[n - 1], x[n - 2]));
    work w = {.mounts = vec3_dot(vec3_sub(pull_a, f[0]), vec3_sub(x[0], was[0])) +
                        vec3_dot(vec3_sub(pull_b, f[n - 1]), vec3_sub(x[n - 1], was[n - 1]))};
    for (int i = 0; i < n; i++) w.foam += vec3_dot(f[i], vec3_sub(x[i], was[i]));
    for (int e = 0; e < n - 1; e++) {
        const wcut_vec3 turn = vec3_sub(vec3_sub(x[e + 1], x[e]), vec3_sub(was[e + 1], was[e]));
        w.turning += s[e] * vec3_dot(turn, turn) / (2 * edge);
    }
    return w;
}

TEST(the_mounts_spend_what_the_foam_and_the_turning_edges_take_to_the_solvers_tolerance) {
    wcut_job *const job[] = {swinging_job(61, 120), sample_job("steady-400-60.json"), sample_job("steady-300-85.json")};
    for (int k = 0; k < 3; k++) {
        wcut_history *h = run_of(job[k]);
        const double edge = job[k]->wire_length / (h->nodes - 1);
        int compared = 0;
        for (int j = 1; j < h->stations; j++) {
            if (h->row[j].substeps != 1) continue;
            const work w = work_of_step(h, edge, j);
            /* strain and balance are within 1e-10 of their scales; a step is millimetres, an edge of 2 N five of them
             */
            ck_assert_double_eq_tol(w.mounts + w.foam, w.turning, 1e-7);
            ck_assert_double_le(w.foam, 0);
            ck_assert_double_ge(w.turning, 0);
            compared += w.mounts > 0.1;
        }
        ck_assert_int_gt(compared, 100);
        wcut_history_destroy(h);
        wcut_job_destroy(job[k]);
    }
}

TEST(in_the_steady_state_the_mounts_spend_exactly_what_the_foam_takes) {
    wcut_job *job = straight_job(400, 60, 620, 121, 300, 250, 1190);
    wcut_history *h = run_of(job);
    const work w = work_of_step(h, job->wire_length / 120, h->stations - 1);
    const wcut_vec3 out = vec3_unit(vec3_sub(nodes_at(h, h->stations - 1)[0], nodes_at(h, h->stations - 1)[1]));
    /* both mounts pull with k along their tangents: 2 k sin(alpha) times the way */
    const double way = job->mount_a[1].y - job->mount_a[0].y;
    ck_assert_double_eq_tol(w.mounts, 2 * 2 * out.y * way, 1e-8);
    ck_assert_double_eq_tol(w.mounts, -w.foam, 1e-8);
    ck_assert_double_lt(w.turning, 1e-8);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(halving_the_steps_halves_what_the_turning_edges_take) {
    double turning[3];
    for (int k = 0, m = 61; k < 3; k++, m = 2 * m - 1) {
        wcut_job *job = swinging_job(61, m);
        wcut_history *h = run_of(job);
        turning[k] = 0;
        for (int j = m / 2; j < m; j++) turning[k] += work_of_step(h, job->wire_length / 60, j).turning;
        wcut_history_destroy(h);
        wcut_job_destroy(job);
    }
    ck_assert_double_eq_tol(turning[0] / turning[1], 2, 0.1);
    ck_assert_double_eq_tol(turning[1] / turning[2], 2, 0.1);
}
