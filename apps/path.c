/* wirecut path: a job to the programs of two synchronised robots, held against the limits of cell and wire. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "job.h"
#include "results.h"
#include "terminal.h"

/* How exactly the least distance of a mount's path to the block is found. */
#define CLEARANCE_MM 1e-3
/* How far along its way a mount may be off where the speed is dithered: 5 % of 20 mm/s over 3 s are 0.5 mm. */
#define EXCITED_MM 0.005

typedef struct export_ {
    const app_call *call;
    const char *path; /* of the job */
    wcut_job *job;
    wcut_setup *setup;
    wcut_history *history;
    wcut_vec3 *mount_a, *mount_b; /* one block */
    double length;                /* [mm] of the wire from mount to mount */
    wcut_robot_motion *motion;
    wcut_robot_check check[WCUT_ROBOT_CHECKS];
    wcut_path_near near[2]; /* the mounts' paths and the block */
    wcut_robot_format format;
    app_results results;
} export_;

static int load_export(export_ *e) {
    wcut_error error = {0};
    const int code = app_job_load(e->call, e->path, &e->job);
    if (code != APP_DONE) return code;

    e->format = (wcut_robot_format)app_choice(e->call, "format");
    const wcut_status status = wcut_setup_create(e->job, NULL, &e->setup, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, e->path, &error);
}

/* a cut that does not reach its end is no program */
static int run_export(export_ *e) {
    wcut_error error = {0};
    app_progress progress = app_progress_begin(app_given(e->call, "quiet"));
    wcut_status status = wcut_setup_run(e->setup, app_progress_step, &progress, &e->history, &error);
    app_progress_end(&progress);
    if (status != WCUT_OK) return app_fail_status(status, e->path, &error);
    const size_t stations = (size_t)e->history->stations;
    e->mount_a = calloc(2 * stations, sizeof *e->mount_a);
    if (!e->mount_a) return app_fail_status(WCUT_NO_MEMORY, e->path, NULL);
    e->mount_b = e->mount_a + stations;
    status = wcut_history_path(e->setup, e->history, e->mount_a, e->mount_b, &e->length, &error);
    if (status == WCUT_OK) status = wcut_history_excite(e->job, e->history, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, e->path, &error);
}

/* A program must not end with the hot wire in the foam: only a lead-out that clears the block can take it out. */
static int check_end(const export_ *e) {
    const wcut_history_row *last = &e->history->row[e->history->stations - 1];
    const double asked = app_real(e->call, "lead-out");
    if (!(last->engaged_length > 0) || asked < 0 || asked >= e->motion->lead_out) return APP_DONE;
    return app_fail(
        APP_BAD_INPUT,
        "%s: station %d, the last: %.4g mm of the wire are in the foam, a lead-out of %.4g mm would clear the "
        "block; expected a path that goes on until the wire has left the block, or --lead-out clear",
        e->path, e->history->stations - 1, last->engaged_length, e->motion->lead_out);
}

/* How near the mounts' ways come to the block, between the stations too, with their leads. */
static int approach(export_ *e) {
    const wcut_box block = {{0, 0, 0}, e->job->block_size};
    const wcut_robot_motion *m = e->motion;
    const int in = m->target[0].station == -1, out = m->target[m->count - 1].station == -2;
    const int stations = e->history->stations, count = in + stations + out;
    wcut_vec3 *way = calloc((size_t)count, sizeof *way);
    wcut_status status = way ? WCUT_OK : WCUT_NO_MEMORY;
    for (int k = 0; k < 2 && status == WCUT_OK; k++) {
        if (in) way[0] = k ? m->target[0].b : m->target[0].a;
        memcpy(way + in, k ? e->mount_b : e->mount_a, (size_t)stations * sizeof *way);
        if (out) way[count - 1] = k ? m->target[m->count - 1].b : m->target[m->count - 1].a;
        status = wcut_path_clearance(count, way, &block, CLEARANCE_MM, &e->near[k]);
        e->near[k].station -= in; /* a lead-in lies before station 0 */
    }
    free(way);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, e->path, NULL);
}

static void choose(const app_call *call, const char *option, double unit, double *to) {
    if (app_given(call, option)) *to = app_real(call, option) * unit;
}

