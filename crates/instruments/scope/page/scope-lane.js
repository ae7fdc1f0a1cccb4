// A digital wire of the scope: a gate as levels, and what changes at instants as strokes there.

/** Draws `{ kind, values, times }` into `box`, in the colour `ink`. `times` are instants, where the wire is told when it changes; `x` is the place of one. */
export function lane(context, { kind, values, times }, { left, top, width, height }, x, ink) {
  context.save();
  context.beginPath();
  context.rect(left, top, width, height);
  context.clip();
  context.strokeStyle = ink;
  context.beginPath();
  if (times && kind !== "gate") strokes(context, times, top, height, x);
  else levels(context, { values, times }, { top, height, end: left + width }, x);
  context.stroke();
  context.restore();
}

function strokes(context, times, top, height, x) {
  for (const time of times) {
    context.moveTo(x(time), top + 4);
    context.lineTo(x(time), top + height - 6);
  }
}

function levels(context, { values, times }, { top, height, end }, x) {
  const level = (value) => top + height - 6 - (value > 0.5 ? height - 10 : 0);
  values.forEach((value, at) => {
    const place = x(times ? times[at] : at);
    if (at === 0) context.moveTo(place, level(value));
    else context.lineTo(place, level(values[at - 1]));
    context.lineTo(place, level(value));
  });
  if (values.length > 0) context.lineTo(end, level(values.at(-1)));
}
