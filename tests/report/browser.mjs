// Open pages in a headless Chromium and ask them what they show:  node browser.mjs FOLDER|PAGE.html [PICTURES]
// A folder holds what pages.h writes, with numbers known here; a page alone is any verb's report.
// Ends with 0 (right), 1 (wrong, said on stderr) or 77 (no chromium here). Speaks the DevTools protocol over a pipe;
// needs nothing but node. With a second folder it leaves screenshots there.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {accessSync, mkdtempSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {basename, dirname, join} from 'node:path';
import {pathToFileURL} from 'node:url';

const [folder, pictures] = process.argv[2]?.endsWith('.html') ? [dirname(process.argv[2]), process.argv[3]] : process.argv.slice(2);
const only = process.argv[2]?.endsWith('.html') ? basename(process.argv[2]) : null;
const executable = (process.env.PATH ?? '').split(':').flatMap(at => ['chromium', 'chromium-browser'].map(name => join(at, name)))
  .find(path => { try { accessSync(path, 1); return statSync(path).isFile(); } catch { return false; } });
if (!executable) {
  console.log('skipped: no chromium on the path');
  process.exit(77);
}

// a browser of its own: send(method, parameters, session) and what it reports
class Browser {
  constructor(...flags) {
    this.profile = mkdtempSync(join(tmpdir(), 'wirecut-browser-'));
    this.child = spawn(executable, ['--headless', '--no-sandbox', '--remote-debugging-pipe', `--user-data-dir=${this.profile}`, '--no-first-run',
      '--disable-background-networking', '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage', '--force-device-scale-factor=1', ...flags], {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    this.waiting = new Map();
    this.listeners = [];
    this.last = 0;
    let rest = '';
    this.child.stdio[4].setEncoding('utf8').on('data', data => {
      const parts = (rest + data).split('\0');
      rest = parts.pop();
      parts.forEach(part => this.receive(JSON.parse(part)));
    });
    this.child.on('exit', () => this.waiting.forEach(({fail}) => fail(new Error('the browser ended'))));
  }

  receive(message) {
    const waiting = this.waiting.get(message.id);
    if (!waiting) return this.listeners.forEach(listener => listener(message));
    this.waiting.delete(message.id);
    if (message.error) waiting.fail(new Error(message.error.message)); else waiting.done(message.result);
  }

  send(method, params = {}, sessionId = undefined) {
    return new Promise((done, fail) => {
      this.waiting.set(++this.last, {done, fail});
      this.child.stdio[3].write(`${JSON.stringify({id: this.last, method, params, sessionId})}\0`);
    });
  }

  async close() {
    const ended = new Promise(done => this.child.once('exit', done));
    await this.send('Browser.close').catch(() => {});
    await ended;
    rmSync(this.profile, {recursive: true, force: true, maxRetries: 5});
  }
}

// an open page: everything that it complained about or asked the network for is kept
class Page {
  static async open(browser, file, width = 1280, height = 1000) {
    const page = new Page();
    const {targetId} = await browser.send('Target.createTarget', {url: 'about:blank'});
    const {sessionId} = await browser.send('Target.attachToTarget', {targetId, flatten: true});
    Object.assign(page, {browser, sessionId, targetId, complaints: [], requests: []});
    browser.listeners.push(({method, params, sessionId: from}) => {
      if (from !== sessionId) return;
      if (method === 'Runtime.consoleAPICalled') page.complaints.push(params.args.map(a => a.value ?? a.description).join(' '));
      if (method === 'Runtime.exceptionThrown') page.complaints.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
      if (method === 'Log.entryAdded') page.complaints.push(params.entry.text);
      if (method === 'Network.requestWillBeSent') page.requests.push(params.request.url);
    });
    for (const domain of ['Runtime', 'Log', 'Network', 'Page']) await page.send(`${domain}.enable`);
    await page.send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile: false});
    const begin = Date.now();
    await page.send('Page.navigate', {url: pathToFileURL(join(folder, file)).href});
    for (let k = 0; k < 600 && !await page.ask('Boolean(window.wirecut?.ready)'); k++) await new Promise(done => setTimeout(done, 50));
    page.opened = Date.now() - begin;
    assert.equal(await page.ask('Boolean(window.wirecut?.ready)'), true, `${file} was never ready: ${page.complaints.join('; ')}`);
    return page;
  }

  send(method, params) { return this.browser.send(method, params, this.sessionId); }

