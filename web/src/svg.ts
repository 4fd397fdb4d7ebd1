// A drawing context that writes SVG: what a view draws on its canvas it can draw into a file.

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

const number = (value: number): string => String(Number(value.toFixed(2)));

const ruler = document.createElement('canvas').getContext('2d')!;

/** The same steps as Path2D. */
export class SvgPath {
  d = '';
  moveTo(x: number, y: number): void { this.d += `M${number(x)} ${number(y)}`; }
  lineTo(x: number, y: number): void { this.d += `L${number(x)} ${number(y)}`; }
  closePath(): void { this.d += 'Z'; }
  rect(x: number, y: number, w: number, h: number): void {
    this.d += `M${number(x)} ${number(y)}h${number(w)}v${number(h)}h${number(-w)}Z`;
  }
  arc(x: number, y: number, r: number, from: number, to: number): void {
    const whole = Math.abs(to - from) >= 2 * Math.PI - 1e-9;
    const at = (angle: number): string => `${number(x + r * Math.cos(angle))} ${number(y + r * Math.sin(angle))}`;
    const arcTo = (angle: number): string => `A${number(r)} ${number(r)} 0 0 1 ${at(angle)}`;
    this.d += `M${at(from)}${arcTo((from + to) / 2)}${arcTo(to)}${whole ? 'Z' : ''}`;
  }
  addPath(path: SvgPath): void { this.d += path.d; }
}

interface Style {
  fillStyle: string; strokeStyle: string; lineWidth: number; font: string; textAlign: string;
  textBaseline: string; globalAlpha: number; lineJoin: string; lineCap: string; dash: number[];
  matrix: DOMMatrix; clips: number;
}

export class SvgContext {
  fillStyle = '#000'; strokeStyle = '#000'; lineWidth = 1; font = '10px sans-serif';
  textAlign = 'start'; textBaseline = 'alphabetic'; globalAlpha = 1; lineJoin = 'miter'; lineCap = 'butt';
  imageSmoothingEnabled = true;
  private dash: number[] = [];
  private matrix = new DOMMatrix();
  private clips = 0;
  private clipCount = 0;
  private path = new SvgPath();
  private readonly stack: Style[] = [];
  private body = '';

  constructor(readonly canvas: HTMLCanvasElement) {}

  asText(width: number, height: number, title: string): string {
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}">` +
      `<title>${escaped(title)}</title>${this.body}${'</g>'.repeat(this.clips)}</svg>\n`;
  }

  private place(): string {
    const m = this.matrix;
    return m.isIdentity ? '' : ` transform="matrix(${[m.a, m.b, m.c, m.d, m.e, m.f].map(number).join(' ')})"`;
  }
  private pen(): string {
    const dash = this.dash.length > 0 ? ` stroke-dasharray="${this.dash.join(' ')}"` : '';
    return ` fill="none" stroke="${this.strokeStyle}" stroke-width="${number(this.lineWidth)}"` +
      ` stroke-opacity="${this.globalAlpha}" stroke-linejoin="${this.lineJoin}" stroke-linecap="${this.lineCap}"${dash}`;
  }
  private brush(): string { return ` fill="${this.fillStyle}" fill-opacity="${this.globalAlpha}"`; }

  save(): void {
    const { fillStyle, strokeStyle, lineWidth, font, textAlign, textBaseline, globalAlpha, lineJoin, lineCap, dash, clips } = this;
    this.stack.push({ fillStyle, strokeStyle, lineWidth, font, textAlign, textBaseline, globalAlpha, lineJoin, lineCap, dash, clips,
      matrix: DOMMatrix.fromMatrix(this.matrix) });
  }
  restore(): void {
    const style = this.stack.pop();
    if (!style) return;
    this.body += '</g>'.repeat(this.clips - style.clips);
    Object.assign(this, style);
  }
  translate(x: number, y: number): void { this.matrix.translateSelf(x, y); }
  rotate(angle: number): void { this.matrix.rotateSelf((angle * 180) / Math.PI); }
  scale(x: number, y: number): void { this.matrix.scaleSelf(x, y); }
  setTransform(a: number, b: number, c: number, d: number, e: number, f: number): void { this.matrix = new DOMMatrix([a, b, c, d, e, f]); }
  setLineDash(dash: number[]): void { this.dash = dash; }
  beginPath(): void { this.path = new SvgPath(); }
  moveTo(x: number, y: number): void { this.path.moveTo(x, y); }
  lineTo(x: number, y: number): void { this.path.lineTo(x, y); }
  closePath(): void { this.path.closePath(); }
  rect(x: number, y: number, w: number, h: number): void { this.path.rect(x, y, w, h); }
  arc(x: number, y: number, r: number, from: number, to: number): void { this.path.arc(x, y, r, from, to); }
  clip(path?: SvgPath): void {
    const id = `clip${++this.clipCount}`;
    this.body += `<clipPath id="${id}"><path d="${(path instanceof SvgPath ? path : this.path).d}"${this.place()}/></clipPath><g clip-path="url(#${id})">`;
    ++this.clips;
  }
  stroke(path?: SvgPath): void { this.body += `<path d="${(path ?? this.path).d}"${this.pen()}${this.place()}/>`; }
  fill(path?: SvgPath | string): void {
    this.body += `<path d="${(path instanceof SvgPath ? path : this.path).d}"${this.brush()}${this.place()}/>`;
  }
  fillRect(x: number, y: number, w: number, h: number): void {
    this.body += `<rect x="${number(x)}" y="${number(y)}" width="${number(w)}" height="${number(h)}"${this.brush()}${this.place()}/>`;
  }
  strokeRect(x: number, y: number, w: number, h: number): void {
    this.body += `<rect x="${number(x)}" y="${number(y)}" width="${number(w)}" height="${number(h)}"${this.pen()}${this.place()}/>`;
  }
  clearRect(): void { /* a new file has nothing to clear */ }
  measureText(text: string): TextMetrics {
    ruler.font = this.font;
    return ruler.measureText(text);
  }
  fillText(text: string, x: number, y: number): void {
    const anchor = { center: 'middle', right: 'end', end: 'end' }[this.textAlign] ?? 'start';
    const base = { middle: 'central', top: 'hanging', bottom: 'text-after-edge' }[this.textBaseline] ?? 'alphabetic';
    this.body += `<text x="${number(x)}" y="${number(y)}" style="font:${escaped(this.font).replaceAll('&quot;', "'")}" text-anchor="${anchor}" dominant-baseline="${base}"${this.brush()}${this.place()}>${escaped(text)}</text>`;
  }
  drawImage(image: HTMLCanvasElement, x: number, y: number, w: number, h: number): void {
    this.body += `<image href="${image.toDataURL()}" x="${number(x)}" y="${number(y)}" width="${number(w)}" height="${number(h)}" preserveAspectRatio="none"${this.place()}/>`;
  }
}

/**
 * Runs a drawing with every canvas recording instead of painting, and returns what was drawn last.
 * Only for a moment in which nothing else draws: uPlot takes its context and Path2D from the window.
 */
export async function recorded(draw: () => Promise<void> | void): Promise<SvgContext> {
  const { getContext } = HTMLCanvasElement.prototype;
  const { Path2D } = globalThis;
  let last: SvgContext | undefined;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement) {
    return (last = new SvgContext(this));
  } as unknown as typeof getContext;
  globalThis.Path2D = SvgPath as unknown as typeof Path2D;
  try {
    await draw();
  } finally {
    HTMLCanvasElement.prototype.getContext = getContext;
    globalThis.Path2D = Path2D;
  }
  if (!last) throw new Error('nothing was drawn');
  return last;
}
