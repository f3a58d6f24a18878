// What the views of the page have in common.

import type { Cases } from "./cases";
import type { Report } from "./report";

export interface Page {
  report: Report;
  cases: Cases;
}

/** What the page shows for an address (the part after #). */
export interface View {
  title: string;
  element: HTMLElement;
  /** When another view takes its place. */
  dispose?(): void;
}
