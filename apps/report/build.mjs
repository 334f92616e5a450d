// Bundle the page: src/ and two libraries into dist/page.js and dist/page.css, the same bytes at every run.
// node build.mjs [folder]
import {build} from 'esbuild';
import {readFileSync, writeFileSync, mkdirSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, 'dist');

const licence = (name, file) => {
  const {version} = JSON.parse(readFileSync(join(here, 'node_modules', name, 'package.json'), 'utf8'));
  return `${name} ${version}\n${readFileSync(join(here, 'node_modules', name, file), 'utf8').trim()}`;
};
const licences = `${licence('three', 'LICENSE')}\n\n${licence('uplot', 'LICENSE')}`;
const banner = `/*!\nThe report page of wirecut, GPL-3.0-or-later, with\n\n${licences}\n*/`;

const options = {bundle: true, minify: true, write: false, legalComments: 'none', charset: 'ascii', target: 'es2021'};
const bundle = async entry =>
  (await build({...options, entryPoints: [join(here, 'src', entry)], format: 'iife'})).outputFiles[0].text;

const script = `${banner}\n${await bundle('main.js')}`.replaceAll('\r', '');
const style = `${await bundle('page.css')}`.replaceAll('\r', '');
// inside an element these would end it, or change how the parser reads it
for (const [text, word] of [
  [script, /<\/script|<!--|<script/i],
  [style, /<\/style|<!--/i]
])
  if (word.test(text)) throw new Error(`the bundle holds ${word}`);

mkdirSync(out, {recursive: true});
writeFileSync(join(out, 'page.js'), script);
writeFileSync(join(out, 'page.css'), style);
