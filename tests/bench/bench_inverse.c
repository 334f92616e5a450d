/* From targets to cuts: how near they come, and what it takes (kernel/MEASURED.md).

   bench_inverse [targets | NAME | hidden COUNT | cloud | panels N | cost | compensation] ...; seconds are of the processor. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <wirecut/wirecut.h>

#include "cut/sensitivity.h"
#include "cut/setup.h"
#include "inverse/feet.h"
#include "inverse/target.h"

#define PI 3.14159265358979323846

enum { GRID_X = 41, GRID_Y = 61 };
static const wcut_vec3 block = {400, 600, 300};
static int stations = 241, nodes = 121;

static double seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t); /* the machine is shared: what this process took */
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* a number of the environment, or the standard */
static int setting(const char *name, int standard) {
    const char *text = getenv(name);
    return text ? atoi(text) : standard;
}

/* ---- targets: heights over the block ---- */

static double saddle(double x, double y) { return 150 + 5e-4 * ((x - 200) * (x - 200) - (y - 300) * (y - 300)) * 0.8; }

/* Enneper's surface, size 600, solved for its parameters over x, y */
static double enneper(double x, double y) {
    const double size = 600, px = (x - 200) / size, py = (y - 300) / size;
    double u = px, v = py;
    for (int k = 0; k < 50; k++) {
        const double fx = u - u * u * u / 3 + u * v * v - px, fy = v - v * v * v / 3 + v * u * u - py;
        const double a = 1 - u * u + v * v, b = 2 * u * v, d = 1 - v * v + u * u, det = a * d - b * b;
        u -= (fx * d - fy * b) / det, v -= (fy * a - fx * b) / det;
    }
    return 150 + size * (u * u - v * v);
}

/* the inner side of a torus about the y axis of the block's middle: radii 700 and 500 */
static double torus(double x, double y) {
    const double ring = 700, tube = 900;
    const double r = ring + tube - sqrt(tube * tube - (y - 300) * (y - 300));
    return 150 - ring + 60 + sqrt(r * r - (x - 200) * (x - 200)) - 60;
}
static double hypar(double x, double y) { return 150 + 6e-4 * (x - 200) * (y - 300); }
static double helicoid(double x, double y) { return 150 + (x - 200) * tan(0.5 * (y - 300) / 600); }
static double cone(double x, double y) { return 150 + 0.15 * (y - 300) * (0.5 + x / 800) + 0.0 * x; }
static double waves(double x, double y) { return 150 + 25 * sin(2 * PI * y / 400) + 0 * x; }
static double monkey(double x, double y) {
    const double u = (x - 200) / 200, v = (y - 300) / 200;
    return 150 + 15 * (u * u * u - 3 * u * v * v);
}
static double sines(double x, double y) { return 150 + 20 * sin(2 * PI * x / 400) * sin(2 * PI * y / 400); }
static double sphere(double x, double y) {
    return 150 - 1000 + sqrt(1e6 - (x - 200) * (x - 200) - (y - 300) * (y - 300)) + 50;
}

typedef double (*height)(double, double);
static const struct {
    const char *name;
    height z;
    double wanted[2]; /* [mm] rms with free edges, with fixed ones; 0: none */
} known[] = {{"saddle", saddle, {0.10, 0.17}}, {"enneper", enneper, {0.12, 0.25}},   {"torus", torus, {0.16, 0.36}},
             {"hypar", hypar, {0.06, 0.10}},   {"helicoid", helicoid, {0.06, 0.10}}, {"cone", cone, {0.06, 0.10}},
             {"waves", waves, {0.06, 0.10}},   {"monkey", monkey, {2.4, 4.1}},       {"sines", sines, {6.0, 9.8}},
             {"sphere", sphere, {5.9, 14.6}}};
enum { KNOWN = sizeof known / sizeof *known };

