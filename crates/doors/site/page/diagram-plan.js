// Where the blocks stand in the drawing, after the report's overall figure (fig. 14): from the data banks at the left to the tube at the right.

/** Width and height of a block. */
export const SIZE = [140, 46];
/** Size of the drawing. */
export const SHEET = [1400, 600];

/** Upper left corners of the blocks. */
const PLACES = {
  "data-bank": [10, 260],
  dpu: [180, 260],
  "sweep-generator": [330, 20],
  "terrain-generator": [610, 150],
  "feature-generator": [610, 270],
  "shadow-controller": [610, 350],
  "texture-generator": [610, 430],
  "polyhedron-generator": [610, 510],
  "mixing-unit": [920, 270],
  "display-projection-processor": [920, 110],
  "sweep-memory": [1220, 270],
  "picture-tube": [1220, 110],
};

/** Where the values of a block's wires stand, if not right of it. */
const VALUES = { "data-bank": [10, 322], "sweep-memory": [1296, 200] };

/** The way between two blocks where it is not straight: the columns and lines at which it turns. */
const TURNS = {
  "dpu>sweep-generator": [["y", 43]],
  "dpu>terrain-generator": [["x", 500], ["y", 190]],
  "dpu>feature-generator": [["x", 500], ["y", 300]],
  "dpu>shadow-controller": [["x", 500], ["y", 380]],
  "dpu>polyhedron-generator": [["x", 500], ["y", 533]],
  "dpu>sweep-memory": [["y", 590], ["x", 1380], ["y", 293]],
  "sweep-generator>dpu": [["y", 270]],
  "sweep-generator>terrain-generator": [["x", 590], ["y", 165]],
  "sweep-generator>feature-generator": [["x", 590], ["y", 283]],
  "sweep-generator>shadow-controller": [["x", 590], ["y", 363]],
  "sweep-generator>texture-generator": [["x", 590], ["y", 453]],
  "sweep-generator>display-projection-processor": [["y", 43]],
  "terrain-generator>mixing-unit": [["x", 880], ["y", 293]],
  "shadow-controller>mixing-unit": [["x", 880], ["y", 293]],
  "texture-generator>mixing-unit": [["x", 880], ["y", 293]],
  "display-projection-processor>sweep-memory": [["x", 1130], ["y", 285]],
  "polyhedron-generator>sweep-memory": [["x", 1130], ["y", 303]],
};

/** Where the first value of the wires of a block stands. */
export function valuesOf(name, [x, y]) {
  return VALUES[name] ?? [x + SIZE[0] + 5, y + SIZE[1] / 2 + 14];
}

/** The place of each block by name; those of another generator stand in rows. */
export function places(names) {
  const free = names.filter((name) => !(name in PLACES));
  const row = (name) => [10 + (free.indexOf(name) % 9) * 154, 20 + Math.floor(free.indexOf(name) / 9) * 70];
  return new Map(names.map((name) => [name, PLACES[name] ?? row(name)]));
}

/** The points of a way from the middle of a block to that of another, at right angles. */
export function way(from, to, place) {
  const [start, end] = [from, to].map((name) => place.get(name).map((corner, axis) => corner + SIZE[axis] / 2));
  const points = [start];
  for (const [axis, at] of TURNS[`${from}>${to}`] ?? []) {
    const [x, y] = points.at(-1);
    points.push(axis === "x" ? [at, y] : [x, at]);
  }
  const [x, y] = points.at(-1);
  if (x !== end[0] && y !== end[1]) points.push([end[0], y]);
  return [...points, end];
}
