/* wirecut compare: a scan of the cut face beside the face that a job, or a mesh, says it should be. */
#include <math.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/angle.h>
#include <wirecut/cloud_file.h>
#include <wirecut/deviation_file.h>

#include "command.h"
#include "compare_run.h"
#include "job.h"
#include "results.h"
#include "terminal.h"

/* What a run may leave in its folder, in the order written. */
static const char *const result_name[] = {"deviation.ply",      "deviation_mesh.ply", "deviation_mesh.obj",
                                          "reconstruction.ply", "reconstruction.stl", "zones.csv",
                                          "report.html",        "deviation.json",     NULL};

/* points held in memory, unless something else is asked for */
enum { HOLD = 500000, HOLD_WHOLE = 2000000 };

/* ---- what is asked for ---- */

/* The next number of a list; NULL where there is none or it is not positive and finite. */
static const char *read_number(const char *text, double *number) {
    char *end;
    if (strspn(text, "+-.0123456789eE") == 0) return NULL;
    *number = strtod(text, &end);
    return end > text && isfinite(*number) && *number > 0 && *number <= 1e6 ? end : NULL;
}

static int refuse_bands(const char *text) {
    return app_fail(APP_USAGE, "--bands: found \"%s\", expected up to %d positive tolerances in mm, such as 0.25,0.5,1",
                    text, WCUT_BANDS_MAX - 1);
}

/* keep the list in order, each tolerance once; there is room for one more than may be listed, that of the gate */
static void add_band(app_compare_options *o, double band) {
    int at = o->bands;
    for (int k = 0; k < o->bands; k++)
        if (o->band[k] == band) return;
    for (; at > 0 && o->band[at - 1] > band; at--) o->band[at] = o->band[at - 1];
    o->band[at] = band;
    o->bands++;
}

static int read_bands(const char *text, app_compare_options *o) {
    const char *at = text;
    for (;;) {
        double band;
        at = read_number(at, &band);
        if (!at || o->bands == WCUT_BANDS_MAX - 1) return refuse_bands(text);
        add_band(o, band);
        if (!*at) return APP_DONE;
        if (*at++ != ',') return refuse_bands(text);
    }
}

/* ---- degrees of freedom ---- */

static int refuse_dof(const char *text) {
    return app_fail(APP_USAGE,
                    "--dof: found \"%s\", expected degrees of freedom tx, ty, tz (mm) and rx, ry, rz (deg), each free "
                    "or with a standard deviation, as tx:0.2,rz:0.01deg,tz:free",
                    text);
}

/* "tx:0.2" or "tz:free" or "tz", up to a comma or the end; NULL where it is none */
static const char *read_dof(const char *at, wcut_registration_options *options) {
    static const char *const name[WCUT_DOF_COUNT] = {"tx", "ty", "tz", "rx", "ry", "rz"};
    int k = 0;
    while (k < WCUT_DOF_COUNT && strncmp(at, name[k], 2) != 0) k++;
    if (k == WCUT_DOF_COUNT) return NULL;
    wcut_dof *dof = &options->dof[k];
    dof->kind = WCUT_DOF_KIND_FREE;
    at += 2;
    if (*at != ':') return at;
    at++;
    if (strncmp(at, "free", 4) == 0) return at + 4;
    at = read_number(at, &dof->sigma);
    if (!at) return NULL;
    dof->kind = WCUT_DOF_KIND_PRIOR;
    if (k < 3) return strncmp(at, "mm", 2) == 0 ? at + 2 : at;
    if (strncmp(at, "rad", 3) == 0) return at + 3;
    dof->sigma /= WCUT_DEG_PER_RAD;
    return strncmp(at, "deg", 3) == 0 ? at + 3 : at;
}

/* those that are not named stay where they are */
static int read_dofs(const char *text, wcut_registration_options *options) {
    for (int k = 0; k < WCUT_DOF_COUNT; k++) options->dof[k].kind = WCUT_DOF_KIND_LOCKED;
    for (const char *at = text;; at++) {
        at = read_dof(at, options);
        if (!at || (*at && *at != ',')) return refuse_dof(text);
        if (!*at) return APP_DONE;
    }
}

/* ---- options ---- */

