/* A pool of processes that run the cases of a sweep.

   A child's standard error is a pipe of its own: what comes through it are the case's last words, and its end says that
   the child is gone. The next case is prepared (hash, folder, input) while the children work, and started before the one
   that ended is recorded, so that the processors do not wait for the disk. */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/study/sweep.h"

enum {
    TAIL = 2000,        /* [byte] of a child's words that are kept */
    LOOK_MS = 100,      /* how often the caller is asked whether to go on */
    CANNOT_START = 127, /* exit code of a child that found no program */
    WORDS_MAX = 1024    /* of a call */
};

/* a case in the pool */
typedef struct slot {
    char *folder, *call; /* NULL: the slot is free */
    char hash[WCUT_STUDY_HASH_SIZE];
    pid_t child;
    int words_fd;
    struct timespec begun;
    int tail_count;
    char tail[TAIL + 1];
    wcut_sweep_record record; /* once it ended */
} slot;

typedef struct pool {
    wcut_sweep *sweep;
    const wcut_sweep_options *options;
    wcut_sweep_counts counts;
    wcut_error *error;
    int next, looked; /* case to look at next; how many were */
    slot ready;       /* prepared, waits for a place */
    slot *running;    /* jobs */
    slot *ended;      /* 2 jobs, to be recorded: those whose places were filled again, and the last ones */
    int running_count, ended_count;
    bool stopping;
} pool;

static wcut_status fail_pool_memory(wcut_error *error) {
    return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
}

static double seconds_since(const struct timespec *begun) {
    struct timespec now = *begun;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)(now.tv_sec - begun->tv_sec) + 1e-9 * (double)(now.tv_nsec - begun->tv_nsec);
}

static void clear_slot(slot *s) {
    wcut_free(s->folder);
    free(s->call);
    *s = (slot){.words_fd = -1};
}

/* ---- prepare ---- */

/* the folder of a case and the two above it */
static wcut_status make_case_folder(pool *p, const char *folder) {
    char path[4096];
    const size_t root = strlen(p->sweep->folder);
    const size_t end[] = {root + strlen("/cases"), root + strlen("/cases/HH"), strlen(folder)};
    if (strlen(folder) >= sizeof path)
        return wcut_fail_errno(p->error, WCUT_NOT_WRITTEN, ENAMETOOLONG, p->sweep->folder, "no folder for a case");
    for (int i = 0; i < 3; i++) {
        memcpy(path, folder, end[i]);
        path[end[i]] = '\0';
        if (mkdir(path, 0777) != 0 && errno != EEXIST)
            return wcut_fail_errno(p->error, WCUT_NOT_WRITTEN, errno, path, "no folder for a case");
    }
    return WCUT_OK;
}

/* the same case may stand twice in a study */
static bool is_in_pool(const pool *p, const char *hash) {
    for (int i = 0; i < p->options->jobs; i++)
        if (p->running[i].folder && strcmp(p->running[i].hash, hash) == 0) return true;
    for (int i = 0; i < p->ended_count; i++)
        if (strcmp(p->ended[i].hash, hash) == 0) return true;
    return false;
}

