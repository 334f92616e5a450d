/* The signature of every effect in all channels, as one picture of small multiples: bench_signatures > effects.svg

   One cut in space is simulated plain and with one effect at a time. Tensions are those of a run driven by the plain
   run's motion; speed, angles and the cut face those of a run whose tension is held. Each cell shows the change. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/wirecut.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

enum { STATIONS = 240, NODES = 61, CHANNELS = 5, POINTS = 80 };
enum { CELL_W = 150, CELL_H = 54, LEFT = 190, TOP = 58, GAP = 10 };

static const char *const heading[CHANNELS] = {"tension, motion given", "speed, tension held", "alpha", "beta",
                                              "scan, at W/4"};
static const char *const unit[CHANNELS] = {"N", "mm/s", "deg", "deg", "mm"};
static const double min[CHANNELS] = {0.01, 0.1, 0.1, 0.1, 0.05}; /* smaller changes are drawn flat */

typedef struct run {
    int stations;
    double channel[CHANNELS][2][STATIONS]; /* of mount A and B; the scan has one, its points are apart */
    double time[STATIONS], speed[STATIONS];
    wcut_vec3 face[STATIONS], normal[STATIONS];
} run;

/* entry, steady part and exit, the mounts rising and falling against each other */
static wcut_job *make_job(void) {
    wcut_job *job;
    if (wcut_job_create(&job) != WCUT_OK) exit(1);
    job->block_size = vec3(400, 600, 300);
    job->wire_diameter = 0.15, job->wire_length = 560, job->nodes = NODES;
    job->heat = 65, job->tension = 2, job->speed_max = 40, job->stations = STATIONS;
    job->force_law = (wcut_force_law){0.06, 6e-4};
    job->mount_a = wcut_alloc(STATIONS, sizeof *job->mount_a);
    job->mount_b = wcut_alloc(STATIONS, sizeof *job->mount_b);
    if (!job->mount_a || !job->mount_b) exit(1);
    for (int j = 0; j < STATIONS; j++) {
        const double u = j / (STATIONS - 1.0), narrow = fmin(1, fmin(u, 1 - u) / 0.22);
        const double beside = 78 - 34 * narrow * narrow * (3 - 2 * narrow), rise = 30 * sin(2 * WCUT_PI * u);
        job->mount_a[j] = vec3(-beside, -10 + 690 * u, 150 + rise);
        job->mount_b[j] = vec3(400 + beside, -10 + 690 * u, 150 - rise);
    }
    return job;
}

static double degrees(double rad) { return rad * 180 / WCUT_PI; }

static void keep_forward(const wcut_station *s, int j, run *r) {
    const double value[CHANNELS][2] = {
        {0, 0}, {s->speed_a, s->speed_b}, {s->alpha_a, s->alpha_b}, {s->beta_a, s->beta_b}, {0, 0}};
    for (int c = 1; c < 4; c++)
        for (int m = 0; m < 2; m++) r->channel[c][m][j] = c == 1 ? value[c][m] : degrees(value[c][m]);
    const int i = NODES / 4;
    const wcut_vec3 along = vec3_sub(s->position[i + 1], s->position[i - 1]);
    r->time[j] = s->time;
    r->face[j] = s->position[i];
    r->speed[j] = s->speed[i];
    r->normal[j] = along; /* turned into the normal when the next point of the face is known */
}

static void find_normals(run *r) {
    for (int j = 0; j < r->stations; j++) {
        const int a = j > 0 ? j - 1 : 0, b = j < r->stations - 1 ? j + 1 : j;
        r->normal[j] = vec3_unit(vec3_cross(r->normal[j], vec3_sub(r->face[b], r->face[a])));
    }
}

/* tension held: speeds, angles, face */
static void run_forward(const wcut_job *job, run *r) {
    wcut_setup *setup;
    wcut_cut *cut;
    wcut_error error = {0};
    if (wcut_setup_create(job, NULL, &setup, &error) != WCUT_OK || wcut_cut_create(setup, &cut, &error) != WCUT_OK)
        fprintf(stderr, "%s\n", error.text), exit(1);
    r->stations = 0;
    do {
        wcut_station s;
        wcut_cut_view(cut, &s);
        keep_forward(&s, r->stations++, r);
    } while (wcut_cut_step(cut, &error) == WCUT_OK);
    find_normals(r);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
}

/* the plain run's motion: tensions */
static void run_driven(const wcut_job *job, const run *plain, run *r) {
    wcut_setup *setup;
    wcut_cut *cut;
    wcut_error error = {0};
    if (wcut_setup_create(job, NULL, &setup, &error) != WCUT_OK || wcut_cut_create(setup, &cut, &error) != WCUT_OK)
        fprintf(stderr, "%s\n", error.text), exit(1);
    for (int j = 1; j < plain->stations; j++) {
        if (wcut_cut_drive(cut, job->mount_a[j], job->mount_b[j], plain->time[j] - plain->time[j - 1], job->heat,
                           &error) != WCUT_OK)
            break;
        wcut_station s;
        wcut_cut_view(cut, &s);
        r->channel[0][0][j] = s.tension_a, r->channel[0][1][j] = s.tension_b;
    }
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
}

