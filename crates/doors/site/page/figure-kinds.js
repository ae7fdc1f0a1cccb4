// Kinds of living figures: how each shows what its models answer.

import { show } from "./picture.js";
import { inSentence } from "./scope-values.js";
import { Scope } from "./scope.js";

/** How much brighter a difference is shown than it is (chosen). */
const BRIGHTER = 4;

/** The picture of one machine. */
function picture(canvas, [model]) {
  model.addEventListener("picture", ({ detail: { planes } }) => shown(canvas, planes.picture));
}

/** Wires of a sweep on a scope; those of another machine stand behind, where there is one. */
function wave(canvas, models, { across = "sample" }, say) {
  const scope = new Scope(canvas, (told) => say(inSentence(told)));
  scope.along(across);
  const traces = models.map(() => null);
  const drawn = () => {
    if (traces.includes(null)) return;
    canvas.classList.add("shown");
    if (traces[1]) {
      scope.show(traces[1]);
      // The first call of a pair lays the traces behind, the second takes them away.
      if (!scope.keep()) scope.keep();
    }
    scope.show(traces[0]);
    told(canvas, traces[0].planes);
  };
  models.forEach((model, at) => model.addEventListener("traces", ({ detail }) => {
    traces[at] = detail;
    drawn();
  }));
}

/** Where two machines disagree, and by how much. */
function difference(canvas, models, _, say) {
  const pictures = [null, null];
  models.forEach((model, at) => model.addEventListener("picture", ({ detail: { planes } }) => {
    pictures[at] = planes.picture;
    if (!pictures[0] || !pictures[1]) return;
    const { picture, share, rms } = apart(...pictures);
    shown(canvas, picture);
    say(`${(100 * share).toFixed(2)} % of the pixels differ; root mean square ${rms.toFixed(2)} of 255 codes. Black is equal; differences are shown ${BRIGHTER} times as bright.`);
  }));
}

/** Each kind takes a canvas, its models, what the figure says of itself, and a function that is told a sentence. */
export const KINDS = { picture, wave, difference };

function shown(canvas, picture) {
  canvas.classList.add("shown");
  show(canvas, picture);
  told(canvas, { picture });
}

/** Tells the page that the canvas shows `planes` now. */
function told(canvas, planes) {
  canvas.dispatchEvent(new CustomEvent("shown", { bubbles: true, detail: planes }));
}

/** The difference of two pictures of one shape and 8 bits: as a picture, as a share of pixels, and as a root of the mean square. */
export function apart(one, other) {
  if (one.shape.join() !== other.shape.join()) throw new RangeError(`pictures of ${one.shape} and ${other.shape} numbers`);
  const [lines, columns, parts = 1] = one.shape;
  const values = one.values.map((value, at) => Math.min(255, BRIGHTER * Math.abs(value - other.values[at])));
  let [differ, squares] = [0, 0];
  for (let pixel = 0; pixel < lines * columns; pixel += 1) {
    const steps = Array.from({ length: parts }, (_, part) => one.values[parts * pixel + part] - other.values[parts * pixel + part]);
    differ += Number(steps.some((step) => step !== 0));
    squares += steps.reduce((sum, step) => sum + step * step, 0) / parts;
  }
  return { picture: { shape: one.shape, values }, share: differ / (lines * columns), rms: Math.sqrt(squares / (lines * columns)) };
}
