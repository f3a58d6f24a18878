// The page's frame, its overview and its provenance, in a browser. REPORT and RESULTS name another report and the file that it is
// of, for the values.

import { NARROW, THEMES, WIDE, accessibilityFaults, check, failOnErrors, goTo, openReport, overflow, run } from "./browser.mjs";
import { python, sampleReports } from "./sample.mjs";

const sample = sampleReports();
const whole = process.env.REPORT ? { report: process.env.REPORT, results: process.env.RESULTS } : sample.whole;
const VIEWS = ["/", "/explore", "/case", "/data", "/nowhere"];

const strategies = (page) => page.getByRole("region", { name: "The strategies" });
const names = (page) => strategies(page).locator("tbody th").allInnerTexts();

async function everyViewIsSoundInBothThemes(browser) {
  for (const theme of THEMES) {
    for (const [where, size] of [["wide", WIDE], ["at 390 px", NARROW]]) {
      const { page, faults } = await openReport(browser, whole.report, { theme, size });
      const id = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent).overview.counts.length);
      check(id > 0, "the report has no strategies");
      for (const view of VIEWS) {
        await goTo(page, view);
        for (const details of await page.locator("main details:not([open]) > summary").all()) if (await details.isVisible()) await details.click();
        const found = await accessibilityFaults(page);
        check(found.length === 0, `${view}, ${theme}, ${where}: axe-core finds\n  ${found.join("\n  ")}`);
        check((await overflow(page)) <= 0, `${view}, ${theme}, ${where}: wider than the window by ${await overflow(page)} px`);
        check((await page.locator("main h1").count()) === 1, `${view}: not one h1`);
      }
      failOnErrors(faults, `${theme}, ${where}`);
      await page.context().close();
    }
  }
}

async function theOverviewAnswersTheQuestion(browser) {
  const { page, faults } = await openReport(browser, sample.whole.report);
  check((await page.locator("h1").innerText()).startsWith("Which strategy leaves least of the organ in the tool"), "no question");
  const answer = await page.locator(".answer").innerText();
  check(answer.startsWith("careful ranks first by"), `the answer is ${answer}`);
  check((await names(page)).join() === "careful,middling,hasty", `strategies in order ${await names(page)}`);
  check((await page.locator(".diagrams figure svg").count()) > 0, "no critical-difference diagram");
  check((await page.title()) === "Overview · made up", `title ${await page.title()}`);
  failOnErrors(faults, "overview");
}

async function headingsSort(browser) {
  const { page } = await openReport(browser, sample.whole.report);
  const heading = strategies(page).getByRole("columnheader", { name: /^handling, 99/ });
  await heading.getByRole("button").click();
  check((await heading.getAttribute("aria-sort")) === "ascending", "aria-sort is not ascending");
  check((await names(page)).join() === "hasty,middling,careful", `by time: ${await names(page)}`);
  await heading.getByRole("button").press("Enter");
  check((await heading.getAttribute("aria-sort")) === "descending", "aria-sort is not descending");
  check((await names(page)).join() === "careful,middling,hasty", `by time, slowest first: ${await names(page)}`);
  check((await strategies(page).locator("[aria-sort]").count()) === 1, "several headings say that they sort");
}

/** Any ten values of the case view, in full. */
async function valuesAreThoseOfTheFile(browser) {
  const { page } = await openReport(browser, whole.report);
  const shown = await page.evaluate(() => JSON.parse(document.getElementById("report").textContent).columns.filter((c) => c.role === "figure").map((c) => c.name));
  const picks = Array.from({ length: 10 }, () => [shown[Math.floor(Math.random() * shown.length)], Math.random()]);
  const file = python(["-c", READ, whole.results, JSON.stringify(picks)]);
  for (const { caseId, figure, value } of JSON.parse(file)) {
    await goTo(page, `/case/${caseId}`);
    const row = page.locator("table tr").filter({ has: page.getByText(figure, { exact: true }) }).first();
    await row.waitFor();
    const said = await row.locator("td").first().innerText();
    check(value === null ? /^(–|none)/.test(said) : Number(said) === value, `${figure} of ${caseId}: the file has ${value}, the page says ${said}`);
  }
}

const READ = `
import h5py, json, math, sys
file = h5py.File(sys.argv[1])
found = []
for figure, place in json.loads(sys.argv[2]):
    values = file["cases"][figure][...]
    row = int(place * len(values))
    value = float(values[row])
    found.append({"caseId": file["cases/case_id"][row].decode(), "figure": figure, "value": None if math.isnan(value) else value})
print(json.dumps(found))
`;

