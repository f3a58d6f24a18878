// Which conditions, and which strategies under them, stand side by side.

import { h } from "../dom";
import type { Report } from "../report";
import { writeAddress, type Shown } from "./address";
import { select } from "./controls";
import type { Replay } from "./replay_data";

export const MOST_VIEWS = 6;

/** The replays that an address means, and what is wrong with it, if anything is. */
export function choose(report: Report, caseIds: string[]): { chosen: Replay[]; wrong: string } {
  const { replays } = report;
  const found = caseIds.flatMap((id) => replays.find((replay) => replay.caseId === id) ?? []);
  const unknown = caseIds.filter((id) => !replays.some((replay) => replay.caseId === id));
  const first = found[0] ?? replays[0];
  if (!first) return { chosen: [], wrong: "" };
  const alike = found.filter((replay) => replay.set === first.set);
  const chosen = (found.length ? alike : inOrder(report, first.set)).slice(0, MOST_VIEWS);
  const wrong = [
    unknown.length ? `The report has no replay of ${unknown.join(", ")}.` : "",
    alike.length < found.length ? "Only cases under the same conditions can stand side by side; the others are left out." : "",
    alike.length > MOST_VIEWS ? `At most ${MOST_VIEWS} cases fit side by side; the others are left out.` : "",
  ];
  return { chosen, wrong: wrong.filter(Boolean).join(" ") };
}

/** Replays under the same conditions, strategies in the order of the report. */
export function inOrder(report: Report, set: number): Replay[] {
  const place = ({ label }: Replay) => (report.labels.indexOf(label) + report.labels.length + 1) % (report.labels.length + 1);
  return report.replays.filter((replay) => replay.set === set).sort((a, b) => place(a) - place(b));
}

/** @param current what is shown, which another choice of strategies keeps */
export function chooser(report: Report, chosen: Replay[], current: () => Shown): HTMLElement {
  const set = chosen[0]!.set;
  const sets = new Map(report.replays.map((replay) => [String(replay.set), replay.conditions]));
  const open = (ids: string[], shown: Shown) => void (location.hash = writeAddress(ids, shown));
  const conditions = select("Conditions", [...sets.keys()], (key) => sets.get(key)!, (key) => {
    const ids = inOrder(report, Number(key)).slice(0, MOST_VIEWS).map((replay) => replay.caseId);
    open(ids, { ...current(), step: null, vertex: null, camera: null });
  });
  conditions.set(String(set));
  const all = inOrder(report, set);
  const ids = new Set(chosen.map((replay) => replay.caseId));
  const boxes = all.map((replay) => {
    const box = h("input", { type: "checkbox" });
    box.checked = ids.has(replay.caseId);
    box.disabled = box.checked ? ids.size === 1 : ids.size === MOST_VIEWS;
    box.addEventListener("change", () => {
      if (box.checked) ids.add(replay.caseId);
      else ids.delete(replay.caseId);
      open(all.map((one) => one.caseId).filter((id) => ids.has(id)), current());
    });
    return h("label", { class: "replay-check" }, box, replay.label);
  });
  return h("div", { class: "replay-chooser" }, conditions.element,
    h("fieldset", { class: "replay-strategies" }, h("legend", {}, `Strategies, at most ${MOST_VIEWS}`), ...boxes));
}
