// Where the numbers come from: the file, the programs and machines, the sweep, how to make it all again, what is not in this
// report, and what each metric is.

import "./provenance.css";
import { h } from "../dom";
import { grouped, short } from "../numbers";
import type { Report } from "../report";
import type { Page, View } from "../view";
import { copyable } from "./copyable";
import { glossary } from "./glossary";

export function provenance({ report }: Page): View {
  const element = h(
    "section",
    { class: "provenance" },
    h("h1", {}, "Data & provenance"),
    part("What is not in this report", ...notes(report)),
    part("The result file", facts(fileFacts(report))),
    part("Run the sweep again", ...sweep(report)),
    part("Programs and machines", ...ways(report)),
    part("Glossary of metrics", h("p", { class: "lead" }, "Figures are named after their metric, the moment (h after handling, d after deformation) where it is taken at both, and what they are over the window: mean, max, final; of times quantiles."), glossary(report)),
  );
  return { title: "Data & provenance", element };
}

function part(title: string, ...content: Node[]): HTMLElement {
  return h("section", { class: "part" }, h("h2", {}, title), ...content);
}

function notes({ notes: said, cases }: Report): HTMLElement[] {
  const whole = `All ${grouped(cases)} cases of the file are in it, with every figure in full precision.`;
  return [h("p", {}, whole), h("ul", { class: "notes" }, ...(said.length ? said : ["Nothing of the file is left out."]).map((note) => h("li", {}, note)))];
}

function fileFacts(report: Report): [string, string][] {
  const planned = report.planned === null ? "not said by the file" : grouped(report.planned);
  return [
    ["file", report.file],
    ["made by", report.generator || "not said by the file"],
    ["made on", report.createdUtc || "not said by the file"],
    ["schema of the file", String(report.schema)],
    ["cases", grouped(report.cases)],
    ["cases of the whole sweep", planned],
    ["strategies", report.labels.join(", ")],
  ];
}

function facts(entries: [string, string][]): HTMLElement {
  return h("dl", { class: "fact-list" }, ...entries.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
}

function sweep(report: Report): HTMLElement[] {
  const lines = [...new Set(report.provenance.map(({ argv }) => String(argv ?? "")).filter(Boolean))];
  const commands = lines.length
    ? [h("p", {}, "The file was made by:"), ...lines.map((line) => copyable(line, "the command"))]
    : [h("p", {}, "The file does not say by which command it was made. With its sweep, below, as sweep.toml:"), copyable(`trocar run sweep.toml -o ${report.file}`, "the command")];
  const toml = report.sweepToml ? [h("p", {}, "The sweep, as the file holds it:"), copyable(report.sweepToml, "the sweep")] : [h("p", {}, "The file does not hold its sweep.")];
  return [...commands, ...toml, h("p", {}, "This page, from the file:"), copyable(`trocar report ${report.file} -o report.html`, "the command that makes this page")];
}

function ways(report: Report): HTMLElement[] {
  if (!report.provenance.length) return [h("p", { class: "notice" }, "The file does not say how its cases were run (/provenance is empty).")];
  const cautions = report.overview.cautions.map((caution) => h("p", { class: "notice" }, caution));
  const cards = report.provenance.map((way) => h("article", { class: "card" }, facts(Object.entries(way).map(([name, value]) => [name.replaceAll("_", " "), said(name, value)]))));
  return [...cautions, ...cards];
}

function said(name: string, value: string | number): string {
  if (name === "git_dirty") return value ? "yes: with changes that are in no commit" : "no";
  return typeof value === "number" ? short(value) : value || "–";
}
