/* wirecut overlay: a photograph of the cut face beside the simulated wire. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "job.h"
#include "results.h"
#include "terminal.h"

/* everything in a run */
typedef struct overlaying {
    const app_call *call;
    const char *job_path, *photo_path;
    wcut_job *job;
    wcut_setup *setup;
    wcut_history *history;
    wcut_picture *photo;
    wcut_picture_source source;
    int points;
    wcut_photo_point *point;
    double *residual, *left_out;
    wcut_camera camera;
    wcut_camera_report report;
    wcut_overlay *overlay;
    char hash[2][WCUT_SHA256_TEXT];
    app_results results;
} overlaying;

static const char *const result_name[] = {
    "rectified.png", "rectified.pgw", "overlay.png", "overlay.svg",  "overlay-photo.png",
    "details.png",   "rills.csv",     "report.html", "overlay.json", NULL};

/* ---- what is given ---- */

/* four corners of the block's upper face: u and v of each */
static int read_corners(overlaying *o, const char *text) {
    /* the corners of the upper face, in the order of the option */
    const wcut_vec3 b = o->job->block_size;
    const wcut_vec3 place[4] = {{0, 0, b.z}, {b.x, 0, b.z}, {b.x, b.y, b.z}, {0, b.y, b.z}};
    o->point = calloc(4, sizeof *o->point);
    if (!o->point) return app_fail_status(WCUT_NO_MEMORY, "overlay", NULL);

    /* eight numbers with commas between them */
    const char *at = text;
    for (int k = 0; k < 8; k++) {
        char *end;
        const double value = strtod(at, &end);
        if (end == at || *end != (k < 7 ? ',' : '\0') || !isfinite(value))
            return app_fail(
                APP_USAGE,
                "--corners: found \"%s\", expected eight numbers: u1,v1,u2,v2,u3,v3,u4,v4 (see wirecut overlay "
                "--help)",
                text);

        /* u and v by turns */
        if (k % 2)
            o->point[k / 2].v = value;
        else
            o->point[k / 2].u = value;
        o->point[k / 2].place = place[k / 2];
        at = end + 1;
    }
    o->points = 4;
    return APP_DONE;
}

static int read_points(overlaying *o) {
    const char *points = app_text(o->call, "points"), *corners = app_text(o->call, "corners");
    wcut_error error = {0};
    if (!points == !corners)
        return app_fail(APP_USAGE, "overlay: expected either --points POINTS.csv or --corners u1,v1,u2,v2,u3,v3,u4,v4");
    if (corners) return read_corners(o, corners);
    const wcut_status status = wcut_photo_points_read(points, &o->points, &o->point, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, NULL, &error);
}

static int load_overlay(overlaying *o) {
    wcut_error error = {0};
    int code = app_job_load(o->call, o->job_path, &o->job);
    if (code == APP_DONE) code = read_points(o);
    if (code != APP_DONE) return code;
    wcut_status status = wcut_picture_read(o->photo_path, &o->photo, &o->source, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);

    /* the camera first: a mistyped row is known before the cut is simulated */
    o->residual = calloc((size_t)o->points * 2, sizeof *o->residual);
    o->left_out = calloc((size_t)o->points, sizeof *o->left_out);
    if (!o->residual || !o->left_out) return app_fail_status(WCUT_NO_MEMORY, "overlay", NULL);
    status = wcut_camera_fit(o->points, o->point, o->photo->width, o->photo->height, NULL, &o->camera, &o->report,
                             o->residual, o->left_out, &error);
    if (status != WCUT_OK) return app_fail_status(status, app_text(o->call, "points"), &error);
    status = wcut_source_hash(o->job_path, o->hash[0], &error);
    if (status == WCUT_OK) status = wcut_source_hash(o->photo_path, o->hash[1], &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, NULL, &error);
}

/* ---- the run ---- */

