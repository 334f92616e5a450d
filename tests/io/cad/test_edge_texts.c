/* Two edges as people and programs write them down: read where only one reading fits, else refused with an example. */
#include <wirecut/curve.h>
#include <wirecut/projection.h>
#include <wirecut/read.h>

#include "base/alloc.h"
#include "io/cad/curve_set.h"
#include "test.h"

static wcut_curve_set *set;
static wcut_error error;

static wcut_status read_edges(const char *label, const char *text) {
    const wcut_curve_read_options options = wcut_curve_read_options_default();
    const size_t length = strlen(text);
    char *copy = calloc(length + 1, 1);
    memcpy(copy, text, length);
    wcut_curve_set_destroy(set);
    set = NULL;
    error.text[0] = '\0';
    const wcut_status status = wcut_curve_set_read_memory(copy, length, label, &options, &set, &error);
    free(copy);
    return status;
}

static void is_near(const char *text, wcut_vec3 p, const double *expected) {
    ck_assert_msg(fabs(p.x - expected[0]) + fabs(p.y - expected[1]) + fabs(p.z - expected[2]) < 1e-9,
                  "%s\nfound %g %g %g, expected %g %g %g", text, p.x, p.y, p.z, expected[0], expected[1], expected[2]);
}

/* the edges that every text below describes, by their three points; the middle one lies on the curve where it is passed */
static const double edge[2][3][3] = {{{0, 0, 150}, {0, 450, 160.5}, {0, 900, 136}},
                                     {{400, 0, 100}, {400, 450, 120.25}, {400, 900, 128}}};

static void is_edges(const char *label, const char *text) {
    ck_assert_msg(read_edges(label, text) == WCUT_OK, "%s\n%s", text, error.text);
    ck_assert_msg(set->count == 2, "%s\n%d curves", text, set->count);
    for (int k = 0; k < 2; k++) {
        const wcut_vec3 middle = {edge[k][1][0], edge[k][1][1], edge[k][1][2]};
        double first, last;
        wcut_vec3 p[2];
        wcut_curve_foot foot;
        wcut_curve_domain(set->curve[k], &first, &last);
        ck_assert_int_eq(wcut_curve_eval(set->curve[k], first, 0, &p[0]), WCUT_OK);
        ck_assert_int_eq(wcut_curve_eval(set->curve[k], last, 0, &p[1]), WCUT_OK);
        is_near(text, p[0], edge[k][0]);
        is_near(text, p[1], edge[k][2]);
        ck_assert_int_eq(wcut_curve_locate(set->curve[k], 1, &middle, 1, &foot), WCUT_OK);
        ck_assert_msg(foot.distance < 1e-6, "%s\nthe middle point is %g mm off", text, foot.distance);
    }
}

/* ---- tables ---- */

#define A "0,0,150\n0,450,160.5\n0,900,136\n"
#define B "400,0,100\n400,450,120.25\n400,900,128\n"