/* the next case that is not whole, ready to start; none: ready.folder stays NULL */
static wcut_status prepare_next(pool *p) {
    const wcut_study *study = p->sweep->study;

    /* a limit counts the cases of this run, also those that are not recorded yet */
    wcut_sweep_record record;
    while (p->next < study->info.cases && !p->stopping) {
        if (p->options->limit > 0 && p->counts.ran + p->running_count + p->ended_count >= p->options->limit)
            return WCUT_OK;
        const int k = p->next;
        slot s = {.words_fd = -1};
        if (wcut_study_hash_eval(study, k, s.hash) != WCUT_OK) return fail_pool_memory(p->error);
        s.folder = wcut_sweep_folder(p->sweep, s.hash);
        if (!s.folder) return fail_pool_memory(p->error);

        /* one that is whole or in the pool is not run again */
        p->next += p->options->shares;
        const bool whole = wcut_sweep_record_read(s.folder, &record) && wcut_sweep_record_is_whole(s.folder, &record);
        if (whole || is_in_pool(p, s.hash)) {
            if (whole) p->counts.state[record.state]++;
            p->looked++;
            clear_slot(&s);
            if (p->options->progress && p->options->progress(p->looked, p->counts.cases, p->options->context))
                p->stopping = true;
            continue;
        }

        /* folder, input and call of the case: ready to be started */
        wcut_status status = make_case_folder(p, s.folder);
        if (status == WCUT_OK) status = wcut_sweep_input_write(study, k, s.folder, p->error);
        if (status == WCUT_OK && wcut_study_call_print(study, k, s.folder, &s.call) != WCUT_OK)
            status = fail_pool_memory(p->error);
        if (status != WCUT_OK) {
            clear_slot(&s);
            return status;
        }
        p->ready = s;
        return WCUT_OK;
    }
    return WCUT_OK;
}

/* ---- start ---- */

/* in the child: nothing of the caller's but the words' pipe, and gone when the caller is */
static void become(const pool *p, char *const word[], int words, pid_t parent) {
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    const int nowhere = open("/dev/null", O_RDWR);
    if (nowhere < 0 || dup2(nowhere, 0) < 0 || dup2(nowhere, 1) < 0 || dup2(words, 2) < 0) _exit(CANNOT_START);
    setpgid(0, 0); /* a Ctrl-C is the caller's, who hands it on */
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != parent) _exit(CANNOT_START);
    if (*p->sweep->study->folder && chdir(p->sweep->study->folder) != 0) _exit(CANNOT_START);
    execvp(p->options->program, word);
    _exit(CANNOT_START);
}

/* the call's words, the program first and the further word last; they point into `call` */
static bool split_call(const pool *p, char *call, char *word[WORDS_MAX]) {
    int n = 0;
    word[n++] = (char *)p->options->program;
    for (char *at = call; *at;) {
        char *feed = strchr(at, '\n');
        if (n + 2 >= WORDS_MAX || !feed) return false;
        *feed = '\0';
        word[n++] = at;
        at = feed + 1;
    }
    if (p->options->word) word[n++] = (char *)p->options->word;
    word[n] = NULL;
    return true;
}

static wcut_status start(pool *p, slot *s) {
    char *word[WORDS_MAX];
    int ends[2];

    /* a pipe takes the last words of the case; no other child inherits its ends */
    if (!split_call(p, s->call, word))
        return wcut_fail(p->error, WCUT_BAD_ARGUMENT, "found a call of more than %d words", WORDS_MAX);
    if (pipe(ends) != 0)
        return wcut_fail_errno(p->error, WCUT_NO_MEMORY, errno, p->options->program, "cannot be started");
    fcntl(ends[0], F_SETFD, FD_CLOEXEC);
    fcntl(ends[1], F_SETFD, FD_CLOEXEC);

    /* start the case; the child does not return from become */
    const pid_t parent = getpid();
    clock_gettime(CLOCK_MONOTONIC, &s->begun);
    s->child = fork();
    if (s->child == 0) become(p, word, ends[1], parent);
    const int code = errno;
    close(ends[1]);
    if (s->child < 0) {
        close(ends[0]);
        return wcut_fail_errno(p->error, WCUT_NO_MEMORY, code, p->options->program, "cannot be started");
    }

    /* the parent never waits for words */
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    s->words_fd = ends[0];
    return WCUT_OK;
}

/* the case that is ready goes into a free place, and the next one is made ready */
static wcut_status fill_places(pool *p) {
    for (int i = 0; i < p->options->jobs && p->ready.folder && !p->stopping; i++) {
        slot *s = &p->running[i];
        if (s->folder) continue;
        *s = p->ready;
        p->ready = (slot){.words_fd = -1};
        p->running_count++;
        wcut_status status = start(p, s);
        if (status != WCUT_OK) {
            clear_slot(s);
            p->running_count--;
            return status;
        }
        status = prepare_next(p);
        if (status != WCUT_OK) return status;
    }
    return WCUT_OK;
}

