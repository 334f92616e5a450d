/* Robot programs: every format parsed by a grammar of the emitted subset and compared with the motion. */
/* labels: unit property */
#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/robot.h>
#include <wirecut/robot_file.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "test.h"

enum { STATIONS = 60 };

static wcut_history_row row[STATIONS];
static wcut_history history;
static wcut_vec3 mount_a[STATIONS], mount_b[STATIONS];
static wcut_robot_options options;
static wcut_robot_motion *motion;
static wcut_error error;
static char *text; /* of the program being parsed */
static const char *at;

/* mount A on an arc, mount B straight, for a while standing; speeds that change */
static void prepare(void) {
    memset(row, 0, sizeof row);
    for (int j = 0; j < STATIONS; j++) {
        const double u = (double)j / (STATIONS - 1);
        mount_a[j] = (wcut_vec3){-100 + 40 * sin(2 * u), 300 * u + 1e-4 * j, 150 + 30 * cos(3 * u)};
        mount_b[j] = (wcut_vec3){500, u < 0.5 ? 400 * u : 200, 150};
        row[j].duration = j ? 0.2 + 0.1 * u : 0;
        row[j].time = j ? row[j - 1].time + row[j].duration : 0;
        row[j].speed_a = 20;
        row[j].speed_b = 10;
        row[j].alpha_a = 0.3 * u;
        row[j].beta_a = -0.2 * u;
        row[j].alpha_b = 0.25;
        row[j].beta_b = 0.1 * sin(5 * u);
        row[j].tension_a = row[j].tension_b = 2;
    }
    history = (wcut_history){.stations = STATIONS, .planned = STATIONS, .nodes = 3, .row = row};
    options = wcut_robot_options_default();
    options.frame = WCUT_TOOL_FRAME_FOLLOWING;
    options.lead_in = 20;
    options.lead_out = 30;
    motion = NULL;
    text = NULL;
}

static void forget(void) {
    wcut_robot_motion_destroy(motion);
    free(text);
}

static void make(void) {
    ck_assert_int_eq(wcut_robot_motion_create(&history, mount_a, mount_b, &options, &motion, &error), WCUT_OK);
}

/* ---- a scanner: words, numbers, marks; space between them does not count ---- */

static void load(wcut_robot_format format, int robot, const wcut_robot_names *names) {
    char path[64];
    snprintf(path, sizeof path, "test_robot.%ld", (long)getpid());
    ck_assert_msg(wcut_robot_write(motion, names, format, robot, path, &error) == WCUT_OK, "%s", error.text);
    FILE *file = fopen(path, "rb");
    ck_assert_ptr_nonnull(file);
    free(text);
    text = calloc(1, 1 << 20);
    ck_assert_uint_gt(fread(text, 1, (1 << 20) - 1, file), 0);
    ck_assert(feof(file));
    fclose(file);
    remove(path);
    at = text;
}

static char comment_mark;

static void skip(void) {
    for (;;) {
        while (isspace((unsigned char)*at)) at++;
        if (!comment_mark || *at != comment_mark) return;
        at += strcspn(at, "\n");
    }
}

static bool sees(const char *word) {
    skip();
    return strncmp(at, word, strlen(word)) == 0;
}

/* the words in order, "#" for a number that goes to the next double * */
static void expect(const char *words, ...) {
    enum { NUMBERS = 16 };
    double *to[NUMBERS], unused = 0;
    int count = 0, next = 0;
    for (const char *w = words; *w; w++) count += *w == '#';
    ck_assert_int_le(count, NUMBERS);
    va_list list;
    va_start(list, words);
    for (int k = 0; k < NUMBERS; k++) to[k] = k < count ? va_arg(list, double *) : &unused;
    va_end(list);
    for (const char *w = words; *w; w++) {
        if (*w == ' ') continue;
        skip();
        if (*w == '#') {
            const size_t length = strspn(at, "+-0123456789.");
            char *end;
            *to[next++] = strtod(at, &end);
            ck_assert_msg(length > 0 && end == at + length, "expected a number at: %.60s", at);
            at += length;
        } else {
            ck_assert_msg(*at == *w, "expected \"%s\" at: %.60s", w, at);
            at++;
        }
    }
}

/* ---- what a program must say ---- */

