/* A history as ParaView's .vtp, written as the stations come: one polyline a station, exact doubles, appended raw.
   Every array has its place from the first station on, for the most stations that may come; where fewer came the
   arrays are moved together at the end, so that the file is the one a shorter plan would have made. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>
#include <wirecut/write.h>

#include <wirecut/angle.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "io/file/text.h"

_Static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the file says LittleEndian");

/* where an array of the file gets its values */
typedef enum section { POINT_DATA, CELL_REAL, CELL_INTEGER, POINTS, LINES } section;

typedef struct array {
    section section;
    const char *name;
    int components;
} array;

enum { REALS = 12, INTEGERS = 4, FIELDS = 5, ENGAGED = 4, FIRST_REAL = FIELDS, FIRST_INTEGER = FIRST_REAL + REALS };
enum { COORDINATES = FIRST_INTEGER + INTEGERS, CONNECTIVITY, OFFSETS, ARRAYS };

static const array arrays[ARRAYS] = {
    {POINT_DATA, "force_N", 3},     {POINT_DATA, "force_N_per_mm", 1}, {POINT_DATA, "speed_mm_s", 1},
    {POINT_DATA, "tension_N", 1},   {POINT_DATA, "engaged", 1},        {CELL_REAL, "time_s", 1},
    {CELL_REAL, "duration_s", 1},   {CELL_REAL, "speed_a_mm_s", 1},    {CELL_REAL, "speed_b_mm_s", 1},
    {CELL_REAL, "tension_a_N", 1},  {CELL_REAL, "tension_b_N", 1},     {CELL_REAL, "alpha_a_deg", 1},
    {CELL_REAL, "beta_a_deg", 1},   {CELL_REAL, "alpha_b_deg", 1},     {CELL_REAL, "beta_b_deg", 1},
    {CELL_REAL, "engaged_mm", 1},   {CELL_REAL, "residual", 1},        {CELL_INTEGER, "phase", 1},
    {CELL_INTEGER, "condition", 1}, {CELL_INTEGER, "iterations", 1},   {CELL_INTEGER, "substeps", 1},
    {POINTS, "position_mm", 3},     {LINES, "connectivity", 1},        {LINES, "offsets", 1},
};

struct wcut_vtp_stream {
    wcut_file *file;
    int max, nodes;      /* stations that may come, nodes of each */
    int count;           /* stations that came */
    bool engaged;        /* the stations have that array: the first one says so */
    uint64_t at[ARRAYS]; /* offset in the file of each array's size, values behind it */
    double *real;        /* most x REALS */
    int32_t *integer;    /* most x INTEGERS */
    double *along;       /* nodes: a station's tensions, a value a node */
};

/* ---- the layout ---- */

static bool is_vtp_there(const wcut_vtp_stream *s, int k) { return k != ENGAGED || s->engaged; }

/* bytes that a station puts into an array */
static uint64_t bytes_of(const wcut_vtp_stream *s, int k) {
    if (arrays[k].section == CELL_INTEGER) return sizeof(int32_t);
    bool nodal = arrays[k].section == POINT_DATA || k == COORDINATES || k == CONNECTIVITY;
    return sizeof(double) * (uint64_t)arrays[k].components * (nodal ? (uint64_t)s->nodes : 1);
}

static void put_vtp_array(wcut_text *text, int k, uint64_t offset) {
    static const char *const type[] = {"Float64", "Float64", "Int32", "Float64", "Int64"};
    wcut_text_print(text, "        <DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"appended\" ",
                    type[arrays[k].section], arrays[k].name, arrays[k].components);
    wcut_text_print(text, "offset=\"%llu\"/>\n", (unsigned long long)offset);
}

static void put_vtp_section(wcut_text *text, const wcut_vtp_stream *s, int m, const char *element, int first, int end) {
    uint64_t offset = 0;
    wcut_text_print(text, "      <%s>\n", element);
    for (int k = 0; k < end; k++) {
        if (!is_vtp_there(s, k)) continue;
        if (k >= first) put_vtp_array(text, k, offset);
        offset += sizeof(uint64_t) + (uint64_t)m * bytes_of(s, k);
    }
    wcut_text_print(text, "      </%.*s>\n", (int)strcspn(element, " "), element);
}