static void read_cleaning(const app_call *call, app_scan_options *o) {
    o->clean = wcut_clean_options_default();
    o->clean.duplicate = app_given(call, "duplicates") ? 0 : -1;
    o->clean.radius = app_given(call, "isolated") ? app_real(call, "isolated") : 0;
    o->clean.voxel = app_given(call, "thin") ? app_real(call, "thin") : 0;
    if (app_given(call, "outliers"))
        o->clean.deviations = app_real(call, "outliers");
    else
        o->clean.neighbours = 0;
    o->cleaned = app_given(call, "duplicates") || app_given(call, "isolated") || app_given(call, "thin") ||
                 app_given(call, "outliers");
}

static int read_registration(const app_call *call, app_compare_options *o) {
    o->method = (wcut_registration_method)app_choice(call, "register");
    o->registration = wcut_registration_options_default();
    o->datum_path = app_text(call, "datum");
    const bool by_datum = o->method == WCUT_REGISTRATION_METHOD_DATUM;
    if (by_datum != (o->datum_path != NULL))
        return app_fail(APP_USAGE, "%s: expected --register datum and --datum FILE together",
                        by_datum ? "--register datum" : "--datum");
    if (!app_given(call, "dof")) return APP_DONE;
    if (o->method == WCUT_REGISTRATION_METHOD_NONE)
        return app_fail(APP_USAGE, "--dof: expected --register datum or fit with it");
    return read_dofs(app_text(call, "dof"), &o->registration);
}

static int read_options(const app_call *call, app_compare_options *o) {
    /* a job among the scans is most likely a wrong order */
    const char *first = strrchr(call->operand[0], '.');
    for (int k = 1; k < call->operand_count && first; k++) {
        const char *ending = strrchr(call->operand[k], '.');
        if (strcmp(first, ".json") != 0 && ending && strcmp(ending, ".json") == 0)
            return app_fail(APP_USAGE, "compare: found %s before %s, expected the job first: JOB.json SCAN...",
                            call->operand[0], call->operand[k]);
    }

    /* defaults, and the options that are given */
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    *o = (app_compare_options){.reference = call->operand[0],
                               .call = call,
                               .files = call->operand_count - 1,
                               .scan = call->operand + 1,
                               .quiet = app_given(call, "quiet"),
                               .flip = app_given(call, "flip"),
                               .distance = (app_distance)app_choice(call, "distance"),
                               .chord_tolerance = app_real(call, "chord-tolerance"),
                               .share = app_real(call, "share") / 100,
                               .reconstruct = app_choice(call, "reconstruct"),
                               .threads = processors > 1 ? processors < 64 ? (int)processors : 64 : 1};

    /* numbers that depend on the scan unless they are given */
    if (app_given(call, "threads")) o->threads = app_int(call, "threads");
    if (app_given(call, "normals")) o->normals = app_int(call, "normals");
    if (app_given(call, "support")) o->support = app_real(call, "support");

    /* scans: unit, columns, threads, cleaning */
    o->scans.unit = (wcut_length_unit)app_choice(call, "unit");
    o->scans.columns = app_text(call, "columns");

    /* the title block of the report */
    o->part = app_text(call, "part");
    o->inspector = app_text(call, "inspector");
    o->instrument = app_text(call, "instrument");
    o->date = app_text(call, "date");

    /* a law from a calibration replaces the job's */
    if (app_given(call, "force-law")) o->force_law = app_text(call, "force-law");
    o->reference_unit =
        app_given(call, "reference-unit") ? (wcut_length_unit)app_choice(call, "reference-unit") : o->scans.unit;
    o->scans.threads = o->threads;
    read_cleaning(call, &o->scans);

    /* a reconstruction is needed for a distance to it, and all points for the reconstruction */
    if (o->distance == APP_TO_RECONSTRUCTION && o->reconstruct == 0) o->reconstruct = 1;
    o->scans.hold = app_given(call, "hold") ? app_int(call, "hold") : o->reconstruct ? HOLD_WHOLE : HOLD;

    /* bands of the histogram; the tolerance is one of them */
    int code = read_bands(app_text(call, "bands"), o);
    if (code == APP_DONE && app_given(call, "tolerance")) {
        o->tolerance = app_real(call, "tolerance");
        add_band(o, o->tolerance);
    }

    return code == APP_DONE ? read_registration(call, o) : code;
}

/* ---- the files ---- */

