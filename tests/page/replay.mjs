// The replay: it draws, steps, and shows strategies as differently as they are; keyboard, address, pinned vertex and saved picture
// work; where there is no WebGL it says so.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { accessibilityFaults, check, failOnErrors, NARROW, openReport, overflow, run, THEMES, WIDE } from "./browser.mjs";

const here = import.meta.dirname;
const folder = mkdtempSync(join(tmpdir(), "trocar-replay-"));
const report = join(folder, "report.html");
const python = (...options) =>
  execFileSync("/usr/bin/python3", ["-B", ...options], { env: { ...process.env, PYTHONPATH: join(here, "../../analysis") }, stdio: ["ignore", "ignore", "inherit"] });
python(join(here, "replay_sample.py"), join(folder, "sample.h5"));
python("-m", "trocar_analysis", "report", join(folder, "sample.h5"), "-o", report);

/** The replay, once it is drawn. */
async function openReplay(browser, address, options = {}) {
  const opened = await openReport(browser, report, { address: `/replay/${address}`, ...options });
  await opened.page.waitForSelector("[data-drawn]");
  return opened;
}

/** What a view shows: a hash of its pixels, and how many colours they have. */
function pixels(page, view) {
  return page.evaluate((k) => {
    const canvas = document.querySelector(".replay-ground canvas");
    const around = canvas.getBoundingClientRect();
    const box = document.querySelectorAll(".replay-place")[k].getBoundingClientRect();
    const scale = canvas.width / around.width;
    const copy = new OffscreenCanvas(Math.floor(box.width * scale), Math.floor(box.height * scale));
    const context = copy.getContext("2d");
    context.drawImage(canvas, -Math.ceil((box.left - around.left) * scale), -Math.ceil((box.top - around.top) * scale));
    const words = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
    return { hash: words.reduce((hash, word) => (Math.imul(hash, 31) + word) | 0, 7), colours: new Set(words).size };
  }, view);
}

const step = (page, number) => page.waitForSelector(`[data-drawn="${number}"]`);

