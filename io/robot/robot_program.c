/* Robot programs: URScript (Universal Robots), RAPID with MultiMove (ABB), KRL (KUKA); an honest subset of each. */
#include "io/robot/robot_program.h"
#include <wirecut/angle.h>
#include <wirecut/robot_file.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>

#define STANDING 5e-4   /* [mm] a shorter way is printed as none */
#define STILL 1e-5      /* [rad] a smaller turn of the tool is none */
#define ORI_SPEED 200.0 /* [deg/s] of the tool where the way sets the time, KRL */
#define RUN_ID_BITS 12
#define BIT_TIME 0.1 /* [s] half a bit of the run id: far above the cycle of either controller */

/* one robot's half of a target */
typedef struct half {
    wcut_vec3 at;
    double speed, zone, duration, way;
    const double *frame;
} half;

static half half_of(const wcut_robot_motion *m, int arm, int i) {
    const wcut_robot_target *t = &m->target[i];
    const int robot = arm == 1; /* one robot is in the place of A */
    const double speed = robot ? t->speed_b : t->speed_a;
    return (half){.at = robot ? t->b : t->a,
                  .speed = speed,
                  .zone = robot ? t->zone_b : t->zone_a,
                  .duration = t->duration,
                  .way = speed * t->duration,
                  .frame = robot ? t->frame_b : t->frame_a};
}

/* the angle between two frames [rad] */
static double frame_angle(const double p[4], const double q[4]) {
    double dot = 0;
    for (int k = 0; k < 4; k++) dot += p[k] * q[k];
    double sine = 0; /* of half the angle: accurate where it is small */
    for (int k = 0; k < 4; k++) sine += (p[k] - (dot < 0 ? -q[k] : q[k])) * (p[k] - (dot < 0 ? -q[k] : q[k]));
    return 4 * asin(fmin(1, sqrt(sine) / 2));
}

/* where a controller is sent: to 1e-3 mm */
static wcut_vec3 printed(wcut_vec3 p) {
    return (wcut_vec3){round(p.x * 1000) / 1000, round(p.y * 1000) / 1000, round(p.z * 1000) / 1000};
}

static double flange_distance(wcut_vec3 p, wcut_vec3 q) {
    return sqrt((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z));
}

/* twelve bits of all targets and the title: FNV-1a (Fowler, Noll, Vo 1991) over what is printed */
static unsigned run_id(const wcut_robot_motion *m, const wcut_robot_names *names) {
    uint32_t hash = 2166136261u;
    for (const char *c = names->title; c && *c; c++) hash = (hash ^ (unsigned char)*c) * 16777619u;
    for (int i = 0; i < m->count; i++) {
        const wcut_robot_target *t = &m->target[i];
        const double value[] = {t->time, t->a.x, t->a.y, t->a.z, t->b.x, t->b.y, t->b.z};
        for (size_t k = 0; k < sizeof value / sizeof *value; k++) {
            const long long number = llround(value[k] * 1000);
            for (int byte = 0; byte < 8; byte++)
                hash = (hash ^ (unsigned char)((unsigned long long)number >> (8 * byte))) * 16777619u;
        }
    }
    return (hash ^ (hash >> RUN_ID_BITS) ^ (hash >> (2 * RUN_ID_BITS))) & ((1u << RUN_ID_BITS) - 1);
}

