/* wirecut verify: whether the results in a folder are those that their vouchers list. */
#include <stdio.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "terminal.h"

/* JSON strings of names that the library has let through: no control characters */
static void print_name(const char *text) {
    putchar('"');
    for (; *text; text++) {
        if (*text == '"' || *text == '\\') putchar('\\');
        putchar(*text);
    }
    putchar('"');
}

static const char *state_word(wcut_result_state state) {
    static const char *const word[] = {"whole", "changed", "missing"};
    return word[state];
}

static void print_verify_json(const wcut_verification *v) {
    printf("{\n  \"format\": \"wirecut-verification/1\",\n  \"whole\": %s,\n  \"files\": [",
           v->broken ? "false" : "true");
    for (int k = 0; k < v->count; k++) {
        printf("%s\n    {\"voucher\": ", k ? "," : "");
        print_name(v->file[k].voucher);
        printf(", \"name\": ");
        print_name(v->file[k].name);
        printf(", \"state\": \"%s\"}", state_word(v->file[k].state));
    }
    printf("\n  ]\n}\n");
}

static int verify(const app_call *call) {
    /* every voucher of the folder, and its files */
    wcut_error error = {0};
    wcut_verification *v = NULL;
    const char *folder = call->operand[0];
    const wcut_status status = wcut_results_verify(folder, &v, &error);
    if (status != WCUT_OK) return app_fail_status(status, error.text[0] ? NULL : folder, &error);
    if (app_given(call, "json")) print_verify_json(v);

    /* each broken file is a line; the last one is the answer */
    for (int k = 0; k < v->count; k++)
        if (v->file[k].state != WCUT_RESULT_STATE_WHOLE)
            app_say("%s: %s, listed by %s", v->file[k].name, state_word(v->file[k].state), v->file[k].voucher);

    /* the exit code */
    int code = APP_DONE;
    if (v->broken)
        code = app_fail(APP_BAD_INPUT, "%s: %d of %d files are not as their voucher lists them", folder, v->broken,
                        v->count);
    else if (!app_given(call, "quiet"))
        app_say("%s: %d files are as %d voucher%s list%s them", folder, v->count, v->vouchers,
                v->vouchers == 1 ? "" : "s", v->vouchers == 1 ? "s" : "");

    wcut_verification_destroy(v);
    return code;
}

static const app_operand operand[] = {
    {.name = "DIR", .kind = APP_FOLDER, .help = "a folder of results"},
    {.name = NULL},
};

static const app_option option[] = {APP_OPTIONS_OF_ALL};

const app_verb app_verb_verify = {
    .name = "verify",
    .brief = "check a folder of results against its voucher",
    .about =
        "Every verb writes its files as one set: the JSON file that it names last lists them with their SHA-256. "
        "verify reads each file and compares. A file that was changed or is missing ends it with 3, and so does a "
        "folder without a voucher.\n"
        "A run that was killed while its files were put into the folder is finished first.",
    .operand = operand,
    .option = option,
    .run = verify,
};
