// A picture of the replay of a report, taken by headless Chromium: the pictures of README.md are made by it.
//
//   node cmake/replay_picture.mjs REPORT.html OUT.png --cases ID,ID [--step deepest] [--moment handled] [--color none] [--surface both]
//     [--hide tool,…] [--cut 1] [--camera x,y,z,distance,side,height] [--theme light] [--width 1400] [--height 900]
//
// Width and height are those of the page; the picture has twice as many pixels. What the options mean is in
// analysis/page/src/replay/README.md: they are those of the page's address.

import { createRequire } from "node:module";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";

const IN_ADDRESS = ["moment", "color", "surface", "hide", "cut", "camera", "vertex"];
const text = { type: "string" };
const usage = "usage: node cmake/replay_picture.mjs REPORT.html OUT.png --cases ID,ID [--step K] [--moment M] … (see the file's head)";

function read() {
  try {
    const { values, positionals } = parseArgs({
      allowPositionals: true,
      options: {
        ...Object.fromEntries([...IN_ADDRESS, "step", "cases"].map((name) => [name, text])),
        theme: { ...text, default: "light" },
        width: { ...text, default: "1400" },
        height: { ...text, default: "900" },
      },
    });
    if (positionals.length !== 2 || !values.cases) throw new Error("expected a report, a picture and --cases");
    for (const name of ["width", "height"]) if (!/^[1-9]\d*$/.test(values[name])) throw new Error(`--${name} ${values[name]}: expected pixels`);
    if (!["light", "dark"].includes(values.theme)) throw new Error(`--theme ${values.theme}: expected light or dark`);
    return { ...values, report: positionals[0], output: positionals[1] };
  } catch (error) {
    console.error(`${error.message}\n${usage}`);
    process.exit(2);
  }
}

const wishes = read();
const said = IN_ADDRESS.filter((name) => wishes[name] !== undefined).map((name) => `&${name}=${wishes[name]}`);
if (wishes.step !== undefined && wishes.step !== "deepest") said.push(`&step=${wishes.step}`);
const address = `${pathToFileURL(resolve(wishes.report))}#/replay/${wishes.cases}?bare=1${said.join("")}`;

const { chromium } = createRequire(new URL("../analysis/page/package.json", import.meta.url))("playwright-core");
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: [
    "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  ],
});
try {
  const page = await browser.newPage({
    viewport: { width: Number(wishes.width), height: Number(wishes.height) },
    deviceScaleFactor: 2,
    colorScheme: wishes.theme,
  });
  await page.goto(address);
  await page.waitForSelector("[data-drawn], [role=alert]");
  const wrong = await page.getByRole("alert").allTextContents();
  if (wrong.length) throw new Error(wrong.join("\n"));
  await page.screenshot({ path: wishes.output });
  console.log(`${wishes.output}: ${await page.locator(".replay-head").textContent()}`);
} catch (error) {
  console.error(`${wishes.report}: no picture: ${error.message}`);
  process.exitCode = 1;
} finally {
  await browser.close();
}
