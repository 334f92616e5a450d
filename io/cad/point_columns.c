/* Names of columns in a table of curves: which coordinate of which curve, the unit, what names a curve or counts points. */
#include "io/cad/point_columns.h"

#include <ctype.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "io/file/unit.h"

/* ---- words ---- */

static const char *const curve_words[] = {
    "edge",   "curve",   "side",    "line",  "polyline", "path",  "spline", "mount",   "boundary", "border",
    "rail",   "profile", "contour", "kante", "kurve",    "seite", "linie",  "rand",    "track",    "polygon",
    "branch", "arete",   "courbe",  "edges", "curves",   "lines", "ply",    "polyzug", "spur",     NULL};
static const char *const side_words[] = {"left",  "right", "links", "rechts", "first", "second", "top",  "bottom",
                                         "upper", "lower", "inner", "outer",  "front", "back",   "near", "far",
                                         "one",   "two",   "oben",  "unten",  "innen", "aussen", "lhs",  "rhs",
                                         "west",  "east",  "north", "south",  "start", "end",    NULL};
static const char *const id_words[] = {"id",      "name",  "label",  "group", "set", "part",
                                       "segment", "layer", "object", "key",   NULL};
static const char *const index_words[] = {"n", "nr",  "no",    "num",     "number", "index",  "idx", "i",      "k",
                                          "j", "seq", "order", "station", "count",  "sample", "row", "nummer", NULL};
static const char *const neutral_words[] = {
    "coord", "coords", "coordinate", "coordinates", "koordinate", "pos",   "position",
    "point", "points", "pt",         "vertex",      "location",   "value", "cartesian",
    "achse", "axis",   "p",          "pnt",         "pointid",    "punkt", NULL};
static const char *const normal_words[] = {"normal", "normals", "nrm", "n", "tangent", NULL};

static bool is_listed(const char *word, size_t n, const char *const *list) {
    for (; *list; list++)
        if (strlen(*list) == n && strncasecmp(*list, word, n) == 0) return true;
    return false;
}

static bool is_word_byte(char c) { return isalnum((unsigned char)c) || (unsigned char)c >= 0x80; }

/* the next word of a text from *at on; false: none is left */
static bool next_word(const char *text, int length, int *at, const char **word, size_t *n) {
    int k = *at;
    while (k < length && !is_word_byte(text[k])) k++;
    const int from = k;
    while (k < length && is_word_byte(text[k])) k++;
    *at = k;
    *word = text + from;
    *n = (size_t)(k - from);
    return k > from;
}

/* 0 .. 2 for a word that is an axis, -1 otherwise */
static int find_axis(const char *word, size_t n) {
    const int c = n == 1 ? tolower((unsigned char)word[0]) : 0;
    return c >= 'x' && c <= 'z' ? c - 'x' : -1;
}

/* whether a word can tell one curve from another: "a", "2", "left", "edge", "edge2", "curveB" */
static bool is_label(const char *word, size_t n) {
    for (const char *const *w = curve_words; *w; w++) {
        const size_t m = strlen(*w);
        if (n < m || strncasecmp(*w, word, m) != 0) continue;
        if (n == m || is_label(word + m, n - m)) return true;
    }
    if (is_listed(word, n, side_words)) return true;
    if (n == 1 && (strchr("abcdefgh", tolower((unsigned char)*word)) || strchr("lr", tolower((unsigned char)*word))))
        return true;
    size_t digits = 0;
    while (digits < n && isdigit((unsigned char)word[digits])) digits++;
    return n > 0 && n <= 4 && digits == n;
}

bool wcut_point_label_whole(const char *text, int length) {
    const char *word;
    size_t n;
    int at = 0, words = 0;
    for (; next_word(text, length, &at, &word, &n); words++)
        if (!is_label(word, n)) return false;
    return words > 0;
}

/* ---- a name ---- */

typedef enum name_role { NAME_OTHER, NAME_AXIS, NAME_NORMAL, NAME_ID, NAME_INDEX, NAME_ODD } name_role;

