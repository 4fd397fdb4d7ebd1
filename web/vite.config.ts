// One classic script, one style sheet, and the library packed into base64: opens from a folder, fetches
// nothing.

import { readFileSync } from 'node:fs';
import { gzipSync } from 'node:zlib';
import { defineConfig, type Plugin } from 'vite';

const core = process.env.SIGNORINI_WEB_CORE ?? '../build/emscripten/bin';
const palette = new URL('../src/draw/palette.hpp', import.meta.url);

/** The colours of src/draw/palette.hpp, which is the one place that knows them. */
function colours(): string {
  const text = readFileSync(palette, 'utf8');
  const one = (name: string): string => {
    const found = new RegExp(`\\b${name} = "(#[0-9a-f]{6})"`).exec(text);
    if (!found) throw new Error(`palette.hpp: no colour ${name}`);
    return found[1];
  };
  const list = (name: string): string[] => {
    const found = new RegExp(`std::array ${name}\\{([^}]*)\\}`).exec(text);
    if (!found) throw new Error(`palette.hpp: no colours ${name}`);
    return found[1].split(',').map((word) => /"(#[0-9a-f]{6})"/.exec(word)?.[1] ?? one(word.trim()));
  };
  const names = ['ink', 'strain', 'velocity', 'contact', 'faint', 'grid'];
  return JSON.stringify({
    ...Object.fromEntries(names.map((name) => [name, one(name)])),
    sequence: list('sequence'),
    diverging: list('diverging'),
  });
}

/** Modules that are made of files outside this folder. */
function made(): Plugin {
  const modules: Record<string, () => string> = {
    'virtual:palette': () => `export const palette = ${colours()};`,
    'virtual:core-glue': () => `${readFileSync(`${core}/core.js`, 'utf8')}\nexport default createCore;`,
  };
  return {
    name: 'made',
    resolveId: (id) => (id in modules ? `\0${id}` : undefined),
    load: (id) => modules[id.slice(1)]?.(),
  };
}

/** Scripts from a folder must be classic ones, and the style sheet takes its colours from the palette. */
function classic(): Plugin {
  return {
    name: 'classic',
    enforce: 'post',
    transformIndexHtml: {
      order: 'post',
      handler: (html) => {
        const { strain, velocity, contact, faint, grid } = JSON.parse(colours()) as Record<string, string>;
        const tones = { strain, velocity, contact, faint, grid };
        const style = Object.entries(tones).map(([name, colour]) => `--${name}:${colour}`).join(';');
        return html
          .replace(/<script type="module" crossorigin src="([^"]*)"><\/script>/, '')
          .replace(/ crossorigin/g, '')
          .replace('</head>', `<style>:root{${style}}</style></head>`)
          .replace('</body>', '<script src="./core.js"></script><script src="./explorer.js"></script></body>');
      },
    },
    generateBundle() {
      const binary = gzipSync(readFileSync(`${core}/core.wasm`), { level: 9 }).toString('base64');
      this.emitFile({ type: 'asset', fileName: 'core.js', source: `globalThis.signoriniCore="${binary}";\n` });
    },
  };
}

export default defineConfig({
  base: './',
  plugins: [made(), classic()],
  worker: { plugins: () => [made()], format: 'iife' },
  build: {
    outDir: '../out/web',
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: false,
    rollupOptions: {
      checks: { pluginTimings: false },
      output: { format: 'iife', entryFileNames: 'explorer.js', assetFileNames: 'explorer[extname]' },
    },
  },
});