static int write_meshes(const app_comparison *c, app_results *r) {
    wcut_error error = {0};
    wcut_status status = wcut_deviation_mesh_write_ply(c->mesh, c->value, c->present, c->limit,
                                                       app_results_path(r, "deviation_mesh.ply"), &error);
    int code = app_results_add(r, "deviation_mesh.ply", status, &error);
    if (code != APP_DONE) return code;
    status = wcut_deviation_mesh_write_obj(c->mesh, c->value, c->present, c->limit,
                                           app_results_path(r, "deviation_mesh.obj"), &error);
    code = app_results_add(r, "deviation_mesh.obj", status, &error);
    if (code != APP_DONE || !c->reconstruction) return code;
    const wcut_mesh *mesh = c->reconstruction->mesh;
    status = wcut_deviation_mesh_write_ply(mesh, mesh->scalar, NULL, c->limit,
                                           app_results_path(r, "reconstruction.ply"), &error);
    code = app_results_add(r, "reconstruction.ply", status, &error);
    if (code != APP_DONE) return code;
    status = wcut_mesh_write_stl(mesh, app_results_path(r, "reconstruction.stl"), &error);
    return app_results_add(r, "reconstruction.stl", status, &error);
}

static int write_compare_report(const app_comparison *c, app_results *r) {
    /* names of the units in the order of their enumerators */
    wcut_error error = {0};
    static const char *const unit[] = {"mm", "cm", "m", "inch", "ft", "dm", "um"};
    const app_reference *reference = &c->reference;

    /* what the page shows: the comparison, the face, the scan */
    const wcut_report_compare page = {.compared = &c->found,
                                      .title = reference->job ? reference->job->name : NULL,
                                      .reference_sha256 = reference->hash[0] ? reference->hash : NULL,
                                      .face = reference->face,
                                      .stations = reference->is_job ? reference->history->stations : 0,
                                      .mount_a = reference->mount_a,
                                      .mount_b = reference->mount_b,
                                      .mesh = c->mesh,
                                      .value = c->value,
                                      .present = c->present,
                                      .points = c->scans.count,
                                      .point = c->scans.point,
                                      .deviation = c->deviation,
                                      .spacing = c->scans.spacing,
                                      .unit = unit[c->options.scans.unit],
                                      .border = reference->options.border};

    const wcut_status status = wcut_report_compare_write(&page, app_results_path(r, "report.html"), &error);

    return app_results_add(r, "report.html", status, &error);
}

/* What a run leaves in its folder, under deviation.json. */
static int write_compare_results(app_comparison *c, app_results *r) {
    wcut_error error = {0};
    int code = app_results_add(r, "deviation.ply", wcut_deviation_stream_commit(c->points, &error), &error);
    if (code == APP_DONE) code = write_meshes(c, r);
    if (code == APP_DONE) {
        const wcut_status status = wcut_zones_write(c->found.found, app_results_path(r, "zones.csv"), &error);
        code = app_results_add(r, "zones.csv", status, &error);
    }
    if (code == APP_DONE) code = write_compare_report(c, r);
    if (code != APP_DONE) return code;
    char *text = NULL;
    const wcut_status status = wcut_deviation_print(&c->found, &text);
    return app_results_commit(r, "deviation.json", status, text);
}

/* ---- the answer ---- */

static void say_figures(const char *label, const wcut_deviation_summary_result *r) {
    const wcut_statistics *s = &r->statistics;
    if (s->count == 0) {
        app_say("%-13s mean \xe2\x80\x93, rms \xe2\x80\x93, max \xe2\x80\x93: no point is over the face", label);
        return;
    }
    app_say("%-13s mean %+.3f, rms %.3f, 1 %% %+.3f, median %+.3f, 99 %% %+.3f, max %.3f mm", label, s->mean, s->rms,
            s->p01, s->median, s->p99, s->hausdorff);
    app_say("%-13s offset %+.3f \xc2\xb1 %.3f, form %.3f rms, noise %.3f rms mm", "", r->split.offset,
            r->split.offset_error, r->split.form_rms, r->split.noise_rms);
}

static void say_registration(const wcut_registration *r) {
    static const char *const name[WCUT_DOF_COUNT] = {"tx", "ty", "tz", "rx", "ry", "rz"};
    char text[256] = "";
    size_t used = 0;
    for (int k = 0; k < WCUT_DOF_COUNT; k++) {
        const double unit = k < 3 ? 1 : WCUT_DEG_PER_RAD;
        used += (size_t)snprintf(text + used, sizeof text - used, " %s %.4g%s", name[k], r->parameter[k] * unit,
                                 r->determined[k] ? "" : "*");
    }
    app_say("moved by%s (mm, deg; *: not determined by the data), overlap %.1f %%", text, 100 * r->overlap);
    app_say("the motion puts the points \xc2\xb1 %.2g mm (standard error, RMS)", r->doubt);
    if (!r->converged)
        app_say("warning: the fit stopped after %d steps, the last of %.2g mm; this is its best pose", r->iterations,
                r->step);
}