static wcut_vec3 place(int robot, int i) { return robot ? motion->target[i].b : motion->target[i].a; }

static double speed_of(int robot, int i) { return robot ? motion->target[i].speed_b : motion->target[i].speed_a; }

static double zone_of(int robot, int i) { return robot ? motion->target[i].zone_b : motion->target[i].zone_a; }

static void check_place(int robot, int i, double x, double y, double z) {
    const wcut_vec3 p = place(robot, i);
    ck_assert_double_eq_tol(x, p.x, 0.501e-3);
    ck_assert_double_eq_tol(y, p.y, 0.501e-3);
    ck_assert_double_eq_tol(z, p.z, 0.501e-3);
}

/* x and z axes of the tool from the target's quaternion */
static void axes(int robot, int i, double x[3], double z[3]) {
    const double *q = robot ? motion->target[i].frame_b : motion->target[i].frame_a;
    const double w = q[0], a = q[1], b = q[2], c = q[3];
    x[0] = 1 - 2 * (b * b + c * c);
    x[1] = 2 * (a * b + w * c);
    x[2] = 2 * (a * c - w * b);
    z[0] = 2 * (a * c + w * b);
    z[1] = 2 * (b * c - w * a);
    z[2] = 1 - 2 * (a * a + b * b);
}

/* the matrix R (rows of rows) has these axes as its first and third column */
static void check_axes(int robot, int i, double r[3][3], double tolerance) {
    double x[3], z[3];
    axes(robot, i, x, z);
    for (int k = 0; k < 3; k++) {
        ck_assert_double_eq_tol(r[k][0], x[k], tolerance);
        ck_assert_double_eq_tol(r[k][2], z[k], tolerance);
    }
}

/* Rodrigues */
static void from_vector(const double v[3], double r[3][3]) {
    const double t = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const double n[3] = {t > 0 ? v[0] / t : 1, t > 0 ? v[1] / t : 0, t > 0 ? v[2] / t : 0}, c = cos(t), s = sin(t);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) r[i][j] = (1 - c) * n[i] * n[j] + (i == j ? c : 0);
    r[0][1] -= s * n[2];
    r[1][0] += s * n[2];
    r[0][2] += s * n[1];
    r[2][0] -= s * n[1];
    r[1][2] -= s * n[0];
    r[2][1] += s * n[0];
}

/* Rz(A) Ry(B) Rx(C) */
static void from_euler(const double abc[3], double r[3][3]) {
    const double d = acos(-1) / 180, ca = cos(abc[0] * d), sa = sin(abc[0] * d), cb = cos(abc[1] * d);
    const double sb = sin(abc[1] * d), cc = cos(abc[2] * d), sc = sin(abc[2] * d);
    const double m[3][3] = {{ca * cb, ca * sb * sc - sa * cc, ca * sb * cc + sa * sc},
                            {sa * cb, sa * sb * sc + ca * cc, sa * sb * cc - ca * sc},
                            {-sb, cb * sc, cb * cc}};
    memcpy(r, m, sizeof m);
}

/* the angle by which the tool turns in a move [rad] */
static double turn_at(int robot, int i) {
    const wcut_robot_target *t = &motion->target[i];
    const double *p = robot ? t[-1].frame_b : t[-1].frame_a, *q = robot ? t->frame_b : t->frame_a;
    return 2 * acos(fmin(1, fabs(p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3])));
}

static bool creeps(int robot, int i) { return speed_of(robot, i) * motion->target[i].duration < 5e-4; }

/* neither goes nor turns */
static bool stands(int robot, int i) { return creeps(robot, i) && turn_at(robot, i) < 1e-5; }

/* the run id over output and input `io` of URScript or KRL */
static unsigned expect_run_id(bool ur, int io) {
    char words[300];
    unsigned id = 0;
    for (int k = 0; k < 12; k++) {
        snprintf(words, sizeof words, ur ? "set_digital_out(%d, " : "$OUT[%d] = ", io);
        expect(words);
        const bool bit = sees("T");
        id = 2 * id + bit;
        const char *value = ur ? bit ? "True" : "False" : bit ? "TRUE" : "FALSE";
        if (ur)
            snprintf(
                words, sizeof words,
                "%s) sleep(0.100) if (get_digital_in(%d) != %s): popup(\"programs of different runs\", \"wirecut\", "
                "False, True, True) halt end sleep(0.100)",
                value, io, value);
        else
            snprintf(words, sizeof words,
                     "%s WAIT SEC 0.100 IF $IN[%d] <> %s THEN LOOP HALT ENDLOOP ENDIF WAIT SEC 0.100", value, io,
                     value);
        expect(words);
    }
    return id;
}