/* what instruments and faces make of it */
static void sense(const wcut_job *job, run *r) {
    double *value[WCUT_SENSED_COUNT] = {NULL, NULL};
    for (int k = 2; k < WCUT_SENSED_COUNT; k++)
        value[k] = k < 4 ? r->channel[0][k - 2] : r->channel[k % 2 ? 3 : 2][k < 6 ? 0 : 1];
    for (int c = 2; c < 4; c++)
        for (int m = 0; m < 2; m++)
            for (int j = 0; j < r->stations; j++) r->channel[c][m][j] *= WCUT_PI / 180;
    double q_eff[STATIONS];
    for (int j = 0; j < r->stations; j++) {
        q_eff[j] = r->speed[j] > 0 ? wcut_q_eff_eval(job->heat, r->speed[j]) : 1;
        if (r->normal[j].z < 0) r->normal[j] = vec3_scale(-1, r->normal[j]);
    }
    if (wcut_sensors_eval(job->effect_count, job->effect, r->stations, r->time, NULL, value) != WCUT_OK ||
        wcut_face_eval(job->effect_count, job->effect, job->block_size, r->stations, r->normal, q_eff, r->face) !=
            WCUT_OK)
        exit(1);
    for (int c = 2; c < 4; c++)
        for (int m = 0; m < 2; m++)
            for (int j = 0; j < r->stations; j++) r->channel[c][m][j] *= 180 / WCUT_PI;
}

/* distance of the face from the plain one along its normal, at the nearest of its points */
static double face_distance(const run *plain, wcut_vec3 p) {
    int nearest = 0;
    for (int j = 1; j < plain->stations; j++)
        if (vec3_distance(plain->face[j], p) < vec3_distance(plain->face[nearest], p)) nearest = j;
    return vec3_dot(vec3_sub(p, plain->face[nearest]), plain->normal[nearest]);
}

static double change(const run *plain, const run *r, int c, int m, int j) {
    return c < 4 ? r->channel[c][m][j] - plain->channel[c][m][j] : face_distance(plain, r->face[j]);
}

