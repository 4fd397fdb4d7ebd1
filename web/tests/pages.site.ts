// Every page of the site in a light window, a dark one and on a telephone: nothing on its console, no request that
// fails or leaves the folder, the scheme of the system, nothing wider than the screen, and letters of enough contrast.

import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { expect, test, type Page } from '@playwright/test';

const folder = process.env.SIGNORINI_SITE ?? resolve(import.meta.dirname, '../../out/docs');

/** All pages but the explorer's, which has tests of its own. */
function pages(): string[] {
  const all = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.html'));
  return all.filter((name) => !name.startsWith('explorer/') && !name.startsWith('_static/')).sort();
}

function watch(page: Page): string[] {
  const faults: string[] = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(String(error)));
  page.on('requestfailed', (request) => faults.push(`${request.url()}: ${request.failure()?.errorText}`));
  page.on('request', (request) => {
    const url = request.url();
    if (!url.startsWith(`file://${folder}/`) && !/^(blob|data|about):/.test(url)) faults.push(`request to ${url}`);
  });
  return faults;
}

/** 0 for black, 1 for white. */
const brightness = (page: Page): Promise<number> => page.evaluate(() => {
  const [r, g, b] = /(\d+), (\d+), (\d+)/.exec(getComputedStyle(document.body).backgroundColor)!.slice(1).map(Number);
  return (r + g + b) / 765;
});

test('the site has pages', () => {
  expect(pages().length).toBeGreaterThan(20);
});

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** What axe says of the contrast of letters, place by place. */
async function contrast(page: Page): Promise<string[]> {
  return page.evaluate(async () => {
    interface Found { violations: { nodes: { html: string; failureSummary?: string }[] }[] }
    const { run } = (globalThis as unknown as { axe: { run: (options: object) => Promise<Found> } }).axe;
    const { violations } = await run({ runOnly: ['color-contrast'], resultTypes: ['violations'] });
    return violations.flatMap((one) => one.nodes.map((node) => `${node.html.slice(0, 120)}: ${node.failureSummary?.split('\n')[1]}`)).slice(0, 5);
  });
}

for (const file of pages()) {
  test(file, async ({ page }) => {
    const faults = watch(page);
    await page.goto(`file://${join(folder, file)}`, { waitUntil: 'load' });
    await page.evaluate(axe);
    for (const [colorScheme, width] of [['light', 1280], ['dark', 1280], ['light', 390]] as const) {
      await page.emulateMedia({ colorScheme });
      await page.setViewportSize({ width, height: 844 });
      const white = await brightness(page);
      expect(white, colorScheme).toBeGreaterThan(colorScheme === 'light' ? 0.9 : 0);
      expect(white, colorScheme).toBeLessThan(colorScheme === 'light' ? 1.01 : 0.2);
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      // On a telephone the references, more than half of the pages, have the letters of the others.
      if (width > 400 || !file.startsWith('reference/')) expect(await contrast(page)).toEqual([]);
    }
    expect(faults).toEqual([]);
  });
}

// A symbol of C++, one of Python and a word, each on a page where it has to be found.
for (const [words, where] of [['findPeriodic', 'reference/cpp/'], ['signorini.simulate', 'reference/python/'], ['penetration', 'certificates.html']] as const) {
  test(`the search finds ${words}`, async ({ page }) => {
    await page.goto(`file://${join(folder, 'search.html')}?q=${words}`, { waitUntil: 'load' });
    await expect(page.locator(`#search-results a[href*="${where}"]`).first()).toBeVisible();
  });
}
