/* The picture of kernel/convergence.svg: heun and implicit against the distance of stations on a block 400 mm wide.

   bench_convergence [FILE.svg]   (default convergence.svg; prints its numbers)

   Left: the mounts' speed along the cut. Right: error of the angle alpha in the middle of the exit, against implicit
   with stations 1 and 0.5 mm apart, extrapolated. */
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/cut.h>
#include <wirecut/history.h>
#include <wirecut/job.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* the cut begins in the foam, where the wire hangs under an even load: at first contact heun ends with short steps */
#define FROM 100.0
#define TO 1180.0
#define WATCHED 1000.0 /* [mm] where the error is taken */

enum { MAX = 2300, STEPS = 10 };

typedef struct run { /* what one run said: y of the mounts, speed, alpha */
    int stations, reached;
    double y[MAX], speed[MAX], alpha[MAX];
} run;

static double smooth(double t) {
    t = clamp(t, 0, 1);
    return t * t * t * (10 + t * (6 * t - 15));
}

/* the entry-steady-exit cut of samples/make_jobs.py, 400 mm and 60 W/m, its path at any distance of stations */
static wcut_job *make_job(double step) {
    const double p = tan(32 * WCUT_PI / 180), depth = 1200, entry = 300;
    wcut_job *job = NULL;
    if (wcut_job_create(&job) != WCUT_OK) exit(EXIT_FAILURE);
    job->block_size = vec3(400, depth, 300);
    job->wire_diameter = 0.15;
    job->wire_length = 200 * (hypot(1, p) + asinh(p) / p) + 2 * 60 * hypot(1, p);
    job->nodes = 121;
    job->heat = 60;
    job->tension = 2;
    job->force_law = (wcut_force_law){.a = 0.1, .b = 8.6e-4};
    job->stations = 1 + (int)lround((TO - FROM) / step);
    job->mount_a = wcut_alloc((size_t)job->stations, sizeof *job->mount_a);
    job->mount_b = wcut_alloc((size_t)job->stations, sizeof *job->mount_b);
    if (!job->mount_a || !job->mount_b) exit(EXIT_FAILURE);
    const double straight = (job->wire_length / 1.0005 - 400) / 2;
    for (int j = 0; j < job->stations; j++) {
        const double y = FROM + step * j, bent = smooth(y / entry) - smooth((y - depth + entry) / entry);
        const double out = straight + bent * (60 - straight);
        job->mount_a[j] = vec3(-out, y, 150);
        job->mount_b[j] = vec3(400 + out, y, 150);
    }
    return job;
}

static run *cut(double step, wcut_integrator integrator) {
    wcut_job *job = make_job(step);
    wcut_cut_options options = wcut_cut_options_default();
    options.integrator = integrator;
    wcut_setup *setup = NULL;
    wcut_history *h = NULL;
    wcut_error error = {0};
    if (wcut_setup_create(job, &options, &setup, &error) == WCUT_OK) wcut_setup_run(setup, NULL, NULL, &h, &error);
    run *r = calloc(1, sizeof *r);
    if (!h || !r) {
        fprintf(stderr, "bench_convergence: %s\n", error.text);
        exit(EXIT_FAILURE);
    }
    if (error.text[0])
        fprintf(stderr, "%g mm, %s: %s\n", step, integrator == WCUT_INTEGRATOR_HEUN ? "heun" : "implicit", error.text);
    r->stations = job->stations, r->reached = h->stations;
    for (int j = 0; j < h->stations; j++) {
        r->y[j] = job->mount_a[j].y;
        r->speed[j] = h->row[j].speed_a;
        r->alpha[j] = (h->row[j].alpha_a + h->row[j].alpha_b) / 2 * 180 / WCUT_PI;
    }
    wcut_history_destroy(h);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
    return r;
}

/* alpha at the watched place; NAN where the run did not get there */
static double watched(const run *r) {
    for (int j = 0; j < r->reached; j++)
        if (fabs(r->y[j] - WATCHED) < 1e-6) return r->alpha[j];
    return NAN;
}

/* ---- drawing ---- */

typedef struct panel { /* data to picture */
    double left, top, width, height;
    double x0, x1, y0, y1;
    int logarithmic;
} panel;

static double at_x(const panel *p, double x) {
    if (p->logarithmic) return p->left + p->width * log(x / p->x0) / log(p->x1 / p->x0);
    return p->left + p->width * (x - p->x0) / (p->x1 - p->x0);
}

