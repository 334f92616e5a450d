/* Whichever allocation fails, the call says so, writes nothing and leaks nothing (the sanitizer looks). */
#include "base/alloc.h"
#include "cut/cuts.h"
#include "test.h"

static char somewhere;
static void *const untouched = &somewhere; /* an address that no call gives */

TEST(a_setup_survives_every_failing_allocation) {
    wcut_job *const job[] = {swinging_job(31, 20), sample_job("freeform-3.json")};
    job[1]->stations = 8, job[1]->nodes = 21; /* a design is planned with it, hence run */
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

TEST(a_designs_path_survives_every_failing_allocation) {
    wcut_job *job = sample_job("freeform-1.json"), *path = untouched;
    job->stations = 10;
    wcut_setup *setup = setup_of(job, NULL);
    EACH_FAILED_ALLOCATION(wcut_setup_path_job(setup, &path), path == untouched);
    ck_assert_int_eq(path->stations, wcut_setup_stations(setup).stations);
    wcut_job_destroy(path);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}
