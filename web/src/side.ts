// What stands beside the picture: tabs, help behind "?", the lecture view.

import { byId } from './dom';
import { controls } from './words';

const tabs = ['motion', 'curves', 'facts', 'take'] as const;
export type Panel = (typeof tabs)[number];

export const isShown = (panel: Panel): boolean => !byId(`panel-${panel}`).hidden;
let onPanel: (panel: Panel) => void = () => undefined;

export function showPanel(panel: Panel): void {
  for (const one of tabs) {
    byId(`panel-${one}`).hidden = one !== panel;
    byId(`tab-${one}`).setAttribute('aria-selected', String(one === panel));
    byId(`tab-${one}`).tabIndex = one === panel ? 0 : -1;
  }
  onPanel(panel);
}

export function listenToTabs(shows: (panel: Panel) => void): void {
  onPanel = shows;
  tabs.forEach((one, k) => {
    byId(`tab-${one}`).onclick = () => showPanel(one);
    byId(`tab-${one}`).onkeydown = (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) return;
      const next = tabs[(k + step + tabs.length) % tabs.length];
      showPanel(next);
      byId(`tab-${next}`).focus();
    };
  });
  showPanel('motion');
}

/** Two sentences and the formula behind a "?" at each control. */
export function addHelp(): void {
  for (const place of document.querySelectorAll<HTMLElement>('[data-control]')) {
    const { title, text, formula } = controls[place.dataset.control!];
    const details = Object.assign(document.createElement('details'), { className: 'help' });
    const summary = Object.assign(document.createElement('summary'), { textContent: '?', ariaLabel: `About: ${title}` });
    const box = document.createElement('div');
    box.append(text, Object.assign(document.createElement('code'), { textContent: formula }));
    details.append(summary, box);
    details.ontoggle = () => {
      if (!details.open) return;
      const { left, bottom, top } = summary.getBoundingClientRect();
      box.style.left = `${Math.max(8, Math.min(left, innerWidth - box.offsetWidth - 8))}px`;
      box.style.top = `${bottom + box.offsetHeight + 8 < innerHeight ? bottom + 4 : Math.max(8, top - box.offsetHeight - 4)}px`;
    };
    // On a telephone this is where the map is explained.
    if (place.id === 'map-title') box.insertBefore(Object.assign(document.createElement('p'), { id: 'map-key' }), box.lastChild);
    place.append(' ', details);
    if (place.closest('label')) details.classList.add('beside');
  }
  addEventListener('pointerdown', (event) => close((details) => !details.contains(event.target as Node)));
  addEventListener('keydown', (event) => { if (event.key === 'Escape') close(() => true); });
}

function close(which: (details: HTMLDetailsElement) => boolean): void {
  for (const details of document.querySelectorAll<HTMLDetailsElement>('.help[open]')) if (which(details)) details.open = false;
}

/** Bar and map alone, in large letters, on the whole screen where the browser lets it. */
export function listenToLecture(redraw: () => void): void {
  const set = (isOn: boolean): void => {
    document.body.classList.toggle('lecture', isOn);
    byId('lecture').textContent = isOn ? 'Back' : 'Lecture';
    redraw();
  };
  byId('lecture').onclick = () => {
    const isOn = !document.body.classList.contains('lecture');
    set(isOn);
    if (isOn) void document.documentElement.requestFullscreen?.().catch(() => undefined);
    else if (document.fullscreenElement) void document.exitFullscreen();
  };
  addEventListener('fullscreenchange', () => { if (!document.fullscreenElement) set(false); });
  addEventListener('keydown', (event) => { if (event.key === 'Escape' && document.body.classList.contains('lecture')) set(false); });
}
