// The first page: one mountain, torn by late words and healed, in turn.

import { Lunoid, WorkerHome } from "./lunoid.js";
import { show } from "./picture.js";
import { contents } from "./shipped.js";

const SCENARIO = "scenarios/first-light.toml";
const FRAME = 60;
const LATE = { "loader.access_ns": 90 };
/** Milliseconds that each picture stands. */
const STANDS = 1500;

const canvas = document.getElementById("tube");
const state = document.getElementById("state");
const pause = document.getElementById("pause");

const megabytes = (bytes) => (bytes / 1e6).toFixed(1);

/** Says what the worker does, in a sentence. */
function hear({ phase, bytes, reason }) {
  if (phase === "loading") state.textContent = `Loading the machine: ${megabytes(bytes)} MB.`;
  if (phase === "compiled") state.textContent = "Starting the machine.";
  if (phase === "working") state.textContent = "The machine draws.";
  if (phase === "ended") state.textContent = `The machine ended and was started again: ${reason}`;
}

/** The picture with the settings `set`, by a worker of its own. */
async function drawn(files, set) {
  const machine = new Lunoid(new WorkerHome({ hear }));
  try {
    await machine.open(SCENARIO, { files, set });
    const { hash, planes } = await machine.frame(FRAME);
    return { hash, picture: planes.picture };
  } finally {
    machine.close();
  }
}

/** Shows `views` in turn until the page goes. */
function alternate(views) {
  let at = 0;
  let stands = false;
  const turn = () => {
    if (stands) return;
    const { name, says, picture, hash } = views[at % views.length];
    show(canvas, picture);
    canvas.setAttribute("aria-label", says);
    canvas.dataset.view = name;
    canvas.dataset.hash = hash;
    state.textContent = says;
    at += 1;
  };
  pause.disabled = false;
  pause.addEventListener("click", () => {
    stands = !stands;
    pause.textContent = stands ? "Go on" : "Pause";
  });
  turn();
  setInterval(turn, STANDS);
}

async function run() {
  const files = await contents([SCENARIO]);
  const torn = drawn(files, LATE);
  const healed = drawn(files, {});
  // The torn one stands until the other is drawn.
  const first = await torn;
  show(canvas, first.picture);
  alternate([
    { name: "torn", says: "Words 90 ns late: the mountain is torn.", ...first },
    { name: "healed", says: "Words in time: the mountain is whole.", ...(await healed) },
  ]);
}

run().catch((error) => {
  state.textContent = `The machine could not draw: ${error.message}`;
});
