/* Clouds of every format come back as they were written, through windows and in pieces of any size. */
#include <locale.h>
#include <sys/stat.h>
#include <unistd.h>

#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/scan/cloud_given.h"
#include "test.h"

enum { COUNT = 300 };

/* coordinates that a float, an int and four decimals hold exactly */
static wcut_vec3 truth(int k) { return (wcut_vec3){k - 100, 2.5 * k, 0.0625 * (k % 37) - 1}; }
static wcut_vec3 whole(int k) { return (wcut_vec3){k % 120, (k / 3) % 100, k % 7}; }
static wcut_vec3 up(int k) { return k % 3 == 0 ? (wcut_vec3){0.6, 0, 0.8} : (wcut_vec3){0, -0.28, 0.96}; }

static bool equal(wcut_vec3 a, wcut_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
static bool close_to(wcut_vec3 a, wcut_vec3 b, double by) {
    return fabs(a.x - b.x) <= by && fabs(a.y - b.y) <= by && fabs(a.z - b.z) <= by;
}

static void came_back(wcut_cloud_format format, int stated) {
    reads(COUNT);
    for (int k = 0; k < COUNT; k++) ck_assert(equal(got[k], truth(k)));
    ck_assert(got_info.format == format && got_info.stated == stated && got_info.not_finite == 0);
    ck_assert(got_info.low.x == -100 && got_info.high.x == COUNT - 101 && got_info.low.y == 0);
    ck_assert(got_info.high.y == 2.5 * (COUNT - 1) && got_info.low.z == -1 && got_info.high.z == 1.25);
}

static void normals_came_back(double by) {
    ck_assert_int_eq(got_info.has_normals, 1);
    for (int k = 0; k < COUNT; k++) ck_assert(close_to(got_normal[k], up(k), by));
}

static void no_normals(void) {
    ck_assert_int_eq(got_info.has_normals, 0);
    for (int k = 0; k < COUNT; k++) ck_assert(got_normal[k].x == 999);
}

/* ---- PLY ---- */

/* properties of the vertex: x, lists and scalars that nobody asked for, y, z, normals */
static void put_ply(const char *format, const char *type, bool list, bool normals) {
    const bool ascii = strcmp(format, "ascii") == 0, big = strstr(format, "big") != NULL;
    put_text("ply\nformat %s 1.0\ncomment element vertex 3\nobj_info anything\n", format);
    put_text("element camera 2\nproperty double view\nproperty list uchar short steps\n");
    put_text("element vertex %d\nproperty %s x\nproperty uchar red\n%s", COUNT, type,
             list ? "property list int float w\n" : "");
    put_text("property %s y\nproperty %s z\n", type, type);
    if (normals) put_text("property float nx\nproperty double ny\nproperty float32 nz\n");
    put_text("element face 1\nproperty list uint8 int32 vertex_indices\nend_header\n");
    for (int k = 0; k < 2; k++) {
        if (ascii) put_text("1e300 2 7 8\n");
        if (!ascii) put_double(1e300, big), put_bits(2, 1, big), put_bits(7, 2, big), put_bits(8, 2, big);
    }
    for (int k = 0; k < COUNT; k++) {
        const wcut_vec3 p = truth(k), n = up(k);
        if (ascii) {
            put_text("%.9g 200 %s%.9g  %.9g", p.x, list ? k % 2 ? "3 1 2 nan " : "0 " : "", p.y, p.z);
            if (normals) put_text(" %.9g %.9g %.9g", n.x, n.y, n.z);
            put_text(k % 5 ? "\n" : " \r\n");
            continue;
        }
        put_scalar(type, p.x, big), put_bits(200, 1, big);
        if (list) put_bits((uint64_t)(k % 2 ? 3 : 0), 4, big);
        for (int j = 0; list && j < (k % 2 ? 3 : 0); j++) put_float(1, big);
        put_scalar(type, p.y, big), put_scalar(type, p.z, big);
        if (normals) put_float(n.x, big), put_double(n.y, big), put_float(n.z, big);
    }
    if (ascii)
        put_text("3 0 1 2\n\n");
    else
        put_bits(3, 1, big), put_bits(0, 4, big), put_bits(1, 4, big), put_bits(2, 4, big);
}

TEST(ply_of_every_byte_order_with_lists_and_normals_and_strange_elements) {
    const char *const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const char *const types[] = {"float", "double", "float32", "float64"};
    for (int k = 0; k < 3 * 4 * 4; k++) {
        begin();
        put_ply(formats[k / 16], types[k / 4 % 4], k & 1, k & 2);
        came_back(WCUT_CLOUD_FORMAT_PLY, COUNT);
        if (k & 2)
            normals_came_back(1e-7);
        else
            no_normals();
    }
}

TEST(ply_of_integer_coordinates) {
    const char *const types[] = {"char",   "int8",   "uchar", "uint8", "short", "int16",
                                 "ushort", "uint16", "int",   "int32", "uint",  "uint32"};
    for (int t = 0; t < 24; t++) {
        const char *type = types[t / 2];
        begin();
        put_text("ply\r\nformat binary_%s_endian 1.0\r\nelement vertex %d\r\nproperty %s x\r\nproperty %s y\r\n",
                 t % 2 ? "big" : "little", COUNT, type, type);
        put_text("property %s z\r\nend_header\r\n", type);
        for (int k = 0; k < 3 * COUNT; k++) {
            const wcut_vec3 p = whole(k / 3);
            put_scalar(type, (const double[]){p.x, p.y, p.z}[k % 3], t % 2);
        }
        reads(COUNT);
        for (int k = 0; k < COUNT; k++) ck_assert(equal(got[k], whole(k)));
    }
    begin();
    put_text(
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty short x\nproperty char y\nproperty int "
        "z\nend_header\n");
    put_bits((uint64_t)-300, 2, false), put_bits((uint64_t)-5, 1, false), put_bits((uint64_t)-70000, 4, false);
    reads(1);
    ck_assert(equal(got[0], (wcut_vec3){-300, -5, -70000}));
}

/* ---- text ---- */

static void put_rows(const char *separator, const char *end, bool normals, bool comma) {
    for (int k = 0; k < COUNT; k++) {
        const size_t from = size;
        const wcut_vec3 p = truth(k), n = up(k);
        put_text("%.9g%s%.9g%s%.9g", p.x, separator, p.y, separator, p.z);
        if (normals) put_text("%s%.9g%s%.9g%s%.9g", separator, n.x, separator, n.y, separator, n.z);
        put_text("%s", end);
        for (size_t i = from; comma && i < size; i++)
            if (bytes[i] == '.') bytes[i] = ',';
    }
}

TEST(text_of_every_separator) {
    const char *const separators[] = {" ", "\t", ",", ";", "  \t ", ", ", " ; "}, *const ends[] = {"\n", "\r\n", " \n"};
    for (int k = 0; k < 7 * 3 * 2; k++) {
        begin();
        put_rows(separators[k / 6], ends[k / 2 % 3], k % 2, false);
        came_back(WCUT_CLOUD_FORMAT_TEXT, -1);
        if (k % 2)
            normals_came_back(1e-12);
        else
            no_normals();
        size--; /* the last line without its feed */
        came_back(WCUT_CLOUD_FORMAT_TEXT, -1);
    }
}

TEST(decimal_commas_are_known_between_semicolons_and_blanks) {
    const char *const separators[] = {";", "\t", " "};
    for (int k = 0; k < 6; k++) {
        begin();
        put_rows(separators[k / 2], "\n", k % 2, true);
        came_back(WCUT_CLOUD_FORMAT_TEXT, -1);
    }
    given("1;2;3\n1,5;-2,5;3,5e1\n1.5;2;3\n"); /* the first row need not tell */
    reads(3);
    ck_assert(equal(got[1], (wcut_vec3){1.5, -2.5, 35}));
    given("1 2 3\n1, 2, 3\n"); /* the first row has blanks alone */
    refused(1, "line 2, column 1: found 1, 2, 3, expected a number");
    given("0,5,1,5,2,5\n1,5,1,5,2,5\n");
    refused(0, "the commas could be decimal ones");
    given("x,y,z,a,b,c\n0,5,1,5,2,5\n"); /* named: they are not */
    reads(1);
    given("1;2;3\n1.234,5;2;3\n");
    refused(1, "line 2, column 1: found 1.234,5;2;3, expected a number");
}

TEST(headers_comments_counts_and_marks_are_tolerated) {
    given("\xef\xbb\xbf# by the scanner\n\n// 2 lines\nScan of Monday\nunit,mm\n3\n1 2 3\n# between\n4 5 6\n\n7 8 9\n");
    reads(3);
    ck_assert(equal(got[2], (wcut_vec3){7, 8, 9}) && got_info.stated == 3);
    given("//X Y Z R G B\n1 2 3 0 0 1\n"); /* colours, though of length 1 */
    reads(1);
    ck_assert_int_eq(got_info.has_normals, 0);
    given("id,x_mm,y_mm,z_mm,nx,ny,nz,note\n17,1,2,3,0,3,4,\"any text\"\n");
    reads(1);
    ck_assert(equal(got[0], (wcut_vec3){1, 2, 3}) && close_to(got_normal[0], (wcut_vec3){0, 0.6, 0.8}, 1e-15));
    given("\"x\";\"y\";\"z\"\n1;2;3\n");
    reads(1);
    given("z y x\n1 2 3\n");
    reads(1);
    ck_assert(equal(got[0], (wcut_vec3){3, 2, 1}));
    given("1 2 3 40 255 0 0\n4 5 6 40 0 255 0\n"); /* x y z intensity r g b */
    reads(2);
    given("1 2 3 128 0 255\n"); /* six columns, but no normal */
    reads(1);
    ck_assert_int_eq(got_info.has_normals, 0);
    given("1 2 3 0.6 0 0.8\n4 5 6 0 0 0\n4 5 6 nan 0 1\n4 5 6 0 0 -5e200\n"); /* a normal of any length, or none */
    reads(4);
    ck_assert(got_normal[1].z == 0 && got_normal[2].z == 0 && got_normal[3].z == -1);
}

TEST(units_become_millimetres) {
    const wcut_length_unit units[] = {WCUT_LENGTH_UNIT_MM, WCUT_LENGTH_UNIT_CM, WCUT_LENGTH_UNIT_M,
                                      WCUT_LENGTH_UNIT_INCH};
    const double factor[] = {1, 10, 1000, 25.4};
    const char *const header[] = {"x_mm", "x(cm)", "x [m]", "x_inch"};
    for (int k = 0; k < 4; k++) {
        given("1 2 3\n");
        options.unit = units[k];
        reads(1);
        ck_assert(close_to(got[0], (wcut_vec3){factor[k], 2 * factor[k], 3 * factor[k]}, 1e-12));

        /* what the header states goes before the default and must agree with anything else */
        given(header[k]);
        put_text(";y;z\n1;2;3\n");
        for (int o = 0; o < 4; o++) {
            options.unit = units[o];
            if (o != k && o != 0) {
                refused(0, "line 1, column 1: found x");
                continue;
            }
            reads(1);
            ck_assert(close_to(got[0], (wcut_vec3){factor[k], 2 * factor[k], 3 * factor[k]}, 1e-12));
            ck_assert_double_eq(got_info.unit, factor[k]);
        }
    }
}

/* a header, rows of so many columns, and the column where x y z (10, 20, 30 in the file) stand */
TEST(columns_are_known_by_their_names) {
    static const struct {
        const char *header, *row;
        double millimetres;
    } good[] = {{"x_nom,y_nom,z_nom,x_meas,y_meas,z_meas", "1,2,3,10,20,30", 1},
                {"X nominal;Y nominal;Z nominal;X actual;Y actual;Z actual;Dev", "1;2;3;10;20;30;0", 1},
                {"MeasX,MeasY,MeasZ,NomX,NomY,NomZ", "10,20,30,1,2,3", 1},
                {"x_soll\ty_soll\tz_soll\tx_ist\ty_ist\tz_ist", "1\t2\t3\t10\t20\t30", 1},
                {"x_ref,y_ref,z_ref,x,y,z", "1,2,3,10,20,30", 1},
                {"X(nom),Y(nom),Z(nom),X(act),Y(act),Z(act)", "1,2,3,10,20,30", 1},
                {"x_cad,y_cad,z_cad,dx,dy,dz,x_scan,y_scan,z_scan", "1,2,3,9,9,9,10,20,30", 1},
                {"x,y,z,x_dev,y_dev,z_dev", "10,20,30,1,2,3", 1},
                {"Point ID,X,Y,Z", "17,10,20,30", 1},
                {"name;X [mm];Y [mm];Z [mm]", "P 1;10;20;30", 1},
                {"X [mm] Y [mm] Z [mm]", "10 20 30", 1},
                {"\"X\",\"Y\",\"Z\"", "\"10\",\"20\",\"30\"", 1},
                {"Points:0,Points:1,Points:2,Deviation", "10,20,30,0", 1},
                {"X-Koordinate;Y-Koordinate;Z-Koordinate", "10,0;20,0;30,0", 1},
                {"x_ft,y_ft,z_ft", "10,20,30", 304.8},
                {"x [dm],y [dm],z [dm]", "10,20,30", 100},
                {"x_um,y_um,z_um", "10,20,30", 1e-3},
                {"X (\xc2\xb5m),Y (\xc2\xb5m),Z (\xc2\xb5m)", "10,20,30", 1e-3},
                {"x (inches) y (inches) z (inches)", "10 20 30", 25.4},
                {"x_meters,y_meters,z_meters", "10,20,30", 1000},
                {"x_meas_m,y_meas_m,z_meas_m,x_nom_mm,y_nom_mm,z_nom_mm", "10,20,30,1,2,3", 1000},
                {"# units: m", "10 20 30", 1000},
                {"# Unit = inch\n//X Y Z", "10 20 30", 25.4}};
    for (size_t k = 0; k < sizeof good / sizeof *good; k++) {
        const double f = good[k].millimetres;
        given(good[k].header);
        put_text("\n%s\n", good[k].row);
        reads(1);
        ck_assert_msg(close_to(got[0], (wcut_vec3){10 * f, 20 * f, 30 * f}, 1e-9), "%s", good[k].header);
    }
}

TEST(columns_that_nobody_knows_are_asked_for) {
    static const char *const bad[] = {"easting,northing,height\n10,20,30\n",
                                      "a b c\n10 20 30\n",
                                      "Rechtswert;Hochwert;H\xc3\xb6he;x\n1;2;3;4\n",
                                      "x_nom,y_nom,z_nom\n10,20,30\n",
                                      "x,y,z,x_meas,y_meas,z_meas\n1,2,3,10,20,30\n",
                                      "x_1,y_1,z_1,x_2,y_2,z_2\n1,2,3,10,20,30\n",
                                      "x_furlong,y_furlong,z_furlong\n10,20,30\n",
                                      "x,y,z,x,y,z\n1,2,3,10,20,30\n",
                                      "x,y,height\n10,20,30\n",
                                      "x,y,z\n10,20,30,40\n",
                                      "Scan of Monday\n10 20 30\n",
                                      "0 0 5 0 0 5.1\n9 0 5 9 0 5.2\n0 9 5 0 9 5.1\n9 9 5 9 9 5.1\n4 4 5 4 4 5.2\n",
                                      "1 5 6 7\n2 6 5 7\n3 8 6 7\n4 1 2 7\n5 2 8 9\n"};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        given(bad[k]);
        refused(0, k < 9 ? "line 1, column 1: " : "line ");
        ck_assert_msg(k == 9 || strstr(error.text, "option columns"), "%s", error.text);
    }
}

