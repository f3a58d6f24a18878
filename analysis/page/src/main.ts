// The page: its header, and the view that its address names: #/ (overview), #/explore, #/case/ID, #/replay/ID,ID, #/data.

import "./page.css";
import { readJson } from "./blocks";
import { readCases } from "./cases";
import { h } from "./dom";
import { header } from "./header";
import { replayView } from "./replay/replay_view";
import type { Report } from "./report";
import type { Page, View } from "./view";
import { caseView } from "./views/case";
import { explore } from "./views/explore";
import { notFound } from "./views/not_found";
import { overview } from "./views/overview";
import { provenance } from "./views/provenance";
import { trouble } from "./views/trouble";

function viewOf(page: Page, path: string): View {
  const [, name = "", rest = ""] = path.split("/");
  if (name === "") return overview(page);
  if (name === "explore") return explore(page);
  if (name === "case") return caseView(page, rest);
  if (name === "replay") return replayView(page, rest.split(",").filter(Boolean));
  if (name === "data") return provenance(page);
  return notFound(path);
}

/** The part of the address that says which view; what follows "?" is the view's own. */
function path(): string {
  return location.hash.slice(1).split("?")[0] || "/";
}

async function start(app: HTMLElement): Promise<void> {
  if (!("DecompressionStream" in globalThis)) {
    throw new Error("This browser cannot unpack the report: it is older than Chromium 103, Firefox 113 or Safari 16.4.");
  }
  const report = readJson<Report>("report");
  const page: Page = { report, cases: await readCases(report) };
  const main = h("main", { id: "main", tabindex: -1 });
  const head = header(report, main);
  app.replaceChildren(...head.elements, main);
  let shown: View | undefined;
  const show = () => {
    shown?.dispose?.();
    try {
      shown = viewOf(page, path());
    } catch (error) {
      console.error(error);
      shown = trouble(error);
    }
    main.replaceChildren(shown.element);
    main.dataset.view = path();
    document.title = `${shown.title} · ${report.title}`;
    head.mark(path());
  };
  addEventListener("hashchange", () => {
    show();
    scrollTo(0, 0);
    main.focus({ preventScroll: true }); // a reader who cannot see it learns that there is something new
  });
  show();
}

const app = document.getElementById("app")!;
start(app).catch((error: unknown) => {
  console.error(error);
  app.replaceChildren(h("main", {}, trouble(error).element));
});
