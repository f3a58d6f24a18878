// Mouse and touch: drag turns, drag with two fingers, the right button or Shift moves, wheel and pinch zoom, a click picks.

export interface Gestures {
  turn(right: number, down: number): void; // pixels
  pan(right: number, down: number): void; // pixels
  zoom(factor: number): void;
  pick(x: number, y: number): void; // in the window
}

const CLICK = 4; // pixels: a pointer that moved less was clicked

export function listen(element: HTMLElement, gestures: Gestures, until: AbortSignal): void {
  const down = new Map<number, { x: number; y: number }>();
  let travelled = 0;
  const options = { signal: until };
  element.addEventListener("pointerdown", (event) => {
    if (down.size === 0) travelled = 0;
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
    element.setPointerCapture(event.pointerId);
  }, options);
  element.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const [x, y] = [event.clientX - before.x, event.clientY - before.y];
    travelled += Math.hypot(x, y);
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    if (other) {
      const spread = (at: { x: number; y: number }) => Math.hypot(at.x - other.x, at.y - other.y);
      gestures.zoom(spread(before) / Math.max(1, spread({ x: event.clientX, y: event.clientY })));
      gestures.pan(x / 2, y / 2);
    } else if (event.shiftKey || event.buttons & 6) gestures.pan(x, y);
    else gestures.turn(x, y);
    down.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }, options);
  const up = (event: PointerEvent) => {
    if (down.delete(event.pointerId) && event.type === "pointerup" && travelled < CLICK && event.button === 0)
      gestures.pick(event.clientX, event.clientY);
  };
  element.addEventListener("pointerup", up, options);
  element.addEventListener("pointercancel", up, options);
  element.addEventListener("wheel", (event) => {
    event.preventDefault();
    gestures.zoom(Math.exp(event.deltaY * (event.deltaMode ? 0.03 : 0.001)));
  }, { ...options, passive: false });
  element.addEventListener("contextmenu", (event) => event.preventDefault(), options);
}
