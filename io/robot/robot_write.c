/* The motion of two robots to files: their programs, one table, one JSON object, and an export's figures. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <wirecut/robot_file.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "io/robot/robot_program.h"

static const struct {
    const char *text, *file[3]; /* of two robots, of one */
} known[] = {{"urscript", {"wirecut_a.script", "wirecut_b.script", "wirecut.script"}},
             {"rapid", {"wirecut_a.mod", "wirecut_b.mod", "wirecut.mod"}},
             {"krl", {"wirecut_a.src", "wirecut_b.src", "wirecut.src"}},
             {"csv", {"robot.csv", NULL, "robot.csv"}},
             {"json", {"robot.json", NULL, "robot.json"}}};
enum { FORMATS = sizeof known / sizeof *known, NAME_MAX = 22, IO_MAX = 255 };

wcut_robot_names wcut_robot_names_default(void) {
    return (wcut_robot_names){.program = "wirecut",
                              .wire_on = "wire_on",
                              .wire_off = "wire_off",
                              .wire_heat = "wire_heat",
                              .sync_io = 1,
                              .approach_speed = 50,
                              .approach_acceleration = 1000};
}

const char *wcut_robot_format_name(wcut_robot_format format) {
    return (unsigned)format < FORMATS ? known[format].text : "unknown";
}

const char *wcut_robot_file_name(wcut_robot_format format, int robot) {
    return (unsigned)format < FORMATS && robot >= 0 && robot <= WCUT_ROBOT_SINGLE ? known[format].file[robot] : NULL;
}

/* ---- table ---- */

static void put_fixed(wcut_text *text, const char *before, double value, int decimals) {
    wcut_text_print(text, "%s", before);
    wcut_text_fixed(text, value, decimals);
}

/* the beginning of a target's row: its number, times, and `count` lengths */
static void put_row_begin(wcut_text *text, int i, const wcut_robot_target *t, size_t count, const double *millimetre) {
    wcut_text_print(text, "%d,", i);
    if (t->station >= 0) wcut_text_print(text, "%d", t->station); /* none: a lead */
    put_fixed(text, ",", t->time, 6);
    put_fixed(text, ",", t->duration, 6);
    for (size_t k = 0; k < count; k++) put_fixed(text, ",", millimetre[k], 3);
}

/* the end of a target's row: the heat only where it changes */
static void put_row_end(wcut_text *text, const wcut_robot_target *t) {
    wcut_text_print(text, ",");
    if (t->heat > 0) put_fixed(text, "", t->heat, 3);
    wcut_text_print(text, "\n");
}

/* one robot: its tool's place and turn */
static void put_single_csv(wcut_text *text, const wcut_robot_motion *m) {
    wcut_text_print(
        text,
        "target,station,time_s,duration_s,x_mm,y_mm,z_mm,speed_mm_s,zone_mm,frame_w,frame_x,frame_y,frame_z,"
        "heat_W_per_m\n");
    for (int i = 0; i < m->count; i++) {
        const wcut_robot_target *t = &m->target[i];
        const double millimetre[] = {t->a.x, t->a.y, t->a.z, t->speed_a, t->zone_a};

        /* place, speed and zone, then the turn */
        put_row_begin(text, i, t, sizeof millimetre / sizeof *millimetre, millimetre);
        for (int k = 0; k < 4; k++) put_fixed(text, ",", t->frame_a[k], 9);
        put_row_end(text, t);
    }
}

static void put_csv(wcut_text *text, const wcut_robot_motion *m) {
    if (m->single) {
        put_single_csv(text, m);
        return;
    }
    wcut_text_print(text,
                    "target,station,time_s,duration_s,a_x_mm,a_y_mm,a_z_mm,b_x_mm,b_y_mm,b_z_mm,speed_a_mm_s,"
                    "speed_b_mm_s,zone_a_mm,zone_b_mm,frame_a_w,frame_a_x,frame_a_y,frame_a_z,frame_b_w,frame_b_x,"
                    "frame_b_y,frame_b_z,heat_W_per_m\n");

    /* one row per target; lengths to 1e-3 mm, times to 1e-6 s */
    for (int i = 0; i < m->count; i++) {
        const wcut_robot_target *t = &m->target[i];
        const double millimetre[] = {t->a.x, t->a.y,     t->a.z,     t->b.x,    t->b.y,
                                     t->b.z, t->speed_a, t->speed_b, t->zone_a, t->zone_b};
        put_row_begin(text, i, t, sizeof millimetre / sizeof *millimetre, millimetre);

        /* orientation of both tools as quaternions */
        for (int k = 0; k < 4; k++) put_fixed(text, ",", t->frame_a[k], 9);
        for (int k = 0; k < 4; k++) put_fixed(text, ",", t->frame_b[k], 9);
        put_row_end(text, t);
    }
}