static wcut_surface *surface_of(height z) {
    wcut_vec3 *grid = calloc(GRID_X * GRID_Y, sizeof *grid);
    wcut_surface *surface = NULL;
    for (int j = 0; j < GRID_Y; j++)
        for (int i = 0; i < GRID_X; i++) {
            const double x = -40 + 480.0 * i / (GRID_X - 1), y = -60 + 720.0 * j / (GRID_Y - 1);
            grid[j * GRID_X + i] = (wcut_vec3){x, y, z(x, y)};
        }
    if (wcut_surface_loft(GRID_Y, GRID_X, grid, 1e-3, &surface, NULL, NULL) != WCUT_OK) exit(1);
    free(grid);
    return surface;
}

static wcut_job *process(void) {
    wcut_job *job;
    if (wcut_job_create(&job) != WCUT_OK) exit(1);
    job->block_size = block;
    job->wire_diameter = 0.15;
    job->nodes = nodes, job->stations = stations;
    job->heat = 65, job->tension = 2;
    job->force_law = (wcut_force_law){.a = 0.1, .b = 8.6e-4};
    job->clearance = 80;
    return job;
}

static int say_round(const wcut_design_round *r, void *context) {
    (void)context;
    if (getenv("SAY"))
        printf("    %d x %d, %d unknowns, %d runs: %.4f mm rms, %.3f max\n", r->stations, r->nodes, r->unknowns,
               r->runs, r->rms, r->max);
    return 0;
}

static void show(const char *name, const wcut_design_target *target, const wcut_design_options *o, double wanted) {
    wcut_job *job = process();
    wcut_design *d = NULL;
    wcut_error error = {0};
    const double start = seconds();
    const wcut_status status = wcut_design_fit(target, job, o, say_round, NULL, &d, &error);
    if (status == WCUT_OK)
        printf(
            "%-12s %-5s feed %s start %8.3f rms %8.4f max %8.3f (wanted %.2f)%s path %.3f (unpolished %.3f) %d runs "
            "%5.2f s, uncovered %d of %d\n",
            name, o->free_edges ? "free" : "fixed", wcut_design_feed_name(d->feed), d->start_rms, d->rms, d->max,
            wanted, d->rms <= wanted ? "" : " **", d->path_rms, d->unpolished_rms, d->runs, seconds() - start,
            d->uncovered, d->used + d->uncovered);
    else
        printf("%-12s failed: %s\n", name, error.text);
    fflush(stdout);
    wcut_design_destroy(d);
    wcut_job_destroy(job);
}

static void show_target(int k) {
    wcut_surface *surface = surface_of(known[k].z);
    wcut_design_target *target = NULL;
    wcut_error error = {0};
    if (wcut_design_target_from_surface(surface, block, &target, &error) != WCUT_OK) {
        printf("%s: %s\n", known[k].name, error.text);
    } else {
        wcut_design_options o = wcut_design_options_default();
        o.threads = setting("THREADS", 1);
        show(known[k].name, target, &o, known[k].wanted[0]);
        o.free_edges = 0;
        if (!setting("FREE_ONLY", 0)) show(known[k].name, target, &o, known[k].wanted[1]);
    }
    wcut_design_target_destroy(target);
    wcut_surface_destroy(surface);
}

/* ---- hidden designs: random edges, lag and extra length, and back from their surfaces ---- */

static unsigned long long seed = 1;

static double uniform(double low, double high) {
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}

enum { CURVE = 7 };

static wcut_job *hidden_job(void) {
    wcut_job *job = process();
    wcut_vec3 a[CURVE], b[CURVE];
    const double lag = uniform(-60, 60), turn = uniform(-60, 60);
    for (int k = 0; k < CURVE; k++) {
        const double t = k / (CURVE - 1.0), y = -140 + 900 * t, ahead = (lag + turn * t) / 2;
        a[k] = (wcut_vec3){0, y + ahead, 150 + uniform(-35, 35)};
        b[k] = (wcut_vec3){block.x, y - ahead, 150 + uniform(-35, 35)};
    }
    job->mode = WCUT_MODE_DESIGN;
    job->overrun = block.x; /* edges go on behind the block */
    if (wcut_curve_interpolate(CURVE, a, &job->edge_a) != WCUT_OK) exit(1);
    if (wcut_curve_interpolate(CURVE, b, &job->edge_b) != WCUT_OK) exit(1);
    job->extra_count = 5;
    job->extra_u = calloc(5, sizeof(double)), job->extra_length = calloc(5, sizeof(double));
    if (!job->extra_u || !job->extra_length) exit(1);
    for (int k = 0; k < 5; k++) job->extra_u[k] = k / 4.0, job->extra_length[k] = uniform(12, 45);
    return job;
}

