# The Debian packages of a release build: lintian finds no error in them, and in a bare Debian 12 root the command, its manual
# page, its completion and `import wirecut` work. Needs lintian, mmdebstrap, root and a Debian archive; says which is missing.
# labels: install slow
set -eu
for program in lintian mmdebstrap; do
    command -v $program >/dev/null || { echo "skipped: no $program"; exit 77; }
done
[ "$(id -u)" -eq 0 ] || { echo "skipped: a root is made by root"; exit 77; }

# PACKAGES: a folder of packages that are there already; else they are built
if [ -z "${PACKAGES-}" ]; then
    cmake -S "$SOURCE_DIR" -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DWCUT_TESTS=OFF >configure.log
    cmake --build build
    (cd build && cpack -G DEB >../cpack.log)
    PACKAGES=$PWD/build
fi
[ "$(ls "$PACKAGES"/*.deb | wc -l)" -eq 4 ] || { echo "expected four packages in $PACKAGES"; exit 1; }
lintian --allow-root --fail-on error "$PACKAGES"/*.deb

# a root with apt alone; another one does not change what is tested
mmdebstrap --quiet --variant=apt bookworm root || { echo "skipped: no Debian archive"; exit 77; }
trap 'rm -rf --one-file-system root' EXIT
mkdir root/given
cp "$PACKAGES"/*.deb "$SOURCE_DIR/samples/jobs/freeform-1.json" root/given/
chroot root apt-get update -qq
# the shell of the root finds the files by their pattern: outside of it there are none
chroot root sh -c 'apt-get install -qq -y --no-install-recommends /given/libwirecut0.1_*.deb /given/wirecut_*.deb \
    /given/python3-wirecut_*.deb' >install.log 2>&1 || { tail -n 20 install.log; exit 1; }

# the command, and what comes with it
chroot root wirecut simulate /given/freeform-1.json -o /given/out --stations 40 --nodes 31 --quiet
chroot root wirecut verify /given/out
[ -s root/usr/share/bash-completion/completions/wirecut ] || { echo "no completion"; exit 1; }
[ "$(chroot root dpkg -L wirecut | grep -c /man1/wirecut.1.gz)" -eq 1 ] || { echo "no manual page"; exit 1; }

# the Python package: the same cut, the same time
chroot root python3 -c "
import json, wirecut
job = wirecut.Job.read('/given/freeform-1.json')
history = wirecut.simulate(job)
assert history.position_mm.ndim == 3 and history.position_mm.shape[2] == 3
print('python', wirecut.__name__, history.position_mm.shape)"
echo "four packages: lintian without errors, installed in a bare root, command and import work"
