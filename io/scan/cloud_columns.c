/* Names of columns in the files of metrologists and CAD programs, and which of them are the coordinates that were measured. */
#include "io/scan/cloud_columns.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "io/file/unit.h"

/* ---- cells ---- */

static bool is_cloud_columns_blank(char c) { return c == ' ' || c == '\t'; }

/* behind the cell at p */
static const char *cell_end(const char *p, const char *end, char separator) {
    /* quotes around the cell, if there are any */
    if (*p == '"') {
        for (p++; p < end && *p != '"'; p++) {
        }
        if (p < end) p++;
    }

    /* other separators than a blank end the cell wherever they stand */
    if (separator != ' ') {
        while (p < end && *p != separator) p++;
        return p;
    }
    while (p < end && !is_cloud_columns_blank(*p)) p++;

    /* a unit in brackets belongs to the name before it */
    const char *next = p;
    while (next < end && is_cloud_columns_blank(*next)) next++;
    if (next < end && (*next == '[' || *next == '(')) {
        while (next < end && *next != ']' && *next != ')') next++;
        return next < end ? next + 1 : p;
    }

    return p;
}

static wcut_cell trim(const char *from, const char *to) {
    while (from < to && (is_cloud_columns_blank(*from) || *from == '"')) from++;
    while (to > from && (is_cloud_columns_blank(to[-1]) || to[-1] == '"' || to[-1] == '\r')) to--;
    return (wcut_cell){from, (int)(to - from)};
}

int wcut_cells_split(const char *line, const char *end, char separator, wcut_cell cell[WCUT_CELLS_MAX + 1]) {
    int count = 0;
    const char *p = line;
    while (end > p && (end[-1] == '\n' || end[-1] == '\r' || end[-1] == '\0')) end--;
    while (p < end && is_cloud_columns_blank(*p)) p++;
    while (separator == ' ' && end > p && is_cloud_columns_blank(end[-1])) end--;
    while (count <= WCUT_CELLS_MAX && p < end) {
        const char *stop = cell_end(p, end, separator);
        cell[count++] = trim(p, stop);
        p = stop;
        if (separator == ' ')
            while (p < end && is_cloud_columns_blank(*p)) p++;
        else if (p < end && ++p == end && count <= WCUT_CELLS_MAX)
            cell[count++] = trim(p, p); /* an empty cell behind the last separator */
    }
    return count;
}

/* ---- the words of a name ---- */

typedef enum role { PLAIN, MEASURED, NOMINAL, DERIVED, STRANGE, ROLES } role;

typedef struct name {
    int field; /* x y z nx ny nz as 0 .. 5, -1: no coordinate */
    role role;
    double unit;   /* [mm]; 0: none */
    unsigned word; /* of STRANGE: its words, hashed, so that columns of one kind are known as such */
} name;

static bool is_one_of(const char *word, size_t n, const char *const *list) {
    for (; *list; list++)
        if (strlen(*list) == n && strncasecmp(*list, word, n) == 0) return true;
    return false;
}

static const char *const said_of_measured[] = {"meas",     "measured", "measure", "measurement", "act",
                                               "actual",   "scan",     "scanned", "ist",         "obs",
                                               "observed", "real",     "mess",    "probed",      NULL};
static const char *const said_of_nominal[] = {"nom",      "nominal", "ref",   "reference",   "cad",
                                              "design",   "target",  "theo",  "theoretical", "soll",
                                              "expected", "model",   "ideal", "planned",     NULL};
static const char *const said_of_derived[] = {
    "dev", "deviation", "diff", "difference", "delta",       "d",        "error", "err",    "std", "stdev",    "sigma",
    "sd",  "rms",       "tol",  "tolerance",  "uncertainty", "residual", "res",   "offset", "var", "variance", NULL};
static const char *const said_of_any[] = {
    "coord",  "coords", "coordinate", "coordinates", "koordinate", "pos",       "position", "point",
    "points", "pt",     "punkt",      "location",    "value",      "cartesian", "vertex",   NULL};
static const char *const said_of_normal[] = {"normal", "normals", "nrm", "n", NULL};

static role role_of(const char *word, size_t n) {
    if (is_one_of(word, n, said_of_measured)) return MEASURED;
    if (is_one_of(word, n, said_of_nominal)) return NOMINAL;
    if (is_one_of(word, n, said_of_derived)) return DERIVED;
    return STRANGE;
}

