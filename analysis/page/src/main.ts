// The page: its header, and the view that its address names: #/ (overview), #/explore, #/case/ID, #/replay/ID,ID.

import "./page.css";
import { readCases } from "./cases";
import { h } from "./dom";
import { readJson } from "./blocks";
import type { Report } from "./report";
import { replayView } from "./replay/replay_view";
import type { Page, View } from "./view";
import { caseView } from "./views/case";
import { explore } from "./views/explore";
import { overview } from "./views/overview";

function viewOf(page: Page, address: string): View {
  const [, name, rest = ""] = address.split("?")[0]!.split("/");
  if (name === "explore") return explore(page);
  if (name === "case") return caseView(page, rest);
  if (name === "replay") return replayView(page, rest.split(",").filter(Boolean));
  return overview(page);
}

async function start(app: HTMLElement): Promise<void> {
  const report = readJson<Report>("report");
  const page: Page = { report, cases: await readCases(report) };
  const main = h("main");
  app.replaceChildren(main);
  let shown: View | undefined;
  const show = () => {
    shown?.dispose?.();
    shown = viewOf(page, location.hash.slice(1));
    main.replaceChildren(shown.element);
    document.title = `${shown.title} · ${report.title}`;
  };
  addEventListener("hashchange", show);
  show();
}

const app = document.getElementById("app")!;
start(app).catch((error: unknown) => app.replaceChildren(h("p", { role: "alert" }, String(error))));