static const char *const tables[] = {
    /* a column that names the curve */
    "curve,x,y,z\na,0,0,150\na,0,450,160.5\na,0,900,136\nb,400,0,100\nb,400,450,120.25\nb,400,900,128\n",
    "Edge,X [mm],Y [mm],Z [mm]\n1,0,0,150\n1,0,450,160.5\n1,0,900,136\n2,400,0,100\n2,400,450,120.25\n2,400,900,128\n",
    "x_mm,y_mm,z_mm,edge\n0,0,150,left\n0,450,160.5,left\n0,900,136,left\n400,0,100,right\n400,450,120.25,right\n"
    "400,900,128,right\n",
    "\"side\",\"x\",\"y\",\"z\"\n\"A\",\"0\",\"0\",\"150\"\n\"A\",\"0\",\"450\",\"160.5\"\n\"A\",\"0\",\"900\","
    "\"136\"\n"
    "\"B\",\"400\",\"0\",\"100\"\n\"B\",\"400\",\"450\",\"120.25\"\n\"B\",\"400\",\"900\",\"128\"\n",
    /* ... its rows alternating, with a count of points, the name once as in merged cells */
    "curve,x,y,z\na,0,0,150\nb,400,0,100\na,0,450,160.5\nb,400,450,120.25\na,0,900,136\nb,400,900,128\n",
    "point,curve_id,x,y,z\n0,0,0,0,150\n0,1,400,0,100\n1,0,0,450,160.5\n1,1,400,450,120.25\n2,0,0,900,136\n"
    "2,1,400,900,128\n",
    "id,edge,x,y,z\n1,a,0,0,150\n2,a,0,450,160.5\n3,a,0,900,136\n4,b,400,0,100\n5,b,400,450,120.25\n6,b,400,900,128\n",
    "edge,x,y,z\na,0,0,150\n,0,450,160.5\n,0,900,136\nb,400,0,100\n,400,450,120.25\n,400,900,128\n",
    "a,0,0,150\na,0,450,160.5\na,0,900,136\nb,400,0,100\nb,400,450,120.25\nb,400,900,128\n",
    "0 0 150 A\n0 450 160.5 A\n0 900 136 A\n400 0 100 B\n400 450 120.25 B\n400 900 128 B\n",
    /* blank lines, titles, headers, comments and rows of nothing between blocks */
    A "\n" B,
    "x_mm,y_mm,z_mm\n" A "\n" B,
    "x,y,z\n" A "\n\n\n" B "\n\n",
    "x,y,z\n" A ",,\n" B,
    "x,y,z\n" A "nan,nan,nan\n" B,
    "Edge A\nx,y,z\n" A "\nEdge B\nx,y,z\n" B,
    "x,y,z\n" A "x,y,z\n" B,
    "edge a:\n" A "edge b:\n" B,
    "Kante links\n" A "Kante rechts\n" B,
    "Rim of the part\n" A "Foot of the part\n" B,
    "# edge A\n" A "# edge B\n" B,
    "# drawn on Monday\n# x, y, z\n" A "\n# curve 2\n" B,
    ">\n" A ">\n" B,
    "3\n" A "3\n" B,
    /* a count of points that begins again */
    "n,x,y,z\n1,0,0,150\n2,0,450,160.5\n3,0,900,136\n1,400,0,100\n2,400,450,120.25\n3,400,900,128\n",
    /* curves beside each other */
    "x1,y1,z1,x2,y2,z2\n0,0,150,400,0,100\n0,450,160.5,400,450,120.25\n0,900,136,400,900,128\n",
    "x_a_mm,y_a_mm,z_a_mm,x_b_mm,y_b_mm,z_b_mm\n0,0,150,400,0,100\n0,450,160.5,400,450,120.25\n0,900,136,400,900,128\n",
    "ax,ay,az,bx,by,bz\n0,0,150,400,0,100\n0,450,160.5,400,450,120.25\n0,900,136,400,900,128\n",
    "Left X,Left Y,Left Z,Right X,Right Y,Right "
    "Z\n0,0,150,400,0,100\n0,450,160.5,400,450,120.25\n0,900,136,400,900,128\n",
    "x,y,z,x.1,y.1,z.1\n0,0,150,400,0,100\n0,450,160.5,400,450,120.25\n0,900,136,400,900,128\n",
    "x,y,z,x,y,z\n0,0,150,400,0,100\n0,450,160.5,400,450,120.25\n0,900,136,400,900,128\n",
    "station,y,x_a,z_a,x_b,z_b\n1,0,0,150,400,100\n2,450,0,160.5,400,120.25\n3,900,0,136,400,128\n",
    "0.0,0,150,400,0,100\n0,450,160.5,400,450,120.25\n0,900,136,400,900,128\n",
    "x1,y1,z1,x2,y2,z2\n0,0,150,400,0,100\n0,450,160.5,400,450,120.25\n0,900,136,,,\n,,,400,900,128\n",
    /* separators, decimal commas, line ends, marks, brackets, remarks */
    "x;y;z\n0;0;150\n0;450;160,5\n0;900;136\n\n400;0;100\n400;450;120,25\n400;900;128\n",
    "curve;x_mm;y_mm;z_mm\na;0;0;150\na;0;450;160,5\na;0;900;136\nb;400;0;100\nb;400;450;120,25\nb;400;900;128\n",
    "x1;y1;z1;x2;y2;z2\n0;0;150;400;0;100\n0;450;160,5;400;450;120,25\n0;900;136;400;900;128\n",
    "x\ty\tz\n0\t0\t150\n0\t450\t160,5\n0\t900\t136\n\n400\t0\t100\n400\t450\t120,25\n400\t900\t128\n",
    "0 0 150\n0 450 160,5\n0 900 136\n\n400 0 100\n400 450 120,25\n400 900 128\n",
    "  0.0   0.0  150.0\n  0.0 450.0  160.5\n  0.0 900.0  136.0\n\n400 0 100\n400 450 120.25\n400 900 128\n",
    "x,y,z\n\"0\",\"0\",\"150\"\n\"0\",\"450\",\"160,5\"\n0,900,136\n\n400,0,100\n400,450,\"120,25\"\n400,900,128\n",
    "\xef\xbb\xbfx,y,z\r\n0,0,150\r\n0,450,160.5\r\n0,900,136\r\n\r\n400,0,100\r\n400,450,120.25\r\n400,900,128\r\n",
    "x,y,z\r0,0,150\r0,450,160.5\r0,900,136\r\r400,0,100\r400,450,120.25\r400,900,128\r",
    "sep=;\nx;y;z\n0;0;150\n0;450;160.5\n0;900;136\n\n400;0;100\n400;450;120.25\n400;900;128\n",
    "(0, 0, 150),\n(0, 450, 160.5),\n(0, 900, 136),\n\n(400, 0, 100),\n(400, 450, 120.25),\n(400, 900, 128)\n",
    "{0, 0, 150}\n{0, 450, 160.5}\n{0, 900, 136}\n\n{400, 0, 100}\n{400, 450, 120.25}\n{400, 900, 128}\n",
    "0, 0, 150;\n0, 450, 160.5;\n0, 900, 136;\n\n400, 0, 100;\n400, 450, 120.25;\n400, 900, 128;\n",
    "x,y,z\n0,0,150 # the corner\n0,450,160.5\n0,900,136\n\n400,0,100\n400,450,120.25\n400,900,128\n",
    /* units, the order of columns, what is beside them */
    "curve,x_m,y_m,z_m\na,0,0,.150\na,0,.450,.1605\na,0,.900,.136\nb,.4,0,.1\nb,.4,.45,.12025\nb,.4,.9,.128\n",
    "x (cm),y (cm),z (cm)\n0,0,15\n0,45,16.05\n0,90,13.6\n\n40,0,10\n40,45,12.025\n40,90,12.8\n",
    "x,y,z\ncm,cm,cm\n0,0,15\n0,45,16.05\n0,90,13.6\n\n40,0,10\n40,45,12.025\n40,90,12.8\n",
    "x in mm,y in mm,z in mm\n" A "\n" B,
    "# units: cm\n0,0,15\n0,45,16.05\n0,90,13.6\n\n40,0,10\n40,45,12.025\n40,90,12.8\n",
    "z,x,y,remark\n150,0,0,start\n160.5,0,450,\n136,0,900,\n\n100,400,0,\n120.25,400,450,\n128,400,900,end\n",
    "x,y,z,nx,ny,nz\n0,0,150,0,0,1\n0,450,160.5,0,0,1\n0,900,136,0,0,1\n\n400,0,100,0,0,1\n400,450,120.25,0,0,1\n"
    "400,900,128,0,0,1\n",
    "X-Koordinate [mm];Y-Koordinate [mm];Z-Koordinate [mm]\n0;0;150\n0;450;160,5\n0;900;136\n\n400;0;100\n"
    "400;450;120,25\n400;900;128\n",
};

