// Six steps from one contact to forced resonance.

import { byId } from './dom';
import type { Explorer } from './explorer';
import { tour } from './words';

export class Tour {
  private step = 0;

  constructor(private readonly explorer: Explorer) {
    byId('start-tour').onclick = () => this.go(0);
    byId('tour-next').onclick = () => (this.step + 1 < tour.length ? this.go(this.step + 1) : this.end());
    byId('tour-back').onclick = () => this.go(Math.max(this.step - 1, 0));
    byId('tour-end').onclick = () => this.end();
    byId('tour').addEventListener('keydown', (event) => {
      if (event.key === 'Escape') this.end();
    });
  }

  private go(step: number): void {
    this.step = step;
    const { title, text, link } = tour[step];
    byId('tour').hidden = false;
    byId('tour-title').textContent = `${step + 1}. ${title}`;
    byId('tour-text').textContent = text;
    byId('tour-place').textContent = `${step + 1} of ${tour.length}`;
    byId<HTMLButtonElement>('tour-back').disabled = step === 0;
    byId('tour-next').textContent = step + 1 < tour.length ? 'Next' : 'Done';
    this.explorer.follow(link);
    byId('tour-next').focus({ preventScroll: true });
  }

  private end(): void {
    byId('tour').hidden = true;
    byId('start-tour').focus();
  }
}
