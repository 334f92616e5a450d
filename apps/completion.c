/* The table as a completion script for bash. */
#include <string.h>
#include <wirecut/effects.h>

#include "command.h"

static void print_names(FILE *out, const app_verb *verb) {
    for (const app_option *o = verb->option; o->kind != APP_END; o++) {
        fprintf(out, "--%s ", o->name);
        if (o->letter) fprintf(out, "-%c ", o->letter);
    }
}

/* The words of a choice, separated by spaces. */
static void print_choice(FILE *out, const char *words) {
    for (; *words; words++) fputc(*words == '|' ? ' ' : *words, out);
}

/* After an option that takes a value: what the value may be. */
static void print_completion_value(FILE *out, const app_option *o) {
    /* a flag has no value */
    if (o->kind == APP_FLAG) return;
    fprintf(out, "        --%s", o->name);
    if (o->letter) fprintf(out, "|-%c", o->letter);
    fputs(") COMPREPLY=(", out);

    /* lists of effects, one after a comma */
    if (o->kind == APP_EFFECTS) {
        fputs("$(compgen -P \"${word%\"${word##*,}\"}\" -W '", out);
        for (int k = 0; k < WCUT_EFFECT_COUNT; k++) fprintf(out, "%s ", wcut_effect_view((wcut_effect_kind)k)->name);
        fputs("' -- \"${word##*,}\")", out);
    }

    /* words, folders or files */
    if (o->kind == APP_CHOICE) {
        fputs("$(compgen -W '", out);
        print_choice(out, o->value);
        fputs("' -- \"$word\")", out);
    } else if (o->kind == APP_FOLDER) {
        fputs("$(compgen -d -- \"$word\")", out);
    } else if (o->kind == APP_FILE) {
        fputs("$(compgen -f -- \"$word\")", out);
    }
    fputs("); return;;\n", out);
}

static void print_completion_verb(FILE *out, const app_verb *verb) {
    fprintf(out, "    %s)\n        case $before in\n", verb->name);
    for (const app_option *o = verb->option; o->kind != APP_END; o++) print_completion_value(out, o);
    fputs("        esac\n        options='", out);
    print_names(out, verb);
    fputs("';;\n", out);
}

void app_print_completion(FILE *out) {
    /* the words of the first position: verbs and the options of the command */
    fputs(
        "# completion of wirecut for bash\n"
        "_wirecut() {\n"
        "    local IFS=$' \\t\\n' word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} options=\n"
        "    COMPREPLY=()\n"
        "    if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
        "        COMPREPLY=($(compgen -W '",
        out);
    for (int i = 0; app_verbs[i]; i++) fprintf(out, "%s ", app_verbs[i]->name);
    print_names(out, &app_self);
    fputs("' -- \"$word\"))\n        return\n    fi\n    case ${COMP_WORDS[1]} in\n", out);

    /* the options of each verb */
    for (int i = 0; app_verbs[i]; i++) print_completion_verb(out, app_verbs[i]);

    /* every other word is a file */
    fputs(
        "    *) return;;\n"
        "    esac\n"
        "    local IFS=$'\\n'\n"
        "    case $word in\n"
        "    -*) COMPREPLY=($(IFS=' ' compgen -W \"$options\" -- \"$word\"));;\n"
        "    *) COMPREPLY=($(compgen -f -- \"$word\"));;\n"
        "    esac\n"
        "}\n"
        "complete -o filenames -F _wirecut wirecut\n",
        out);
}
