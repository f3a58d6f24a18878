// Data as CSV: numbers in full, so that they are those of the result file.

export type Cell = string | number;

export function csvText(rows: Cell[][]): string {
  return rows.map((row) => row.map(field).join(",") + "\n").join("");
}

function field(cell: Cell): string {
  if (typeof cell === "number") return Number.isNaN(cell) ? "" : String(cell);
  return /[",\n\r]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell;
}

export function csvRows(text: string): string[][] {
  const rows: string[][] = [];
  let row: string[] = [];
  for (const [, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^,\n]*))(,|\n)/g)) {
    row.push(quoted?.replaceAll('""', '"') ?? plain!);
    if (end === "\n") row = (rows.push(row), []);
  }
  return rows;
}
