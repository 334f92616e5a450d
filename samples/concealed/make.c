/* Three sealed cases: what a machine would record of cuts in which something is concealed.

   Usage: make DIR      writes DIR/one, DIR/two, DIR/three and DIR/answers

   Each case is four cuts, the last two of them identification cuts. The job that the diagnosis is given has a wrong
   force law and no effect; the foam, or an instrument, has another law and an effect. The loop holds the tension all the
   same: what is concealed moves into the speed. Sensors and scanner have their noise, from a seed. */
#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <wirecut/diagnosis.h>
#include <wirecut/wirecut.h>

enum { CUTS = 4, STATIONS = 130, NODES = 61, SCANNED = 2, PATH = 400 };

#define PI 3.14159265358979323846
/* [s] of the tension's readings, as in every recording of this rig */
#define READINGS_LATE 0.05

typedef struct concealed {
    const char *name;
    double law_a, law_b; /* [1] the foam's over the job's */
    wcut_effect effect;
    uint64_t seed;
} concealed;

static void stop(const char *what, const wcut_error *error) {
    fprintf(stderr, "make: %s: %s\n", what, error && error->text[0] ? error->text : "failed");
    exit(1);
}

static void must(wcut_status status, const char *what, const wcut_error *error) {
    if (status == WCUT_OK) return;
    if (error && error->text[0]) stop(what, error);
    stop(wcut_status_text(status), NULL);
}

/* ---- random numbers ---- */

/* splitmix64 (Steele 2014) and the sum of twelve: normal enough for a scanner, and the same on every machine */
static double uniform(uint64_t *state) {
    uint64_t z = (*state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) / 9007199254740992.0;
}

static double normal(uint64_t *state) {
    double sum = -6;
    for (int i = 0; i < 12; i++) sum += uniform(state);
    return sum;
}

/* ---- jobs ---- */

/* entry, steady part, exit; the mounts of odd cuts rise and fall against each other */
static wcut_job *make_job(int cut) {
    static const double heat[CUTS] = {60, 75, 65, 70};
    wcut_job *job = NULL;
    char name[40];
    must(wcut_job_create(&job), "a job", NULL);
    snprintf(name, sizeof name, "cut %d", cut + 1);
    free(job->name);
    job->name = malloc(strlen(name) + 1);
    job->mount_a = calloc(STATIONS, sizeof *job->mount_a);
    job->mount_b = calloc(STATIONS, sizeof *job->mount_b);
    if (!job->name || !job->mount_a || !job->mount_b) stop("no memory", NULL);
    memcpy(job->name, name, strlen(name) + 1);
    job->block_size = (wcut_vec3){400, 600, 300};
    job->wire_diameter = 0.15, job->wire_length = 560, job->nodes = NODES;
    job->heat = heat[cut], job->tension = 2, job->speed_max = 40;
    job->force_law = (wcut_force_law){0.1, 8.6e-4};
    job->stations = STATIONS;
    for (int j = 0; j < STATIONS; j++) {
        const double u = j / (STATIONS - 1.0), end = u < 1 - u ? u : 1 - u, narrow = end < 0.22 ? end / 0.22 : 1;
        const double beside = 78 - 30 * narrow * narrow * (3 - 2 * narrow);
        const double rise = cut % 2 ? 35 * sin(2 * PI * u) : 0;
        job->mount_a[j] = (wcut_vec3){-beside, -10 + 690 * u, 150 + rise};
        job->mount_b[j] = (wcut_vec3){400 + beside, -10 + 690 * u, 150 - rise};
    }
    return job;
}

/* the four cuts of a case: two as they are, two to identify with */
static void make_jobs(const concealed *c, wcut_job *job[CUTS]) {
    wcut_error error = {0};
    for (int k = 0; k < CUTS; k++) {
        wcut_job *plain = make_job(k), *excited = NULL;
        job[k] = plain;
        if (k < 2) continue;
        must(wcut_identification_create(plain, 1, c->seed + (uint64_t)k, &excited, &error), "an excitation", &error);
        wcut_job_destroy(plain);
        job[k] = excited;
    }
}