/* the same that a program's head says */
static unsigned id_of_head(void) {
    const char *found = strstr(text, "Run id ");
    ck_assert_ptr_nonnull(found);
    return (unsigned)strtoul(found + 7, NULL, 16);
}

TEST(urscript_parses_and_says_what_the_motion_is) {
    make();
    comment_mark = '#';
    int turning = 0; /* where a mount stands, its tool follows the wire all the same */
    for (int robot = 0; robot < 2; robot++) {
        load(WCUT_ROBOT_FORMAT_URSCRIPT, robot, NULL);
        double x, y, z, v[3], a, speed, t, zone, r[3][3];
        expect(robot ? "def wirecut_b(): block = p[0, 0, 0, 0, 0, 0]" : "def wirecut_a(): block = p[0, 0, 0, 0, 0, 0]");
        expect("set_digital_out(1, False) movel(pose_trans(block, p[");
        skip();
        expect("#, #, #, #, #, #]), a=#, v=#)", &x, &y, &z, &v[0], &v[1], &v[2], &a, &speed);
        check_place(robot, 0, 1000 * x, 1000 * y, 1000 * z);
        ck_assert(a == 1 && speed == 0.05);
        if (robot == 0) expect("wire_on()");
        expect("set_digital_out(1, True) while (get_digital_in(1) == False): sync() end");
        ck_assert_uint_eq(expect_run_id(true, 1), id_of_head());
        for (int i = 1; i < motion->count; i++) {
            if (stands(robot, i)) {
                expect("sleep(#)", &t);
                ck_assert_double_eq_tol(t, motion->target[i].duration, 1e-6);
                continue;
            }
            expect("movel(pose_trans(block, p[#, #, #, #, #, #]), a=#, v=#, t=#, r=#)", &x, &y, &z, &v[0], &v[1], &v[2],
                   &a, &speed, &t, &zone);
            turning += creeps(robot, i);
            check_place(robot, i, 1000 * x, 1000 * y, 1000 * z);
            from_vector(v, r);
            check_axes(robot, i, r, 3e-6);
            ck_assert_double_eq_tol(1000 * speed, speed_of(robot, i), 1e-3);
            ck_assert_double_eq_tol(t, motion->target[i].duration, 1e-6);
            ck_assert_double_eq_tol(1000 * zone, zone_of(robot, i), 1e-3);
        }
        expect("set_digital_out(1, False)");
        if (robot == 0) expect("wire_off()");
        expect("end");
        skip();
        ck_assert(*at == 0);
    }
    ck_assert_int_gt(turning, 0);
}

