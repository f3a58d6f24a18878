// The section through the tool's axis: what is on the eye's side of the plane is cut away, and the cut is filled.
//
// A point of the plane is inside a closed mesh when the ray from the eye through it meets the mesh an odd number of times behind the
// plane. So each mesh inverts a bit of the stencil wherever it is drawn, cut by the plane; then the plane is drawn where the bits say.

import {
  AlwaysStencilFunc, BufferGeometry, DoubleSide, EqualStencilFunc, Group, InvertStencilOp, Mesh, MeshBasicMaterial, type Object3D,
  Plane, PlaneGeometry, Vector3,
} from "three";
import type { Colors } from "./colors";
import type { Sight } from "./replay_data";

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
  paint(colors: Colors): void;
  dispose(): void;
}

/** @param tool moves its part of the section with it */
export function sectionView(organ: BufferGeometry, tool: BufferGeometry, toolGroup: Object3D, plane: Plane, sight: Sight): SectionView {
  const counts = [organ, tool].map((geometry, k) => {
    const bit = [IN_ORGAN, IN_TOOL][k]!;
    const mesh = new Mesh(geometry, counting(bit, plane));
    mesh.renderOrder = -3;
    mesh.frustumCulled = false;
    return mesh;
  });
  const square = new PlaneGeometry(1, 1);
  const fills = [IN_ORGAN, IN_ORGAN | IN_TOOL].map((bits, k) => {
    const mesh = new Mesh(square, filling(bits, k === 0 ? IN_ORGAN : IN_ORGAN | IN_TOOL));
    mesh.material.polygonOffset = k > 0;
    mesh.material.polygonOffsetFactor = mesh.material.polygonOffsetUnits = -1;
    mesh.position.fromArray(sight.centre);
    mesh.lookAt(front(sight).add(mesh.position));
    mesh.scale.setScalar(1000);
    mesh.renderOrder = -2 + k;
    return mesh;
  });
  counts[1]!.matrixAutoUpdate = false;
  const group = new Group().add(...counts, ...fills);
  counts[1]!.matrix = toolGroup.matrix;
  return {
    group,
    paint: (colors) => {
      fills[0]!.material.color.copy(colors.section);
      fills[1]!.material.color.copy(colors.deep);
    },
    dispose: () => {
      square.dispose();
      for (const mesh of [...counts, ...fills]) mesh.material.dispose();
    },
  };
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
  });
}