TEST(an_option_says_which_columns_are_meant) {
    static const struct {
        const char *columns, *text;
    } good[] = {{"x_meas,y_meas,z_meas", "x,y,z,x_meas,y_meas,z_meas\n1,2,3,10,20,30\n"},
                {"4,5,6", "x,y,z,x_meas,y_meas,z_meas\n1,2,3,10,20,30\n"},
                {"easting, Northing ,HEIGHT", "easting,northing,height\n10,20,30\n"},
                {"3,2,1", "30 20 10\n"},
                {"2,3,4", "P1 10 20 30\nP2 10 20 30\n"},
                {"1,2,3", "Scan of Monday\n10 20 30\n"},
                {"1,2,3", "a b c d e f g h i j\n10 20 30\n"}};
    for (size_t k = 0; k < sizeof good / sizeof *good; k++) {
        given(good[k].text);
        options.columns = good[k].columns;
        reads(k == 4 ? 2 : 1);
        ck_assert_msg(equal(got[0], (wcut_vec3){10, 20, 30}), "%s", good[k].columns);
    }
    given("1 2 3 0 0 2\n");
    options.columns = "1,2,3,4,5,6";
    reads(1);
    ck_assert(got_info.has_normals && got_normal[0].z == 1);
    static const char *const bad[] = {"",      "1,2",           "1,2,7", "0,1,2", "1,2,3,4",
                                      "x,y,z", "1,2,3,4,5,6,1", "1,,3",  "1;2;3"};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        options.columns = bad[k];
        refused(0, "columns that the option columns names");
    }
}