TEST(a_table_of_two_edges_is_read_however_its_curves_are_told_apart) {
    for (size_t k = 0; k < sizeof tables / sizeof *tables; k++) {
        is_edges("edges.csv", tables[k]);
        is_edges("edges.txt", tables[k]);
    }
    ck_assert_int_eq(set->format, WCUT_CURVE_FORMAT_CSV);
    wcut_curve_set_destroy(set);
    set = NULL;
}

TEST(curves_have_the_names_that_the_table_gives_them) {
    static const struct {
        const char *text, *name[2];
    } named[] = {{"curve,x,y,z\nrim,0,0,1\nrim,1,0,1\nfoot,0,5,1\nfoot,1,5,1\n", {"rim", "foot"}},
                 {"x_a,y_a,z_a,x_b,y_b,z_b\n0,0,1,0,5,1\n1,0,1,1,5,1\n", {"a", "b"}},
                 {"# edge A\n0,0,1\n1,0,1\n# edge B:\n0,5,1\n1,5,1\n", {"edge A", "edge B"}},
                 {"0,0,1\n1,0,1\n\n0,5,1\n1,5,1\n", {"", ""}}};
    for (size_t k = 0; k < sizeof named / sizeof *named; k++) {
        ck_assert_msg(read_edges("a.csv", named[k].text) == WCUT_OK, "%s", error.text);
        ck_assert_int_eq(set->count, 2);
        for (int c = 0; c < 2; c++) ck_assert_str_eq(set->name[c], named[k].name[c]);
    }
    wcut_curve_set_destroy(set);
    set = NULL;
}

