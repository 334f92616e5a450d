# wirecut compare: scans that are none, each refused with what was found where, and exit code 3; nothing is left behind.
. "$SOURCE_DIR/tests/apps/common.sh"
steady=$jobs/steady-400-60.json
good=$SOURCE_DIR/samples/scans/freeform-4.ply

# refused SCAN TEXT [OPTION...]: one line that names the scan and holds the text, in bounded memory
refused() {
    scan=$1 text=$2
    shift 2
    run 3 compare "$steady" "$scan" -o bad "$@"
    one_line "$text"
    [ -e bad/deviation.json ] && fail "$called: it left a result"
    no_leavings bad
}
limit() { ulimit -v 4000000 2>/dev/null || :; } # sanitizers reserve more than that
case "$(ldd "$WIRECUT")" in *libasan*) ;; *) limit ;; esac

# nothing, or nothing that spans a face
for name in empty.xyz empty.ply empty.obj empty.off; do
    : >$name
    refused $name "$name: byte 0: found the end of the file"
done
refused nowhere.xyz "nowhere.xyz"
printf '200 600 150\n' >one.xyz
refused one.xyz "one.xyz: found 1 points in one place, expected a scan of a face"
awk 'BEGIN { for (i = 0; i < 200; i++) print 200, 600, 150 }' >equal.xyz
refused equal.xyz "found 200 points in one place"
refused equal.xyz "found 200 points in one place" --register fit
awk 'BEGIN { for (i = 0; i < 500; i++) print 100 + 0.4 * i, 300 + i, 150 + 0.01 * i }' >line.xyz
refused line.xyz "found 500 points on one line"
refused line.xyz "found 500 points on one line" --reconstruct field
printf 'nan nan nan\ninf 1 2\n' >nan.xyz
refused nan.xyz "found no point (2 not finite, 0 withheld)"
awk 'BEGIN { for (i = 0; i < 500; i++) print 9000 + i, 9000 + i % 7, 9000 }' >away.xyz
refused away.xyz "none of them over the face"
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 200 600 150\nvertex 200 600 150\nvertex 200 600 150\nendloop\nendfacet\nendsolid\n' >flat.stl
refused flat.stl "found 3 points in one place"

# text
printf '1 2 3\n4 five 6\n' >text.xyz
refused text.xyz "text.xyz: line 2, column 3: found five 6, expected a number"
printf '1 2 3\n4 5 6 7\n' >columns.xyz
refused columns.xyz "line 2, column 7"

# PLY
xyz='property float x\nproperty float y\nproperty float z\n'
ply() { # FORMAT COUNT MORE...: a header, then what is given
    printf "ply\nformat %s 1.0\nelement vertex %s\n$xyz$3end_header\n$4" "$1" "$2"
}
head -c 20000 "$good" >cut.ply
refused cut.ply "cut.ply: byte 136: found a count of 8000 vertices in the header and 19864 bytes of data"
ply binary_little_endian -5 '' '' >negative.ply
refused negative.ply "line 3, column 16: found -5"
ply binary_little_endian 2147483648 '' '' >int.ply
refused int.ply "found a count of 2147483648 vertices, expected 0 to 2147483647"
ply binary_little_endian 900000000 '' 1234 >huge.ply
refused huge.ply "a count of 900000000 vertices in the header and 4 bytes of data"
ply ascii 1 'property list uchar int a\n' '200 600 150 3 1 2\n' >list.ply
refused list.ply "line 9, column 18"
ply ascii 1 'property list int int a\n' '200 600 150 2000000000 1 2\n' >endless.ply
refused endless.ply "line 9, column 27"
sed 's/binary_little_endian/binary_big_endian/' "$good" >order.ply
refused order.ply "a wrong byte order"

# meshes
printf 'v 1 2 3\nv 1 2\n' >short.obj
refused short.obj "line 2, column 6"
{ for i in 1 2 3; do printf 'v 200 600 150\n'; done; yes 'f 1 2 3' | head -c 4000000; } >bomb.obj
refused bomb.obj "found 3 points in one place"
printf 'OFF\n2147483647 1 0\n1 2 3\n' >lie.off
refused lie.off "a count of 2147483647 vertices"
printf 'glTF\002' >bad.glb
refused bad.glb "assimp reads no mesh in it"

# formats that are not read, and some that end early
printf 'ASTM-E57' >a.e57
refused a.e57 "found a cloud in E57, which would need the library libE57Format (not in Debian 12), expected PLY"
printf 'LASF' >short.las
refused short.las "byte 4: found the end of the file"
printf 'PK\003\004' >a.zip
refused a.zip "found a ZIP archive"

# a CAD file that ends early is no reference
printf 'ISO-10303-21;\n' >surface.step
run 3 compare surface.step "$good" -o bad
one_line "surface.step: "

# a mesh of triangles without area is no reference
run 3 compare flat.stl "$good" -o bad
one_line "flat.stl: line 10: found no triangle (1 collapsed)"
finish
