// Curves, by uPlot: one look for all of them.

import uPlot from 'uplot';
import { tones } from './colours';
import { recorded } from './svg';

const font = '13px system-ui, sans-serif';

export interface Axes {
  x: string; y: string;
  logY?: boolean;
  xRange?: [number, number]; yRange?: [number, number];
  zoom?: boolean;
  isDragged?: boolean;  // what is drawn, so that the frame is not
  yTicks?: (value: number) => string;
}

type Draw = (plot: uPlot) => void;

/** Where a value stands on the canvas, in its own dots. */
export function at(plot: uPlot, x: number, y: number): [number, number] {
  return [plot.valToPos(x, 'x', true), plot.valToPos(y, 'y', true)];
}

export class Plot {
  private plot: uPlot | undefined;
  private data: uPlot.AlignedData = [[]];
  private series: uPlot.Series[] = [];
  private axes: Axes = { x: '', y: '' };
  private draw: Draw = () => undefined;
  private readonly cursor = document.createElement('div');
  private place: number | undefined;

  constructor(private readonly host: HTMLElement) {
    this.cursor.className = 'time-cursor';
    this.cursor.hidden = true;
    new ResizeObserver(() => {
      const { width, height } = this.size();
      if (this.plot && (this.plot.width !== width || this.plot.height !== height)) this.plot.setSize({ width, height });
      this.moveCursor();
    }).observe(host);
  }

  get inner(): uPlot | undefined { return this.plot; }

  private size(): { width: number; height: number } {
    return { width: Math.max(this.host.clientWidth, 120), height: Math.max(this.host.clientHeight, 90) };
  }

  private options(size: { width: number; height: number }, scales?: { x: [number, number]; y: [number, number] }): uPlot.Options {
    const { ink, grid } = tones();
    const { axes } = this;
    const axis = (label: string, isY: boolean): uPlot.Axis => ({
      label, labelFont: font, font, stroke: ink, labelSize: 20, size: isY ? 56 : 34,
      grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1, size: 5 },
      ...(isY && axes.yTicks ? { values: (_: uPlot, all: number[]) => all.map((v) => (v === null ? '' : axes.yTicks!(v))) } : {}),
    });
    const range = (fixed: [number, number] | undefined, zoomed: [number, number] | undefined): uPlot.Scale =>
      zoomed ? { min: zoomed[0], max: zoomed[1], range: (_, low, high) => [low, high] as [number, number] }
        : fixed ? { range: (_, low, high) => (axes.zoom && this.isZoomed ? [low, high] : fixed) as [number, number] } : {};
    return {
      ...size,
      legend: { show: false },
      cursor: { show: Boolean(axes.zoom), points: { show: false }, drag: { x: !axes.isDragged, y: !axes.isDragged, setScale: !axes.isDragged, dist: 6 } },
      scales: {
        x: { time: false, ...range(axes.xRange, scales?.x) },
        y: { ...(axes.logY ? { distr: 3, log: 10 } : {}), ...range(axes.yRange, scales?.y) },
      },
      axes: [axis(axes.x, false), axis(axes.y, true)],
      series: [{}, ...this.series],
      hooks: { draw: [(plot: uPlot) => {
        plot.ctx.save();
        plot.ctx.beginPath();
        plot.ctx.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
        plot.ctx.clip();
        this.draw(plot);
        plot.ctx.restore();
      }] },
    };
  }

  private isZoomed = false;

  show(axes: Axes, data: uPlot.AlignedData, series: uPlot.Series[], draw: Draw = () => undefined): void {
    this.axes = axes;
    this.data = data;
    this.series = series;
    this.draw = draw;
    this.isZoomed = false;
    this.plot?.destroy();
    this.plot = new uPlot(this.options(this.size()), data, this.host);
    this.plot.over.addEventListener('mousedown', () => { this.isZoomed = true; });
    this.plot.over.append(this.cursor);
    this.moveCursor();
    this.onPlot?.(this.plot);
  }

  onPlot: ((plot: uPlot) => void) | undefined;

  redraw(): void { this.plot?.redraw(false, true); }

  /** What is shown at first. */
  whole(): { x: [number, number]; y: [number, number] } {
    return { x: this.axes.xRange ?? [0, 1], y: this.axes.yRange ?? [0, 1] };
  }

  /** Shows a part; without one the whole. */
  zoom(x?: [number, number], y?: [number, number]): void {
    const { plot } = this;
    if (!plot) return;
    this.isZoomed = x !== undefined;
    const whole = this.whole();
    plot.batch(() => {
      plot.setScale('x', { min: (x ?? whole.x)[0], max: (x ?? whole.x)[1] });
      plot.setScale('y', { min: (y ?? whole.y)[0], max: (y ?? whole.y)[1] });
    });
  }

  /** A line over the plot that costs no drawing. */
  setCursor(place: number | undefined): void {
    this.place = place;
    this.moveCursor();
  }

  private moveCursor(): void {
    this.cursor.hidden = this.place === undefined || !this.plot;
    if (this.place !== undefined && this.plot) {
      this.cursor.style.transform = `translateX(${this.plot.valToPos(this.place, 'x')}px)`;
    }
  }

  get canvas(): HTMLCanvasElement | undefined { return this.plot?.ctx.canvas; }

  async svg(title: string): Promise<string> {
    const { plot } = this;
    if (!plot) throw new Error('there is no plot');
    const scales = { x: [plot.scales.x.min, plot.scales.x.max], y: [plot.scales.y.min, plot.scales.y.max] } as
      { x: [number, number]; y: [number, number] };
    const size = this.size();
    const context = await recorded(async () => {
      const copy = new uPlot(this.options(size, scales), this.data, document.createElement('div'));
      await new Promise((resolve) => setTimeout(resolve));
      copy.destroy();
    });
    const ratio = devicePixelRatio;
    return context.asText(size.width * ratio, size.height * ratio, title);
  }
}
