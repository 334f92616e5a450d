# The validator of Khronos finds no error, no warning and no hint in the GLB files.
# labels: exchange slow
. "$SOURCE_DIR/tests/exchange/exchange.sh"
need node nodejs
if ! node -e 'require("gltf-validator")' 2>/dev/null; then
    need npm npm
    npm install --silent --no-audit --no-fund --prefix "$PWD" gltf-validator@2.0.0-dev.3.10 >log 2>&1 ||
        { echo "skipped: npm gives no gltf-validator here"; exit 77; }
fi
"$WIRECUT" simulate "$SOURCE_DIR/samples/jobs/freeform-4.json" -o out --quiet
cat >check.js <<'JAVASCRIPT'
const fs = require("fs"), validator = require("gltf-validator");
(async () => {
    let faults = 0;
    for (const file of ["lower.glb", "upper.glb", "out/surface.glb"]) {
        const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
        const n = report.issues;
        console.log(file, "errors", n.numErrors, "warnings", n.numWarnings, "hints", n.numHints,
                    "triangles", report.info.totalTriangleCount);
        for (const m of n.messages) console.log("  ", m.code, m.message, m.pointer);
        faults += n.numErrors + n.numWarnings + n.numHints + (report.info.totalTriangleCount > 0 ? 0 : 1);
    }
    process.exit(faults ? 1 : 0);
})();
JAVASCRIPT
node check.js
