/* What a study is made of, for the files of this room.

   A case's input is not made by changing a document: the input's canonical text is printed once, with the places of the
   parameters known, and a case is its pieces with the case's values between them. */
#ifndef WCUT_IO_STUDY_STUDY_H
#define WCUT_IO_STUDY_STUDY_H

#include <jansson.h>
#include <stddef.h>
#include <stdint.h>
#include <wirecut/study.h>

#include "io/file/json_read.h"
#include "io/file/text.h"

/* limits beyond which it is a slip of the pen */
enum {
    WCUT_STUDY_BYTES_MAX = 64 << 20, /* of the study, of its input */
    WCUT_STUDY_PARAMETERS_MAX = 64,
    WCUT_STUDY_VALUES_MAX = 4000000, /* of all ranges together */
    WCUT_STUDY_FIGURES_MAX = 256,
    WCUT_STUDY_INPUTS_MAX = 64
};

typedef enum wcut_combine {
    WCUT_COMBINE_GRID,
    WCUT_COMBINE_ZIP,
    WCUT_COMBINE_ROWS,
    WCUT_COMBINE_LATIN,
    WCUT_COMBINE_SOBOL
} wcut_combine;

/* a parameter: a list of values, or an interval that samples are drawn from */
typedef struct wcut_study_parameter {
    char *name;
    json_t *list;     /* an array; NULL: an interval */
    double low, high; /* of the interval */
    double step;      /* samples are low + a multiple of it; 0: any number */
    bool log;         /* evenly spread in the logarithm */
    int *interval;    /* cases: of a Latin hypercube; else NULL */
    size_t at;        /* where its value goes in the canonical input; of an option, and of the whole input, 0 */
} wcut_study_parameter;

/* a file that cases use as it is */
typedef struct wcut_study_file {
    char *name; /* relative to the study's folder, or from the root */
    char hash[WCUT_STUDY_HASH_SIZE];
} wcut_study_file;

struct wcut_study {
    wcut_study_info info;
    char *folder; /* of the study, with its slash; "" where it is the working one */
    char *name, *verb;
    int inputs;
    char **input;
    json_t *options; /* an object, NULL: none */
    wcut_combine combine;
    int asked, seed; /* cases of a sample */
    double listed;   /* values of all ranges */
    char *rows;      /* the name of a CSV of rows */
    int parameters, figures;
    wcut_study_parameter *parameter;
    const char **parameter_name;
    char **figure, **pointer;
    char *best;
    bool highest;
    char *canonical; /* the input without the values of parameters; NULL: no parameter is a pointer */
    int *order;      /* the parameters that are pointers, as they come in it */
    int places;      /* how many */
    bool recorded;   /* the varied input is a case of recordings, whose files lie beside it */
    int files;
    wcut_study_file *file;
    char *text, *base; /* the study as it was read; the input that is varied, NULL: none */
    size_t text_length, base_length;
};

/* study_read.c: the study's text; `label` in messages, names relative to `folder`. base: the varied input's own text, or
   NULL: it is read by its name. */
wcut_status wcut_study_parse(const char *text, size_t length, const char *label, const char *folder, const char *base,
                             size_t base_length, wcut_study **study, wcut_error *error);

/* study_parameter.c: values of "parameters", cases by "combine"; false: refused */
bool wcut_study_read_parameters(wcut_reader *reader, const wcut_place *at, wcut_study *study);
bool wcut_study_combine(wcut_reader *reader, const wcut_place *at, wcut_study *study);
bool wcut_study_read_rows(wcut_reader *reader, const wcut_place *at, wcut_study *study);

/* study_input.c: the canonical input with the places of its parameters; false: refused */
bool wcut_study_prepare_input(wcut_reader *reader, const wcut_place *at, wcut_study *study, const char *base,
                              size_t length);

/* study_case.c: the value of a parameter in a case: borrowed from its list, or NULL and a number */
const json_t *wcut_study_value(const wcut_study *study, int k, int parameter, double *number);

/* canonical.c: JSON with sorted keys, without blanks, numbers the shortest that read back the same. `hole`, or NULL, is
   called at every value; where it is true, nothing is printed for that value. */
typedef bool wcut_hole(void *context, const json_t *value, const wcut_text *text);
void wcut_canonical_print(wcut_text *text, const json_t *value, wcut_hole *hole, void *context);

/* the path of a file that the study names, for free(); NULL: no memory */
char *wcut_study_join(const wcut_study *study, const char *name);

/* study_input.c: the same of a file that the varied input names, relative to the study's folder */
char *wcut_study_beside_input(const wcut_study *study, const char *name);

#endif
