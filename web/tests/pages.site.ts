// Every page of the site in a light window and a small dark one: nothing on its console, no request that
// fails or leaves the folder, and the scheme of the system.

import { readdirSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';
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

for (const colorScheme of ['light', 'dark'] as const) {
  test.describe(colorScheme, () => {
    test.use({ colorScheme, viewport: { width: colorScheme === 'light' ? 1280 : 390, height: 844 } });
    for (const name of pages()) {
      test(name, async ({ page }) => {
        const faults = watch(page);
        await page.goto(`file://${join(folder, name)}`, { waitUntil: 'load' });
        const white = await brightness(page);
        expect(white, relative(folder, name)).toBeGreaterThan(colorScheme === 'light' ? 0.9 : 0);
        expect(white).toBeLessThan(colorScheme === 'light' ? 1.01 : 0.2);
        expect(faults).toEqual([]);
      });
    }
  });
}

// A symbol of C++, one of Python and a word, each on a page where it has to be found.
for (const [words, where] of [['findPeriodic', 'reference/cpp/'], ['signorini.simulate', 'reference/python/'], ['penetration', 'certificates.html']] as const) {
  test(`the search finds ${words}`, async ({ page }) => {
    await page.goto(`file://${join(folder, 'search.html')}?q=${words}`, { waitUntil: 'load' });
    await expect(page.locator(`#search-results a[href*="${where}"]`).first()).toBeVisible();
  });
}
