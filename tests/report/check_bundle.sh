#!/bin/sh
# The committed bundle is what its sources give:  sh tests/report/check_bundle.sh [TREE]
# Builds apps/report once more and compares. Needs node and the locked packages (npm ci in apps/report); without them it
# says so and ends with 0.
set -eu
tree=$(cd "${1:-$(dirname "$0")/../..}" && pwd)
cd "$tree/apps/report"

if grep -n '"resolved"' package-lock.json; then
    echo "package-lock.json names a registry"
    exit 1
fi
command -v node >/dev/null 2>&1 || { echo "skipped: no node"; exit 0; }
[ -d node_modules/esbuild ] || { echo "skipped: run npm ci in apps/report first"; exit 0; }

# versions that were not locked would give another bundle, for another reason
node -e '
const {packages} = JSON.parse(require("fs").readFileSync("package-lock.json", "utf8"));
for (const name of ["esbuild", "three", "uplot"]) {
  const {version} = JSON.parse(require("fs").readFileSync(`node_modules/${name}/package.json`, "utf8"));
  if (version !== packages[`node_modules/${name}`].version) {
    console.error(`${name} ${version} is installed, ${packages[`node_modules/${name}`].version} is locked: run npm ci`);
    process.exit(1);
  }
}'

fresh=$(mktemp -d)
trap 'rm -rf "$fresh"' EXIT
node build.mjs "$fresh"
for file in page.js page.css; do
    cmp "dist/$file" "$fresh/$file" || { echo "dist/$file is not what src/ gives: run node build.mjs in apps/report"; exit 1; }
done
echo "the bundle is what its sources give"
