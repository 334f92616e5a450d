/* Clouds that lie, end early or are none: each is refused with its own words, after the points that stand before. */
#include <wirecut/cloud_file.h>
#include "io/scan/cloud_given.h"
#include "test.h"

/* ---- text ---- */

TEST(text_that_is_no_cloud_is_refused_with_its_line) {
    given("");
    refused(0, "byte 0: found the end of the file, expected points");
    given("\n\n  \n");
    refused(0, "line 4: found the end of the file, expected a row with the numbers x y z");
    given("# nothing\n");
    refused(0, "expected a row with the numbers x y z");
    given("a\nb\nc\nd\ne\nf\ng\nh\ni\nj\nk\n1 2 3\n");
    refused(0, "line 11, column 1: found k, expected a row that begins with numbers");
    given("1 2\n3 4\n");
    refused(0, "line 1, column 1: found 1 2, expected at least three numbers");
    given("1 2 3\n4 5\n");
    refused(1, "line 2, column 4: found the end of the line, expected as many columns as the first row has");
    given("1,2,3,9\n4,5,6\n");
    refused(1, "line 2, column 6: found the end of the line, expected as many columns as the first row has");
    given("1 2 3\n4 5 6 7\n");
    refused(1, "line 2, column 7: found 7, expected the end of the line, as in the first row");
    given("1 2 3\n4 5 6\n7 8O 9\n");
    refused(2, "line 3, column 3: found 8O 9, expected a number");
    given("1 2 3\n4 5 0x10\n");
    refused(1, "line 2, column 5: found 0x10, expected a number");
    given("1,2,3\n4,,6\n");
    refused(1, "line 2, column 3: found ,6, expected a number");
    given("1,2,3\n4 5,6,7\n");
    refused(1, "line 2, column 3: found 5,6,7, expected the next column");
    given("1 2 3\n4 5 1e999\n");
    refused(1, "line 2, column 5: found 1e999, expected a number");
    given("1 2 3\n4 5 6\nend of scan\n");
    refused(2, "line 3, column 1: found end of scan, expected a number");
    given("id,x,y,z\n1,2,3,4,5\n");
    refused(0, "line 1, column 1: found id,x,y,z, expected as many names as the rows have columns");
}

TEST(zero_bytes_other_alphabets_and_endless_lines_are_refused) {
    begin();
    put("1 2 3\n4 5\0 6\n", 13);
    refused(1, "line 2, column 4: found a zero byte");
    begin();
    put("1 2 3\n\0\n", 8);
    refused(1, "found a zero byte");
    begin();
    put("\0\0\0\0\0\n", 6);
    refused(0, "found binary data of no known kind");
    begin();
    put("\xff\xfe"
        "1\0 \0",
        6);
    refused(0, "found UTF-16 text, expected PLY, XYZ/PTS/PTX/CSV text, STL, OBJ, OFF, glTF, LAS or PCD");
    begin();
    for (int k = 0; k < 50000; k++) put("1 ", 2);
    refused(0, "without a line feed");
    given("1 2 3\x01\n");
    refused(0, "found 3\\x01");
    begin();
    put("2\r\n1 \0 2 3\r\n4 5 6\r\n", 19);
    refused(0, "expected");
    given("2\r\n1\n1 5 6 41 1 ");
    refused(0, "expected the end of the line");
}

TEST(formats_that_are_not_read_are_named) {
    given("ASTM-E57\1");
    refused(0, "found a cloud in E57, which would need the library libE57Format (not in Debian 12), expected PLY");
    given("PK\003\004");
    refused(0, "found a ZIP archive");
    given("\037\213");
    refused(0, "found a gzip archive");
}

TEST(a_count_that_lies_is_refused) {
    given("3\n1 2 3\n4 5 6\n");
    refused(2, "found the end of the file, expected 1 points more");
    given("1\n1 2 3\n4 5 6\n");
    refused(1, "line 3, column 1: found 4 5 6, expected the end: the file states no more points");
    given("2147483648\n1 2 3\n");
    refused(0, "line 1: found a count of 2147483648 points, expected 0 to 2147483647");
    given("99999999999999999999\n1 2 3\n"); /* no count of anything: a row too short */
    refused(0, "at least three numbers");
}

