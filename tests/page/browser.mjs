// A report in a real browser: headless Chromium, driven by playwright-core of analysis/page. Whatever the page complains of or
// asks the network for is a fault, which the test that opened it fails on.

import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const fromPage = createRequire(new URL("../../analysis/page/package.json", import.meta.url));
const { chromium } = fromPage("playwright-core");
const axe = readFileSync(fromPage.resolve("axe-core/axe.min.js"), "utf8");

export const THEMES = ["light", "dark"];
export const WIDE = { width: 1280, height: 900 };
export const NARROW = { width: 390, height: 844 };

const QUIET = ["--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const SOFTWARE_GL = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];

/** Chromium; CHROMIUM names another one than Debian's. Close it at the end. */
export function launch() {
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    headless: true,
    args: ["--no-sandbox", ...QUIET, ...SOFTWARE_GL],
  });
}

/** A page with the report at an address (the part after #), once its view is there.
 * @returns the page and its `faults`, to which it adds whatever goes wrong on it from now on */
export async function openReport(browser, file, { address = "/", size = WIDE, theme = "light" } = {}) {
  const context = await browser.newContext({ viewport: size, colorScheme: theme, acceptDownloads: true });
  const page = await context.newPage();
  const faults = watch(page);
  await page.goto(`${pathToFileURL(resolve(file))}#${address}`);
  await viewIsThere(page);
  return { page, faults };
}

/** Goes to another view of the report that a page shows. */
export async function goTo(page, address) {
  await page.evaluate((there) => (location.hash = there), address);
  await viewIsThere(page);
}

/** Fails the test where a page had faults. */
export function failOnErrors(faults, where) {
  check(faults.length === 0, `${where}: ${faults.join("\n  ")}`);
}

/** What axe-core finds on a page that is serious or critical, one line each. */
export async function accessibilityFaults(page) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return violations
    .filter(({ impact }) => impact === "serious" || impact === "critical")
    .flatMap(({ id, help, nodes }) => nodes.map((node) => `${id} (${help}): ${node.target.join(" ")} ${node.html.slice(0, 160)}`));
}

/** How far the page is wider than the window, px: 0 where nothing has to be scrolled sideways. */
export function overflow(page) {
  return page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
}

/** @throws Error with what is wrong */
export function check(holds, message) {
  if (!holds) throw new Error(message);
}

/** Runs a test's parts one after the other in one browser; the process ends with 1 where one fails. */
export async function run(parts) {
  const browser = await launch();
  let failed = 0;
  for (const [name, part] of Object.entries(parts)) {
    try {
      await part(browser);
      console.log(`ok      ${name}`);
    } catch (error) {
      failed += 1;
      console.log(`FAILED  ${name}\n  ${error.stack}`);
    }
  }
  await browser.close();
  process.exitCode = failed ? 1 : 0;
}

function watch(page) {
  const faults = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && faults.push(`console: ${message.text()}`));
  page.on("pageerror", (error) => faults.push(`exception: ${error.message}`));
  page.on("request", (request) => /^(file|data|blob):/.test(request.url()) || faults.push(`request: ${request.url()}`));
  return faults;
}

/** main.ts says by data-view which address it shows. */
function viewIsThere(page) {
  return page.waitForFunction(
    () => document.querySelector("main[data-view]")?.dataset.view === (location.hash.slice(1).split("?")[0] || "/"),
    undefined,
    { timeout: 60_000 },
  );
}