TEST(rapid_parses_and_says_what_the_motion_is) {
    make();
    comment_mark = '!';
    for (int robot = 0; robot < 2; robot++) {
        load(WCUT_ROBOT_FORMAT_RAPID, robot, NULL);
        double x, y, z, q[4], speed, id, zone[5];
        expect(robot ? "MODULE wirecut_b" : "MODULE wirecut_a");
        char words[200], on[60], off[60];
        snprintf(on, sizeof on, "SyncMoveOn wirecut_on_%03x, wirecut_tasks;", id_of_head());
        snprintf(off, sizeof off, "SyncMoveOff wirecut_off_%03x;", id_of_head());
        snprintf(
            words, sizeof words,
            "PERS tasks wirecut_tasks{2} := [[\"T_ROB1\"],[\"T_ROB2\"]]; VAR syncident wirecut_on_%03x; VAR syncident "
            "wirecut_off_%03x;",
            id_of_head(), id_of_head());
        expect(words);
        expect(robot ? "PROC wirecut_b_main() ConfL \\Off;" : "PROC wirecut_a_main() ConfL \\Off;");
        const char *rest = "[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        for (int i = 0; i < motion->count; i++) {
            expect("MoveL [[#,#,#],[#,#,#,#],", &x, &y, &z, &q[0], &q[1], &q[2], &q[3]);
            expect(rest);
            check_place(robot, i, x, y, z);
            const double *frame = robot ? motion->target[i].frame_b : motion->target[i].frame_a;
            for (int k = 0; k < 4; k++) ck_assert_double_eq_tol(q[k], frame[k], 0.51e-9);
            if (i > 0) {
                expect("\\ID:=#", &id);
                ck_assert(id == 10 * i);
            }
            expect(", [#,500,5000,1000],", &speed);
            if (i > 0) ck_assert_double_eq_tol(speed, fmax(speed_of(robot, i), 0.01), 0.51e-3);
            if (sees("fine")) {
                expect("fine");
                ck_assert(zone_of(robot, i) < 5e-4);
            } else {
                expect("[FALSE,#,#,#,0.150,#,0.150]", &zone[0], &zone[1], &zone[2], &zone[3]);
                ck_assert_double_eq_tol(zone[0], zone_of(robot, i), 0.51e-3);
            }
            expect(", wirecut_tool\\WObj:=wirecut_block;");
            if (i == 0 && robot == 0) expect("wire_on;");
            if (i == 0) expect(on);
        }
        expect(off);
        if (robot == 0) expect("wire_off;");
        expect("ENDPROC ENDMODULE");
        skip();
        ck_assert(*at == 0);
    }
}

TEST(krl_parses_and_says_what_the_motion_is) {
    make();
    comment_mark = ';';
    const wcut_robot_names names = {.program = "cut7",
                                    .wire_on = "heat",
                                    .wire_off = NULL,
                                    .sync_io = 12,
                                    .approach_speed = 30,
                                    .approach_acceleration = 500,
                                    .preheat = 2.5,
                                    .heat = 65,
                                    .tension = 2,
                                    .wire_length = 606};
    int turns = 0;
    for (int robot = 0; robot < 2; robot++) {
        load(WCUT_ROBOT_FORMAT_KRL, robot, &names);
        double x, y, z, abc[3], speed, zone, t, r[3][3];
        expect(robot ? "DEF cut7_b ( )" : "DEF cut7_a ( )");
        skip();
        ck_assert_int_eq(strncmp(at, "BAS (#INITMOV,0)", 16), 0);
        at += 16;
        expect("$TOOL = TOOL_DATA[1] $BASE = BASE_DATA[1] $ORI_TYPE = ");
        skip();
        ck_assert_int_eq(strncmp(at, "#VAR", 4), 0);
        at += 4;
        double acceleration, ori[2];
        expect("$ADVANCE = 3 $ACC.CP = # $VEL.ORI1 = # $VEL.ORI2 = # PTP $AXIS_ACT $OUT[12] = FALSE", &acceleration,
               &ori[0], &ori[1]);
        expect("$VEL.CP = # LIN {X #, Y #, Z #, A #, B #, C #}", &speed, &x, &y, &z, &abc[0], &abc[1], &abc[2]);
        check_place(robot, 0, x, y, z);
        ck_assert(acceleration == 0.5 && speed == 0.03 && ori[0] == 200 && ori[1] == 200);
        ck_assert(strstr(text, "heat 65.000 W/m; tension 2.000 N; length from mount to mount 606.000 mm"));
        ck_assert(strstr(text, "A calls heat, to be defined"));
        if (robot == 0) expect("heat ( ) WAIT SEC 2.500");
        expect("$OUT[12] = TRUE WAIT FOR $IN[12]");
        ck_assert_uint_eq(expect_run_id(false, 12), id_of_head());
        double last[3] = {x, y, z}, late = 0;
        for (int i = 1; i < motion->count; i++) {
            if (stands(robot, i)) {
                expect("WAIT SEC #", &t);
                ck_assert_double_eq_tol(t, motion->target[i].duration, 1e-6);
                continue;
            }
            if (sees("$VEL.ORI1")) { /* it turns where it stands, and takes the time of the move for it */
                expect(
                    "$VEL.ORI1 = # $VEL.ORI2 = # LIN {X #, Y #, Z #, A #, B #, C #} $VEL.ORI1 = 200.000000 $VEL.ORI2 = "
                    "200.000000",
                    &ori[0], &ori[1], &x, &y, &z, &abc[0], &abc[1], &abc[2]);
                ck_assert_double_eq_tol(ori[0] * motion->target[i].duration, turn_at(robot, i) * 180 / acos(-1), 2e-3);
                turns++;
            } else {
                const bool blends = sees("$APO");
                if (blends) {
                    expect("$APO.CDIS = #", &zone);
                    ck_assert_double_eq_tol(zone, zone_of(robot, i), 0.51e-3);
                }
                expect("$VEL.CP = # LIN {X #, Y #, Z #, A #, B #, C #}", &speed, &x, &y, &z, &abc[0], &abc[1], &abc[2]);
                if (blends) expect("C_DIS");
                ck_assert_double_gt(speed, 0);

                /* way over speed as printed is the time of the move: the arms stay together */
                const double way = sqrt(pow(x - last[0], 2) + pow(y - last[1], 2) + pow(z - last[2], 2));
                late += way / (1000 * speed) - motion->target[i].duration;
                ck_assert_double_lt(fabs(late), 1e-3);
            }
            last[0] = x, last[1] = y, last[2] = z;
            check_place(robot, i, x, y, z);
            from_euler(abc, r);
            check_axes(robot, i, r, 3e-6);
        }
        expect("$OUT[12] = FALSE END");
        skip();
        ck_assert(*at == 0);
    }
    ck_assert_int_gt(turns, 0);
}

