/* The wirecut command: finds the verb, runs it, and makes sure that what it said was heard. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/version.h>

#include "command.h"
#include "terminal.h"

#define APP_VERB_ENTRY(name) &app_verb_##name,
const app_verb *const app_verbs[] = {APP_VERB_LIST(APP_VERB_ENTRY) NULL};
#undef APP_VERB_ENTRY

/* ---- the command without a verb ---- */

static const app_operand no_operand[] = {{.name = NULL}};

static const app_option self_option[] = {
    {.kind = APP_FLAG, .name = "version", .letter = 'V', .help = "print the version of the library"},
    {.kind = APP_FLAG, .name = "json-usage", .help = "print verbs, options and exit codes as JSON"},
    {.kind = APP_FLAG, .name = "man", .help = "print the manual page: wirecut --man | man -l -"},
    {.kind = APP_FLAG, .name = "completion", .help = "print the completion for bash: eval \"$(wirecut --completion)\""},
    APP_OPTION_HELP,
    {.kind = APP_END},
};

static int run_self(const app_call *call) {
    if (app_given(call, "version"))
        printf("wirecut %s\n", wcut_version_text());
    else if (app_given(call, "json-usage"))
        app_print_json(stdout);
    else if (app_given(call, "man"))
        app_print_man(stdout);
    else if (app_given(call, "completion"))
        app_print_completion(stdout);
    else
        return app_fail(APP_USAGE, "found no verb, expected one (see wirecut --help)");
    return APP_DONE;
}

const app_verb app_self = {
    .name = "",
    .brief = "spatial hot-wire cutting: simulation, moulds, robot programs, comparison, diagnosis",
    .about =
        "Messages and progress go to standard error, results to standard output. Lengths are mm, times s, forces N, "
        "heat W/m, angles deg. Files appear whole or not at all.",
    .operand = no_operand,
    .option = self_option,
    .run = run_self,
};

/* ---- finding the verb ---- */

static const app_verb *find_verb(const char *name) {
    for (int i = 0; app_verbs[i]; i++)
        if (strcmp(app_verbs[i]->name, name) == 0) return app_verbs[i];
    return NULL;
}

static int refuse_verb(int argc, char **argv) {
    const char *name = argv[1];
    const char *names[sizeof app_verbs / sizeof *app_verbs] = {NULL};
    for (int i = 0; app_verbs[i]; i++) names[i] = app_verbs[i]->name;
    const char *near = app_suggest(name, names);
    if (near) return app_fail(APP_USAGE, "unknown verb \"%s\"; did you mean %s? (see wirecut --help)", name, near);
    for (int k = 2; k < argc; k++)
        if (find_verb(argv[k]))
            return app_fail(APP_USAGE,
                            "unknown verb \"%s\"; the verb comes first: wirecut %s ... (see wirecut %s --help)", name,
                            argv[k], argv[k]);
    return app_fail(APP_USAGE, "unknown verb \"%s\" (see wirecut --help)", name);
}

/* wirecut help VERB is wirecut VERB --help */
static int print_help(int argc, char **argv) {
    const app_verb *verb = argc > 2 ? find_verb(argv[2]) : &app_self;
    if (!verb) return refuse_verb(argc - 1, argv + 1);
    app_print_help(stdout, verb);
    return APP_DONE;
}

static int run_verb(int argc, char **argv) {
    const app_verb *verb = &app_self;
    if (argc > 1 && strcmp(argv[1], "help") == 0) return print_help(argc, argv);
    if (argc > 1 && argv[1][0] != '-') {
        verb = find_verb(argv[1]);
        if (!verb) return refuse_verb(argc, argv);
        argc--, argv++;
    }
    app_call call;
    int code = app_parse(verb, argc, argv, &call);
    if (code != APP_DONE) return code;
    if (app_given(&call, "help"))
        app_print_help(stdout, verb);
    else
        code = verb->run(&call);
    app_call_clear(&call);
    return code;
}

/* ---- the standard streams ---- */

/* A closed standard stream would lend its number to an output file, and words would land in it. */
static bool open_standard_streams(void) {
    for (int fd = 0; fd <= 2; fd++)
        if (fcntl(fd, F_GETFD) < 0 && open("/dev/null", O_RDONLY) != fd) return false;
    return true;
}

/* The result counts as given only once the system took all of it. */
static int close_output(int code) {
    bool bad = ferror(stdout);
    if (fflush(stdout) != 0) bad = true;
    int cause = errno;
    if (close(STDOUT_FILENO) != 0) bad = true, cause = errno;
    if (!bad) return code;
    app_fail(APP_NOT_WRITTEN, "standard output: not written completely: %s", strerror(cause));
    return code == APP_DONE ? APP_NOT_WRITTEN : code;
}

int main(int argc, char **argv) {
    if (!open_standard_streams()) return APP_FAILED;
    /* a reader that went away or a limit of size is an error to report, not an end in silence */
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    return close_output(run_verb(argc, argv));
}