TEST(coordinates_beyond_any_scan_are_refused) {
    given("1 2 3\n1 2 -1.1e12\n");
    refused(1, "line 2: found z = -1.1e+12 mm, expected at most 1e12: a wrong byte order or unit?");
    given("1 2e9 3\n");
    options.unit = WCUT_LENGTH_UNIT_M;
    refused(0, "found y = 2e+12 mm");
    given("1e300 0 0\n");
    options.unit = WCUT_LENGTH_UNIT_M;
    refused(0, "found x = 1e+303 mm");
}

/* ---- PLY ---- */

static const char ply_head[] =
    "ply\nformat %s 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\n%send_header\n";

static void given_ply(const char *format, const char *count, const char *more) {
    begin();
    put_text(ply_head, format, count, more);
}

static void ply_refused(const char *header, const char *words) {
    given(header);
    refused(0, words);
}

TEST(a_ply_header_is_read_to_the_letter) {
    ply_refused("ply\n", "line 2: found the end of the file, expected end_header");
    ply_refused("ply\nend_header\n", "line 2, column 1: found end_header, expected a format before it");
    ply_refused("ply\nformat binary 1.0\n", "line 2, column 8: found binary 1.0, expected ascii, binary_little");
    ply_refused("ply\nformat ascii 2.0\n", "line 2, column 14: found 2.0, expected 1.0");
    ply_refused("ply\nformat ascii 1.0\nformat ascii 1.0\n", "expected one format");
    ply_refused("ply\nformat ascii 1.0\nend_header\n", "found no element vertex, expected one");
    ply_refused("ply\nformat ascii 1.0\nvertices 3\n", "line 3, column 1: found vertices 3, expected a word");
    ply_refused("ply\nformat ascii 1.0\nproperty float x\n", "expected an element before its properties");
    ply_refused("ply\nformat ascii 1.0\nelement vertex -1\n",
                "found -1, expected a count, an integer that is not negative");
    ply_refused("ply\nformat ascii 1.0\nelement vertex 1.5\n", "found 1.5, expected a count");
    ply_refused("ply\nformat ascii 1.0\nelement vertex\n", "found the end of the line, expected a count");
    ply_refused("ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n", "expected a count");
    ply_refused("ply\nformat ascii 1.0\nelement vertex 1\nelement vertex 1\n", "expected one element vertex");
    ply_refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty real x\n", "found real x, expected a type");
    ply_refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float\n", "expected the property's name");
    ply_refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty list int float x\n",
                "expected a coordinate that is no list");
    ply_refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float float w\n", "expected an integer type");
    ply_refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float x\n",
                "expected each coordinate once");
    ply_refused("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float z\nend_header\n1 2\n",
                "found no property y of the element vertex");
    given_ply("ascii", "2147483648", "");
    refused(0, "found a count of 2147483648 vertices, expected 0 to 2147483647");
    begin();
    put_text("ply\nformat ascii 1.0\n");
    for (int k = 0; k < 65; k++) put_text("element a%d 0\n", k);
    refused(0, "at most 64 elements");
    begin();
    put_text("ply\nformat ascii 1.0\nelement vertex 1\n");
    for (int k = 0; k < 257; k++) put_text("property int a%d\n", k);
    refused(0, "at most 256 properties");
}

TEST(a_ply_that_claims_more_than_it_holds_is_refused_at_once) {
    given_ply("binary_little_endian", "900000000", ""); /* 10 GB in 1 KB */
    for (int k = 0; k < 900; k++) put_bits(0, 1, false);
    refused(0, "a count of 900000000 vertices in the header and 900 bytes of data, expected at least 12 bytes each");
    given_ply("ascii", "2147483647", "");
    put_text("1 2 3\n");
    refused(0, "a count of 2147483647 vertices in the header and 6 bytes of data");
    given(
        "ply\nformat binary_little_endian 1.0\nelement junk 9000000000000000000\nproperty double a\nelement vertex 0\n"
        "property int x\nproperty int y\nproperty int z\nend_header\n1234");
    refused(0, "found the end of the file, expected the elements that are stated");
    given(
        "ply\nformat ascii 1.0\nelement junk 9000000000000000000\nproperty double a\nelement vertex 0\n"
        "property int x\nproperty int y\nproperty int z\nend_header\n1\n2\n");
    refused(0, "line 12: found the end of the file, expected as many lines as elements are stated");
}

