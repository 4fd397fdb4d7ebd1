// Ten thousand random questions, asked of the library in WebAssembly and of the same code compiled
// by GCC: the answers agree in every bit. Where a forced motion needs a linear program, the browser,
// which has no GLPK, says that it is undecided.

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
/** Polygons of two contacts: their chains and periods. */
const polygons = [
  [[[2, 1, 2], [2, 2, 1]], 5 / 2, 8 / 3], [[[6, 3, 2], [2, 2, 1]], 3, 16 / 5], [[[10, 5, 2], [2, 2, 1]], 10 / 3, 24 / 7],
  [[[16, 4, 2], [2, 1, 1]], 7, 36 / 5], [[[2, 3, 2], [2, 4, 1]], 9 / 8, 8 / 7],
];
/** Around the bar: pressed on the wall, touching it, between two stops. */
const scenes = [
  () => ({ ...likely(), energy: undefined, gap: -1e-3 }),
  () => ({ ...likely(), gap: 0, energy: number(1e-6, 1e-4) }),
  () => {
    const scale = whole(1, 8);
    return { cells: 4 * scale, phases: [[scale, 5 * scale], [scale, 5 * scale, 'L']], second_stop: number(2e-4, 3e-3) };
  },
  () => ({ cells: whole(1, 8), phases: [[whole(1, 8), whole(1, 12)], [whole(1, 8), whole(1, 12), 'L']], second_stop: 1e-3 }),
];
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
  scene: () => ({ show: 'schedule', ...oneOf(scenes)() }),
  polygon: () => {
    const [chains, low, high] = oneOf(polygons);
    return { show: 'polygon', chains, period: low + (high - low) * (0.001 + 0.998 * random()), split: 0.001 + 0.998 * random(), cells: whole(2, 40) };
  },
  polygons: () => ({ show: 'polygons', order: whole(1, 7) }),
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
  bars: () => ({ show: 'scene', words: oneOf(['clamp 10 gap=1e-3 14:1.3 clamp', '4:2 gap=1e-3 16', 'spring=2 20 dash=0.1 stop=1e-3', 'clamp 8 stop=5e-4 12 clamp']),
    hands: [number(-3, 1), 0], ...(random() < 0.3 ? { gravity: number(-1e-3, 1e-3) } : {}), from: number(0, 4), span: number(0.5, 4) }),
  swept: () => ({ show: 'sweep', cells: whole(6, 20), ...force(), damping: number(0.02, 0.1), least: 0.9, most: 1.3, points: 5, periods: 20, down: random() < 0.5, wanted: whole(1, 5) }),
  damped: () => ({ show: 'simulation', cells: whole(4, 30), start: { kind: 'pluck', place: 1, displacement: number(-5, -1) },
    damping: number(0.01, 0.2), crossings: 20, from: 0, span: 8, frames: 8 }),
  map: () => ({ show: 'map', cells: whole(1, 60), order: whole(1, 30), energy: number(2, 60) }),
};
const weights = { schedule: 27, mode: 17, scene: 8, polygon: 6, polygons: 1, family: 7, simulation: 12, file: 5, continuum: 1, forced: 6, shaken: 2, damped: 2, bars: 4, swept: 1, map: 1 };
const kinds = Object.entries(weights).flatMap(([kind, weight]) => Array(weight).fill(kind));

const asked = Array.from({ length: count }, (_, k) => {
  const kind = kinds[k % kinds.length];
  return { kind, text: JSON.stringify(questions[kind]()) };
});

const glue = readFileSync(new URL('core.js', core), 'utf8');
const context = vm.createContext({ ...globalThis, console, process, require: createRequire(import.meta.url), WebAssembly, __filename: '', __dirname: '' });
vm.runInContext(`${glue}\nglobalThis.createCore = createCore;`, context);
const bridge = await context.createCore({ wasmBinary: readFileSync(new URL('core.wasm', core)) });
const ask = (text) => bridge.ccall('signoriniAnswer', 'string', ['string'], [text]);
const run = (lines, ...options) => {
  const result = spawnSync(native, options, { input: `${lines.join('\n')}\n`, maxBuffer: 2 ** 30, encoding: 'utf8' });
  if (result.status !== 0) throw new Error(`${native}: ${result.error ?? result.signal ?? result.status}`);
  return result.stdout.trim().split('\n');
};

const digests = run(asked.map((one) => one.text));
const tally = {};
const differing = [];
let withoutSolver = 0;
const lacksSolver = ({ answer }) => answer?.status === 'undecided' && /no solver of linear programs/.test(answer.detail);
asked.forEach(({ kind, text }, k) => {
  const answer = JSON.parse(ask(text));
  const isSame = bridge.ccall('signoriniDigest', 'string', [], []) === digests[k];
  const count = (tally[kind] ??= { asked: 0, same: 0, answered: 0 });
  ++count.asked;
  count.answered += answer.error || answer.answer?.status === 'none' ? 0 : 1;
  count.same += isSame ? 1 : 0;
  if (!isSame && lacksSolver(answer)) ++withoutSolver;
  else if (!isSame) differing.push(text);
});
console.table(tally);
for (const text of differing.slice(0, 3)) {
  console.log(`differs: ${text}\n  browser ${ask(text).slice(0, 300)}\n  native  ${run([text], 'json')[0].slice(0, 300)}`);
}
console.log(`compare: ${asked.length} questions, ${asked.length - differing.length - withoutSolver} answers equal in every bit, ${withoutSolver} undecided for want of GLPK, ${differing.length} different`);
process.exit(differing.length === 0 ? 0 : 1);