/** Does something, and waits until a view looks otherwise. */
async function looksOtherwise(page, does, what) {
  const before = await pixels(page, 0);
  await does();
  for (let tries = 0; tries < 100; tries++) {
    if ((await pixels(page, 0)).hash !== before.hash) return;
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  throw new Error(`${what} does not change what is seen`);
}

/** Waits until a view looks as it did: while things move it may be coarser. */
async function looksLike(page, { hash }, what) {
  for (let tries = 0; tries < 200; tries++) {
    if ((await pixels(page, 0)).hash === hash) return;
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  throw new Error(what);
}

await run({
  async "views are drawn and differ as the strategies do"(browser) {
    const { page, faults } = await openReplay(browser, "aa11,aa22?step=2");
    const [clears, leaves] = [await pixels(page, 0), await pixels(page, 1)];
    check(clears.colours > 100 && leaves.colours > 100, `views of ${clears.colours} and ${leaves.colours} colours are blank`);
    check(clears.hash !== leaves.hash, "two strategies look the same");
    check((await page.locator(".replay-cell").count()) === 2, "there are not two views");
    await page.getByText("9 moved").waitFor();
    failOnErrors(faults, "replay");
  },

  async "without cases in the address the first conditions are shown"(browser) {
    const { page, faults } = await openReplay(browser, "?step=0");
    check((await page.locator(".replay-caption strong").allTextContents()).join() === "clears,leaves", "not the cases of the first conditions");
    await page.getByLabel("Conditions").selectOption({ label: "penetration · sphere · prism-4 · 100 mm/s · seed 2" });
    await page.waitForFunction(() => document.querySelectorAll(".replay-cell").length === 1 && document.querySelector("[data-drawn]"));
    check(new URL(page.url()).hash.startsWith("#/replay/bb33"), "the address does not name the chosen case");
    failOnErrors(faults, "chooser");
  },

  async "the keyboard steps, changes the moment, turns and resets"(browser) {
    const { page, faults } = await openReplay(browser, "aa11,aa22?step=0");
    const press = (key) => page.keyboard.press(key);
    await looksOtherwise(page, () => press("ArrowRight"), "→");
    await step(page, 1);
    await press("End");
    await step(page, 4);
    await press("ArrowLeft");
    await step(page, 3);
    await press("Home");
    await step(page, 0);
    await looksOtherwise(page, () => press("1"), "1");
    check(await page.getByLabel("before handling").isChecked(), "1 does not choose the moment before handling");
    const start = await pixels(page, 0);
    await looksOtherwise(page, () => press("Shift+ArrowLeft"), "Shift+←");
    await looksOtherwise(page, () => press("+"), "+");
    await looksOtherwise(page, () => press("d"), "D");
    await looksOtherwise(page, () => press("r"), "R");
    await looksLike(page, start, "R does not bring the camera back");
    await press(" ");
    await page.getByRole("button", { name: "Pause" }).waitFor();
    await press(" ");
    await page.getByRole("button", { name: "Play" }).waitFor();
    failOnErrors(faults, "keyboard");
  },

  async "playing goes to the end"(browser) {
    const { page, faults } = await openReplay(browser, "aa11,aa22?step=0&speed=1");
    await page.getByRole("button", { name: "Play" }).click();
    await step(page, 4);
    await page.getByRole("button", { name: "Play" }).waitFor();
    check(await page.getByLabel("after deformation").isChecked(), "it does not end with the last moment");
    failOnErrors(faults, "playing");
  },

  async "it plays by itself, but not for who asks for less motion"(browser) {
    const { page } = await openReplay(browser, "aa11,aa22");
    await step(page, 2); // the deepest
    await page.getByRole("button", { name: "Play" }).waitFor();
    const still = await browser.newPage({ reducedMotion: "reduce" });
    await still.goto(page.url().replace(/\?.*/, ""));
    await still.waitForSelector('[data-drawn="2"]');
    await still.getByRole("button", { name: "Play" }).waitFor();
  },

  async "every control changes what is seen"(browser) {
    const { page, faults } = await openReplay(browser, "aa11,aa22?step=2");
    for (const field of ["displacement", "strain", "depth", "none"])
      await looksOtherwise(page, () => page.getByLabel("Colour by").selectOption(field), `colour by ${field}`);
    for (const one of ["wire", "solid", "both"])
      await looksOtherwise(page, () => page.getByText(one, { exact: true }).click(), `organ ${one}`);
    for (const name of ["section", "tool", "moved vertices", "displacements", "crossing facets"])
      await looksOtherwise(page, () => page.getByRole("checkbox", { name, exact: true }).click(), name);
    failOnErrors(faults, "controls");
  },

  async "the mouse turns, moves and zooms"(browser) {
    const { page } = await openReplay(browser, "aa11,aa22?step=2");
    const box = await page.locator(".replay-place").first().boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const drag = async (button) => {
      await page.mouse.move(x, y);
      await page.mouse.down({ button });
      await page.mouse.move(x + 40, y + 20, { steps: 4 });
      await page.mouse.up({ button });
    };
    await looksOtherwise(page, () => drag("left"), "dragging");
    await looksOtherwise(page, () => drag("right"), "dragging with the right button");
    await looksOtherwise(page, () => page.mouse.wheel(0, 200), "the wheel");
  },

  async "a click pins a vertex, which the address keeps"(browser) {
    const { page, faults } = await openReplay(browser, "aa11,aa22?step=2&cut=0");
    const box = await page.locator(".replay-place").first().boundingBox();
    await page.mouse.click(box.x + 0.2 * box.width, box.y + 0.5 * box.height);
    await page.getByRole("heading", { name: /^Vertex \d+$/ }).waitFor();
    await page.waitForFunction(() => /vertex=\d+/.test(location.hash));
    await page.keyboard.press("Escape");
    await page.getByRole("heading", { name: /^Vertex/ }).waitFor({ state: "detached" });
    failOnErrors(faults, "pinning");
  },

  async "the pinned vertex is where the result file has it"(browser) {
    const { page } = await openReplay(browser, "aa11,aa22?step=2&vertex=220"); // the middle of the sheet, 5 mm deep
    const cells = await page.locator(".replay-pinned tbody td").allTextContents();
    check(cells.join() === "5.01,0.00,0.00,3.00", `displacements and depths are ${cells.join()}`);
  },

  async "an address restores what was seen"(browser) {
    const { page } = await openReplay(browser, "aa11,aa22?step=1&moment=deformed&color=displacement&surface=solid&hide=tool");
    await page.keyboard.press("Shift+ArrowUp");
    await page.waitForFunction(() => /camera=/.test(location.hash));
    await page.waitForFunction(() => {
      const canvas = document.querySelector(".replay-ground canvas");
      return canvas.width === Math.floor(canvas.clientWidth * devicePixelRatio); // while things move it may be coarser
    });
    const [seen, address] = [await pixels(page, 0), page.url()];
    await page.reload();
    await step(page, 1);
    await looksLike(page, seen, `${address} does not look as before`);
  },

  async "the saved picture is twice as large"(browser) {
    const { page } = await openReplay(browser, "aa11,aa22?step=2");
    const [saved] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save picture" }).click()]);
    const target = join(folder, "picture.png");
    await saved.saveAs(target);
    const box = await page.locator(".replay-figure").boundingBox();
    check(readFileSync(target).readUInt32BE(16) === Math.round(2 * box.width), "the picture is not twice as wide as the figure");
    check(saved.suggestedFilename() === "replay-clears_leaves-step-2.png", saved.suggestedFilename());
  },

  async "without WebGL it says so"(browser) {
    const context = await browser.newContext({ viewport: WIDE });
    await context.addInitScript(() => {
      const get = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
        return kind.startsWith("webgl") ? null : get.call(this, kind, ...more);
      };
    });
    const page = await context.newPage();
    const faults = [];
    page.on("pageerror", (error) => faults.push(error.message));
    page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
    await page.goto(`file://${report}#/replay/aa11,aa22?step=1`);
    await page.getByRole("alert").filter({ hasText: "no WebGL" }).waitFor();
    failOnErrors(faults, "no WebGL");
  },

  async "cases that are not there, or not alike, are named"(browser) {
    const { page } = await openReplay(browser, "aa11,nonesuch,bb33?step=1");
    const said = await page.getByRole("alert").textContent();
    check(/nonesuch/.test(said) && /same conditions/.test(said), said);
    check((await page.locator(".replay-cell").count()) === 1, "cases that are not alike stand side by side");
  },

  async "leaving it frees its context"(browser) {
    const { page, faults } = await openReplay(browser, "aa11?step=1");
    for (let turn = 0; turn < 20; turn++) {
      await page.evaluate((number) => (location.hash = `#/replay/aa11?step=${number}`), turn % 2);
      await step(page, turn % 2);
    }
    await page.evaluate(() => (location.hash = "#/"));
    await page.waitForFunction(() => !document.querySelector("canvas"));
    failOnErrors(faults, "20 replays after one another"); // browsers complain of more than 16 contexts
  },

  async "accessible in both themes, and usable on a narrow screen"(browser) {
    for (const theme of THEMES)
      for (const size of [WIDE, NARROW]) {
        const { page } = await openReplay(browser, "aa11,aa22?step=2&vertex=220&color=strain", { size, theme });
        const faults = await accessibilityFaults(page);
        check(faults.length === 0, `${theme}, ${size.width} px: ${faults.join("\n")}`);
        check((await overflow(page)) <= 0, `${theme}: ${size.width} px are too narrow`);
      }
  },
});
