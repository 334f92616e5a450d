/* wirecut mould: a job file to the two halves of its block, as triangles and exact faces. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "job.h"
#include "results.h"
#include "terminal.h"

/* Sections nearer than a job's own rounding of its coordinates are one section. */
#define MERGE_MM 1e-3
#define FORMATS_KNOWN "stl,obj,ply,3mf,step"

enum {
    RESULT_NAME_SIZE = 64,
    LABEL_MAX = 40,
    FORMATS = 5,
    STEP = 4,
    PART_FILES = 3 * FORMATS, /* of lower, upper, frame */
    PAIR = PART_FILES,
    CUT,
    NAMES
};

enum { KEYS_NONE, KEYS_POCKETS, KEYS_CONES, KEYS_LUGS };

static const char *const format[FORMATS] = {"stl", "obj", "ply", "3mf", "step"};
static const char *const part_name[3] = {"lower", "upper", "frame"};
static const wcut_mould_part part_of[3] = {WCUT_MOULD_PART_LOWER, WCUT_MOULD_PART_UPPER, WCUT_MOULD_PART_FRAME};

typedef struct moulding {
    const app_call *call;
    const char *path; /* of the job */
    wcut_job *job;
    wcut_setup *setup;
    wcut_history *history;
    wcut_surface *surface;
    double *parameter, *kerf; /* of the stations, of the nodes */
    wcut_mesh *stock;
    wcut_vec3 pull;
    wcut_mould *mould;
    char name[NAMES][RESULT_NAME_SIZE]; /* lower.stl .. lower.step, upper.stl .., frame.stl .., mould.3mf, cut.igs,
                                                      with the label */
    const char *title;                  /* what CAD programs show before the name of a part */
    const char *result[NAMES + 3];      /* all that a run may write, and the NULL that closes the list */
    app_results results;
} moulding;

/* ---- names ---- */

static int name_mould_files(moulding *m) {
    /* letters that are safe in every file name */
    static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
    const char *label = app_given(m->call, "label") ? app_text(m->call, "label") : NULL;
    if (label && (!label[0] || strlen(label) > LABEL_MAX || label[0] == '.' || label[strspn(label, letters)]))
        return app_fail(APP_USAGE,
                        "--label: expected 1 to %d letters, digits, dots, dashes or underscores, not a dot first",
                        LABEL_MAX);

    /* the names of both halves and the frame in each format */
    const char *before = label ? label : "", *dash = label ? "-" : "";
    for (int k = 0; k < PART_FILES; k++)
        snprintf(m->name[k], RESULT_NAME_SIZE, "%s%s%s.%s", before, dash, part_name[k / FORMATS], format[k % FORMATS]);
    m->title = label ? label : m->job->name;

    /* files of both halves together */
    snprintf(m->name[PAIR], RESULT_NAME_SIZE, "%s%smould.3mf", before, dash);
    snprintf(m->name[CUT], RESULT_NAME_SIZE, "%s%scut.igs", before, dash);

    /* report and summary come last */
    for (int k = 0; k < NAMES; k++) m->result[k] = m->name[k];
    m->result[NAMES] = "report.html";
    m->result[NAMES + 1] = "mould.json";

    return APP_DONE;
}

/* ---- the cut ---- */

static int load_moulding(moulding *m) {
    wcut_error error = {0};
    const int code = app_job_load(m->call, m->path, &m->job);
    if (code != APP_DONE) return code;

    /* the stock that the mould is cut from */
    if (app_given(m->call, "stock")) {
        const char *path = app_text(m->call, "stock");
        wcut_mesh_read_options options = wcut_mesh_read_options_default();
        options.unit = (wcut_length_unit)app_choice(m->call, "stock-unit");
        const wcut_status status = wcut_mesh_read(path, &options, &m->stock, NULL, &error);
        if (status != WCUT_OK) return app_fail_status(status, error.text[0] ? NULL : path, &error);
    }

    const wcut_status status = wcut_setup_create(m->job, NULL, &m->setup, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, m->path, &error);
}

