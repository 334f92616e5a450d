/* How many threads a parallel loop asks for: as many as can be team_size. */
#include "base/threads.h"

#include <pthread.h>

/* threads that wait until all are counted, so that they are there at the same time */
typedef struct gate {
    pthread_mutex_t mutex;
    pthread_cond_t opened;
    int open;
} gate;

static void *wait_at(void *context) {
    gate *g = context;
    pthread_mutex_lock(&g->mutex);
    while (!g->open) pthread_cond_wait(&g->opened, &g->mutex);
    pthread_mutex_unlock(&g->mutex);
    return NULL;
}

/* how many of so many threads can be started */
static int try_threads(int asked) {
    gate g = {PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, 0};
    pthread_t thread[WCUT_THREADS_MAX];
    int started = 0;
    while (started < asked && pthread_create(&thread[started], NULL, wait_at, &g) == 0) started++;

    /* all of them go, whether they were enough or not */
    pthread_mutex_lock(&g.mutex);
    g.open = 1;
    pthread_cond_broadcast(&g.opened);
    pthread_mutex_unlock(&g.mutex);
    for (int k = 0; k < started; k++) pthread_join(thread[k], NULL);
    pthread_cond_destroy(&g.opened);
    pthread_mutex_destroy(&g.mutex);
    return started;
}

int wcut_threads(int asked) {
    static _Thread_local int team_size = 1; /* that this thread began last: libgomp keeps it waiting */
    const int wanted = asked < 1 ? 1 : asked < WCUT_THREADS_MAX ? asked : WCUT_THREADS_MAX;
    team_size = wanted <= team_size ? wanted : team_size + try_threads(wanted - team_size);
    return team_size;
}
