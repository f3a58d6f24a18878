// Strategies side by side: one scene, one camera, one timeline.

import "./replay.css";
import { h } from "../dom";
import type { Page, View } from "../view";
import { readAddress } from "./address";
import { choose, chooser } from "./chooser";
import { readRecording } from "./recording";
import { runReplay } from "./session";

/** @param caseIds the cases that stand side by side; none: the view chooses */
export function replayView(page: Page, caseIds: string[]): View {
  const element = h("section", { class: "replay" });
  const { chosen, wrong } = choose(page.report, caseIds);
  if (!chosen.length) {
    element.append(h("h1", {}, "Replay"), h("p", { role: "status" }, nothing(page.report.notes)));
    return { title: "Replay", element };
  }
  const ended = new AbortController();
  const shown = readAddress(location.hash);
  const body = h("div", { class: "replay-body" }, h("p", { role: "status" }, "Unpacking the replay …"));
  element.classList.toggle("replay-bare", shown.bare);
  element.append(
    h("div", { class: "replay-top" }, h("h1", {}, "Replay"), chooser(page.report, chosen, () => shown)),
    ...(wrong ? [h("p", { role: "alert" }, wrong)] : []),
    body,
    ...aboutReplays(page.report.notes).map((note) => h("p", { class: "replay-note" }, note)),
  );
  const meshes = new Map();
  Promise.all(chosen.map((replay) => readRecording(replay, meshes)))
    .then((recordings) => {
      if (!ended.signal.aborted) runReplay(body, recordings, page.report.labels, shown, ended.signal);
    })
    .catch((error: unknown) => body.replaceChildren(h("p", { role: "alert" }, `The replay cannot be shown: ${String(error)}`)));
  return { title: "Replay", element, dispose: () => ended.abort() };
}

function aboutReplays(notes: string[]): string[] {
  return notes.filter((note) => note.startsWith("replay"));
}

function nothing(notes: string[]): string {
  const why = aboutReplays(notes);
  return why.length ? why.join(". ") : "This report has no replay: no case of the result file was recorded. `trocar run … --replay` records one.";
}
