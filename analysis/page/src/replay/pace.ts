// When frames are drawn: one after the other, never more than the renderer keeps up with. Where a frame takes long (a machine without
// a graphics card), what moves is drawn coarser, and sharp again once it rests.

const LONG = 70; // ms: more is no motion
const REST = 250; // ms without a new frame

export interface Pace {
  /** Asks for a frame. */
  ask(): void;
  stop(): void;
}

/** @param draw at a share of the full resolution @param finished when that frame is there */
export function makePace(draw: (share: number) => void, finished: () => Promise<void>): Pace {
  let request = 0;
  let rest: ReturnType<typeof setTimeout> | undefined;
  let slow = false;
  let ended = -Infinity; // when the last frame was there
  let moves = false;
  let [busy, wanted, stopped] = [false, false, false];

  function schedule(): void {
    wanted = true;
    if (busy || stopped) return;
    cancelAnimationFrame(request);
    request = requestAnimationFrame(() => void frame(slow && moves ? 0.5 : 1));
  }

  async function frame(share: number): Promise<void> {
    [busy, wanted] = [true, false];
    const start = performance.now();
    draw(share);
    await finished();
    busy = false;
    ended = performance.now();
    if (share === 1) slow = performance.now() - start > LONG;
    if (wanted) schedule();
    else if (share < 1 && !stopped) rest = setTimeout(() => ((moves = false), schedule()), REST);
  }

  return {
    ask: () => {
      moves = performance.now() - ended < REST || busy;
      clearTimeout(rest);
      schedule();
    },
    stop: () => {
      stopped = true;
      cancelAnimationFrame(request);
      clearTimeout(rest);
    },
  };
}
