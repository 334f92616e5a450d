/* Whichever allocation fails, the call says so, writes nothing and leaks nothing (the sanitizer looks). */
#include "base/alloc.h"
#include "cut/cuts.h"
#include "test.h"

static char somewhere;
static void *const untouched = &somewhere; /* an address that no call gives */

TEST(a_setup_survives_every_failing_allocation) {
    wcut_job *const job[] = {swinging_job(31, 20), sample_job("freeform-3.json")};
    for (int k = 0; k < 2; k++) {
        job[k]->foam_material = job[k]->foam_material ? job[k]->foam_material : wcut_copy_text("EPS");
        wcut_setup *setup = untouched;
        wcut_error error = {0};
        EACH_FAILED_ALLOCATION(wcut_setup_create(job[k], NULL, &setup, &error),
                               error.status == WCUT_NO_MEMORY && error.text[0] && setup == untouched);
        wcut_setup_destroy(setup);
        wcut_job_destroy(job[k]);
    }
}

TEST(a_cut_survives_every_failing_allocation) {
    wcut_job *job = swinging_job(31, 20);
    wcut_setup *setup = setup_of(job, NULL);
    wcut_cut *cut = untouched;
    wcut_error error = {0};
    EACH_FAILED_ALLOCATION(wcut_cut_create(setup, &cut, &error),
                           error.status == WCUT_NO_MEMORY && error.text[0] && cut == untouched);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

TEST(a_history_survives_every_failing_allocation) {
    wcut_job *job = swinging_job(31, 20);
    wcut_setup *setup = setup_of(job, NULL);
    wcut_history *history = untouched;
    wcut_error error = {0};
    EACH_FAILED_ALLOCATION(wcut_setup_run(setup, NULL, NULL, &history, &error),
                           error.status == WCUT_NO_MEMORY && error.text[0] && history == untouched);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

TEST(path_curves_survive_a_failing_allocation) {
    wcut_job *job = sample_job("freeform-1.json");
    job->stations = 10;
    wcut_setup *setup = setup_of(job, NULL);
    wcut_history *h = run_of(job);
    wcut_vec3 a[10], b[10];
    double length = 999;
    a[0].x = b[9].z = 999;
    wcut_alloc_fail_at(1);
    const wcut_status status = wcut_history_path(setup, h, a, b, &length, NULL);
    wcut_alloc_fail_at(0);
    ck_assert_int_eq(status, WCUT_NO_MEMORY);
    ck_assert(a[0].x == 999 && b[9].z == 999 && length == 999);
    wcut_history_destroy(h);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}