/* a block is divided by a whole cut, or not at all */
static int run_moulding(moulding *m) {
    wcut_error error = {0};
    app_progress progress = app_progress_begin(app_given(m->call, "quiet"));
    const wcut_status status = wcut_setup_run(m->setup, app_progress_step, &progress, &m->history, &error);
    app_progress_end(&progress);
    if (status == WCUT_INTERRUPTED) return app_fail(APP_INTERRUPTED, "%s: interrupted", m->path);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, m->path, &error);
}

static int loft(moulding *m) {
    const wcut_history *h = m->history;
    m->parameter = calloc((size_t)h->stations, sizeof *m->parameter);
    m->kerf = calloc((size_t)h->stations * (size_t)h->nodes, sizeof *m->kerf);
    wcut_status status = m->parameter && m->kerf ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK)
        status = wcut_surface_loft(h->stations, h->nodes, h->position, MERGE_MM, &m->surface, m->parameter, NULL);
    if (status == WCUT_OK) status = wcut_history_kerf(m->job, h, m->kerf);
    if (status == WCUT_OK) return APP_DONE;
    return app_fail(app_exit_code(status), "%s: lofting the surface: %s", m->path, wcut_status_text(status));
}

/* "0,0,1" */
static int read_pull(const char *text, wcut_vec3 *pull) {
    double number[3];
    const char *at = text;
    for (int k = 0; k < 3; k++) {
        char *end = NULL;
        number[k] = at && strspn(at, "+-.0123456789eE") ? strtod(at, &end) : NAN;
        const bool goes_on = end && isfinite(number[k]) && fabs(number[k]) <= 1e6 && *end == (k < 2 ? ',' : '\0');
        at = goes_on ? end + 1 : NULL;
    }
    if (!at || !(hypot(hypot(number[0], number[1]), number[2]) > 1e-6))
        return app_fail(APP_USAGE, "--pull: found \"%s\", expected a direction of three numbers as 0,0.2,1", text);
    *pull = (wcut_vec3){number[0], number[1], number[2]};
    return APP_DONE;
}

static int divide(moulding *m) {
    /* tolerances, draft and kerf of the mould */
    wcut_error error = {0};
    wcut_key key[WCUT_KEYS_AT_CORNERS];
    wcut_mould_options o = wcut_mould_default();
    o.pull = m->pull;
    const int keys = app_choice(m->call, "keys");
    o.chord_tolerance = app_real(m->call, "chord-tolerance");
    o.fit_tolerance = app_real(m->call, "fit-tolerance");
    o.prolong = app_real(m->call, "prolong");
    o.kerf_stations = m->history->stations, o.kerf_nodes = m->history->nodes;
    o.kerf_parameter = m->parameter, o.kerf_field = m->kerf;
    o.scale = app_real(m->call, "scale");
    o.wire_diameter = m->job->wire_diameter;
    o.wall_asked = app_real(m->call, "minimum-wall");
    if (app_given(m->call, "minimum-draft")) o.draft_asked = app_real(m->call, "minimum-draft") * WCUT_RAD_PER_DEG;
    o.stock = m->stock;

    /* what holds the halves over each other, and what is between them */
    o.thickness = app_real(m->call, "thickness");
    o.frame_wall = app_real(m->call, "frame");
    o.frame_clearance = app_real(m->call, "frame-clearance");
    if (keys == KEYS_LUGS) {
        o.lug_radius = app_real(m->call, "key-radius");
        o.lug_height = app_real(m->call, "key-height");
        o.lug_clearance = app_real(m->call, "key-clearance");
    }

    /* keys at the corners: pins stand out, sockets go in */
    if (keys == KEYS_POCKETS || keys == KEYS_CONES) {
        const double height = app_real(m->call, "key-height");
        const wcut_status status = wcut_keys_at_corners(m->job->block_size, app_real(m->call, "key-radius"),
                                                        keys == KEYS_POCKETS ? -height : height, key);
        if (status != WCUT_OK)
            return app_fail(APP_USAGE,
                            "--key-height: a key of that radius is lower, because its flanks meet in a point");
        o.key = key, o.key_count = WCUT_KEYS_AT_CORNERS;
    }

    /* divide the block */
    const wcut_status status = wcut_mould_create(m->surface, m->job->block_size, &o, &m->mould, &error);

    return status == WCUT_OK ? APP_DONE : app_fail_status(status, m->path, &error);
}

