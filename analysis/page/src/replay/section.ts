// The section through the tool's axis: what is on the eye's side of the plane is cut away, and the cut is filled.
//
// A point of the plane is inside a closed mesh when the ray from the eye through it meets the mesh an odd number of times behind the
// plane. So each mesh inverts a bit of the stencil wherever it is drawn, cut by the plane; then the plane is drawn where the bits say.

import {
  AlwaysStencilFunc, DoubleSide, EqualStencilFunc, Group, InvertStencilOp, Mesh, MeshBasicMaterial, Plane, PlaneGeometry, Vector3,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Colors } from "./colors";
import type { OrganView } from "./organ_view";
import type { Recording } from "./recording";
import type { Sight } from "./replay_data";
import type { ToolView } from "./tool_view";

const IN_ORGAN = 1; // bits of the stencil
const IN_TOOL = 2;

/** Cuts at the plane of the sight whatever is on the eye's side of it. */
export function turnPlane(plane: Plane, sight: Sight, eye: Vector3): void {
  const centre = new Vector3().fromArray(sight.centre);
  plane.setFromNormalAndCoplanarPoint(front(sight), centre);
  if (plane.distanceToPoint(eye) > 0) plane.negate();
}

export function front(sight: Sight): Vector3 {
  return new Vector3().fromArray(sight.right).cross(new Vector3().fromArray(sight.axis));
}

export interface SectionView {
  group: Group;
  /** After the organ has moved. @param filled whether the section is filled, or its line alone drawn */
  pose(filled: boolean): void;
  paint(colors: Colors): void;
  dispose(): void;
}

export function sectionView(recording: Recording, organ: OrganView, tool: ToolView, plane: Plane): SectionView {
  const sight = recording.replay.view;
  const counts = [organ.geometry, tool.geometry].map((geometry, k) => {
    const mesh = new Mesh(geometry, counting([IN_ORGAN, IN_TOOL][k]!, plane));
    mesh.renderOrder = -3;
    mesh.frustumCulled = false;
    return mesh;
  });
  counts[1]!.matrixAutoUpdate = false;
  counts[1]!.matrix = tool.group.matrix;
  const square = new PlaneGeometry(1000, 1000); // mm: beyond every organ
  const fills = [filling(IN_ORGAN, IN_ORGAN), filling(IN_ORGAN | IN_TOOL, IN_ORGAN | IN_TOOL), filling(IN_TOOL, IN_ORGAN | IN_TOOL)].map(
    (material, k) => {
      const mesh = new Mesh(square, material);
      mesh.position.fromArray(sight.centre);
      mesh.lookAt(front(sight).add(mesh.position));
      mesh.renderOrder = -2 + k;
      return mesh;
    },
  );
  Object.assign(fills[2]!.material, { transparent: true, opacity: 0.4, depthWrite: false });
  const [organLine, toolLine] = [makeLine(), makeLine()];
  const group = new Group().add(...counts, ...fills, organLine, toolLine);
  const flat = new Plane().setFromNormalAndCoplanarPoint(front(sight), new Vector3().fromArray(sight.centre));
  return {
    group,
    pose: (filled) => {
      for (const mesh of [...counts, ...fills]) mesh.visible = filled && recording.organ.closed;
      setLine(organLine, sectionLine(organ.positions, recording.organ.facets, flat));
      setLine(toolLine, tool.group.visible ? sectionLine(tool.positions(), recording.tool.facets, flat) : []);
    },
    paint: (colors) => {
      [colors.section, colors.deep, colors.tool].forEach((color, k) => fills[k]!.material.color.copy(color));
      organLine.material.color.copy(colors.edge);
      toolLine.material.color.copy(colors.outline);
    },
    dispose: () => {
      square.dispose();
      for (const line of [organLine, toolLine]) line.geometry.dispose();
      for (const mesh of [...counts, ...fills, organLine, toolLine]) mesh.material.dispose();
    },
  };
}

function makeLine(): LineSegments2 {
  const ink = new LineMaterial({ linewidth: 1.8, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 });
  const line = new LineSegments2(new LineSegmentsGeometry(), ink);
  line.frustumCulled = false;
  return line;
}

function setLine(line: LineSegments2, ends: number[]): void {
  line.geometry.dispose(); // the buffers of the line before
  line.geometry.setPositions(ends);
  line.visible = ends.length > 0;
}

function counting(bit: number, plane: Plane): MeshBasicMaterial {
  return new MeshBasicMaterial({
    side: DoubleSide, colorWrite: false, depthWrite: false, depthTest: false, clippingPlanes: [plane],
    stencilWrite: true, stencilWriteMask: bit, stencilFunc: AlwaysStencilFunc,
    stencilFail: InvertStencilOp, stencilZFail: InvertStencilOp, stencilZPass: InvertStencilOp,
  });
}

/** Where the bits of the mask are these. */
function filling(bits: number, mask: number): MeshBasicMaterial {
  return new MeshBasicMaterial({
    side: DoubleSide, stencilWrite: true, stencilWriteMask: 0, stencilFunc: EqualStencilFunc, stencilRef: bits, stencilFuncMask: mask,
    polygonOffset: bits !== mask || bits !== IN_ORGAN, polygonOffsetFactor: -1, polygonOffsetUnits: -1,
  });
}

/** Where a mesh meets a plane: both ends of a line for each facet that does, three numbers each. */
export function sectionLine(positions: Float32Array, facets: Uint32Array, plane: Plane): number[] {
  const { normal, constant } = plane;
  const height = (vertex: number) =>
    normal.x * positions[3 * vertex]! + normal.y * positions[3 * vertex + 1]! + normal.z * positions[3 * vertex + 2]! + constant;
  const line: number[] = [];
  for (let f = 0; f < facets.length; f += 3) {
    for (let end = 0; end < 3; end++) {
      const [a, b] = [facets[f + end]!, facets[f + ((end + 1) % 3)]!];
      const [ha, hb] = [height(a), height(b)];
      if (ha <= 0 === hb <= 0) continue;
      const share = ha / (ha - hb);
      for (let k = 0; k < 3; k++) line.push(positions[3 * a + k]! + share * (positions[3 * b + k]! - positions[3 * a + k]!));
    }
  }
  return line;
}
