// Where frames take long (a machine without a graphics card), what moves is drawn coarser, and sharp again once it rests.

const LONG = 70; // ms: more is no motion
const REST = 250; // ms without a new frame

export interface Pace {
  /** Asks for a frame. */
  ask(): void;
  stop(): void;
}

/** @param draw at a share of the full resolution; has to return only when the frame is there */
export function makePace(draw: (share: number) => void): Pace {
  let request = 0;
  let rest: ReturnType<typeof setTimeout> | undefined;
  let slow = false;
  let last = -Infinity; // when a frame was asked for
  const frame = (share: number) => {
    const start = performance.now();
    draw(share);
    const took = performance.now() - start;
    if (share === 1) slow = took > LONG;
  };
  return {
    ask: () => {
      const moves = performance.now() - last < REST;
      last = performance.now();
      cancelAnimationFrame(request);
      clearTimeout(rest);
      request = requestAnimationFrame(() => {
        const coarse = slow && moves;
        frame(coarse ? 0.5 : 1);
        if (coarse) rest = setTimeout(() => frame(1), REST);
      });
    },
    stop: () => {
      cancelAnimationFrame(request);
      clearTimeout(rest);
    },
  };
}