/* ---- the files ---- */

static const wcut_mesh *part_mesh(const moulding *m, int part) {
    return part == 2 ? m->mould->frame : part ? m->mould->upper.mesh : m->mould->lower.mesh;
}

static wcut_status write_mould_part(const moulding *m, int part, int f, const char *path, wcut_error *error) {
    const wcut_mesh *mesh = part_mesh(m, part);
    switch (f) {
        case 0:
            return wcut_mesh_write_stl(mesh, path, error);
        case 1:
            return wcut_mesh_write_obj(mesh, path, error);
        case 2:
            return wcut_mesh_write_ply(mesh, NULL, path, error);
        case 3:
            return wcut_mould_write_3mf(m->mould, m->title, part_of[part], app_choice(m->call, "layout"), path, error);
        default:
            return wcut_mould_write_step(m->mould, m->title, part_of[part],
                                         (wcut_step_schema)app_choice(m->call, "step-schema"), path, error);
    }
}

/* both halves and the frame, then all of them in one 3MF, with the casting where it is assembled */
static int write_halves(moulding *m) {
    wcut_error error = {0};
    for (int k = 0; k < PART_FILES; k++) {
        const int part = k / FORMATS, f = k % FORMATS;
        if (!app_wants_format(m->call, format[f]) || !part_mesh(m, part)) continue;
        if (f == STEP && part < 2 && m->mould->by_boolean) continue; /* triangles alone: there are no exact faces */
        const wcut_status status = write_mould_part(m, part, f, app_results_path(&m->results, m->name[k]), &error);
        const int code = app_results_add(&m->results, m->name[k], status, &error);
        if (code != APP_DONE) return code;
    }
    if (!app_wants_format(m->call, "3mf")) return APP_DONE;
    const int for_print = app_choice(m->call, "layout");
    unsigned parts = WCUT_MOULD_PART_LOWER | WCUT_MOULD_PART_UPPER;
    if (m->mould->frame) parts |= WCUT_MOULD_PART_FRAME;
    if (m->mould->thickness > 0 && !for_print) parts |= WCUT_MOULD_PART_CASTING;
    const wcut_status status = wcut_mould_write_3mf(m->mould, m->title, parts, for_print,
                                                    app_results_path(&m->results, m->name[PAIR]), &error);
    return app_results_add(&m->results, m->name[PAIR], status, &error);
}

/* the cut faces alone, exactly: one where there is no kerf */
static int write_cut(moulding *m) {
    wcut_error error = {0};
    wcut_shape shape[2] = {{.name = "cut face of the lower half"}, {.name = "cut face of the upper half"}};
    if (!app_given(m->call, "iges") || m->mould->by_boolean) return APP_DONE;
    for (int upper = 0; upper < 2; upper++) {
        const wcut_brep *brep = upper ? m->mould->upper.brep : m->mould->lower.brep;
        for (int f = 0; f < brep->face_count; f++)
            if (brep->face[f].part == WCUT_BREP_PART_CUT) shape[upper].surface = brep->face[f].surface;
    }
    const wcut_status status =
        wcut_iges_write(m->mould->kerf ? 2 : 1, shape, app_results_path(&m->results, m->name[CUT]), &error);
    return app_results_add(&m->results, m->name[CUT], status, &error);
}

static int write_mould_report(moulding *m) {
    wcut_error error = {0};
    const char *name = "report.html";
    const wcut_report_mould run = {.job_path = m->path,
                                   .stock_path = app_given(m->call, "stock") ? app_text(m->call, "stock") : NULL,
                                   .edges_path = app_given(m->call, "edges") ? app_text(m->call, "edges") : NULL,
                                   .chord_tolerance = app_real(m->call, "chord-tolerance"),
                                   .fit_tolerance = app_real(m->call, "fit-tolerance"),
                                   .prolong = app_real(m->call, "prolong")};
    const wcut_status status =
        wcut_report_mould_write(&run, m->job, m->history, m->mould, app_results_path(&m->results, name), &error);
    return app_results_add(&m->results, name, status, &error);
}

