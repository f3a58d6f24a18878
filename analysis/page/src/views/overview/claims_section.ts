// The paper's claims with their verdicts on this file's cases.

import { h } from "../../dom";
import type { Claim, ClaimVerdict, Overview } from "../overview_data";

// A verdict is told by its words; the colour only helps to find it.
const KINDS: Record<string, string> = { reproduced: "good", partly: "some", "not reproduced": "bad" };

const UNSEEN = ["not run", "not yet", "cannot be judged"];

export function claimsSection({ claims, about, legend }: Overview["claims"]): HTMLElement[] {
  const said = about.map((sentence) => h("p", { class: "note" }, sentence));
  if (!claims.length) return said;
  const words = h("details", { class: "more" }, h("summary", {}, "How a claim is judged"), ...legend.map((line) => h("p", {}, line)));
  const list = h("div", { class: "claims" }, ...claims.map(claimElement));
  const isAny = claims.some(({ verdicts }) => verdicts.some(({ word }) => !UNSEEN.includes(word)));
  if (isAny) return [...said, list, words];
  return [h("p", {}, "This file holds no cases on which a claim could be judged."), ...said, h("details", { class: "more" }, h("summary", {}, "The claims"), list)];
}

function claimElement(claim: Claim): HTMLElement {
  const tags = h("div", { class: "claim-verdicts" }, ...together(claim.verdicts).map(verdictElement));
  const heading = h("h3", {}, h("span", { class: "claim-id" }, claim.id), " ", claim.says);
  const place = h("p", { class: "claim-place" }, claim.place, claim.pending ? `. Cannot be judged yet: ${claim.pending}.` : "");
  const inside = [place, ...claim.notes.map((note) => h("p", { class: "note" }, note))];
  return h("article", { class: "claim" }, heading, tags, ...inside, ...conditions(claim));
}

/** Verdicts that are the same under each release stand once. */
function together(verdicts: ClaimVerdict[]): { words: string; verdict: ClaimVerdict }[] {
  return [false, true].flatMap((confirmation) => {
    const own = verdicts.filter((one) => one.confirmation === confirmation);
    const where = confirmation ? "confirmation set" : "";
    if (own.length > 1 && own.every(({ text }) => text === own[0]!.text)) return [{ words: where || "both releases", verdict: own[0]! }];
    return own.map((verdict) => ({ words: [where, verdict.release && `release ${verdict.release}`].filter(Boolean).join(", "), verdict }));
  });
}

function verdictElement({ words, verdict }: { words: string; verdict: ClaimVerdict }): HTMLElement {
  return h("span", { class: "claim-verdict" }, h("span", { class: `tag ${KINDS[verdict.word] ?? "open"}` }, verdict.text), ...(words ? [h("small", {}, words)] : []));
}

function conditions({ id, table, verdicts }: Claim): HTMLElement[] {
  if (!table?.rows.length || verdicts.every(({ text }) => UNSEEN.includes(text))) return [];
  const kind = table.columns.map(({ isText }) => (isText ? "" : "number"));
  const head = table.columns.map(({ title }, place) => h("th", { scope: "col", class: kind[place] }, title));
  const rows = table.rows.map((row) => h("tr", {}, ...row.map((cell, place) => h("td", { class: kind[place] }, cell))));
  const scroll = h("div", { class: "scroll", tabindex: 0, role: "region", "aria-label": `Conditions of ${id}` }, h("table", {}, h("thead", {}, h("tr", {}, ...head)), h("tbody", {}, ...rows)));
  return [h("details", { class: "more" }, h("summary", {}, "Its conditions, with medians and intervals"), scroll)];
}