static int make_motion(export_ *e) {
    wcut_error error = {0};
    wcut_robot_options o = wcut_robot_options_default();
    choose(e->call, "chord-tolerance", 1, &o.chord_tolerance);
    choose(e->call, "time-tolerance", 1, &o.time_tolerance);
    choose(e->call, "lead-in", 1, &o.lead_in);
    choose(e->call, "lead-out", 1, &o.lead_out);

    /* the word is -1; a path that ends in the foam must be led out of it */
    const bool inside = e->history->row[e->history->stations - 1].engaged_length > 0;
    if (o.lead_out < 0 || inside) o.clear = e->job;
    if (o.lead_out < 0) o.lead_out = 0;
    choose(e->call, "zone", 1, &o.zone);
    o.heater = e->job;
    if (e->job->rig.kind != WCUT_RIG_KIND_TWO_ARMS) o.tool = e->job;

    /* a dither is small: thinned as usual it would be gone */
    if (e->job->dither_count > 0 && o.time_tolerance > EXCITED_MM) o.time_tolerance = EXCITED_MM;
    o.frame = app_choice(e->call, "tool-frame") == 1 ? WCUT_TOOL_FRAME_FOLLOWING : WCUT_TOOL_FRAME_FIXED;
    wcut_status status = wcut_robot_motion_create(e->history, e->mount_a, e->mount_b, &o, &e->motion, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, e->path, &error);
}

static wcut_robot_limits limits_of(const export_ *e) {
    wcut_robot_limits l = wcut_robot_limits_default(e->job);
    choose(e->call, "speed", 1, &l.speed);
    choose(e->call, "acceleration", 1, &l.acceleration);
    choose(e->call, "alpha", WCUT_RAD_PER_DEG, &l.alpha);
    choose(e->call, "beta", WCUT_RAD_PER_DEG, &l.beta);
    return l;
}

static int check_limits(export_ *e) {
    const wcut_robot_limits l = limits_of(e);
    wcut_status status = wcut_robot_limits_check(e->job, e->history, e->mount_a, e->mount_b, &l, e->check);
    if (status != WCUT_OK)
        return app_fail(app_exit_code(status), "%s: limits: the wire exceeds 3000 degC, expected less", e->path);
    int over = 0;
    for (int i = 0; i < WCUT_ROBOT_CHECKS; i++) over += e->check[i].over;
    if (over == 0 || !app_given(e->call, "strict")) return APP_DONE;
    for (int i = 0; i < WCUT_ROBOT_CHECKS; i++)
        if (e->check[i].over)
            return app_fail(APP_OUTSIDE,
                            "%s: %s: %.4g %s, limit %.4g %s; %d of %d limits are exceeded, nothing was written",
                            e->path, e->check[i].name, e->check[i].value, e->check[i].unit, e->check[i].limit,
                            e->check[i].unit, over, WCUT_ROBOT_CHECKS);
    return APP_DONE;
}

/* the files of a format, path.json, and the NULL that closes the list */
static void name_programs(wcut_robot_format format, bool single, const char *name[4]) {
    int count = 0;
    for (int robot = 0; robot < (single ? 1 : 2); robot++) {
        name[count] = wcut_robot_file_name(format, single ? WCUT_ROBOT_SINGLE : robot);
        count += name[count] != NULL;
    }
    name[count] = "path.json";
    name[count + 1] = NULL;
}

/* a procedure's name: as given, none, or the default */
static const char *hook(const app_call *call, const char *option, const char *otherwise) {
    if (!app_given(call, option)) return otherwise;
    return strcmp(app_text(call, option), "none") == 0 ? NULL : app_text(call, option);
}

/* a refusal that begins with the field of a struct begins with the option that fills it: "wire_on: ", "--wire-on: " */
static int refuse_field(const app_call *call, const char *text) {
    char option[40] = "";
    const size_t n = strcspn(text, ":");
    for (size_t k = 0; k < n && n < sizeof option; k++) option[k] = (char)(text[k] == '_' ? '-' : text[k]);
    if (option[0] && app_has(call, option)) return app_fail(APP_USAGE, "path: --%s%s", option, text + n);
    return app_fail(APP_USAGE, "path: %s", text);
}

