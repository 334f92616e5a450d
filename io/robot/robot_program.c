/* Robot programs: URScript (Universal Robots), RAPID with MultiMove (ABB), KRL (KUKA); an honest subset of each. */
#include "io/robot/robot_program.h"
#include <wirecut/angle.h>
#include <wirecut/robot_file.h>

#include <math.h>
#include <stdio.h>

#define STANDING 5e-4     /* [mm] a move shorter than it is printed */
#define START_SPEED 50    /* [mm/s] to the first target */
#define UR_ACCELERATION 1 /* [m/s^2] read by the controller only where t is not met */

/* one robot's half of a target */
typedef struct half {
    wcut_vec3 at;
    double speed, zone, duration, way;
    const double *frame;
} half;

static half half_of(const wcut_robot_motion *m, int robot, int i) {
    const wcut_robot_target *t = &m->target[i];
    const double speed = robot ? t->speed_b : t->speed_a;
    return (half){.at = robot ? t->b : t->a,
                  .speed = speed,
                  .zone = robot ? t->zone_b : t->zone_a,
                  .duration = t->duration,
                  .way = speed * t->duration,
                  .frame = robot ? t->frame_b : t->frame_a};
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

static void put(wcut_text *text, const char *before, double value, int decimals) {
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

static void put_head(wcut_text *text, const char *mark, const wcut_robot_motion *m, const wcut_robot_names *names,
                     int robot) {
    wcut_text_print(text, "%swirecut: mount %c of two that cut one wire; %d targets of %d stations, ", mark,
                    robot ? 'B' : 'A', m->count, m->stations);
    put(text, "", m->duration, 3);
    wcut_text_print(text, " s\n");
    if (names->title && *names->title) put_comment(text, mark, names->title);
    wcut_text_print(text,
                    "%sPositions are in the frame of the foam block: x across from A to B, y the feed, z up.\n"
                    "%sTool: its x axis looks along the wire into the cut, its z axis up.\n",
                    mark, mark);
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
    put(text, "pose_trans(block, p[", h->at.x / 1000, 6);
    put(text, ", ", h->at.y / 1000, 6);
    put(text, ", ", h->at.z / 1000, 6);
    for (int k = 0; k < 3; k++) put(text, ", ", v[k], 6);
    wcut_text_print(text, "])");
}

void wcut_urscript_put(wcut_text *text, const wcut_robot_motion *m, const wcut_robot_names *names, int robot) {
    const int io = names->sync_io;

    /* the head: what is to be set at the cell */
    wcut_text_print(text, "def %s_%c():\n", names->program, robot ? 'b' : 'a');
    put_head(text, "  # ", m, names, robot);
    wcut_text_print(
        text,
        "  # To be set: block, the pose of the foam block in this robot's base; the TCP; digital output %d\n"
        "  # of either controller wired to input %d of the other. Both start together and then keep the\n"
        "  # time of every move; their clocks are not coupled.\n"
        "  block = p[0, 0, 0, 0, 0, 0]\n",
        io, io);

    /* go to the start slowly, switch the wire on, wait for the other robot */
    half h = half_of(m, robot, 0);
    wcut_text_print(text, "  movel(");
    put_ur_pose(text, &h);
    put(text, ", a=", UR_ACCELERATION, 3);
    put(text, ", v=", START_SPEED / 1000.0, 6);
    wcut_text_print(text, ")\n");
    if (robot == 0 && names->wire_on) wcut_text_print(text, "  %s()\n", names->wire_on);
    wcut_text_print(text, "  set_digital_out(%d, True)\n  while (get_digital_in(%d) == False):\n    sync()\n  end\n",
                    io, io);

    /* a move for each target; a target without a way is a pause */
    for (int i = 1; i < m->count; i++) {
        h = half_of(m, robot, i);
        if (h.way < STANDING) {
            put(text, "  sleep(", h.duration, 6);
            wcut_text_print(text, ")\n");
            continue;
        }
        wcut_text_print(text, "  movel(");
        put_ur_pose(text, &h);
        put(text, ", a=", UR_ACCELERATION, 3);
        put(text, ", v=", h.speed / 1000, 6);
        put(text, ", t=", h.duration, 6);
        put(text, ", r=", h.zone / 1000, 6);
        wcut_text_print(text, ")\n");
    }

    /* tell the other robot, switch the wire off */
    wcut_text_print(text, "  set_digital_out(%d, False)\n", io);
    if (robot == 0 && names->wire_off) wcut_text_print(text, "  %s()\n", names->wire_off);
    wcut_text_print(text, "end\n");
}

/* ---- RAPID: millimetres, quaternions, MultiMove: moves of one ID end together ---- */

static void put_rapid_move(wcut_text *text, const half *h, int id, double speed) {
    put(text, "    MoveL [[", h->at.x, 3);
    put(text, ",", h->at.y, 3);
    put(text, ",", h->at.z, 3);
    for (int k = 0; k < 4; k++) put(text, k ? "," : "],[", h->frame[k], 9);
    wcut_text_print(text, "],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]");
    if (id > 0) wcut_text_print(text, "\\ID:=%d", id);
    put(text, ", [", speed, 3);
    wcut_text_print(text, ",500,5000,1000], ");
    if (h->zone < 5e-4) {
        wcut_text_print(text, "fine");
    } else {
        put(text, "[FALSE,", h->zone, 3);
        put(text, ",", 1.5 * h->zone, 3);
        put(text, ",", 1.5 * h->zone, 3);
        put(text, ",0.150,", 1.5 * h->zone, 3);
        wcut_text_print(text, ",0.150]");
    }
}

void wcut_rapid_put(wcut_text *text, const wcut_robot_motion *m, const wcut_robot_names *names, int robot) {
    const char *p = names->program, side = robot ? 'b' : 'a';
    wcut_text_print(text, "MODULE %s_%c\n", p, side);
    put_head(text, "  ! ", m, names, robot);
    wcut_text_print(text,
                    "  ! To be defined in task T_ROB%d: tooldata %s_tool, wobjdata %s_block (the foam block).\n"
                    "  ! Needs MultiMove; moves of one ID end together in both tasks.\n"
                    "  PERS tasks %s_tasks{2} := [[\"T_ROB1\"],[\"T_ROB2\"]];\n"
                    "  VAR syncident %s_on;\n  VAR syncident %s_off;\n  PROC %s_%c_main()\n    ConfL \\Off;\n",
                    robot + 1, p, p, p, p, p, p, side);
    half h = half_of(m, robot, 0);
    put_rapid_move(text, &h, 0, START_SPEED);
    wcut_text_print(text, ", %s_tool\\WObj:=%s_block;\n", p, p);
    if (robot == 0 && names->wire_on) wcut_text_print(text, "    %s;\n", names->wire_on);
    wcut_text_print(text, "    SyncMoveOn %s_on, %s_tasks;\n", p, p);
    for (int i = 1; i < m->count; i++) {
        h = half_of(m, robot, i);
        /* a robot that stands waits for the other; its own speed must not be 0 */
        put_rapid_move(text, &h, 10 * i, h.speed < 0.01 ? 0.01 : h.speed);
        wcut_text_print(text, ", %s_tool\\WObj:=%s_block;\n", p, p);
    }
    wcut_text_print(text, "    SyncMoveOff %s_off;\n", p);
    if (robot == 0 && names->wire_off) wcut_text_print(text, "    %s;\n", names->wire_off);
    wcut_text_print(text, "  ENDPROC\nENDMODULE\n");
}

/* ---- KRL: millimetres, A B C in degrees, a speed for every move ---- */

static void put_krl_move(wcut_text *text, const half *h) {
    double abc[3];
    euler_angles(h->frame, abc);
    put(text, "LIN {X ", h->at.x, 3);
    put(text, ", Y ", h->at.y, 3);
    put(text, ", Z ", h->at.z, 3);
    put(text, ", A ", abc[0], 4);
    put(text, ", B ", abc[1], 4);
    put(text, ", C ", abc[2], 4);
    wcut_text_print(text, "}%s\n", h->zone < 5e-4 ? "" : " C_DIS");
}

static void put_krl_speed(wcut_text *text, double speed) {
    put(text, "$VEL.CP = ", speed / 1000, 6);
    wcut_text_print(text, "\n");
}

void wcut_krl_put(wcut_text *text, const wcut_robot_motion *m, const wcut_robot_names *names, int robot) {
    const int io = names->sync_io;

    /* the head: what is to be set at the cell */
    wcut_text_print(text, "DEF %s_%c ( )\n", names->program, robot ? 'b' : 'a');
    put_head(text, "; ", m, names, robot);
    wcut_text_print(
        text,
        "; To be set: TOOL_DATA[1], BASE_DATA[1] (the foam block); output %d of either controller wired to\n"
        "; input %d of the other. Both start together and then keep the speed of every move; their clocks\n"
        "; are not coupled.\n"
        "$TOOL = TOOL_DATA[1]\n$BASE = BASE_DATA[1]\n$ORI_TYPE = #VAR\n$ADVANCE = 3\n",
        io, io);

    /* go to the start slowly, switch the wire on, wait for the other robot */
    half h = half_of(m, robot, 0);
    put_krl_speed(text, START_SPEED);
    put_krl_move(text, &h);
    if (robot == 0 && names->wire_on) wcut_text_print(text, "%s ( )\n", names->wire_on);
    wcut_text_print(text, "$OUT[%d] = TRUE\nWAIT FOR $IN[%d]\n", io, io);

    /* a move for each target; a target without a way is a pause */
    for (int i = 1; i < m->count; i++) {
        h = half_of(m, robot, i);
        if (h.way < STANDING) {
            put(text, "WAIT SEC ", h.duration, 6);
            wcut_text_print(text, "\n");
            continue;
        }
        if (h.zone >= 5e-4) {
            put(text, "$APO.CDIS = ", h.zone, 3);
            wcut_text_print(text, "\n");
        }
        put_krl_speed(text, h.speed);
        put_krl_move(text, &h);
    }

    /* tell the other robot, switch the wire off */
    wcut_text_print(text, "$OUT[%d] = FALSE\n", io);
    if (robot == 0 && names->wire_off) wcut_text_print(text, "%s ( )\n", names->wire_off);
    wcut_text_print(text, "END\n");
}
