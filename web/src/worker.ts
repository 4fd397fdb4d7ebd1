// The library, off the page's own thread: a question in, an answer with arrays out.

import createCore, { type Core } from 'virtual:core-glue';
import type { Question, RawAnswer } from './core';

let core: Promise<Core> | undefined;

function answer(bridge: Core, question: Question): { answer: RawAnswer; numbers: Float64Array } {
  const text = bridge.ccall('signoriniAnswer', 'string', ['string'], [JSON.stringify(question)]) as string;
  const at = bridge.ccall('signoriniNumbers', 'number', [], []) as number;
  const count = bridge.ccall('signoriniCount', 'number', [], []) as number;
  // Copied: the memory of the library is its own.
  return { answer: JSON.parse(text) as RawAnswer, numbers: bridge.HEAPF64.slice(at / 8, at / 8 + count) };
}

self.onmessage = async (event: MessageEvent<{ id: number; binary?: ArrayBuffer; question?: Question }>) => {
  const { id, binary, question } = event.data;
  if (binary) {
    core = createCore({ wasmBinary: binary });
    return;
  }
  try {
    if (!core || !question) throw new Error('the library is not loaded');
    const result = answer(await core, question);
    postMessage({ id, ...result }, { transfer: [result.numbers.buffer] });
  } catch (fault) {
    postMessage({ id, answer: { error: String(fault) }, numbers: new Float64Array() });
  }
};