/* everything before the first array, for m stations */
static void put_vtp_header(wcut_text *text, const wcut_vtp_stream *s, int m) {
    /* what the numbers stand for */
    wcut_text_print(
        text,
        "<?xml version=\"1.0\"?>\n<!-- wirecut %s. Units: mm, s, N, deg. One polyline a station, its points "
        "the wire's nodes from mount A to mount B.\n     tension_N: of the edge from the point towards "
        "mount B; the last point repeats it.\n     phase:",
        WCUT_VERSION);
    for (int k = WCUT_PHASE_APPROACH; k <= WCUT_PHASE_LEFT; k++)
        wcut_text_print(text, " %d %s%s", k, wcut_phase_name((wcut_phase)k), k < WCUT_PHASE_LEFT ? "," : ".");
    wcut_text_print(text, " condition (what set the speed):");
    for (int k = WCUT_CONDITION_TENSION; k <= WCUT_CONDITION_TIME; k++)
        wcut_text_print(text, " %d %s%s", k, wcut_condition_name((wcut_condition)k),
                        k < WCUT_CONDITION_TIME ? "," : ". -->\n");

    /* the arrays and where each begins */
    wcut_text_print(text,
                    "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
                    "  <PolyData>\n    <Piece NumberOfPoints=\"%lld\" NumberOfVerts=\"0\" NumberOfLines=\"%d\" "
                    "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
                    (long long)m * s->nodes, m);
    put_vtp_section(text, s, m, "PointData Scalars=\"force_N_per_mm\" Vectors=\"force_N\"", 0, FIELDS);
    put_vtp_section(text, s, m, "CellData Scalars=\"time_s\"", FIRST_REAL, COORDINATES);
    put_vtp_section(text, s, m, "Points", COORDINATES, CONNECTIVITY);
    put_vtp_section(text, s, m, "Lines", CONNECTIVITY, ARRAYS);

    wcut_text_print(text, "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n_");
}

/* where every array lies behind a header of that size */
static uint64_t lay_vtp_out(const wcut_vtp_stream *s, int m, uint64_t header, uint64_t at[ARRAYS]) {
    for (int k = 0; k < ARRAYS; k++) {
        at[k] = header;
        if (is_vtp_there(s, k)) header += sizeof(uint64_t) + (uint64_t)m * bytes_of(s, k);
    }
    return header;
}

static wcut_status no_memory(wcut_error *error) {
    return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
}

/* ---- the stream ---- */

wcut_status wcut_vtp_stream_create(const char *path, int stations, int nodes, wcut_vtp_stream **stream,
                                   wcut_error *error) {
    if (!path || !stream || stations < 1 || nodes < 2)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a .vtp: found %d stations of %d nodes, expected at least 1 of at least 2", stations, nodes);

    /* room for the numbers of all stations */
    wcut_vtp_stream *made = wcut_alloc(1, sizeof *made);
    if (!made) return no_memory(error);
    made->max = stations;
    made->nodes = nodes;
    made->real = wcut_alloc((size_t)stations * REALS, sizeof *made->real);
    made->integer = wcut_alloc((size_t)stations * INTEGERS, sizeof *made->integer);
    made->along = wcut_alloc((size_t)nodes, sizeof *made->along);

    /* the file is created last: nothing is on disk if there is no memory */
    wcut_status status =
        made->real && made->integer && made->along ? wcut_file_create(path, &made->file, error) : no_memory(error);
    if (status != WCUT_OK) {
        wcut_vtp_stream_destroy(made);
        return status;
    }

    *stream = made;

    return WCUT_OK;
}

/* the first station says which arrays there are, so where each begins */
static wcut_status begin_vtp(wcut_vtp_stream *s, const wcut_station *station, wcut_error *error) {
    wcut_text text;
    s->engaged = station->engaged != NULL;
    bool made = wcut_text_create(&text, NULL);
    if (made) put_vtp_header(&text, s, s->max);
    made = made && !text.failed;
    if (made) lay_vtp_out(s, s->max, text.count, s->at);
    wcut_text_destroy(&text);
    return made ? WCUT_OK : no_memory(error);
}

static void list_reals(const wcut_station *t, double real[REALS]) {
    const double value[REALS] = {t->time,
                                 t->duration,
                                 t->speed_a,
                                 t->speed_b,
                                 t->tension_a,
                                 t->tension_b,
                                 t->alpha_a * WCUT_DEG_PER_RAD,
                                 t->beta_a * WCUT_DEG_PER_RAD,
                                 t->alpha_b * WCUT_DEG_PER_RAD,
                                 t->beta_b * WCUT_DEG_PER_RAD,
                                 t->engaged_length,
                                 t->residual};
    memcpy(real, value, sizeof value);
}

static bool is_vtp_usable(const wcut_vtp_stream *s, const wcut_station *t, const double real[REALS]) {
    int n = s->nodes;
    if (t->nodes != n || !t->position || !t->force || !t->force_line || !t->speed || !t->tension) return false;
    if (s->count > 0 && s->engaged != (t->engaged != NULL)) return false;
    return all_finite(3 * n, &t->position->x) && all_finite(3 * n, &t->force->x) && all_finite(n, t->force_line) &&
           all_finite(n, t->speed) && all_finite(n - 1, t->tension) && (!t->engaged || all_finite(n, t->engaged)) &&
           all_finite(REALS, real);
}