static void say_answer(const app_comparison *c, const app_results *results) {
    const wcut_compared *f = &c->found;
    app_say("%s: %d points compared, %d outside, %d ambiguous", c->options.scan[0], f->found->statistics.count,
            f->found->place[WCUT_PLACE_BEYOND], f->found->place[WCUT_PLACE_AMBIGUOUS]);
    say_figures("as scanned", f->unmoved);
    if (c->registration.method != WCUT_REGISTRATION_METHOD_NONE) {
        say_figures(c->registration.method == WCUT_REGISTRATION_METHOD_FIT ? "best fit" : "by datums", f->found);
        say_registration(&c->registration);
    }
    if (f->has_kerf)
        app_say("kerf from the scan %.3f mm, in the job %.3f mm", f->kerf - 2 * f->found->split.offset, f->kerf);
    if (f->tolerance > 0)
        app_say("%s: required are \xc2\xb1%g mm for %g %% of the points",
                f->within ? "within tolerance" : "OUTSIDE TOLERANCE", f->tolerance, 100 * f->share);
    app_say("in %s: %s", results->folder, app_results_list(results));
}

static int give_answer(const app_comparison *c, const app_results *results) {
    if (!c->options.quiet) say_answer(c, results);
    if (!c->registration.converged) return APP_NOT_CONVERGED;
    return c->found.within ? APP_DONE : APP_OUTSIDE;
}

static int run_compare(const app_call *call) {
    app_compare_options options;
    app_results results;
    int code = read_options(call, &options);
    if (code == APP_DONE) code = app_results_begin(&results, app_text(call, "output"), result_name);
    if (code != APP_DONE) return code;
    app_catch_interrupts();
    app_comparison *c = calloc(1, sizeof *c);
    code = c ? app_comparison_run(c, &options, &results) : app_fail_status(WCUT_NO_MEMORY, "compare", NULL);
    if (c && code == APP_DONE) code = write_compare_results(c, &results);
    if (code == APP_DONE && app_given(call, "json")) fputs(results.text, stdout);
    if (c && code == APP_DONE) code = give_answer(c, &results);
    if (c) app_comparison_clear(c);
    free(c);
    app_results_end(&results);
    return code;
}

/* ---- the table ---- */