/** The overview's medians are those of the cases; every strategy of the sample has a value in each. */
async function mediansAreThoseOfTheFile(browser) {
  const { page } = await openReport(browser, sample.whole.report);
  const file = JSON.parse(python(["-c", MEDIANS, sample.whole.results]));
  for (const row of await strategies(page).locator("tbody tr").all()) {
    const label = await row.locator("th").innerText();
    const shown = await row.locator(".median").evaluateAll((all) => all.map((one) => Number(one.dataset.value)));
    check(JSON.stringify(shown) === JSON.stringify(file[label]), `${label}: the page has ${shown}, the file ${file[label]}`);
  }
}

const MEDIANS = `
import h5py, json, numpy, sys
cases = h5py.File(sys.argv[1])["cases"]
labels = cases["label"].asstr()[...]
figures = ("depth_max_d_max", "drag_mean", "time_handle_p99")
print(json.dumps({label: [float(numpy.median(cases[name][...][labels == label])) for name in figures] for label in set(labels)}))
`;

async function theThemeIsToggled(browser) {
  const { page } = await openReport(browser, sample.whole.report, { theme: "light" });
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await background();
  await page.getByRole("button", { name: "Dark theme" }).click();
  check((await page.evaluate(() => document.documentElement.dataset.theme)) === "dark", "data-theme is not dark");
  check((await background()) !== light, "the page looks the same");
  await page.getByRole("button", { name: "Light theme" }).click();
  check((await background()) === light, "the page does not go back");
}

async function theKeyboardReachesEverything(browser) {
  const { page } = await openReport(browser, sample.whole.report);
  await page.keyboard.press("Tab");
  check((await page.evaluate(() => document.activeElement.textContent)) === "Skip to the content", "the skip link is not first");
  await page.keyboard.press("Enter");
  check((await page.evaluate(() => document.activeElement.id)) === "main", "the skip link does not go to the content");
  check((await page.evaluate(() => document.querySelector("main").dataset.view)) === "/", "the skip link left the view");
  await page.getByRole("link", { name: "Data & provenance" }).press("Enter");
  await page.locator('main[data-view="/data"]').waitFor();
  check((await page.evaluate(() => document.activeElement.id)) === "main", "the new view has no focus");
  check((await page.getByRole("link", { name: "Data & provenance" }).getAttribute("aria-current")) === "page", "no aria-current");
}

async function provenanceSaysHowToMakeItAgain(browser) {
  const { page } = await openReport(browser, sample.whole.report, { address: "/data" });
  const text = await page.locator("main").innerText();
  for (const words of ["trocar run made-up.toml", 'strategies = ["careful"', "GNU 12", "depth_max", "trocar report whole.h5"]) {
    check(text.includes(words), `the view does not say ${words}`);
  }
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.getByRole("button", { name: "Copy the command", exact: true }).click();
  await page.getByText(/^(copied|selected)/).waitFor();
}

async function failuresAreSaid(browser) {
  for (const [name, words] of [["half", "42 of 84 cases failed"], ["failed", "No case completed"], ["single", "only strategy"], ["single", "No ranks by"]]) {
    const { page, faults } = await openReport(browser, sample[name].report);
    const text = await page.locator("main").innerText();
    check(text.includes(words), `${name}: the overview does not say ${words}:\n${text.slice(0, 2000)}`);
    for (const chart of await page.locator("figure.chart .chart-drawing").all()) {
      await chart.locator("svg, .empty").first().waitFor(); // fails where a chart stays blank
    }
    for (const view of VIEWS) await goTo(page, view);
    failOnErrors(faults, name);
  }
}

async function damageIsSaid(browser) {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto(`file://${sample.whole.report}`);
  const damaged = (await page.content()).replace(/<div id="app">.*?<script type="application\/json"/s, '<div id="app"></div><script type="application/json"').replace(/(id="columns\/[^"]+">)[^<]{9}/g, "$1");
  await page.setContent(damaged);
  await page.getByRole("heading", { name: "This cannot be shown" }).waitFor();
  check((await page.getByRole("alert").innerText()).length > 60, "the error page says nothing");
}

await run({
  everyViewIsSoundInBothThemes,
  theOverviewAnswersTheQuestion,
  headingsSort,
  valuesAreThoseOfTheFile,
  mediansAreThoseOfTheFile,
  theThemeIsToggled,
  theKeyboardReachesEverything,
  provenanceSaysHowToMakeItAgain,
  failuresAreSaid,
  damageIsSaid,
});