static int by_size(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* what 97 of 100 changes stay below: the moments at which the wire enters and leaves are not the picture's scale */
static double size_of(const run *plain, const run *r, int c, int stations) {
    double size[2 * STATIONS];
    int count = 0;
    for (int j = 2; j < stations; j++)
        for (int m = 0; m < 2; m++) size[count++] = fabs(change(plain, r, c, m, j));
    qsort(size, (size_t)count, sizeof *size, by_size);
    return size[count * 97 / 100];
}

static void draw_cell(const run *plain, const run *r, int c, double x, double y) {
    const int stations = r->stations < plain->stations ? r->stations : plain->stations;
    const double size = size_of(plain, r, c, stations);
    printf("<path class=\"z\" d=\"M%g %gh%d\"/>\n", x, y + CELL_H / 2.0, CELL_W);
    if (size < min[c]) return;
    for (int m = 0; m < (c < 4 ? 2 : 1); m++) {
        printf("<path class=\"%s\" d=\"", c == 4 ? "f" : m ? "b" : "a");
        for (int k = 0; k < POINTS; k++) {
            const int j = 2 + k * (stations - 3) / (POINTS - 1);
            const double height = clamp(change(plain, r, c, m, j) / size, -1.2, 1.2);
            printf("%s%.1f %.1f", k ? (k == 1 ? "L" : " ") : "M", x + CELL_W * j / (STATIONS - 1.0),
                   y + CELL_H / 2.0 - (CELL_H / 2.0 - 8) * height);
        }
        printf("\"/>\n");
    }
    printf("<text class=\"s\" x=\"%g\" y=\"%g\">&#177;%.2g %s</text>\n", x + CELL_W, y + 8, size, unit[c]);
}

static void draw_label(const wcut_effect *e, double y) {
    const wcut_effect_info *info = wcut_effect_view(e->kind);
    char words[200] = "";
    size_t used = 0;
    if (info->choice_key) used += (size_t)snprintf(words, sizeof words, "%s ", info->choice[e->choice]);
    for (const wcut_effect_parameter *p = wcut_effect_parameters(e); p->key && p->at < 2; p++)
        used += (size_t)snprintf(words + used, sizeof words - used, "%s%.4g", p->at ? ", " : "", e->value[p->at]);
    printf("<text class=\"n\" x=\"12\" y=\"%g\">%s</text><text class=\"p\" x=\"12\" y=\"%g\">%s</text>\n", y + 24,
           info->name, y + 38, words);
}

static wcut_effect typical(wcut_effect_kind kind) {
    static const struct {
        wcut_effect_kind kind;
        int choice;
        double value[WCUT_EFFECT_VALUES];
    } given[] = {{WCUT_EFFECT_WIRE_THERMAL_LAG, 0, {0.6, 10, 0.059, 0.0079}},
                 {WCUT_EFFECT_AIR_OVERHEATING, 0, {1.6, 1.5}},
                 {WCUT_EFFECT_END_COOLING, 0, {0.25, 100}},
                 {WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0, {0.3}},
                 {WCUT_EFFECT_EMPIRICAL_FORCE, 4, {0.2, 0, 80}}, /* wave_y */
                 {WCUT_EFFECT_EMPIRICAL_READING, 0, {0.3, 0, -1e6, 1e6}},
                 {WCUT_EFFECT_FOAM_INCLUSION, 0, {0.3, 50, 130, 300, 150}},
                 {WCUT_EFFECT_TANGENTIAL_DRAG, 0, {0.3, 0.3}},
                 {WCUT_EFFECT_WIRE_ELONGATION, 0, {0.004, 0.8, 1.4}},
                 {WCUT_EFFECT_MOUNT_COMPLIANCE, 0, {2, 0.3}},
                 {WCUT_EFFECT_RATE_DEPENDENCE, 0, {0.3, 10}},
                 {WCUT_EFFECT_WIRE_FOULING, 0, {0.2, 600, 0}},
                 {WCUT_EFFECT_KERF_GROWTH, 0, {1.6e-4, 0}},
                 {WCUT_EFFECT_BLOCK_SPRINGBACK, 2, {2}},
                 {WCUT_EFFECT_ANGLE_OFFSET, 0, {1}},
                 {WCUT_EFFECT_TENSION_GAIN, 0, {0.05}},
                 {WCUT_EFFECT_TENSION_DRIFT, 0, {0.2, 0}},
                 {WCUT_EFFECT_CLOCK_OFFSET, 0, {0.15}},
                 {WCUT_EFFECT_SCAN_OFFSET, 0, {0.5, 0.5, 0.5}},
                 {WCUT_EFFECT_SCAN_SCALE, 0, {1.005}}};
    wcut_effect e = wcut_effect_default(kind);
    for (size_t k = 0; k < sizeof given / sizeof *given; k++)
        if (given[k].kind == kind) {
            e.choice = given[k].choice;
            memcpy(e.value, given[k].value, sizeof e.value);
        }
    return e;
}

static void begin_picture(void) {
    const int width = LEFT + CHANNELS * (CELL_W + GAP) + 10, height = TOP + WCUT_EFFECT_COUNT * (CELL_H + 4) + 30;
    printf("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\">\n", width,
           height, width, height);
    printf(
        "<style>text{font:12px system-ui,sans-serif;fill:#333}.p,.s{font-size:10px;fill:#777}.s{text-anchor:end}"
        ".h{font-weight:600}path{fill:none;stroke-width:1.3}.z{stroke:#ddd;stroke-width:1}.a{stroke:#1f5fa8}"
        ".b{stroke:#d9822b}.f{stroke:#3c7a4e}</style>\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n");
    printf(
        "<text class=\"p\" x=\"12\" y=\"%d\">What each effect changes, from station to station of one cut: blue mount "
        "A, orange mount B, green the face. Cells without a curve change less than can be measured.</text>\n",
        height - 8);
    for (int c = 0; c < CHANNELS; c++)
        printf("<text class=\"h\" x=\"%d\" y=\"36\">%s</text>\n", LEFT + c * (CELL_W + GAP), heading[c]);
}

int main(void) {
    static run plain, with;
    wcut_job *job = make_job();
    run_forward(job, &plain);
    run_driven(job, &plain, &plain);
    sense(job, &plain);
    begin_picture();
    for (int k = 0; k < WCUT_EFFECT_COUNT; k++) {
        wcut_effect e = typical((wcut_effect_kind)k);
        job->effect = &e, job->effect_count = 1;
        with = plain;
        if (wcut_effect_view(e.kind)->place == WCUT_EFFECT_PLACE_STEP) {
            run_forward(job, &with);
            run_driven(job, &plain, &with);
        }
        sense(job, &with);
        draw_label(&e, TOP + k * (CELL_H + 4));
        for (int c = 0; c < CHANNELS; c++)
            draw_cell(&plain, &with, c, LEFT + c * (CELL_W + GAP), TOP + k * (CELL_H + 4));
    }
    printf("</svg>\n");
    job->effect = NULL, job->effect_count = 0;
    wcut_job_destroy(job);
    return EXIT_SUCCESS;
}