TEST(a_run_id_is_that_of_both_programs_and_of_no_other_run) {
    make();
    unsigned id[4];
    for (int robot = 0; robot < 2; robot++) {
        load(WCUT_ROBOT_FORMAT_URSCRIPT, robot, NULL);
        id[robot] = id_of_head();
    }
    wcut_robot_names names = wcut_robot_names_default();
    names.title = "another job";
    load(WCUT_ROBOT_FORMAT_KRL, 0, &names);
    id[2] = id_of_head();
    motion->target[motion->count / 2].a.z += 0.01;
    load(WCUT_ROBOT_FORMAT_URSCRIPT, 0, NULL);
    id[3] = id_of_head();
    ck_assert(id[0] == id[1] && id[0] != id[2] && id[0] != id[3]);
}

TEST(outputs_that_a_controller_lacks_are_refused) {
    make();
    wcut_robot_names names = wcut_robot_names_default();
    const struct {
        wcut_robot_format format;
        int io;
        wcut_status status;
    } of[] = {{WCUT_ROBOT_FORMAT_URSCRIPT, 7, WCUT_OK},
              {WCUT_ROBOT_FORMAT_URSCRIPT, 8, WCUT_BAD_ARGUMENT},
              {WCUT_ROBOT_FORMAT_KRL, 0, WCUT_BAD_ARGUMENT},
              {WCUT_ROBOT_FORMAT_KRL, 255, WCUT_OK}};
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        names.sync_io = of[k].io;
        ck_assert_int_eq(wcut_robot_write(motion, &names, of[k].format, 0, "test_robot.io", &error), of[k].status);
        if (of[k].status != WCUT_OK) ck_assert_msg(strstr(error.text, "sync_io"), "%s", error.text);
    }
    remove("test_robot.io");
}

