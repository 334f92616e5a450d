/* wirecut compare: a scan of the cut face beside the face that a job, or a mesh, says it should be. */
#include <math.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>
#include <wirecut/angle.h>
#include <wirecut/compare.h>

#include "command.h"
#include "job.h"
#include "results.h"
#include "terminal.h"

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

static int read_bands(const char *text, wcut_compare_options *o) {
    const char *at = text;
    for (;;) {
        double band;
        at = read_number(at, &band);
        if (!at || o->bands == WCUT_BANDS_MAX - 1) return refuse_bands(text);
        o->band[o->bands++] = band;
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

static void read_cleaning(const app_call *call, wcut_clean_options *clean) {
    const wcut_clean_options usual = wcut_clean_options_default();
    if (app_given(call, "duplicates")) clean->duplicate = usual.duplicate;
    if (app_given(call, "isolated")) clean->radius = app_real(call, "isolated");
    if (app_given(call, "thin")) clean->voxel = app_real(call, "thin");
    if (app_given(call, "outliers"))
        clean->neighbours = usual.neighbours, clean->deviations = app_real(call, "outliers");
}

static int read_registration(const app_call *call, wcut_compare_options *o) {
    o->method = (wcut_registration_method)app_choice(call, "register");
    o->datums = app_text(call, "datum");
    const bool by_datum = o->method == WCUT_REGISTRATION_METHOD_DATUM;
    if (by_datum != (o->datums != NULL))
        return app_fail(APP_USAGE, "%s: expected --register datum and --datum FILE together",
                        by_datum ? "--register datum" : "--datum");
    if (!app_given(call, "dof")) return APP_DONE;
    if (o->method == WCUT_REGISTRATION_METHOD_NONE)
        return app_fail(APP_USAGE, "--dof: expected --register datum or fit with it");
    return read_dofs(app_text(call, "dof"), &o->registration);
}

static int check_job_first(const app_call *call) {
    const char *first = strrchr(call->operand[0], '.');
    for (int k = 1; k < call->operand_count && first; k++) {
        const char *ending = strrchr(call->operand[k], '.');
        if (strcmp(first, ".json") != 0 && ending && strcmp(ending, ".json") == 0)
            return app_fail(APP_USAGE, "compare: found %s before %s, expected the job first: JOB.json SCAN...",
                            call->operand[0], call->operand[k]);
    }
    return APP_DONE;
}

/* a CAD file states its unit */
static int check_unit(const app_call *call) {
    static const char *const cad[] = {".step", ".stp", ".p21", ".iges", ".igs"};
    const char *ending = strrchr(call->operand[0], '.');
    for (size_t k = 0; ending && app_given(call, "reference-unit") && k < sizeof cad / sizeof *cad; k++)
        if (strcasecmp(ending, cad[k]) == 0)
            return app_fail(APP_USAGE, "%s: --reference-unit: found a CAD file, which states its unit",
                            call->operand[0]);
    return APP_DONE;
}

static int processors(void) {
    const long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count > 1 ? count < 64 ? (int)count : 64 : 1;
}

static int read_compare_options(const app_call *call, wcut_compare_options *o) {
    int code = check_job_first(call);
    if (code == APP_DONE) code = check_unit(call);
    *o = wcut_compare_options_default();

    /* what is read, and how */
    o->unit = (wcut_length_unit)app_choice(call, "unit");
    o->reference_unit =
        app_given(call, "reference-unit") ? (wcut_length_unit)app_choice(call, "reference-unit") : o->unit;
    o->columns = app_text(call, "columns");
    o->flip = app_given(call, "flip");
    read_cleaning(call, &o->clean);

    /* what is measured */
    o->distance = (wcut_compare_distance)app_choice(call, "distance");
    o->chord_tolerance = app_real(call, "chord-tolerance");
    o->share = app_real(call, "share") / 100;
    o->reconstruct = app_choice(call, "reconstruct") > 0;
    if (app_given(call, "normals")) o->normals = app_int(call, "normals");
    if (app_given(call, "support")) o->support = app_real(call, "support");
    if (app_given(call, "tolerance")) o->tolerance = app_real(call, "tolerance");
    if (app_given(call, "hold")) o->hold = app_int(call, "hold");
    o->threads = app_given(call, "threads") ? app_int(call, "threads") : processors();

    /* the title block */
    o->zones = app_text(call, "zones");
    o->part = app_text(call, "part");
    o->inspector = app_text(call, "inspector");
    o->instrument = app_text(call, "instrument");
    o->date = app_text(call, "date");

    o->bands = 0;
    if (code == APP_DONE) code = read_bands(app_text(call, "bands"), o);
    return code == APP_DONE ? read_registration(call, o) : code;
}

/* ---- who watches ---- */

typedef struct watching {
    bool quiet;
    int stage; /* that the bar is of; -1: none yet */
    app_progress bar;
} watching;

static int watch_progress(wcut_compare_stage stage, int done, int total, void *context) {
    watching *w = context;

    /* a bar for each stage whose end is known */
    if (stage == WCUT_COMPARE_STAGE_READ) return app_is_interrupted();
    if (w->stage != (int)stage) {
        app_progress_end(&w->bar);
        w->bar = app_progress_begin(w->quiet);
        if (stage == WCUT_COMPARE_STAGE_MEASURE) w->bar.unit = "points";
        w->stage = (int)stage;
    }
    const int stop = app_progress_step(done, total, &w->bar);
    if (done >= total - 1) app_progress_end(&w->bar);
    return stop;
}

static void watch_warning(const char *text, void *context) {
    (void)context;
    app_say("%s", text);
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

/* zones of the user with a tolerance: how many pass, and the names of those that fail */
static void say_zones(const wcut_survey_result *s) {
    char failed[200] = "";
    size_t used = 0;
    int judged = 0, passed = 0;
    for (int k = 0; k < s->of->regions; k++) {
        if (s->region[k].passed < 0) continue;
        judged++;
        passed += s->region[k].passed;
        if (s->region[k].passed || used + WCUT_REGION_NAME + 2 >= sizeof failed) continue;
        used += (size_t)snprintf(failed + used, sizeof failed - used, "%s%s", used ? ", " : "", s->of->region[k].name);
    }
    if (judged > 0)
        app_say("zones: %d of %d within their tolerance%s%s", passed, judged, used ? "; FAILED: " : "", failed);
}

static void say_answer(const app_call *call, const wcut_compare_result *c, const char *files) {
    const wcut_compared *f = &c->compared;
    app_say("%s: %d points compared, %d outside, %d ambiguous", call->operand[1], f->found->statistics.count,
            f->found->place[WCUT_PLACE_BEYOND], f->found->place[WCUT_PLACE_AMBIGUOUS]);
    say_figures("as scanned", f->unmoved);
    if (f->registration->method != WCUT_REGISTRATION_METHOD_NONE) {
        say_figures(f->registration->method == WCUT_REGISTRATION_METHOD_FIT ? "best fit" : "by datums", f->found);
        say_registration(f->registration);
    }
    if (f->has_kerf)
        app_say("kerf from the scan %.3f mm, in the job %.3f mm", f->kerf - 2 * f->found->split.offset, f->kerf);
    if (f->survey) say_zones(f->survey);
    if (f->tolerance > 0)
        app_say("%s: required are \xc2\xb1%g mm for %g %% of the points",
                f->within ? "within tolerance" : "OUTSIDE TOLERANCE", f->tolerance, 100 * f->share);
    app_say("in %s: %s", app_text(call, "output"), files);
}

static int give_answer(const app_call *call, const wcut_compare_result *c, const char *text) {
    const char *name[WCUT_COMPARE_FILES_MAX];
    const int files = wcut_compare_files(c, name);
    char list[512] = "";
    size_t used = 0;
    for (int k = 0; k < files; k++)
        used += (size_t)snprintf(list + used, sizeof list - used, "%s%s", k ? ", " : "", name[k]);
    if (!app_given(call, "quiet")) say_answer(call, c, list);
    if (app_given(call, "json")) fputs(text, stdout);
    if (!c->compared.registration->converged) return APP_NOT_CONVERGED;
    const bool passed = !c->compared.survey || c->compared.survey->passed;
    return c->compared.within && passed ? APP_DONE : APP_OUTSIDE;
}

/* ---- the whole ---- */

/* compare, and write the set of files */
static int compare_files(const app_call *call, const wcut_compare_options *options, wcut_results *results) {
    /* reference and scans of the call */
    const wcut_compare_reference reference = {.path = call->operand[0],
                                              .edges = app_text(call, "edges"),
                                              .force_law = app_text(call, "force-law"),
                                              .face = app_text(call, "face")};
    const int scans = call->operand_count - 1;
    wcut_compare_scan *scan = calloc((size_t)scans, sizeof *scan);
    if (!scan) return app_fail_status(WCUT_NO_MEMORY, "compare", NULL);
    for (int k = 0; k < scans; k++) scan[k].path = call->operand[k + 1];

    /* compare with a progress bar; warnings are printed when they occur */
    wcut_error error = {0};
    wcut_compare_result *result = NULL;
    char *text = NULL;
    watching w = {.quiet = app_given(call, "quiet"), .stage = -1};
    const wcut_compare_watch watch = {watch_progress, watch_warning, &w};
    wcut_status status = wcut_compare_run(&reference, scans, scan, options, results, &watch, &result, &error);
    app_progress_end(&w.bar);

    /* write the set of files and print the verdict */
    if (status == WCUT_OK) status = wcut_compare_write(result, results, &text, &error);
    const int code = status == WCUT_OK ? give_answer(call, result, text) : app_fail_status(status, NULL, &error);

    free(text);
    wcut_compare_destroy(result);
    free(scan);
    return code;
}

static int run_compare(const app_call *call) {
    const char *name[WCUT_COMPARE_FILES_MAX + 1] = {NULL};
    wcut_compare_options options;
    app_results results;
    wcut_compare_files(NULL, name);
    int code = read_compare_options(call, &options);
    if (code == APP_DONE) code = app_results_begin(&results, app_text(call, "output"), name);
    if (code != APP_DONE) return code;

    app_catch_interrupts();
    code = compare_files(call, &options, results.set);
    app_results_end(&results);
    return code;
}

/* ---- the table ---- */

static double compare_unit(void) { return wcut_compare_options_default().unit; }
static double compare_register(void) { return wcut_compare_options_default().method; }
static double compare_share(void) { return 100 * wcut_compare_options_default().share; }
static double compare_distance(void) { return wcut_compare_options_default().distance; }
static double compare_reconstruct(void) { return wcut_compare_options_default().reconstruct; }
static double compare_chord_tolerance(void) { return wcut_compare_options_default().chord_tolerance; }

static const char *compare_bands_text(void) {
    static char text[WCUT_BANDS_MAX * 16];
    const wcut_compare_options o = wcut_compare_options_default();
    int used = 0;
    for (int k = 0; k < o.bands; k++)
        used += snprintf(text + used, sizeof text - (size_t)used, "%s%g", k ? "," : "", o.band[k]);
    return text;
}

static const app_operand operand[] = {
    {.name = "JOB",
     .kind = APP_FILE,
     .help = "a job, wirecut-job/1, a mesh: .stl .ply .obj .off .glb, or a face of a CAD file: .step .iges"},
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
     .library = compare_unit,
     .help = "unit of scans that state none, and of a mesh they are compared with (glTF is in metres)"},
    {.kind = APP_CHOICE,
     .name = "reference-unit",
     .value = "mm|cm|m|inch|ft|dm|um",
     .help = "unit of the mesh alone, where it is not that of the scans; a CAD file states its own"},
    {.kind = APP_TEXT,
     .name = "face",
     .value = "NAME|N,..",
     .help =
         "of a CAD file with several faces: those that are compared, by their names or their numbers from 1, or all"},
    {.kind = APP_FILE,
     .name = "zones",
     .value = "FILE.json",
     .help =
         "zones with a tolerance each and sections along lines, wirecut-zones/1: verdicts in the report, zones.csv and "
         "deviation.json, profiles in sections.csv; the exit code is 5 if a zone fails"},
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
     .library = compare_register,
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
     .library = compare_share,
     .help = "percentage of the deviations that must be within --tolerance"},
    {.kind = APP_TEXT,
     .name = "bands",
     .value = "LIST",
     .library_text = compare_bands_text,
     .help = "tolerances in mm whose shares are reported"},
    {.kind = APP_CHOICE,
     .name = "distance",
     .value = "surface|mesh|reconstruction",
     .library = compare_distance,
     .help = "distance from the points to the exact surface of a job or a CAD file or to triangles (a mesh has only "
             "those), or "
             "from the reconstructed scan to the surface"},
    {.kind = APP_CHOICE,
     .name = "reconstruct",
     .value = "none|field",
     .library = compare_reconstruct,
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
     .library = compare_chord_tolerance,
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