static int run_overlay(overlaying *o) {
    /* the simulated cut, whose wires are drawn */
    wcut_error error = {0};
    app_progress progress = app_progress_begin(app_given(o->call, "quiet"));
    wcut_status status = wcut_setup_create(o->job, NULL, &o->setup, &error);
    if (status == WCUT_OK) status = wcut_setup_run(o->setup, app_progress_step, &progress, &o->history, &error);
    app_progress_end(&progress);
    if (status != WCUT_OK) return app_fail_status(status, o->job_path, &error);

    /* the photograph over the wires */
    wcut_overlay_options options = wcut_overlay_options_default();
    options.upper = app_choice(o->call, "half") == 1;
    if (app_given(o->call, "resolution")) options.resolution = app_real(o->call, "resolution");
    options.patch = app_real(o->call, "patch");
    options.curves = app_int(o->call, "curves");
    options.threads = app_int(o->call, "threads");

    /* the picture against the wires, with progress */
    progress = app_progress_begin(app_given(o->call, "quiet"));
    progress.unit = "rows of patches";
    status = wcut_overlay_create(o->job->block_size, o->history, &o->camera, &o->report, o->photo, &options,
                                 app_progress_step, &progress, &o->overlay, &error);
    app_progress_end(&progress);
    if (status == WCUT_INTERRUPTED)
        return app_fail(APP_INTERRUPTED, "%s: interrupted; nothing was written", o->photo_path);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, o->photo_path, &error);
}

/* ---- the files ---- */

static int keep(overlaying *o, const char *name, wcut_status status, wcut_error *error) {
    return app_results_add(&o->results, name, status, error);
}

static int write_picture(overlaying *o, const wcut_picture *picture, double resolution, const char *name) {
    wcut_error error = {0};
    return keep(o, name, wcut_picture_write(picture, resolution, app_results_path(&o->results, name), &error), &error);
}

/* drawn over from above, cut out by phase, and in its own perspective */
static int write_drawings(overlaying *o) {
    /* the wires over the rectified picture */
    const wcut_overlay_style style = {.by_force = app_choice(o->call, "colour") == 0,
                                      .width = wcut_overlay_style_default().width};
    const wcut_vec3 block = o->job->block_size;
    wcut_picture *drawn = NULL, *details = NULL, *photo = NULL;
    wcut_status status = wcut_overlay_draw(o->overlay, block, o->history, &style, &drawn);
    int code = status == WCUT_OK ? write_picture(o, drawn, o->overlay->resolution, "overlay.png")
                                 : app_fail_status(status, "overlay", NULL);

    /* a cut without a wire in the block has no details */
    if (code == APP_DONE) {
        status = wcut_overlay_details(o->overlay, block, o->history, drawn, 6 * app_real(o->call, "patch"), &details);
        if (status == WCUT_OK)
            code = write_picture(o, details, o->overlay->resolution, "details.png");
        else if (status != WCUT_DEGENERATE)
            code = app_fail_status(status, "overlay", NULL);
    }

    /* the wires over the photograph itself */
    if (code == APP_DONE) {
        status = wcut_overlay_draw_photo(o->overlay, block, o->history, &style, &o->camera, o->photo, &photo);
        code = status == WCUT_OK ? write_picture(o, photo, 0, "overlay-photo.png")
                                 : app_fail_status(status, "overlay", NULL);
    }
    wcut_picture_destroy(drawn);
    wcut_picture_destroy(details);
    wcut_picture_destroy(photo);
    return code;
}