TEST(mounts_that_start_against_each_other_have_a_lead_of_their_common_way) {
    for (int j = 0; j < STATIONS; j++) {
        mount_a[j] = (wcut_vec3){-60, j < 5 ? 10 - 2.0 * j : 2 + 10.0 * (j - 4), 150};
        mount_b[j] = (wcut_vec3){460, j < 5 ? 2.0 * j : 8 + 10.0 * (j - 4), 150};
    }
    make();
    ck_assert_int_eq(motion->target[0].station, -1);
    ck_assert_double_eq_tol(motion->target[0].a.y, mount_a[0].y - 20, 1e-9);
    ck_assert_double_eq_tol(motion->target[0].b.y, mount_b[0].y - 20, 1e-9);
    wcut_robot_motion_destroy(motion);
    motion = NULL;
    for (int j = 0; j < STATIONS; j++) mount_b[j].y = -mount_a[j].y;
    ck_assert_int_eq(wcut_robot_motion_create(&history, mount_a, mount_b, &options, &motion, &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_msg(strstr(error.text, "a lead"), "%s", error.text);
}

TEST(the_table_and_the_object_say_what_the_motion_is) {
    make();
    comment_mark = 0;
    load(WCUT_ROBOT_FORMAT_CSV, 0, NULL);
    at = strchr(text, '\n') + 1;
    for (int i = 0; i < motion->count; i++) {
        double number, v[20];
        expect("#,", &number);
        ck_assert(number == i);
        if (motion->target[i].station >= 0) {
            expect("#", &number);
            ck_assert(number == motion->target[i].station);
        }
        for (int k = 0; k < 20; k++) expect(",#", &v[k]);
        ck_assert_double_eq_tol(v[0], motion->target[i].time, 1e-6);
        check_place(0, i, v[2], v[3], v[4]);
        check_place(1, i, v[5], v[6], v[7]);
        ck_assert_double_eq_tol(v[19], motion->target[i].frame_b[3], 1e-9);
        expect(","); /* no change of heat */
    }
    skip();
    ck_assert(*at == 0);
    load(WCUT_ROBOT_FORMAT_JSON, 0, NULL);
    for (int i = 0; i < motion->count; i++) { /* exact */
        wcut_vec3 p = place(1, i);
        at = strstr(at, "\"b\": {\"at_mm\": [") + 16;
        char *end;
        ck_assert(strtod(at, &end) == p.x && strtod(end + 1, &end) == p.y && strtod(end + 1, NULL) == p.z);
    }
}

/* ---- the motion ---- */

/* where a mount is at a time, going straight and evenly between targets */
static wcut_vec3 program_at(int robot, double time) {
    int i = motion->first;
    while (i < motion->last - 1 && motion->target[i + 1].time <= time) i++;
    const wcut_robot_target *f = &motion->target[i], *t = f + 1;
    const double s = (time - f->time) / (t->time - f->time);
    const wcut_vec3 a = place(robot, i), b = place(robot, i + 1);
    return (wcut_vec3){a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
}

TEST(thinned_targets_keep_both_mounts_within_their_tolerances_at_every_moment) {
    const double tolerance[] = {1, 0.1, 0.01, 1e-4};
    int before = 0;
    for (int k = 0; k < 4; k++) {
        options.chord_tolerance = tolerance[k];
        options.time_tolerance = 5 * tolerance[k];
        options.angle_tolerance = 1;
        make();
        ck_assert_int_ge(motion->count, before);
        before = motion->count;
        ck_assert_double_le(motion->chord_error, tolerance[k]);
        ck_assert_double_le(motion->time_error, 5 * tolerance[k]);
        const double begin = motion->target[motion->first].time;
        for (int j = 0; j < STATIONS; j++)
            for (int robot = 0; robot < 2; robot++) {
                const wcut_vec3 p = program_at(robot, begin + row[j].time), q = robot ? mount_b[j] : mount_a[j];
                const double off =
                    sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z));
                ck_assert_double_le(off, hypot(tolerance[k], 5 * tolerance[k]) + 1e-9);
            }
        wcut_robot_motion_destroy(motion);
        motion = NULL;
    }
    ck_assert_int_eq(before, STATIONS + 2); /* nothing is left out of an arc at a ten thousandth */
}

TEST(leads_run_along_the_feed_and_zones_never_meet) {
    options.zone = 50;
    make();
    const wcut_robot_target *t = motion->target;
    ck_assert_int_eq(motion->first, 1);
    ck_assert_int_eq(motion->last, motion->count - 2);
    ck_assert_int_eq(t[0].station, -1);
    ck_assert_int_eq(t[motion->count - 1].station, -2);
    ck_assert(t[0].time == 0 && t[0].duration == 0 && t[0].zone_a == 0 && t[motion->count - 1].zone_b == 0);
    const double dx = t[1].a.x - t[0].a.x, dy = t[1].a.y - t[0].a.y, dz = t[1].a.z - t[0].a.z;
    ck_assert_double_eq_tol(sqrt(dx * dx + dy * dy + dz * dz), 20, 1e-9);
    ck_assert_double_eq_tol(t[1].b.y - t[0].b.y, dy, 1e-12); /* both by the same vector: the wire keeps its chord */
    ck_assert_double_gt(dy, 0);
    for (int i = 1; i < motion->count; i++) {
        ck_assert_double_eq_tol(t[i].time - t[i - 1].time, t[i].duration, 1e-12);
        for (int robot = 0; robot < 2; robot++)
            ck_assert_double_le(zone_of(robot, i - 1) + zone_of(robot, i),
                                0.8 * speed_of(robot, i) * t[i].duration + 1e-9);
    }
}

TEST(a_fixed_frame_looks_into_the_cut_from_both_sides) {
    options.frame = WCUT_TOOL_FRAME_FIXED;
    make();
    for (int i = 0; i < motion->count; i++) {
        double x[3], z[3];
        axes(0, i, x, z);
        ck_assert(x[0] == 1 && z[2] == 1);
        axes(1, i, x, z);
        ck_assert_double_eq_tol(x[0], -1, 1e-15);
        ck_assert_double_eq_tol(z[2], 1, 1e-15);
    }
}

TEST(a_following_frame_looks_along_the_wire) {
    make();
    const int i = motion->last, j = motion->target[i].station;
    double x[3], z[3];
    axes(0, i, x, z);
    ck_assert_double_eq_tol(atan2(-x[1], x[0]), row[j].alpha_a, 1e-12);
    ck_assert_double_eq_tol(atan2(x[2], hypot(x[0], x[1])), row[j].beta_a, 1e-12);
    axes(1, i, x, z);
    ck_assert_double_eq_tol(atan2(-x[1], -x[0]), row[j].alpha_b, 1e-12);
    ck_assert_double_eq_tol(atan2(x[2], hypot(x[0], x[1])), row[j].beta_b, 1e-12);
    ck_assert_double_gt(z[2], 0.9);
}

/* ---- limits ---- */

TEST(the_wire_in_air_is_as_hot_as_its_tables_say) {
    double at_65 = 999, at_85 = 999, cold = 999;
    ck_assert_int_eq(wcut_wire_temperature(65, 0.15, 20, 0.7, &at_65), WCUT_OK);
    ck_assert_int_eq(wcut_wire_temperature(85, 0.15, 20, 0.7, &at_85), WCUT_OK);
    ck_assert_int_eq(wcut_wire_temperature(0, 0.15, 20, 0.7, &cold), WCUT_OK);
    ck_assert_double_eq_tol(at_65, 650, 25);
    ck_assert_double_eq_tol(at_85, 760, 25);
    ck_assert_double_eq_tol(cold, 20, 1e-3);
    ck_assert_int_eq(wcut_wire_temperature(-1, 0.15, 20, 0.7, &cold), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_wire_temperature(60, 0, 20, 0.7, &cold), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_wire_temperature(60, 0.15, NAN, 0.7, &cold), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_wire_temperature(60, 0.15, 20, 1.1, &cold), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_wire_temperature(1e6, 0.15, 20, 0.7, &cold), WCUT_BAD_ARGUMENT);
    ck_assert_double_eq_tol(cold, 20, 1e-3);
}

TEST(limits_are_told_with_their_numbers_and_their_station) {
    wcut_job job = {.heat = 85, .wire_diameter = 0.15, .speed_max = 100};
    wcut_robot_limits limits = wcut_robot_limits_default(&job);
    limits.alpha = 0.25;
    wcut_robot_check check[WCUT_ROBOT_CHECKS];
    mount_b[40].y = 230; /* a jerk */
    ck_assert_int_eq(wcut_robot_limits_check(&job, &history, mount_a, mount_b, &limits, check), WCUT_OK);
    ck_assert_str_eq(check[1].name, "speed of mount B");
    ck_assert_int_eq(check[1].station, 41 - (row[41].duration > row[40].duration));
    ck_assert_double_eq_tol(check[1].value, 30 / row[40].duration, 1e-9);
    ck_assert(check[1].over && check[1].limit == 100 && !check[0].over);
    ck_assert_int_eq(check[3].station, 40);
    ck_assert_double_eq_tol(check[4].value, 0.3 * 180 / acos(-1), 1e-9);
    ck_assert(check[4].over && !check[5].over);
    ck_assert(check[6].limit == 30); /* not 29.999999999999996 */
    ck_assert_double_eq_tol(check[8].value, 759.4, 1);
    ck_assert_double_eq_tol(check[9].value, 2 / (acos(-1) / 4 * 0.15 * 0.15), 1e-9);                   /* 113 MPa */
    ck_assert_double_eq_tol(check[9].limit, 725 * pow(34.0 / 725, (check[8].value - 20) / 880), 1e-9); /* 55.4 MPa */
    ck_assert(check[9].over && !check[8].over);
    limits.hot_strength = 0;
    check[0].value = 999;
    ck_assert_int_eq(wcut_robot_limits_check(&job, &history, mount_a, mount_b, &limits, check), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_robot_limits_check(NULL, &history, mount_a, mount_b, NULL, check), WCUT_BAD_ARGUMENT);
    ck_assert(check[0].value == 999);
}

/* ---- what is refused ---- */

TEST(options_out_of_range_are_refused_and_nothing_is_written) {
    wcut_robot_options bad[7];
    for (int k = 0; k < 7; k++) bad[k] = options;
    bad[0].chord_tolerance = 0;
    bad[1].time_tolerance = NAN;
    bad[2].angle_tolerance = -1;
    bad[3].lead_in = -1;
    bad[4].lead_out = INFINITY;
    bad[5].zone = -1;
    bad[6].frame = (wcut_tool_frame)7;
    for (int k = 0; k < 7; k++)
        ck_assert_int_eq(wcut_robot_motion_create(&history, mount_a, mount_b, &bad[k], &motion, &error),
                         WCUT_BAD_ARGUMENT);
    row[9].time = row[8].time;
    ck_assert_int_eq(wcut_robot_motion_create(&history, mount_a, mount_b, NULL, &motion, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "station 9"));
    ck_assert_int_eq(wcut_robot_motion_create(NULL, mount_a, mount_b, NULL, &motion, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(motion);
    wcut_robot_motion_destroy(NULL);
}

TEST(names_that_could_say_something_else_are_refused) {
    make();
    const char *const name[] = {"",        "1st",      "a b", "x()",
                                "wire-on", "\xc3\xa4", "a;b", "this_name_is_far_too_long_for_it"};
    for (size_t k = 0; k < sizeof name / sizeof *name; k++) {
        wcut_robot_names n = wcut_robot_names_default();
        n.wire_on = name[k];
        ck_assert_int_eq(wcut_robot_write(motion, &n, WCUT_ROBOT_FORMAT_KRL, 0, "test_robot.none", &error),
                         WCUT_BAD_ARGUMENT);
        n.wire_on = NULL;
        n.program = name[k];
        ck_assert_int_eq(wcut_robot_write(motion, &n, WCUT_ROBOT_FORMAT_KRL, 0, "test_robot.none", &error),
                         WCUT_BAD_ARGUMENT);
    }
    wcut_robot_names n = wcut_robot_names_default();
    n.sync_io = 256;
    ck_assert_int_eq(wcut_robot_write(motion, &n, WCUT_ROBOT_FORMAT_KRL, 0, "test_robot.none", &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_robot_write(motion, NULL, WCUT_ROBOT_FORMAT_CSV, 1, "test_robot.none", &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_robot_write(motion, NULL, (wcut_robot_format)9, 0, "test_robot.none", &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_robot_write(NULL, NULL, WCUT_ROBOT_FORMAT_KRL, 0, "test_robot.none", &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_robot_write(motion, NULL, WCUT_ROBOT_FORMAT_KRL, 0, "nowhere/at/all", &error),
                     WCUT_NOT_WRITTEN);
    wcut_alloc_fail_at(1);
    ck_assert_int_eq(wcut_robot_write(motion, NULL, WCUT_ROBOT_FORMAT_KRL, 0, "test_robot.none", &error),
                     WCUT_NO_MEMORY);
    wcut_alloc_fail_at(0);
    ck_assert_int_ne(access("test_robot.none", F_OK), 0);
}

TEST(a_title_cannot_end_a_comment) {
    make();
    wcut_robot_names n = wcut_robot_names_default();
    n.title = "one\nset_digital_out(7, True)\r\x1b[2J";
    load(WCUT_ROBOT_FORMAT_URSCRIPT, 0, &n);
    ck_assert_ptr_nonnull(strstr(text, "# one?set_digital_out(7, True)??[2J\n"));
    ck_assert_ptr_null(strstr(text, "\nset_digital_out(7"));
}

FIXTURE(prepare, forget);
