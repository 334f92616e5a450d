/* A sweep's folder, for the files of this room.

     plan.json, study.json, input.json, manifest.csv    the plan, under plan.json
     cases/HH/HASH/input.json                           of a case: its input (of recordings: input/case.json and its files),
     cases/HH/HASH/...                                  the verb's results under their own voucher,
     cases/HH/HASH/case.json                            and, written last, how it ended
     sweep.csv, report.html, sweep.json                 what was collected, under sweep.json
     .sweep-lock                                        who runs: alone (wcut_sweep_create), or a task among others */
#ifndef WCUT_IO_STUDY_SWEEP_H
#define WCUT_IO_STUDY_SWEEP_H

#include <jansson.h>
#include <wirecut/sweep.h>

#include "io/study/study.h"

struct wcut_sweep {
    wcut_study *study;
    char *folder; /* absolute */
    int lock;     /* descriptor; -1: none */
};

enum { WCUT_SWEEP_WORDS_SIZE = 400, WCUT_SWEEP_RESULT_SIZE = 200 };

/* case.json */
typedef struct wcut_sweep_record {
    wcut_sweep_state state;
    int code, signal; /* exit code; the signal that ended it, 0: none */
    double seconds;
    char result[WCUT_SWEEP_RESULT_SIZE]; /* the voucher of its results; "": none */
    char hash[WCUT_STUDY_HASH_SIZE];     /* of that file */
    char words[WCUT_SWEEP_WORDS_SIZE];   /* its last ones */
} wcut_sweep_record;

/* sweep_case.c: the folder of a case by its hash, for free(); NULL: no memory */
char *wcut_sweep_folder(const wcut_sweep *sweep, const char *hash);

/* case.json of a folder; false, and state missing: there is none, or it cannot be read */
bool wcut_sweep_record_read(const char *folder, wcut_sweep_record *record);

/* whether a record is final and its results are those that it vouches for */
bool wcut_sweep_record_is_whole(const char *folder, const wcut_sweep_record *record);

/* find the voucher of the results in a folder, and write case.json */
wcut_status wcut_sweep_record_write(const char *folder, wcut_sweep_record *record, wcut_error *error);

/* the result of a case as a document, for json_decref; NULL: it has none */
json_t *wcut_sweep_result_load(const char *folder, const wcut_sweep_record *record);

/* sweep_input.c: the input of case k into its folder, which is there; none is written where no parameter is a pointer. A
   case of recordings gets its files beside it, by links where the file system has them. WCUT_OK; WCUT_NOT_WRITTEN,
   WCUT_NOT_FOUND (a file of the case cannot be read), WCUT_NO_MEMORY */
wcut_status wcut_sweep_input_write(const wcut_study *study, int k, const char *folder, wcut_error *error);

/* sweep_plan.c: take the lock, alone or beside others. WCUT_OK; WCUT_NOT_WRITTEN */
wcut_status wcut_sweep_lock(wcut_sweep *sweep, bool alone, wcut_error *error);

/* sweep_plan.c: make the folder of a study and put its plan there, as wcut_sweep_create; the study is the sweep's then,
   and freed on failure */
wcut_status wcut_sweep_plan(wcut_study *study, const char *folder, wcut_sweep **sweep, wcut_error *error);

/* a value as a field of a CSV, quoted where need be (RFC 4180) */
void wcut_sweep_put_field(wcut_text *text, const char *value);
void wcut_sweep_put_value(wcut_text *text, const wcut_study *study, int k, int parameter);

#endif