typedef struct column_name {
    name_role role;
    int axis;
    double unit; /* [mm] 0: none */
    char label[WCUT_POINT_LABEL_SIZE];
} column_name;

static void add_label(column_name *name, const char *word, size_t n) {
    size_t used = strlen(name->label);
    if (used > 0 && used + 1 < sizeof name->label) name->label[used++] = '_';
    for (size_t k = 0; k < n && used + 1 < sizeof name->label; k++)
        name->label[used++] = (char)tolower((unsigned char)word[k]);
    name->label[used] = '\0';
}

/* an axis glued to what names a curve or a normal: "x1", "ax", "nx", "xleft" */
static bool take_glued_axis(column_name *name, const char *word, size_t n) {
    if (n < 2) return false;
    const int first = find_axis(word, 1), last = find_axis(word + n - 1, 1);
    const char *rest = last >= 0 ? word : word + 1;
    if ((first < 0 && last < 0) || (first >= 0 && last >= 0)) return false;
    if (last >= 0 && is_listed(rest, n - 1, normal_words)) {
        name->role = NAME_NORMAL;
        return true;
    }
    if (!is_label(rest, n - 1)) return false;
    name->axis = last >= 0 ? last : first;
    add_label(name, rest, n - 1);
    return true;
}

/* the words of a name: an axis, a unit behind it, what names a curve; every other word makes an axis odd */
static column_name read_column_name(const wcut_point_cell *cell) {
    column_name name = {NAME_OTHER, -1, 0, ""};
    const char *word;
    size_t n;
    int at = 0, words = 0;
    bool odd = false, is_id = false, counts = false, is_point = false;

    /* each word by the lists; what an axis means depends on the words before it */
    while (next_word(cell->at, cell->length, &at, &word, &n)) {
        words++;

        /* an axis, a normal, a unit behind an axis, an axis joined to a word, then names and counts */
        const double unit = wcut_unit_find(word, n);
        if (name.axis < 0 && find_axis(word, n) >= 0)
            name.axis = find_axis(word, n);
        else if (is_listed(word, n, normal_words) && n > 1)
            name.role = NAME_NORMAL;
        else if (name.axis >= 0 && unit > 0)
            name.unit = unit;
        else if (name.axis < 0 && take_glued_axis(&name, word, n))
            continue;
        else if (is_label(word, n)) {
            is_id = is_id || is_listed(word, n, curve_words);
            add_label(&name, word, n);
        } else if (is_listed(word, n, neutral_words))
            is_point = true;
        else if (is_listed(word, n, id_words))
            is_id = true;
        else if (is_listed(word, n, index_words))
            counts = true;
        else
            odd = true;
    }

    /* what the words say together: "n_x" is a normal, "curve no" names a curve, "curve point" counts points */
    if (name.role == NAME_NORMAL) return name;
    if (name.axis >= 0)
        name.role = !counts && !odd ? NAME_AXIS : words == 2 && counts ? NAME_NORMAL : NAME_ODD;
    else if (!odd)
        name.role = is_point ? NAME_INDEX : is_id ? NAME_ID : counts ? NAME_INDEX : NAME_OTHER;
    return name;
}

bool wcut_point_columns_named(int count, const wcut_point_cell *cell) {
    bool seen[3] = {false, false, false};
    for (int k = 0; k < count; k++) {
        const column_name name = read_column_name(&cell[k]);
        if (name.role == NAME_AXIS || name.role == NAME_ODD) seen[name.axis] = true;
    }
    return seen[0] && seen[1] && seen[2];
}

double wcut_point_columns_unit(int count, const wcut_point_cell *cell) {
    double one = 0;
    for (int k = 0; k < count; k++) {
        const char *word;
        size_t n;
        int at = 0;
        if (!next_word(cell[k].at, cell[k].length, &at, &word, &n)) continue;
        const double unit = wcut_unit_find(word, n);
        if (unit <= 0 || next_word(cell[k].at, cell[k].length, &at, &word, &n)) return 0;
        if (one > 0 && unit != one) return -1;
        one = unit;
    }
    return one;
}

