// Where the blocks stand in the drawing, after the report's overall figure (fig. 14): from the data banks at the left to the tube at the right.

/** Width and height of a block. */
export const SIZE = [128, 46];
/** Size of the drawing. */
export const SHEET = [1180, 590];

/** Upper left corners of the blocks. */
const PLACES = {
  "data-bank": [10, 260],
  dpu: [180, 260],
  "sweep-generator": [390, 20],
  "terrain-generator": [560, 120],
  "feature-generator": [560, 250],
  "shadow-controller": [560, 330],
  "texture-generator": [560, 410],
  "polyhedron-generator": [560, 490],
  "mixing-unit": [760, 250],
  "display-projection-processor": [760, 110],
  "sweep-memory": [1020, 250],
  "picture-tube": [1020, 110],
  "vehicle-shadow": [1020, 490],
};

/** Corners between the ends of a way, where a straight one would cross blocks: the columns and lines at which it turns. */
const TURNS = {
  "dpu>sweep-generator": [["y", 43]],
  "dpu>terrain-generator": [["x", 340], ["y", 156]],
  "dpu>feature-generator": [["x", 340], ["y", 273]],
  "dpu>shadow-controller": [["x", 340], ["y", 353]],
  "dpu>polyhedron-generator": [["x", 340], ["y", 513]],
  "dpu>sweep-memory": [["y", 570], ["x", 1160], ["y", 273]],
  "sweep-generator>dpu": [["x", 360], ["y", 283]],
  "sweep-generator>terrain-generator": [["x", 540], ["y", 130]],
  "sweep-generator>feature-generator": [["x", 540], ["y", 260]],
  "sweep-generator>shadow-controller": [["x", 540], ["y", 340]],
  "sweep-generator>texture-generator": [["x", 540], ["y", 433]],
  "sweep-generator>display-projection-processor": [["y", 43], ["x", 824]],
};

/** The place of each block by name; those of another generator stand in rows. */
export function places(names) {
  const free = names.filter((name) => !(name in PLACES));
  const row = (name) => [10 + (free.indexOf(name) % 8) * 146, 20 + Math.floor(free.indexOf(name) / 8) * 70];
  return new Map(names.map((name) => [name, PLACES[name] ?? row(name)]));
}

/** The points of a way from block to block, at right angles. */
export function way(from, to, place) {
  const [[x, y], [u, v]] = [place.get(from), place.get(to)];
  const [width, height] = SIZE;
  const turns = TURNS[`${from}>${to}`];
  if (turns) return turned([x + width / 2, y + height / 2], turns, [u + width / 2, v + height / 2]);
  const [start, end] = [[x + width / 2, y + height / 2], [u + width / 2, v + height / 2]];
  if (start[0] === end[0] || start[1] === end[1]) return [start, end];
  const middle = u > x ? (x + width + u) / 2 : start[0];
  return turned(start, [["x", middle], ["y", end[1]]], end);
}

function turned(start, turns, end) {
  const points = [start];
  for (const [axis, at] of turns) {
    const [x, y] = points.at(-1);
    points.push(axis === "x" ? [at, y] : [x, at]);
  }
  const [x, y] = points.at(-1);
  if (x !== end[0] && y !== end[1]) points.push([end[0], y]);
  return [...points, end];
}