static void show_hidden(int count) {
    int found = 0, tried = 0, started = 0;
    double slowest = 0;
    for (int k = 0; k < count; k++) {
        wcut_job *job = hidden_job();
        const wcut_cut_options cut = wcut_cut_options_default();
        wcut_setup *plan = NULL;
        wcut_history *history = NULL;
        wcut_surface *surface = NULL;
        wcut_design_target *target = NULL;
        wcut_design *d = NULL;
        wcut_error error = {0};
        wcut_status status = wcut_plan_create(job, &cut, &plan, &error);
        if (status == WCUT_OK) status = wcut_setup_run(plan, NULL, NULL, &history, &error);
        if (status == WCUT_OK)
            status =
                wcut_surface_loft(history->stations, history->nodes, history->position, 1e-3, &surface, NULL, NULL);
        if (status == WCUT_OK) status = wcut_design_target_from_surface(surface, block, &target, &error);
        if (status == WCUT_OK) {
            wcut_design_options o = wcut_design_options_default();
            wcut_job *base = process();
            o.feed = WCUT_DESIGN_FEED_PLUS_Y, o.tolerance = 1e-3;
            const double start = seconds();
            status = wcut_design_fit(target, base, &o, say_round, NULL, &d, &error);
            const double spent = seconds() - start;
            tried++;
            if (status == WCUT_OK) {
                found += d->rms <= 0.005, started += d->start_rms <= 0.5;
                slowest = fmax(slowest, spent);
                printf("hidden %d: start %.3f, plan %.4f mm rms, path %.4f, %d runs, %.2f s\n", k, d->start_rms, d->rms,
                       d->path_rms, d->runs, spent);
            }
            wcut_job_destroy(base);
        }
        if (status != WCUT_OK) printf("hidden %d: %s\n", k, error.text);
        fflush(stdout);
        wcut_design_destroy(d);
        wcut_design_target_destroy(target);
        wcut_surface_destroy(surface);
        wcut_history_destroy(history);
        wcut_setup_destroy(plan);
        wcut_job_destroy(job);
    }
    printf("hidden: %d of %d within 0.005 mm, %d starts within 0.5 mm, slowest %.2f s\n", found, tried, started,
           slowest);
}

/* ---- a cloud: 5000 points, 0.2 mm of noise, a hole, 1 % strays ---- */

static double normal_deviate(void) {
    double sum = -6;
    for (int k = 0; k < 12; k++) sum += uniform(0, 1);
    return sum;
}

/* [mm] rms of an exact target from the plan of a job */
static double plan_off(const wcut_job *job, const wcut_design_target *exact) {
    const wcut_cut_options cut = wcut_cut_options_default();
    wcut_setup *plan = NULL;
    wcut_history *h = NULL;
    wcut_wire_foot *foot = calloc((size_t)exact->count, sizeof *foot);
    double sum = 0;
    int used = 0;
    if (wcut_plan_create(job, &cut, &plan, NULL) != WCUT_OK) exit(1);
    if (wcut_setup_run(plan, NULL, NULL, &h, NULL) != WCUT_OK) exit(1);
    const wcut_wire_face face = {h->stations, h->nodes, h->position};
    wcut_wire_feet(&face, exact->count, exact->point, false, 1, foot);
    for (int k = 0; k < exact->count; k++)
        if (!(foot[k].beside > 0)) sum += foot[k].height * foot[k].height, used++;
    free(foot);
    wcut_history_destroy(h);
    wcut_setup_destroy(plan);
    return sqrt(sum / used);
}