/* what a run leaves in its folder, under mould.json */
static int write_mould_results(moulding *m) {
    int code = write_halves(m);
    if (code == APP_DONE) code = write_cut(m);
    if (code == APP_DONE) code = write_mould_report(m);
    if (code != APP_DONE) return code;
    char *text = NULL;
    const wcut_status status = wcut_mould_print(m->mould, m->job->name, &text);
    return app_results_commit(&m->results, "mould.json", status, text);
}

/* ---- the answer ---- */

static void say_half(const char *name, const wcut_half_report *r) {
    app_say("%s: %.6g mm3, closed, %d piece%s; draft at least %.3g deg, undercut %.4g mm2", name, r->volume, r->pieces,
            r->pieces == 1 ? "" : "s", WCUT_DEG_PER_RAD * r->draft_min, r->undercut_area);
    if (isfinite(r->wall_min))
        app_say("%s: wall at least %.4g mm, at (%.4g, %.4g, %.4g); edges at the block's sides at least %.3g deg", name,
                r->wall_min, r->wall_place.x, r->wall_place.y, r->wall_place.z, WCUT_DEG_PER_RAD * r->edge_min);
}

static void say_mould(const moulding *m) {
    /* each half */
    const wcut_mould *d = m->mould;
    say_half("lower", &d->lower.report);
    say_half("upper", &d->upper.report);
    if (d->thickness > 0)
        app_say("casting between the halves: %.6g mm3, %.4g mm thick along the normals", d->kerf_volume, d->thickness);
    if (d->frame) app_say("frame: %.6g mm3", d->frame_volume);
    app_say("volumes of halves and %s make the block, relative error %.1e", d->thickness > 0 ? "casting" : "kerf",
            d->volume_error);

    /* the smallest radius against the wire's */
    if (isfinite(d->radius_min))
        app_say("%ssmallest radius of the cut %.4g mm, at (%.4g, %.4g, %.4g); radius of the wire %.4g mm",
                d->radius_min < d->wire_radius ? "warning: " : "", d->radius_min, d->radius_place.x, d->radius_place.y,
                d->radius_place.z, d->wire_radius);

    /* what was added to the cut, and what is missing */
    if (d->prolonged_entry > 0 || d->prolonged_exit > 0 || d->prolonged_side > 0)
        app_say(
            "the cut was continued straight: %.3g mm where it begins, %.3g mm where it ends, %.3g mm at the wire's "
            "ends",
            d->prolonged_entry, d->prolonged_exit, d->prolonged_side);
    if (d->by_boolean)
        app_say("no STEP files%s: the halves are triangle meshes, because %s",
                app_given(m->call, "iges") ? ", no IGES file" : "",
                m->stock ? "a stock was cut" : "the cut leaves through top or bottom");

    app_say("in %s: %s", m->results.folder, app_results_list(&m->results));
}

static int give(const moulding *m) {
    /* for people and for programs */
    if (!app_given(m->call, "quiet")) say_mould(m);
    if (app_given(m->call, "json")) fputs(m->results.text, stdout);

    /* walls and drafts that were asked for are exit codes; each that falls short is named with its place */
    int code = APP_DONE;
    const wcut_half_report *half[2] = {&m->mould->lower.report, &m->mould->upper.report};
    for (int k = 0; k < 2; k++) {
        const char *name = k ? "upper" : "lower";
        if (!half[k]->wall_held && !isfinite(half[k]->wall_min))
            code = app_fail(
                APP_OUTSIDE,
                "%s half: the wall is not known, because the half was made by booleans; expected at least %.4g mm",
                name, m->mould->wall_asked);
        else if (!half[k]->wall_held)
            code = app_fail(APP_OUTSIDE,
                            "%s half: found a wall of %.4g mm at (%.4g, %.4g, %.4g) mm, expected at least %.4g mm",
                            name, half[k]->wall_min, half[k]->wall_place.x, half[k]->wall_place.y,
                            half[k]->wall_place.z, m->mould->wall_asked);
        if (!half[k]->draft_held)
            code = app_fail(APP_OUTSIDE,
                            "%s half: found a draft of %.4g deg at (%.4g, %.4g, %.4g) mm, expected at least %.4g deg",
                            name, WCUT_DEG_PER_RAD * half[k]->draft_min, half[k]->draft_place.x, half[k]->draft_place.y,
                            half[k]->draft_place.z, WCUT_DEG_PER_RAD * m->mould->draft_asked);
    }

    return code;
}

