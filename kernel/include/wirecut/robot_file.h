/* wirecut/robot_file.h - robot programs out (libwirecut-io). */
#ifndef WCUT_ROBOT_FILE_H
#define WCUT_ROBOT_FILE_H

#include <wirecut/export.h>
#include <wirecut/robot.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Programs' formats. */
typedef enum wcut_robot_format {
    WCUT_ROBOT_FORMAT_URSCRIPT, /**< Universal Robots: two programs */
    WCUT_ROBOT_FORMAT_RAPID,    /**< ABB MultiMove: two modules */
    WCUT_ROBOT_FORMAT_KRL,      /**< KUKA: two programs */
    WCUT_ROBOT_FORMAT_CSV,      /**< both robots in one table */
    WCUT_ROBOT_FORMAT_JSON      /**< both robots in one object, "format": "wirecut-robot/1" */
} wcut_robot_format;

/** Names in the programs, and what their heads state. Both programs carry a run id of 12 bits, made of all targets and
 * the title: urscript and krl exchange it bit by bit over the start signal before they move together, rapid has it in
 * the names of its synchronisation points, so that programs of different runs do not start with each other. Names are
 * letters, digits and _, beginning with a letter, at most 22 long: KRL has no more. */
typedef struct wcut_robot_names {
    const char *title;     /**< the job's; any text, for comments */
    const char *program;   /**< default "wirecut": module and program names get _a and _b */
    const char *wire_on;   /**< procedure that robot A calls at its first target; NULL: none; default "wire_on" */
    const char *wire_off;  /**< ... after its last; default "wire_off" */
    const char *wire_heat; /**< procedure that robot A calls with a power [W/m] where the heater's programme changes it;
                                NULL: none, not allowed where it does; default "wire_heat" */
    int sync_io; /**< digital output of one robot that is this input of the other: urscript 0 .. 7, krl 1 .. 255;
                               default 1 */
    double approach_speed;        /**< [mm/s] of the move to the first target, positive; default 50 */
    double approach_acceleration; /**< [mm/s^2] of every move that has no time of its own, positive; default 1000 */
    double preheat;     /**< [s] that robot A waits behind wire_on before both start, not negative; default 0 */
    double heat;        /**< [W/m] for the head; 0, the default: not said */
    double tension;     /**< [N] for the head; 0, the default: not said */
    double wire_length; /**< [mm] from mount to mount, for the head; 0, the default: not said */
} wcut_robot_names;
/** The defaults stated at the fields. */
WCUT_API wcut_robot_names wcut_robot_names_default(void);

/** The name of a file of a format: robot 0 or 1; a format with one file has a NULL for robot 1. WCUT_ROBOT_SINGLE: the one
 * file of one robot. */
WCUT_API const char *wcut_robot_file_name(wcut_robot_format format, int robot);

/**
 * Write one robot's program, or the one file of csv and json. Positions are in the block frame, to 1e-3 mm (json:
 * exact); the program's head lists what the cell has to define.
 *
 * @param[in]  motion
 * @param[in]  names   NULL for the defaults
 * @param[in]  format
 * @param[in]  robot   0 or 1; of a motion of one robot WCUT_ROBOT_SINGLE
 * @param[in]  path    the target, replaced whole or not at all
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a name that is not valid; a digital output that the controller lacks; a robot
 *         that the format or the motion has no file for), WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_robot_write(const wcut_robot_motion *motion, const wcut_robot_names *names,
                                      wcut_robot_format format, int robot, const char *path, wcut_error *error);

/** The figures of an export. */
typedef struct wcut_robot_summary {
    const wcut_job *job;
    const wcut_robot_motion *motion;
    const wcut_robot_check *check; /**< WCUT_ROBOT_CHECKS */
    const wcut_path_near *near;    /**< 2: of the mounts' paths and the block (wcut_path_clearance) */
    wcut_robot_format format;
} wcut_robot_summary;

/**
 * The text of an export's figures, "format": "wirecut-path/1".
 *
 * @param[in]  summary every pointer set
 * @param[out] text    the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_robot_summary_print(const wcut_robot_summary *summary, char **text);

/** The word of a format: "urscript", "rapid", "krl", "csv", "json". */
WCUT_API const char *wcut_robot_format_name(wcut_robot_format format);

#ifdef __cplusplus
}
#endif

#endif
