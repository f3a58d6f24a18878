// What is drawn over the organ of one view, also where the organ hides it: the vertices that the strategy moved, how, and the
// pinned one.

import {
  CylinderGeometry, ConeGeometry, DynamicDrawUsage, Group, IcosahedronGeometry, InstancedMesh, Matrix4, Mesh, MeshBasicMaterial, type Plane,
  Quaternion, Vector3,
} from "three";
import type { Shown } from "./address";
import type { Colors } from "./colors";
import { verticesAt, type Recording } from "./recording";

const UP = new Vector3(0, 1, 0);
const HEAD = 3.5; // length of an arrow's head, sizes of the marks

export interface MarksView {
  group: Group;
  /** @param positions of the organ as it is shown */
  pose(frame: number, shown: Shown, positions: Float32Array): void;
  paint(colors: Colors): void;
  clip(planes: Plane[]): void;
  dispose(): void;
}

/** @param size of the marks, mm */
export function marksView(recording: Recording, size: number): MarksView {
  let most = 1;
  for (let frame = 0; frame < recording.frames.length; frame++) most = Math.max(most, recording.moved(frame).length);
  const ball = new IcosahedronGeometry(1, 2);
  const rod = new CylinderGeometry(1, 1, 1, 8).translate(0, 0.5, 0);
  const tip = new ConeGeometry(1, 1, 12).translate(0, -0.5, 0);
  const overAll = { depthTest: false, transparent: true };
  const ballPaint = new MeshBasicMaterial(overAll);
  const arrowPaint = new MeshBasicMaterial(overAll);
  const pinPaint = new MeshBasicMaterial(overAll);
  const balls = instances(ball, ballPaint, most, 6);
  const rods = instances(rod, arrowPaint, most, 6);
  const tips = instances(tip, arrowPaint, most, 6);
  const pin = new Mesh(ball, pinPaint);
  pin.renderOrder = 7;
  const found = new Float32Array(recording.rest.length);
  const group = new Group().add(balls, rods, tips, pin);

  return {
    group,
    pose: (frame, shown, positions) => {
      const moved = recording.moved(frame);
      const by = recording.movedBy(frame);
      verticesAt(recording, frame, "found", found);
      balls.count = shown.hidden.includes("moved") ? 0 : moved.length;
      rods.count = tips.count = shown.hidden.includes("vectors") ? 0 : moved.length;
      const [start, way] = [new Vector3(), new Vector3()];
      const radius = 0.7 * size;
      moved.forEach((vertex, k) => {
        balls.setMatrixAt(k, new Matrix4().makeScale(radius, radius, radius).setPosition(start.fromArray(positions, 3 * vertex)));
        arrow(rods, tips, k, start.fromArray(found, 3 * vertex), way.fromArray(by, 3 * k), size);
      });
      for (const one of [balls, rods, tips]) one.instanceMatrix.needsUpdate = true;
      pin.visible = shown.vertex !== null && 3 * shown.vertex < positions.length;
      if (pin.visible) pin.position.fromArray(positions, 3 * shown.vertex!);
      pin.scale.setScalar(1.6 * size);
    },
    paint: (colors) => {
      ballPaint.color.copy(colors.moved);
      arrowPaint.color.copy(colors.vector);
      pinPaint.color.copy(colors.pin);
    },
    clip: (planes) => {
      for (const paint of [ballPaint, arrowPaint]) paint.clippingPlanes = planes;
    },
    dispose: () => {
      for (const one of [ball, rod, tip, ballPaint, arrowPaint, pinPaint, balls, rods, tips]) one.dispose();
    },
  };
}

function instances<Shape extends IcosahedronGeometry | CylinderGeometry>(shape: Shape, paint: MeshBasicMaterial, most: number, order: number) {
  const mesh = new InstancedMesh(shape, paint, most);
  mesh.instanceMatrix.setUsage(DynamicDrawUsage);
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
}

/** From start along way: its head ends where the vertex went, and is shorter where the way is short. */
function arrow(rods: InstancedMesh, tips: InstancedMesh, k: number, start: Vector3, way: Vector3, size: number): void {
  const length = way.length();
  const head = Math.min(HEAD * size, 0.5 * length);
  const turn = new Quaternion().setFromUnitVectors(UP, length > 0 ? way.clone().divideScalar(length) : UP);
  const width = head / (HEAD * size) || 1e-6;
  const rod = new Vector3(0.28 * size * width, Math.max(length - head, 1e-6), 0.28 * size * width);
  rods.setMatrixAt(k, new Matrix4().compose(start, turn, rod));
  tips.setMatrixAt(k, new Matrix4().compose(start.clone().add(way), turn, new Vector3(1.3 * size * width, head || 1e-6, 1.3 * size * width)));
}
