// Curves on a canvas.

/** The first of so many samples, whose places `x` grow, that lies at `place` or beyond; `count` where none does. */
export function firstAt(place, x, count) {
  let [low, high] = [0, count];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (x(middle) < place) low = middle + 1;
    else high = middle;
  }
  return low;
}

/**
 * Draws a signal: the lowest and the highest value that fall on a column, so no peak is lost. It breaks where a value is no number. Nothing is
 * drawn outside of `bounds`, the first and the last column; what lies next outside leads to them.
 */
export function curve(context, values, { x, y, bounds: [first, last], colour }) {
  context.save();
  context.beginPath();
  context.rect(first, 0, last - first, context.canvas.height);
  context.clip();
  context.strokeStyle = colour;
  context.lineWidth = 1.5;
  context.beginPath();
  let [column, low, high, pen] = [null, 0, 0, false];
  const put = () => {
    if (column === null) return;
    if (!pen) context.moveTo(column, y(low));
    pen = true;
    context.lineTo(column, y(low));
    context.lineTo(column, y(high));
  };
  const end = Math.min(values.length - 1, firstAt(last, x, values.length));
  for (let sample = Math.max(0, firstAt(first, x, values.length) - 1); sample <= end; sample += 1) {
    const [at, value] = [Math.round(x(sample)), values[sample]];
    if (!Number.isFinite(value)) {
      put();
      [column, pen] = [null, false];
    } else if (at === column) {
      [low, high] = [Math.min(low, value), Math.max(high, value)];
    } else {
      put();
      [column, low, high] = [at, value, value];
    }
  }
  put();
  context.stroke();
  context.restore();
}

/** Draws one signal over another, sample by sample. */
export function trace(context, across, up, { x, y, colour }) {
  context.strokeStyle = colour;
  context.beginPath();
  let pen = false;
  across.forEach((value, sample) => {
    const isPoint = Number.isFinite(value) && Number.isFinite(up[sample]);
    if (isPoint && pen) context.lineTo(x(value), y(up[sample]));
    else if (isPoint) context.moveTo(x(value), y(up[sample]));
    pen = isPoint;
  });
  context.stroke();
}