/* ---- JSON ---- */

static void put_robot(wcut_text *text, const char *name, wcut_vec3 at, double speed, double zone, const double q[4]) {
    wcut_text_print(text, ", \"%s\": {\"at_mm\": [", name);
    wcut_text_put_number(text, "", at.x);
    wcut_text_put_number(text, ", ", at.y);
    wcut_text_put_number(text, ", ", at.z);
    wcut_text_put_number(text, "], \"speed_mm_s\": ", speed);
    wcut_text_put_number(text, ", \"zone_mm\": ", zone);
    for (int k = 0; k < 4; k++) wcut_text_put_number(text, k ? ", " : ", \"frame_wxyz\": [", q[k]);
    wcut_text_print(text, "]}");
}

static void put_motion_json(wcut_text *text, const wcut_robot_motion *m, const wcut_robot_names *names) {
    /* head of the file, with its errors */
    wcut_text_print(text, "{\n  \"format\": \"wirecut-robot/1\",\n  \"version\": \"%s\",\n  \"job\": ", WCUT_VERSION);
    wcut_text_string(text, names->title ? names->title : "");
    wcut_text_put_number(text, ",\n  \"duration_s\": ", m->duration);
    wcut_text_put_number(text, ",\n  \"chord_error_mm\": ", m->chord_error);
    wcut_text_put_number(text, ",\n  \"time_error_mm\": ", m->time_error);
    wcut_text_print(text, ",\n  \"stations\": %d,\n  \"targets\": [", m->stations);

    /* targets with the state of both robots */
    for (int i = 0; i < m->count; i++) {
        const wcut_robot_target *t = &m->target[i];
        wcut_text_print(text, "%s\n    {\"station\": ", i ? "," : "");

        /* a target between stations has none */
        if (t->station < 0)
            wcut_text_print(text, "null");
        else
            wcut_text_print(text, "%d", t->station);
        wcut_text_put_number(text, ", \"time_s\": ", t->time);
        wcut_text_put_number(text, ", \"duration_s\": ", t->duration);
        if (t->heat > 0) wcut_text_put_number(text, ", \"heat_W_per_m\": ", t->heat);
        put_robot(text, m->single ? "tool" : "a", t->a, t->speed_a, t->zone_a, t->frame_a);
        if (!m->single) put_robot(text, "b", t->b, t->speed_b, t->zone_b, t->frame_b);
        wcut_text_print(text, "}");
    }
    wcut_text_print(text, "\n  ]\n}\n");
}

/* ---- files ---- */

/* letters, digits and _, beginning with a letter */
static bool is_name(const char *name) {
    const char *letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const size_t length = strlen(name);
    if (length < 1 || length > NAME_MAX || !strchr(letters, *name)) return false;
    return strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == length;
}

/* words of the controllers' languages; RAPID and KRL do not tell capitals apart */
static bool is_reserved(const char *name, wcut_robot_format format) {
    static const char *const urscript[] = {"and",      "break",
                                           "continue", "def",
                                           "elif",     "else",
                                           "end",      "False",
                                           "global",   "halt",
                                           "if",       "in",
                                           "local",    "not",
                                           "or",       "return",
                                           "run",      "sec",
                                           "then",     "thread",
                                           "True",     "while",
                                           "xor",      "movej",
                                           "movel",    "movep",
                                           "movec",    "pose",
                                           "sleep",    "sync",
                                           "kill",     "join",
                                           "None",     "set_digital_out",
                                           "popup",    "stopl",
                                           "stopj",    NULL};
    static const char *const rapid[] = {
        "alias",    "and",       "backward", "bool",     "case",     "clock",       "connect", "const",     "confdata",
        "default",  "div",       "do",       "else",     "elseif",   "endfor",      "endfunc", "endif",     "endmodule",
        "endproc",  "endrecord", "endtest",  "endtrap",  "endwhile", "error",       "exit",    "false",     "for",
        "from",     "func",      "goto",     "if",       "inout",    "jointtarget", "local",   "main",      "mod",
        "module",   "movec",     "movej",    "movel",    "moveabsj", "nostepin",    "not",     "num",       "or",
        "pers",     "pose",      "pos",      "proc",     "raise",    "record",      "return",  "robtarget", "set",
        "setdo",    "speeddata", "step",     "stop",     "string",   "sysmodule",   "task",    "test",      "then",
        "to",       "tooldata",  "trap",     "true",     "trynext",  "undo",        "var",     "viewonly",  "waitdi",
        "waittime", "while",     "with",     "wobjdata", "xor",      "zonedata",    "reset",   "retry",     NULL};
    static const char *const krl[] = {
        "and",       "axis",   "bool",    "brake",     "case",     "char",  "circ",   "confirm", "const",
        "continue",  "decl",   "def",     "deffct",    "default",  "do",    "else",   "end",     "endfct",
        "endfor",    "endif",  "endloop", "endswitch", "endwhile", "enum",  "exit",   "ext",     "extfct",
        "false",     "for",    "frame",   "global",    "goto",     "halt",  "if",     "import",  "int",
        "interrupt", "is",     "lin",     "loop",      "not",      "or",    "pos",    "ptp",     "real",
        "repeat",    "resume", "return",  "signal",    "spline",   "struc", "switch", "then",    "to",
        "trigger",   "true",   "until",   "wait",      "when",     "while", "bas",    "slin",    "scirc",
        "sptp",      "exor",   "b_not",   "b_and",     "b_or",     "e6pos", "e6axis", NULL};

    /* the list of the format; csv and json call nothing */
    const char *const *word = format == WCUT_ROBOT_FORMAT_URSCRIPT ? urscript
                              : format == WCUT_ROBOT_FORMAT_RAPID  ? rapid
                              : format == WCUT_ROBOT_FORMAT_KRL    ? krl
                                                                   : NULL;

    /* RAPID and KRL do not distinguish upper and lower case */
    for (; word && *word; word++)
        if (format == WCUT_ROBOT_FORMAT_URSCRIPT ? strcmp(*word, name) == 0 : strcasecmp(*word, name) == 0) return true;
    return false;
}