/* LZF with two literal runs and a reference over what it writes itself */
TEST(compressed_pcd_is_read_field_by_field) {
    static const char *const head =
        "# .PCD v0.7\nVERSION 0.7\nCOLUMNS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nDATA "
        "binary_compressed\n";
    given(head);
    put_bits(23, 4, false), put_bits(24, 4, false);
    put_bits(7, 1, false), put_float(1, false), put_float(4, false); /* x: 1 and 4 */
    put_bits(3, 1, false), put_float(2, false);                      /* y: 2 */
    put_bits(2 << 5, 1, false), put_bits(3, 1, false);               /* and 2 again: four bytes from four before */
    put_bits(6, 1, false);
    put_bits(0x40400000, 4, false), put_bits(0, 3, false); /* z: 3 and seven bytes of a 0 */
    put_bits(0, 1, false), put_bits(0, 1, false);
    const size_t whole = size;
    const uint32_t packed = (uint32_t)(whole - strlen(head) - 8);
    memcpy(bytes + strlen(head), &packed, 4);
    reads(2);
    ck_assert(equal(got[0], (wcut_vec3){1, 2, 3}) && equal(got[1], (wcut_vec3){4, 2, 0}));
    put_bits(0, 8, false); /* a page that is filled up */
    reads(2);

    /* cut short, a reference before the first byte, a size that the points do not have */
    size = whole - 1;
    refused(0, "expected the compressed points");
    size = whole;
    bytes[strlen(head) + 8] = 0x20;
    refused(0, "found compressed points that do not unpack, expected LZF");
    bytes[strlen(head) + 4] = 25;
    refused(0, "expected 24 for the points stated");
}

