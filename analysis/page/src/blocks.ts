// Reading what the report holds: one JSON text (#report) and arrays beside it, each in a <script> of its own as the
// base64 of gzip. analysis/trocar_analysis/report/blocks.py writes them.

export type Kind = "f8" | "f4" | "i4" | "i2" | "u4" | "u2" | "u1";
export type Values = Float64Array | Float32Array | Int32Array | Int16Array | Uint32Array | Uint16Array | Uint8Array;

/** An array of the report that is unpacked when it is wanted. */
export interface Block {
  block: string; // the id of its <script>
  kind: Kind;
  shape: number[];
}

const KINDS = {
  f8: Float64Array,
  f4: Float32Array,
  i4: Int32Array,
  i2: Int16Array,
  u4: Uint32Array,
  u2: Uint16Array,
  u1: Uint8Array,
};

function text(id: string): string {
  const found = document.getElementById(id);
  if (!found) throw new Error(`this report is damaged: it has no part ${id}`);
  return found.textContent ?? "";
}

/** The JSON text of the report. */
export function readJson<T>(id: string): T {
  return JSON.parse(text(id)) as T;
}

/** The values of a block, little-endian, row by row. Bytes of one significance lie together in the report: they pack better. */
export async function readBlock(block: Block): Promise<Values> {
  const binary = atob(text(block.block));
  const packed = new Uint8Array(binary.length);
  for (let i = 0; i < packed.length; i++) packed[i] = binary.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  const planes = new Uint8Array(await new Response(stream).arrayBuffer());
  const array = KINDS[block.kind];
  const width = array.BYTES_PER_ELEMENT;
  const count = planes.length / width;
  const bytes = new Uint8Array(planes.length);
  for (let k = 0; k < width; k++) for (let i = 0; i < count; i++) bytes[i * width + k] = planes[k * count + i]!;
  return new array(bytes.buffer);
}
