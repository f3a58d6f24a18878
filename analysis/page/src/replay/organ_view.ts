// The organ of one view: its surface, its edges and the facets that are in the tool.

import {
  BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Group, LineBasicMaterial, LineSegments, Mesh,
  MeshLambertMaterial, type Plane,
} from "three";
import type { Shown } from "./address";
import { TABLE } from "./color_map";
import type { Colors } from "./colors";
import { fieldValues } from "./fields";
import { verticesAt, type Recording } from "./recording";
import { MOMENTS, type Moment } from "./replay_data";

export interface OrganView {
  group: Group;
  geometry: BufferGeometry;
  positions: Float32Array; // mm, of what is shown
  pose(frame: number, moment: Moment): void;
  /** Colours and marks, after a pose. @param top the value at the end of the colour map */
  dress(frame: number, shown: Shown, top: number): void;
  paint(colors: Colors): void;
  clip(planes: Plane[]): void;
  /** Leaves out edges that are there beside the surface: many lines take longer than all else where there is no graphics card. */
  simplify(simple: boolean): void;
  dispose(): void;
}

export function organView(recording: Recording): OrganView {
  const { facets, edges } = recording.organ;
  const positions = new Float32Array(recording.rest.length);
  const normals = new Float32Array(positions.length);
  const shades = new Float32Array(positions.length).fill(1);
  const values = new Float32Array(positions.length / 3);
  const position = dynamic(positions);
  const [normal, color] = [dynamic(normals), dynamic(shades)];

  const geometry = new BufferGeometry();
  geometry.setIndex(new BufferAttribute(facets, 1));
  geometry.setAttribute("position", position).setAttribute("normal", normal).setAttribute("color", color);
  const wires = new BufferGeometry().setAttribute("position", position);
  wires.setIndex(new BufferAttribute(edges, 1));
  const marked = new BufferGeometry().setAttribute("position", position).setAttribute("normal", normal);
  const outlined = new BufferGeometry().setAttribute("position", position);
  const most = mostCrossing(recording);
  marked.setIndex(dynamicIndex(3 * most));
  outlined.setIndex(dynamicIndex(6 * most));

  const skin = new MeshLambertMaterial({
    side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
  });
  const wire = new LineBasicMaterial({ transparent: true, opacity: 0.4 });
  const mark = new MeshLambertMaterial({ side: DoubleSide });
  const markEdge = new LineBasicMaterial();
  const body = new Mesh(geometry, skin);
  const net = new LineSegments(wires, wire);
  const marks = new Mesh(marked, mark);
  const markEdges = new LineSegments(outlined, markEdge);
  const group = new Group().add(body, net, marks, markEdges);
  for (const object of group.children) object.frustumCulled = false;

  let wired = true;
  return {
    group,
    geometry,
    positions,
    pose: (frame, moment) => {
      verticesAt(recording, frame, moment, positions);
      smoothNormals(positions, facets, normals);
      position.needsUpdate = normal.needsUpdate = true;
    },
    dress: (frame, shown, top) => {
      const coloured = shown.color !== "none";
      if (coloured) {
        fieldValues(recording, shown.color, frame, shown.moment, positions, values);
        shade(values, top, shades);
        color.needsUpdate = true;
      }
      if (skin.vertexColors !== coloured) {
        skin.vertexColors = coloured;
        skin.needsUpdate = true;
      }
      skin.color.copy(coloured ? WHITE : skin.userData.own);
      body.visible = shown.surface !== "wire";
      wired = shown.surface !== "solid";
      wire.opacity = shown.surface === "wire" ? 0.75 : 0.28;
      const crossing = shown.hidden.includes("crossing") ? [] : recording.crossing(frame, shown.moment);
      markFacets(crossing, facets, marked.index!, outlined.index!);
      marked.setDrawRange(0, coloured || shown.surface === "wire" ? 0 : 3 * crossing.length); // the colours stay to be seen
      outlined.setDrawRange(0, 6 * crossing.length);
    },
    paint: (colors) => {
      skin.userData.own = colors.organ;
      wire.color.copy(colors.edge);
      mark.color.copy(colors.mark);
      markEdge.color.copy(colors.deep);
    },
    clip: (planes) => {
      for (const material of [skin, wire, mark, markEdge]) material.clippingPlanes = planes;
    },
    simplify: (simple) => {
      net.visible = wired && !(simple && body.visible);
    },
    dispose: () => {
      for (const one of [geometry, wires, marked, outlined, skin, wire, mark, markEdge]) one.dispose();
    },
  };
}

const WHITE = { r: 1, g: 1, b: 1 } as import("three").Color;

function dynamic(values: Float32Array): BufferAttribute {
  return new BufferAttribute(values, 3).setUsage(DynamicDrawUsage);
}

function dynamicIndex(size: number): BufferAttribute {
  return new BufferAttribute(new Uint32Array(size), 1).setUsage(DynamicDrawUsage);
}

function mostCrossing(recording: Recording): number {
  let most = 0;
  for (let frame = 0; frame < recording.frames.length; frame++)
    for (const moment of MOMENTS) most = Math.max(most, recording.crossing(frame, moment).length);
  return most;
}

function markFacets(marked: ArrayLike<number>, facets: Uint32Array, index: BufferAttribute, edges: BufferAttribute): void {
  for (let k = 0; k < marked.length; k++) {
    for (let end = 0; end < 3; end++) {
      const vertex = facets[3 * marked[k]! + end]!;
      index.array[3 * k + end] = vertex;
      edges.array[6 * k + 2 * end] = vertex;
      edges.array[6 * k + ((2 * end + 5) % 6)] = vertex;
    }
  }
  index.needsUpdate = edges.needsUpdate = true;
}

function shade(values: Float32Array, top: number, shades: Float32Array): void {
  for (let v = 0; v < values.length; v++) {
    const row = 3 * Math.min(255, Math.round((255 * values[v]!) / (top || 1)));
    shades[3 * v] = TABLE[row]!;
    shades[3 * v + 1] = TABLE[row + 1]!;
    shades[3 * v + 2] = TABLE[row + 2]!;
  }
}

/** Unit normals at the vertices: the facets' normals, weighted by area. */
function smoothNormals(positions: Float32Array, facets: Uint32Array, normals: Float32Array): void {
  normals.fill(0);
  for (let f = 0; f < facets.length; f += 3) {
    const [a, b, c] = [3 * facets[f]!, 3 * facets[f + 1]!, 3 * facets[f + 2]!];
    const [ax, ay, az] = [positions[a]!, positions[a + 1]!, positions[a + 2]!];
    const [ux, uy, uz] = [positions[b]! - ax, positions[b + 1]! - ay, positions[b + 2]! - az];
    const [vx, vy, vz] = [positions[c]! - ax, positions[c + 1]! - ay, positions[c + 2]! - az];
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (let end = 0; end < 3; end++) {
      const at = 3 * facets[f + end]!;
      normals[at]! += x;
      normals[at + 1]! += y;
      normals[at + 2]! += z;
    }
  }
  for (let at = 0; at < normals.length; at += 3) {
    const length = Math.hypot(normals[at]!, normals[at + 1]!, normals[at + 2]!) || 1;
    normals[at]! /= length;
    normals[at + 1]! /= length;
    normals[at + 2]! /= length;
  }
}