  async ask(expression) {
    const {result, exceptionDetails} = await this.send('Runtime.evaluate', {expression, returnByValue: true, awaitPromise: true});
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description ?? exceptionDetails.text}`);
    return result.value;
  }

  async picture(name) {
    if (!pictures) return;
    const {cssContentSize: {width, height}} = await this.send('Page.getLayoutMetrics');
    const {data} = await this.send('Page.captureScreenshot', {captureBeyondViewport: true, clip: {x: 0, y: 0, width, height, scale: 1}});
    writeFileSync(join(pictures, name), Buffer.from(data, 'base64'));
  }

  async close() {
    assert.deepEqual(this.complaints, [], 'the console is silent');
    assert.deepEqual(this.requests.filter(url => !/^(file|data|blob):/.test(url)), [], 'nothing is asked of the network');
    await this.browser.send('Target.closeTarget', {targetId: this.targetId});
  }
}

const near = (found, expected, tolerance, what) => assert.ok(Math.abs(found - expected) <= tolerance, `${what}: found ${found}, expected ${expected}`);
const nearColour = (found, expected, what) => found.forEach((c, k) => near(c, expected[k], 3, `${what}, channel ${'rgb'[k]}`));

// helpers inside the page: a frame has been drawn; the colour at a vertex; type into a number box by its label
const HELPERS = `
window.frame = () => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
window.colourAt = index => {
  const {view} = wirecut.surface;
  view.draw(true); // a picture can be read within the task that drew it
  const [x, y] = view.project(...at(index).position), copy = document.createElement('canvas');
  copy.width = view.canvas.width, copy.height = view.canvas.height;
  const context = copy.getContext('2d');
  context.drawImage(view.canvas, 0, 0);
  return Array.from(context.getImageData(Math.round(x - 0.5), Math.round(y - 0.5), 1, 1).data.subarray(0, 3));
};
window.type = (label, value) => {
  const box = [...document.querySelectorAll('label')].find(l => l.textContent.trim().startsWith(label) && l.querySelector('[type=number]')).querySelector('input');
  box.value = value;
  box.dispatchEvent(new Event('input'));
};
window.tick = (label, on) => {
  const box = [...document.querySelectorAll('label')].find(l => l.textContent.trim() === label).querySelector('input');
  if (box.checked !== on) box.click();
};
window.at = index => wirecut.surface.at(index);
true`;

const STATIONS = 161, NODES = 121; // pages.h
const forceAt = (s, n) => {
  const u = n / (NODES - 1), v = s / (STATIONS - 1);
  return u > 0.18 && u < 0.82 ? 0.009 + 0.003 * Math.sin(Math.PI * u) * Math.sin(Math.PI * v) : 0;
};

async function testCut(browser) {
  const page = await Page.open(browser, 'cut.html');
  await page.ask(HELPERS);
  await page.picture('cut-light.png');

  // hostile names are text, and nothing of them ran
  assert.equal(await page.ask('typeof window.broken'), 'undefined');
  assert.equal(await page.ask('document.images.length'), 1, 'the only image is the one for paper');
  const title = await page.ask('document.querySelector("h1").textContent');
  assert.ok(title.includes('</script><script>window.broken=1</script>') && title.includes('\u2028') && title.includes('\ufffd'), title);
  assert.ok((await page.ask('document.querySelector(".provenance td:nth-child(2)").textContent')).startsWith('</script>'));
  // and the policy holds even for a script that gets in
  await page.ask('document.body.append(Object.assign(document.createElement("script"), {textContent: "window.broken = 2"}))');
  assert.equal(await page.ask('typeof window.broken'), 'undefined');
  assert.ok(page.complaints.splice(0).some(text => /Content Security Policy/.test(text)), 'the policy refused it');

  // a click gives the vertex under it, in numbers that the test knows
  for (const [s, n] of [[80, 60], [20, 40], [140, 85]]) {
    const picked = await page.ask(`(() => { const p = at(${s * NODES + n}).position; return wirecut.pick(...wirecut.surface.view.project(...p)); })()`);
    assert.deepEqual([picked.row, picked.column], [s, n]);
    near(picked.values[0].value, forceAt(s, n), 1e-9, 'force');
    near(picked.position[0], -110 + 620 * n / (NODES - 1), 1e-4, 'x');
  }
  assert.match(await page.ask('document.querySelector(".readout").textContent'), /station140node85x.*mm.*N\/mm/);
  assert.equal(await page.ask('document.querySelectorAll(".surface .charts .uplot").length'), 2, 'profiles along station and node');
  assert.equal(await page.ask('wirecut.pick(2, 2)'), null);

  // colours are those of the scale
  for (const box of ['station lines', 'node curves', 'path curves', 'worst areas', 'shading']) await page.ask(`tick(${JSON.stringify(box)}, false)`);
  nearColour(await page.ask(`colourAt(${80 * NODES + 8})`), [0x44, 0x01, 0x54], 'force 0 is the foot of viridis');
  const middle = forceAt(40, 50);
  await page.ask(`type('to', ${2 * middle})`);
  nearColour(await page.ask(`colourAt(${40 * NODES + 50})`), [0x21, 0x91, 0x8c], 'half the range is the middle of viridis');
  await page.ask('wirecut.surface.choose(0, 2)');
  nearColour(await page.ask(`colourAt(${72 * NODES + 54})`), [158, 163, 168], 'not measured is grey');
  const [warm, cold] = [await page.ask(`colourAt(${80 * NODES + 20})`), await page.ask(`colourAt(${80 * NODES + 70})`)];
  assert.ok(warm[0] > warm[2] + 60 && cold[2] > cold[0] + 60, `positive is orange (${warm}), negative blue (${cold})`);
  await page.ask(`type('Tolerance', 1.39)`);
  const inside = await page.ask(`colourAt(${80 * NODES + 70})`);
  assert.ok(Math.max(...inside) - Math.min(...inside) < 8, `inside the tolerance there is no hue: ${inside}`);

  // keys turn the view and find a point
  await page.ask('wirecut.surface.canvas.focus()');
  const before = await page.ask('wirecut.surface.view.azimuth');
  await page.send('Input.dispatchKeyEvent', {type: 'keyDown', key: 'ArrowLeft', code: 'ArrowLeft'});
  assert.notEqual(await page.ask('wirecut.surface.view.azimuth'), before);
  await page.ask(`type('Read at station', 33); type('node', 44)`);
  assert.equal(await page.ask('wirecut.surface.index'), 33 * NODES + 44);

  // charts: units, the other abscissa, numbers as a table
  const labels = await page.ask('[...document.querySelectorAll(".plot")].map(p => p.getAttribute("aria-label"))');
  assert.ok(labels.some(label => /Speed: mount A from 9 to 14 mm\/s/.test(label)), labels.join('\n'));
  await page.ask('document.querySelectorAll("fieldset input")[1].click()');
  assert.match(await page.ask('document.querySelector("section:nth-of-type(2) .u-legend").textContent'), /station.*mount A \[mm\/s\]/);
  await page.ask('document.querySelectorAll("section:nth-of-type(2) details")[0].open = true; frame()');
  assert.equal(await page.ask('document.querySelectorAll("section:nth-of-type(2) details")[0].querySelectorAll("tbody tr").length'), STATIONS);
  assert.equal(await page.ask('document.querySelectorAll("canvas:not([aria-hidden=true]):not([aria-label])").length - document.querySelectorAll(".plot canvas").length'), 0, 'every picture has words');

  // paper, dark, narrow
  await page.ask('document.querySelector("details").open = false');
  await page.send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: 'dark'}]});
  await page.ask('frame()');
  await page.picture('cut-dark.png');
  const background = () => page.ask('getComputedStyle(document.body).backgroundColor');
  assert.equal(await background(), 'rgb(21, 23, 26)');
  const pdf = await page.send('Page.printToPDF', {printBackground: true});
  if (pictures) writeFileSync(join(pictures, 'cut.pdf'), Buffer.from(pdf.data, 'base64'));
  assert.match(await page.ask('document.querySelector(".paper").src.slice(0, 22)'), /^data:image\/png;base64,$/);
  await page.send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: 'light'}]});
  await page.send('Emulation.setDeviceMetricsOverride', {width: 360, height: 740, deviceScaleFactor: 1, mobile: true});
  await page.ask('frame()');
  await page.picture('cut-narrow.png');
  assert.ok(await page.ask('document.documentElement.scrollWidth <= innerWidth'), 'nothing sticks out of a narrow window');
  await page.close();
}

async function testCloud(browser) {
  const page = await Page.open(browser, 'cloud.html');
  await page.ask(HELPERS);
  await page.ask(`wirecut.pick(...wirecut.surface.view.project(200, 600, 170))`);
  await page.picture('cloud-light.png');
  assert.equal(await page.ask('wirecut.surface.shape.total'), 1000000);
  const shown = await page.ask('wirecut.surface.shape.count');
  assert.ok(shown <= 400000 && shown >= 300000, `${shown} points are shown`);

  // the share counts every point: compare with a count of the same formula (pages.h)
  let within = 0;
  for (let i = 0; i < 1000000; i++) {
    const u = (i % 1000) / 999, v = Math.floor(i / 1000) / 999;
    within += Math.abs(0.8 * Math.sin(7 * u + 2 * v) * Math.sin(Math.PI * v)) <= 0.4;
  }
  await page.ask(`type('Tolerance', 0.4)`);
  const words = await page.ask('document.querySelector(".share").textContent');
  near(Number(/([\d.]+)\s%\slie within/.exec(words)[1]), within / 1e4, 0.15, words);
  assert.equal(await page.ask('(() => { let most = 0; for (let i = 0; i < wirecut.surface.shape.count; i++) most = Math.max(most, at(i).values[0].value); return most; })()'), 7.5, 'the outlier is shown');

  // bands of a map are named where their numbers would be, for those too who hear it
  const said = await page.ask('[...document.querySelectorAll(".plot")].map(p => p.getAttribute("aria-label"))');
  assert.ok(said.some(label => /residual over time and tension, angle,/.test(label)), said.join('\n'));

  // picking gives a point whose numbers agree with the formula
  const picked = await page.ask(`wirecut.pick(...wirecut.surface.view.project(200, 600, 170))`);
  const u = picked.position[0] / 400, v = picked.position[1] / 1200;
  near(picked.values[0].value, 0.8 * Math.sin(7 * u + 2 * v) * Math.sin(Math.PI * v), 1e-5, 'deviation');

  const cost = await page.ask(`(() => {
    const {view} = wirecut.surface, copy = Object.assign(document.createElement('canvas'), {width: 8, height: 8}).getContext('2d', {willReadFrequently: true});
    const begin = performance.now();
    for (let k = 0; k < 3; k++) {
      view.azimuth += 0.1;
      view.draw(true);
      copy.drawImage(view.canvas, 0, 0); // waits for the picture
      copy.getImageData(0, 0, 1, 1);
    }
    return (performance.now() - begin) / 3;
  })()`);
  const coarse = await page.ask(`(async () => {
    const {view} = wirecut.surface;
    view.slow = true;
    view.turn(0.1, 0);
    const moving = view.surface.geometry.getIndex().count;
    await new Promise(done => setTimeout(done, 400));
    return [moving, view.surface.geometry.getIndex()];
  })()`);
  assert.ok(coarse[0] < 50000 && coarse[1] === null, `a slow machine turns a part of the points and rests on all: ${coarse}`);
  const pick = await page.ask('(() => { const t = performance.now(); wirecut.surface.view.pick(300, 200); return performance.now() - t; })()');
  // the other shape: a mesh with triangles of its own, and a field without a value
  await page.ask('wirecut.surface.choose(1, 0)');
  assert.equal(await page.ask('wirecut.surface.shape.triangles.length'), 6 * 19 * 19);
  const corner = await page.ask('wirecut.pick(...(wirecut.surface.view.draw(true), wirecut.surface.view.project(...at(213).position)))');
  assert.equal(corner.index, 213);
  near(corner.values[0].value, 0.213, 1e-7, 'height');
  await page.ask('wirecut.surface.choose(1, 1)');
  assert.equal(await page.ask('document.querySelector(".share").textContent'), 'No value was measured.');
  console.log(`1,000,000 points: ready after ${page.opened} ms, a frame in software ${cost.toFixed(0)} ms, a pick ${pick.toFixed(0)} ms`);
  await page.close();
}

// without WebGL a map from above and a sentence
async function testPlan(browser) {
  const page = await Page.open(browser, 'cut.html');
  assert.equal(await page.ask('wirecut.surface.space'), false, 'this browser was to have no WebGL');
  assert.match(await page.ask('document.querySelector(".notice:not([hidden])").textContent'), /no WebGL/);
  const picked = await page.ask(`wirecut.pick(...wirecut.surface.view.project(...wirecut.surface.at(${80 * NODES + 60}).position))`);
  assert.deepEqual([picked.row, picked.column], [80, 60]);
  const colours = await page.ask(`(() => { const c = wirecut.surface.canvas, d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data, seen = new Set();
    for (let i = 0; i < d.length; i += 4) seen.add(d[i] << 16 | d[i + 1] << 8 | d[i + 2]); return seen.has(0x440154) && seen.size; })()`);
  assert.ok(colours > 20, `the map has colours: ${colours}`);
  await page.picture('cut-plan.png');
  // the browser's own refusal of a context is no complaint of the page
  page.complaints = page.complaints.filter(text => !/WebGL/i.test(text));
  await page.close();
}

// cases of a study: brushes by mouse and by numbers, the list in the goal's order, a point that is picked, links
async function testCases(browser) {
  const page = await Page.open(browser, 'cases.html');
  const selected = () => page.ask("document.querySelector('.cases .share').textContent.split(' ')[0]");
  assert.equal(await selected(), '100');
  assert.equal(await page.ask('window.broken'), undefined);
  // the upper half of the first axis by mouse: positions are those of a frame of 320 pixels with 34 above, 20 below
  const box = await page.ask("(() => { const b = document.querySelector('.sheet').getBoundingClientRect(); return [b.left, b.top, b.width]; })()");
  const x = box[0] + Math.min(60, box[2] / 10), y = t => box[1] + 34 + (1 - t) * 266;
  for (const [type, at] of [['mousePressed', 0.5], ['mouseMoved', 0.7], ['mouseMoved', 1.1], ['mouseReleased', 1.1]])
    await page.send('Input.dispatchMouseEvent', {type, x, y: y(at), button: 'left', buttons: 1, clickCount: 1});
  assert.equal(await selected(), '50');
  // the list: the highest first, each with its own page but the one without
  assert.deepEqual(await page.ask("[...document.querySelectorAll('.cases .scroll tbody tr td:first-child a')].slice(0, 2).map(a => [a.textContent, a.getAttribute('href')])"),
    [['198', 'cases/00/report.html'], ['196', 'cases/00/report.html']]);
  await page.ask("[...document.querySelectorAll('.cases button')].find(b => b.textContent === 'Clear brushes').click()");
  assert.equal(await selected(), '100');
  // by numbers: b from 16 to 100, which the case without b is not in
  await page.ask("for (const [side, value] of [['b from', 16], ['b to', 100]]) { const input = document.querySelector(`[aria-label=\"${side}\"]`); input.value = value; input.dispatchEvent(new Event('change')); }");
  assert.equal(await selected(), '6');
  // a point of the scatter names its case
  await page.ask("(() => { const {cases} = wirecut, c = cases.scatter.canvas, b = c.getBoundingClientRect(), [x, y] = cases.pointPlace(5, c.clientWidth, c.clientHeight); c.dispatchEvent(new MouseEvent('click', {clientX: b.left + x, clientY: b.top + y})); })()");
  assert.match(await page.ask("document.querySelectorAll('.cases figure')[1].querySelector('.share').textContent"), /^case 10: [^]*b 25, word odd$/);
  assert.equal(await page.ask("document.querySelectorAll('.best li').length"), 2);
  await page.picture('cases.png');
  await page.close();
}

