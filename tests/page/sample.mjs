// Reports for the tests, made of the files that sample_results.py writes.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const PYTHON = "/usr/bin/python3";
const ROOT = fileURLToPath(new URL("../..", import.meta.url));
const BETTER = "depth_max=low,time_handle=low,drag=low";

/** @returns for each name (whole, half, failed, single) its result file and report. The folder goes when the process ends. */
export function sampleReports() {
  const folder = mkdtempSync(join(tmpdir(), "trocar-page-"));
  process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
  python([join(ROOT, "tests/page/sample_results.py"), folder]);
  return Object.fromEntries(["whole", "half", "failed", "single"].map((name) => [name, sampleReport(folder, name)]));
}

function sampleReport(folder, name) {
  const [results, report] = [join(folder, `${name}.h5`), join(folder, `${name}.html`)];
  const claims = join(ROOT, "experiments/claims.toml");
  python(["-m", "trocar_analysis", "report", results, "-o", report, "--better", BETTER, "--claims", claims]);
  return { results, report };
}

/** What Python prints. */
export function python(words) {
  return execFileSync(PYTHON, ["-B", ...words], { env: { ...process.env, PYTHONPATH: join(ROOT, "analysis") }, encoding: "utf8" });
}