static wcut_status motion_is_writable(const wcut_robot_motion *m, const wcut_robot_names *n, wcut_robot_format format,
                                      int robot, const char *path, wcut_error *error) {
    /* motion, file and robot */
    if (!m || !m->target || m->count < 2 || !path || !wcut_robot_file_name(format, robot) ||
        m->single != (robot == WCUT_ROBOT_SINGLE))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a robot program: expected a motion, a file name and a robot that the format has a file for");

    /* names go into programs as they are: letters and digits only */
    const char *const name[] = {n->program ? n->program : "", n->wire_on, n->wire_off, n->wire_heat};
    static const char *const field[] = {"program", "wire_on", "wire_off", "wire_heat"};
    for (int k = 0; k < 4; k++) {
        char quoted[WCUT_QUOTE_SIZE];
        if (name[k] && !is_name(name[k]))
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "%s: found \"%s\", expected a name of letters, digits and _, beginning with a letter, at "
                             "most %d long",
                             field[k], wcut_quote(quoted, name[k], WCUT_FOUND_MAX, 0), NAME_MAX);
        if (name[k] && is_reserved(name[k], format))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: found \"%s\", a word of %s itself, expected another name",
                             field[k], name[k], wcut_robot_format_name(format));
    }

    /* outputs that the controller has: eight of Universal Robots, $OUT[0] is none of KUKA */
    const int low = format == WCUT_ROBOT_FORMAT_KRL ? 1 : 0, high = format == WCUT_ROBOT_FORMAT_URSCRIPT ? 7 : IO_MAX;
    if (n->sync_io < low || n->sync_io > high)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "sync_io: found %d, expected %d to %d for %s", n->sync_io, low, high,
                         wcut_robot_format_name(format));

    /* settings of the cell are positive or none */
    if (!(n->approach_speed > 0 && n->approach_speed < 1e6) ||
        !(n->approach_acceleration > 0 && n->approach_acceleration < 1e6) || !(n->preheat >= 0 && n->preheat < 1e6) ||
        !(n->heat >= 0 && n->heat < 1e9) || !(n->tension >= 0 && n->tension < 1e9) ||
        !(n->wire_length >= 0 && n->wire_length < 1e9))
        return wcut_fail(
            error, WCUT_BAD_ARGUMENT,
            "a positive speed and acceleration of the approach, a preheat, heat, tension and wire length of "
            "0 or more are expected");

    /* places and times fit into the digits of the formats */
    for (int i = 0; i < m->count; i++) {
        const wcut_robot_target *t = &m->target[i];
        const double value[] = {t->a.x,     t->a.y,     t->a.z,    t->b.x,    t->b.y,      t->b.z, t->time,
                                t->speed_a, t->speed_b, t->zone_a, t->zone_b, t->duration, t->heat};
        if (t->heat > 0 && !n->wire_heat)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "the heater changes its power at target %d, expected a procedure to call", i);
        for (size_t k = 0; k < sizeof value / sizeof *value; k++)
            if (!(fabs(value[k]) < 1e9)) /* also what fixed decimals hold */
                return wcut_fail(error, WCUT_BAD_ARGUMENT, "target %d: found %g, expected less than 1e9", i, value[k]);
    }

    return WCUT_OK;
}