static double at_y(const panel *p, double y) {
    const double t = p->logarithmic ? log(y / p->y0) / log(p->y1 / p->y0) : (y - p->y0) / (p->y1 - p->y0);
    return p->top + p->height * (1 - t);
}

static void label(FILE *f, double x, double y, const char *anchor, const char *class_name, const char *text) {
    fprintf(f, "<text x='%.1f' y='%.1f' text-anchor='%s' class='%s'>%s</text>\n", x, y, anchor, class_name, text);
}

static void frame(FILE *f, const panel *p, const char *title, const char *across, const char *up, int nx,
                  const double *tick_x, int ny, const double *tick_y) {
    char text[40];
    for (int k = 0; k < ny; k++) {
        const double y = at_y(p, tick_y[k]);
        fprintf(f, "<path class='grid' d='M%.1f %.1fh%.1f'/>\n", p->left, y, p->width);
        snprintf(text, sizeof text, "%g", tick_y[k]);
        label(f, p->left - 8, y + 4, "end", "tick", text);
    }
    for (int k = 0; k < nx; k++) {
        const double x = at_x(p, tick_x[k]);
        fprintf(f, "<path class='axis' d='M%.1f %.1fv5'/>\n", x, p->top + p->height);
        snprintf(text, sizeof text, "%g", tick_x[k]);
        label(f, x, p->top + p->height + 20, "middle", "tick", text);
    }
    fprintf(f, "<path class='axis' d='M%.1f %.1fh%.1f'/>\n", p->left, p->top + p->height, p->width);
    label(f, p->left, p->top - 34, "start", "title", title);
    label(f, p->left, p->top - 14, "start", "unit", up);
    label(f, p->left + p->width, p->top + p->height + 42, "end", "unit", across);
}

static void draw_speed(FILE *f, const panel *p, const run *r, const char *class_name) {
    fprintf(f, "<path class='%s' clip-path='url(#speed)' d='", class_name);
    int first = 1;
    for (int j = 1; j < r->reached; j++) {
        if (r->y[j] < FROM + 5) continue; /* the first steps shape the wire that hung before */
        fprintf(f, "%c%.1f %.1f", first ? 'M' : 'L', at_x(p, r->y[j]), at_y(p, r->speed[j]));
        first = 0;
    }
    fprintf(f, "'/>\n");
}

static void draw_error(FILE *f, const panel *p, int n, const double *step, const double *error,
                       const char *class_name) {
    fprintf(f, "<path class='%s' d='", class_name);
    int first = 1;
    for (int k = 0; k < n; k++) {
        if (!isfinite(error[k])) continue;
        fprintf(f, "%c%.1f %.1f", first ? 'M' : 'L', at_x(p, step[k]), at_y(p, clamp(error[k], p->y0, p->y1)));
        first = 0;
    }
    fprintf(f, "'/>\n");
    for (int k = 0; k < n; k++)
        if (isfinite(error[k]))
            fprintf(f, "<circle class='%s dot' cx='%.1f' cy='%.1f' r='4'/>\n", class_name, at_x(p, step[k]),
                    at_y(p, clamp(error[k], p->y0, p->y1)));
}

static const char *const style =
    "<style>text{font:13px system-ui,-apple-system,'Segoe "
    "UI',sans-serif;fill:#333;paint-order:stroke;stroke:#fff;stroke-width:4px;stroke-linejoin:round}.title{font-size:"
    "16px;font-weight:600;"
    "fill:#111}.unit,.tick{fill:#555}.grid{stroke:#e4e4e4;fill:none}.axis{stroke:#888;fill:none}"
    ".implicit,.fine,.heun9,.heun4,.heun,.guide{fill:none;stroke-linejoin:round;stroke-width:2.2}"
    ".implicit{stroke:#0072b2}.fine{stroke:#0072b2;stroke-width:6;opacity:.28}"
    ".heun9{stroke:#d55e00}.heun4{stroke:#7a2d00;stroke-width:1.3}.heun{stroke:#d55e00}"
    ".guide{stroke:#999;stroke-width:1.2;stroke-dasharray:5 4}.dot{stroke:#fff;stroke-width:1.5}"
    "circle.implicit{fill:#0072b2}circle.heun{fill:#d55e00}"
    ".t-implicit{fill:#00588a;font-weight:600}.t-9{fill:#b04e00;font-weight:600}"
    ".t-4{fill:#7a2d00;font-weight:600}.t-guide{fill:#777}</style>\n";

