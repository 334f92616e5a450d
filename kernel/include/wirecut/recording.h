/* wirecut/recording.h - what the machine measured during a cut. */
#ifndef WCUT_RECORDING_H
#define WCUT_RECORDING_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/job.h>
#include <wirecut/status.h>
#include <wirecut/table.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Channel, column without its unit, unit, whether a recording of two arms has it. */
#define WCUT_CHANNEL_LIST(X)                     \
    X(TIME, "time", "s", 1)                      \
    X(STATION, "station", "", 1)                 \
    X(SPEED_A, "speed_a", "mm_s", 1)             \
    X(SPEED_B, "speed_b", "mm_s", 1)             \
    X(TENSION_A, "tension_a", "N", 1)            \
    X(TENSION_B, "tension_b", "N", 1)            \
    X(ALPHA_A, "alpha_a", "deg", 1)              \
    X(BETA_A, "beta_a", "deg", 1)                \
    X(ALPHA_B, "alpha_b", "deg", 1)              \
    X(BETA_B, "beta_b", "deg", 1)                \
    X(SPEED_COMMAND, "speed_command", "mm_s", 0) \
    X(HEAT, "heat", "W_per_m", 0)                \
    X(HEATER_VOLTAGE, "heater", "V", 0)          \
    X(HEATER_CURRENT, "heater", "A", 0)          \
    X(A_X, "a_x", "mm", 0)                       \
    X(A_Y, "a_y", "mm", 0)                       \
    X(A_Z, "a_z", "mm", 0)                       \
    X(B_X, "b_x", "mm", 0)                       \
    X(B_Y, "b_y", "mm", 0)                       \
    X(B_Z, "b_z", "mm", 0)                       \
    X(FORCE_X, "force_x", "N", 0)                \
    X(FORCE_Y, "force_y", "N", 0)                \
    X(FORCE_Z, "force_z", "N", 0)                \
    X(MOMENT_X, "moment_x", "Nm", 0)             \
    X(MOMENT_Y, "moment_y", "Nm", 0)             \
    X(MOMENT_Z, "moment_z", "Nm", 0)             \
    X(SPEED, "speed", "mm_s", 0)                 \
    X(TOOL_X, "x", "mm", 0)                      \
    X(TOOL_Y, "y", "mm", 0)                      \
    X(TOOL_Z, "z", "mm", 0)

#define WCUT_CHANNEL_ENTRY(name, stem, unit, required) WCUT_CHANNEL_##name,
/** The channels that the program knows. `time` is in every recording. One of two arms has the eight of the mounts and
   `station` or the mounts' positions a_x .. b_z; one of a tool with a force sensor has force_x .. force_z and the tool's
   positions x .. z or its `speed`. */
typedef enum wcut_channel { WCUT_CHANNEL_LIST(WCUT_CHANNEL_ENTRY) WCUT_CHANNEL_COUNT } wcut_channel;
#undef WCUT_CHANNEL_ENTRY

/** A recording: structure of arrays, one sample a row. */
typedef struct wcut_recording {
    int samples;                             /**< at least 1 */
    wcut_column channel[WCUT_CHANNEL_COUNT]; /**< [s, 1, mm/s, N, rad, W/m, V, A, mm]; name NULL: not in the file */
    wcut_table *further;                     /**< the file's other columns, as they are, and every row's line */
} wcut_recording;

/** Whether a recording is one of a tool with a force sensor; false: of two arms. */
WCUT_API bool wcut_recording_has_force(const wcut_recording *recording);

/**
 * Give a recording without `station` this channel from the mounts' positions: for each sample the place of the job's
 * path that is next to both mounts together (least squares), not more than one station behind the samples before it.
 * Samples without a position have no station. A recording with the channel, or of a tool, is left as it is.
 *
 * @param[in]     job       path mode
 * @param[in,out] recording as read
 * @param[out]    error     may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (no path, neither stations nor positions), WCUT_NO_MEMORY: the recording is as it
 *         was.
 */
WCUT_API wcut_status wcut_recording_place(const wcut_job *job, wcut_recording *recording, wcut_error *error);

/**
 * The column of a channel in a file, "speed_a_mm_s".
 *
 * @return a constant string; "" outside the enum.
 */
WCUT_API const char *wcut_channel_name(wcut_channel channel);

#ifdef __cplusplus
}
#endif

#endif
