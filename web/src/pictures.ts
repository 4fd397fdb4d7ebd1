// Views as PNG and SVG.

import type { Drawing } from './bar';
import { tones } from './colours';
import type { Explorer } from './explorer';
import type { Plot } from './plots';
import { SvgContext } from './svg';

export interface Picture { label: string; file: string; png: () => Promise<Blob>; svg: () => Promise<Blob> }

interface Drawable {
  canvas: HTMLCanvasElement;
  draw(context: Drawing, width: number, height: number, ratio: number): void;
}

const asSvg = (text: string): Blob => new Blob([text], { type: 'image/svg+xml' });

function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext('2d')!;
  context.fillStyle = tones().paper;
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(canvas, 0, 0);
  return new Promise((resolve, reject) => {
    copy.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the picture could not be made'))));
  });
}

function ofCanvas(label: string, file: string, view: Drawable): Picture {
  const size = (): [number, number] => [view.canvas.clientWidth || 640, view.canvas.clientHeight || 230];
  return {
    label, file,
    png: () => {
      const copy = document.createElement('canvas');
      const [width, height] = size();
      [copy.width, copy.height] = [width * devicePixelRatio, height * devicePixelRatio];
      view.draw(copy.getContext('2d')!, width, height, devicePixelRatio);
      return pngOf(copy);
    },
    svg: async () => {
      const [width, height] = size();
      const context = new SvgContext(view.canvas);
      view.draw(context as unknown as Drawing, width, height, 1);
      return asSvg(context.asText(width, height, label));
    },
  };
}

function ofPlot(label: string, file: string, plot: Plot): Picture {
  return { label, file, png: () => pngOf(plot.canvas), svg: async () => asSvg(await plot.svg(label)) };
}

export function pictures(explorer: Explorer): Picture[] {
  const { tip, force, strain, velocity, faces, pushes } = explorer.plots;
  if (explorer.film?.isScene) return [ofCanvas('Bars', 'bars', explorer.bar), ofPlot('Faces', 'faces', faces), ofPlot('Forces', 'forces', pushes)];
  return [
    ofPlot('Map', 'map', explorer.map.plot), ofCanvas('Bar', 'bar', explorer.bar), ofCanvas('u(x, t)', 'surface', explorer.surface),
    ofPlot('Tip', 'tip', tip), ofPlot('Force', 'force', force),
    ...(explorer.answer?.has('s0') ? [ofPlot('Strain', 'strain', strain), ofPlot('Velocity', 'velocity', velocity)] : []),
  ];
}