/* ---- sets ---- */

/* the set of this label that lacks the axis; a name that stands twice begins a further curve. NULL: too many */
static wcut_point_set *find_set(wcut_point_columns *c, const char *label, int axis) {
    for (int k = 0; k < c->sets; k++)
        if (strcmp(c->set[k].label, label) == 0 && c->set[k].column[axis] < 0) return &c->set[k];
    if (c->sets == WCUT_POINT_SETS_MAX) return NULL;
    wcut_point_set *set = &c->set[c->sets++];
    *set = (wcut_point_set){.column = {-1, -1, -1}};
    snprintf(set->label, sizeof set->label, "%s", label);
    return set;
}

/* a coordinate that all curves share, "x_a,x_b,y,z_a,z_b", stands in a set of its own without a label: give it to the others */
static void share_columns(wcut_point_columns *c) {
    int plain = -1;
    for (int k = 0; k < c->sets; k++)
        if (c->set[k].label[0] == '\0') plain = k;
    if (plain < 0 || c->sets < 3) return;

    /* what the plain set has, every other one lacks */
    const wcut_point_set shared = c->set[plain];
    for (int k = 0; k < c->sets; k++)
        for (int a = 0; a < 3; a++)
            if (k != plain && (c->set[k].column[a] >= 0) == (shared.column[a] >= 0)) return;
    for (int k = plain; k + 1 < c->sets; k++) c->set[k] = c->set[k + 1];
    c->sets--;
    for (int k = 0; k < c->sets; k++)
        for (int a = 0; a < 3; a++)
            if (shared.column[a] >= 0) c->set[k].column[a] = shared.column[a];
}

/* one letter beside coordinates without a name is as often a rotation or an acceleration as a second curve */
static bool is_clear(const wcut_point_columns *c) {
    bool plain = false, letter = false;
    for (int k = 0; k < c->sets; k++) {
        const char *label = c->set[k].label;
        plain = plain || label[0] == '\0';
        letter = letter || (label[0] && !label[1] && isalpha((unsigned char)label[0]));
    }
    return !(plain && letter);
}

/* put a coordinate's column into its set; NULL: done, else what was expected */
static const char *add_axis(wcut_point_columns *c, const column_name *name, int column) {
    wcut_point_set *set = find_set(c, name->label, name->axis);
    if (!set) return "at most 32 curves beside each other";
    set->column[name->axis] = column;
    if (name->unit > 0 && c->unit > 0 && name->unit != c->unit) return "x, y and z in one unit";
    if (name->unit > 0) c->unit = name->unit;
    return NULL;
}

const char *wcut_point_columns_find(int count, const wcut_point_cell *cell, wcut_point_columns *columns, int *odd) {
    wcut_point_columns c = {.columns = count, .id = {-1, -1}, .index = -1};
    *odd = -1;
    for (int k = 0; k < count; k++) {
        const column_name name = read_column_name(&cell[k]);
        if (name.role == NAME_ID && c.id[1] < 0) c.id[c.id[0] >= 0] = k;
        if (name.role == NAME_INDEX && c.index < 0) c.index = k;
        if (name.role != NAME_AXIS && name.role != NAME_ODD) continue;

        /* a coordinate: of which curve, in which unit */
        const char *expected =
            name.role == NAME_ODD ? "a coordinate's name such as x, x_mm or x_a" : add_axis(&c, &name, k);
        if (!expected) continue;
        *odd = k;
        return expected;
    }

    /* each curve has its three */
    share_columns(&c);
    for (int k = 0; k < c.sets; k++)
        for (int a = 0; a < 3; a++)
            if (c.set[k].column[a] < 0) return "columns x, y and z for each curve";
    if (c.sets == 0) return "columns x_mm, y_mm, z_mm";
    if (!is_clear(&c)) return "coordinates of two curves named alike, as x_a,y_a,z_a,x_b,y_b,z_b";
    *columns = c;
    return NULL;
}