TEST(ptx_scans_are_moved_by_their_matrices) {
    static const char *const still = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
    begin();
    put_text("2\n1\n%s1 2 3 0.5\n0 0 0 0.5\n", still);
    put_text("1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n1 2 3 0.5 9 9 9\n");
    reads(2);
    ck_assert(got_info.format == WCUT_CLOUD_FORMAT_PTX && got_info.withheld == 1 && got_info.stated == 3);
    ck_assert(equal(got[0], (wcut_vec3){1, 2, 3}));
    ck_assert(equal(got[1], (wcut_vec3){8, 21, 33})); /* a quarter turn about z, then the shift */
    begin();
    put_text("2\n1\n%s1.00000 2.00000 3.00000 0.5\n", still);
    refused(1, "expected 1 points more");
    begin();
    put_text("2\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 5\n0 0 0 1\n1 2 3 0.5\n");
    refused(0, "found a matrix that is no motion");
}

TEST(lines_may_end_with_a_return_alone_and_numbers_may_be_none) {
    given("1 2 3\r4 5 6\r\r7 8 9");
    reads(3);
    ck_assert(equal(got[2], (wcut_vec3){7, 8, 9}));
    given("1 2 3\r\n4 5 6\r\n");
    reads(2);
    given(
        "ply\rformat binary_little_endian 1.0\relement vertex 1\rproperty float x\rproperty float y\r"
        "property float z\rend_header\r");
    put_bits(0x3f80000a, 4, false); /* the first byte is a line feed, and data */
    put_float(2, false), put_float(3, false);
    reads(1);
    ck_assert(got[0].x > 1 && got[0].x < 1.01 && got[0].z == 3);
    given(
        "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
        "property float nx\nproperty float ny\nproperty float nz\nend_header\n\n"
        "1 2 3 -1.#IND00 1.#QNAN0e+000 -1.#J\n4 5 6 nan(0x8) -nan +inf\n");
    reads(2);
    ck_assert(got_normal[0].z == 0 && got_normal[1].z == 0 && got[1].z == 6);
    given("1 2 3\n1.#INF00 2 3\n-1.#IND 2 3\n1 2 1.#R\n1 nan(ind) 3\n");
    reads(1);
    ck_assert_int_eq(got_info.not_finite, 4);
    given("1 2 3\n1.#? 2 3\n");
    refused(1, "line 2, column 1: found 1.#? 2 3, expected a number");
}