static int write_programs(export_ *e) {
    /* names in the programs */
    wcut_error error = {0};
    wcut_robot_names names = wcut_robot_names_default();
    names.title = e->job->name;
    names.sync_io = app_int(e->call, "sync-io");
    names.wire_on = hook(e->call, "wire-on", names.wire_on);
    names.wire_off = hook(e->call, "wire-off", names.wire_off);
    names.wire_heat = hook(e->call, "wire-heat", names.wire_heat);

    /* what the moves keep that have no time of their own, and what the cell sets */
    const wcut_robot_limits l = limits_of(e);
    if (names.approach_speed > l.speed) names.approach_speed = l.speed;
    names.approach_acceleration = l.acceleration;
    names.preheat = app_real(e->call, "preheat");
    names.heat = e->job->heat;
    names.tension = e->job->rig.kind == WCUT_RIG_KIND_BOW ? e->job->rig.pretension : e->job->tension;
    if (e->job->rig.kind == WCUT_RIG_KIND_TWO_ARMS) names.wire_length = e->length; /* else the rig sets it */

    /* a file for each robot, or one for both or for the only one */
    int code = APP_DONE;
    const bool single = e->motion->single;
    for (int k = 0; k < (single ? 1 : 2) && code == APP_DONE; k++) {
        const int robot = single ? WCUT_ROBOT_SINGLE : k;
        const char *name = wcut_robot_file_name(e->format, robot);
        if (!name) continue;
        wcut_status status =
            wcut_robot_write(e->motion, &names, e->format, robot, app_results_path(&e->results, name), &error);
        if (status == WCUT_BAD_ARGUMENT) return refuse_field(e->call, error.text);
        code = app_results_add(&e->results, name, status, &error);
    }

    return code;
}

/* both programs, under path.json */
static int write_path_results(export_ *e) {
    const int code = write_programs(e);
    if (code != APP_DONE) return code;
    char *text = NULL;
    const wcut_robot_summary summary = {
        .job = e->job, .motion = e->motion, .check = e->check, .near = e->near, .format = e->format};
    const wcut_status status = wcut_robot_summary_print(&summary, &text);
    return app_results_commit(&e->results, "path.json", status, text);
}

static void say_motion(const export_ *e) {
    const wcut_robot_motion *m = e->motion;

    /* the motion and how far it is from the path */
    app_say("%s: %d targets of %d stations, %.1f s; error across the path at most %.2g mm, along it %.2g mm",
            e->job->name, m->count, m->stations, m->duration, m->chord_error, m->time_error);

    /* an excitation is partly in the speeds, partly in calls */
    if (e->job->dither_count + e->job->heat_step_count > 0)
        app_say(
            "excitation: %d sines on the speed are in the programs, %d heater steps call a procedure; time 0 of the "
            "recording is station 0",
            e->job->dither_count, e->job->heat_step_count);

    /* the place where each mount comes nearest to the block */
    for (int k = 0; k < 2; k++) {
        const wcut_path_near *n = &e->near[k];
        const char *mount = k ? "B" : "A";
        if (n->distance > 0)
            app_say("mount %s: least distance from the block %.4g mm, at station %.4g, (%.4g, %.4g, %.4g) mm", mount,
                    n->distance, n->station, n->place.x, n->place.y, n->place.z);
        else
            app_say("warning: mount %s touches the block at station %.4g, (%.4g, %.4g, %.4g) mm", mount, n->station,
                    n->place.x, n->place.y, n->place.z);
        if (n->distance > 0 && n->distance < e->job->clearance - CLEARANCE_MM)
            app_say(
                "warning: mount %s comes within %.4g mm of the block, %.2g mm less than the job's clearance of %.4g mm",
                mount, n->distance, e->job->clearance - n->distance, e->job->clearance);
    }

    /* limits of the cell that the motion is over */
    for (int i = 0; i < WCUT_ROBOT_CHECKS; i++) {
        const wcut_robot_check *c = &e->check[i];
        if (!c->over) continue;
        if (c->station >= 0)
            app_say("warning: %s: %.4g %s at station %d, limit %.4g %s", c->name, c->value, c->unit, c->station,
                    c->limit, c->unit);
        else
            app_say("warning: %s: %.4g %s, limit %.4g %s", c->name, c->value, c->unit, c->limit, c->unit);
    }

    app_say("in %s: %s", e->results.folder, app_results_list(&e->results));
}

