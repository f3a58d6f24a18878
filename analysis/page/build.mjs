// Bundles the page into dist/page.js, a classic script (a page opened from file:// may not load modules), and
// dist/page.css. With --tests it bundles tests/*.test.ts into dist/tests instead, for node --test.
import { readdirSync, rmSync } from "node:fs";
import { build } from "esbuild";

const tests = process.argv.includes("--tests");
const common = { bundle: true, logLevel: "warning", legalComments: "inline", absWorkingDir: import.meta.dirname };

if (tests) {
  rmSync(new URL("dist/tests", import.meta.url), { recursive: true, force: true });
  const entryPoints = readdirSync(new URL("tests", import.meta.url))
    .filter((name) => name.endsWith(".test.ts"))
    .map((name) => `tests/${name}`);
  await build({ ...common, entryPoints, outdir: "dist/tests", platform: "node", format: "esm", outExtension: { ".js": ".mjs" } });
} else {
  await build({
    ...common,
    entryPoints: { page: "src/main.ts" },
    outdir: "dist",
    format: "iife",
    target: ["chrome103", "firefox113", "safari16.4"],
    minify: true,
  });
}