/* ---- JSON ---- */

#define JA "[[0,0,150],[0,450,160.5],[0,900,136]]"
#define JB "[[400,0,100],[400,450,120.25],[400,900,128]]"

static const char *const objects[] = {
    "[" JA "," JB "]",
    "\xef\xbb\xbf[" JA "," JB "]",
    "{\"curves\": [{\"points_mm\": " JA "}, {\"points_mm\": " JB "}]}",
    "[{\"points_mm\": " JA "}, {\"points_mm\": " JB "}]",
    "{\"edge_a\": {\"points_mm\": " JA "}, \"edge_b\": {\"points_mm\": " JB "}}",
    "{\"edge_a\": " JA ", \"edge_b\": " JB "}",
    "{\"left\": {\"points\": " JA "}, \"right\": {\"points\": " JB "}, \"comment\": \"two edges\", \"unit\": \"mm\"}",
    "{\"edges\": [{\"name\": \"a\", \"points_mm\": " JA "}, {\"name\": \"b\", \"points_mm\": " JB "}]}",
    "{\"edges\": {\"a\": {\"vertices\": " JA "}, \"b\": {\"vertices\": " JB "}}}",
    "{\"format\": \"wirecut-job/1\", \"name\": \"x\", \"block\": {\"size_mm\": [1,2,3]}, \"design\": {\"edge_a\": "
    "{\"points_mm\": " JA "}, \"edge_b\": {\"points_mm\": " JB "}}}",
    "{\"a\": [{\"x\":0,\"y\":0,\"z\":150},{\"x\":0,\"y\":450,\"z\":160.5},{\"x\":0,\"y\":900,\"z\":136}],"
    " \"b\": [{\"x\":400,\"y\":0,\"z\":100},{\"x\":400,\"y\":450,\"z\":120.25},{\"x\":400,\"y\":900,\"z\":128}]}",
    "{\"a\": {\"x\": [0,0,0], \"y\": [0,450,900], \"z\": [150,160.5,136]},"
    " \"b\": {\"x\": [400,400,400], \"y\": [0,450,900], \"z\": [100,120.25,128]}}",
    "[{\"curve\":\"a\",\"x\":0,\"y\":0,\"z\":150},{\"curve\":\"b\",\"x\":400,\"y\":0,\"z\":100},"
    "{\"curve\":\"a\",\"x\":0,\"y\":450,\"z\":160.5},{\"curve\":\"b\",\"x\":400,\"y\":450,\"z\":120.25},"
    "{\"curve\":\"a\",\"x\":0,\"y\":900,\"z\":136},{\"curve\":\"b\",\"x\":400,\"y\":900,\"z\":128}]",
    "[{\"edge\":1,\"x_cm\":0,\"y_cm\":0,\"z_cm\":15},{\"edge\":1,\"x_cm\":0,\"y_cm\":45,\"z_cm\":16.05},"
    "{\"edge\":1,\"x_cm\":0,\"y_cm\":90,\"z_cm\":13.6},{\"edge\":2,\"x_cm\":40,\"y_cm\":0,\"z_cm\":10},"
    "{\"edge\":2,\"x_cm\":40,\"y_cm\":45,\"z_cm\":12.025},{\"edge\":2,\"x_cm\":40,\"y_cm\":90,\"z_cm\":12.8}]",
    "{\"unit\": \"m\", \"a\": [[0,0,0.15],[0,0.45,0.1605],[0,0.9,0.136]], \"b\": [[0.4,0,0.1],[0.4,0.45,0.12025],"
    "[0.4,0.9,0.128]]}",
    "{\"a\": {\"points_cm\": [[0,0,15],[0,45,16.05],[0,90,13.6]]}, \"b\": {\"points_cm\": [[40,0,10],[40,45,12.025],"
    "[40,90,12.8]]}}",
    "{\"type\": \"FeatureCollection\", \"features\": [{\"type\": \"Feature\", \"properties\": {\"name\": \"a\"}, "
    "\"geometry\": {\"type\": \"LineString\", \"coordinates\": " JA
    "}}, {\"type\": \"Feature\", \"properties\": {}, "
    "\"geometry\": {\"type\": \"LineString\", \"coordinates\": " JB "}}]}",
    "{\"type\": \"MultiLineString\", \"coordinates\": [" JA "," JB "]}",
    "{\"type\": \"GeometryCollection\", \"geometries\": [{\"type\": \"LineString\", \"coordinates\": " JA
    "}, "
    "{\"type\": \"LineString\", \"coordinates\": " JB "}]}",
};

