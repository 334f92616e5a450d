/* The words typed against a verb's table: getopt_long finds them, the table says what they may be. */
#include <assert.h>
#include <errno.h>
#include <getopt.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "terminal.h"

enum { LONG_FIRST = 256 }; /* codes of long options lie above every letter */

static int count_options(const app_verb *verb) {
    int count = 0;
    while (verb->option[count].kind != APP_END) count++;
    assert(count < APP_OPTIONS_MAX);
    return count;
}

static const char *full_name(const app_verb *verb) {
    static char name[64];
    snprintf(name, sizeof name, "wirecut%s%s", verb->name[0] ? " " : "", verb->name);
    return name;
}

static int usage_error(const app_verb *verb, const char *what, const char *found, const char *expected) {
    return app_fail(APP_USAGE, "%s: found \"%s\", expected %s (see %s --help)", what, found, expected, full_name(verb));
}

/* ---- values ---- */

/* Decimal numbers only; the command never calls setlocale, so that strtod reads a point whatever the user's locale. */
static bool read_option_number(const app_option *option, const char *text, double *number) {
    const char *letters = option->kind == APP_INT ? "+-0123456789" : "+-.0123456789eE";
    char *end = NULL;
    if (option->word && strcmp(text, option->word) == 0) {
        *number = -1;
        return true;
    }
    if (!*text || text[strspn(text, letters)]) return false;
    double value = strtod(text, &end);
    if (*end || !isfinite(value) || value < option->low || value > option->high) return false;
    *number = value;
    return true;
}

/* Which of the words a|b|c; -1 where it is none. */
static int find_word(const char *words, const char *text) {
    size_t length = strlen(text);
    for (int index = 0;; index++) {
        size_t word = strcspn(words, "|");
        if (word == length && strncmp(words, text, word) == 0) return index;
        if (!words[word]) return -1;
        words += word + 1;
    }
}

static int set_value(const app_verb *verb, const app_option *option, const char *text, app_value *value) {
    /* the option as it is named in messages */
    char what[64], expected[128];
    snprintf(what, sizeof what, "--%s", option->name);
    double number = 0;

    /* numbers and words are checked, names only have to be there */
    switch (option->kind) {
        case APP_INT:
        case APP_REAL:
            if (read_option_number(option, text, &number)) break;
            snprintf(expected, sizeof expected, "%s from %.12g to %.12g%s%s",
                     option->kind == APP_INT ? "a whole number" : "a number", option->low, option->high,
                     option->word ? ", or " : "", option->word ? option->word : "");
            return usage_error(verb, what, text, expected);
        case APP_CHOICE:
            number = find_word(option->value, text);
            if (number >= 0) break;
            snprintf(expected, sizeof expected, "one of %s", option->value);
            return usage_error(verb, what, text, expected);
        default:
            if (option->kind != APP_FLAG && !*text) return usage_error(verb, what, text, "a name that is not empty");
    }

    *value = (app_value){.text = text, .number = number};

    return APP_DONE;
}

const char *app_standard(const app_option *option, char text[APP_STANDARD_SIZE]) {
    if (option->library_text) return option->library_text();
    if (!option->library) return option->standard;
    if (option->kind != APP_CHOICE) {
        snprintf(text, APP_STANDARD_SIZE, "%.12g", option->library());
        return text;
    }

    /* which of the words between the bars */
    const char *word = option->value;
    for (int k = (int)option->library(); k > 0 && word; k--) word = strchr(word, '|') ? strchr(word, '|') + 1 : NULL;
    if (word) snprintf(text, APP_STANDARD_SIZE, "%.*s", (int)strcspn(word, "|"), word);
    return word ? text : NULL;
}

/* The value where none is given passes the same check as a typed one. */
static int set_standard(const app_verb *verb, const app_option *option, app_value *value) {
    char text[APP_STANDARD_SIZE];
    const char *standard = app_standard(option, text);
    if (!standard) return APP_DONE;
    const int code = set_value(verb, option, standard, value);
    if (standard == text) value->text = ""; /* the text ends with this call */
    return code;
}

/* ---- words ---- */

static void describe_table(const app_verb *verb, int count, struct option *longs, char *shorts) {
    *shorts++ = '-'; /* operands come in order, POSIXLY_CORRECT or not */
    *shorts++ = ':'; /* a missing value is told from an unknown option */
    for (int i = 0; i < count; i++) {
        const app_option *o = &verb->option[i];
        longs[i] = (struct option){.name = o->name, .has_arg = o->kind != APP_FLAG, .val = LONG_FIRST + i};
        if (!o->letter) continue;
        *shorts++ = o->letter;
        if (o->kind != APP_FLAG) *shorts++ = ':';
    }
    longs[count] = (struct option){0};
    *shorts = 0;
}

/* The option that getopt's code stands for; -1 where there is none. */
static int find_option(const app_verb *verb, int count, int code) {
    if (code >= LONG_FIRST) return code - LONG_FIRST;
    for (int i = 0; i < count; i++)
        if (verb->option[i].letter && verb->option[i].letter == code) return i;
    return -1;
}