/* ---- end ---- */

/* take what a child says; false: it has nothing more to say */
static bool hear(slot *s) {
    char piece[4096];
    for (;;) {
        const ssize_t n = read(s->words_fd, piece, sizeof piece);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0 && errno == EAGAIN) return true;
        if (n <= 0) return false;

        /* its end is kept */
        const int taken = n < TAIL ? (int)n : TAIL, kept = s->tail_count + taken > TAIL ? TAIL - taken : s->tail_count;
        memmove(s->tail, s->tail + s->tail_count - kept, (size_t)kept);
        memcpy(s->tail + kept, piece + n - taken, (size_t)taken);
        s->tail_count = kept + taken;
    }
}

/* the last words as one line that any terminal and any file can take */
static void clean_words(const slot *s, char *words) {
    int from = s->tail_count > WCUT_SWEEP_WORDS_SIZE - 1 ? s->tail_count - (WCUT_SWEEP_WORDS_SIZE - 1) : 0, to = 0;
    for (; from < s->tail_count; from++) {
        const unsigned char c = (unsigned char)s->tail[from];
        words[to++] = c == '\n' ? ' ' : c < 0x20 || c > 0x7e ? '?' : (char)c;
    }
    while (to > 0 && words[to - 1] == ' ') to--;
    words[to] = '\0';
}

static wcut_sweep_state state_of_code(int code) {
    switch (code) {
        case 0:
            return WCUT_SWEEP_STATE_DONE;
        case 2:
        case 3:
            return WCUT_SWEEP_STATE_REFUSED;
        case 5:
            return WCUT_SWEEP_STATE_OUTSIDE;
        case 6:
            return WCUT_SWEEP_STATE_NOT_CONVERGED;
        case 130:
            return WCUT_SWEEP_STATE_MISSING;
        default:
            return WCUT_SWEEP_STATE_FAILED;
    }
}

/* the child is gone: how it ended, and its place is free */
static void reap(pool *p, slot *s) {
    int state = 0;
    wcut_sweep_record *r = &s->record;
    close(s->words_fd);
    s->words_fd = -1;
    while (waitpid(s->child, &state, 0) < 0 && errno == EINTR) continue;
    *r = (wcut_sweep_record){.seconds = seconds_since(&s->begun)};
    r->signal = WIFSIGNALED(state) ? WTERMSIG(state) : 0;
    r->code = WIFEXITED(state) ? WEXITSTATUS(state) : 0;
    r->state = r->signal ? WCUT_SWEEP_STATE_CRASHED : state_of_code(r->code);
    clean_words(s, r->words);
    if (p->stopping && r->signal) r->state = WCUT_SWEEP_STATE_MISSING; /* it was asked to end */
    p->ended[p->ended_count++] = *s;
    *s = (slot){.words_fd = -1};
    p->running_count--;
}

/* wait until a child ends, or a moment */
static void await_children(pool *p) {
    struct pollfd of[WCUT_SWEEP_JOBS_MAX];
    slot *who[WCUT_SWEEP_JOBS_MAX];
    nfds_t n = 0;
    for (int i = 0; i < p->options->jobs; i++)
        if (p->running[i].folder) {
            of[n] = (struct pollfd){.fd = p->running[i].words_fd, .events = POLLIN};
            who[n++] = &p->running[i];
        }
    if (poll(of, n, LOOK_MS) <= 0) return;
    for (nfds_t i = 0; i < n; i++)
        if (of[i].revents && !hear(who[i])) reap(p, who[i]);
}

