/* One broken argument at a time: each argument has some ways to be broken; the call is made once for each way of each. */
#include "hostile/hostile.h"

#include <stdint.h>

enum { COPIES_MAX = 16, TEXT_MAX = 200 };

void *const hostile_mark = (void *)0x999;

/* `turn` is the way of this call, `seen` how many ways the arguments before had */
static struct {
    long turn, seen;
    bool broken, refused, first;
    char text[TEXT_MAX];
    void *copy[COPIES_MAX];
    int copies, wrong;
} now;

static void free_copies(void) {
    for (int k = 0; k < now.copies; k++) free(now.copy[k]);
    now.copies = 0;
}

void hostile_begin(void) {
    free_copies();
    memset(&now, 0, sizeof now);
    now.turn = -1;
    now.first = true;
}

bool hostile_next(void) {
    free_copies();
    if (!now.first && !now.broken) return false; /* the sound call was the last */
    now.first = now.broken = now.refused = false;
    now.turn++;
    now.seen = 0;
    snprintf(now.text, sizeof now.text, "the sound call");
    return true;
}

/* the way in which this argument is to be broken now, -1: none */
static int way_of(int ways, bool refused, const char *argument) {
    const long way = now.turn - now.seen;
    now.seen += ways;
    if (way < 0 || way >= ways) return -1;
    now.broken = true;
    now.refused = refused;
    snprintf(now.text, sizeof now.text, "%s broken, way %ld", argument, way);
    return (int)way;
}

bool hostile_status(wcut_status status) {
    const bool done = status == WCUT_OK || status == WCUT_INTERRUPTED;
    const bool right = now.broken ? !now.refused || !done : done;
    if (right) return true;
    printf("    %s: %s\n", now.text, wcut_status_text(status));
    now.wrong++;
    return false;
}

void hostile_touched(const char *what) {
    printf("    %s: refused, but not %s\n", now.text, what);
    now.wrong++;
}

void hostile_end(const char *name) {
    free_copies();
    fflush(stdout);
    ck_assert_msg(now.wrong == 0, "%s: %d of %ld calls went wrong, see above", name, now.wrong, now.turn + 1);
}

void *hostile_pointer(const void *p, bool refused, const char *text) {
    return way_of(1, refused, text) == 0 ? NULL : (void *)p;
}

double hostile_number(double x, bool refused, const char *text) {
    const double broken[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const int way = way_of(3, refused, text);
    return way < 0 ? x : broken[way];
}

int hostile_int(int n, bool refused, bool largest, const char *text) {
    const int broken[3] = {-1, INT_MIN, INT_MAX};
    const int way = way_of(largest ? 3 : 2, refused, text);
    return way < 0 ? n : broken[way];
}

int hostile_threads(int n, const char *text) {
    const int broken[3] = {-1, INT_MIN, INT_MAX}, way = way_of(3, true, text);
    if (way == 2) now.refused = false;
    return way < 0 ? n : broken[way];
}

wcut_vec3 hostile_vec3(wcut_vec3 v, const char *text) {
    const int way = way_of(3, true, text);
    if (way == 0) v.x = (double)NAN;
    if (way == 1) v.y = (double)INFINITY;
    if (way == 2) v.z = -(double)INFINITY;
    return v;
}

/* a copy of its own, exactly so large, so that a sanitizer sees who reads past it */
static void *copy_of(const void *p, size_t size) {
    void *copy = malloc(size);
    if (!copy || now.copies == COPIES_MAX) abort();
    now.copy[now.copies++] = copy;
    return memcpy(copy, p, size);
}

void *hostile_values(const void *p, size_t size, bool refused, const char *text) {
    const double broken[2] = {(double)NAN, (double)INFINITY};
    const int way = way_of(3, true, text);
    if (way == 0) now.refused = refused;
    if (way == 0) return NULL;
    double *copy = copy_of(p, size);
    const size_t count = size / sizeof *copy;
    if (way > 0) copy[way == 1 ? count / 2 : count / 4] = broken[way - 1];
    return copy;
}

void *hostile_record(const void *p, size_t size, int from, int to, const char *text) {
    const int words = to - from, way = way_of(words + 1, false, text);
    if (way == words) return NULL;
    unsigned char *copy = copy_of(p, size);
    if (way >= 0) memset(copy + 8 * (size_t)(from + way), 0xff, 8);
    return copy;
}

void hostile_fill(void *p, size_t size) { memset(p, 0x99, size); }

bool hostile_is_filled(const void *p, size_t size) {
    const unsigned char *byte = p;
    for (size_t k = 0; k < size; k++)
        if (byte[k] != 0x99) return false;
    return true;
}