/* 0 .. 2 for a word that is an axis, -1 otherwise */
static int axis_of_word(const char *word, size_t n) {
    const int c = tolower((unsigned char)word[0]);
    return n == 1 && c >= 'x' && c <= 'z' ? c - 'x' : -1;
}

/* an axis glued to a word: "nx", "xnom", "measy" */
static bool take_glued(const char *word, size_t n, int *axis, bool *is_normal, role *r) {
    if (n < 2) return false;
    const int first = axis_of_word(word, 1), last = axis_of_word(word + n - 1, 1);
    if (last >= 0 && is_one_of(word, n - 1, said_of_normal)) {
        *axis = last, *is_normal = true;
        return true;
    }
    const role before = last >= 0 ? role_of(word, n - 1) : STRANGE;
    const role behind = first >= 0 ? role_of(word + 1, n - 1) : STRANGE;
    if (before == STRANGE && behind == STRANGE) return false;
    *axis = before != STRANGE ? last : first;
    *r = before != STRANGE ? before : behind;
    return true;
}

/* the words between what is neither letter nor digit */
static bool is_word(char c) { return isalnum((unsigned char)c) || (unsigned char)c >= 0x80; }

static name read_cloud_columns_name(const wcut_cell *cell) {
    name found = {-1, PLAIN, 0, 2166136261u};

    /* the axis is kept beside the role: the name "nx" says both */
    int axis = -1;
    bool is_normal = false, is_point = false;

    /* word by word: letters and digits */
    for (int k = 0; k < cell->length;) {
        if (!is_word(cell->at[k])) {
            k++;
            continue;
        }
        int end = k;
        while (end < cell->length && is_word(cell->at[end])) end++;
        const char *word = cell->at + k;
        const size_t n = (size_t)(end - k);
        const double unit = wcut_unit_find(word, n);
        role r = role_of(word, n);
        k = end;

        /* "Points:0" as ParaView writes it */
        if (is_point && n == 1 && *word >= '0' && *word <= '2' && axis < 0)
            axis = *word - '0';
        else if (axis_of_word(word, n) >= 0 && axis < 0)
            axis = axis_of_word(word, n);
        else if (is_one_of(word, n, said_of_normal))
            is_normal = true;
        else if (unit > 0 && axis >= 0)
            found.unit = unit;
        else if (is_one_of(word, n, said_of_any))
            is_point = true;
        else if (r != STRANGE || (axis < 0 && take_glued(word, n, &axis, &is_normal, &r)))
            found.role = r == STRANGE ? found.role : r;
        else {
            /* a strange word is hashed, so that columns of one kind are recognised */
            found.role = STRANGE;
            for (size_t c = 0; c < n; c++) found.word = (found.word ^ (unsigned char)tolower(word[c])) * 16777619u;
        }
    }
    if (axis >= 0) found.field = axis + (is_normal ? 3 : 0);

    return found;
}

/* ---- which of them ---- */

/* coordinates of one role; normals are of any */
typedef struct group {
    int column[WCUT_FIELDS], count;
    double unit[3];
    bool twice;
} group;

static bool is_group_whole(const group *g) { return g->count == 3; }

static void take_column(group *g, int field, int column, double unit) {
    if (field >= 3) {
        if (g->column[field] < 0) g->column[field] = column;
        return;
    }
    g->twice = g->twice || g->column[field] >= 0;
    if (g->column[field] >= 0) return;
    g->column[field] = column;
    g->unit[field] = unit;
    g->count++;
}

/* the one unit that some or all of three columns state, 0: none does; false: they state several */
static bool agree(const double unit[3], double *one) {
    *one = 0;
    for (int k = 0; k < 3; k++) {
        if (unit[k] > 0 && *one > 0 && unit[k] != *one) return false;
        if (unit[k] > 0) *one = unit[k];
    }
    return true;
}

static const char *take_cloud_columns(const group *g, const group *normals, wcut_columns *columns) {
    if (g->twice) return "each coordinate once: say which columns by the option columns";
    if (!agree(g->unit, &columns->unit)) return "x, y and z in one unit";
    for (int k = 0; k < 3; k++) columns->column[k] = g->column[k];
    const int *n = normals->column + 3;
    const bool has_normals = n[0] >= 0 && n[1] >= 0 && n[2] >= 0;
    for (int k = 0; k < 3; k++) columns->column[3 + k] = has_normals ? n[k] : -1;
    return NULL;
}

