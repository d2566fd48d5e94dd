// Many browsers open the study at once.   class.mjs ADDRESS COUNT
// Ends with 1 when one of them does not come to the consent, or with all others behind it.
import { chromium } from "./person.mjs";

const [address, count] = [process.argv[2], Number(process.argv[3] ?? 60)];
const PROCESSES = 4;
const PATIENCE_MS = 180000;
const launch = () =>
  chromium.launch({
    executablePath: process.env.SEAMLINE_CHROMIUM,
    headless: true,
    args: ["--host-resolver-rules=MAP study.example.org 127.0.0.1"],
  });
const browsers = await Promise.all(Array.from({ length: PROCESSES }, launch));
/** A context is a browser of its own: storage, cache and connections. */
const pages = await Promise.all(
  Array.from({ length: count }, async (_, at) => {
    const context = await browsers[at % PROCESSES].newContext({ viewport: { width: 1280, height: 900 }, ignoreHTTPSErrors: true });
    return context.newPage();
  })
);

/** All of them do it at once; how many come to what they wait for, and where the others are. */
async function together(what, does, selector) {
  const begun = Date.now();
  const where = await Promise.all(
    pages.map(async (page) => {
      try {
        await does(page);
        await page.waitForSelector(selector, { timeout: PATIENCE_MS });
        return "there";
      } catch {
        return page.evaluate(() => document.body?.innerText.trim().slice(0, 120) || "nothing on the screen").catch(String);
      }
    })
  );
  const others = where.filter((one) => one !== "there");
  console.log("%s: %d of %d (%s s)", what, count - others.length, count, ((Date.now() - begun) / 1000).toFixed(1));
  for (const words of new Set(others)) console.log("  %d at: %s", others.filter((one) => one === words).length, words);
  return others.length === 0;
}

let isWhole = await together("come to the consent", (page) => page.goto(address, { waitUntil: "commit", timeout: PATIENCE_MS }), "#accept");
isWhole = isWhole && (await together("agree, and come to the form", (page) => page.click("#accept"), "#submit"));
await Promise.all(browsers.map((browser) => browser.close()));
process.exit(isWhole ? 0 : 1);
