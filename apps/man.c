/* The table as a manual page, man(7). */
#include <string.h>
#include <wirecut/version.h>

#include "command.h"

/* Text as roff takes it: hyphens that can be copied, no line that begins with a request. */
static void roff(FILE *out, const char *text) {
    bool first = true;
    for (; *text; text++) {
        if (first && (*text == '.' || *text == '\'')) fputs("\\&", out);
        first = *text == '\n';
        if (*text == '-')
            fputs("\\-", out);
        else if (*text == '\\')
            fputs("\\e", out);
        else if (*text == '\n')
            fputs("\n.PP\n", out);
        else
            fputc(*text, out);
    }
}

static void line(FILE *out, const char *request, const char *text) {
    fputs(request, out);
    roff(out, text);
    fputc('\n', out);
}

static void print_man_option(FILE *out, const app_option *o) {
    fputs(".TP\n", out);

    /* letter, name and value */
    if (o->letter) fprintf(out, "\\fB\\-%c\\fR, ", o->letter);
    fputs("\\fB\\-\\-", out);
    roff(out, o->name);
    fputs("\\fR", out);
    if (o->value) {
        fputs(" \\fI", out);
        roff(out, o->value);
        fputs("\\fR", out);
    }
    fputc('\n', out);

    /* the sentence, the range and the default */
    roff(out, o->help);
    if (o->kind == APP_INT || o->kind == APP_REAL) fprintf(out, " (%.12g to %.12g)", o->low, o->high);
    char text[APP_STANDARD_SIZE];
    const char *standard = app_standard(o, text);
    if (standard) {
        fputs("; default ", out);
        roff(out, standard);
    }

    fputs(o->required ? "; required\n" : "\n", out);
}

static void print_options(FILE *out, const app_verb *verb) {
    for (const app_option *o = verb->option; o->kind != APP_END; o++) print_man_option(out, o);
}

static void print_man_verb(FILE *out, const app_verb *verb) {
    fprintf(out, ".SS \"wirecut %s", verb->name);
    for (const app_operand *o = verb->operand; o->name; o++) fprintf(out, " %s%s", o->name, o->many ? "..." : "");
    fputs("\"\n", out);
    line(out, "", verb->brief);
    line(out, ".PP\n", verb->about);
    for (const app_operand *o = verb->operand; o->name; o++) {
        fprintf(out, ".TP\n\\fI%s\\fR\n", o->name);
        line(out, "", o->help);
    }
    print_options(out, verb);
}

void app_print_man(FILE *out) {
    fprintf(out, ".TH WIRECUT 1 \"\" \"wirecut %s\" \"User Commands\"\n", wcut_version_text());
    line(out, ".SH NAME\nwirecut \\- ", app_self.brief);
    fputs(".SH SYNOPSIS\n.B wirecut\n.I VERB\n[\\fIinput\\fR ...] [\\fIoptions\\fR]\n", out);
    line(out, ".SH DESCRIPTION\n", app_self.about);
    fputs(".SH OPTIONS\n", out);
    print_options(out, &app_self);
    fputs(".SH VERBS\n", out);
    for (int i = 0; app_verbs[i]; i++) print_man_verb(out, app_verbs[i]);
    fputs(".SH \"EXIT STATUS\"\n", out);
#define APP_EXIT_ENTRY(name, code, text) \
    fprintf(out, ".TP\n%d\n", code);     \
    line(out, "", text);
    APP_EXIT_LIST(APP_EXIT_ENTRY)
#undef APP_EXIT_ENTRY
}