TEST(off_with_colours_and_normals_is_read) {
    static const char *const good[] = {
        "COFF\n2 0 0\n1 2 3 255 0 0 255\n4 5 6 1 1 1 1\n", "NOFF\n2 0\n1 2 3 0 0 2\n4 5 6 0 0 2\n",
        "STCNOFF # all\n\n2 0 0\n1 2 3 0 0 2 1 1 1 1 0 0\n4 5 6 0 0 2 1 1 1 1 0 0\n", "2 0 0\n1 2 3\n4 5 6\n"};
    for (size_t k = 0; k < sizeof good / sizeof *good; k++) {
        given(good[k]);
        options.format = WCUT_CLOUD_FORMAT_OFF;
        reads(2);
        ck_assert(equal(got[1], (wcut_vec3){4, 5, 6}) && got_info.has_normals == (k == 1 || k == 2));
        if (got_info.has_normals) ck_assert(got_normal[1].z == 1);
    }
    given("nOFF\n4\n1 0 0\n1 2 3 4\n");
    options.format = WCUT_CLOUD_FORMAT_OFF;
    refused(0, "expected OFF, COFF, NOFF or CNOFF");
    given("OFF BINARY\n");
    options.format = WCUT_CLOUD_FORMAT_OFF;
    refused(0, "expected OFF, COFF, NOFF or CNOFF");
}

TEST(a_text_of_several_scans_is_one) {
    given("2\n1 2 3\n4 5 6\n1\n7 8 9\n");
    reads(3);
    ck_assert(got_info.stated == 3 && equal(got[2], (wcut_vec3){7, 8, 9}));
    given("2\n1 2 3\n4 5 6\n2\n7 8 9\n");
    refused(3, "expected 1 points more");
    given("1\n1 2 3\n4 5 6\n");
    refused(1, "line 3, column 1: found 4 5 6, expected the end");
}

TEST(a_locale_with_decimal_commas_changes_nothing) {
    ck_assert_ptr_nonnull(setlocale(LC_ALL, "de_DE.UTF-8"));
    given("1.5 2.25 3.125\n");
    reads(1);
    ck_assert(equal(got[0], (wcut_vec3){1.5, 2.25, 3.125}));
    given("1.5 2.25 1e20\n");
    refused(0, "1e+20 mm");
    setlocale(LC_ALL, "C");
}