/* the foam as it is: the job's own numbers put right, with the effect */
static void conceal(const concealed *c, wcut_job *job) {
    job->force_law.a *= c->law_a;
    job->force_law.b *= c->law_b;
    job->effect = malloc(sizeof *job->effect);
    if (!job->effect) stop("no memory", NULL);
    job->effect[0] = c->effect;
    job->effect_count = 1;
}

/* ---- what is recorded ---- */

static wcut_rig_run *record(const concealed *c, int cut, wcut_job *job) {
    wcut_setup *setup = NULL;
    wcut_history *plan = NULL;
    wcut_rig_run *run = NULL;
    wcut_error error = {0};
    must(wcut_setup_create(job, NULL, &setup, &error), "a plan", &error);
    must(wcut_setup_run(setup, NULL, NULL, &plan, &error), "a plan", &error);
    wcut_control_settings control = wcut_control_settings_default(job);
    control.tension_stop = 20 * job->tension, control.tension_absurd = 100 * job->tension;
    wcut_rig_options o = wcut_rig_options_default(job);
    o.seed = c->seed + 100 * (uint64_t)cut;
    o.decimation = 4; /* 10 Hz */
    o.delay = READINGS_LATE;
    conceal(c, job);
    must(wcut_rig_run_create(job, plan, &control, &o, NULL, NULL, &run, &error), "a recording", &error);
    if (!run->complete) stop("a cut stopped before its end", NULL);
    double *value[WCUT_SENSED_COUNT];
    for (int k = 0; k < WCUT_SENSED_COUNT; k++) value[k] = run->recording.channel[WCUT_CHANNEL_SPEED_A + k].value;
    must(wcut_sensors_eval(1, &c->effect, run->recording.samples, run->recording.channel[WCUT_CHANNEL_TIME].value, NULL,
                           value),
         "the instruments", NULL);
    wcut_history_destroy(plan);
    wcut_setup_destroy(setup);
    return run;
}

