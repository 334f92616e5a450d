/* Hostile calls: every public function is called again and again, each time with one argument broken. An entry writes
   one sound call and says of each argument how it can be broken:

       HOSTILE_OUT(wcut_surface_normal, wcut_vec3, PTR(surface()), NUM(0.5), NUM(0.5))

   PTR(p)          NULL is refused                      OPT(p)        NULL is allowed
   NUM(x)          NaN and infinities are refused       ANY_NUM(x)    they are allowed
   COUNT(n)        negative is refused                  ANY_COUNT(n)  it is allowed
   INT(n)          negative and INT_MAX are refused     ANY_INT(n)    they are allowed
   THREADS(n)      negative is refused, INT_MAX is allowed
   ENUM(e)         below and above are refused          ANY_ENUM(e)   they are allowed
   VEC(v)          a vector by value with NaN or infinity in it is refused
   VALUES(p, n)    NULL, and NaN or infinity among its n elements of doubles, are refused; the copy ends where it ends
   OPT_VALUES(p, n)  the same, but that NULL is allowed
   RECORD(p)       a struct without pointers: each of its fields in turn all ones (NaN, -1); what is no matter is allowed

   RECORD_WORDS(p, from, to)  the same for these words of 8 bytes alone: a bool of all ones is no bool

   A refused call gives a status and leaves its outputs as they were; an allowed one gives any status. None crashes; the
   sound call itself succeeds. house_hostile.sh finds the functions that have no entry. */
#ifndef WCUT_TESTS_HOSTILE_HOSTILE_H
#define WCUT_TESTS_HOSTILE_HOSTILE_H

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/wirecut.h>

#include "test.h"

void hostile_begin(void);

/* prepare the next call; false where every argument had its turn */
bool hostile_next(void);

/* what a status means for this call; false (and a line printed) where it is not what it has to be */
bool hostile_status(wcut_status status);

/* note that outputs of a refused call were touched */
void hostile_touched(const char *what);
void hostile_end(const char *name);

void *hostile_pointer(const void *p, bool refused, const char *text);
double hostile_number(double x, bool refused, const char *text);
int hostile_int(int n, bool refused, bool largest, const char *text);
int hostile_threads(int n, const char *text);
wcut_vec3 hostile_vec3(wcut_vec3 v, const char *text);
void *hostile_values(const void *p, size_t size, bool refused, const char *text);
void *hostile_record(const void *p, size_t size, int from, int to, const char *text);

/* every byte 0x99, and whether it is still */
void hostile_fill(void *p, size_t size);
bool hostile_is_filled(const void *p, size_t size);

#define PTR(p) hostile_pointer(p, true, #p)
#define OPT(p) hostile_pointer(p, false, #p)
#define NUM(x) hostile_number(x, true, #x)
#define ANY_NUM(x) hostile_number(x, false, #x)
#define COUNT(n) hostile_int(n, true, false, #n)
#define ANY_COUNT(n) hostile_int(n, false, false, #n)
#define INT(n) hostile_int(n, true, true, #n)
#define ANY_INT(n) hostile_int(n, false, true, #n)
#define THREADS(n) hostile_threads(n, #n)
#define ENUM(e) ((__typeof__(e))hostile_int((int)(e), true, true, #e))
#define ANY_ENUM(e) ((__typeof__(e))hostile_int((int)(e), false, true, #e))
#define VEC(v) hostile_vec3(v, #v)
#define VALUES(p, n) hostile_values(p, (size_t)(n) * sizeof *(p), true, #p)
#define OPT_VALUES(p, n) hostile_values(p, (size_t)(n) * sizeof *(p), false, #p)
#define RECORD(p) RECORD_WORDS(p, 0, (int)(sizeof *(p) / 8))
#define RECORD_WORDS(p, from, to) hostile_record(p, sizeof *(p), from, to, #p)

/* what a pointer to a made object is before the call */
extern void *const hostile_mark;
#define MARK hostile_mark
#define OUT_FILE "hostile.out"

#define EACH_HOSTILE_ARGUMENT(name, call, untouched, forget)         \
    do {                                                             \
        for (hostile_begin(); hostile_next();) {                     \
            const wcut_status status_ = (call);                      \
            hostile_status(status_);                                 \
            if (status_ != WCUT_OK && status_ != WCUT_INTERRUPTED) { \
                if (!(untouched)) hostile_touched(#untouched);       \
            } else {                                                 \
                forget;                                              \
            }                                                        \
        }                                                            \
        hostile_end(#name);                                          \
    } while (0)

#define HOSTILE(name) TEST(name)

/* the last argument is a struct or a value that is written */
#define HOSTILE_OUT(name, type, ...)                                                                   \
    TEST(name) {                                                                                       \
        type out;                                                                                      \
        hostile_fill(&out, sizeof out);                                                                \
        EACH_HOSTILE_ARGUMENT(name, name(__VA_ARGS__, PTR(&out)), hostile_is_filled(&out, sizeof out), \
                              hostile_fill(&out, sizeof out));                                         \
    }

/* the last argument is an array that is written */
#define HOSTILE_ARRAY(name, type, size, ...)                                                             \
    TEST(name) {                                                                                         \
        type out[size];                                                                                  \
        hostile_fill(out, sizeof out);                                                                   \
        EACH_HOSTILE_ARGUMENT(name, name(__VA_ARGS__, PTR(&out[0])), hostile_is_filled(out, sizeof out), \
                              hostile_fill(out, sizeof out));                                            \
    }

/* `made` is among the arguments and is made by the call */
#define HOSTILE_MADE(name, type, destroy, ...)                                                      \
    TEST(name) {                                                                                    \
        type *made = MARK;                                                                          \
        EACH_HOSTILE_ARGUMENT(name, name(__VA_ARGS__), made == MARK, (destroy(made), made = MARK)); \
    }

/* a file OUT_FILE appears or does not */
#define HOSTILE_FILE(name, ...) \
    TEST(name) { EACH_HOSTILE_ARGUMENT(name, name(__VA_ARGS__), access(OUT_FILE, F_OK) != 0, remove(OUT_FILE)); }

/* a text is printed to `made` */
#define HOSTILE_TEXT(name, ...) HOSTILE_MADE(name, char, free, __VA_ARGS__)

/* nothing is written by it */
#define HOSTILE_STATUS(name, ...) \
    TEST(name) { EACH_HOSTILE_ARGUMENT(name, name(__VA_ARGS__), true, (void)0); }

/* a value or nothing is given back, whatever the arguments: it only must not crash */
#define HOSTILE_VALUE(name, ...)                                  \
    TEST(name) {                                                  \
        for (hostile_begin(); hostile_next();) name(__VA_ARGS__); \
        hostile_end(#name);                                       \
    }

#endif