static int write_overlay(overlaying *o) {
    /* what all files show */
    wcut_error error = {0};
    const wcut_overlaid all = {.job = o->job_path,
                               .photo = o->photo_path,
                               .job_sha256 = o->hash[0][0] ? o->hash[0] : NULL,
                               .photo_sha256 = o->hash[1][0] ? o->hash[1] : NULL,
                               .block = o->job->block_size,
                               .source = &o->source,
                               .camera = &o->camera,
                               .report = &o->report,
                               .points = o->points,
                               .point = o->point,
                               .residual = o->residual,
                               .leave_one_out = o->left_out,
                               .history = o->history,
                               .overlay = o->overlay};
    /* pictures first, then what was measured in them */
    int code = write_picture(o, o->overlay->rectified, o->overlay->resolution, "rectified.png");
    if (code == APP_DONE)
        code = keep(o, "rectified.pgw",
                    wcut_world_write(o->overlay, all.block, app_results_path(&o->results, "rectified.pgw"), &error),
                    &error);
    if (code == APP_DONE) code = write_drawings(o);
    if (code == APP_DONE)
        code = keep(o, "overlay.svg",
                    wcut_overlay_svg_write(&all, "rectified.png", app_results_path(&o->results, "overlay.svg"), &error),
                    &error);

    /* the measured directions, and the page */
    if (code == APP_DONE)
        code = keep(o, "rills.csv", wcut_rills_write(o->overlay, app_results_path(&o->results, "rills.csv"), &error),
                    &error);
    if (code == APP_DONE)
        code = keep(o, "report.html",
                    wcut_report_overlay_write(&all, app_results_path(&o->results, "report.html"), &error), &error);
    if (code != APP_DONE) return code;

    /* overlay.json vouches for the others */
    char *text = NULL;
    const wcut_status status = wcut_overlay_print(&all, &text);
    return app_results_commit(&o->results, "overlay.json", status, text);
}

/* ---- the answer ---- */

static void say_overlay(const overlaying *o) {
    const wcut_overlay *v = o->overlay;
    const wcut_camera_report *r = &o->report;

    /* what was done to the picture before it was measured */
    if (o->source.orientation > 1)
        app_say("%s: EXIF orientation %d applied: the picture is %d x %d px", o->photo_path, o->source.orientation,
                o->photo->width, o->photo->height);
    if (o->source.profile) app_say("%s: the embedded colour profile was ignored", o->photo_path);
    if (o->source.depth == 16) app_say("%s: 16 bits a channel were reduced to 8", o->photo_path);

    /* the camera, and how well it meets its points */
    if (o->camera.kind == WCUT_CAMERA_KIND_PLANE)
        app_say(
            "warning: the points do not tell the focal length: the plane of the points is rectified, and the face's "
            "height above "
            "it shifts what is measured; give 6 points at two heights");
    else
        app_say("camera: focal length %.1f +- %.1f px, points met to %.2f px rms", o->camera.focal, 2 * r->focal_sigma,
                r->rms);
    if (r->suspect >= 0)
        app_say("warning: point %d is %.1f px from where the others put it: check that row", r->suspect + 1,
                o->left_out[r->suspect]);

    /* what the rills say */
    app_say("rectified: %.3g mm a pixel, %.0f %% of the face is seen", v->resolution, 100 * v->covered);
    if (v->readable == 0) {
        app_say("nothing readable: no rills were found in the picture");
        return;
    }

    /* the verdict */
    app_say("rills read in %d patches, %.0f %% of those seen; %d of %d wires differ from the simulation", v->readable,
            100 * v->readable_share, v->differing, v->curve_count);
}

static int overlay(const app_call *call) {
    overlaying o = {.call = call, .job_path = call->operand[0], .photo_path = call->operand[1]};

    /* inputs and folder, before the simulation */
    int code = load_overlay(&o);
    if (code == APP_DONE) code = app_results_begin(&o.results, app_text(call, "output"), result_name);
    if (code == APP_DONE) {
        /* simulate, measure, write; then figures for people and for programs */
        app_catch_interrupts();
        code = run_overlay(&o);
        if (code == APP_DONE) code = write_overlay(&o);
        if (code == APP_DONE && !app_given(call, "quiet")) {
            say_overlay(&o);
            app_say("in %s: %s", o.results.folder, app_results_list(&o.results));
        }
        if (code == APP_DONE && app_given(call, "json")) fputs(o.results.text, stdout);
    }
    app_results_end(&o.results);

    /* everything that was made, also after a failure */
    wcut_overlay_destroy(o.overlay);
    free(o.left_out);
    free(o.residual);
    free(o.point);
    wcut_picture_destroy(o.photo);
    wcut_history_destroy(o.history);
    wcut_setup_destroy(o.setup);
    wcut_job_destroy(o.job);
    return code;
}

