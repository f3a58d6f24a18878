// One renderer that draws every view into its own part of one canvas (a context a view would be wasteful, and browsers allow few).

import {
  DirectionalLight, HemisphereLight, PerspectiveCamera, Plane, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import type { Shown } from "./address";
import { readColors } from "./colors";
import { marksView } from "./marks_view";
import { organView } from "./organ_view";
import { pan, placeCamera, turn, zoom, type Orbit } from "./orbit";
import { frameAt, type Recording } from "./recording";
import { sectionView, turnPlane } from "./section";
import { toolView } from "./tool_view";

export interface Stage {
  canvas: HTMLCanvasElement;
  orbit: Orbit;
  /** Shows a step, in the colours up to `top`. */
  show(step: number, shown: Shown, top: number): void;
  repaint(): void; // once the ground is in the page, and after a change of the theme
  /** Draws; the views' places are read from their elements. @param scale pixels of the picture for each of the page
   * @param simple without what takes long */
  draw(scale: number, simple?: boolean): void;
  finished(): Promise<void>; // when the renderer has drawn all that it was told to
  turn(right: number, down: number): void; // pixels
  pan(right: number, down: number): void;
  zoom(factor: number): void;
  /** The vertex nearest to what is seen at a place of the window, or null. */
  pick(x: number, y: number): number | null;
  dispose(): void;
}

type View = ReturnType<typeof viewOf>;

/** Null where the browser has no WebGL. @param places the element of each view, all in `ground` */
export function makeStage(recordings: Recording[], places: HTMLElement[], ground: HTMLElement, orbit: Orbit): Stage | null {
  const canvas = document.createElement("canvas");
  const renderer = makeRenderer(canvas);
  if (!renderer) return null;
  const sight = recordings[0]!.replay.view;
  const camera = new PerspectiveCamera();
  const plane = new Plane();
  const views = recordings.map((recording) => viewOf(recording, plane));
  let cut = true;
  const unit = () => places[0]!.clientHeight || 1;
  const stage: Stage = {
    canvas,
    orbit,
    show: (step, shown, top) => {
      cut = shown.cut;
      for (const view of views) view.show(frameAt(view.recording, step), shown, top);
      for (const view of views) view.clip(cut ? [plane] : []);
    },
    repaint: () => {
      const colors = readColors(ground);
      renderer.setClearColor(colors.ground);
      for (const view of views) view.paint(colors);
    },
    draw: (scale, simple = false) => {
      const around = ground.getBoundingClientRect();
      renderer.setPixelRatio(scale);
      renderer.setSize(around.width, around.height, false);
      renderer.setScissorTest(false);
      renderer.clear();
      renderer.setScissorTest(true);
      places.forEach((place, k) => {
        const box = place.getBoundingClientRect();
        if (!box.width || !box.height) return;
        const [left, bottom] = [box.left - around.left, around.bottom - box.bottom];
        renderer.setViewport(left, bottom, box.width, box.height);
        renderer.setScissor(left, bottom, box.width, box.height);
        placeCamera(camera, stage.orbit, sight, box.width / box.height);
        turnPlane(plane, sight, camera.position);
        views[k]!.light(camera);
        views[k]!.organ.simplify(simple);
        renderer.clear();
        renderer.render(views[k]!.scene, camera);
      });
    },
    finished: () => fence(renderer.getContext() as WebGL2RenderingContext),
    turn: (right, down) => turn(stage.orbit, -right * 0.4, down * 0.4),
    pan: (right, down) => pan(stage.orbit, camera, -right / unit(), down / unit()),
    zoom: (factor) => zoom(stage.orbit, factor),
    pick: (x, y) => {
      const k = places.findIndex((place) => within(place.getBoundingClientRect(), x, y));
      if (k < 0) return null;
      const box = places[k]!.getBoundingClientRect();
      placeCamera(camera, stage.orbit, sight, box.width / box.height);
      const at = new Vector2((2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height);
      return nearestVertex(views[k]!, at, camera, cut ? plane : null);
    },
    dispose: () => {
      for (const view of views) view.dispose();
      renderer.dispose();
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
  return stage;
}

function makeRenderer(canvas: HTMLCanvasElement): WebGLRenderer | null {
  const wishes = { antialias: true, stencil: true, preserveDrawingBuffer: true };
  if (!canvas.getContext("webgl2", wishes)) return null; // three would write an error to the console
  const renderer = new WebGLRenderer({ canvas, ...wishes });
  renderer.localClippingEnabled = true;
  renderer.autoClear = false;
  return renderer;
}

/** When all that was asked of the context is done. */
function fence(gl: WebGL2RenderingContext): Promise<void> {
  const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  return new Promise((done) => {
    const look = () => {
      if (sync && !gl.isContextLost() && gl.getSyncParameter(sync, gl.SYNC_STATUS) === gl.UNSIGNALED) return void setTimeout(look, 2);
      gl.deleteSync(sync);
      done();
    };
    look();
  });
}

/** The scene of one case. */
function viewOf(recording: Recording, plane: Plane) {
  const sight = recording.replay.view;
  const organ = organView(recording);
  const tool = toolView(recording);
  const marks = marksView(recording, 0.016 * sight.halfHeight);
  const section = sectionView(recording, organ, tool, plane);
  const lamp = new DirectionalLight(0xffffff, 2.1);
  const scene = new Scene().add(organ.group, tool.group, section.group, marks.group);
  scene.add(lamp, lamp.target, new HemisphereLight(0xffffff, 0x8d8894, 1.5));
  return {
    recording,
    scene,
    organ,
    show: (frame: number, shown: Shown, top: number) => {
      organ.pose(frame, shown.moment);
      organ.dress(frame, shown, top);
      tool.pose(frame);
      tool.group.visible = !shown.hidden.includes("tool");
      marks.pose(frame, shown, organ.positions);
      section.group.visible = shown.cut;
      if (shown.cut) section.pose(shown.surface !== "wire");
    },
    clip: (planes: Plane[]) => {
      for (const part of [organ, tool, marks]) part.clip(planes);
    },
    paint: (colors: ReturnType<typeof readColors>) => {
      for (const part of [organ, tool, marks, section]) part.paint(colors);
    },
    /** The lamp goes with the camera: from the right and above. */
    light: (camera: PerspectiveCamera) => {
      lamp.position.set(0.45, 0.8, 0.6).transformDirection(camera.matrixWorld);
    },
    dispose: () => {
      for (const part of [organ, tool, marks, section]) part.dispose();
    },
  };
}

function within(box: DOMRect, x: number, y: number): boolean {
  return x >= box.left && x < box.right && y >= box.top && y < box.bottom;
}

function nearestVertex(view: View, at: Vector2, camera: PerspectiveCamera, plane: Plane | null): number | null {
  const caster = new Raycaster();
  caster.setFromCamera(at, camera);
  const body = view.organ.group.children[0]!;
  view.organ.geometry.computeBoundingSphere();
  const hit = caster.intersectObject(body, false).find(({ point }) => !plane || plane.distanceToPoint(point) >= 0);
  if (!hit?.face) return null;
  const { positions } = view.organ;
  const away = (vertex: number) => new Vector3().fromArray(positions, 3 * vertex).distanceToSquared(hit.point);
  return [hit.face.a, hit.face.b, hit.face.c].reduce((best, vertex) => (away(vertex) < away(best) ? vertex : best));
}