TEST(a_ply_that_ends_early_or_goes_on_is_refused) {
    given_ply("binary_little_endian", "3", "");
    for (int k = 0; k < 9; k++) put_float(k, false);
    size -= 1;
    refused(0, "a count of 3 vertices in the header and 35 bytes of data");

    /* less than a record, and padding, is nothing that was lost */
    size += 1;
    put_text("\n");
    reads(3);
    for (int k = 0; k < 3000; k++) put_bits(0, 1, false);
    reads(3);
    put_text("more than a record");
    refused(3, "found more data after the last element");
    given_ply("binary_big_endian", "2", "property list uchar int w\n");
    for (int k = 0; k < 2; k++) {
        for (int c = 0; c < 3; c++) put_float(c, true);
        put_bits(2, 1, true), put_bits(1, 4, true), put_bits(1, 4, true);
    }
    reads(2);
    size -= 1;
    refused(1, "found the end of the file, expected a list's values");
    size -= 8;
    refused(1, "found the end of the file, expected a list's count");
    size -= 2;
    refused(1, "found the end of the file, expected the elements that are stated");
    given_ply("ascii", "2", "");
    put_text("1 2 3\n4 5 6\n7 8 9\n");
    refused(2, "found more data after the last element");
    given_ply("ascii", "2", "");
    put_text("1 2 3\n4 5\n");
    refused(1, "line 9, column 4: found the end of the line, expected a number");
    given_ply("ascii", "1", "element face 2\nproperty list uchar int i\n");
    put_text("1 2 3\n3 0 0 0\n");
    refused(1, "expected as many lines as elements are stated");
}

TEST(lists_of_negative_or_immense_length_are_refused) {
    given_ply("binary_little_endian", "1", "property list char int w\n");
    for (int c = 0; c < 3; c++) put_float(c, false);
    put_bits(0xff, 1, false);
    put_bits(0, 8, false);
    refused(0, "found a list of -1 values, expected 0 or more");
    given_ply("binary_little_endian", "1", "property list uint double w\n");
    for (int c = 0; c < 3; c++) put_float(c, false);
    put_bits(0xffffffff, 4, false);
    refused(0, "expected a list's values");
    given_ply("ascii", "1", "property list uint double w\n");
    put_text("1 2 3 -1\n");
    refused(0, "line 9, column 7: found -1, expected a list's count, 0 or more");
    given_ply("ascii", "1", "property list uint double w\n");
    put_text("1 2 3 4000000000 1 2\n");
    refused(0, "column 21: found the end of the line, expected a number");
}

TEST(the_wrong_byte_order_is_noticed) {
    /* round numbers become tiny ones, others huge or not finite */
    given_ply("binary_little_endian", "3", "");
    for (int k = 0; k < 9; k++) put_float(100 + k, true);
    refused(3, "found 9 of 9 coordinates below 1e-30 mm, expected lengths: a wrong byte order?");
    given_ply("binary_big_endian", "2000", "");
    for (int k = 0; k < 6000; k++) put_float(k % 1000, false);
    for (int piece = 1; piece <= 1000; piece *= 10) {
        ck_assert_int_eq(read_through(4096, piece), WCUT_BAD_FORMAT);
        ck_assert(got_count <= 1000 && strstr(error.text, "a wrong byte order?"));
    }
    given_ply("binary_little_endian", "100", "");
    for (int k = 0; k < 300; k++) put_float(sqrt(3 + k), true);
    ck_assert_int_eq(read_through(4096, 100), WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "expected at most 1e12: a wrong byte order or unit?"));
    given_ply("binary_little_endian", "2", ""); /* zeros and a few tiny ones are a scan all the same */
    for (int k = 0; k < 6; k++) put_float(k < 2 ? 1e-40 : k, false);
    reads(2);
}

/* ---- the others ---- */

