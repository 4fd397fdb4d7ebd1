// From one contact to scenes of several bars; each step marks on the screen what it speaks of.

import { byId } from './dom';
import { showPanel } from './side';
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
    const { title, text, link, at } = tour[step];
    showPanel('motion');
    byId('tour').hidden = false;
    byId('tour-title').textContent = `${step + 1}. ${title}`;
    byId('tour-text').textContent = text;
    byId('tour-place').textContent = `${step + 1} of ${tour.length}`;
    byId<HTMLButtonElement>('tour-back').disabled = step === 0;
    byId('tour-next').textContent = step + 1 < tour.length ? 'Next' : 'Done';
    byId('tour-next').focus({ preventScroll: true });
    this.mark(at);
    // Of another kind of motion it is there only once that motion is.
    void this.explorer.follow(link).then(() => document.querySelector('.pointed')?.scrollIntoView({ block: 'nearest' }));
  }

  private mark(at?: string): void {
    document.querySelector('.pointed')?.classList.remove('pointed');
    if (at) document.querySelector(at)?.classList.add('pointed');
  }

  private end(): void {
    this.mark();
    byId('tour').hidden = true;
    byId('start-tour').focus();
  }
}