static int path(const app_call *call) {
    /* load, then simulate */
    export_ e = {.call = call, .path = call->operand[0]};
    const char *name[4];
    int code = load_export(&e);
    name_programs(e.format, code == APP_DONE && e.job->rig.kind != WCUT_RIG_KIND_TWO_ARMS, name);
    if (code == APP_DONE) app_catch_interrupts();
    if (code == APP_DONE) code = run_export(&e);

    /* motion and limits */
    if (code == APP_DONE) code = make_motion(&e);
    if (code == APP_DONE) code = check_end(&e);
    if (code == APP_DONE) code = approach(&e);
    if (code == APP_DONE) code = check_limits(&e);

    /* write only what may be run */
    if (code == APP_DONE) code = app_results_begin(&e.results, app_text(call, "output"), name);
    if (code == APP_DONE) code = write_path_results(&e);
    if (code == APP_DONE && !app_given(call, "quiet")) say_motion(&e);
    if (code == APP_DONE && app_given(call, "json")) fputs(e.results.text, stdout);

    app_results_end(&e.results);

    wcut_robot_motion_destroy(e.motion);
    free(e.mount_a); /* and mount_b, which lies behind it */
    wcut_history_destroy(e.history);
    wcut_setup_destroy(e.setup);
    wcut_job_destroy(e.job);
    return code;
}

/* ---- the table ---- */

/* defaults of the library */
static double path_chord_tolerance(void) { return wcut_robot_options_default().chord_tolerance; }
static double path_time_tolerance(void) { return wcut_robot_options_default().time_tolerance; }
static double path_lead_in(void) { return wcut_robot_options_default().lead_in; }
static double path_lead_out(void) { return wcut_robot_options_default().lead_out; }
static double path_zone(void) { return wcut_robot_options_default().zone; }
static double path_sync_io(void) { return wcut_robot_names_default().sync_io; }
static double path_preheat(void) { return wcut_robot_names_default().preheat; }
static double path_frame(void) { return wcut_robot_options_default().frame; }
static const char *path_wire_on_text(void) { return wcut_robot_names_default().wire_on; }
static const char *path_wire_off_text(void) { return wcut_robot_names_default().wire_off; }
static const char *path_wire_heat_text(void) { return wcut_robot_names_default().wire_heat; }
static double path_acceleration(void) { return wcut_robot_limits_default(&(wcut_job){0}).acceleration; }
static double path_alpha(void) { return wcut_robot_limits_default(&(wcut_job){0}).alpha * WCUT_DEG_PER_RAD; }
static double path_beta(void) { return wcut_robot_limits_default(&(wcut_job){0}).beta * WCUT_DEG_PER_RAD; }

static const app_operand operand[] = {
    {.name = "JOB", .kind = APP_FILE, .help = "a job file, wirecut-job/1"},
    {.name = NULL},
};

