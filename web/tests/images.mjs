// The explorer's pictures in docs/images, of the page in out/web: tools/npm images.

import { chromium } from '@playwright/test';

const views = {
  wide: 'show=schedule&cells=300&phases=150:900&energy=20&pause=0.25&map=energy&magnified=60&time=0.93',
  contacts: 'show=polygon&cells=200&chains=2:1:2,2:2:1&period=2.58&split=0.3&map=contacts&magnified=50&time=0.05',
  response: 'show=forced&cells=60&phases=24:192&which=1&damping=0.02&place=tip&amplitude=0.0002&grid=60&least=0.8&most=1.4&map=response&magnified=30&time=0.1',
  scene: 'show=scene&words=clamp+100+gap%3D1e-3+140:1.3+clamp&hands=-4:2&from=0&span=16&magnified=60&time=0.13',
  dark: 'show=schedule&cells=300&phases=120:930&energy=20&pause=0.25&map=existence&magnified=60&time=0.25',
};
const root = new URL('../..', import.meta.url);
const browser = await chromium.launch({ executablePath: process.env.SIGNORINI_CHROMIUM ?? '/usr/bin/chromium', chromiumSandbox: false });
for (const [name, link] of Object.entries(views)) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 720 }, colorScheme: name === 'dark' ? 'dark' : 'light', reducedMotion: 'reduce' });
  await page.goto(`${new URL('out/web/index.html', root)}#${link}`);
  await page.locator('#mode option').first().waitFor({ state: 'attached' });
  if (name === 'contacts') await page.locator('#polygon option').first().waitFor({ state: 'attached' });
  if (name === 'response') {
    await page.getByText('each tried').waitFor();
    for (const way of ['up', 'down']) {
      await page.click(`#sweep-${way}`);
      await page.getByText(`${way}: 60 of 60`).waitFor();
    }
  }
  await page.waitForTimeout(300);
  await page.screenshot({ path: new URL(`docs/images/explorer_${name}.png`, root).pathname });
  await page.close();
}
await browser.close();