static void show_cloud(int known_target) {
    enum { POINTS = 5000 };
    wcut_vec3 *point = calloc(POINTS, sizeof *point);
    for (int k = 0; k < POINTS;) {
        const double x = uniform(0, block.x), y = uniform(0, block.y);
        if (hypot(x - 150, y - 350) < 50) continue;
        point[k] = (wcut_vec3){x, y, known[known_target].z(x, y) + 0.2 * normal_deviate()};
        if (k % 100 == 0) point[k].z += (k % 200 ? 1 : -1) * uniform(5, 15);
        k++;
    }
    wcut_design_target *target = NULL;
    wcut_error error = {0};
    if (wcut_design_target_from_points(POINTS, point, block, &target, &error) != WCUT_OK) {
        printf("cloud: %s\n", error.text);
    } else {
        wcut_job *job = process();
        wcut_design_options o = wcut_design_options_default();
        wcut_design *d = NULL;
        wcut_surface *surface = surface_of(known[known_target].z);
        wcut_design_target *exact = NULL;
        double rms = NAN, max = NAN;
        const double start = seconds();
        if (wcut_design_fit(target, job, &o, say_round, NULL, &d, &error) != WCUT_OK) printf("cloud: %s\n", error.text);
        if (d && wcut_design_target_from_surface(surface, block, &exact, &error) == WCUT_OK)
            wcut_compensation_measure(exact, d->path, 1, &rms, &max, &error);
        if (d)
            printf(
                "cloud of %s: %.3f mm rms of its points, %d strays; true surface from the plan %.4f rms, from the path "
                "%.4f "
                "rms, %.3f max, %.2f s\n",
                known[known_target].name, d->rms, d->strays, exact ? plan_off(d->job, exact) : NAN, rms, max,
                seconds() - start);
        wcut_design_target_destroy(exact);
        wcut_surface_destroy(surface);
        wcut_design_destroy(d);
        wcut_job_destroy(job);
    }
    wcut_design_target_destroy(target);
    free(point);
}

/* ---- panels ---- */

/* a bicubic patch over random heights: control heights of +-30 mm */
static double bicubic(double x, double y) {
    static double control[16];
    if (control[0] == 0) {
        unsigned long long kept = seed;
        seed = 7;
        for (int k = 0; k < 16; k++) control[k] = uniform(-30, 30);
        seed = kept;
    }
    const double t[2] = {x / block.x, y / block.y};
    double b[2][4];
    for (int d = 0; d < 2; d++) {
        const double r = 1 - t[d];
        b[d][0] = r * r * r, b[d][1] = 3 * t[d] * r * r, b[d][2] = 3 * t[d] * t[d] * r, b[d][3] = t[d] * t[d] * t[d];
    }
    double z = 150;
    for (int k = 0; k < 16; k++) z += b[1][k / 4] * b[0][k % 4] * control[k];
    return z;
}

static void show_panels(int most) {
    static const struct {
        const char *name;
        height z;
        double held;
    } shape[] = {{"bicubic", bicubic, 0.5}, {"sines", sines, 0.25}, {"sphere", sphere, 0.42}};
    for (int k = 0; k < 3; k++) {
        wcut_surface *surface = surface_of(shape[k].z);
        wcut_design_target *target = NULL;
        wcut_design_panels *p = NULL;
        wcut_error error = {0};
        wcut_job *job = process();
        wcut_design_options o = wcut_design_options_default();
        const double start = seconds();
        o.tolerance = shape[k].held;
        wcut_status status = wcut_design_target_from_surface(surface, block, &target, &error);
        if (status == WCUT_OK)
            status = wcut_design_panels_fit(target, job, &o, most, shape[k].held, say_round, NULL, &p, &error);
        double step = 0, angle = 0;
        for (int n = 0; p && n < p->joints; n++)
            step = fmax(step, p->joint[n].step_max), angle = fmax(angle, p->joint[n].angle_max);
        if (p)
            printf(
                "%s: %d across, %d along: %.3f mm rms, %.2f max (held: %.2f); step %.2f mm, angle %.2f deg at most; %d "
                "runs, %.1f s\n",
                shape[k].name, p->across, p->along, p->rms, p->max, shape[k].held, step, angle * 180 / PI, p->runs,
                seconds() - start);
        else
            printf("%s: %s (%s)\n", shape[k].name, error.text, wcut_status_text(status));
        fflush(stdout);
        wcut_design_panels_destroy(p);
        wcut_job_destroy(job);
        wcut_design_target_destroy(target);
        wcut_surface_destroy(surface);
    }
}

