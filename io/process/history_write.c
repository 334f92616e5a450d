/* A history in memory to path.csv and history.vtp. */
#include <math.h>
#include <stddef.h>
#include <string.h>
#include <wirecut/write.h>

#include <wirecut/angle.h>
#include "base/fail.h"
#include "base/vec3.h"
#include "io/file/text.h"
#include "io/process/history_check.h"

bool wcut_history_is_usable(const wcut_history *history) {
    if (!history || history->stations < 1 || history->nodes < 2 || !history->row) return false;
    for (int j = 0; j < history->stations; j++) {
        const wcut_history_row *r = &history->row[j];
        const double value[] = {r->time,    r->duration, r->speed_a, r->speed_b, r->tension_a,      r->tension_b,
                                r->alpha_a, r->beta_a,   r->alpha_b, r->beta_b,  r->engaged_length, r->residual};
        for (size_t k = 0; k < sizeof value / sizeof *value; k++)
            if (!isfinite(value[k])) return false;
    }
    return true;
}

/* ---- path.csv ---- */

static void put_history_row(wcut_text *text, const wcut_history *history, int j, wcut_vec3 a, wcut_vec3 b) {
    /* speeds and angles in the units of files */
    const wcut_history_row *r = &history->row[j];
    /* a speed is that of the way to the station: the first one has none and takes the second's */
    const wcut_history_row *moved = j == 0 && history->stations > 1 ? r + 1 : r;
    const double value[] = {a.x,
                            a.y,
                            a.z,
                            b.x,
                            b.y,
                            b.z,
                            moved->speed_a,
                            moved->speed_b,
                            r->tension_a,
                            r->tension_b,
                            r->alpha_a * WCUT_DEG_PER_RAD,
                            r->beta_a * WCUT_DEG_PER_RAD,
                            r->alpha_b * WCUT_DEG_PER_RAD,
                            r->beta_b * WCUT_DEG_PER_RAD};

    /* which station, when, and in which phase */
    wcut_text_print(text, "%d,", j);
    wcut_text_number(text, r->time);
    wcut_text_print(text, ",%s", wcut_phase_name(r->phase));
    for (size_t k = 0; k < sizeof value / sizeof *value; k++) {
        wcut_text_put(text, ",", 1);
        wcut_text_number(text, value[k]);
    }
    wcut_text_put(text, "\n", 1);
}

/* a history and where its mounts were */
typedef struct travelled {
    const wcut_history *history;
    const wcut_vec3 *a, *b; /* history->stations */
} travelled;

static bool put_path(wcut_text *text, const void *context) {
    const travelled *whole = context;
    static const char header[] =
        "station,time_s,phase,a_x_mm,a_y_mm,a_z_mm,b_x_mm,b_y_mm,b_z_mm,"
        "speed_a_mm_s,speed_b_mm_s,tension_a_N,tension_b_N,"
        "alpha_a_deg,beta_a_deg,alpha_b_deg,beta_b_deg\n";
    wcut_text_put(text, header, sizeof header - 1);
    for (int j = 0; j < whole->history->stations; j++)
        put_history_row(text, whole->history, j, whole->a[j], whole->b[j]);
    return true;
}

wcut_status wcut_history_write_csv(const wcut_history *history, const wcut_vec3 *mount_a, const wcut_vec3 *mount_b,
                                   const char *path, wcut_error *error) {
    if (!path || !mount_a || !mount_b || !wcut_history_is_usable(history) ||
        !vec3_all_finite(history->stations, mount_a) || !vec3_all_finite(history->stations, mount_b))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a path table: expected a file name, at least one station and finite numbers");
    const travelled whole = {history, mount_a, mount_b};
    return wcut_text_write_file(path, put_path, &whole, error);
}

/* ---- history.vtp ---- */

static wcut_station view_station(const wcut_history *h, int j) {
    const wcut_history_row *r = &h->row[j];

    /* nodes of earlier stations come first */
    size_t at = (size_t)j * (size_t)h->nodes;

    /* a view into the history's arrays: nothing is copied */
    return (wcut_station){.index = j,
                          .time = r->time,
                          .duration = r->duration,
                          .nodes = h->nodes,
                          .position = h->position + at,
                          .force = h->force + at,
                          .force_line = h->force_line + at,
                          .speed = h->speed + at,
                          .tension = h->tension + (size_t)j * (size_t)(h->nodes - 1),
                          .engaged = NULL, /* a history does not keep it */
                          .speed_a = r->speed_a,
                          .speed_b = r->speed_b,
                          .tension_a = r->tension_a,
                          .tension_b = r->tension_b,
                          .alpha_a = r->alpha_a,
                          .beta_a = r->beta_a,
                          .alpha_b = r->alpha_b,
                          .beta_b = r->beta_b,
                          .engaged_length = r->engaged_length,
                          .phase = r->phase,
                          .condition = r->condition,
                          .iterations = r->iterations,
                          .substeps = r->substeps,
                          .residual = r->residual};
}

wcut_status wcut_history_write_vtp(const wcut_history *history, const char *path, wcut_error *error) {
    if (!path || !wcut_history_is_usable(history) || !history->position || !history->force || !history->force_line ||
        !history->speed || !history->tension)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a .vtp: expected a file name, at least one station and finite numbers");
    wcut_vtp_stream *stream = NULL;
    wcut_status status = wcut_vtp_stream_create(path, history->stations, history->nodes, &stream, error);
    for (int j = 0; status == WCUT_OK && j < history->stations; j++) {
        wcut_station station = view_station(history, j);
        status = wcut_vtp_stream_append(stream, &station, error);
    }
    if (status == WCUT_OK) status = wcut_vtp_stream_commit(stream, error);
    wcut_vtp_stream_destroy(stream);
    return status;
}
