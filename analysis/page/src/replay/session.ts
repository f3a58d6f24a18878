// A replay while it is shown: what is shown, and what brings it about.

import { h } from "../dom";
import { writeAddress, type Shown } from "./address";
import { MOMENT_WORDS } from "./captions";
import { onThemeChange } from "./colors";
import { makeControls, type Wishes } from "./controls";
import { endOfBar, type Field } from "./fields";
import { makeFigure } from "./figure";
import { keysHelp, onKeys } from "./keys";
import { orbitFrom, orbitNumbers, startOrbit } from "./orbit";
import { download, figurePicture } from "./picture";
import { makePace } from "./pace";
import { pinnedPanel } from "./pinned";
import { makePlayer, nearestStep, next, stay, type Timeline } from "./player";
import { listen } from "./pointer";
import { MOMENTS } from "./replay_data";
import type { Recording } from "./recording";
import { makeStage } from "./stage";

const NO_WEBGL =
  "This browser shows no WebGL, which the replay is drawn with. It may be switched off, or the graphics driver is not supported: " +
  "try another browser, or hardware acceleration in this one's settings.";
const ADDRESS_DELAY = 250; // ms: browsers refuse addresses that change faster

/** @param shown changes in place @param labels of all strategies of the report: their colours are by this order */
export function runReplay(body: HTMLElement, recordings: Recording[], labels: string[], shown: Shown, ended: AbortSignal): void {
  const { replay } = recordings[0]!;
  const timeline = timelineOf(recordings);
  const colors = recordings.map((one) => `var(--series-${Math.max(0, labels.indexOf(one.replay.label)) % 7})`);
  const figure = makeFigure(recordings, colors);
  const orbit = shown.camera ? orbitFrom(shown.camera) : startOrbit(replay.view);
  const stage = makeStage(recordings, figure.places, figure.ground, orbit);
  if (!stage) return body.replaceChildren(h("p", { role: "alert" }, NO_WEBGL));
  figure.ground.prepend(stage.canvas);

  const autoplay = shown.step === null && !shown.bare && !matchMedia("(prefers-reduced-motion: reduce)").matches;
  const goal = nearestStep(timeline, replay.deepest);
  let at = nearestStep(timeline, shown.step ?? (autoplay ? 0 : replay.deepest));
  let stopAt = autoplay ? goal : -1;
  const player = makePlayer(advance, () => (update(), remember()));
  const pinned = h("div", {});
  const wishes: Wishes = {
    change: (changes) => {
      if (changes.moment) player.stop();
      Object.assign(shown, changes);
      update();
      remember();
    },
    go: (steps) => wishes.scrub(at + steps),
    scrub: (to) => {
      player.stop();
      at = Math.max(0, Math.min(timeline.steps.length - 1, to));
      update();
      remember();
    },
    play: () => {
      stopAt = -1;
      if (!player.playing && !next(timeline, { at, moment: shown.moment }, shown.through)) at = 0;
      player.toggle();
    },
    resetCamera: () => {
      stage.orbit = startOrbit(replay.view);
      shown.camera = null;
      redraw();
      remember();
    },
    save: () => {
      const picture = figurePicture(figure.element, stage.canvas, stage.draw);
      redraw();
      void download(picture, `replay-${recordings.map((one) => one.replay.label.replace(/\W+/g, "-")).join("_")}-step-${shown.step}.png`);
    },
  };
  const controls = makeControls(timeline.steps.length - 1, wishes);
  const moved = (move: () => void) => {
    move();
    shown.camera = orbitNumbers(stage.orbit);
    stage.orbit = orbitFrom(shown.camera); // what the address says, to the last bit
    redraw();
    remember();
  };
  const camera = {
    turn: (right: number, down: number) => moved(() => stage.turn(right, down)),
    pan: (right: number, down: number) => moved(() => stage.pan(right, down)),
    zoom: (factor: number) => moved(() => stage.zoom(factor)),
  };
  onKeys(wishes, camera, timeline.steps.length - 1, ended);
  listen(figure.ground, { ...camera, pick: (x, y) => wishes.change({ vertex: stage.pick(x, y) }) }, ended);

  const pace = makePace((share) => {
    const coarse = share < 1 && !shown.bare; // a picture never is
    stage.draw((coarse ? share : 1) * devicePixelRatio, coarse);
    body.dataset.drawn = String(shown.step);
  }, stage.finished);
  const redraw = pace.ask;
  const tops = new Map<Field, number>();
  function update(): void {
    shown.step = timeline.steps[at]!;
    if (!tops.has(shown.color)) tops.set(shown.color, endOfBar(shown.color === "none" ? [] : recordings, shown.color));
    const top = tops.get(shown.color)!;
    const when = `step ${shown.step}, ${timeline.seconds[at]!.toFixed(3)} s`;
    figure.update(shown.step, shown, top, `${replay.conditions} · ${when} · ${MOMENT_WORDS[shown.moment]}`);
    controls.update(shown, at, player.playing, when);
    pinned.replaceChildren(...(shown.vertex === null || 3 * shown.vertex >= recordings[0]!.rest.length ? [] : [
      pinnedPanel(recordings, shown.vertex, shown.step, shown.moment, colors, () => wishes.change({ vertex: null }))]));
    stage!.show(shown.step, shown, top);
    redraw();
  }

  function advance(): number | null {
    const place = next(timeline, { at, moment: shown.moment }, shown.through);
    const reached = stopAt >= 0 && at >= stopAt && shown.moment === "handled";
    if (!place || reached) return null;
    [at, shown.moment] = [place.at, place.moment];
    update();
    return stay(timeline, place, shown.through, shown.speed);
  }

  let writing: ReturnType<typeof setTimeout> | undefined;
  function remember(): void {
    clearTimeout(writing);
    if (player.playing) return;
    writing = setTimeout(() => history.replaceState(null, "", writeAddress(recordings.map((one) => one.replay.caseId), shown)), ADDRESS_DELAY);
  }

  const sizes = new ResizeObserver(() => (figure.arrange(), redraw()));
  onThemeChange(() => (stage.repaint(), update()), ended);
  ended.addEventListener("abort", () => {
    player.stop();
    clearTimeout(writing);
    pace.stop();
    sizes.disconnect();
    stage.dispose();
  });
  body.replaceChildren(figure.element, controls.transport, controls.options, keysHelp(), pinned);
  stage.repaint();
  figure.arrange();
  sizes.observe(figure.ground);
  if (autoplay && shown.through) shown.moment = MOMENTS[0]!;
  update();
  if (autoplay) player.toggle();
}

/** The steps of the recording that goes furthest; the others stand still when theirs end. */
function timelineOf(recordings: Recording[]): Timeline {
  const longest = recordings.reduce((a, b) => (b.frames.length > a.frames.length ? b : a));
  return { steps: Array.from(longest.frames), seconds: Array.from(longest.time) };
}