/* ---- the table ---- */

static double overlay_patch(void) { return wcut_overlay_options_default().patch; }
static double overlay_curves(void) { return wcut_overlay_options_default().curves; }

static const app_operand operand[] = {
    {.name = "JOB", .kind = APP_FILE, .help = "a job file, wirecut-job/1"},
    {.name = "PHOTO", .kind = APP_FILE, .help = "a photograph of the cut face, PNG or JPEG, lit from a low angle"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    {.kind = APP_FILE,
     .name = "points",
     .value = "FILE",
     .help = "CSV file u_px, v_px, x_mm, y_mm, z_mm: points of the picture and their places on the block; 4 or 5 of "
             "one plane, or 6 "
             "and more at different heights"},
    {.kind = APP_TEXT,
     .name = "corners",
     .value = "LIST",
     .help = "instead of points: u1,v1,u2,v2,u3,v3,u4,v4 of the upper face's corners in the order drawn above"},
    {.kind = APP_CHOICE,
     .name = "half",
     .value = "lower|upper",
     .standard = "lower",
     .help = "which half is in the picture: lower, seen from above, or upper, seen from below"},
    {.kind = APP_REAL,
     .name = "resolution",
     .value = "MM",
     .low = 1e-3,
     .high = 100,
     .help = "size of a pixel of the rectified picture, mm; the picture's own where none is given"},
    {.kind = APP_REAL,
     .name = "patch",
     .value = "MM",
     .low = 1,
     .high = 1000,
     .library = overlay_patch,
     .help = "side of a patch in which the rills are averaged, mm"},
    {.kind = APP_INT,
     .name = "curves",
     .value = "N",
     .low = 1,
     .high = 1000,
     .library = overlay_curves,
     .help = "number of wires that are drawn and measured"},
    {.kind = APP_CHOICE,
     .name = "colour",
     .value = "force|phase",
     .standard = "force",
     .help = "colour of the wires: force of the foam, or phase of the cut"},
    {.kind = APP_INT,
     .name = "threads",
     .value = "N",
     .low = 1,
     .high = 256,
     .standard = "1",
     .help = "number of threads; no result depends on it"},
    APP_OPTION_EDGES,
    APP_OPTION_STATIONS,
    APP_OPTION_NODES,
    APP_OPTION_FORCE_LAW,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_overlay = {
    .name = "overlay",
    .brief = "lay a photograph of the cut face over the simulated wire",
    .about =
        "Finds the camera from points whose places on the block are known, brings the photograph onto the simulated "
        "face, and "
        "compares the direction of the rills that the wire left with the simulated wire. Writes into DIR: "
        "rectified.png (seen "
        "from above, with rectified.pgw that places it in mm), overlay.png and overlay.svg (with wires), "
        "overlay-photo.png (in "
        "its own perspective), details.png (entry, steady cut and exit side by side), rills.csv (a row a patch), "
        "report.html and "
        "overlay.json, which is written last and lists the files.\n"
        "Pixels are counted from the centre of the picture's first pixel, u to the right, v down, in the picture as "
        "viewers show it.\n"
        "Corners of the block's upper face, seen from above with the feed to the top: 4 (0, L) and 3 (W, L) above, 1 "
        "(0, 0) and 2 "
        "(W, 0) below.\n"
        "A picture without rills is no failure: the answer is \"nothing readable\".",
    .operand = operand,
    .option = option,
    .run = overlay,
};