static void write_row(wcut_vtp_stream *s, int k, const void *values) {
    uint64_t bytes = bytes_of(s, k);
    wcut_file_write_at(s->file, s->at[k] + sizeof(uint64_t) + (uint64_t)s->count * bytes, values, bytes);
}

wcut_status wcut_vtp_stream_append(wcut_vtp_stream *s, const wcut_station *station, wcut_error *error) {
    if (!s || !station) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a .vtp: stream or station is NULL");

    /* a station that fits behind the others */
    double real[REALS];
    list_reals(station, real);
    if (s->count == s->max)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a .vtp: found another station, expected at most %d", s->max);
    if (!is_vtp_usable(s, station, real))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a .vtp, station %d: expected %d nodes, every array and finite numbers", s->count, s->nodes);

    /* the first one begins the file */
    wcut_status status = s->count == 0 ? begin_vtp(s, station, error) : WCUT_OK;
    if (status != WCUT_OK) return status;
    memcpy(s->along, station->tension, (size_t)(s->nodes - 1) * sizeof(double));
    s->along[s->nodes - 1] = s->along[s->nodes - 2];

    /* arrays of nodes go to disk at once, numbers of stations at the end */
    const void *field[FIELDS] = {station->force, station->force_line, station->speed, s->along, station->engaged};
    for (int k = 0; k < FIELDS; k++)
        if (is_vtp_there(s, k)) write_row(s, k, field[k]);
    write_row(s, COORDINATES, station->position);
    const int32_t integer[INTEGERS] = {(int32_t)station->phase, (int32_t)station->condition, station->iterations,
                                       station->substeps};
    memcpy(s->real + (size_t)s->count * REALS, real, sizeof real);
    memcpy(s->integer + (size_t)s->count * INTEGERS, integer, sizeof integer);

    /* errors of writing are kept by the file and told here */
    s->count++;

    return wcut_file_check(s->file, error);
}

/* ---- the end ---- */

/* the values of an array that no station has written */
static void put_values(wcut_text *text, const wcut_vtp_stream *s, int k) {
    int64_t n = s->nodes, m = s->count;
    if (k == CONNECTIVITY)
        for (int64_t i = 0; i < m * n; i++) wcut_text_put(text, &i, sizeof i);
    else if (k == OFFSETS)
        for (int64_t end = n; end <= m * n; end += n) wcut_text_put(text, &end, sizeof end);
    else if (arrays[k].section == CELL_INTEGER)
        for (int64_t j = 0; j < m; j++)
            wcut_text_put(text, s->integer + j * INTEGERS + (k - FIRST_INTEGER), sizeof(int32_t));
    else
        for (int64_t j = 0; j < m; j++) wcut_text_put(text, s->real + j * REALS + (k - FIRST_REAL), sizeof(double));
}

/* move what the stations wrote to where it belongs for as many as came, and write the rest around it */
static void finish_stream(wcut_vtp_stream *s, wcut_text *header, wcut_text *body) {
    uint64_t at[ARRAYS], end = lay_vtp_out(s, s->count, header->count, at);
    for (int k = 0; k < ARRAYS; k++) {
        if (!is_vtp_there(s, k)) continue;
        uint64_t size = (uint64_t)s->count * bytes_of(s, k);
        if (arrays[k].section == POINT_DATA || k == COORDINATES)
            wcut_file_move(s->file, at[k] + sizeof size, s->at[k] + sizeof size, size);
        wcut_file_write_at(s->file, at[k], &size, sizeof size);
        if (arrays[k].section == POINT_DATA || k == COORDINATES) continue;
        wcut_file_seek(s->file, at[k] + sizeof size);
        put_values(body, s, k);
        wcut_text_flush(body);
    }
    static const char tail[] = "\n  </AppendedData>\n</VTKFile>\n";
    wcut_file_write_at(s->file, 0, header->data, header->count);
    wcut_file_write_at(s->file, end, tail, sizeof tail - 1);
    wcut_file_truncate(s->file, end + sizeof tail - 1);
}

wcut_status wcut_vtp_stream_commit(wcut_vtp_stream *s, wcut_error *error) {
    if (!s || s->count == 0) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a .vtp: found no station to write");
    wcut_text header, body = {0};
    bool made = wcut_text_create(&header, NULL);
    if (made) put_vtp_header(&header, s, s->count);
    made = made && !header.failed && wcut_text_create(&body, s->file);
    if (made) finish_stream(s, &header, &body);
    wcut_text_destroy(&header);
    wcut_text_destroy(&body);
    return made ? wcut_file_commit(s->file, error) : no_memory(error);
}

void wcut_vtp_stream_destroy(wcut_vtp_stream *s) {
    if (!s) return;
    wcut_file_destroy(s->file);
    free(s->real);
    free(s->integer);
    free(s->along);
    free(s);
}
