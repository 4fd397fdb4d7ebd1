/** The colours of src/draw/palette.hpp, read when the page is built (vite.config.ts). */
declare module 'virtual:palette' {
  export const palette: {
    ink: string; strain: string; velocity: string; contact: string; faint: string; grid: string;
    sequence: string[]; diverging: string[];
  };
}
/** The glue that Emscripten makes, as a module. */
declare module 'virtual:core-glue' {
  export interface Core {
    HEAPF64: Float64Array;
    ccall(name: string, result: string, types: string[], values: unknown[]): unknown;
  }
  const createCore: (options: { wasmBinary: ArrayBuffer }) => Promise<Core>;
  export default createCore;
}