static void given_stl(unsigned triangles, size_t length) {
    begin();
    put_text("%-80s", "binary");
    put_bits(triangles, 4, false);
    while (size < length) put_bits(0, 1, false);
    options.format = WCUT_CLOUD_FORMAT_STL;
}

TEST(stl_that_lies_is_refused) {
    given_stl(2, 84 + 99);
    refused(0, "a count of 2 triangles in the header and 99 bytes of data, expected at least 50 bytes each");
    given_stl(2, 84 + 101);
    reads(6);
    put_text("%-60s", "a facet that the count does not know");
    refused(6, "byte 185: found more data after the last element");
    given_stl(0, 84 + 100); /* a program that wrote as it went */
    reads(6);
    given_stl(0xffffffff, 84 + 100);
    reads(6);
    given_stl(0xffffffff, 1000);
    refused(0, "found a count of 4294967295 triangles, expected 0 to 2147483647");
    given_stl(0, 84);
    size = 50;
    refused(0, "expected solid, or the 84 bytes of a binary STL header");
    given("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nvertex 1 2\n");
    refused(1, "line 5, column 11: found the end of the line, expected a number");
    given("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nendloop\n");
    refused(1, "line 5, column 1: found endloop, expected vertex");
    given("solid a\nfacet 0 0 1\n");
    refused(0, "line 2, column 1: found facet 0 0 1, expected endsolid or facet normal");
    given("solid a\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3 4\n");
    refused(0, "line 4, column 14: found 4, expected the end of the line");
    given("solid a\nfacet normal 0 0 1\n");
    refused(0, "line 3: found the end of the file, expected endsolid");
    given("solid a\nfacet normal 0 0 1\nloop\n");
    refused(0, "found loop, expected outer loop");
    given("solid a\nendsolid\nanything\n");
    refused(0, "found anything, expected solid");
}

static void given_las(int minor, int format, int length, uint64_t count, double scale) {
    begin();
    put_las_header(minor, format, length, count, scale, 0);
    for (int k = 0; k < 5 * length; k++) put_bits(0, 1, false);
}

TEST(las_that_lies_is_refused) {
    given_las(2, 0, 20, 5, 0.001);
    reads(5);
    given_las(1, 0, 20, 5, 0.001);
    reads(5);
    given_las(0, 0, 20, 5, 0.001);
    reads(5);
    given_las(5, 0, 20, 5, 0.001);
    refused(0, "found LAS 1.5, expected 1.0 to 1.4");
    given_las(2, 0x80, 20, 5, 0.001);
    refused(0, "found compressed points (LAZ), which would need the library LASzip (not in Debian 12), expected LAS");
    given_las(4, 0x40 | 6, 30, 5, 0.001);
    refused(0, "found compressed points (LAZ)");
    given_las(4, 11, 30, 5, 0.001);
    refused(0, "found point format 11, expected 0 to 10");
    given_las(4, 6, 29, 5, 0.001);
    refused(0, "found records of 29 bytes, expected at least 30 for point format 6");
    given_las(2, 0, 20, 6, 0.001);
    refused(0, "a count of 6 points in the header and 100 bytes of data, expected at least 20 bytes each");
    given_las(4, 6, 30, 1u << 31, 0.001);
    refused(0, "found a count of 2147483648 points");
    given_las(4, 6, 30, UINT64_MAX, 0.001);
    refused(0, "found a count of 9223372036854775807 points");
    given_las(2, 0, 20, 5, 0);
    refused(0, "found scale 0 and offset 0 of x, expected finite ones, the scale not 0");
    given_las(2, 0, 20, 5, NAN);
    refused(0, "expected finite ones");
    given_las(2, 0, 20, 5, 1e300);
    reads(5); /* 0 x 1e300 */
    bytes[size - 1 - 12] = 0x40;
    given_las(2, 0, 20, 5, 0.001);
    bytes[94] = 100;
    refused(0, "found a header of 100 bytes, expected at least 227");
    given_las(2, 0, 20, 5, 0.001);
    bytes[96] = 10, bytes[97] = 0;
    refused(0, "found the points at byte 10, expected them after the header");
    given_las(2, 0, 20, 5, 0.001);
    bytes[98] = 10;
    refused(0, "expected the points that the header places there");
    given("LASF");
    refused(0, "expected the header of a LAS file");
    given_las(2, 0, 20, 5, 0.001);
    bytes[0] = 'l';
    options.format = WCUT_CLOUD_FORMAT_LAS;
    refused(0, "found no LASF, expected a LAS file");
}

