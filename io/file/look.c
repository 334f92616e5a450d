/* What a file is that was given in the place of another one: by its first bytes, in words, with the verb that takes it. */
#include "io/file/look.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "base/fail.h"

#define MESH_USE "compare takes it as SCAN or in the place of the job, mould as --stock"
#define CLOUD_USE "compare takes it as SCAN"
#define CAD_USE "compare takes a surface of it in the place of the job, --edges its curves"

/* what is looked at; so many control bytes make no text, fewer are a fault of it that its reader places */
enum { LOOK_MAX = 4096, CONTROLS_MIN = 4 };

/* the bytes that are looked at, and the ending of the name */
typedef struct view {
    char text[LOOK_MAX + 1]; /* zeros are blanks here */
    size_t length, whole;    /* looked at; all that are known */
    const char *first;       /* behind blanks and a byte order mark */
    const char *ending;
    bool is_binary; /* a zero byte */
    int controls;
} view;

static void make_view(view *v, const char *bytes, size_t length, const char *label) {
    v->whole = length;
    v->length = length < LOOK_MAX ? length : LOOK_MAX;
    v->is_binary = false;
    v->controls = 0;
    for (size_t k = 0; k < v->length; k++) {
        v->is_binary = v->is_binary || bytes[k] == '\0';
        v->controls += (unsigned char)bytes[k] < 0x20 && !strchr("\t\n\r\f\v", bytes[k]);
        v->controls += bytes[k] == '\0';
        v->text[k] = bytes[k] ? bytes[k] : ' ';
    }
    v->text[v->length] = '\0';
    v->first = v->text;
    if (strncmp(v->first, "\xef\xbb\xbf", 3) == 0) v->first += 3;
    v->first += strspn(v->first, " \t\r\n");
    const char *point = strrchr(label, '.');
    v->ending = point && !strchr(point, '/') ? point : "";
}

static bool begins_with(const char *text, const char *word) { return strncasecmp(text, word, strlen(word)) == 0; }

static bool is_ending(const view *v, const char *ending) { return strcasecmp(v->ending, ending) == 0; }

/* ---- kinds that their first bytes tell ---- */

static const struct {
    const char *begin;
    wcut_look look;
} by_begin[] = {
    {"ISO-10303-21", {"a STEP file", CAD_USE}},
    {"ASTM-E57",
     {"a cloud in E57, which would need the library libE57Format (not in Debian 12)",
      "export it as PLY, LAS or PTS, or convert it: CloudCompare -O in.e57 -C_EXPORT_FMT PLY -SAVE_CLOUDS"}},
    {"# .PCD", {"a cloud (PCD)", CLOUD_USE}},
    {"AutoCAD Binary DXF", {"a DXF drawing", "export it as STEP or IGES"}},
    {"AC10", {"a DWG drawing", "export it as STEP or IGES"}},
    {"3D Geometry File Format", {"a Rhino model", "export it as STEP or IGES"}},
    {"Kaydara FBX", {"an FBX model", "export it as STL or PLY"}},
    {"glTF", {"a mesh (glTF)", MESH_USE}},
    {"\037\213", {"a gzip archive", "unpack it first"}},
    {"%PDF", {"a PDF document", ""}},
    {"\x89PNG", {"a PNG picture", ""}},
    {"\xff\xd8\xff", {"a JPEG picture", ""}},
    {"\xff\xfe", {"UTF-16 text", "save it as UTF-8"}},
    {"\xfe\xff", {"UTF-16 text", "save it as UTF-8"}},
    {"\xd0\xcf\x11\xe0", {"an old spreadsheet or document", "save it as CSV"}},
    {"<VTKFile", {"a file of ParaView", ""}},
    {"# vtk DataFile", {"a file of ParaView", ""}},
    {"<!DOCTYPE html", {"a web page", ""}},
    {"<html", {"a web page", ""}},
    {"<?xml", {"XML", ""}},
};

/* ---- meshes, clouds, drawings ---- */

/* "0 / SECTION" of a DXF; a first row "v ", "o ", "mtllib" of an OBJ */
static bool begins_dxf(const char *first) {
    return *first == '0' && strspn(first + 1, " \t\r\n") > 0 &&
           begins_with(first + 1 + strspn(first + 1, " \t\r\n"), "SECTION");
}

static bool begins_obj(const view *v) {
    const char *p = v->first;
    while (*p == '#') {
        p = strchr(p, '\n');
        if (!p) return false;
        p += strspn(p, " \t\r\n");
    }
    const bool word = begins_with(p, "v ") || begins_with(p, "mtllib ") || begins_with(p, "o ") || begins_with(p, "g ");
    return word && (strstr(p, "\nv ") || begins_with(p, "v "));
}

/* a binary STL of its stated size, where all bytes are known */
static bool has_stl_size(const view *v, const char *bytes) {
    if (v->whole < 84 || !v->is_binary) return false;
    const unsigned char *n = (const unsigned char *)bytes + 80;
    const size_t count = n[0] | (size_t)n[1] << 8 | (size_t)n[2] << 16 | (size_t)n[3] << 24;
    return count > 0 && v->whole == 84 + 50 * count;
}

