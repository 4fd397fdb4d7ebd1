// Short ways to elements and numbers.

export function byId<Element extends HTMLElement = HTMLElement>(id: string): Element {
  const found = document.getElementById(id);
  if (!found) throw new Error(`no element ${id}`);
  return found as Element;
}

export const input = (id: string): HTMLInputElement => byId<HTMLInputElement>(id);
export const select = (id: string): HTMLSelectElement => byId<HTMLSelectElement>(id);

export const slide = (id: string, act: (value: number) => void): void => input(id).addEventListener('input', () => act(Number(input(id).value)));

/** Six digits, as people read them. */
export function shown(value: number, digits = 6): string {
  if (!Number.isFinite(value)) return '∞';
  return String(Number(value.toPrecision(digits))).replace('-', '−');
}

/** "1 contact", "2 contacts". */
export const counted = (count: number, what: string): string => `${count} ${what}${count === 1 ? '' : 's'}`;

/** A value that stays readable in a link. */
export const round = (value: number, digits = 6): number => Number(value.toPrecision(digits));

export function fill(list: HTMLElement, texts: string[]): void {
  list.replaceChildren(...texts.map((text) => Object.assign(document.createElement('li'), { textContent: text })));
}