TEST(json_of_two_edges_is_read_however_it_is_nested) {
    for (size_t k = 0; k < sizeof objects / sizeof *objects; k++) {
        is_edges("edges.json", objects[k]);
        is_edges("edges", objects[k]);
        is_edges("edges.txt", objects[k]);
    }
    ck_assert_int_eq(set->format, WCUT_CURVE_FORMAT_JSON);
    wcut_curve_set_destroy(set);
    set = NULL;
}

/* ---- what fits no reading, or two ---- */

typedef struct refused {
    const char *label, *text, *words;
} refused;

static const refused refusals[] = {
    {"a.csv", "0,0,150,1\n0,450,160,1\n", "line 1: found 4 values without a header"},
    {"a.csv", "0,0,150,0,5,3\n0,4,160,5,6,7\n", "line 1: found commas that may be decimal ones"},
    {"a.csv", "0.5,0,150,0,0,1\n0,4,160,0,0,1\n", "line 1: found points with normals"},
    {"a.csv", "x,y,z\n0,0,150,5\n", "line 2: found 4 values, expected 3"},
    {"a.csv", "x,y,z\n0,0,150\n1,,160\n", "line 3: found no y, expected a number"},
    {"a.csv", "x,y,z\n0,0,150\n1,1,16O\n", "line 3: found \"16O\", expected a number"},
    {"a.csv", "x,y,z\n0,0,150\n1,1,2e12\n", "line 3: found a coordinate beyond 1e12"},
    {"a.csv", "x,y\n0,0\n1,0\n", "found 2 values without a header"},
    {"a.csv", "east,north,height\n0,0,0\n1,0,0\n", "line 1: found \"east\", expected columns named x_mm, y_mm, z_mm"},
    {"a.csv", "x_furlong,y_furlong,z_furlong\n0,0,0\n1,0,0\n", "found \"x_furlong\", expected a coordinate's name"},
    {"a.csv", "x_mm,y_cm,z_mm\n0,0,0\n1,0,0\n", "found \"y_cm\", expected x, y and z in one unit"},
    {"a.csv", "x,y,z\nmm,cm,mm\n0,0,0\n1,0,0\n", "line 2: found several units"},
    {"a.csv", "# unit: m\nx_mm,y_mm,z_mm\n0,0,0\n1,0,0\n", "line 2: found a second unit"},
    {"a.csv", "x,y,z,rx,ry,rz\n0,0,0,0,0,0\n1,0,0,0,0,0\n", "coordinates of two curves named alike"},
    {"a.csv", "x_a,y_a,z_a,x_b,y_b\n0,0,0,0,0\n1,0,0,0,0\n", "columns x, y and z for each curve"},
    {"a.csv", "x1,y1,z1,x2,y2,z2\n0,0,0,4,0,0\n0,1,0,4,1,0\n\n1,0,0,4,0,0\n", "beside each other and below each other"},
    {"a.csv", "curve,layer,x,y,z\na,p,0,0,0\na,q,0,1,0\nb,p,4,0,0\nb,q,4,1,0\n", "two columns that name curves"},
    {"a.csv", "0,0,0\n\n0,1,0\n\n0,2,0\n", "a blank line behind each row"},
    {"a.csv", "n,x,y,z\n1,0,0,0\n3,0,1,0\n2,0,2,0\n", "line 4: found point 2 behind 3, expected counts in order"},
    {"a.csv", "n,curve,x,y,z\n1,a,0,0,0\n2,a,0,1,0\n1,b,0,0,0\n1,b,0,2,0\n", "line 5: found point 1 behind 1"},
    {"a.csv", "x,y,z\n0,0,0\n0,0,0\n", "line 2: found 2 points, expected two or more, neighbours apart"},
    {"a.csv", "x,y,z\n", "found no row of numbers"},
    {"a.csv", "", "found no row of numbers"},
    {"a.csv", "\xff\xfex", "found UTF-16"},
    {"a.csv", "x,y,z\n0,0,0\nremeasured\n0,1,0\n", "line 3: found \"remeasured\", expected a number"},
    {"a.csv", "x,y,z\n0,0,0\n1,1,1\nz,y,x\n0,1,0\n", "line 4: found other columns than before"},
    {"a.json", "[[[0,0],[0,1]],[[4,0],[4,1]]]", "$[0][0]: found an array of 2, expected three numbers"},
    {"a.json", "{\"edge_a\": [[0,0,1],[0,1,1]], \"scale\": 10}", "$.scale: found 10, expected a curve"},
    {"a.json", "{\"a\": [[0,0,1],[0,1,\"1\"]]}", "$.a[1][2]: found \"1\", expected"},
    {"a.json", "{\"unit\": \"rood\", \"a\": [[0,0,1],[0,1,1]]}", "$.unit: found \"rood\", expected a unit of length"},
    {"a.json", "{\"unit\": \"m\", \"a\": {\"points_mm\": [[0,0,1],[0,1,1]]}}", "expected one unit"},
    {"a.json", "{\"type\": \"LineString\", \"crs\": {}, \"coordinates\": [[0,0,1],[0,1,1]]}", "not those of a map"},
    {"a.json", "{\"type\": \"Point\", \"coordinates\": [0,0,1]}", "expected lines"},
    {"a.json", "{\"a\": {\"x\": [0,1], \"y\": [0,1], \"z\": [0]}}", "arrays x, y and z of one length"},
    {"a.json", "[[[0,0,1e13],[0,1,1]]]", "a coordinate up to 1e12 mm"},
    {"a.json", "[[0,0,1]]", "two points or more"},
    {"a.json", "[]", "found no curve, expected at least one"},
    {"a.json", "7", "expected"},
    {"a.json", "{\"a\":{\"a\":{\"a\":{\"a\":{\"a\":{\"a\":{\"a\":{\"a\":[[0,0,1],[0,1,1]]}}}}}}}}",
     "at most 8 values deep"},
};