void wcut_text_fixed(wcut_text *text, double value, int decimals) {
    static const double power[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
    const long long scaled = llround(fabs(value) * power[decimals]), one = (long long)power[decimals];
    const char *sign = value < 0 && scaled > 0 ? "-" : "";
    if (decimals == 0)
        wcut_text_print(text, "%s%lld", sign, scaled);
    else
        wcut_text_print(text, "%s%lld.%0*lld", sign, scaled / one, decimals, scaled % one);
}

static void put_rounded(wcut_text *text, const char *before, double value, int decimals) {
    wcut_text_print(text, "%s", before);
    wcut_text_fixed(text, value, decimals);
}

/* a comment's text: one line of printable ASCII */
static void put_comment(wcut_text *text, const char *mark, const char *words) {
    char line[121];
    int n = 0;
    for (; n < 120 && words[n]; n++) line[n] = words[n] >= ' ' && words[n] <= '~' ? words[n] : '?';
    line[n] = 0;
    wcut_text_print(text, "%s%s\n", mark, line);
}

static int count_heats(const wcut_robot_motion *m) {
    int count = 0;
    for (int i = 0; i < m->count; i++) count += m->target[i].heat > 0;
    return count;
}

/* the power that robot A sets where target i is reached; 0: none */
static double target_heat(const wcut_robot_motion *m, int robot, int i) { return robot != 1 ? m->target[i].heat : 0; }

/* what stands behind the name of a program */
static const char *suffix_of(int robot) {
    static const char *const text[] = {"_a", "_b", ""};
    return text[robot];
}

/* whether a program switches the wire: A's, or the only one */
static bool switches(int robot) { return robot != 1; }

static void put_program_head(wcut_text *text, const char *mark, const wcut_robot_motion *m,
                             const wcut_robot_names *names, int robot) {
    /* what the program is, for whoever opens it at the cell */
    if (m->single)
        wcut_text_print(text, "%swirecut: one arm that holds the wire by both ends; %d targets of %d stations, ", mark,
                        m->count, m->stations);
    else
        wcut_text_print(text, "%swirecut: mount %c of two that cut one wire; %d targets of %d stations, ", mark,
                        robot ? 'B' : 'A', m->count, m->stations);
    put_rounded(text, "", m->duration, 3);
    wcut_text_print(text, " s\n");

    if (names->title && *names->title) put_comment(text, mark, names->title);
    wcut_text_print(text, "%sPositions are in the frame of the foam block: x across from A to B, y the feed, z up.\n",
                    mark);
    if (m->single)
        wcut_text_print(
            text, "%sTool: the frame of the job's poses, in which both ends of the wire have their places.\n", mark);
    else
        wcut_text_print(text,
                        "%sTool: its x axis looks along the wire into the cut, its z axis up.\n"
                        "%sRun id %03x: the other program has the same, or neither starts.\n",
                        mark, mark, run_id(m, names));

    /* what the cell sets before it starts */
    wcut_text_print(text, "%sWire:", mark);
    if (names->heat > 0) put_rounded(text, " heat ", names->heat, 3), wcut_text_print(text, " W/m;");
    if (names->tension > 0) put_rounded(text, " tension ", names->tension, 3), wcut_text_print(text, " N;");
    if (names->wire_length > 0)
        put_rounded(text, " length from mount to mount ", names->wire_length, 3), wcut_text_print(text, " mm;");
    if (names->preheat > 0)
        put_rounded(text, " heated for ", names->preheat, 3), wcut_text_print(text, " s before the start;");
    if (count_heats(m) > 0)
        wcut_text_print(text, " %s %s with a power in W/m, %d times, to be defined by the cell;",
                        m->single ? "calls" : "A calls", names->wire_heat, count_heats(m));
    if (names->wire_on || names->wire_off)
        wcut_text_print(text, " %s %s%s%s, to be defined by the cell.\n", m->single ? "It calls" : "A calls",
                        names->wire_on ? names->wire_on : "", names->wire_on && names->wire_off ? " and " : "",
                        names->wire_off ? names->wire_off : "");
    else
        wcut_text_print(text, " these programs do not switch it.\n");
}

/* angle and axis of a unit quaternion with w >= 0, as a rotation vector */
static void rotation_vector(const double q[4], double v[3]) {
    const double sine = sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const double scale = sine > 1e-12 ? 2 * atan2(sine, q[0]) / sine : 2;
    for (int k = 0; k < 3; k++) v[k] = scale * q[k + 1];
}

/* KUKA's A, B, C [deg]: R = Rz(A) Ry(B) Rx(C) */
static void euler_angles(const double q[4], double abc[3]) {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double sine = 2 * (w * y - z * x);
    abc[0] = atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)) * WCUT_DEG_PER_RAD;
    abc[1] = asin(sine < -1 ? -1 : sine > 1 ? 1 : sine) * WCUT_DEG_PER_RAD;
    abc[2] = atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)) * WCUT_DEG_PER_RAD;
}