/* ---- what derivatives cost ---- */

static void show_cost(void) {
    enum { UNKNOWNS = 24 };
    wcut_job *job = hidden_job();
    const wcut_cut_options cut = wcut_cut_options_default();
    wcut_setup *plan = NULL;
    if (wcut_plan_create(job, &cut, &plan, NULL) != WCUT_OK) exit(1);
    const size_t m = (size_t)plan->stations, n = (size_t)job->nodes;
    wcut_vec3 *by_a = calloc(UNKNOWNS * m, sizeof *by_a), *by_b = calloc(UNKNOWNS * m, sizeof *by_b);
    double *by_length = calloc(UNKNOWNS * m, sizeof *by_length);
    wcut_vec3 *by = calloc(UNKNOWNS * m * n, sizeof *by);
    for (size_t k = 0; k < UNKNOWNS; k++)
        for (size_t j = 0; j < m; j++) {
            const double bump = exp(-pow(((double)j / (double)m - (double)(k % 6) / 6) / 0.1, 2));
            by_a[k * m + j] = (wcut_vec3){0, k / 6 == 1 ? bump : 0, k / 6 == 0 ? bump : 0};
            by_b[k * m + j] = (wcut_vec3){0, 0, k / 6 == 2 ? bump : 0};
            by_length[k * m + j] = k / 6 == 3 ? bump : 0;
        }
    double spent[2] = {HUGE_VAL, HUGE_VAL};
    const wcut_end_motion motion = {UNKNOWNS, (int)m, by_a, by_b, by_length, 1, 0};
    for (int turn = 0; turn < 3; turn++) {
        wcut_history *history = NULL;
        double start = seconds();
        if (wcut_setup_run(plan, NULL, NULL, &history, NULL) != WCUT_OK) exit(1);
        spent[0] = fmin(spent[0], seconds() - start);
        wcut_history_destroy(history);
        start = seconds();
        if (wcut_setup_differentiate(plan, &motion, by, &history, NULL) != WCUT_OK) exit(1);
        spent[1] = fmin(spent[1], seconds() - start);
        wcut_history_destroy(history);
    }
    printf("derivatives by %d unknowns: %.3f s, a plain run %.3f s: %.2f plain runs\n", (int)UNKNOWNS, spent[1],
           spent[0], spent[1] / spent[0]);
    free(by_a);
    free(by_b);
    free(by_length);
    free(by);
    wcut_setup_destroy(plan);
    wcut_job_destroy(job);
}

/* ---- compensation of single effects on a curved cut ---- */

static wcut_job *curved_job(void) {
    wcut_job *job = process();
    const int m = stations;
    job->stations = m;
    job->wire_length = 640;
    job->mount_a = calloc((size_t)m, sizeof *job->mount_a);
    job->mount_b = calloc((size_t)m, sizeof *job->mount_b);
    if (!job->mount_a || !job->mount_b) exit(1);
    for (int j = 0; j < m; j++) {
        const double t = j / (m - 1.0), y = -120 + 900 * t;
        job->mount_a[j] = (wcut_vec3){-80, y, 150 + 25 * sin(5 * t)};
        job->mount_b[j] = (wcut_vec3){480, y, 150 + 20 * sin(4 * t + 1)};
    }
    return job;
}