static int mould(const app_call *call) {
    /* check the options before the simulation */
    moulding m = {.call = call, .path = call->operand[0]};
    int code = app_check_formats(call, FORMATS_KNOWN);
    if (code == APP_DONE) code = load_moulding(&m);
    if (code == APP_DONE) code = read_pull(app_text(call, "pull"), &m.pull);
    if (code == APP_DONE) code = name_mould_files(&m);
    if (code == APP_DONE) code = app_results_begin(&m.results, app_text(call, "output"), m.result);

    /* simulate, loft, divide, write */
    if (code == APP_DONE) {
        app_catch_interrupts();
        code = run_moulding(&m);
    }
    if (code == APP_DONE) code = loft(&m);
    if (code == APP_DONE) code = divide(&m);

    /* files, figures and the exit code */
    if (code == APP_DONE) code = write_mould_results(&m);
    if (code == APP_DONE) code = give(&m);

    app_results_end(&m.results);

    /* everything that was made, also after a failure */
    wcut_mould_destroy(m.mould);
    wcut_mesh_destroy(m.stock);
    free(m.kerf);
    free(m.parameter);
    wcut_surface_destroy(m.surface);
    wcut_history_destroy(m.history);
    wcut_setup_destroy(m.setup);
    wcut_job_destroy(m.job);
    return code;
}

/* ---- the table ---- */

/* defaults of the library */
static double mould_prolong(void) { return wcut_mould_default().prolong; }
static double mould_stock_unit(void) { return wcut_mesh_read_options_default().unit; }
static double mould_keys(void) { return wcut_mould_default().key_count > 0; }
static const char *mould_pull_text(void) {
    static char text[64];
    const wcut_vec3 pull = wcut_mould_default().pull;
    snprintf(text, sizeof text, "%g,%g,%g", pull.x, pull.y, pull.z);
    return text;
}
static double mould_fit_tolerance(void) { return wcut_mould_default().fit_tolerance; }
static double mould_key_clearance(void) { return wcut_mould_default().lug_clearance; }
static double mould_thickness(void) { return wcut_mould_default().thickness; }
static double mould_frame(void) { return wcut_mould_default().frame_wall; }
static double mould_frame_clearance(void) { return wcut_mould_default().frame_clearance; }
static double mould_scale(void) { return wcut_mould_default().scale; }
static double mould_minimum_wall(void) { return wcut_mould_default().wall_asked; }