// any page: it opens without a word, its charts are drawn, and what is clicked in its middle is what its boxes say
async function testAny(browser) {
  const page = await Page.open(browser, only);
  await page.ask(HELPERS);
  await page.picture('page.png');
  const charts = await page.ask('wirecut.report.sections.reduce((sum, section) => sum + section.charts.length + section.maps.length, 0)');
  assert.equal(await page.ask("document.querySelectorAll('figure.chart .uplot canvas').length"), charts);
  if (await page.ask('wirecut.surface === null')) return page.close();
  const index = await page.ask('(wirecut.surface.shape.rows >> 1) * wirecut.surface.shape.columns + (wirecut.surface.shape.columns >> 1)');
  const picked = await page.ask(`wirecut.pick(...wirecut.surface.view.project(...at(${index}).position))`);
  assert.equal(picked.index, index);
  for (let f = 0; f < await page.ask('wirecut.surface.shape.fields.length'); f++) await page.ask(`wirecut.surface.choose(0, ${f}); frame()`);
  await page.close();
}

for (const [flags, tests] of only ? [[['--use-angle=swiftshader', '--enable-unsafe-swiftshader'], [testAny]]] : [[['--use-angle=swiftshader', '--enable-unsafe-swiftshader'], [testCut, testCloud, testCases]], [['--disable-3d-apis'], [testPlan]]]) {
  const browser = new Browser(...flags);
  try {
    for (const test of tests) await test(browser);
  } catch (error) {
    console.error(error.stack);
    process.exitCode = 1;
  } finally {
    await browser.close();
  }
}