static wcut_status record_ended(pool *p) {
    wcut_status status = WCUT_OK;
    for (int i = 0; i < p->ended_count; i++) {
        slot *s = &p->ended[i];
        if (s->record.state != WCUT_SWEEP_STATE_MISSING && status == WCUT_OK)
            status = wcut_sweep_record_write(s->folder, &s->record, p->error);
        if (s->record.code == CANNOT_START && status == WCUT_OK)
            status = wcut_fail(p->error, WCUT_NOT_FOUND, "%s: cannot be started, expected the wirecut command",
                               p->options->program);
        p->counts.state[s->record.state]++;
        p->counts.seconds += s->record.seconds;
        p->counts.ran++;
        p->looked++;
        clear_slot(s);
    }
    p->ended_count = 0;
    return status;
}

/* ask the children to end, and wait for them */
static void stop_children(pool *p) {
    p->stopping = true;
    for (int i = 0; i < p->options->jobs; i++)
        if (p->running[i].folder) kill(p->running[i].child, SIGTERM);
    while (p->running_count > 0) await_children(p);
}

/* ---- the run ---- */

static wcut_status run_pool(pool *p) {
    /* start, wait, start again, then record: the processors do not wait for the disk */
    wcut_status status = prepare_next(p);
    while (status == WCUT_OK && (p->ready.folder || p->running_count > 0) && !p->stopping) {
        status = fill_places(p);
        if (status == WCUT_OK) await_children(p);
        if (status == WCUT_OK && p->ended_count > 0) status = fill_places(p);
        if (status == WCUT_OK) status = record_ended(p);

        /* with a limit, or a case that was still in the pool, there may be a next one only now */
        if (status == WCUT_OK && !p->ready.folder) status = prepare_next(p);
        const bool stop = p->options->progress && p->options->progress(p->looked, p->counts.cases, p->options->context);
        if (status == WCUT_OK && stop) p->stopping = true;
    }

    /* none is left behind, whatever the reason */
    const bool stopped = p->stopping;
    stop_children(p);
    const wcut_status last = record_ended(p);
    if (status == WCUT_OK) status = last;

    /* an interrupt is reported with what is whole */
    if (status == WCUT_OK && stopped)
        status = wcut_fail(p->error, WCUT_INTERRUPTED, "%s: interrupted with %d of %d cases whole", p->sweep->folder,
                           p->counts.state[WCUT_SWEEP_STATE_DONE], p->counts.cases);
    return status;
}

wcut_sweep_options wcut_sweep_options_default(void) { return (wcut_sweep_options){.jobs = 1, .shares = 1}; }

wcut_status wcut_sweep_run(wcut_sweep *sweep, const wcut_sweep_options *options, wcut_sweep_counts *counts,
                           wcut_error *error) {
    if (!sweep || !options || !options->program || options->jobs < 1 || options->jobs > WCUT_SWEEP_JOBS_MAX ||
        options->shares < 1 || options->share < 0 || options->share >= options->shares || options->limit < 0)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));

    /* a shared lock: several pools may run parts of one sweep */
    wcut_status status = wcut_sweep_lock(sweep, false, error);
    if (status != WCUT_OK) return status;

    /* room for the running cases and for those that ended and are not recorded yet */
    const int cases = sweep->study->info.cases;
    pool p = {.sweep = sweep,
              .options = options,
              .error = error,
              .next = options->share,
              .ready.words_fd = -1,
              .running = wcut_alloc((size_t)options->jobs, sizeof(slot)),
              .ended = wcut_alloc(2 * (size_t)options->jobs, sizeof(slot))};
    p.counts.cases = options->share < cases ? (cases - options->share - 1) / options->shares + 1 : 0;

    /* run, free, and report counts also after an interrupt */
    status = p.running && p.ended ? run_pool(&p) : fail_pool_memory(error);
    clear_slot(&p.ready);
    wcut_free(p.running);
    wcut_free(p.ended);
    if (counts && (status == WCUT_OK || status == WCUT_INTERRUPTED)) *counts = p.counts;
    return status;
}