static wcut_vec3 between(const wcut_vec3 *path, double station) {
    const int j = station < STATIONS - 1 ? (int)station : STATIONS - 2;
    const double t = station - j;
    const wcut_vec3 a = path[j], b = path[j + 1];
    return (wcut_vec3){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/* the normal of the face between two positions of the wire, upwards */
static wcut_vec3 normal_of(wcut_vec3 left, wcut_vec3 right, wcut_vec3 before, wcut_vec3 now) {
    const wcut_vec3 a = {right.x - left.x, right.y - left.y, right.z - left.z};
    const wcut_vec3 b = {now.x - before.x, now.y - before.y, now.z - before.z};
    wcut_vec3 n = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    const double length = sqrt(n.x * n.x + n.y * n.y + n.z * n.z) * (n.z < 0 ? -1 : 1);
    return (wcut_vec3){n.x / length, n.y / length, n.z / length};
}

/* a point of the face under a node, half a kerf below the wire, as the scanner has it */
static void put_point(FILE *out, const concealed *c, const wcut_job *job, const wcut_station *s, int i,
                      wcut_vec3 before, double heat, uint64_t *state) {
    const double half_kerf = 0.45, noise = 0.08; /* [mm] */
    const wcut_vec3 n = normal_of(s->position[i - 1], s->position[i + 1], before, s->position[i]);
    const double q_eff = wcut_q_eff_eval(heat, s->speed[i]);
    wcut_vec3 p = s->position[i];
    const double lower = -half_kerf + noise * normal(state);
    p = (wcut_vec3){p.x + lower * n.x, p.y + lower * n.y, p.z + lower * n.z};
    must(wcut_face_eval(1, &c->effect, job->block_size, 1, &n, &q_eff, &p), "a scanned point", NULL);
    fprintf(out, "%.2f %.2f %.2f\n", p.x, p.y, p.z);
}

/* the wire led once more as it was recorded, and its face scanned */
static void scan(const concealed *c, int cut, const wcut_job *job, const wcut_recording *r, const char *path) {
    FILE *out = fopen(path, "w");
    wcut_setup *setup = NULL;
    wcut_cut *wire = NULL;
    wcut_error error = {0};
    wcut_vec3 before[NODES];
    uint64_t state = c->seed * 1000 + (uint64_t)cut;
    if (!out) stop(path, NULL);
    must(wcut_setup_create(job, NULL, &setup, &error), "a scan", &error);
    must(wcut_cut_create(setup, &wire, &error), "a scan", &error);
    const double *time = r->channel[WCUT_CHANNEL_TIME].value, *station = r->channel[WCUT_CHANNEL_STATION].value;
    const double *heat = r->channel[WCUT_CHANNEL_HEAT].value;
    double last = 0;
    for (int k = 1; k < r->samples; k++) {
        wcut_station s;
        if (!(station[k] > station[k - 1])) continue;
        must(wcut_cut_drive(wire, between(job->mount_a, station[k]), between(job->mount_b, station[k]), time[k] - last,
                            heat[k], &error),
             "a scan", &error);
        last = time[k];
        wcut_cut_view(wire, &s);
        for (int i = 2 + k % 4; i < NODES - 1 && k % 3 == 0; i += 4)
            if (s.engaged[i] > 0.99 && s.speed[i] > 0.5) put_point(out, c, job, &s, i, before[i], heat[k], &state);
        memcpy(before, s.position, sizeof before);
    }
    if (fclose(out) != 0) stop(path, NULL);
    wcut_cut_destroy(wire);
    wcut_setup_destroy(setup);
}

/* ---- what goes with it ---- */

/* steady test cuts in the foam: 2 T sin(alpha) = F(Q) W, with 3 % of scatter */
static void calibrate(const concealed *c, const char *path) {
    static const double heat[] = {50, 60, 70, 85}, alpha[] = {18, 27, 36};
    const double a = 0.1 * c->law_a, b = 8.6e-4 * c->law_b, tension = 2, engaged = 400;
    FILE *out = fopen(path, "w");
    uint64_t state = c->seed * 7777;
    if (!out) stop(path, NULL);
    fprintf(out, "heat_W_per_m,speed_mm_s,engaged_mm,tension_N,alpha_deg\n");
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            const double force = 2 * tension * sin(alpha[k] * PI / 180) / engaged;
            const double speed = 1000 * heat[i] * b / log(a / force);
            fprintf(out, "%g,%.3f,%g,%.4f,%.3f\n", heat[i], speed, engaged, tension * (1 + 0.03 * normal(&state)),
                    alpha[k]);
        }
    if (fclose(out) != 0) stop(path, NULL);
}

static void write_case(const concealed *c, const char *path) {
    FILE *out = fopen(path, "w");
    if (!out) stop(path, NULL);
    fprintf(out, "{\"format\": \"wirecut-case/1\", \"name\": \"%s\",\n \"cuts\": [", c->name);
    for (int k = 0; k < CUTS; k++) {
        fprintf(out, "%s{\"job\": \"cut-%d/job.json\", \"recording\": \"cut-%d/recording.csv\", \"scan\": ",
                k ? ",\n          " : "", k + 1, k + 1);
        fprintf(out, k < SCANNED ? "\"cut-%d/scan.xyz\"}" : "null}", k + 1);
    }
    fprintf(out, "],\n \"calibration\": \"calibration.csv\"}\n");
    if (fclose(out) != 0) stop(path, NULL);
}

static void write_answer(const concealed *c, const char *path) {
    const wcut_effect_info *info = wcut_effect_view(c->effect.kind);
    FILE *out = fopen(path, "w");
    if (!out) stop(path, NULL);
    fprintf(out, "{\"case\": \"%s\", \"effect\": \"%s\"", c->name, info->name);
    if (info->choice_required) fprintf(out, ", \"%s\": \"%s\"", info->choice_key, info->choice[c->effect.choice]);
    for (const wcut_effect_parameter *p = wcut_effect_parameters(&c->effect); p->key; p++) {
        fprintf(out, ", \"%s\": %s", p->key, p->size == 3 ? "[" : "");
        for (int k = 0; k < p->size; k++) fprintf(out, "%s%g", k ? ", " : "", c->effect.value[p->at + k]);
        fprintf(out, "%s", p->size == 3 ? "]" : "");
    }
    fprintf(out, ",\n \"a_N_per_mm\": %g, \"b_m2_per_J\": %g, \"the job said\": [0.1, 0.00086],\n", 0.1 * c->law_a,
            8.6e-4 * c->law_b);

    /* what the rig has beside it: its tension readings are late, as its loop reads them */
    fprintf(out, " \"the rig\": {\"tension_delay_s\": %g}}\n", READINGS_LATE);
    if (fclose(out) != 0) stop(path, NULL);
}

static void make_folder(const char *path) {
    if (mkdir(path, 0777) != 0 && errno != EEXIST) stop(path, NULL);
}

static void make_case(const concealed *c, const char *folder) {
    char path[PATH];
    wcut_job *job[CUTS];
    wcut_error error = {0};
    snprintf(path, sizeof path, "%s/%s", folder, c->name);
    make_folder(path);
    make_jobs(c, job);
    for (int k = 0; k < CUTS; k++) {
        snprintf(path, sizeof path, "%s/%s/cut-%d", folder, c->name, k + 1);
        make_folder(path);
        snprintf(path, sizeof path, "%s/%s/cut-%d/job.json", folder, c->name, k + 1);
        must(wcut_job_write(job[k], path, &error), path, &error);
        wcut_rig_run *run = record(c, k, job[k]);
        snprintf(path, sizeof path, "%s/%s/cut-%d/recording.csv", folder, c->name, k + 1);
        must(wcut_recording_write(&run->recording, NULL, path, &error), path, &error);
        snprintf(path, sizeof path, "%s/%s/cut-%d/scan.xyz", folder, c->name, k + 1);
        if (k < SCANNED) scan(c, k, job[k], &run->recording, path);
        wcut_rig_run_destroy(run);
        wcut_job_destroy(job[k]);
    }
    snprintf(path, sizeof path, "%s/%s/calibration.csv", folder, c->name);
    calibrate(c, path);
    snprintf(path, sizeof path, "%s/%s/case.json", folder, c->name);
    write_case(c, path);
    snprintf(path, sizeof path, "%s/answers/%s.json", folder, c->name);
    write_answer(c, path);
}

int main(int count, char **word) {
    char path[PATH];
    if (count != 2 || strlen(word[1]) > PATH - 60) {
        fprintf(stderr, "usage: make DIR\n");
        return 2;
    }
    concealed c[] = {{"one", 0.88, 1.1, wcut_effect_default(WCUT_EFFECT_WIRE_THERMAL_LAG), 11},
                     {"two", 1.12, 0.95, wcut_effect_default(WCUT_EFFECT_ANGLE_OFFSET), 12},
                     {"three", 0.93, 1.06, wcut_effect_default(WCUT_EFFECT_FOAM_INCLUSION), 13}};
    c[0].effect.value[0] = 0.8;
    c[1].effect.choice = 2;
    c[1].effect.value[0] = 1.4;
    c[2].effect.value[0] = 0.45, c[2].effect.value[1] = 55;
    c[2].effect.value[2] = 150, c[2].effect.value[3] = 330, c[2].effect.value[4] = 150;
    make_folder(word[1]);
    snprintf(path, sizeof path, "%s/answers", word[1]);
    make_folder(path);
    for (size_t i = 0; i < sizeof c / sizeof *c; i++) make_case(&c[i], word[1]);
    return 0;
}
