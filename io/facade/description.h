/* A facade's description in the making. */
#ifndef WCUT_IO_FACADE_DESCRIPTION_H
#define WCUT_IO_FACADE_DESCRIPTION_H

#include <wirecut/facade_file.h>

#include "io/file/json_read.h"

enum {
    WCUT_FACADE_BYTES_MAX = 64 << 20,
    WCUT_FACADE_FIELDS_MAX = 1000,
    WCUT_FACADE_SUM_MAX = 64, /* fields in a sum */
    WCUT_FACADE_VARIANTS_MAX = 10000
};

/* a field by its name, with what it owns */
typedef struct wcut_named_field {
    char *name;
    wcut_facade_field field;
} wcut_named_field;

/* a variant: the job that elements follow, and how its block is laid */
typedef struct wcut_facade_variant {
    char *name, *path;
    wcut_job *job;
    int turn;
    bool mirrored;
} wcut_facade_variant;

typedef enum wcut_deal { WCUT_DEAL_NONE, WCUT_DEAL_CHECKERBOARD, WCUT_DEAL_RANDOM, WCUT_DEAL_NEAREST } wcut_deal;

/* what is being filled */
typedef struct wcut_describing {
    const char *folder; /* names are relative to it: with its slash, or "" */
    char *name;
    wcut_facade_plan plan;
    char *surface_path;
    wcut_surface *surface;

    /* fields, and which of them drive the edges */
    int fields;
    wcut_named_field *field;
    int heights, extras;
    int height[WCUT_FACADE_SUM_MAX], extra[WCUT_FACADE_SUM_MAX];

    /* variants, and the rule by which they are dealt */
    int variants;
    wcut_facade_variant *variant;
    wcut_deal deal;
    int seed, deal_field;
    int deal_values;
    double *deal_value; /* variants, of "nearest" */
    int placements;
    wcut_facade_placement *placement;
} wcut_describing;

/* wcut_facade_read of a text: label stands in front of every message, names are relative to the folder */
wcut_status wcut_facade_parse(const char *text, size_t length, const char *label, const char *folder,
                              wcut_facade_description **description, wcut_error *error);

/* facade_fields.c: "fields"; `into` is a wcut_describing */
bool wcut_facade_read_fields(wcut_reader *reader, const wcut_place *at, void *into);

/* the number of a field by its name; false: refused */
bool wcut_facade_field_locate(wcut_reader *reader, const wcut_place *at, const wcut_describing *d, int *found);

/* "FOLDER/NAME" for wcut_free; NULL: refused */
char *wcut_facade_join(wcut_reader *reader, const wcut_place *at, const wcut_describing *d, const char *name);

/* a number of quarter turns from degrees */
bool wcut_facade_read_turn(wcut_reader *reader, const wcut_place *at, int *turn);

#endif