/* ---- the others ---- */

TEST(stl_gives_the_corners_of_its_triangles) {
    for (int named = 0; named < 2; named++) {
        begin();
        put_text("%s", named ? "solid but binary all the same" : "STLB");
        while (size < 80) put_bits(0, 1, false);
        put_bits(COUNT / 3, 4, false);
        for (int k = 0; k < COUNT; k++) {
            for (int c = 0; k % 3 == 0 && c < 3; c++) put_float(7, false);
            const wcut_vec3 p = truth(k);
            put_float(p.x, false), put_float(p.y, false), put_float(p.z, false);
            if (k % 3 == 2) put_bits(0xffff, 2, false);
        }
        options.format = WCUT_CLOUD_FORMAT_STL;
        came_back(WCUT_CLOUD_FORMAT_STL, COUNT);
        no_normals();
    }
    begin();
    for (int k = 0; k < COUNT; k++) {
        const wcut_vec3 p = truth(k);
        if (k % 150 == 0) put_text("solid part %d of two\n", k);
        if (k % 3 == 0) put_text("  facet normal 0 0 1e0\r\n\touter loop\n");
        put_text("VERTEX %.9g %.9g %.9g\n", p.x, p.y, p.z);
        if (k % 3 == 2) put_text("endloop\n endfacet\n");
        if (k % 150 == 149) put_text("endsolid part\n\n");
    }
    came_back(WCUT_CLOUD_FORMAT_STL, -1);
}

TEST(obj_and_off_give_their_vertices) {
    begin();
    put_text("# a sheet\nmtllib sheet.mtl\no sheet\n\n");
    for (int k = 0; k < COUNT; k++) {
        const wcut_vec3 p = truth(k);
        static const char *const rest[] = {"", " 1", " 0.5 0.25 1", "\r"};
        put_text("%sv %.9g %.9g %.9g%s\n", k % 5 ? "" : " ", p.x, p.y, p.z, rest[k % 4]);
        if (k % 3 == 2) put_text("vn 0 0 1\nvt 0 1\nf %d/1/1 -2 %d\n", k - 1, k + 1);
    }
    options.format = WCUT_CLOUD_FORMAT_OBJ;
    came_back(WCUT_CLOUD_FORMAT_OBJ, -1);
    no_normals();
    for (int apart = 0; apart < 2; apart++) {
        begin();
        put_text("# a sheet\nOFF%s%d 1 0 # counts\n\n", apart ? " # one\n" : " ", COUNT);
        for (int k = 0; k < COUNT; k++) {
            const wcut_vec3 p = truth(k);
            put_text("%.9g %.9g %.9g%s\n", p.x, p.y, p.z, k % 2 ? "" : " 255 0 0");
        }
        put_text("3 0 1 2\n");
        options.format = WCUT_CLOUD_FORMAT_OFF;
        came_back(WCUT_CLOUD_FORMAT_OFF, COUNT);
    }
}

/* two nodes with one mesh of three points each, the second shifted by (10, 20, 30) m */
static const char gltf[] =
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0,1]}],"
    "\"nodes\":[{\"mesh\":0},{\"mesh\":0,\"translation\":[10,20,30]}],"
    "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"mode\":%d}]}],"
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
    "\"min\":[0,0,0],\"max\":[1,2,0]}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
    "\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAAEAAAAAA\"}]}";

TEST(gltf_gives_the_vertices_of_every_node_in_mm_with_z_upwards) {
    for (int mode = 0; mode <= 4; mode += 4) { /* points, triangles */
        begin();
        put_text(gltf, mode);
        options.format = WCUT_CLOUD_FORMAT_GLTF;
        reads(6);
        ck_assert(got_info.format == WCUT_CLOUD_FORMAT_GLTF && got_info.stated == 6);
        no_normals();
        ck_assert(equal(got_info.low, (wcut_vec3){0, -30000, 0}) && equal(got_info.high, (wcut_vec3){11000, 0, 22000}));
    }
}