static void pcd_refused(int count, const char *text, const char *words) {
    begin();
    put_text("# .PCD\n%s", text);
    refused(count, words);
}

#define XYZ "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n"

TEST(pcd_that_lies_is_refused) {
    pcd_refused(0, "", "expected DATA");
    pcd_refused(0, XYZ "WIDTH 1\nDATA binary_compressed\n",
                "found the end of the file, expected the sizes of compressed points");
    pcd_refused(0, XYZ "WIDTH 1\nDATA\n", "found the end of the line, expected ascii, binary or binary_compressed");
    pcd_refused(0, XYZ "DATA ascii\n", "found DATA, expected WIDTH before it");
    pcd_refused(0, "SIZE 4\n", "found SIZE 4, expected FIELDS before it");
    pcd_refused(0, XYZ "SIZE 4 4 4\n", "expected each keyword once");
    pcd_refused(0, "COLOUR red\n", "found COLOUR red, expected a keyword of a PCD header");
    pcd_refused(0, "FIELDS x y z x\n", "expected each field once");
    pcd_refused(0, "FIELDS x y z\nSIZE 4 4\n", "expected a positive integer for each of the FIELDS");
    pcd_refused(0, "FIELDS x y z\nSIZE 4 4 4 4\n", "expected as many as there are FIELDS");
    pcd_refused(0, "FIELDS x y z\nSIZE 4 4 9\n", "found 9, expected a positive integer");
    pcd_refused(0, "FIELDS x y z\nSIZE 4 4 4\nTYPE F F D\n", "found D, expected I, U or F");
    pcd_refused(0, "FIELDS x y z\nSIZE 4 4 2\nTYPE F F F\nWIDTH 1\nDATA ascii\n", "found a field of type F and size 2");
    pcd_refused(0, XYZ "COUNT 1 1 2\nWIDTH 1\nDATA ascii\n", "found a coordinate of COUNT 2, expected 1");
    pcd_refused(0, "FIELDS x y\nSIZE 4 4\nTYPE F F\nWIDTH 1\nDATA ascii\n", "expected the FIELDS x y z before it");
    pcd_refused(0, XYZ "WIDTH -1\n", "found -1, expected a count, an integer that is not negative");
    pcd_refused(0, XYZ "WIDTH 2\nHEIGHT 2\nPOINTS 5\nDATA ascii\n", "found POINTS 5, expected WIDTH x HEIGHT, 2 x 2");
    pcd_refused(0, XYZ "WIDTH 4000000000\nHEIGHT 4000000000\nDATA ascii\n",
                "found a count of 9223372036854775807 points");
    pcd_refused(0, XYZ "WIDTH 2000000000\nDATA binary\n123",
                "a count of 2000000000 points in the header and 3 bytes of data");
    pcd_refused(1, XYZ "WIDTH 2\nDATA ascii\n1 2 3\n4 5 x\n", "line 8, column 5: found x, expected a number");
    pcd_refused(2, XYZ "WIDTH 2\nDATA ascii\n1 2 3\n4 5 6\n7", "found more data after the last element");
    pcd_refused(1, XYZ "WIDTH 2\nDATA ascii\n1 2 33333\n\n",
                "line 8, column 1: found the end of the line, expected a number");
    given("# .PCD\n" XYZ "WIDTH 1\nDATA binary\n");
    put_bits(0, 8, false), put_bits(0, 5, false);
    reads(1);
    put_text("a thirteenth byte");
    refused(1, "found more data after the last element");
    pcd_refused(0, "FIELDS x y z a\nSIZE 4 4 4 8\nTYPE F F F F\nCOUNT 1 1 1 4096\nWIDTH 0\nDATA binary\n",
                "found records of 32780 bytes, expected at most 4096");
}

static void mesh_refused(wcut_cloud_format format, int count, const char *text, const char *words) {
    given(text);
    options.format = format;
    refused(count, words);
}