/* ---- URScript: metres, rotation vectors, a duration for every move ---- */

static void put_ur_pose(wcut_text *text, const half *h) {
    double v[3];
    rotation_vector(h->frame, v);
    put_rounded(text, "pose_trans(block, p[", h->at.x / 1000, 6);
    put_rounded(text, ", ", h->at.y / 1000, 6);
    put_rounded(text, ", ", h->at.z / 1000, 6);
    for (int k = 0; k < 3; k++) put_rounded(text, ", ", v[k], 6);
    wcut_text_print(text, "])");
}

/* the words of a dialect about digital signals */
typedef struct signal_words {
    const char *set, *set_to, *set_end;   /* output, its value */
    const char *wait, *wait_end;          /* seconds */
    const char *test, *test_for, *refuse; /* input, its value; what is done where it has another */
    const char *high, *low;
} signal_words;

static const signal_words ur_signal = {"  set_digital_out(",
                                       ", ",
                                       ")\n",
                                       "  sleep(",
                                       ")\n",
                                       "  if (get_digital_in(",
                                       ") != ",
                                       "):\n    popup(\"programs of different runs\", \"wirecut\", False, True, True)\n"
                                       "    halt\n  end\n",
                                       "True",
                                       "False"};

static const signal_words krl_signal = {"$OUT[", "] = ",    "\n",    "WAIT SEC ",
                                        "\n",    "IF $IN[", "] <> ", " THEN\nLOOP\nHALT\nENDLOOP\nENDIF\n",
                                        "TRUE",  "FALSE"};

static void put_wait(wcut_text *text, const signal_words *w, double time) {
    put_rounded(text, w->wait, time, 3);
    wcut_text_put_word(text, w->wait_end);
}

/* Both robots send and read the run id at the same time, a bit every two BIT_TIME, read in the middle. */
static void put_run_id(wcut_text *text, const signal_words *w, unsigned id, int io) {
    for (int k = RUN_ID_BITS - 1; k >= 0; k--) {
        const char *bit = id >> k & 1 ? w->high : w->low;
        wcut_text_print(text, "%s%d%s%s%s", w->set, io, w->set_to, bit, w->set_end);
        put_wait(text, w, BIT_TIME);
        wcut_text_print(text, "%s%d%s%s%s", w->test, io, w->test_for, bit, w->refuse);
        put_wait(text, w, BIT_TIME);
    }
}

