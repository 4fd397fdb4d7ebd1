// Ten thousand random questions, asked of the library in WebAssembly and of the same code compiled
// by GCC: the answers agree in every bit, those of the C library's functions aside (see `isExact`).

import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import vm from 'node:vm';

const core = new URL('../../build/emscripten/bin/', import.meta.url);
const native = new URL('../../build/release/bin/explorer-core', import.meta.url).pathname;
const count = Number(process.argv[2] ?? 10000);

/** xorshift: the same questions in every run. */
let seed = 20191n;
function random() {
  seed ^= (seed << 13n) & 0xffffffffffffffffn;
  seed ^= seed >> 7n;
  seed ^= (seed << 17n) & 0xffffffffffffffffn;
  return Number(seed >> 11n) / 2 ** 53;
}
const whole = (low, high) => low + Math.floor(random() * (high - low + 1));
const oneOf = (list) => list[whole(0, list.length - 1)];
const number = (low, high) => Number((low + random() * (high - low)).toPrecision(whole(2, 17)));

/** Periods with many classes exist more often. */
function onePhase(cells) {
  const unit = oneOf([1, 1, 2, 3, 4, 6, 12]);
  return [[whole(1, Math.max(1, Math.floor(cells / unit))) * unit, whole(1, Math.max(1, Math.floor((4 * cells) / unit))) * unit]];
}
/** A schedule that has motions, of a known family. */
function likely() {
  const scale = whole(1, 12);
  const [w, nu, k] = oneOf([[4, 7, 1], [3, 5, 1], [5, 9, 1], [6, 11, 1], [7, 12, 2], [5, 8, 2]]);
  const [cells, contact] = [w * scale, 2 * k * scale];
  return { cells, phases: [[contact, 2 * nu * scale - contact]], energy: number(3, 6 * scale) };
}
const modes = [[4, -1], [8, -3], [12, -5], [4, -3], [16, -7], [16, -5]];
const force = () => ({ damping: number(0.005, 0.3), place: oneOf(['tip', 'base']), amplitude: number(1e-4, 1e-3) });

const questions = {
  schedule: () => {
    const cells = whole(1, 60);
    return oneOf([
      () => ({ show: 'schedule', cells, phases: onePhase(cells) }),
      () => ({ show: 'schedule', ...likely() }),
      () => ({ show: 'schedule', cells: whole(1, 12), phases: [[whole(1, 9), whole(1, 30)], [whole(1, 9), whole(1, 30)]] }),
    ])();
  },
  mode: () => {
    const [contact, turns] = oneOf(modes);
    return { show: 'mode', contact, turns, period: number(0.9 * (contact / -turns), contact / -turns), cells: whole(2, 40) };
  },
  family: () => ({ show: 'family', order: whole(1, 30), nu: whole(1, 60), blocks: whole(1, 6), cells: whole(1, 300) }),
  simulation: () => ({ show: 'simulation', cells: whole(2, 40), start: { kind: 'pluck', place: number(0.05, 1), displacement: number(-5, 1) },
    damping: 0, crossings: number(1, 40), from: number(0, 8), span: number(0.5, 8), frames: whole(4, 20) }),
  file: () => ({ show: 'file', name: 'schedule.state', of: { ...likely(), energy: undefined } }),
  continuum: () => ({ show: 'file', name: 'schedule.continuum', of: likely() }),
  forced: () => {
    const cells = whole(4, 30);
    return { show: 'forced', cells, phases: [[whole(1, cells), whole(cells, 4 * cells)]], ...force(), which: whole(0, 1) };
  },
  shaken: () => ({ show: 'simulation', cells: whole(4, 30), start: { kind: 'rest' }, ...force(), steps: whole(40, 120), periods: whole(1, 20),
    from: 0, span: 8, frames: 8 }),
  damped: () => ({ show: 'simulation', cells: whole(4, 30), start: { kind: 'pluck', place: 1, displacement: number(-5, -1) },
    damping: number(0.01, 0.2), crossings: 20, from: 0, span: 8, frames: 8 }),
  map: () => ({ show: 'map', cells: whole(1, 60), order: whole(1, 30), energy: number(2, 60) }),
};
const weights = { schedule: 40, mode: 20, family: 8, simulation: 14, file: 6, continuum: 1, forced: 6, shaken: 2, damped: 2, map: 1 };
const kinds = Object.entries(weights).flatMap(([kind, weight]) => Array(weight).fill(kind));

