// The views of a report that go from all cases down to one: what filters change, what is saved, what is said of a point, and
// whether the command of a case runs that case.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { accessibilityFaults, check, failOnErrors, goTo, NARROW, openReport, overflow, run, THEMES } from "./browser.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const root = resolve(here, "../..");
const program = resolve(process.env.TROCAR ?? join(root, "build/trocar"));
const folder = mkdtempSync(join(tmpdir(), "trocar-explore-"));
process.on("exit", () => rmSync(folder, { recursive: true, force: true }));

function python(...words) {
  const env = { ...process.env, PYTHONPATH: join(root, "analysis") };
  return execFileSync("/usr/bin/python3", ["-B", ...words], { env, encoding: "utf8", maxBuffer: 1e8 });
}

function reportOf(file, ...words) {
  const report = file.replace(/\.h5$/, ".html");
  python("-m", "trocar_analysis", "report", file, "-o", report, ...words);
  return report;
}

const file = join(folder, "made_up.h5");
const cases = JSON.parse(python(join(here, "explore_results.py"), file));
const report = reportOf(file, "--better", "depth_max=low,time_handle=low");
const DEPTH = "depth_max_d_max";

const chart = (page, number) => page.locator("figure.chart").nth(number);
const drawing = (page, number) => chart(page, number).locator(".chart-drawing svg").first();
const drawn = (page, number) => drawing(page, number).evaluate((svg) => svg.innerHTML);
const chip = (page, name) => page.getByRole("button", { name, exact: true });

async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
}

function rowsOf(csv) {
  const [head, ...lines] = csv.trim().split("\n").map((line) => [...line.matchAll(/(?:"((?:[^"]|"")*)"|([^,]*))(?:,|$)/g)].map(([, a, b]) => a ?? b).slice(0, -1));
  return lines.map((cells) => Object.fromEntries(head.map((name, k) => [name, cells[k]])));
}

function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : sorted[middle - 1] + (sorted[middle] - sorted[middle - 1]) / 2;
}

/** What a chart shows once it no longer shows `before`. */
async function otherThan(page, number, before) {
  const isOther = ([number, before]) => document.querySelectorAll("figure.chart")[number].querySelector(".chart-drawing svg")?.innerHTML !== before;
  await page.waitForFunction(isOther, [number, before], { timeout: 20_000 }).catch(() => check(false, `chart ${number} did not change`));
  return drawn(page, number);
}

async function filtersChangeAllCharts(browser) {
  const { page, faults } = await openReport(browser, report, { address: "/explore" });
  const before = await Promise.all([0, 1, 2].map((number) => drawn(page, number)));
  await chip(page, "liver").click();
  await page.getByText(`${cases.length / 3} of ${cases.length} cases`).waitFor();
  const after = await Promise.all(before.map((text, number) => otherThan(page, number, text)));
  check(page.url().includes("only=organ%3Dliver"), `the filter is not in the address: ${page.url()}`);
  await page.reload();
  await page.getByText(`${cases.length / 3} of ${cases.length} cases`).waitFor();
  check((await chip(page, "liver").getAttribute("aria-pressed")) === "true", "the address did not restore the filter");
  check((await drawn(page, 0)) === after[0], "the address did not restore the chart");
  await page.getByRole("button", { name: "Clear filters" }).click();
  check((await drawn(page, 0)) === before[0], "without filters the chart is another one than at first");
  failOnErrors(faults, "explore");
}

async function savedDataIsTheFiles(browser) {
  const { page } = await openReport(browser, report, { address: `/explore?figure=${DEPTH}&x=speed&across=organ&down=scene` });
  const groups = rowsOf((await saved(page, chart(page, 0).getByRole("button", { name: /^Save as CSV/ }))).text);
  const complete = cases.filter(({ status }) => status === "complete");
  check(groups.length === 36, `36 groups expected, the CSV has ${groups.length}`);
  for (const group of groups) {
    const of = (one) => one.label === group.strategy && one.organ === group.organ && one.scene === group.scene && one.speed === Number(group.speed);
    const values = complete.filter(of).map((one) => one[DEPTH]).filter((value) => value !== null);
    const expected = median(values);
    check(Math.abs(Number(group.median) - expected) <= 1e-14 * expected, `median ${group.median} of ${JSON.stringify(group)}, expected ${expected}`);
    check(Number(group.cases) === cases.filter(of).length, `cases of ${JSON.stringify(group)}`);
    check(Number(group.failed) === cases.filter(of).length - complete.filter(of).length, `failed of ${JSON.stringify(group)}`);
    check(Number(group.without_value) === complete.filter(of).length - values.length, `without value: ${JSON.stringify(group)}`);
  }
  const pairs = rowsOf((await saved(page, chart(page, 2).getByRole("button", { name: /^Save as CSV/ }))).text);
  check(pairs.length > 20, `only ${pairs.length} pairs`);
  for (const pair of pairs) {
    const [a, b] = [pair.case_a, pair.case_b].map((id) => cases.find(({ case_id }) => case_id === id));
    check(Math.abs(Number(pair.value_a) - a[DEPTH]) < 1e-14 * a[DEPTH] && Math.abs(Number(pair.value_b) - b[DEPTH]) < 1e-14 * b[DEPTH], `values of ${JSON.stringify(pair)}`);
    check(["organ", "scene", "speed", "seed"].every((name) => a[name] === b[name]) && a.label !== b.label, `no pair: ${JSON.stringify(pair)}`);
  }
}