void wcut_urscript_put(wcut_text *text, const wcut_robot_motion *m, const wcut_robot_names *names, int robot) {
    const int io = names->sync_io;

    /* the head: what is to be set at the cell */
    wcut_text_print(text, "def %s%s():\n", names->program, suffix_of(robot));
    put_program_head(text, "  # ", m, names, robot);
    if (m->single)
        wcut_text_print(text,
                        "  # To be set: block, the pose of the foam block in the robot's base; the TCP.\n"
                        "  block = p[0, 0, 0, 0, 0, 0]\n");
    else
        wcut_text_print(
            text,
            "  # To be set: block, the pose of the foam block in this robot's base; the TCP; digital output %d\n"
            "  # of either controller wired to input %d of the other. Both start together and then keep the\n"
            "  # time of every move; their clocks are not coupled.\n"
            "  block = p[0, 0, 0, 0, 0, 0]\n",
            io, io);

    /* no start signal of an earlier run, then to the first target */
    const double acceleration = names->approach_acceleration / 1000;
    if (!m->single) wcut_text_print(text, "  set_digital_out(%d, False)\n", io);
    half h = half_of(m, robot, 0);
    wcut_text_print(text, "  movel(");
    put_ur_pose(text, &h);
    put_rounded(text, ", a=", acceleration, 6);
    put_rounded(text, ", v=", names->approach_speed / 1000, 6);
    wcut_text_print(text, ")\n");
    if (switches(robot) && names->wire_on) wcut_text_print(text, "  %s()\n", names->wire_on);
    if (switches(robot) && names->preheat > 0) {
        put_rounded(text, "  sleep(", names->preheat, 3);
        wcut_text_print(text, ")\n");
    }

    /* both are there; the run id; both start */
    if (!m->single) {
        wcut_text_print(
            text, "  set_digital_out(%d, True)\n  while (get_digital_in(%d) == False):\n    sync()\n  end\n", io, io);
        put_run_id(text, &ur_signal, run_id(m, names), io);
    }

    /* a move for each target; one that neither goes nor turns is a pause */
    half last = h;
    for (int i = 1; i < m->count; i++) {
        if (target_heat(m, robot, i - 1) > 0) {
            wcut_text_print(text, "  %s", names->wire_heat);
            put_rounded(text, "(", target_heat(m, robot, i - 1), 3);
            wcut_text_print(text, ")\n");
        }
        h = half_of(m, robot, i);
        if (h.way < STANDING && frame_angle(last.frame, h.frame) < STILL) {
            put_rounded(text, "  sleep(", h.duration, 6);
            wcut_text_print(text, ")\n");
            continue;
        }
        wcut_text_print(text, "  movel(");
        put_ur_pose(text, &h);
        put_rounded(text, ", a=", acceleration, 6);
        put_rounded(text, ", v=", h.speed / 1000, 6);
        put_rounded(text, ", t=", h.duration, 6);
        put_rounded(text, ", r=", h.zone / 1000, 6);
        wcut_text_print(text, ")\n");
        last = h;
    }

    /* tell the other robot, switch the wire off */
    if (!m->single) wcut_text_print(text, "  set_digital_out(%d, False)\n", io);
    if (switches(robot) && names->wire_off) wcut_text_print(text, "  %s()\n", names->wire_off);
    wcut_text_print(text, "end\n");
}

/* ---- RAPID: millimetres, quaternions, MultiMove: moves of one ID end together ---- */

/* calls: a procedure is called in the middle of the zone (MoveLSync), not when the program runs ahead; timed: the move takes
   its duration, however much of it the tool turns */
