/* JSON pointers (RFC 6901): the value that one names, and the one that a misspelt pointer was meant to be. */
#include "io/study/pointer.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/file/nearest.h"

enum {
    ITEMS_LOOKED_AT = 3,    /* of an array: its items are alike */
    PLACES_LOOKED_AT = 5000 /* of a document, so that a large one does not take minutes */
};

bool wcut_pointer_is_valid(const char *text) {
    if (*text && *text != '/') return false;
    for (const char *at = text; *at; at++)
        if (*at == '~' && at[1] != '0' && at[1] != '1') return false;
    return strlen(text) < WCUT_POINTER_SIZE;
}

/* the name up to the next slash, unescaped; gives what is behind it, NULL where it is too long */
static const char *next_name(const char *at, char name[WCUT_POINTER_SIZE]) {
    int length = 0;
    for (; *at && *at != '/'; at++) {
        if (length + 1 == WCUT_POINTER_SIZE) return NULL;
        name[length++] = *at != '~' ? *at : *++at == '1' ? '/' : '~';
    }
    name[length] = '\0';
    return at;
}

/* an item of an array: digits without a leading zero */
static json_t *item_of(json_t *array, const char *name) {
    size_t index = 0;
    if (!*name || (name[0] == '0' && name[1]) || strspn(name, "0123456789") != strlen(name) || strlen(name) > 9)
        return NULL;
    for (; *name; name++) index = 10 * index + (size_t)(*name - '0');
    return json_array_get(array, index);
}

json_t *wcut_pointer_locate(json_t *root, const char *pointer) {
    char name[WCUT_POINTER_SIZE];
    json_t *value = root;
    if (!wcut_pointer_is_valid(pointer)) return NULL;
    while (*pointer && value) {
        pointer = next_name(pointer + 1, name);
        if (!pointer) return NULL;
        value = json_is_array(value) ? item_of(value, name) : json_object_get(value, name);
    }
    return value;
}

bool wcut_pointer_replace(json_t *root, const char *pointer, json_t *value) {
    char above[WCUT_POINTER_SIZE], name[WCUT_POINTER_SIZE];
    const char *slash = strrchr(pointer, '/');
    bool done = false;
    if (value && slash && wcut_pointer_locate(root, pointer) && next_name(slash + 1, name)) {
        memcpy(above, pointer, (size_t)(slash - pointer));
        above[slash - pointer] = '\0';
        json_t *parent = wcut_pointer_locate(root, above);
        done = json_is_array(parent) ? json_array_set(parent, (size_t)strtoul(name, NULL, 10), value) == 0
                                     : json_object_set(parent, name, value) == 0;
    }
    json_decref(value);
    return done;
}

/* ---- the nearest ---- */

/* the search: where it is, what it found */
typedef struct search {
    const char *wanted, *last; /* the pointer, and its last name */
    int places, best;          /* looked at; edits of the nearest */
    char at[WCUT_POINTER_SIZE];
    char *nearest;
} search;

static const char *last_name(const char *pointer) {
    const char *slash = strrchr(pointer, '/');
    return slash ? slash + 1 : pointer;
}

/* the place that the search is at may be nearer than the best one */
static void look_at(search *s) {
    const bool same_name = strcmp(last_name(s->at), s->last) == 0;
    const int edits = wcut_edit_distance(s->wanted, s->at), cost = same_name ? edits / 8 : edits;
    if (cost >= s->best) return;
    s->best = cost;
    memcpy(s->nearest, s->at, strlen(s->at) + 1);
}

static void walk(search *s, const json_t *value, size_t length);

static void enter_place(search *s, const json_t *value, size_t length, const char *name) {
    /* the name, escaped */
    size_t end = length;
    s->at[end++] = '/';
    for (; *name && end + 3 < WCUT_POINTER_SIZE; name++) {
        if (*name == '~' || *name == '/') s->at[end++] = '~';
        s->at[end++] = *name == '~' ? '0' : *name == '/' ? '1' : *name;
    }
    s->at[end] = '\0';

    /* a place is looked at, then what is inside; one with a longer name is passed over */
    if (!*name && s->places++ < PLACES_LOOKED_AT) {
        look_at(s);
        walk(s, value, end);
    }
    s->at[length] = '\0';
}

static void walk(search *s, const json_t *value, size_t length) {
    char number[16];
    if (length + 3 >= WCUT_POINTER_SIZE) return;
    for (void *at = json_object_iter((json_t *)value); at; at = json_object_iter_next((json_t *)value, at))
        enter_place(s, json_object_iter_value(at), length, json_object_iter_key(at));
    for (size_t i = 0; i < json_array_size(value) && i < ITEMS_LOOKED_AT; i++) {
        snprintf(number, sizeof number, "%zu", i);
        enter_place(s, json_array_get(value, i), length, number);
    }
}

bool wcut_pointer_nearest(const json_t *root, const char *pointer, char nearest[WCUT_POINTER_SIZE]) {
    search s = {.wanted = pointer, .last = last_name(pointer), .best = INT_MAX, .nearest = nearest};
    walk(&s, root, 0);
    return s.best < INT_MAX;
}

bool wcut_pointer_overlaps(const char *a, const char *b) {
    const size_t n = strlen(a), m = strlen(b), common = n < m ? n : m;
    if (strncmp(a, b, common) != 0) return false;
    return n == m || (n < m ? b[n] : a[m]) == '/';
}
