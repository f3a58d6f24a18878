// How long a frame of the replay takes: six views of an organ of about 15,000 facets, in headless Chromium. A measurement, no test:
//
//   node tests/page/frame_time.mjs build/trocar
//
// While the camera turns (the views are drawn again), and while it steps too (every frame another step: positions, normals, colours
// and section are worked out again as well); at full resolution, and as it is shown while it moves, which is coarser where frames
// take long. A frame is the time from the key to when its last pixel is there
// (a pixel is read back), so it has all that the renderer does, on the processor or the graphics card that its name tells.

import { execFileSync } from "node:child_process";
import { createRequire } from "node:module";
import { mkdtempSync, rmSync } from "node:fs";
import { cpus, tmpdir } from "node:os";
import { join } from "node:path";

const { chromium } = createRequire(new URL("../../analysis/page/package.json", import.meta.url))("playwright-core");
const FRAMES = 100;
const here = import.meta.dirname;
const trocar = process.argv[2];
if (!trocar) throw new Error("usage: node tests/page/frame_time.mjs TROCAR, the program, such as build/trocar");

const folder = mkdtempSync(join(tmpdir(), "trocar-frame-time-"));
const [results, report] = [join(folder, "frame_time.h5"), join(folder, "frame_time.html")];
const quiet = { stdio: ["ignore", "ignore", "inherit"], env: { ...process.env, PYTHONPATH: join(here, "../../analysis") } };
execFileSync(trocar, ["run", join(here, "frame_time.toml"), "-o", results, "--replay", "--metrics", "fast"], quiet);
execFileSync("/usr/bin/python3", ["-B", "-m", "trocar_analysis", "report", results, "-o", report], quiet);

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: [
    "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  ],
});
const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
await open(true);
const renderer = await page.evaluate(() => {
  const gl = document.createElement("canvas").getContext("webgl2");
  return gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL);
});
const size = await page.evaluate(() => {
  const { width, height } = document.querySelector(".replay-ground canvas");
  return `${document.querySelectorAll(".replay-cell").length} views, ${width} × ${height} pixels in all`;
});
const version = browser.version();
const measured = [
  ["camera turns, full resolution", await frameTimes(false)],
  ["and another step each frame", await frameTimes(true)],
];
await open(false);
measured.push(["the same as it is shown while it moves", await frameTimes(true)]);
await browser.close();
rmSync(folder, { recursive: true });

console.log(`${size}; Chromium ${version}; ${renderer}; ${cpus().length} × ${cpus()[0].model}`);
for (const [what, times] of measured)
  console.log(`${what}: median ${quantile(times, 0.5).toFixed(1)} ms, 99th percentile ${quantile(times, 0.99).toFixed(1)} ms, of ${times.length} frames`);

/** @param whole at full resolution always */
async function open(whole) {
  await page.goto("about:blank");
  await page.goto(`file://${report}#/replay/?step=20&color=displacement${whole ? "&bare=1" : ""}`);
  await page.waitForSelector("[data-drawn]");
}

/** ms from a key to the end of the drawing. */
function frameTimes(alsoStep) {
  return page.evaluate(
    async ([frames, step]) => {
      const gl = document.querySelector(".replay-ground canvas").getContext("webgl2");
      const drained = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      const press = (key, shiftKey) => dispatchEvent(new KeyboardEvent("keydown", { key, shiftKey }));
      const times = [];
      for (let k = 0; k < frames; k++) {
        const start = performance.now();
        press("ArrowRight", true);
        if (step) press(k % 50 < 25 ? "ArrowRight" : "ArrowLeft", false);
        await new Promise(requestAnimationFrame);
        drained();
        times.push(performance.now() - start);
        await new Promise((done) => setTimeout(done, 20)); // so that the next frame is not put off
      }
      return times;
    },
    [FRAMES, alsoStep],
  );
}

function quantile(values, share) {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}