TEST(las_of_every_version_and_point_format) {
    const int min[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    for (int minor = 2; minor <= 4; minor++) {
        for (int format = 0; format <= (minor < 4 ? 5 : 10); format++) {
            const int length = min[format] + format % 3;
            begin();
            put_las_header(minor, format, length, COUNT + 1, 0.0625, -512);
            for (int k = 0; k <= COUNT; k++) {
                const wcut_vec3 p = truth(k < 10 ? k : k - 1);
                const double v[3] = {(p.x + 512) * 16, (p.y + 1024) * 16, (p.z + 1536) * 16};
                for (int c = 0; c < 3; c++) put_bits((uint64_t)(int64_t)v[c], 4, false);
                for (int c = 12; c < length; c++) put_bits(0, 1, false);
                /* the eleventh is withheld */
                if (k == 10) bytes[size - (size_t)length + 15] = format <= 5 ? 0x80 : 0x04;
            }
            put_text("records behind the points");
            came_back(WCUT_CLOUD_FORMAT_LAS, COUNT + 1);
            ck_assert_int_eq(got_info.withheld, 1);
        }
    }
}

TEST(pcd_ascii_and_binary_with_fields_of_any_type) {
    for (int binary = 0; binary < 2; binary++) {
        begin();
        put_text("# .PCD v.7 - Point Cloud Data\nVERSION .7\nFIELDS rgb x curve normal_x y z normal_z normal_y id\n");
        put_text("SIZE 4 4 2 4 8 4 4 8 8\nTYPE U F I F F F F F U\nCOUNT 1 1 3 1 1 1 1 1 1\nWIDTH %d\nHEIGHT 3\n",
                 COUNT / 3);
        put_text("VIEWPOINT 0 0 0 1 0 0 0\nPOINTS %d\nDATA %s\n", COUNT, binary ? "binary" : "ascii");
        for (int k = 0; k < COUNT; k++) {
            const wcut_vec3 p = truth(k), n = up(k);
            if (!binary) {
                put_text("4.2108e+06 %.9g 1 2 3 %.9g %.9g %.9g %.9g %.9g 77\n", p.x, n.x, p.y, p.z, n.z, n.y);
                continue;
            }
            put_bits(0xffffff, 4, false), put_float(p.x, false);
            for (int c = 0; c < 3; c++) put_bits(9, 2, false);
            put_float(n.x, false), put_double(p.y, false), put_float(p.z, false), put_float(n.z, false);
            put_double(n.y, false), put_bits(77, 8, false);
        }
        came_back(WCUT_CLOUD_FORMAT_PCD, COUNT);
        normals_came_back(1e-7);
    }
    begin();
    put_text("VERSION 0.7\nFIELDS x y z\nSIZE 8 1 2\nTYPE I U I\nWIDTH 2\nDATA binary\n");
    put_bits((uint64_t)-5000000000, 8, false), put_bits(250, 1, false), put_bits((uint64_t)-300, 2, false);
    put_bits(1, 8, false), put_bits(2, 1, false), put_bits(3, 2, false);
    reads(2);
    ck_assert(equal(got[0], (wcut_vec3){-5e9, 250, -300}) && equal(got[1], (wcut_vec3){1, 2, 3}));
}

TEST(points_that_are_not_finite_are_left_out_and_counted) {
    given("1 2 3\nnan 2 3\n4 -inf 6\n4 5 Infinity\n1.#QNAN 0 0\n-nan(ind) 0 0\n7 8 9\n");
    reads(2);
    ck_assert(got_info.not_finite == 5 && equal(got[1], (wcut_vec3){7, 8, 9}));
    begin();
    put_text(
        "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n");
    for (int k = 0; k < 9; k++) put_float(k == 4 ? (double)NAN : k == 8 ? -(double)INFINITY : k, true);
    reads(1);
    ck_assert_int_eq(got_info.not_finite, 2);
}

/* ---- whole files ---- */

static char path[64];

static void on_disk(const char *ending) {
    snprintf(path, sizeof path, "/tmp/wirecut-test-%ld%s", (long)getpid(), ending);
    FILE *file = fopen(path, "wb");
    ck_assert_ptr_nonnull(file);
    ck_assert(fwrite(bytes, 1, size, file) == size && fclose(file) == 0);
}

TEST(a_whole_cloud_is_in_memory_thinned_where_asked) {
    wcut_cloud *cloud = NULL;
    begin();
    put_ply("binary_little_endian", "float", false, true);
    on_disk(".ply");
    ck_assert_int_eq(wcut_cloud_read(path, NULL, &cloud, &error), WCUT_OK);
    ck_assert(cloud->count == COUNT && cloud->info.read == COUNT && cloud->info.thinned == 0);
    for (int k = 0; k < COUNT; k++)
        ck_assert(equal(cloud->point[k], truth(k)) && close_to(cloud->normal[k], up(k), 1e-7));
    wcut_cloud_destroy(cloud);
    options.voxel = 1e6;
    options.max_points = 5;
    ck_assert_int_eq(wcut_cloud_read(path, &options, &cloud, &error), WCUT_OK);
    ck_assert(cloud->count == 4 && cloud->info.thinned == COUNT - 4); /* about the origin: x and z of either sign */
    ck_assert(equal(cloud->point[0], truth(0)) && close_to(cloud->normal[0], up(0), 1e-7));
    wcut_cloud_destroy(cloud);
    unlink(path);
    wcut_cloud_destroy(NULL);
    /* an STL is known by its name where its first bytes say nothing */
    begin();
    while (size < 80) put_bits('x', 1, false);
    put_bits(0, 4, false);
    on_disk(".STL");
    cloud = (void *)path;
    ck_assert_int_eq(wcut_cloud_read(path, NULL, &cloud, &error), WCUT_BAD_FORMAT);
    ck_assert(strstr(error.text, "found no point, expected at least one") && cloud == (void *)path);
    unlink(path);
}

TEST(more_points_than_allowed_are_refused) {
    wcut_cloud *cloud = (void *)path;
    begin();
    put_rows(" ", "\n", false, false);
    on_disk(".xyz");
    options.max_points = COUNT - 1;
    ck_assert_int_eq(wcut_cloud_read(path, &options, &cloud, &error), WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "found more than 299 points, expected at most that"));
    ck_assert_ptr_eq(cloud, (void *)path);
    options.max_points = COUNT;
    ck_assert_int_eq(wcut_cloud_read(path, &options, &cloud, &error), WCUT_OK);
    ck_assert(cloud->count == COUNT && cloud->normal == NULL);
    wcut_cloud_destroy(cloud);
    unlink(path);
}

