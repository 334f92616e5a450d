/* The same bytes from run to run and for any number of threads on one setup; stepping allocates nothing.
   labels: property */
#include <stdint.h>

#include "base/alloc.h"
#include "cut/cuts.h"
#include "test.h"

/* FNV-1a over everything that a history says, padding left out */
static uint64_t add_bytes(uint64_t hash, const void *bytes, size_t count) {
    for (size_t k = 0; k < count; k++) hash = (hash ^ ((const unsigned char *)bytes)[k]) * 1099511628211u;
    return hash;
}

static uint64_t hash_of(const wcut_history *h) {
    const size_t m = (size_t)h->stations, n = (size_t)h->nodes;
    uint64_t hash = 14695981039346656037u;
    hash = add_bytes(hash, h->position, m * n * sizeof *h->position);
    hash = add_bytes(hash, h->force, m * n * sizeof *h->force);
    hash = add_bytes(hash, h->force_line, m * n * sizeof *h->force_line);
    hash = add_bytes(hash, h->speed, m * n * sizeof *h->speed);
    hash = add_bytes(hash, h->tension, m * (n - 1) * sizeof *h->tension);
    for (int j = 0; j < h->stations; j++) {
        const wcut_history_row *r = &h->row[j];
        hash = add_bytes(hash, r, offsetof(wcut_history_row, condition));
        hash = add_bytes(hash, &r->condition, sizeof r->condition);
    }
    return hash;
}

static uint64_t hash_of_run(const wcut_setup *setup) {
    wcut_history *h = NULL;
    if (wcut_setup_run(setup, NULL, NULL, &h, NULL) != WCUT_OK) return 0;
    const uint64_t hash = hash_of(h);
    wcut_history_destroy(h);
    return hash;
}

TEST(two_runs_of_one_setup_and_a_run_of_another_give_the_same_bytes) {
    wcut_job *const job[] = {swinging_job(61, 100), sample_job("steady-300-60.json"), sample_job("freeform-3.json")};
    job[2]->stations = 61;
    for (int k = 0; k < 3; k++) {
        wcut_setup *setup = setup_of(job[k], NULL), *again = setup_of(job[k], NULL);
        const uint64_t hash = hash_of_run(setup);
        ck_assert(hash != 0);
        ck_assert(hash == hash_of_run(setup) && hash == hash_of_run(again));
        wcut_setup_destroy(setup);
        wcut_setup_destroy(again);
        job[k]->heat *= 1 + 1e-12; /* the hash can tell */
        setup = setup_of(job[k], NULL);
        ck_assert(hash != hash_of_run(setup));
        wcut_setup_destroy(setup);
        wcut_job_destroy(job[k]);
    }
}

TEST(many_threads_on_one_setup_give_the_same_bytes_whatever_their_number) {
    wcut_job *job = swinging_job(61, 100);
    wcut_setup *setup = setup_of(job, NULL);
    const uint64_t alone = hash_of_run(setup);
    for (int threads = 1; threads <= 4; threads *= 2) {
        int wrong = 0;
#pragma omp parallel for num_threads(threads) reduction(+ : wrong) schedule(static, 1)
        for (int k = 0; k < 8; k++) wrong += hash_of_run(setup) != alone;
        ck_assert_int_eq(wrong, 0);
    }
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

#ifndef __SANITIZE_ADDRESS__ /* the sanitizer has its own malloc, and is not to be stepped between */
#define COUNTS_MALLOC
/* NOLINTBEGIN: the C library's own names, for its own functions */
extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *memory, size_t size);
void *malloc(size_t size);
void *calloc(size_t count, size_t size);
void *realloc(void *memory, size_t size);
static volatile long allocations;
void *malloc(size_t size) { return allocations++, __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return allocations++, __libc_calloc(count, size); }
void *realloc(void *memory, size_t size) { return allocations++, __libc_realloc(memory, size); }
/* NOLINTEND */
#else
static volatile long allocations;
#endif

TEST(stepping_and_driving_allocate_nothing) {
    wcut_job *const job[] = {sample_job("steady-400-60.json"), sample_job("freeform-2.json"), swinging_job(61, 60)};
    wcut_cut_options options = wcut_cut_options_default();
    for (int k = 0; k < 5; k++) {
        const wcut_job *now = job[k < 3 ? k : 2];
        options.integrator = k == 3 ? WCUT_INTEGRATOR_HEUN : WCUT_INTEGRATOR_IMPLICIT;
        wcut_setup *setup = setup_of(now, &options);
        wcut_cut *cut = NULL;
        const long before_create = allocations;
        ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
#ifdef COUNTS_MALLOC
        ck_assert_int_gt(allocations, before_create); /* the counter counts */
#endif
        wcut_alloc_fail_at(1); /* and the library's own allocator would fail */
        const long before = allocations;
        wcut_status status = WCUT_OK;
        for (int j = 1; j < now->stations && status == WCUT_OK; j++)
            status = k < 4 ? wcut_cut_step(cut, NULL)
                           : wcut_cut_drive(cut, now->mount_a[j], now->mount_b[j], 0.2, now->heat, NULL);
        const long after = allocations;
        wcut_alloc_fail_at(0);
        ck_assert_int_eq(status, WCUT_OK);
        ck_assert_int_eq(after - before, 0);
        ck_assert(before_create >= 0);
        wcut_cut_destroy(cut);
        wcut_setup_destroy(setup);
    }
    for (int k = 0; k < 3; k++) wcut_job_destroy(job[k]);
}