static wcut_look look_at_shape(const view *v, const char *bytes) {
    const bool is_stl = (begins_with(v->first, "solid") && strstr(v->first, "facet")) || has_stl_size(v, bytes);
    if (is_stl || (is_ending(v, ".stl") && v->is_binary)) return (wcut_look){"a mesh (STL)", MESH_USE};
    if (begins_with(v->first, "ply\n") || begins_with(v->first, "ply\r"))
        return strstr(v->first, "element face") ? (wcut_look){"a mesh (PLY)", MESH_USE}
                                                : (wcut_look){"a cloud (PLY)", CLOUD_USE};

    /* text that names corners or its kind */
    if (begins_obj(v)) return (wcut_look){"a mesh (OBJ)", MESH_USE};
    const size_t dims = strspn(v->first, "STCN4n");
    if (dims <= 4 && strncmp(v->first + dims, "OFF", 3) == 0 && isspace((unsigned char)v->first[dims + 3]))
        return (wcut_look){"a mesh (OFF)", MESH_USE};

    /* LAS: the top bit of the point format marks compression */
    if (strncmp(v->text, "LASF", 4) == 0) {
        const bool packed = is_ending(v, ".laz") || (v->length > 104 && ((unsigned char)v->text[104] & 0x80));
        if (!packed) return (wcut_look){"a cloud (LAS)", CLOUD_USE};
        return (wcut_look){"a cloud in LAZ, which would need the library LASzip (not in Debian 12)",
                           "unpack it with laszip or las2las to LAS"};
    }

    /* drawings and archives */
    if (v->length > 80 && v->text[72] == 'S' && (v->text[80] == '\n' || v->text[80] == '\r'))
        return (wcut_look){"an IGES file", CAD_USE};
    if (begins_dxf(v->first)) return (wcut_look){"a DXF drawing", "export it as STEP or IGES"};
    if (strncmp(v->text, "PK\003\004", 4) == 0) {
        if (is_ending(v, ".xlsx") || is_ending(v, ".ods")) return (wcut_look){"a spreadsheet", "save it as CSV"};
        return is_ending(v, ".3mf") ? (wcut_look){"a mesh (3MF)", "export it as STL"}
                                    : (wcut_look){"a ZIP archive", "unpack it first"};
    }
    return (wcut_look){NULL, ""};
}

/* ---- JSON and tables ---- */

bool wcut_look_is_json(const char *bytes, size_t length) {
    size_t at = length >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
    while (at < length && bytes[at] && strchr(" \t\r\n", bytes[at])) at++;
    return at < length && (bytes[at] == '{' || bytes[at] == '[');
}

static const struct {
    const char *format;
    wcut_look look;
} by_format[] = {
    {"wirecut-job/", {"a job (JSON)", "simulate, path, mould, control and compare take a job"}},
    {"wirecut-case/", {"a case (JSON)", "score and diagnose take a case"}},
    {"wirecut-diagnosis/", {"a diagnosis (JSON)", "apply takes a diagnosis"}},
    {"wirecut-force-law/", {"force laws (JSON)", "--force-law takes them"}},
    {"wirecut-", {"a result of wirecut (JSON)", ""}},
};

const char *wcut_look_format(const char *format) {
    for (size_t k = 0; k + 1 < sizeof by_format / sizeof *by_format; k++)
        if (begins_with(format, by_format[k].format)) return by_format[k].look.use;
    return "";
}

static wcut_look look_at_json(const view *v) {
    if (strstr(v->first, "\"asset\"") && strstr(v->first, "\"meshes\"")) return (wcut_look){"a mesh (glTF)", MESH_USE};
    const char *format = strstr(v->first, "\"wirecut-");
    for (size_t k = 0; format && k < sizeof by_format / sizeof *by_format; k++)
        if (begins_with(format + 1, by_format[k].format)) return by_format[k].look;
    return (wcut_look){"JSON", ""};
}

/* the names of a table's columns tell what it holds */
static wcut_look look_at_table(const view *v) {
    char header[LOOK_MAX + 1];
    const size_t n = strcspn(v->first, "\r\n");
    memcpy(header, v->first, n);
    header[n] = '\0';
    if (!strpbrk(header, ",;\t") || v->is_binary) return (wcut_look){NULL, ""};
    if (strstr(header, "time_s") && strstr(header, "station"))
        return (wcut_look){"a recording (CSV)", "score takes it behind its job"};
    if (strstr(header, "heat_W_per_m") && strstr(header, "engaged_mm"))
        return (wcut_look){"test cuts (CSV)", "calibrate takes them"};
    if (strstr(header, "scan_x_mm") && strstr(header, "block_x_mm"))
        return (wcut_look){"datums (CSV)", "compare takes them as --datum"};
    if (strcspn(header, "xX") < n && strcspn(header, "yY") < n && strcspn(header, "zZ") < n)
        return (wcut_look){"a table of points", "compare takes it as SCAN, --edges as curves"};
    return (wcut_look){NULL, ""};
}

bool wcut_look_is_table(const char *kind) { return strstr(kind, "(CSV)") != NULL || begins_with(kind, "a table"); }

/* ---- any ---- */

wcut_look wcut_look_at(const char *bytes, size_t length, const char *label) {
    view v;
    make_view(&v, bytes, length, label);
    for (size_t k = 0; k < sizeof by_begin / sizeof *by_begin; k++)
        if (begins_with(v.text, by_begin[k].begin) || begins_with(v.first, by_begin[k].begin)) return by_begin[k].look;
    wcut_look found = look_at_shape(&v, bytes);
    if (!found.kind && wcut_look_is_json(bytes, length)) found = look_at_json(&v);
    if (!found.kind) found = look_at_table(&v);
    if (!found.kind && v.controls >= CONTROLS_MIN) found = (wcut_look){"binary data of no known kind", ""};
    return found;
}

wcut_status wcut_look_refuse(const char *bytes, size_t length, const char *label, const char *expected,
                             wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    const wcut_look found = wcut_look_at(bytes, length, label);
    if (!found.kind) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_FORMAT, "%s: found %s, expected %s%s%s",
                     wcut_quote(name, label, WCUT_LABEL_MAX, 1), found.kind, expected, *found.use ? "; " : "",
                     found.use);
}
