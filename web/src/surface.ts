// u(x, t): a map over the period, with the scale of its colours.

import { Film, type Drawing } from './bar';
import { diverging, drawScale, palette, tones } from './colours';
import { shown } from './dom';
import { fontOf } from './plots';
import { inUnit, unitOf } from './units';

const [leftRoom, bottomRoom, topRoom, rightRoom] = [44, 38, 12, 74];

export class SurfaceView {
  private readonly context: Drawing;
  private readonly image = document.createElement('canvas');
  private readonly cursor: HTMLElement;
  private isStale = false;
  film: Film | undefined;
  private share = 0;

  constructor(readonly canvas: HTMLCanvasElement, host: HTMLElement) {
    this.context = canvas.getContext('2d')!;
    this.cursor = document.createElement('div');
    this.cursor.className = 'time-cursor';
    host.append(this.cursor);
    new ResizeObserver(() => this.update()).observe(canvas);
  }

  /** Painted once it is on the screen. */
  show(film: Film): void {
    this.film = film;
    this.isStale = true;
    this.update();
  }

  private update(): void {
    if (this.canvas.clientWidth === 0) return;
    if (this.isStale) this.paintImage();
    this.isStale = false;
    this.paint();
  }

  private paintImage(): void {
    const { film } = this;
    if (!film) return;
    const [width, height] = [film.times.length, film.nodes];
    this.image.width = width;
    this.image.height = height;
    const c = this.image.getContext('2d')!;
    const pixels = c.createImageData(width, height);
    const map = diverging();
    // A dot is one word: opaque, blue, green, red.
    const table = Uint32Array.from({ length: 256 }, (_, k) => map(k / 255).reduceRight((word, part) => (word << 8) | part, 0xff));
    const dots = new Uint32Array(pixels.data.buffer);
    for (let m = 0; m < width; ++m) {
      for (let i = 0; i < height; ++i) {
        dots[(height - 1 - i) * width + m] = table[Math.round(127.5 + (127.5 * film.u[m * height + i]) / film.mostDisplacement)];
      }
    }
    c.putImageData(pixels, 0, 0);
  }

  private box(): { width: number; height: number } {
    return { width: this.canvas.clientWidth - leftRoom - rightRoom, height: this.canvas.clientHeight - topRoom - bottomRoom };
  }

  shareAt(x: number): number {
    return Math.min(Math.max((x - leftRoom) / this.box().width, 0), 1);
  }

  setCursor(share: number): void {
    this.share = share;
    if (this.canvas.clientWidth === 0) return;
    this.cursor.style.transform = `translateX(${leftRoom + share * this.box().width}px)`;
    this.cursor.style.top = `${topRoom}px`;
    this.cursor.style.height = `${this.box().height}px`;
  }

  recolour(): void {
    this.isStale = true;
    this.update();
  }

  paint(): void {
    const ratio = devicePixelRatio;
    this.canvas.width = Math.max(1, Math.round(this.canvas.clientWidth * ratio));
    this.canvas.height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    this.draw(this.context, this.canvas.clientWidth, this.canvas.clientHeight, ratio);
    this.setCursor(this.share);
  }

  draw(c: Drawing, width: number, height: number, ratio: number): void {
    const { film } = this;
    const { ink, paper } = tones();
    if (this.isStale) this.paintImage();
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = paper;
    c.fillRect(0, 0, width, height);
    if (!film) return;
    const box = { width: width - leftRoom - rightRoom, height: height - topRoom - bottomRoom };
    c.font = fontOf(12);
    c.imageSmoothingEnabled = false;
    c.drawImage(this.image, leftRoom, topRoom, box.width, box.height);
    c.strokeStyle = ink;
    c.strokeRect(leftRoom, topRoom, box.width, box.height);
    // Contact: a bar along the tip's edge.
    c.fillStyle = palette.contact;
    const { pathTimes, force } = film;
    for (let m = 0; m + 1 < pathTimes.length; ++m) {
      if (Math.abs(force[m]) <= 1e-9) continue;
      const from = m;
      while (m + 2 < pathTimes.length && Math.abs(force[m + 1]) > 1e-9) ++m;
      const place = (k: number): number => (box.width * (pathTimes[k] - film.begin)) / (film.end - film.begin);
      c.fillRect(leftRoom + place(from), topRoom - 6, place(m + 1) - place(from) + 0.5, 6);
    }
    c.fillStyle = ink;
    c.textAlign = 'right';
    c.textBaseline = 'middle';
    c.fillText('tip', leftRoom - 6, topRoom + 6);
    c.fillText('clamp', leftRoom - 6, topRoom + box.height - 6);
    this.drawScale(c, leftRoom + box.width + 10, box.height, film);
    c.textBaseline = 'top';
    for (let k = 0; k <= 4; ++k) {
      const t = film.begin + ((film.end - film.begin) * k) / 4;
      c.textAlign = k === 0 ? 'left' : k === 4 ? 'right' : 'center';
      c.fillText(shown(inUnit('time', t), 4), leftRoom + (box.width * k) / 4, topRoom + box.height + 4);
    }
    c.textAlign = 'center';
    c.fillText(`time t [${unitOf('time')}]`, leftRoom + box.width / 2, topRoom + box.height + 20);
  }

  /** Largest displacement to either side, and what colours lie between. */
  private drawScale(c: Drawing, x: number, height: number, film: Film): void {
    drawScale(c, x, topRoom, 12, height, diverging());
    c.fillStyle = tones().ink;
    c.textAlign = 'left';
    const most = shown(inUnit('displacement', film.mostDisplacement), 3);
    c.fillText(most, x + 16, topRoom + 6);
    c.fillText(`0 ${unitOf('displacement')}`, x + 16, topRoom + height / 2);
    c.fillText(`−${most}`, x + 16, topRoom + height - 6);
  }
}