async function savedPictureNeedsNothing(browser) {
  for (const theme of THEMES) {
    const { page } = await openReport(browser, report, { address: "/explore", theme });
    const { text, name } = await saved(page, chart(page, 0).getByRole("button", { name: /^Save as SVG/ }));
    check(name.endsWith(".svg"), name);
    check(!/var\(|class=|<style|href/.test(text), `the saved SVG needs the page: ${/.{60}(var\(|class=|<style|href).{60}/.exec(text)?.[0]}`);
    for (const words of ["nearest-face", "fuzzy, always penetration", "lower is better", "diverged"]) check(text.includes(words), `the saved SVG does not say ${words}`);
    const isWhite = /<rect[^>]*fill="rgb\(255, 255, 255\)"/.test(text);
    check(isWhite === (theme === "light"), `the background of the saved SVG is not that of the ${theme} theme`);
    const colours = new Set(text.match(/stroke="rgb\([^"]*"/g));
    check(colours.size >= 4, `the saved SVG has ${colours.size} colours of lines`);
  }
}

async function pointsSayWhatTheyAre(browser) {
  const { page } = await openReport(browser, report, { address: `/explore?figure=${DEPTH}&only=organ%3Dsheet` });
  const tip = chart(page, 0).locator(".tooltip");
  await drawing(page, 0).focus();
  await page.keyboard.press("Home");
  await tip.getByText(/^n = \d+ of 3 cases/).waitFor();
  const said = await tip.innerText();
  check(/median [\d.]{10,} mm/.test(said), `no exact median in: ${said}`);
  check(said.includes("no vertex inside"), `the missing value is not said in: ${said}`);
  await page.keyboard.press("ArrowRight");
  check((await tip.innerText()) !== said, "an arrow key did not go to another point");
  await page.keyboard.press("Home");
  const ring = await chart(page, 0).locator(".hover-ring").boundingBox();
  await page.keyboard.press("Escape");
  await tip.waitFor({ state: "hidden" });
  await page.mouse.move(ring.x + ring.width / 2, ring.y + ring.height / 2);
  await tip.waitFor();
  check((await tip.innerText()) === said, `the pointer says something else than the keys: ${await tip.innerText()}`);
  await page.mouse.down();
  await page.mouse.up();
  await page.getByRole("heading", { name: /^3 cases: / }).waitFor();
  await page.locator(".chosen a[href^='#/case/']").first().click();
  await page.getByRole("heading", { name: "What was run" }).waitFor();
}

async function whatIsMissingIsSaid(browser) {
  const { page } = await openReport(browser, report, { address: `/explore?figure=${DEPTH}` });
  const warning = await chart(page, 0).locator(".chart-warning").innerText();
  check(warning.includes("1 case failed (1 diverged)"), warning);
  check(warning.includes("12 cases without a value (12 no vertex inside)"), warning);
  const panels = await drawing(page, 0).evaluate((svg) => svg.textContent);
  check(panels.includes("1 failed") && panels.includes("6 no value"), "the panels do not say what is missing in them");
  await goTo(page, `/explore?figure=${DEPTH}&only=organ%3Dsheet&only=seed%3D1`);
  await chart(page, 0).getByText(`No case here has a value of ${DEPTH}`).waitFor();
  await goTo(page, "/explore?only=organ%3Dspleen");
  await page.getByText("The address asks for what this report does not have: organ=spleen.").waitFor();
}

async function aCase(browser) {
  const own = cases.find(({ seed, organ, label }) => seed === 1 && organ === "liver" && label === "nearest-face");
  const { page, faults } = await openReport(browser, report, { address: `/case/${own.case_id}` });
  await page.getByText("No value in 4 of 30 steps: no vertex collided in steps 0–2, 10.").waitFor();
  await page.getByRole("button", { name: "fuzzy, always penetration" }).waitFor();
  check(JSON.parse(await page.locator("tr", { hasText: DEPTH }).locator("td.number").innerText()) === own[DEPTH], "the figure is not the file's");
  const slider = page.getByRole("slider", { name: "step" });
  await slider.focus();
  for (let k = 0; k < 12; k++) await page.keyboard.press("ArrowRight");
  await page.getByText("step 12, ").waitFor();
  const cursors = await page.locator(".u-cursor-x").evaluateAll((lines) => lines.map((line) => line.style.transform));
  check(cursors.length > 1 && new Set(cursors).size === 1 && cursors[0] !== "", `cursors stand at ${cursors}`);
  await page.getByRole("link", { name: "cylinder-axis" }).click();
  await page.getByRole("heading", { level: 1, name: "cylinder-axis" }).waitFor();
  const failed = cases.find(({ status }) => status === "diverged");
  await goTo(page, `/case/${failed.case_id}`);
  await page.getByText("a vertex left the world").waitFor();
  failOnErrors(faults, "a case");
}

async function aCaseIsFound(browser) {
  const { page } = await openReport(browser, report, { address: "/case" });
  await page.getByRole("searchbox", { name: "search cases" }).fill("liver 400 nearest sliding");
  await page.getByText("3 cases", { exact: true }).waitFor();
  await goTo(page, "/case/nonsense");
  await page.getByText("This report has no case nonsense").waitFor();
  await page.getByRole("button", { name: "on →" }).click();
  await page.getByText(`51–100 of ${cases.length}`).waitFor();
}

async function theCommandRunsTheCase(browser) {
  const sweep = join(here, "explore.toml");
  const out = join(folder, "real.h5");
  execFileSync(program, ["run", sweep, "-o", out, "--metrics", "fast"], { stdio: "ignore" });
  const ids = JSON.parse(python("-c", "import json, sys; from trocar_analysis.store import ResultFile; print(json.dumps([*ResultFile(sys.argv[1]).cases_table().case_id]))", out));
  const { page } = await openReport(browser, reportOf(out), { address: `/case/${ids.at(-1)}` });
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.getByRole("button", { name: "Copy" }).click();
  await page.getByText("copied").waitFor();
  const command = await page.evaluate(() => navigator.clipboard.readText());
  const words = command.replace(/^trocar /, `'${program}' `);
  execFileSync("sh", ["-c", words], { cwd: folder, stdio: "ignore" });
  const again = join(folder, / -o (\S+)$/.exec(command)[1]);
  const ran = JSON.parse(python("-c", "import json, sys; from trocar_analysis.store import ResultFile; print(json.dumps([*ResultFile(sys.argv[1]).cases_table().case_id]))", again));
  check(ran.length === 1 && ran[0] === ids.at(-1), `${command}\nran ${ran}, expected ${ids.at(-1)}`);
}

/** Charts are drawn anew for another width. */
async function fits(page, address) {
  const isIn = () => document.documentElement.scrollWidth <= document.documentElement.clientWidth;
  await page.waitForFunction(isIn, undefined, { timeout: 10_000 }).catch(() => {});
  check((await overflow(page)) <= 0, `${address} is wider than a screen of ${NARROW.width} px`);
}

async function everyoneCanUseIt(browser) {
  const own = cases.find(({ seed }) => seed === 1);
  for (const theme of THEMES) {
    for (const address of ["/explore", "/case", `/case/${own.case_id}`]) {
      const { page } = await openReport(browser, report, { address, theme });
      const found = await accessibilityFaults(page);
      check(found.length === 0, `${address}, ${theme}:\n  ${found.join("\n  ")}`);
      await page.setViewportSize(NARROW);
      await fits(page, address);
      await page.context().close();
    }
  }
}

await run({
  "filters change all charts, and the address restores them": filtersChangeAllCharts,
  "saved data is the file's": savedDataIsTheFiles,
  "a saved picture needs nothing of the page": savedPictureNeedsNothing,
  "points say what they are, to pointer and keys": pointsSayWhatTheyAre,
  "what failed and what is missing is said": whatIsMissingIsSaid,
  "a case: series with one cursor, siblings, figures": aCase,
  "a case is found": aCaseIsFound,
  "the command of a case runs it": theCommandRunsTheCase,
  "accessible in both themes, and at 390 px": everyoneCanUseIt,
});
