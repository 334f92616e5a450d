/* What a verb is: the one table that parsing, help, man page, completion and --json-usage are made from. */
#ifndef APP_COMMAND_H
#define APP_COMMAND_H

#include <stdbool.h>
#include <stdio.h>

/* A new verb is a file apps/NAME.c that defines `const app_verb app_verb_NAME`, and its NAME in this list. */
#define APP_VERB_LIST(X) \
    X(simulate)          \
    X(design)            \
    X(compensate)        \
    X(calibrate)         \
    X(score)             \
    X(control) X(path) X(identify) X(compare) X(overlay) X(mould) X(diagnose) X(apply) X(verify) X(sweep) X(facade)

/* How the command ends. */
#define APP_EXIT_LIST(X)                                                                            \
    X(APP_DONE, 0, "done, and within tolerance")                                                    \
    X(APP_FAILED, 1, "failed for a reason outside the input, such as memory")                       \
    X(APP_USAGE, 2, "the command line is wrong")                                                    \
    X(APP_BAD_INPUT, 3, "an input is missing, broken or out of range")                              \
    X(APP_NOT_WRITTEN, 4, "an output could not be written completely")                              \
    X(APP_OUTSIDE, 5, "a tolerance or a limit is exceeded")                                         \
    X(APP_NOT_CONVERGED, 6, "the solver did not converge; what was computed until then is written") \
    X(APP_INTERRUPTED, 130, "interrupted; what was computed until then is written")

#define APP_EXIT_ENTRY(name, code, text) name = code,
enum { APP_EXIT_LIST(APP_EXIT_ENTRY) APP_OPTIONS_MAX = 48 };
#undef APP_EXIT_ENTRY

/* What an option's value is. */
typedef enum app_kind {
    APP_END,     /* closes a table */
    APP_FLAG,    /* no value */
    APP_TEXT,    /* any text */
    APP_EFFECTS, /* names of effects, with commas */
    APP_FILE,    /* an existing file's name */
    APP_FOLDER,  /* a folder's name */
    APP_INT,     /* a whole number in low .. high */
    APP_REAL,    /* a number in low .. high */
    APP_CHOICE   /* one of the words of `value`, separated by | */
} app_kind;

typedef struct app_option {
    app_kind kind;
    const char *name;     /* long, without dashes; the same meaning in every verb */
    char letter;          /* short, 0 where there is none */
    bool required;        /* the call is refused without it */
    const char *value;    /* what help calls the value, "DIR"; NULL for a flag */
    double low, high;     /* range of a number */
    const char *word;     /* that may stand for a number, which is -1 then; NULL: none */
    const char *standard; /* value where none is given */
    /* or the library's own: a number, of a choice which of its words; a text. With none of them the verb asks app_given */
    double (*library)(void);
    const char *(*library_text)(void);
    const char *help; /* a line */
} app_option;

typedef struct app_operand {
    const char *name; /* "JOB"; NULL closes the table */
    const char *help; /* a line */
    app_kind kind;    /* APP_FILE, APP_FOLDER or APP_TEXT */
    bool many;        /* the last one may take any number, at least one */
} app_operand;

typedef struct app_call app_call;

typedef struct app_verb {
    const char *name;           /* "simulate"; "" for the command itself */
    const char *brief;          /* a line */
    const char *about;          /* paragraphs, separated by line feeds */
    const app_operand *operand; /* all are required */
    const app_option *option;
    int (*run)(const app_call *call); /* gives an exit code */
} app_verb;

/* A value as it was given or by its standard. */
typedef struct app_value {
    const char *text; /* NULL: neither; "" of a number by its standard */
    double number;    /* of APP_INT and APP_REAL; which word, of APP_CHOICE */
} app_value;

/* A verb as the user called it. */
struct app_call {
    const app_verb *verb;
    int operand_count;
    const char **operand;
    app_value value[APP_OPTIONS_MAX]; /* as verb->option */
};

/* Options that mean the same in every verb that has them. */
#define APP_OPTION_OUTPUT                                                                      \
    {                                                                                          \
        .kind = APP_FOLDER, .name = "output", .letter = 'o', .required = true, .value = "DIR", \
        .help = "folder for the results; it is created if missing",                            \
    }
#define APP_OPTION_FORMATS(known)                                                         \
    {                                                                                     \
        .kind = APP_TEXT, .name = "formats", .value = "LIST",                             \
        .help = "files to write, with commas: some of " known "; all where none is given" \
    }
#define APP_OPTION_CHORD_TOLERANCE                                                                   \
    {                                                                                                \
        .kind = APP_REAL, .name = "chord-tolerance", .value = "MM", .low = 1e-4, .high = 1e3,        \
        .library = app_chord_tolerance, .help = "largest distance between triangles and surface, mm" \
    }
#define APP_OPTION_THREADS                                                                       \
    {                                                                                            \
        .kind = APP_INT, .name = "threads", .value = "N", .low = 1, .high = 64, .standard = "1", \
        .help = "number of threads. Results do not depend on it"                                 \
    }
#define APP_OPTION_HELP \
    { .kind = APP_FLAG, .name = "help", .letter = 'h', .help = "print this help" }
/* What every verb takes, and the end of its table. */
#define APP_OPTIONS_OF_ALL                                                                                        \
    {.kind = APP_FLAG, .name = "json", .help = "print the result as JSON on standard output"},                    \
        {.kind = APP_FLAG, .name = "quiet", .letter = 'q', .help = "print errors only: no progress, no summary"}, \
        APP_OPTION_HELP, {                                                                                        \
        .kind = APP_END                                                                                           \
    }

extern const app_verb app_self; /* the command without a verb */
#define APP_VERB_ENTRY(name) extern const app_verb app_verb_##name;
APP_VERB_LIST(APP_VERB_ENTRY)
#undef APP_VERB_ENTRY
extern const app_verb *const app_verbs[]; /* closed by NULL */

/* parse.c: an option's value where none is given, as text; NULL where it has none. */
enum { APP_STANDARD_SIZE = 32 };
const char *app_standard(const app_option *option, char text[APP_STANDARD_SIZE]);

/* parse.c: argv[0] is the verb. Gives APP_DONE, or APP_USAGE after a line that says why. */
int app_parse(const app_verb *verb, int argc, char **argv, app_call *call);
void app_call_clear(app_call *call);
bool app_has(const app_call *call, const char *option);   /* whether the verb's table lists it */
bool app_given(const app_call *call, const char *option); /* for a flag: whether it is set */
const char *app_text(const app_call *call, const char *option);
bool app_wants_format(const app_call *call, const char *format); /* of --formats; all where it is not given */
int app_check_formats(const app_call *call, const char *known);  /* every word of it is one of known, with commas */
int app_int(const app_call *call, const char *option);
double app_real(const app_call *call, const char *option);
int app_choice(const app_call *call, const char *option); /* which word of `value`, from 0 */

/* simulation.c: the library's own default of APP_OPTION_CHORD_TOLERANCE. */
double app_chord_tolerance(void);

/* suggest.c: the name nearest to a misspelt one; NULL where none is near. Names are closed by NULL. */
const char *app_suggest(const char *typed, const char *const *name);

/* help.c, man.c, completion.c: all from the table. */
void app_print_help(FILE *out, const app_verb *verb);
void app_print_json(FILE *out);
void app_print_man(FILE *out);
void app_print_completion(FILE *out);

#endif