int main(int argc, char **argv) {
    const char *path = argc > 1 ? argv[1] : "convergence.svg";
    const double step[STEPS] = {45, 36, 20, 12, 9, 6, 4, 3, 2, 1};
    run *heun[STEPS], *implicit[STEPS];
    double error[2][STEPS];
    run *fine = cut(0.5, WCUT_INTEGRATOR_IMPLICIT);
    run *half = cut(1, WCUT_INTEGRATOR_IMPLICIT);
    const double exact = 2 * watched(fine) - watched(half);
    free(half);
    printf(
        "alpha at y = %g mm: %.6f deg (implicit, 1 and 0.5 mm, extrapolated)\nstation distance  implicit     heun  "
        "[deg off]\n",
        WATCHED, exact);
    for (int k = 0; k < STEPS; k++) {
        heun[k] = cut(step[k], WCUT_INTEGRATOR_HEUN);
        implicit[k] = cut(step[k], WCUT_INTEGRATOR_IMPLICIT);
        error[0][k] = fabs(watched(implicit[k]) - exact);
        error[1][k] = fabs(watched(heun[k]) - exact);
        printf("%13g mm  %8.5f  %8.5f   heun reached %d of %d stations\n", step[k], error[0][k], error[1][k],
               heun[k]->reached, heun[k]->stations);
    }
    FILE *f = fopen(path, "w");
    if (!f) return EXIT_FAILURE;
    fprintf(f,
            "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1080 470' width='1080' height='470' role='img' "
            "aria-label='Speed along a cut and error against the distance of stations, for both integrators'>\n"
            "<rect width='1080' height='470' fill='#fff'/>\n");
    fputs(style, f);
    const panel s = {.left = 62, .top = 76, .width = 440, .height = 320, .x0 = 100, .x1 = 1200, .y0 = 0, .y1 = 40};
    const panel e = {.left = 620,
                     .top = 76,
                     .width = 400,
                     .height = 320,
                     .x0 = 0.8,
                     .x1 = 60,
                     .y0 = 1e-3,
                     .y1 = 100,
                     .logarithmic = 1};
    fprintf(f, "<clipPath id='speed'><rect x='%g' y='%g' width='%g' height='%g'/></clipPath>\n", s.left, s.top, s.width,
            s.height);
    frame(f, &s, "Along the cut", "position of the mounts y, mm", "speed of the mounts, mm/s", 6,
          (const double[]){200, 400, 600, 800, 1000, 1200}, 5, (const double[]){0, 10, 20, 30, 40});
    draw_speed(f, &s, fine, "fine");
    draw_speed(f, &s, heun[6], "heun4");
    draw_speed(f, &s, heun[4], "heun9");
    draw_speed(f, &s, implicit[1], "implicit");
    label(f, at_x(&s, 760), at_y(&s, 23.5), "middle", "t-implicit", "implicit, 36 mm (thin) and 0.5 mm");
    label(f, at_x(&s, 500), at_y(&s, 12.2), "middle", "t-9", "heun, 9 mm: sways");
    label(f, at_x(&s, 330), at_y(&s, 34), "start", "t-4", "heun, 4 mm: collapses");
    frame(f, &e, "Error in the exit", "distance of stations, mm", "error of the mounts' angle at y = 1000 mm, deg", 7,
          (const double[]){1, 2, 4, 8, 16, 32, 48}, 6, (const double[]){1e-3, 1e-2, 0.1, 1, 10, 100});
    fprintf(f, "<path class='guide' d='M%.1f %.1fL%.1f %.1f'/>\n", at_x(&e, 1), at_y(&e, 4e-3), at_x(&e, 32),
            at_y(&e, 0.128));
    draw_error(f, &e, STEPS, step, error[1], "heun");
    draw_error(f, &e, STEPS, step, error[0], "implicit");
    label(f, at_x(&e, 1), at_y(&e, 48), "start", "t-9", "heun (at 2 mm the run ends early)");
    label(f, at_x(&e, 3.2), at_y(&e, 0.028), "end", "t-implicit", "implicit");
    label(f, at_x(&e, 9), at_y(&e, 0.019), "start", "t-guide", "order one");
    fprintf(f, "</svg>\n");
    const int bad = ferror(f);
    return fclose(f) != 0 || bad ? EXIT_FAILURE : EXIT_SUCCESS;
}