static int refuse_unknown(const app_verb *verb, int count, const char *word) {
    const char *names[APP_OPTIONS_MAX + 1] = {NULL};
    for (int i = 0; i < count; i++) names[i] = verb->option[i].name;
    char typed[64];
    snprintf(typed, sizeof typed, "%.*s", (int)strcspn(word, "="), word);
    const char *near = strncmp(typed, "--", 2) == 0 ? app_suggest(typed + 2, names) : NULL;
    if (near)
        return app_fail(APP_USAGE, "unknown option \"%s\"; did you mean --%s? (see %s --help)", typed, near,
                        full_name(verb));
    return app_fail(APP_USAGE, "unknown option \"%s\" (see %s --help)", typed, full_name(verb));
}

/* What getopt_long could not take: a value too few or too many, or a name that is not in the table. */
static int refuse_typed_option(const app_verb *verb, int count, int code, char **argv) {
    char letter[] = {'-', (char)optopt, 0};
    int index = optopt ? find_option(verb, count, optopt) : -1;
    if (index < 0) return refuse_unknown(verb, count, optopt && optopt < LONG_FIRST ? letter : argv[optind - 1]);
    const app_option *o = &verb->option[index];
    if (code == ':')
        return app_fail(APP_USAGE, "--%s: found nothing, expected %s (see %s --help)", o->name, o->value,
                        full_name(verb));
    return app_fail(APP_USAGE, "--%s: found \"%s\", expected no value (see %s --help)", o->name, argv[optind - 1],
                    full_name(verb));
}

/* ---- a whole call ---- */

static int read_parse_words(const app_verb *verb, int count, int argc, char **argv, app_call *call) {
    struct option longs[APP_OPTIONS_MAX + 1];
    char shorts[2 * APP_OPTIONS_MAX + 3];
    describe_table(verb, count, longs, shorts);
    optind = 0; /* GNU: begin anew */
    opterr = 0;
    for (int code; (code = getopt_long(argc, argv, shorts, longs, NULL)) != -1;) {
        if (code == 1) {
            call->operand[call->operand_count++] = optarg;
            continue;
        }
        if (code == '?' || code == ':') return refuse_typed_option(verb, count, code, argv);
        int index = find_option(verb, count, code);
        int bad = set_value(verb, &verb->option[index], optarg ? optarg : "", &call->value[index]);
        if (bad) return bad;
    }
    while (optind < argc) call->operand[call->operand_count++] = argv[optind++];
    return APP_DONE;
}

static int check_complete(const app_verb *verb, int count, const app_call *call) {
    int needed = 0;
    bool many = false;

    /* every operand, and none too many */
    for (; verb->operand[needed].name; needed++) {
        many = verb->operand[needed].many;
        if (call->operand_count > needed) continue;
        return app_fail(APP_USAGE, "%s is missing: expected %s (see %s --help)", verb->operand[needed].name,
                        verb->operand[needed].help, full_name(verb));
    }
    if (call->operand_count > needed && !many)
        return app_fail(APP_USAGE, "found \"%s\", expected no more than %d input%s (see %s --help)",
                        call->operand[needed], needed, needed == 1 ? "" : "s", full_name(verb));

    /* no empty name, no option missing that is required */
    for (int i = 0; i < call->operand_count; i++)
        if (!*call->operand[i]) return usage_error(verb, "an input", "", "a name that is not empty");

    /* required options */
    for (int i = 0; i < count; i++) {
        const app_option *o = &verb->option[i];
        if (!o->required || call->value[i].text) continue;
        return app_fail(APP_USAGE, "--%s is missing: expected %s, a %s (see %s --help)", o->name, o->value, o->help,
                        full_name(verb));
    }

    return APP_DONE;
}

int app_parse(const app_verb *verb, int argc, char **argv, app_call *call) {
    int count = count_options(verb);
    *call = (app_call){.verb = verb, .operand = calloc((size_t)argc + 1, sizeof *call->operand)};
    if (!call->operand) return app_fail(APP_FAILED, "%s", strerror(ENOMEM));
    for (int i = 0; i < count; i++)
        if (set_standard(verb, &verb->option[i], &call->value[i])) assert(!"a standard is within its own range");

    int code = read_parse_words(verb, count, argc, argv, call);
    if (code == APP_DONE && !app_given(call, "help")) code = check_complete(verb, count, call);
    if (code != APP_DONE) app_call_clear(call);
    return code;
}

void app_call_clear(app_call *call) {
    free(call->operand);
    *call = (app_call){0};
}

/* ---- what the verb asks ---- */

/* NULL where the verb's table has no such option */
static const app_value *look_up(const app_call *call, const char *option) {
    for (int i = 0; call->verb->option[i].kind != APP_END; i++)
        if (strcmp(call->verb->option[i].name, option) == 0) return &call->value[i];
    return NULL;
}

static const app_value *find_value(const app_call *call, const char *option) {
    const app_value *value = look_up(call, option);
    if (value) return value;
    assert(!"the verb's table has the option");
    abort();
}

bool app_has(const app_call *call, const char *option) { return look_up(call, option) != NULL; }

bool app_given(const app_call *call, const char *option) { return find_value(call, option)->text; }
const char *app_text(const app_call *call, const char *option) { return find_value(call, option)->text; }
int app_int(const app_call *call, const char *option) { return (int)find_value(call, option)->number; }
double app_real(const app_call *call, const char *option) { return find_value(call, option)->number; }
int app_choice(const app_call *call, const char *option) { return (int)find_value(call, option)->number; }
