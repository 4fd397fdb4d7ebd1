// What the reader takes along is that of the command line: answers, files, sweeps; and pictures.

import { readFileSync } from 'node:fs';
import { expect } from '@playwright/test';
import { commandLine, download, open, panel, shownCommand, test, withoutStopwatch } from './page';

const headline = '#headline';

const scenes: [string, string, string, string][] = [
  // A bar pressed by g: (450, 300) is the top of the family (4, 5, 3).
  ['pressed', 'T = 2.5 L/c', 'g = −1 mm', '90 60'],
  ['touching', 'T = 2.5 L/c', 'g = 0 mm', '30 120'],
  ['stops', 'L:(75, 375) on 300 cells: T = 3 L/c', 'second stop at −1 mm', '15 75 L:15 75'],
];
for (const [scene, says, bar, small] of scenes) {
  test(`scene “${scene}”: a motion, and the command that gives the same`, async ({ page }) => {
    await open(page);
    await page.selectOption('#scene', scene);
    await expect(page.locator(headline)).toContainText(says);
    await expect(page.locator('#computed')).toContainText(bar);
    // The same on few cells: of 300 the file of the motion has a quarter of a million rows.
    await page.fill('#schedule-text', small);
    await page.fill('#schedule-cells', '60');
    await page.click('#schedule-form button');
    await expect(page.locator(headline)).toContainText('on 60 cells');
    await expect(page.locator('#computed')).toContainText(bar);
    await expect(page.locator('#notice')).toBeHidden();
    const find = commandLine(await shownCommand(page), {}, ['state.csv', 'motion.csv']);
    expect(withoutStopwatch(await download(page, 'answer.json'))).toBe(withoutStopwatch(find.out));
    expect(await download(page, 'state.csv')).toBe(find.files['state.csv']);
    expect(await download(page, 'motion.csv')).toBe(find.files['motion.csv']);
  });
}

test('sweep: it fills in, and its rows are those of the command line', async ({ page }) => {
  await open(page, 'show=forced&cells=60&phases=24:192&which=1&damping=0.02&place=tip&amplitude=0.0002&grid=30&least=1.05&most=1.2&map=response&magnified=30');
  await page.click('#sweep-down');
  await expect(page.locator('#sweep-progress')).toContainText('60 of 60 frequencies');
  const sweep = commandLine(await shownCommand(page, 2), {}, ['sweep.csv']);
  expect(await download(page, 'sweep.csv')).toBe(sweep.files['sweep.csv']);
});

test('scene: two bars are those of the command line, contact by contact', async ({ page }) => {
  await open(page, 'show=scene&words=40:2+gap%3D1e-3+160&hands=1:0&from=0&span=6');
  const found = JSON.parse(commandLine(await shownCommand(page)).out) as { contacts: { count: number; impulse: number; peak_force: number }[] };
  await panel(page, 'facts');
  const text = await page.locator('#computed').innerText();
  const values = [...text.matchAll(/: (?:impulse|peak force)\s+([\d.e−-]+)/g)].map((row) => Number(row[1].replace('−', '-')));
  expect(text).toContain(`${found.contacts[0].count} time`);
  expect(values[0]).toBeCloseTo(found.contacts[0].impulse * 1e3, 4);
  expect(values[1]).toBeCloseTo(found.contacts[0].peak_force * 1e3, 4);
});