/* what one robot is to do, in a dialect */
typedef struct program {
    const wcut_robot_motion *motion;
    const wcut_robot_names *names;
    wcut_robot_format format;
    int robot;
} program;

static bool put_program(wcut_text *text, const void *context) {
    const program *p = context;

    /* a writer for each format */
    switch (p->format) {
        case WCUT_ROBOT_FORMAT_URSCRIPT:
            wcut_urscript_put(text, p->motion, p->names, p->robot);
            break;
        case WCUT_ROBOT_FORMAT_RAPID:
            wcut_rapid_put(text, p->motion, p->names, p->robot);
            break;
        case WCUT_ROBOT_FORMAT_KRL:
            wcut_krl_put(text, p->motion, p->names, p->robot);
            break;
        case WCUT_ROBOT_FORMAT_CSV:
            put_csv(text, p->motion);
            break;
        case WCUT_ROBOT_FORMAT_JSON:
            put_motion_json(text, p->motion, p->names);
            break;
    }

    return true;
}

wcut_status wcut_robot_write(const wcut_robot_motion *motion, const wcut_robot_names *names, wcut_robot_format format,
                             int robot, const char *path, wcut_error *error) {
    const wcut_robot_names n = names ? *names : wcut_robot_names_default();
    const wcut_status status = motion_is_writable(motion, &n, format, robot, path, error);
    if (status != WCUT_OK) return status;
    const program whole = {motion, &n, format, robot};
    return wcut_text_write_file(path, put_program, &whole, error);
}

/* ---- figures ---- */

wcut_status wcut_robot_summary_print(const wcut_robot_summary *s, char **text) {
    if (!s || !s->job || !s->motion || !s->check || !s->near || (unsigned)s->format >= FORMATS || !text)
        return WCUT_BAD_ARGUMENT;

    /* a text that grows */
    wcut_text out;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    const wcut_robot_motion *m = s->motion;

    /* the motion and its errors */
    wcut_text_print(&out, "{\n  \"format\": \"wirecut-path/1\",\n  \"version\": \"%s\",\n  \"job\": ", WCUT_VERSION);
    wcut_text_string(&out, s->job->name);
    wcut_text_print(&out, ",\n  \"program\": \"%s\",\n  \"stations\": %d,\n  \"targets\": %d",
                    wcut_robot_format_name(s->format), m->stations, m->count);
    int changes = 0;
    for (int i = 0; i < m->count; i++) changes += m->target[i].heat > 0;
    wcut_text_print(&out, ",\n  \"sines\": %d,\n  \"heater_changes\": %d", s->job->dither_count, changes);
    wcut_text_put_number(&out, ",\n  \"duration_s\": ", m->duration);
    wcut_text_put_number(&out, ",\n  \"chord_error_mm\": ", m->chord_error);
    wcut_text_put_number(&out, ",\n  \"time_error_mm\": ", m->time_error);

    /* the limits and how near the motion comes to each */
    wcut_text_print(&out, ",\n  \"limits\": [");
    for (int i = 0; i < WCUT_ROBOT_CHECKS; i++) {
        const wcut_robot_check *c = &s->check[i];
        wcut_text_print(&out, "%s\n    {\"what\": \"%s\", \"unit\": \"%s\"", i ? "," : "", c->name, c->unit);
        wcut_text_put_number(&out, ", \"value\": ", c->value);
        wcut_text_put_number(&out, ", \"limit\": ", c->limit);
        if (c->station >= 0) wcut_text_print(&out, ", \"station\": %d", c->station);
        wcut_text_print(&out, ", \"over\": %s}", c->over ? "true" : "false");
    }

    /* the distance of each mount from the block */
    wcut_text_print(&out, "\n  ],\n  \"clearance\": [");
    for (int i = 0; i < 2; i++) {
        const wcut_path_near *n = &s->near[i];
        wcut_text_print(&out, "%s\n    {\"mount\": \"%s\"", i ? "," : "", i ? "B" : "A");
        wcut_text_put_number(&out, ", \"least_mm\": ", n->distance);
        wcut_text_put_number(&out, ", \"station\": ", n->station);
        wcut_text_put_number(&out, ", \"at_mm\": [", n->place.x);
        wcut_text_put_number(&out, ", ", n->place.y);
        wcut_text_put_number(&out, ", ", n->place.z);
        wcut_text_print(&out, "]}");
    }

    /* the object is closed */
    wcut_text_print(&out, "\n  ]\n}\n");

    return wcut_text_finish(&out, text, NULL);
}
