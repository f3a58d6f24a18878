// The one camera of all views: it looks at a point from a distance, a side and a height, with the tool's axis upwards.

import { PerspectiveCamera, Quaternion, Vector3 } from "three";
import type { Sight } from "./replay_data";
import { front } from "./section";

const OPENING = 24; // degrees, from the lower to the upper edge of a view
const START_HEIGHT = 30; // degrees above the plane across the tool's axis

export interface Orbit {
  target: Vector3;
  distance: number; // mm
  side: number; // degrees around the axis, from the section's front
  height: number; // degrees
}

export function startOrbit(sight: Sight): Orbit {
  const distance = (0.9 * sight.halfHeight) / Math.tan((OPENING * Math.PI) / 360);
  return { target: new Vector3().fromArray(sight.centre), distance, side: 0, height: START_HEIGHT };
}

export function orbitFrom(numbers: number[]): Orbit {
  const [x, y, z, distance, side, height] = numbers as [number, number, number, number, number, number];
  return { target: new Vector3(x, y, z), distance: Math.max(distance, 0.1), side, height: Math.max(-89, Math.min(89, height)) };
}

/** Rounded, to be said in an address. */
export function orbitNumbers(orbit: Orbit): number[] {
  return [...orbit.target.toArray(), orbit.distance, orbit.side, orbit.height].map((value) => Number(value.toFixed(3)));
}

/** Puts the camera there. @param aspect width of a view over its height */
export function placeCamera(camera: PerspectiveCamera, orbit: Orbit, sight: Sight, aspect: number): void {
  const axis = new Vector3().fromArray(sight.axis);
  const [side, height] = [orbit.side, orbit.height].map((degrees) => (degrees * Math.PI) / 180) as [number, number];
  const level = front(sight).applyQuaternion(new Quaternion().setFromAxisAngle(axis, side));
  const towards = level.multiplyScalar(Math.cos(height)).addScaledVector(axis, Math.sin(height));
  const widen = Math.max(1, sight.halfWidth / sight.halfHeight / aspect); // a narrow view has to show the width
  const distance = orbit.distance * widen;
  camera.fov = OPENING;
  camera.aspect = aspect;
  camera.near = distance / 50;
  camera.far = distance * 20;
  camera.up.copy(axis);
  camera.position.copy(orbit.target).addScaledVector(towards, distance);
  camera.lookAt(orbit.target);
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

export function turn(orbit: Orbit, side: number, height: number): void {
  orbit.side = (orbit.side + side) % 360;
  orbit.height = Math.max(-89, Math.min(89, orbit.height + height));
}

/** Moves what is looked at by shares of a view's height, right and up as seen. */
export function pan(orbit: Orbit, camera: PerspectiveCamera, right: number, up: number): void {
  const span = 2 * camera.position.distanceTo(orbit.target) * Math.tan((OPENING * Math.PI) / 360);
  const { elements } = camera.matrixWorld;
  orbit.target.addScaledVector(new Vector3(elements[0], elements[1], elements[2]), right * span);
  orbit.target.addScaledVector(new Vector3(elements[4], elements[5], elements[6]), up * span);
}

export function zoom(orbit: Orbit, factor: number): void {
  orbit.distance = Math.max(0.5, Math.min(5000, orbit.distance * factor));
}
