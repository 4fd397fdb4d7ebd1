// Curves, by uPlot: one look for all of them, and new values in place of old ones while one drags.

import uPlot from 'uplot';
import { tones } from './colours';
import { recorded } from './svg';
import { inUnit, unitOf, units, type Quantity } from './units';

type Map1 = (value: number) => number;

export interface Axes {
  x: [string, Quantity]; y: [string, Quantity];
  logY?: boolean;
  spreadX?: { there: Map1; back: Map1; ticks: number[] };
  xRange?: [number, number]; yRange?: [number, number];
  zoom?: boolean;
  isDragged?: boolean;  // what is drawn, so that the frame is not
  yTicks?: number[];
}

type Draw = (plot: uPlot) => void;

/** How much larger letters are in the lecture view. */
export const letters = (): number => (document.body.classList.contains('lecture') ? (innerWidth > 700 ? 1.6 : 1.15) : 1);
export const fontOf = (size = 13): string => `${Math.round(size * letters())}px system-ui, sans-serif`;

/** Where a value stands on the canvas, in its own dots. */
export function at(plot: uPlot, x: number, y: number): [number, number] {
  return [plot.valToPos(x, 'x', true), plot.valToPos(y, 'y', true)];
}

/** A line through points, or what they are the corners of. */
export function trace(c: CanvasRenderingContext2D, how: 'stroke' | 'fill', ...points: [number, number][]): void {
  c.beginPath();
  points.forEach(([x, y], k) => (k === 0 ? c.moveTo(x, y) : c.lineTo(x, y)));
  if (how === 'fill') c.closePath();
  c[how]();
}

export class Plot {
  private plot: uPlot | undefined;
  private look = '';  // of what `plot` was made: as long as it stays, values change in place
  private isStale = false;
  private data: uPlot.AlignedData = [[]];
  private series: uPlot.Series[] = [];
  private axes: Axes = { x: ['', 'time'], y: ['', 'time'] };
  private draw: Draw = () => undefined;
  private readonly cursor = document.createElement('div');
  private place: number | undefined;
  private isZoomed = false;
  /** What moves over the plot, on a sheet of its own: it costs no drawing of what stands. */
  drawOver: (plot: uPlot, c: CanvasRenderingContext2D) => void = () => undefined;
  private readonly sheet = document.createElement('canvas');

  constructor(private readonly host: HTMLElement) {
    this.cursor.className = 'time-cursor';
    this.cursor.hidden = true;
    new ResizeObserver(() => {
      if (!this.isVisible) return;
      const { width, height } = this.size();
      if (this.isStale) this.update();
      else if (this.plot && (this.plot.width !== width || this.plot.height !== height)) this.plot.setSize({ width, height });
      this.moveCursor();
    }).observe(host);
  }

  get inner(): uPlot | undefined { return this.plot; }
  private get isVisible(): boolean { return this.host.clientWidth > 0; }

  private size(): { width: number; height: number } {
    return { width: Math.max(this.host.clientWidth, 120), height: Math.max(this.host.clientHeight, 90) };
  }

