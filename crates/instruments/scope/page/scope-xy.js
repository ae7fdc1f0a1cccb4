// One wire of the scope over another (X-Y).

import { trace } from "./curve.js";
import { short } from "./scope-values.js";

/** Draws the second of `wires` over the first into `box`, with what stands behind and the cursors. `extents` are the ends of both. */
export function over(context, { wires: [across, up], box, extents: [[left, right], [low, high]], traces, before, cursors, ink, colour }) {
  const { top, width, height } = box;
  const place = {
    x: (value) => box.left + ((value - left) / (right - left)) * width,
    y: (value) => top + height - ((value - low) / (high - low)) * height,
  };
  const drawn = ({ planes }, colour) => {
    if (planes[across.name] && planes[up.name]) trace(context, planes[across.name].values, planes[up.name].values, { ...place, colour });
  };
  context.globalAlpha = 0.35;
  before.forEach((traces) => drawn(traces, ink));
  context.globalAlpha = 1;
  drawn(traces, colour);
  context.fillStyle = ink;
  context.strokeStyle = ink;
  cursors.forEach((instant, which) => {
    if (instant === null) return;
    const sample = Math.round(instant);
    const [x, y] = [place.x(traces.planes[across.name].values[sample]), place.y(traces.planes[up.name].values[sample])];
    context.strokeRect(x - 4, y - 4, 8, 8);
    context.fillText("AB"[which], x + 7, y - 5);
  });
  context.textAlign = "right";
  context.fillText(short(high), box.left - 4, top + 10);
  context.fillText(short(low), box.left - 4, top + height);
  context.textAlign = "center";
  context.fillText(`${short(left)} to ${short(right)}: ${across.name}; up: ${up.name}`, box.left + width / 2, top + height + 22);
}
