// manifold beside bench_mould: the same block split by the same cutter, the least CPU time of five; one line for
// bench_table.sh, which calls it in a folder where `npm install manifold-3d` was run. That is manifold compiled to
// WebAssembly.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const { default: load } = await import(pathToFileURL("node_modules/manifold-3d/manifold.js"));
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
const least = Math.min(...seconds);
console.log(["halves", "manifold", least, `both halves, cutter of ${triangles} triangles`].join("\t"));