  private options(size: { width: number; height: number }, scales?: { x: [number, number]; y: [number, number] }): uPlot.Options {
    const { ink, grid } = tones();
    const { axes } = this;
    const [font, k] = [fontOf(), letters()];
    const axis = ([name, what]: [string, Quantity], isY: boolean): uPlot.Axis => {
      const splits = isY ? axes.yTicks : axes.spreadX?.ticks;
      const unit = unitOf(what);
      return {
        label: unit ? `${name} [${unit}]` : name, labelFont: font, font, stroke: ink, labelSize: 18 * k, labelGap: 0, size: (isY ? 46 : 26) * k, gap: 3, space: (isY ? 26 : 60) * k,
        grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1, size: 4 },
        values: (_: uPlot, all: number[]) => all.map((v) => (v === null ? '' : String(Number(inUnit(what, v).toPrecision(6))))),
        ...(splits ? { splits: () => splits, filter: (_: uPlot, all: number[]) => all } : {}),
      };
    };
    const range = (which: 'xRange' | 'yRange', zoomed: [number, number] | undefined): uPlot.Scale =>
      zoomed ? { min: zoomed[0], max: zoomed[1], range: (_, low, high) => [low, high] as [number, number] }
        : axes[which] ? { range: (_, low, high) => (axes.zoom && this.isZoomed ? [low, high] : this.axes[which]!) as [number, number] } : {};
    return {
      ...size,
      legend: { show: false },
      cursor: { show: Boolean(axes.zoom), points: { show: false }, drag: { x: !axes.isDragged, y: !axes.isDragged, setScale: !axes.isDragged, dist: 6 } },
      scales: {
        x: { time: false, ...(axes.spreadX ? { distr: 100, fwd: axes.spreadX.there, bwd: axes.spreadX.back } : {}), ...range('xRange', scales?.x) } as uPlot.Scale,
        y: { ...(axes.logY ? { distr: 3, log: 10 } : {}), ...range('yRange', scales?.y) },
      },
      axes: [axis(axes.x, false), axis(axes.y, true)],
      series: [{}, ...this.series],
      hooks: { draw: [(plot: uPlot) => {
        plot.ctx.save();
        plot.ctx.beginPath();
        plot.ctx.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
        plot.ctx.clip();
        this.draw(plot);
        if (plot === this.plot) this.redrawOver();
        else this.drawOver(plot, plot.ctx);
        plot.ctx.restore();
      }] },
    };
  }

  show(axes: Axes, data: uPlot.AlignedData, series: uPlot.Series[], draw: Draw = () => undefined): void {
    Object.assign(this, { axes, data, series, draw });
    if (this.isVisible) this.update();
    else this.isStale = true;
  }

  private update(): void {
    this.isStale = false;
    const { axes, series } = this;
    const look = JSON.stringify([axes.x, axes.y, axes.logY, axes.isDragged, Boolean(axes.xRange), Boolean(axes.yRange), axes.yTicks, axes.spreadX?.ticks,
      series.map(({ stroke, width }) => [stroke, width]), tones(), units.system, letters()]);
    if (this.plot && look === this.look) {
      this.plot.setData(this.data, !this.isZoomed);
      return this.moveCursor();
    }
    this.look = look;
    this.isZoomed = false;
    this.plot?.destroy();
    this.plot = new uPlot(this.options(this.size()), this.data, this.host);
    this.plot.over.addEventListener('mousedown', () => { this.isZoomed = true; });
    this.plot.over.append(this.cursor);
    this.sheet.className = 'sheet';
    this.plot.over.append(this.sheet);
    this.redrawOver();
    this.moveCursor();
    this.onPlot?.(this.plot);
  }

  onPlot: ((plot: uPlot) => void) | undefined;

  redrawOver(): void {
    const { plot, sheet } = this;
    if (!plot) return;
    const { left, top, width, height } = plot.bbox;
    if (sheet.width !== width || sheet.height !== height) [sheet.width, sheet.height] = [width, height];
    const c = sheet.getContext('2d')!;
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, width, height);
    c.translate(-left, -top);
    this.drawOver(plot, c);
  }

  redraw(): void { this.plot?.redraw(false, true); }

  /** What is shown at first. */
  whole(): { x: [number, number]; y: [number, number] } {
    return { x: this.axes.xRange ?? [0, 1], y: this.axes.yRange ?? [0, 1] };
  }
  get spread(): Axes['spreadX'] { return this.axes.spreadX; }

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
    if (this.place !== undefined && this.plot && this.isVisible) {
      this.cursor.style.transform = `translateX(${this.plot.valToPos(this.place, 'x')}px)`;
    }
  }

  /** To be saved, whether it is on the screen or not. */
  get canvas(): HTMLCanvasElement {
    if (this.isStale || !this.plot) this.update();
    const { canvas } = this.plot!.ctx;
    const both = Object.assign(document.createElement('canvas'), { width: canvas.width, height: canvas.height });
    const c = both.getContext('2d')!;
    c.drawImage(canvas, 0, 0);
    c.drawImage(this.sheet, this.plot!.bbox.left, this.plot!.bbox.top);
    return both;
  }

  async svg(title: string): Promise<string> {
    if (this.isStale || !this.plot) this.update();
    const plot = this.plot!;
    const scales = { x: [plot.scales.x.min, plot.scales.x.max], y: [plot.scales.y.min, plot.scales.y.max] } as
      { x: [number, number]; y: [number, number] };
    const size = { width: Math.max(plot.width, 480), height: Math.max(plot.height, 140) };
    const context = await recorded(async () => {
      const copy = new uPlot(this.options(size, scales), this.data, document.createElement('div'));
      await new Promise((resolve) => setTimeout(resolve));
      copy.destroy();
    });
    const ratio = devicePixelRatio;
    return context.asText(size.width * ratio, size.height * ratio, title);
  }
}
