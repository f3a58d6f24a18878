// The tool of one view: glass of the colour of steel, and an outline that shows faintly where the organ hides it.

import { BackSide, BufferAttribute, BufferGeometry, FrontSide, Group, Matrix4, Mesh, MeshLambertMaterial, type Plane, Vector3 } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Colors } from "./colors";
import type { Recording } from "./recording";

const SHARP = Math.cos((10 * Math.PI) / 180); // an edge at which the surface bends by more than 10° is drawn

export interface ToolView {
  group: Group;
  geometry: BufferGeometry;
  positions(): Float32Array; // in the world
  pose(frame: number): void;
  paint(colors: Colors): void;
  clip(planes: Plane[]): void;
  dispose(): void;
}

export function toolView(recording: Recording): ToolView {
  const { facets } = recording.tool;
  const indexed = new BufferGeometry().setAttribute("position", new BufferAttribute(recording.toolPositions, 3));
  indexed.setIndex(new BufferAttribute(facets, 1));
  const geometry = indexed.toNonIndexed(); // facets are flat: each has corners of its own
  geometry.computeVertexNormals();
  const outline = new LineSegmentsGeometry().setPositions(sharpEdges(recording.toolPositions, facets));

  const glass = { transparent: true, depthWrite: false };
  const back = new MeshLambertMaterial({ ...glass, side: BackSide, opacity: 0.18 });
  const front = new MeshLambertMaterial({ ...glass, side: FrontSide, opacity: 0.3 });
  const line = new LineMaterial({ linewidth: 1.7 });
  const faint = new LineMaterial({ linewidth: 1.2, transparent: true, opacity: 0.4, depthTest: false, depthWrite: false });
  const parts = [new Mesh(geometry, back), new Mesh(geometry, front), new LineSegments2(outline, line), new LineSegments2(outline, faint)];
  parts.forEach((part, k) => (part.renderOrder = [3, 4, 0, 5][k]!));
  const group = new Group().add(...parts);
  group.matrixAutoUpdate = false;
  for (const part of parts) part.frustumCulled = false;

  return {
    group,
    geometry,
    positions: () => (indexed.getAttribute("position").clone().applyMatrix4(group.matrix) as BufferAttribute).array as Float32Array,
    pose: (frame) => {
      group.matrix.copy(poseAt(recording, frame));
      group.matrixWorldNeedsUpdate = true;
    },
    paint: (colors) => {
      for (const material of [back, front]) material.color.copy(colors.tool);
      for (const material of [line, faint]) material.color.copy(colors.outline);
    },
    clip: (planes) => {
      for (const material of [back, front, line, faint]) material.clippingPlanes = planes;
    },
    dispose: () => {
      for (const one of [indexed, geometry, outline, back, front, line, faint]) one.dispose();
    },
  };
}

export function poseAt(recording: Recording, frame: number): Matrix4 {
  return new Matrix4().fromArray(recording.poses.subarray(16 * frame, 16 * frame + 16)).transpose(); // rows in the report, columns here
}

/** Both ends of every edge at which the surface bends, three numbers each. */
function sharpEdges(positions: Float32Array, facets: Uint32Array): number[] {
  const at = (vertex: number) => new Vector3().fromArray(positions, 3 * vertex);
  const first = new Map<string, Vector3>();
  const sharp: number[] = [];
  for (let f = 0; f < facets.length; f += 3) {
    const corners = [facets[f]!, facets[f + 1]!, facets[f + 2]!];
    const [a, b, c] = corners.map(at) as [Vector3, Vector3, Vector3];
    const normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
    for (let end = 0; end < 3; end++) {
      const edge = [corners[end]!, corners[(end + 1) % 3]!].sort((p, q) => p - q);
      const other = first.get(edge.join());
      if (!other) first.set(edge.join(), normal);
      else if (other.dot(normal) < SHARP) sharp.push(...edge.flatMap((vertex) => at(vertex).toArray()));
    }
  }
  return sharp;
}
