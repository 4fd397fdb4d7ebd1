// What the tests of the page share: the built page from its folder, the command line, and a guard.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { expect, test as plain, type Page } from '@playwright/test';

const folder = resolve(import.meta.dirname, '../../out/web');
const program = process.env.SIGNORINI ?? resolve(import.meta.dirname, '../../build/release/bin/signorini');

export const address = (link = ''): string => `file://${folder}/index.html${link ? `#${link}` : ''}`;

/** Every page is watched: no error on its console, and no request out of its folder. */
export const test = plain.extend<{ watched: void }>({
  watched: [async ({ page }, use) => {
    const faults: string[] = [];
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) faults.push(message.text());
    });
    page.on('pageerror', (error) => faults.push(String(error)));
    page.on('request', (request) => {
      const url = request.url();
      if (!url.startsWith(`file://${folder}/`) && !/^(blob|data|about):/.test(url)) faults.push(`request to ${url}`);
    });
    await use();
    expect(faults).toEqual([]);
  }, { auto: true }],
});

/** Opens a view and waits for its motion. */
export async function open(page: Page, link = ''): Promise<void> {
  // A change behind # alone would not load the page anew.
  await page.goto('about:blank');
  await page.goto(address(link));
  await expect(page.locator('#headline')).not.toBeEmpty();
  await expect(page.locator('#mode option').first()).toBeAttached();
}

/** Runs the program in a fresh folder, with the files given, and returns its output and its files. */
export function commandLine(words: string[], files: Record<string, string> = {}, wanted: string[] = []): { out: string; files: Record<string, string> } {
  const place = mkdtempSync(join(tmpdir(), 'signorini-'));
  for (const [name, text] of Object.entries(files)) execFileSync('sh', ['-c', 'cat > "$1"', 'sh', join(place, name)], { input: text });
  const out = execFileSync(program, words, { cwd: place, encoding: 'utf8', maxBuffer: 2 ** 28, stdio: ['ignore', 'pipe', 'ignore'] });
  return { out, files: Object.fromEntries(wanted.map((name) => [name, readFileSync(join(place, name), 'utf8')])) };
}

/** One of the tabs beside the picture. */
export const panel = (page: Page, name: 'motion' | 'curves' | 'facts' | 'take'): Promise<void> => page.click(`#tab-${name}`);

/** The text that a button of "Take away" saves. */
export async function download(page: Page, file: string): Promise<string> {
  await panel(page, 'take');
  const [saved] = await Promise.all([page.waitForEvent('download'), page.locator(`[data-file="${file}"]`).first().click()]);
  return readFileSync(await saved.path(), 'utf8');
}

/** The words of the command that the page shows, without the program's name. */
export async function shownCommand(page: Page, line = 0): Promise<string[]> {
  await panel(page, 'take');
  const text = await page.locator('#command').innerText();
  const words = text.split('\n')[line].replace(/  #.*/, '');
  return [...words.matchAll(/"([^"]*)"|(\S+)/g)].map(([, quoted, plain]) => quoted ?? plain).slice(1);
}

/** A stopwatch is no answer. */
export const withoutStopwatch = (json: string): string => json.replace(/"seconds":[^,}]*/, '"seconds":0');

export async function slide(page: Page, id: string, value: number): Promise<void> {
  await page.locator(`#${id}`).evaluate((element, v) => {
    (element as HTMLInputElement).value = String(v);
    element.dispatchEvent(new Event('input', { bubbles: true }));
  }, value);
}
