// u(x, t): a map over the period, and the same as a relief of lines.

import { Film, type Drawing } from './bar';
import { diverging, palette, tones } from './colours';

const [leftRoom, bottomRoom, topRoom, rightRoom] = [52, 40, 16, 14];
const reliefRun = 0.14;  // of the width, how far the relief runs into the depth

export class SurfaceView {
  private readonly context: Drawing;
  private readonly image = document.createElement('canvas');
  private readonly cursor: HTMLElement;
  film: Film | undefined;
  isRelief = false;
  private share = 0;

  constructor(readonly canvas: HTMLCanvasElement, host: HTMLElement) {
    this.context = canvas.getContext('2d')!;
    this.cursor = document.createElement('div');
    this.cursor.className = 'time-cursor';
    host.append(this.cursor);
    new ResizeObserver(() => this.paint()).observe(canvas);
  }

  show(film: Film): void {
    this.film = film;
    this.paintImage();
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
    const table = Array.from({ length: 256 }, (_, k) => map(k / 255));
    for (let m = 0; m < width; ++m) {
      for (let i = 0; i < height; ++i) {
        const value = 0.5 + (0.5 * film.u[m * height + i]) / film.mostDisplacement;
        const colour = table[Math.round(255 * Math.min(Math.max(value, 0), 1))];
        const at = 4 * ((height - 1 - i) * width + m);
        pixels.data.set(colour, at);
        pixels.data[at + 3] = 255;
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
    this.cursor.hidden = this.isRelief;
    this.cursor.style.transform = `translateX(${leftRoom + share * this.box().width}px)`;
    this.cursor.style.top = `${topRoom}px`;
    this.cursor.style.height = `${this.box().height}px`;
  }

  recolour(): void {
    this.paintImage();
    this.paint();
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
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = paper;
    c.fillRect(0, 0, width, height);
    if (!film) return;
    const box = this.box();
    c.font = '13px system-ui, sans-serif';
    if (this.isRelief) {
      this.drawRelief(c, film, box, ink, paper);
    } else {
      c.imageSmoothingEnabled = false;
      c.drawImage(this.image, leftRoom, topRoom, box.width, box.height);
      c.strokeStyle = ink;
      c.strokeRect(leftRoom, topRoom, box.width, box.height);
      // Contact: a bar along the tip's edge.
      c.fillStyle = palette.contact;
      const step = box.width / (film.times.length - 1);
      for (let m = 0; m + 1 < film.times.length; ++m) {
        if (Math.abs(film.force[m]) > 1e-9) c.fillRect(leftRoom + m * step, topRoom - 6, step + 0.5, 6);
      }
      c.fillStyle = ink;
      c.textAlign = 'right';
      c.textBaseline = 'middle';
      c.fillText('tip', leftRoom - 8, topRoom + 6);
      c.fillText('clamp', leftRoom - 8, topRoom + box.height - 6);
    }
    const timeWidth = this.isRelief ? (1 - reliefRun) * box.width : box.width;
    c.fillStyle = ink;
    c.textBaseline = 'top';
    for (let k = 0; k <= 4; ++k) {
      const t = film.begin + ((film.end - film.begin) * k) / 4;
      c.textAlign = k === 0 ? 'left' : k === 4 ? 'right' : 'center';
      c.fillText(String(Number(t.toPrecision(4))), leftRoom + (timeWidth * k) / 4, topRoom + box.height + 5);
    }
    c.textAlign = 'center';
    c.fillText('time t [L/c]', leftRoom + timeWidth / 2, topRoom + box.height + 22);
  }

  /** u over time for one place after the other, from the clamp at the back to the tip in front. */
  private drawRelief(c: Drawing, film: Film, box: { width: number; height: number }, ink: string, paper: string): void {
    const lines = 24;
    const lift = (0.34 * box.height) / film.mostDisplacement;
    const span = box.width - reliefRun * box.width;
    const count = Math.min(film.times.length, 600);
    for (let k = 0; k <= lines; ++k) {
      const depth = 1 - k / lines;
      const node = Math.round((film.nodes - 1) * (1 - depth));
      const left = leftRoom + depth * reliefRun * box.width;
      const level = topRoom + (0.66 - 0.4 * depth) * box.height;
      const trace = (): void => {
        c.beginPath();
        for (let j = 0; j < count; ++j) {
          const m = Math.round((j * (film.times.length - 1)) / (count - 1));
          const [x, y] = [left + (span * m) / (film.times.length - 1), level - lift * film.u[m * film.nodes + node]];
          if (j === 0) c.moveTo(x, y);
          else c.lineTo(x, y);
        }
      };
      // What lies behind is hidden.
      trace();
      c.lineTo(left + span, topRoom + box.height);
      c.lineTo(left, topRoom + box.height);
      c.closePath();
      c.fillStyle = paper;
      c.fill();
      trace();
      const isTip = k === lines;
      c.strokeStyle = isTip ? palette.strain : ink;
      c.lineWidth = isTip ? 2.5 : 1;
      c.stroke();
      c.lineWidth = 1;
    }
    c.fillStyle = ink;
    c.textAlign = 'right';
    c.textBaseline = 'middle';
    c.fillText('tip', leftRoom - 6, topRoom + 0.66 * box.height);
    c.textAlign = 'left';
    c.textBaseline = 'bottom';
    c.fillText('clamp', leftRoom + reliefRun * box.width, topRoom + 0.26 * box.height - 14);
  }
}
