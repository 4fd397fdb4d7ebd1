import { availableParallelism } from 'node:os';
import { defineConfig } from '@playwright/test';

export default defineConfig({
  testDir: 'tests',
  testMatch: '*.spec.ts',
  timeout: 180_000,
  expect: { timeout: 30_000 },
  // The page has a thread for itself and one for the library.
  workers: Math.max(1, Math.floor(availableParallelism() / 2)),
  fullyParallel: true,
  reporter: 'dot',
  outputDir: '../build/web-tests',
  use: {
    viewport: { width: 1280, height: 900 },
    launchOptions: {
      executablePath: process.env.SIGNORINI_CHROMIUM ?? '/usr/bin/chromium',
      chromiumSandbox: false,
    },
  },
});