static void put_rapid_move(wcut_text *text, const half *h, int id, double speed, bool timed, bool calls) {
    /* target: position, quaternion, external axes unused */
    wcut_text_print(text, "    MoveL%s", calls ? "Sync" : "");
    put_rounded(text, " [[", h->at.x, 3);
    put_rounded(text, ",", h->at.y, 3);
    put_rounded(text, ",", h->at.z, 3);
    for (int k = 0; k < 4; k++) put_rounded(text, k ? "," : "],[", h->frame[k], 9);
    wcut_text_print(text, "],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    if (id > 0) wcut_text_print(text, "\\ID:=%d", id);

    /* speed in mm/s, reorientation 500 deg/s */
    put_rounded(text, ", [", speed, 3);
    wcut_text_print(text, ",500,5000,1000]");
    if (timed) put_rounded(text, "\\T:=", h->duration, 6);
    wcut_text_print(text, ", ");

    /* zone: a stop point, or a fly-by radius in mm */
    if (h->zone < 5e-4) {
        wcut_text_print(text, "fine");
    } else {
        put_rounded(text, "[FALSE,", h->zone, 3);
        put_rounded(text, ",", 1.5 * h->zone, 3);
        put_rounded(text, ",", 1.5 * h->zone, 3);
        put_rounded(text, ",0.150,", 1.5 * h->zone, 3);
        wcut_text_print(text, ",0.150]");
    }
}

static void put_rapid_heat(wcut_text *text, const wcut_robot_names *names, double heat) {
    if (!(heat > 0)) return;
    wcut_text_print(text, "    %s", names->wire_heat);
    put_rounded(text, " ", heat, 3);
    wcut_text_print(text, ";\n");
}

void wcut_rapid_put(wcut_text *text, const wcut_robot_motion *m, const wcut_robot_names *names, int robot) {
    const char *p = names->program, *side = suffix_of(robot);
    const unsigned id = run_id(m, names); /* points of different runs have different names, and never meet */

    /* the module, and what the cell has to define */
    wcut_text_print(text, "MODULE %s%s\n", p, side);
    put_program_head(text, "  ! ", m, names, robot);
    if (m->single)
        wcut_text_print(text,
                        "  ! To be defined: tooldata %s_tool, wobjdata %s_block (the foam block).\n  PROC %s_main()\n"
                        "    ConfL \\Off;\n",
                        p, p, p);
    else
        wcut_text_print(
            text,
            "  ! To be defined in task T_ROB%d: tooldata %s_tool, wobjdata %s_block (the foam block).\n"
            "  ! Needs MultiMove; moves of one ID end together in both tasks.\n"
            "  PERS tasks %s_tasks{2} := [[\"T_ROB1\"],[\"T_ROB2\"]];\n"
            "  VAR syncident %s_on_%03x;\n  VAR syncident %s_off_%03x;\n  PROC %s%s_main()\n    ConfL \\Off;\n",
            robot + 1, p, p, p, p, id, p, id, p, side);

    /* to the first target, before both robots are coupled */
    half h = half_of(m, robot, 0);
    put_rapid_move(text, &h, 0, names->approach_speed, false, false);
    wcut_text_print(text, ", %s_tool\\WObj:=%s_block;\n", p, p);

    /* the wire is switched on and heated by robot A */
    if (switches(robot) && names->wire_on) wcut_text_print(text, "    %s;\n", names->wire_on);
    if (switches(robot) && names->preheat > 0) {
        put_rounded(text, "    WaitTime ", names->preheat, 3);
        wcut_text_print(text, ";\n");
    }

    /* synchronous moves to all targets */
    put_rapid_heat(text, names, target_heat(m, robot, 0));
    if (!m->single) wcut_text_print(text, "    SyncMoveOn %s_on_%03x, %s_tasks;\n", p, id, p);
    for (int i = 1; i < m->count; i++) {
        h = half_of(m, robot, i);
        /* a robot that stands waits for the other; its own speed must not be 0 */
        const bool calls = target_heat(m, robot, i) > 0;
        put_rapid_move(text, &h, m->single ? 0 : 10 * i, h.speed < 0.01 ? 0.01 : h.speed, m->single, calls);
        wcut_text_print(text, ", %s_tool\\WObj:=%s_block", p, p);
        if (calls) wcut_text_print(text, ", \"%s_heat_%d\"", p, i);
        wcut_text_print(text, ";\n");
    }

    /* both robots are released, the wire is switched off */
    if (!m->single) wcut_text_print(text, "    SyncMoveOff %s_off_%03x;\n", p, id);
    if (switches(robot) && names->wire_off) wcut_text_print(text, "    %s;\n", names->wire_off);
    wcut_text_print(text, "  ENDPROC\n");

    /* a procedure without a parameter for each change of the heater's power */
    for (int i = 1; i < m->count; i++) {
        if (!(target_heat(m, robot, i) > 0)) continue;
        wcut_text_print(text, "  PROC %s_heat_%d()\n", p, i);
        put_rapid_heat(text, names, target_heat(m, robot, i));
        wcut_text_print(text, "  ENDPROC\n");
    }
    wcut_text_print(text, "ENDMODULE\n");
}

/* ---- KRL: millimetres, A B C in degrees, a speed for every move ---- */

static void put_krl_move(wcut_text *text, const half *h) {
    double abc[3];
    euler_angles(h->frame, abc);
    put_rounded(text, "LIN {X ", h->at.x, 3);
    put_rounded(text, ", Y ", h->at.y, 3);
    put_rounded(text, ", Z ", h->at.z, 3);
    put_rounded(text, ", A ", abc[0], 4);
    put_rounded(text, ", B ", abc[1], 4);
    put_rounded(text, ", C ", abc[2], 4);
    wcut_text_print(text, "}%s\n", h->zone < 5e-4 ? "" : " C_DIS");
}

/* 9 decimals of m/s: a creeping arm keeps its time, and no speed is printed as 0, which never ends */
static void put_krl_speed(wcut_text *text, double speed) {
    put_rounded(text, "$VEL.CP = ", fmax(speed / 1000, 1e-9), 9);
    wcut_text_print(text, "\n");
}

/* both orientation speeds [deg/s] */
static void put_krl_turning(wcut_text *text, double speed) {
    put_rounded(text, "$VEL.ORI1 = ", fmax(speed, 1e-6), 6);
    put_rounded(text, "\n$VEL.ORI2 = ", fmax(speed, 1e-6), 6);
    wcut_text_print(text, "\n");
}

void wcut_krl_put(wcut_text *text, const wcut_robot_motion *m, const wcut_robot_names *names, int robot) {
    const int io = names->sync_io;

    /* the head: what is to be set at the cell */
    wcut_text_print(text, "DEF %s%s ( )\n", names->program, suffix_of(robot));
    put_program_head(text, "; ", m, names, robot);
    if (m->single)
        wcut_text_print(text, "; To be set: TOOL_DATA[1], BASE_DATA[1] (the foam block).\n");
    else
        wcut_text_print(
            text,
            "; To be set: TOOL_DATA[1], BASE_DATA[1] (the foam block); output %d of either controller wired to\n"
            "; input %d of the other. Both start together and then keep the speed of every move; their clocks\n"
            "; are not coupled.\n",
            io, io);
    wcut_text_print(text,
                    "BAS (#INITMOV,0)\n$TOOL = TOOL_DATA[1]\n$BASE = BASE_DATA[1]\n$ORI_TYPE = #VAR\n$ADVANCE = 3\n");
    put_rounded(text, "$ACC.CP = ", names->approach_acceleration / 1000, 6);
    wcut_text_print(text, "\n");
    put_krl_turning(text, ORI_SPEED);

    /* block coincidence where the arm stands, no start signal of an earlier run, then to the first target */
    wcut_text_print(text, "PTP $AXIS_ACT\n");
    if (!m->single) wcut_text_print(text, "$OUT[%d] = FALSE\n", io);
    half h = half_of(m, robot, 0);
    put_krl_speed(text, names->approach_speed);
    put_krl_move(text, &h);
    if (switches(robot) && names->wire_on) wcut_text_print(text, "%s ( )\n", names->wire_on);
    if (switches(robot) && names->preheat > 0) {
        put_rounded(text, "WAIT SEC ", names->preheat, 3);
        wcut_text_print(text, "\n");
    }

    /* tell the other robot, and wait for it */
    if (!m->single) {
        wcut_text_print(text, "$OUT[%d] = TRUE\nWAIT FOR $IN[%d]\n", io, io);
        put_run_id(text, &krl_signal, run_id(m, names), io);
    }

    /* speeds are those of the printed ways: rounded places must not cost time */
    half last = h;
    for (int i = 1; i < m->count; i++) {
        h = half_of(m, robot, i);
        if (target_heat(m, robot, i - 1) > 0) {
            wcut_text_print(text, "TRIGGER WHEN DISTANCE=0 DELAY=0 DO %s", names->wire_heat);
            put_rounded(text, " (", target_heat(m, robot, i - 1), 3);
            wcut_text_print(text, ") PRIO=-1\n");
        }
        const double way = flange_distance(printed(last.at), printed(h.at)), turn = frame_angle(last.frame, h.frame);
        if (way < STANDING && turn < STILL) {
            put_rounded(text, "WAIT SEC ", h.duration, 6);
            wcut_text_print(text, "\n");
            continue;
        }

        /* a move that only turns has no speed of its own */
        if (way < STANDING) {
            put_krl_turning(text, turn * WCUT_DEG_PER_RAD / h.duration);
            put_krl_move(text, &h);
            put_krl_turning(text, ORI_SPEED);
        } else {
            /* a move along the path: rounding and speed first */
            if (h.zone >= 5e-4) {
                put_rounded(text, "$APO.CDIS = ", h.zone, 3);
                wcut_text_print(text, "\n");
            }
            put_krl_speed(text, way / h.duration);
            put_krl_move(text, &h);
        }
        last = h;
    }

    /* tell the other robot, switch the wire off */
    if (!m->single) wcut_text_print(text, "$OUT[%d] = FALSE\n", io);
    if (switches(robot) && names->wire_off) wcut_text_print(text, "%s ( )\n", names->wire_off);
    wcut_text_print(text, "END\n");
}
