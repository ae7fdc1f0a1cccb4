// Ticks of the axis of the scope, each as its place across and its text.

import { firstAt } from "./curve.js";
import { short } from "./scope-values.js";

/** Ticks of an axis less one, at most. */
const TICKS = 6;

/** Ticks at round numbers of samples between `from` and `to`, no nearer than whole samples. `x` is the place of a sample. */
export function sampleTicks(from, to, x) {
  const least = (to - from) / TICKS;
  const decade = 10 ** Math.floor(Math.log10(least));
  const step = Math.max(1, [1, 2, 5, 10].map((times) => times * decade).find((size) => size >= least * (1 - 1e-9)));
  const first = Math.ceil(from / step - 1e-9);
  const count = Math.floor(to / step + 1e-9) - first + 1;
  return Array.from({ length: count }, (_, at) => [x((first + at) * step), String(Math.round((first + at) * step))]);
}

/** Ticks at even distances from `left` on, with what `values` are there. `x` is the place of a sample. */
export function placeTicks(values, x, left, width) {
  return Array.from({ length: TICKS + 1 }, (_, tick) => {
    const at = left + (tick / TICKS) * width;
    const next = Math.max(1, Math.min(values.length - 1, firstAt(at, x, values.length)));
    const [low, high] = [x(next - 1), x(next)];
    const share = Math.max(0, Math.min(1, (at - low) / (high - low)));
    return [at, short(values[next - 1] + share * (values[next] - values[next - 1]))];
  });
}