/** Sines, exponentials and powers come from the C library, and two of those may differ in the last bit. */
const isExact = (kind) => !['forced', 'shaken', 'damped', 'continuum'].includes(kind);

const asked = Array.from({ length: count }, (_, k) => {
  const kind = kinds[k % kinds.length];
  return { kind, text: JSON.stringify(questions[kind]()) };
});

const glue = readFileSync(new URL('core.js', core), 'utf8');
const context = vm.createContext({ ...globalThis, console, process, require: createRequire(import.meta.url), WebAssembly, __filename: '', __dirname: '' });
vm.runInContext(`${glue}\nglobalThis.createCore = createCore;`, context);
const bridge = await context.createCore({ wasmBinary: readFileSync(new URL('core.wasm', core)) });
const ask = (text) => bridge.ccall('signoriniAnswer', 'string', ['string'], [text]);
const numbers = () => {
  const at = bridge.ccall('signoriniNumbers', 'number', [], []);
  return bridge.HEAPF64.slice(at / 8, at / 8 + bridge.ccall('signoriniCount', 'number', [], []));
};

const run = (lines, ...options) => {
  const result = spawnSync(native, options, { input: `${lines.join('\n')}\n`, maxBuffer: 2 ** 30, encoding: 'utf8' });
  if (result.status !== 0) throw new Error(`${native}: ${result.error ?? result.signal ?? result.status}`);
  return result.stdout.trim().split('\n');
};

const digests = run(asked.map((one) => one.text));
const tally = {};
const differing = [];
asked.forEach(({ kind, text }, k) => {
  const answer = JSON.parse(ask(text));
  const isSame = bridge.ccall('signoriniDigest', 'string', [], []) === digests[k];
  const count = (tally[kind] ??= { asked: 0, same: 0, answered: 0 });
  ++count.asked;
  count.answered += answer.error || answer.answer?.status === 'none' ? 0 : 1;
  count.same += isSame ? 1 : 0;
  if (!isSame) differing.push({ kind, text });
});
console.table(tally);

let faults = 0;
for (const { kind, text } of differing) {
  if (isExact(kind)) {
    if (++faults <= 3) console.log(`differs: ${text}\n  browser ${ask(text).slice(0, 300)}\n  native  ${run([text], 'json')[0].slice(0, 300)}`);
    continue;
  }
  // The last bit of a sine may show: the motion is the same to nine digits, and so is the verdict.
  const own = JSON.parse(ask(text));
  const other = run([text], 'json')[0];
  const end = other.lastIndexOf('}') + 1;
  const theirs = JSON.parse(other.slice(other.indexOf('{'), end));
  const values = other.slice(end).trim().split(' ').filter(Boolean).map(hexadecimal);
  const mine = numbers();
  const size = Math.max(1, ...mine.map(Math.abs));
  const worst = mine.reduce((most, value, i) => Math.max(most, Math.abs(value - values[i])), 0) / size;
  if (own.answer?.status !== theirs.answer?.status || mine.length !== values.length || worst > 1e-9) {
    if (++faults <= 3) console.log(`differs by ${worst}: ${text}`);
  }
}
function hexadecimal(word) {
  const [, sign, lead, digits, power] = /^(-?)0x([01])\.?([0-9a-f]*)p([+-]\d+)$/.exec(word);
  return (sign ? -1 : 1) * (Number(lead) + (digits ? parseInt(digits, 16) / 16 ** digits.length : 0)) * 2 ** Number(power);
}
console.log(`compare: ${asked.length} questions, ${asked.length - differing.length} answers equal in every bit, ${differing.length - faults} to nine digits, ${faults} not`);
process.exit(faults === 0 ? 0 : 1);
