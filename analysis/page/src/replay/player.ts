// The timeline: which of the kept steps is shown, and how it goes on while playing.

import { MOMENTS, type Moment } from "./replay_data";

export interface Timeline {
  steps: number[]; // kept, ascending
  seconds: number[]; // of each
}

export interface Place {
  at: number; // of the timeline's steps
  moment: Moment;
}

/** The kept step that is nearest. */
export function nearestStep({ steps }: Timeline, step: number): number {
  let best = 0;
  steps.forEach((one, k) => {
    if (Math.abs(one - step) < Math.abs(steps[best]! - step)) best = k;
  });
  return best;
}

/** How long a place is shown at a speed, in s. Going through the moments, each has its share of the step. */
export function stay({ seconds }: Timeline, place: Place, through: boolean, speed: number): number {
  const last = seconds.length - 1;
  const [from, to] = place.at < last ? [place.at, place.at + 1] : [Math.max(0, last - 1), last];
  return (seconds[to]! - seconds[from]!) / speed / (through ? MOMENTS.length : 1);
}

/** What comes next; null at the end. */
export function next({ steps }: Timeline, place: Place, through: boolean): Place | null {
  const moment = MOMENTS.indexOf(place.moment);
  if (through && moment + 1 < MOMENTS.length) return { at: place.at, moment: MOMENTS[moment + 1]! };
  if (place.at + 1 >= steps.length) return null;
  return { at: place.at + 1, moment: through ? MOMENTS[0]! : place.moment };
}

export interface Player {
  playing: boolean;
  toggle(): void;
  stop(): void;
}

/** Calls `advance` when it is time for the next place; it returns the seconds until the one after, or null to stop. */
export function makePlayer(advance: () => number | null, changed: (playing: boolean) => void): Player {
  let due = 0;
  let request = 0;
  const player: Player = { playing: false, toggle: () => (player.playing ? player.stop() : start()), stop };
  function start(): void {
    player.playing = true;
    due = performance.now();
    request = requestAnimationFrame(tick);
    changed(true);
  }
  function stop(): void {
    if (!player.playing) return;
    player.playing = false;
    cancelAnimationFrame(request);
    changed(false);
  }
  function tick(now: number): void {
    if (now >= due) {
      const wait = advance();
      if (wait === null) return stop();
      due = Math.max(due + 1000 * wait, now - 100); // a slow machine shows every step, only later
    }
    if (player.playing) request = requestAnimationFrame(tick);
  }
  return player;
}
