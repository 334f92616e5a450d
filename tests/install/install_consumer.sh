# An install works from where it was put: command, headers, soname, find_package(wirecut), pkg-config; moved, too.
set -eu
source=$SOURCE_DIR/tests/install

cmake --install "$BUILD_DIR" --prefix "$PWD/first" >install.log || { cat install.log; exit 1; }
mv first moved # what holds after a move holds in a package and in DESTDIR
prefix=$PWD/moved
ldd "$prefix/bin/wirecut" | grep -F "$prefix/bin/../lib" || { echo "the command does not find its library"; exit 1; }
"$prefix/bin/wirecut" --version | grep -F "$VERSION" || { echo "the command does not say version $VERSION"; exit 1; }
for file in share/man/man1/wirecut.1 share/bash-completion/completions/wirecut share/doc/wirecut/LICENSE; do
    [ -s "$prefix/$file" ] || { echo "$file is missing or empty"; exit 1; }
done
bash -n "$prefix/share/bash-completion/completions/wirecut"
library=$(find "$prefix" -name libwirecut.so)
[ -f "$(dirname "$library")/libwirecut-io.so" ] || { echo "libwirecut-io.so is missing"; exit 1; }
soname=$(objdump -p "$library" | awk '$1 == "SONAME" { print $2 }')
[ "$soname" = "libwirecut.so.${VERSION%.*}" ] || { echo "soname $soname of version $VERSION"; exit 1; }
for header in "$SOURCE_DIR"/kernel/include/wirecut/*.h; do
    cmp "$header" "$prefix/include/wirecut/$(basename "$header")"
done

if /usr/bin/python3 -c 'import numpy, cffi' 2>/dev/null; then
    said=$(PYTHONPATH=$prefix/lib/python3/dist-packages /usr/bin/python3 -c 'import wirecut; print(wirecut.__version__)')
    [ "$said" = "$VERSION" ] || { echo "the installed Python package says version $said"; exit 1; }
fi

echo "find_package"
cmake -G Ninja -S "$source" -B by_cmake -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" \
    -DWANTED="$VERSION" >cmake.log || { cat cmake.log; exit 1; }
cmake --build by_cmake >build.log || { cat build.log; exit 1; }
[ "$(by_cmake/consumer)" = "$VERSION" ]
[ "$(by_cmake/consumer_cxx)" = "$VERSION" ]
by_cmake/reader no-such-job.json | grep -q '^no-such-job.json: '
if cmake -G Ninja -S "$source" -B refused -DCMAKE_PREFIX_PATH="$prefix" -DWANTED=99.0 >refused.log 2>&1 ||
    ! grep -q 'requested version "99.0"' refused.log; then
    cat refused.log
    echo "find_package(wirecut 99.0) was satisfied by $VERSION"
    exit 1
fi

echo "pkg-config"
PKG_CONFIG_PATH=$(dirname "$library")/pkgconfig
export PKG_CONFIG_PATH
[ "$(pkg-config --modversion wirecut)" = "$VERSION" ]
# shellcheck disable=SC2046 # several flags
"$CC" -std=c11 -Wall -Werror "$source/consumer.c" -o by_pkg_config $(pkg-config --cflags --libs wirecut)
[ "$(LD_LIBRARY_PATH=$(dirname "$library") ./by_pkg_config)" = "$VERSION" ]
# shellcheck disable=SC2046
"$CC" -std=c11 -Wall -Werror "$source/reader.c" -o reader $(pkg-config --cflags --libs wirecut-io)
LD_LIBRARY_PATH=$(dirname "$library") ./reader no-such-job.json | grep -q '^no-such-job.json: '
echo "version $VERSION, soname $soname"
