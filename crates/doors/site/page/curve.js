// Curves on a canvas.

/**
 * Draws `values` from left to right. A column of the canvas keeps its lowest and its highest value, so no peak is lost. The curve breaks where
 * a value is no number, and outside of `bounds`, the first and the last column.
 */
export function curve(context, values, { x, y, bounds: [first, last], colour }) {
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
  values.forEach((value, sample) => {
    const at = Math.round(x(sample));
    if (at < first || at > last) return;
    if (!Number.isFinite(value)) {
      put();
      [column, pen] = [null, false];
    } else if (at === column) {
      [low, high] = [Math.min(low, value), Math.max(high, value)];
    } else {
      put();
      [column, low, high] = [at, value, value];
    }
  });
  put();
  context.stroke();
  context.lineWidth = 1;
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