static void show_compensation(void) {
    static const struct {
        const char *name;
        wcut_effect_kind kind;
        int choice;
        double value;
    } effect[] = {{"elongation", WCUT_EFFECT_WIRE_ELONGATION, 0, 4e-3},
                  {"compliance 1 N/mm", WCUT_EFFECT_MOUNT_COMPLIANCE, 0, 1},
                  {"kerf growth", WCUT_EFFECT_KERF_GROWTH, 0, 1.6e-4},
                  {"springback, choice 0", WCUT_EFFECT_BLOCK_SPRINGBACK, 0, 3},
                  {"springback, choice 1", WCUT_EFFECT_BLOCK_SPRINGBACK, 1, 3},
                  {"density across", WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0, 0.4}};
    wcut_job *job = curved_job();
    wcut_setup *setup = NULL;
    wcut_history *history = NULL;
    wcut_surface *surface = NULL;
    wcut_design_target *target = NULL;
    wcut_error error = {0};
    wcut_status status = wcut_setup_create(job, NULL, &setup, &error);
    if (status == WCUT_OK) status = wcut_setup_run(setup, NULL, NULL, &history, &error);
    if (status == WCUT_OK)
        status = wcut_surface_loft(history->stations, history->nodes, history->position, 1e-3, &surface, NULL, NULL);
    if (status == WCUT_OK) status = wcut_design_target_from_surface(surface, block, &target, &error);
    if (status != WCUT_OK) printf("compensation: %s\n", error.text);
    job->effect = calloc(1, sizeof *job->effect);
    for (size_t k = 0; status == WCUT_OK && k < sizeof effect / sizeof *effect; k++) {
        wcut_compensation *c = NULL;
        job->effect[0] = wcut_effect_choose(effect[k].kind, effect[k].choice);
        job->effect[0].value[0] = effect[k].value;
        job->effect_count = 1;
        const double start = seconds();
        if (wcut_compensation_fit(target, job, NULL, say_round, NULL, &c, &error) != WCUT_OK) {
            printf("%s: %s\n", effect[k].name, error.text);
            continue;
        }
        const double spent = seconds() - start;
        double rms[2] = {0, 0}, before[2] = {0, 0}, max;
        for (int side = 0; side < 2; side++) {
            job->effect[0].value[0] = c->job->effect[0].value[0] = effect[k].value * (side ? 1.1 : 0.9);
            wcut_compensation_measure(target, job, 1, &before[side], &max, NULL);
            wcut_compensation_measure(target, c->job, 1, &rms[side], &max, NULL);
        }
        printf(
            "%-22s before %.3f rms %.2f max, after %.3f rms: %.0f %% removed; 10 %% less %.0f %%, 10 %% more %.0f %%; "
            "%d runs "
            "%.1f s\n",
            effect[k].name, c->before_rms, c->before_max, c->after_rms, 100 * (1 - c->after_rms / c->before_rms),
            100 * (1 - rms[0] / before[0]), 100 * (1 - rms[1] / before[1]), c->runs, spent);
        fflush(stdout);
        wcut_compensation_destroy(c);
    }
    wcut_design_target_destroy(target);
    wcut_surface_destroy(surface);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

int main(int count, char **argument) {
    stations = setting("STATIONS", stations), nodes = setting("NODES", nodes);
    if (count == 1)
        printf("bench_inverse [targets | NAME | hidden COUNT | cloud | panels N | cost | compensation] ...\n");
    for (int a = 1; a < count; a++) {
        for (int k = 0; k < KNOWN; k++)
            if (strcmp(argument[a], known[k].name) == 0 || strcmp(argument[a], "targets") == 0) show_target(k);
        if (strcmp(argument[a], "hidden") == 0)
            show_hidden(a + 1 < count ? atoi(argument[++a]) : 10);
        else if (strcmp(argument[a], "cloud") == 0)
            show_cloud(0), show_cloud(3), show_cloud(6);
        else if (strcmp(argument[a], "panels") == 0)
            show_panels(a + 1 < count ? atoi(argument[++a]) : 4);
        else if (strcmp(argument[a], "cost") == 0)
            show_cost();
        else if (strcmp(argument[a], "compensation") == 0)
            show_compensation();
    }
    return 0;
}