static const app_operand operand[] = {
    {.name = "JOB", .kind = APP_FILE, .help = "a job file, wirecut-job/1"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    APP_OPTION_STATIONS,
    APP_OPTION_NODES,
    APP_OPTION_CHORD_TOLERANCE,
    {.kind = APP_REAL,
     .name = "fit-tolerance",
     .value = "MM",
     .low = 1e-5,
     .high = 10,
     .library = mould_fit_tolerance,
     .help = "largest distance between the exact cut face and the wire's surface, mm"},
    {.kind = APP_REAL,
     .name = "prolong",
     .value = "MM",
     .low = 0,
     .high = 1e6,
     .library = mould_prolong,
     .help = "longest straight continuation of a cut that ends inside the block, mm"},
    APP_OPTION_EDGES,
    {.kind = APP_FILE,
     .name = "stock",
     .value = "MESH",
     .help = "closed mesh inside the block, which is cut in its place"},
    {.kind = APP_CHOICE,
     .name = "stock-unit",
     .value = "mm|cm|m|inch|ft|dm|um",
     .library = mould_stock_unit,
     .help = "unit of that mesh (glTF is in metres)"},
    {.kind = APP_CHOICE,
     .name = "keys",
     .value = "none|pockets|cones|lugs",
     .library = mould_keys,
     .help = "pockets or cones: three keys on the outer face of each half, near the corners, for a base plate; lugs: "
             "three boxes beside each half, cones of the lower in pockets of the upper, register the halves to each "
             "other"},
    {.kind = APP_REAL,
     .name = "key-radius",
     .value = "MM",
     .low = 0.1,
     .high = 1e4,
     .standard = "15",
     .help = "radius of a key on its face, mm; a lug is three radii wide"},
    {.kind = APP_REAL,
     .name = "key-height",
     .value = "MM",
     .low = 0.1,
     .high = 1e4,
     .standard = "12",
     .help = "height of a cone or depth of a pocket, mm; its flanks are inclined by 20 deg, of a long cone by less"},
    {.kind = APP_REAL,
     .name = "key-clearance",
     .value = "MM",
     .low = 0,
     .high = 10,
     .library = mould_key_clearance,
     .help = "gap around the cones of lugs in their pockets, mm"},
    {.kind = APP_REAL,
     .name = "thickness",
     .value = "MM",
     .low = 0,
     .high = 1e4,
     .library = mould_thickness,
     .help =
         "thickness of the casting between the halves, along the normals of the cut, in place of the job's kerf, mm; "
         "for printed or milled moulds"},
    {.kind = APP_REAL,
     .name = "frame",
     .value = "MM",
     .low = 0,
     .high = 1e4,
     .library = mould_frame,
     .help = "wall of a frame around the block in which both halves lie, mm; 0: none; not with lugs"},
    {.kind = APP_REAL,
     .name = "frame-clearance",
     .value = "MM",
     .low = 0,
     .high = 100,
     .library = mould_frame_clearance,
     .help = "gap between block and frame, mm"},
    {.kind = APP_CHOICE,
     .name = "layout",
     .value = "assembled|print",
     .standard = "assembled",
     .help = "places in the 3MF files: as in the block, or on a printer's bed, every half on its outer face"},
    {.kind = APP_REAL,
     .name = "scale",
     .value = "FACTOR",
     .low = 0.5,
     .high = 2,
     .library = mould_scale,
     .help = "scale factor of the halves, for the shrinkage of the casting"},
    {.kind = APP_REAL,
     .name = "minimum-wall",
     .value = "MM",
     .low = 0,
     .high = 1e6,
     .library = mould_minimum_wall,
     .help = "smallest wall of a half, mm; if a wall is thinner the exit code is 5"},
    {.kind = APP_REAL,
     .name = "minimum-draft",
     .value = "DEG",
     .low = -90,
     .high = 90,
     .help = "least angle between cut face and pull, deg; if an angle is smaller the exit code is 5"},
    {.kind = APP_TEXT,
     .name = "pull",
     .value = "X,Y,Z",
     .library_text = mould_pull_text,
     .help =
         "direction in which the casting leaves the lower half, for draft and undercut; opposite for the upper half"},
    {.kind = APP_CHOICE,
     .name = "step-schema",
     .value = "ap214|ap242",
     .standard = "ap214",
     .help = "application protocol of the STEP files"},
    {.kind = APP_FLAG, .name = "iges", .help = "also write the exact cut faces as cut.igs, IGES 5.3 type 128"},
    {.kind = APP_TEXT,
     .name = "label",
     .value = "NAME",
     .help = "prefix of the file names, and name of the solids in place of the job's"},
    APP_OPTION_FORMATS(FORMATS_KNOWN),
    APP_OPTION_FORCE_LAW,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_mould = {
    .name = "mould",
    .brief = "divide a job's block along its cut into two closed solids",
    .about =
        "Simulates the cut of a job and divides its block along the surface, with the job's kerf. Writes into DIR the "
        "lower and the upper half, each as lower.stl, .obj, .ply, .3mf and .step (a closed solid of exact faces), "
        "mould.3mf (all parts), report.html (both in 3-D, with their drafts) and mould.json: volumes, walls, drafts, "
        "and "
        "whether both are closed, oriented and free of self-intersections.\nThe wall is the least distance, in any "
        "direction, from the cut face to the opposite face, to pockets in it, and to a side of the block that the cut "
        "face is inclined towards by 45 deg or more. The least angle of the edges between cut face and sides is "
        "reported too.\nWhere the cut leaves through the top or the bottom, and for a stock, the halves are made by "
        "mesh booleans: triangles without STEP files; mould.json says so. A cut that misses the block, grazes a face, "
        "runs along an edge, folds over itself or ends inside is an error, with its place.\n3DM is not written; Rhino "
        "opens the STEP files.",
    .operand = operand,
    .option = option,
    .run = mould,
};
