// The pages of the site (tools/docs), opened by the browser that opens the explorer.

import explorer from './playwright.config';

export default { ...explorer, testMatch: '*.site.ts', outputDir: '../build/docs/browser' };