static const app_option option[] = {
    {.kind = APP_FOLDER,
     .name = "output",
     .letter = 'o',
     .value = "DIR",
     .standard = ".",
     .help = "folder for the programs; it is created if missing"},
    {.kind = APP_CHOICE,
     .name = "format",
     .required = true,
     .value = "urscript|rapid|krl|csv|json",
     .help = "two programs for Universal Robots, ABB MultiMove or KUKA; one table; one JSON object"},
    APP_OPTION_EDGES,
    {.kind = APP_REAL,
     .name = "chord-tolerance",
     .value = "MM",
     .low = 1e-4,
     .high = 1e3,
     .library = path_chord_tolerance,
     .help = "largest distance between triangles and surface, or of a mount from its path, mm"},
    {.kind = APP_REAL,
     .name = "time-tolerance",
     .value = "MM",
     .low = 1e-4,
     .high = 1e3,
     .library = path_time_tolerance,
     .help = "largest error of a mount along its path at any time, mm"},
    {.kind = APP_REAL,
     .name = "lead-in",
     .value = "MM",
     .low = 0,
     .high = 1e4,
     .library = path_lead_in,
     .help = "length of a straight lead-in before the path, against the feed, mm"},
    {.kind = APP_REAL,
     .name = "lead-out",
     .value = "MM|clear",
     .word = "clear",
     .low = 0,
     .high = 1e4,
     .library = path_lead_out,
     .help = "length of a straight lead-out after the path, mm; clear: until the wire is 1 mm out of the block"},
    {.kind = APP_REAL,
     .name = "preheat",
     .value = "S",
     .low = 0,
     .high = 3600,
     .library = path_preheat,
     .help = "time that the wire is heated for at the first target before both robots start, s"},
    {.kind = APP_REAL,
     .name = "zone",
     .value = "MM",
     .low = 0,
     .high = 1e3,
     .library = path_zone,
     .help = "blend radius at a target, mm, limited to 2/5 of the shorter adjacent move"},
    {.kind = APP_CHOICE,
     .name = "tool-frame",
     .value = "fixed|following",
     .library = path_frame,
     .help = "orientation of the tool. fixed: along x, the Cardan head takes up the angles; following: along the wire, "
             "by the simulated angles"},
    {.kind = APP_TEXT,
     .name = "wire-on",
     .value = "NAME",
     .library_text = path_wire_on_text,
     .help = "procedure that robot A calls at its first target"},
    {.kind = APP_TEXT,
     .name = "wire-off",
     .value = "NAME",
     .library_text = path_wire_off_text,
     .help = "procedure that robot A calls after its last target"},
    {.kind = APP_TEXT,
     .name = "wire-heat",
     .value = "NAME",
     .library_text = path_wire_heat_text,
     .help = "procedure that robot A calls with a power in W/m at each heater step of an excitation"},
    {.kind = APP_INT,
     .name = "sync-io",
     .value = "N",
     .low = 0,
     .high = 255,
     .library = path_sync_io,
     .help = "digital output of each robot that is wired to the same input of the other (urscript, krl)"},
    {.kind = APP_REAL,
     .name = "speed",
     .value = "V",
     .low = 1e-3,
     .high = 1e5,
     .help = "largest speed of a mount, mm/s; default the job's speed_max"},
    {.kind = APP_REAL,
     .name = "acceleration",
     .value = "A",
     .low = 1e-3,
     .high = 1e6,
     .library = path_acceleration,
     .help = "largest acceleration of a mount, mm/s^2"},
    {.kind = APP_REAL,
     .name = "alpha",
     .value = "DEG",
     .low = 0.1,
     .high = 90,
     .library = path_alpha,
     .help = "largest alpha of the head, deg"},
    {.kind = APP_REAL,
     .name = "beta",
     .value = "DEG",
     .low = 0.1,
     .high = 90,
     .library = path_beta,
     .help = "largest beta of the head, deg"},
    APP_OPTIONS_STRENGTH,
    {.kind = APP_FLAG,
     .name = "strict",
     .help = "treat an exceeded limit as an error: nothing is written, the exit code is 5"},
    APP_OPTION_FORCE_LAW,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_path = {
    .name = "path",
    .brief = "write the programs of two synchronised robots, or of the one of a bow or blade, for a job",
    .about =
        "Simulates the job and writes the motion of both mounts as programs for two robots that reach every target "
        "together. Stations are left out as long as the error stays within a tolerance across the path and one along "
        "it.\nurscript and krl: wirecut_a.* and wirecut_b.*, started together by a digital output of each robot that "
        "is wired to an input of the other; after that each keeps the time or the speed of its moves. rapid: two "
        "modules for MultiMove, moves with the same ID end together. csv: robot.csv; json: robot.json. A bow or a "
        "blade is led by one robot: one program, wirecut.*, with the poses of its tool.\nAn "
        "identification cut (wirecut identify): its sines are in the speeds, and robot A calls a procedure with a "
        "power "
        "at every heater step. Time 0 of the recording is station 0.\nMount speeds "
        "and accelerations, the angles of the Cardan head, and the wire's temperature in still air and its stress are "
        "compared with limits; exceeded limits are reported.",
    .operand = operand,
    .option = option,
    .run = path,
};
