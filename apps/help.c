/* The table as text for people and as JSON for programs. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>

#include "command.h"
#include "terminal.h"

enum { TEXT_WIDTH = 100, NAME_WIDTH = 32, NARROW = 80, NARROW_NAME = 12 };

/* of the text, and of its column of names: a narrow terminal gets the help below the name */
static int text_width = TEXT_WIDTH, name_width = NAME_WIDTH;

static const struct {
    int code;
    const char *text;
} exit_code[] = {
#define APP_EXIT_ENTRY(name, number, words) {number, words},
    APP_EXIT_LIST(APP_EXIT_ENTRY)
#undef APP_EXIT_ENTRY
};
enum { EXIT_CODES = sizeof exit_code / sizeof *exit_code };

/* ---- text ---- */

/* Words between the left margin and TEXT_WIDTH; the cursor stands at `column`. */
static void print_wrapped(FILE *out, const char *text, int margin, int column) {
    /* word by word: a new line where the next one does not fit */
    while (*text) {
        int length = (int)strcspn(text, " \n");
        if (column > margin && column + 1 + length > text_width) {
            fprintf(out, "\n");
            column = 0;
        }

        /* fill up to the margin, or put a blank between words */
        if (column < margin) {
            fprintf(out, "%*s", margin - column, "");
            column = margin;
        } else if (column > margin) {
            fprintf(out, " ");
            column++;
        }
        fprintf(out, "%.*s", length, text);
        column += length;

        /* line feeds of the text are kept */
        text += length;
        for (; *text == ' ' || *text == '\n'; text++)
            if (*text == '\n') fprintf(out, "\n"), column = 0;
    }
    fprintf(out, "\n");
}

static void print_help_entry(FILE *out, const char *name, const char *help) {
    int column = fprintf(out, "  %s", name);
    if (column > name_width - 2) {
        fprintf(out, "\n");
        column = 0;
    }
    print_wrapped(out, help, name_width, column);
}

static void print_help_option(FILE *out, const app_option *o) {
    char name[96], help[400], range[64] = "", text[APP_STANDARD_SIZE];
    const char *standard = app_standard(o, text);
    char letter[] = {'-', o->letter, ',', ' ', 0};
    snprintf(name, sizeof name, "%s--%s%s%s", o->letter ? letter : "    ", o->name, o->value ? " " : "",
             o->value ? o->value : "");
    if (o->kind == APP_INT || o->kind == APP_REAL) snprintf(range, sizeof range, " (%.12g to %.12g)", o->low, o->high);
    snprintf(help, sizeof help, "%s%s%s%s%s", o->help, range, standard ? "; default " : "", standard ? standard : "",
             o->required ? "; required" : "");
    print_help_entry(out, name, help);
}

static void print_usage_line(FILE *out, const app_verb *verb) {
    fprintf(out, "usage: wirecut%s%s", verb->name[0] ? " " : "", verb->name);
    for (const app_operand *o = verb->operand; o->name; o++) fprintf(out, " %s%s", o->name, o->many ? "..." : "");
    for (const app_option *o = verb->option; o->kind != APP_END; o++)
        if (o->required && o->letter)
            fprintf(out, " -%c %s", o->letter, o->value);
        else if (o->required)
            fprintf(out, " --%s %s", o->name, o->value);
    fprintf(out, " [options]\n");
}

