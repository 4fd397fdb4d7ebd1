// Questions to the library and its answers. Every number of mechanics on this page comes from here.

import BridgeWorker from './worker?worker&inline';

/** Contact and free steps; 'L' touches the second stop. */
export type Phase = [number, number, 'L'?];
export type Phases = Phase[];
/** Of jumps: their number, turns, and the contact whose release is the last. */
export type Chain = [number, number, number];

/** "gap" and "second_stop" [m] where they are not those of the usual bar. */
export interface ScheduleMotion {
  show: 'schedule'; cells: number; phases: Phases; energy?: number; pause?: number; gap?: number; second_stop?: number;
}
export interface ModeMotion {
  show: 'mode'; contact: number; turns: number; period: number; cells: number;
}
/** Two contacts in a period; split of the contact time from the shortest first contact (0) to the longest (1). */
export interface PolygonMotion {
  show: 'polygon'; chains: Chain[]; period: number; split: number; cells: number;
}
export type Place = 'tip' | 'base';
export interface ForcedMotion {
  show: 'forced'; cells: number; phases: Phases; damping: number; place: Place; amplitude: number;
  which: number;
}
/** A forced motion, made a little smaller, is where "beside" starts. */
export type Start = { kind: 'rest' } | { kind: 'pluck'; place: number; displacement: number } | { kind: 'beside'; share: number };
export interface Simulation {
  show: 'simulation'; cells: number; start: Start; damping: number; crossings?: number;
  steps?: number; periods?: number; place?: Place; amplitude?: number;
  phases?: Phases; which?: number;
  from: number; span: number; frames: number;
}
/** Bars in a row, in the words of `signorini scene`; hands: how far each held bar is pulled [g], or how fast a free one flies [c g/L]. */
export interface SceneMotion {
  show: 'scene'; words: string; hands: number[]; gravity?: number; amplitude?: number; frequency?: number; from: number; span: number;
}
export type BarMotion = ScheduleMotion | ModeMotion | PolygonMotion | ForcedMotion | Simulation;
export type Motion = BarMotion | SceneMotion;

export type Question = { show: string } & Record<string, unknown>;

/** JSON of the library; "arrays" says where in the numbers each array is. */
export interface RawAnswer {
  error?: string;
  arrays?: Record<string, [number, number]>;
  [key: string]: unknown;
}

export class Answer {
  constructor(readonly json: RawAnswer, private readonly numbers: Float64Array) {}

  has(name: string): boolean {
    return this.json.arrays?.[name] !== undefined;
  }
  array(name: string): Float64Array {
    const [at, count] = this.json.arrays?.[name] ?? [0, 0];
    return this.numbers.subarray(at, at + count);
  }
}

declare global {
  /** Set by core.js, which stands beside the page: the library, packed by gzip, in base64. */
  var signoriniCore: string;
}

async function unpacked(base64: string): Promise<ArrayBuffer> {
  const text = atob(base64);
  const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

export class Library {
  private readonly worker = new BridgeWorker();
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private readonly ready: Promise<void>;
  private next = 1;

  constructor() {
    this.ready = unpacked(globalThis.signoriniCore).then((binary) => this.worker.postMessage({ id: 0, binary }, [binary]));
    this.worker.onmessage = (event: MessageEvent<{ id: number; answer: RawAnswer; numbers: Float64Array }>) => {
      const { id, answer, numbers } = event.data;
      this.waiting.get(id)?.(new Answer(answer, numbers));
      this.waiting.delete(id);
    };
  }

  /** Throws the library's one line where it refuses. */
  async ask(question: Question): Promise<Answer> {
    const id = this.next++;
    await this.ready;
    const answer = await new Promise<Answer>((resolve) => {
      this.waiting.set(id, resolve);
      this.worker.postMessage({ id, question });
    });
    if (answer.json.error) throw new Error(answer.json.error);
    return answer;
  }
}

/** Of questions that come faster than answers only the last is asked. */
export class Latest {
  private isBusy = false;
  private pending: (() => Promise<void>) | undefined;

  async run(task: () => Promise<void>): Promise<void> {
    if (this.isBusy) {
      this.pending = task;
      return;
    }
    this.isBusy = true;
    for (let now: (() => Promise<void>) | undefined = task; now; ) {
      await now();
      now = this.pending;
      this.pending = undefined;
    }
    this.isBusy = false;
  }
}
