import 'uplot/dist/uPlot.min.css';
import './style.css';
import { isDark } from './colours';
import { Controls } from './controls';
import { Library } from './core';
import { byId } from './dom';
import { Explorer } from './explorer';
import { addHelp, listenToLecture } from './side';
import { Tour } from './tour';
import { glossary } from './words';

const root = document.documentElement;

addHelp();
const explorer = new Explorer(new Library());
new Controls(explorer);
new Tour(explorer);

byId('glossary-list').append(...glossary.flatMap(([word, text]) => [
  Object.assign(document.createElement('dt'), { textContent: word }),
  Object.assign(document.createElement('dd'), { textContent: text }),
]));
byId('open-glossary').onclick = () => byId<HTMLDialogElement>('glossary').showModal();

byId('copy-link').onclick = async () => {
  try {
    await navigator.clipboard.writeText(location.href);
    byId('copy-link').textContent = 'Copied';
  } catch {
    explorer.say(`The link of this view: ${location.href}`);
  }
  setTimeout(() => { byId('copy-link').textContent = 'Link'; }, 2000);
};

listenToLecture(() => explorer.redraw());
byId('beside').onclick = () => explorer.keepBeside();
byId('units').onclick = () => explorer.useUnits(explorer.view.units === 'si' ? 'scaled' : 'si');

function showTheme(): void {
  byId('theme').textContent = isDark() ? 'Light' : 'Dark';
  explorer.redraw();
}
byId('theme').onclick = () => {
  root.dataset.theme = isDark() ? 'light' : 'dark';
  showTheme();
};
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', showTheme);

for (const link of document.querySelectorAll<HTMLElement>('[data-skip]')) {
  link.onclick = (event) => {
    event.preventDefault();
    byId(link.dataset.skip!).focus();
  };
}

byId('theme').textContent = isDark() ? 'Light' : 'Dark';
explorer.setPlaying(explorer.isPlaying);
void explorer.begin();