void app_print_help(FILE *out, const app_verb *verb) {
    bool self = verb == &app_self;

    /* a narrow terminal has shorter lines */
    const int width = app_terminal_width(fileno(out), TEXT_WIDTH);
    text_width = width < TEXT_WIDTH ? width - 1 : TEXT_WIDTH;
    name_width = width < NARROW ? NARROW_NAME : NAME_WIDTH;

    /* what the verb is, how it is called, what it does */
    print_wrapped(out, verb->brief, 0, fprintf(out, "wirecut%s%s -", self ? "" : " ", verb->name));
    fprintf(out, "\n");
    if (self) fprintf(out, "usage: wirecut VERB ... (wirecut VERB --help says more)\n");
    print_usage_line(out, verb);
    fprintf(out, "\n");
    print_wrapped(out, verb->about, 0, 0);

    /* the tables: verbs, inputs, options, exit codes */
    if (self) {
        fprintf(out, "\nVerbs\n");
        for (int i = 0; app_verbs[i]; i++) print_help_entry(out, app_verbs[i]->name, app_verbs[i]->brief);
    }
    if (verb->operand->name) {
        fprintf(out, "\nInputs\n");
        for (const app_operand *o = verb->operand; o->name; o++) print_help_entry(out, o->name, o->help);
    }
    fprintf(out, "\nOptions\n");
    for (const app_option *o = verb->option; o->kind != APP_END; o++) print_help_option(out, o);
    fprintf(out, "\nExit codes\n");

    /* the codes are the same for all verbs */
    for (int i = 0; i < EXIT_CODES; i++) {
        char code[16];
        snprintf(code, sizeof code, "%d", exit_code[i].code);
        print_help_entry(out, code, exit_code[i].text);
    }
}

/* ---- JSON ---- */

static void json_text(FILE *out, const char *key, const char *text) {
    fprintf(out, "\"%s\":", key);
    if (!text) {
        fputs("null", out);
        return;
    }
    fputc('"', out);
    for (; *text; text++)
        if (*text == '"' || *text == '\\')
            fprintf(out, "\\%c", *text);
        else if ((unsigned char)*text < 0x20)
            fprintf(out, "\\u%04x", *text);
        else
            fputc(*text, out);
    fputc('"', out);
}

static void json_option(FILE *out, const app_option *o) {
    static const char *const kind[] = {"", "flag", "text", "effects", "file", "folder", "int", "real", "choice"};
    char letter[] = {o->letter, 0}, text[APP_STANDARD_SIZE];
    fputc('{', out);
    json_text(out, "name", o->name);
    fputc(',', out);
    json_text(out, "letter", o->letter ? letter : NULL);
    fputc(',', out);
    json_text(out, "kind", kind[o->kind]);
    fputc(',', out);
    json_text(out, "value", o->value);
    if (o->kind == APP_INT || o->kind == APP_REAL) fprintf(out, ",\"low\":%.17g,\"high\":%.17g", o->low, o->high);
    fprintf(out, ",\"required\":%s,", o->required ? "true" : "false");
    json_text(out, "default", app_standard(o, text));
    fputc(',', out);
    json_text(out, "help", o->help);
    fputc('}', out);
}

static void json_verb(FILE *out, const app_verb *verb) {
    /* the verb */
    fputc('{', out);
    json_text(out, "name", verb->name);
    fputc(',', out);
    json_text(out, "brief", verb->brief);
    fputc(',', out);
    json_text(out, "about", verb->about);

    /* its inputs, then its options */
    fputs(",\"inputs\":[", out);
    for (const app_operand *o = verb->operand; o->name; o++) {
        fputs(o == verb->operand ? "{" : ",{", out);
        json_text(out, "name", o->name);
        fprintf(out, ",\"many\":%s,", o->many ? "true" : "false");
        json_text(out, "help", o->help);
        fputc('}', out);
    }
    fputs("],\"options\":[\n", out);
    for (const app_option *o = verb->option; o->kind != APP_END; o++) {
        fputs(o == verb->option ? "    " : ",\n    ", out);
        json_option(out, o);
    }
    fputs("]}", out);
}

void app_print_json(FILE *out) {
    fputs("{\"format\":\"wirecut-usage/1\",", out);
    json_text(out, "version", wcut_version_text());
    fputs(",\n\"command\":\n  ", out);
    json_verb(out, &app_self);
    fputs(",\n\"verbs\":[", out);
    for (int i = 0; app_verbs[i]; i++) {
        fputs(i ? ",\n  " : "\n  ", out);
        json_verb(out, app_verbs[i]);
    }
    fputs("],\n\"exit_codes\":[", out);
    for (int i = 0; i < EXIT_CODES; i++) {
        fprintf(out, "%s{\"code\":%d,", i ? ",\n  " : "\n  ", exit_code[i].code);
        json_text(out, "meaning", exit_code[i].text);
        fputc('}', out);
    }
    fputs("]}\n", out);
}
