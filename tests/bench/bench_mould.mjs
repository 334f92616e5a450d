// manifold beside bench_mould: the same block split by the same cutter, CPU seconds, the median of five.
//
//   bench_mould DIR && node bench_mould.mjs DIR      in a folder where `npm install manifold-3d` was run
//
// The package is manifold compiled to WebAssembly. Where it is absent this says so and ends well.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

let load;
try {
    const found = createRequire(process.cwd() + "/").resolve("manifold-3d");
    load = (await import(pathToFileURL(found))).default;
} catch (error) {
    console.log(`manifold: skipped, ${error.message.split("\n")[0]}`);
    process.exit(0);
}
const wasm = await load();
wasm.setup();

const bytes = readFileSync(process.argv[2] + "/cutter.bin");
const data = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
const [vertices, triangles] = new Int32Array(data, 0, 2);
const vertProperties = Float32Array.from(new Float64Array(data, 8, 3 * vertices));
const triVerts = new Uint32Array(data, 8 + 24 * vertices, 3 * triangles);
const block = wasm.Manifold.cube([400, 900, 300]);
const seconds = [];
for (let run = 0; run < 5; run++) {
    const start = process.cpuUsage();
    const cutter = new wasm.Manifold(new wasm.Mesh({ numProp: 3, vertProperties, triVerts }));
    const [below, above] = block.split(cutter);
    const volume_of = (solid) => (solid.volume ? solid.volume() : solid.getProperties().volume);
    const volume = volume_of(below) + volume_of(above); // nothing is computed until something is asked for
    const used = process.cpuUsage(start);
    seconds.push((used.user + used.system) / 1e6);
    if (!(Math.abs(volume / 108e6 - 1) < 1e-5)) throw new Error(`volumes add up to ${volume}`);
    for (const solid of [cutter, below, above]) solid.delete();
}
seconds.sort((a, b) => a - b);
console.log(`manifold in WebAssembly: both halves, cutter of ${triangles} triangles  ${seconds[2].toFixed(3)} s`);
