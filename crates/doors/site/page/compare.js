// The effect that is seen: the picture with what is set, against the same without.

/** How two planes `picture` of one size differ: share of pixels, root of the mean square and largest difference in levels of 255, and where. */
export function difference(with_, without) {
  const levels = with_.values instanceof Uint16Array ? 257 : 1;
  const [lines, columns, parts = 1] = with_.shape;
  let [changed, squares, most, at] = [0, 0, 0, 0];
  for (let pixel = 0; pixel < lines * columns; pixel += 1) {
    let largest = 0;
    for (let part = 0; part < parts; part += 1) {
      const by = (with_.values[parts * pixel + part] - without.values[parts * pixel + part]) / levels;
      squares += by * by;
      largest = Math.max(largest, Math.abs(by));
    }
    changed += Number(largest > 0);
    if (largest > most) [most, at] = [largest, pixel];
  }
  return { share: changed / (lines * columns), rms: Math.sqrt(squares / with_.values.length), most, column: at % columns, line: Math.floor(at / columns) };
}

/** The same in words. */
export function seen({ share, rms, most, column, line }) {
  if (share === 0) return "Seen: no pixel differs. What is set does not bind in this frame.";
  const percent = (100 * share).toPrecision(3);
  return `Seen: ${percent} % of the pixels differ, by ${rms.toPrecision(3)} levels of 255 (root of the mean square), at most ${Math.round(most)} at column ${column}, line ${line}.`;
}

/** What the faults that are on predict, in words. */
export function predicted(faults, on) {
  const rows = faults.filter(({ name }) => on.includes(name));
  return rows.map(({ name, proves, predicts }) => `${name}, predicted: ${proves}. ${predicts}`);
}