TEST(what_fits_no_reading_or_two_is_refused_with_an_example) {
    for (size_t k = 0; k < sizeof refusals / sizeof *refusals; k++) {
        const refused *r = &refusals[k];
        ck_assert_msg(read_edges(r->label, r->text) == WCUT_BAD_FORMAT, "read: %s", r->text);
        ck_assert_ptr_null(set);
        ck_assert_msg(strstr(error.text, r->words) != NULL, "%s\nfound: %s\nexpected: %s", r->text, error.text,
                      r->words);
        ck_assert_msg(strstr(error.text, "two edges are written as ") != NULL, "%s\nfound: %s", r->text, error.text);
    }

    /* the example is read */
    is_edges("a.json", "{\"edge_a\": {\"points_mm\": " JA "}, \"edge_b\": {\"points_mm\": " JB "}}");
    ck_assert_int_eq(read_edges("a.csv", "curve,x_mm,y_mm,z_mm\na,0,0,150\na,0,900,136\nb,400,0,100\nb,400,900,128\n"),
                     WCUT_OK);
    ck_assert_int_eq(set->count, 2);
    wcut_curve_set_destroy(set);
    set = NULL;
}

TEST(without_memory_no_table_and_no_object_is_read_in_part) {
    EACH_FAILED_ALLOCATION(read_edges("a.csv", tables[5]), !set);
    EACH_FAILED_ALLOCATION(read_edges("a.csv", "x1,y1,z1,x2,y2,z2\n0,0,150,400,0,100\n0,450,160,400,450,120\n"), !set);
    EACH_FAILED_ALLOCATION(read_edges("a.json", objects[13]), !set);
    EACH_FAILED_ALLOCATION(read_edges("a.json", objects[4]), !set);
    wcut_curve_set_destroy(set);
    set = NULL;
}