test('take away: JSON and CSV are those of the command shown beside them, to the last digit', async ({ page }) => {
  await open(page, 'show=schedule&cells=300&phases=150:900&energy=20');
  const find = commandLine(await shownCommand(page), {}, ['state.csv']);
  expect(withoutStopwatch(await download(page, 'answer.json'))).toBe(withoutStopwatch(find.out));
  expect(await download(page, 'state.csv')).toBe(find.files['state.csv']);

  await open(page, 'show=schedule&cells=60&phases=30:180&energy=12.5');
  const small = commandLine(await shownCommand(page), {}, ['motion.csv']);
  expect(await download(page, 'motion.csv')).toBe(small.files['motion.csv']);

  await open(page, 'show=schedule&cells=300&phases=150:900&energy=20&pause=0.25');
  const continuum = commandLine(await shownCommand(page), {}, ['state.csv']);
  expect(await download(page, 'answer.json')).toBe(continuum.out);
  expect(await download(page, 'state.csv')).toBe(continuum.files['state.csv']);

  await open(page, `show=mode&cells=200&contact=4&turns=-1&period=${Math.PI}`);
  expect(await download(page, 'answer.json')).toBe(commandLine(await shownCommand(page)).out);

  await open(page, 'show=polygon&cells=200&chains=2:1:2,2:2:1&period=2.58&split=0.3');
  const polygons = commandLine(await shownCommand(page), {}, ['polygons.csv']);
  expect(await download(page, 'answer.json')).toBe(polygons.out);
  expect(await download(page, 'polygons.csv')).toBe(polygons.files['polygons.csv']);
  // The second line is the motion on the grid whose period is nearest: its type has the same energy there.
  const nearest = JSON.parse(commandLine((await shownCommand(page, 1)).slice(0, 7).concat('--format', 'json')).out) as { period_ratio: number; energy_ratio: number };
  expect(nearest.energy_ratio).toBeCloseTo(1 / (2 * nearest.period_ratio - 5) ** 2, 6);

  await open(page, 'show=simulation&cells=200&start=0.6:-3&dashpot=0&crossings=40&from=0&span=16');
  const start = await download(page, 'start.csv');
  const simulation = commandLine(await shownCommand(page), { 'start.csv': start }, ['tip.csv', 'events.csv']);
  expect(await download(page, 'answer.json')).toBe(simulation.out);
  expect(await download(page, 'tip.csv')).toBe(simulation.files['tip.csv']);
  expect(await download(page, 'events.csv')).toBe(simulation.files['events.csv']);

  const families = commandLine(['families', '--csv', 'families.csv'], {}, ['families.csv']);
  expect(await download(page, 'families.csv')).toBe(families.files['families.csv']);
});

test('take away: what is forced and damped is that of the command line, too', async ({ page }) => {
  await open(page, 'show=forced&cells=60&phases=24:192&which=1&damping=0.02&place=tip&amplitude=0.0002');
  const find = commandLine(await shownCommand(page), {}, ['state.csv']);
  expect(find.out).toContain('"found"');
  expect(await download(page, 'answer.json')).toBe(find.out);
  expect(await download(page, 'state.csv')).toBe(find.files['state.csv']);

  await open(page, 'show=forced&cells=30&phases=12:96&which=1&map=response&damping=0.05&place=base&amplitude=0.0003&grid=30&least=1&most=1.2');
  await expect(page.locator('#progress')).toContainText('each tried');
  const response = commandLine(await shownCommand(page, 1), {}, ['response.csv']);
  expect(await download(page, 'response.csv')).toBe(response.files['response.csv']);
  expect(withoutStopwatch(await download(page, 'response.json'))).toBe(withoutStopwatch(response.out));
});

test('pictures: every view is saved as PNG and as SVG', async ({ page }) => {
  const buttons = page.locator('#pictures button');
  await open(page);
  await panel(page, 'take');
  const count = await buttons.count();
  expect(count).toBe(14);
  for (let k = 0; k < count; ++k) {
    // A browser may ask before it saves many files of one page.
    if (k % 4 === 0) await open(page);
    await panel(page, 'take');
    const button = buttons.nth(k);
    const [saved] = await Promise.all([page.waitForEvent('download'), button.click()]);
    const bytes = readFileSync(await saved.path());
    if (saved.suggestedFilename().endsWith('.png')) {
      expect(bytes.subarray(1, 4).toString()).toBe('PNG');
    } else {
      const problem = await page.evaluate((text) => {
        const svg = new DOMParser().parseFromString(text, 'image/svg+xml');
        return svg.querySelector('parsererror')?.textContent ?? (svg.querySelectorAll('path,rect,image').length < 3 ? 'nearly empty' : '');
      }, bytes.toString());
      expect(problem, saved.suggestedFilename()).toBe('');
    }
  }
});