TEST(a_pipe_is_read_like_a_file) {
    begin();
    put_ply("binary_little_endian", "double", true, false);
    int ends[2];
    ck_assert_int_eq(pipe(ends), 0);
    ck_assert(write(ends[1], bytes, size) == (ssize_t)size && close(ends[1]) == 0);
    snprintf(path, sizeof path, "/dev/fd/%d", ends[0]);
    wcut_cloud *cloud = NULL;
    ck_assert_int_eq(wcut_cloud_read(path, NULL, &cloud, &error), WCUT_OK);
    ck_assert_int_eq(cloud->count, COUNT);
    wcut_cloud_destroy(cloud);
    close(ends[0]);
}

TEST(what_cannot_be_read_is_not_found) {
    wcut_cloud_source *source = (void *)path;
    wcut_cloud *cloud = (void *)path;
    ck_assert_int_eq(wcut_cloud_source_create("/no/such/file", NULL, &source, &error), WCUT_NOT_FOUND);
    ck_assert_ptr_nonnull(strstr(error.text, "/no/such/file: cannot be read"));
    ck_assert_int_eq(wcut_cloud_read("/", NULL, &cloud, &error), WCUT_NOT_FOUND); /* a folder */
    ck_assert_ptr_nonnull(strstr(error.text, "cannot be read"));
    ck_assert(source == (void *)path && cloud == (void *)path);
}

TEST(arguments_outside_their_range_are_refused) {
    wcut_cloud_source *source = (void *)path, *good = NULL;
    wcut_cloud *cloud = (void *)path;
    wcut_vec3 p;
    int count = 999;
    begin();
    put_rows(" ", "\n", false, false);
    on_disk(".xyz");
    wcut_cloud_options bad[6];
    for (int k = 0; k < 6; k++) bad[k] = wcut_cloud_options_default();
    bad[0].format = WCUT_CLOUD_FORMAT_COUNT, bad[1].unit = WCUT_LENGTH_UNIT_COUNT;
    bad[2].max_points = 0, bad[3].voxel = -1, bad[4].voxel = NAN, bad[5].voxel = INFINITY;
    for (int k = 0; k < 6; k++) {
        if (k < 2) ck_assert_int_eq(wcut_cloud_source_create(path, &bad[k], &source, NULL), WCUT_BAD_ARGUMENT);
        ck_assert_int_eq(wcut_cloud_read(path, &bad[k], &cloud, NULL), WCUT_BAD_ARGUMENT);
    }
    ck_assert_int_eq(wcut_cloud_source_create(NULL, NULL, &source, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_source_create(path, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_read(NULL, NULL, &cloud, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_read(path, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_source_create(path, NULL, &good, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_cloud_source_next(NULL, 1, &p, NULL, &count, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_source_next(good, 0, &p, NULL, &count, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_source_next(good, 1, NULL, NULL, &count, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_source_next(good, 1, &p, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert(source == (void *)path && cloud == (void *)path && count == 999);
    ck_assert_ptr_null(wcut_cloud_source_info(NULL));
    wcut_cloud_source_destroy(good);
    wcut_cloud_source_destroy(NULL);
    unlink(path);
}

TEST(without_memory_nothing_is_written) {
    const char *const names[] = {"ascii", "binary_little_endian"};
    for (int t = 0; t < 2; t++) {
        begin();
        put_ply(names[t], "float", false, true);
        on_disk(".ply");
        options.voxel = 1;
        wcut_cloud *cloud = (void *)path;
        error.text[0] = '\0';
        EACH_FAILED_ALLOCATION(wcut_cloud_read(path, &options, &cloud, &error),
                               cloud == (void *)path && strstr(error.text, "out of memory"));
        wcut_cloud_destroy(cloud);
        unlink(path);
    }
}
