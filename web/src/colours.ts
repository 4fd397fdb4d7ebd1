// Colours: those of every figure of the project, and what light and dark make of them.

import { palette } from 'virtual:palette';

export { palette };

export function isDark(): boolean {
  const chosen = document.documentElement.dataset.theme;
  return chosen ? chosen === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
}

/** Ink and paper change places in the dark; colours that mean something stay. */
export function tones(): { ink: string; paper: string; grid: string; faint: string } {
  return isDark()
    ? { ink: '#f0f0f0', paper: '#16191d', grid: '#3a3f45', faint: palette.faint }
    : { ink: palette.ink, paper: '#ffffff', grid: palette.grid, faint: palette.faint };
}

type Colour = [number, number, number];

function parts(colour: string): Colour {
  return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)) as Colour;
}

/** A map from [0, 1] through the given colours, straight between them. */
export function through(colours: string[]): (share: number) => Colour {
  const stops = colours.map(parts);
  return (share) => {
    const place = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
    const at = Math.min(Math.floor(place), stops.length - 2);
    const rest = place - at;
    return stops[at].map((value, k) => Math.round(value + rest * (stops[at + 1][k] - value))) as Colour;
  };
}

/** From compression (0) through nothing (1/2) to tension (1). */
export function diverging(): (share: number) => Colour {
  const middle = isDark() ? '#4a4f55' : palette.diverging[1];
  return through([palette.diverging[0], middle, palette.diverging[2]]);
}

/** What the colours of a map mean, from left to right; or upwards, where it is higher than wide. */
export function drawScale(c: CanvasRenderingContext2D, x: number, y: number, wide: number, high: number, map: (share: number) => Colour): void {
  const steps = 64;
  for (let k = 0; k < steps; ++k) {
    c.fillStyle = asText(map(k / (steps - 1)));
    if (wide > high) c.fillRect(x + (wide * k) / steps, y, wide / steps + 0.6, high);
    else c.fillRect(x, y + high - (high * (k + 1)) / steps, wide, high / steps + 0.6);
  }
}

export const asText = (colour: Colour): string => `rgb(${colour.join(',')})`;