const char *wcut_columns_find(int count, const wcut_cell *cell, wcut_columns *columns) {
    group by_role[ROLES];

    /* groups of columns by what their names say of them */
    for (int r = 0; r < ROLES; r++) by_role[r] = (group){.column = {-1, -1, -1, -1, -1, -1}};
    unsigned word = 0;
    bool mixed = false;
    for (int k = 0; k < count; k++) {
        const name n = read_cloud_columns_name(&cell[k]);
        if (n.field < 0) continue;

        /* columns with different strange words belong to several kinds */
        if (n.role == STRANGE && n.field < 3) {
            mixed = mixed || (word && word != n.word);
            word = n.word;
        }
        take_column(&by_role[n.field >= 3 && n.role != DERIVED ? PLAIN : n.role], n.field, k, n.unit);
    }

    /* exactly one whole group may be the measured one */
    const group *measured = &by_role[MEASURED], *plain = &by_role[PLAIN], *nominal = &by_role[NOMINAL];
    const bool strange = mixed || is_group_whole(&by_role[STRANGE]) || by_role[STRANGE].twice;
    if (is_group_whole(measured) && plain->count == 0 && !strange) return take_cloud_columns(measured, plain, columns);
    if (is_group_whole(plain) && measured->count == 0 && !strange) return take_cloud_columns(plain, plain, columns);
    if (is_group_whole(nominal) && measured->count == 0 && plain->count == 0 && !strange)
        return "columns of what was measured, not nominal ones alone: say which by the option columns";

    /* say which choice the option has to make */
    if (is_group_whole(measured) || is_group_whole(plain) || strange)
        return "one set of columns x, y, z: say which by the option columns, as x_meas,y_meas,z_meas or 4,5,6";

    return "columns named x, y, z: say which they are by the option columns, as east,north,height or 1,2,3";
}

bool wcut_columns_named(int count, const wcut_cell *cell) {
    int axes = 0;
    for (int k = 0; k < count; k++) axes += read_cloud_columns_name(&cell[k]).field >= 0;
    return axes >= 3;
}

/* ---- as an option says ---- */

/* the column with this name or number; -1: none, or several */
static int find_column(const char *word, size_t n, int columns, int names, const wcut_cell *cell) {
    int found = -1;
    for (int k = 0; k < names; k++) {
        if ((size_t)cell[k].length != n || strncasecmp(cell[k].at, word, n) != 0) continue;
        if (found >= 0) return -1;
        found = k;
    }
    if (found >= 0) return found;
    long number = 0;
    for (size_t k = 0; k < n; k++) {
        if (word[k] < '0' || word[k] > '9' || number > WCUT_CELLS_MAX) return -1;
        number = 10 * number + (word[k] - '0');
    }
    return n > 0 && number >= 1 && number <= columns ? (int)number - 1 : -1;
}

const char *wcut_columns_choose(const char *option, int columns, int names, const wcut_cell *cell,
                                wcut_columns *chosen) {
    static const char *const expected = "the three (or six, with a normal) columns that the option columns names";

    /* no column is chosen yet */
    int fields = 0;
    wcut_columns c = {.column = {-1, -1, -1, -1, -1, -1}};
    double unit[3] = {0};

    /* a column for each word of the option */
    for (const char *p = option;; p++) {
        const size_t n = strcspn(p, ",");
        wcut_cell word = trim(p, p + n);
        if (fields == WCUT_FIELDS) return expected;
        const int column = find_column(word.at, (size_t)word.length, columns, names, cell);
        if (column < 0) return expected;
        if (fields < 3 && column < names) unit[fields] = read_cloud_columns_name(&cell[column]).unit;
        c.column[fields++] = column;
        p += n;
        if (*p == '\0') break;
    }

    /* a point, or a point and a normal, of one unit */
    if (fields != 3 && fields != WCUT_FIELDS) return expected;
    if (!agree(unit, &c.unit)) return "x, y and z in one unit";
    *chosen = c;

    return NULL;
}