static const app_operand operand[] = {
    {.name = "JOB", .kind = APP_FILE, .help = "a job, wirecut-job/1, or a mesh: .stl .ply .obj .off .glb"},
    {.name = "SCAN",
     .kind = APP_FILE,
     .many = true,
     .help =
         "point clouds of the lower half's cut face, which together are one scan: PLY, text (XYZ, PTS, PTX, CSV, ASC), "
         "LAS, PCD; or the vertices of STL, OBJ, OFF, glTF"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    APP_OPTION_EDGES,
    {.kind = APP_CHOICE,
     .name = "unit",
     .value = "mm|cm|m|inch|ft|dm|um",
     .standard = "mm",
     .help = "unit of scans that state none, and of a mesh they are compared with (glTF is in metres)"},
    {.kind = APP_CHOICE,
     .name = "reference-unit",
     .value = "mm|cm|m|inch|ft|dm|um",
     .help = "unit of the mesh alone, where it is not that of the scans"},
    {.kind = APP_TEXT, .name = "part", .value = "TEXT", .help = "title block of the report: what was measured"},
    {.kind = APP_TEXT, .name = "inspector", .value = "TEXT", .help = "title block: who measured it"},
    {.kind = APP_TEXT, .name = "instrument", .value = "TEXT", .help = "title block: with which instrument"},
    {.kind = APP_TEXT, .name = "date", .value = "TEXT", .help = "title block: when it was measured"},
    {.kind = APP_TEXT,
     .name = "columns",
     .value = "X,Y,Z",
     .help = "columns of a text scan, names of its header or numbers from 1, as x_meas,y_meas,z_meas or 4,5,6; else "
             "by the header"},
    {.kind = APP_CHOICE,
     .name = "register",
     .value = "none|datum|fit",
     .standard = "none",
     .help = "none: as scanned; datum: by --datum; fit: best fit to the face, which hides deviations that resemble a "
             "rigid motion. The figures as scanned are always reported too"},
    {.kind = APP_FILE,
     .name = "datum",
     .value = "FILE.csv",
     .help = "scan_x_mm, scan_y_mm, scan_z_mm and block_x_mm, block_y_mm, block_z_mm: all three, or one, that of an "
             "uncut face; sigma_mm if known"},
    {.kind = APP_TEXT,
     .name = "dof",
     .value = "LIST",
     .help = "degrees of freedom of the registration, free or with a standard deviation: tx:0.2,rz:0.01deg,tz:free; "
             "others are locked"},
    {.kind = APP_FLAG, .name = "duplicates", .help = "remove points that are equal to an earlier one"},
    {.kind = APP_REAL,
     .name = "outliers",
     .value = "M",
     .low = 0,
     .high = 1e6,
     .help =
         "remove points whose mean distance from 10 neighbours is M robust deviations above the median; 6 is usual"},
    {.kind = APP_REAL,
     .name = "isolated",
     .value = "MM",
     .low = 1e-3,
     .high = 1e6,
     .help = "remove points with fewer than 4 others within this radius, mm"},
    {.kind = APP_REAL,
     .name = "thin",
     .value = "MM",
     .low = 1e-3,
     .high = 1e6,
     .help = "keep one point in each cube of this side, mm"},
    {.kind = APP_INT,
     .name = "normals",
     .value = "K",
     .low = 2,
     .high = 128,
     .help = "write a normal for every point into deviation.ply, from its K nearest points, towards the removed half; "
             "16 is usual"},
    {.kind = APP_REAL,
     .name = "tolerance",
     .value = "MM",
     .low = 1e-6,
     .high = 1e6,
     .help =
         "tolerance, mm: the exit code is 5 unless --share percent of the deviations are within plus or minus this"},
    {.kind = APP_REAL,
     .name = "share",
     .value = "PERCENT",
     .low = 0,
     .high = 100,
     .standard = "95",
     .help = "percentage of the deviations that must be within --tolerance"},
    {.kind = APP_TEXT,
     .name = "bands",
     .value = "LIST",
     .standard = "0.25,0.5,1,2",
     .help = "tolerances in mm whose shares are reported"},
    {.kind = APP_CHOICE,
     .name = "distance",
     .value = "surface|mesh|reconstruction",
     .standard = "surface",
     .help = "distance from the points to the exact surface or to its triangles (a mesh has only those), or from the "
             "reconstructed scan to the surface"},
    {.kind = APP_CHOICE,
     .name = "reconstruct",
     .value = "none|field",
     .standard = "none",
     .help = "make a mesh of the scan: a smooth field of deviation over the face"},
    {.kind = APP_REAL,
     .name = "support",
     .value = "MM",
     .low = 1e-3,
     .high = 1e6,
     .help = "radius around a point within which the face counts as measured, mm; default 1.5, or 2.5 times the point "
             "spacing if that is more"},
    {.kind = APP_REAL,
     .name = "chord-tolerance",
     .value = "MM",
     .low = 1e-4,
     .high = 1e3,
     .standard = "0.01",
     .help = "largest distance between triangles and surface, mm, for --distance mesh"},
    {.kind = APP_INT,
     .name = "hold",
     .value = "N",
     .low = 1000,
     .high = 100000000,
     .help = "points held in memory; of a larger scan a sample is held and the files are read twice; default 500000, "
             "with --reconstruct 2000000"},
    {.kind = APP_INT,
     .name = "threads",
     .value = "N",
     .low = 1,
     .high = 64,
     .help = "number of threads; default one for each processor. Results do not depend on it"},
    {.kind = APP_FLAG, .name = "flip", .help = "turn the triangles of a reference mesh that face the wrong way"},
    APP_OPTION_FORCE_LAW,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_compare = {
    .name = "compare",
    .brief = "compare a scan with the simulation: deviations, statistics, report",
    .about =
        "Measures the distance of every point of a scan from the cut face of the lower half, which is the wire's "
        "surface lowered by half the kerf; positive where material was left. Points beyond the border of the face are "
        "counted as outside, not as deviations.\nWrites into DIR: deviation.ply (every point with its deviation), "
        "deviation_mesh.ply and .obj (the face, coloured), zones.csv, report.html (everything on one page, for any "
        "browser), with --reconstruct reconstruction.ply and .stl, and deviation.json, which is written last and lists "
        "the files.\nThe exit code is 5 if the deviations are outside --tolerance; the files are written in any case.",
    .operand = operand,
    .option = option,
    .run = run_compare,
};