TEST(meshes_that_lie_are_refused) {
    const wcut_cloud_format obj = WCUT_CLOUD_FORMAT_OBJ, off = WCUT_CLOUD_FORMAT_OFF, gltf = WCUT_CLOUD_FORMAT_GLTF;
    mesh_refused(obj, 1, "v 1 2 3\nv 1 2\n", "line 2, column 6: found the end of the line, expected 3 coordinates");
    mesh_refused(obj, 0, "v 1 2 x\n", "line 1, column 7: found x, expected a number");
    mesh_refused(obj, 0, "v 1 2 3 0.5\n", "expected a vertex of weight 1");
    mesh_refused(obj, 1, "v 1 2 3\ncurv 0 1 1 2\n", "line 2, column 1: found curv 0 1 1 2, expected a polygon mesh");
    mesh_refused(obj, 0, "1 2 3\n", "line 1, column 1: found 1 2 3, expected a polygon mesh");
    begin();
    put("v 1 2 3\nv 4\0 5\n", 15);
    options.format = obj;
    refused(1, "line 2, column 4: found a zero byte");
    mesh_refused(off, 0, "x 2 3\n", "line 1, column 1: found x 2 3, expected OFF");
    mesh_refused(off, 0, "OFF\n", "line 2: found the end of the file, expected the counts");
    mesh_refused(off, 0, "OFF\n3 1 x\n", "line 2, column 5: found x, expected the counts");
    mesh_refused(off, 0, "OFF\n-3 1 0\n", "found -3 1 0, expected the counts");
    mesh_refused(off, 0, "OFF\n2147483648 1 0\n1 2 3\n", "found a count of 2147483648 vertices");
    mesh_refused(off, 0, "OFF\n2000000000 1 0\n1 2 3\n",
                 "a count of 2000000000 vertices in the header and 6 bytes of data");
    mesh_refused(off, 1, "OFF\n2 0 0\n1.2345678 2 3\n", "found the end of the file, expected 1 vertices more");
    mesh_refused(off, 1, "OFF\n2 0 0\n1 2 3\n4 5 six\n", "line 4, column 5: found six, expected a number");
    mesh_refused(gltf, 0, "{\"asset\":", "assimp reads no mesh in it, expected a sound gltf file");
    mesh_refused(gltf, 0, "glTF\2\1", "assimp reads no mesh in it, expected a sound glb file");
    mesh_refused(gltf, 0, "", "found the end of the file, expected points");
}

TEST(a_format_that_is_asked_for_is_not_guessed) {
    given("1 2 3\n");
    options.format = WCUT_CLOUD_FORMAT_PLY;
    refused(0, "line 1, column 1: found 1 2 3, expected a word of a PLY header");
    options.format = WCUT_CLOUD_FORMAT_PCD;
    refused(0, "expected a keyword of a PCD header");
    options.format = WCUT_CLOUD_FORMAT_LAS;
    refused(0, "expected the header of a LAS file");
    options.format = WCUT_CLOUD_FORMAT_STL;
    refused(0, "expected solid, or the 84 bytes of a binary STL header");
}

TEST(every_truncation_of_a_good_file_is_refused_or_shorter) {
    /* PLY, LAS and PCD state their length: no prefix of them is a cloud */
    for (int t = 0; t < 4; t++) {
        if (t < 2) {
            given_ply(t ? "ascii" : "binary_little_endian", "3", "element face 1\nproperty list uchar int i\n");
            for (int k = 0; k < 9 && t == 0; k++) put_float(k, false);
            if (t == 0) put_bits(2, 1, false), put_bits(77, 8, false);
            if (t == 1) put_text("1 2 3\n4 5 6\n7 8 9\n2 0 1\n");
        } else if (t == 2) {
            given_las(2, 0, 20, 5, 0.001);
        } else {
            given("# .PCD\n" XYZ "WIDTH 2\nDATA binary\n123412341234123412341234");
        }
        const size_t whole = size - (t == 1 ? 3 : 0); /* without its last column the last line is another list */
        for (size = 0; size < whole; size++)
            ck_assert_msg(read_through(4096, 10) == WCUT_BAD_FORMAT, "%d: %zu bytes of %zu", t, size, whole);
    }
}
