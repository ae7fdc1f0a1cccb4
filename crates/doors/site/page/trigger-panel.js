// The controls of the trigger: a condition, what it does, and the next place.

import { PATH } from "./drives.js";

/** Wires `at`, the elements by id, to the trigger of `model`. `stop` ends playing; `failed` is told of faults. */
export function triggerPanel(at, model, { stop, failed }) {
  let run = 0;
  const say = (text) => { at("trigger-says").textContent = text; };
  /** The last condition that the machine took. */
  let known = "";
  const wait = () => {
    run += 1;
    say("");
    model.wait(at("trigger-on").value, at("trigger-mode").value);
  };

  /** Goes on to the next place behind the cursor, frame by frame; the path is searched to its end. */
  const next = async () => {
    const own = (run += 1);
    stop();
    const on = at("trigger-on").value.trim();
    if (on === "") return say("Write a condition first, such as: rising tg.height 12");
    const { lane, frames, view, facts } = model;
    let where = { sweeps: [view.sweep, facts.sweeps], after: view.sample ?? -1 };
    for (let frame = view.frame; frame < frames && own === run; frame += 1) {
      say(`Searching frame ${frame}.`);
      const { places: [place] } = await model.beside((machine) => machine.trigger(on, { ...model.whichOf(lane, frame), ...where }));
      if (place && own === run) return model.lookAtPlace(lane, frame, place);
      where = {};
    }
    if (own === run) say(`No place behind the cursor up to the end of the ${lane === PATH ? "path" : "drive"}.`);
  };

  at("trigger-on").addEventListener("change", wait);
  at("trigger-mode").addEventListener("change", wait);
  at("trigger-arm").addEventListener("click", wait);
  at("trigger-next").addEventListener("click", () => next().catch((error) => { say(""); failed(error); }));
  model.addEventListener("triggered", ({ detail: place }) => {
    const { mode, on } = model.trigger;
    known = on;
    if (place) say(found(place));
    else say(mode === "automatic" ? "Not met in this frame: the sweep of the cursor is shown." : "Not met in this frame: waiting.");
    if (place && mode === "single") stop();
  });
  // A condition that is none is taken back.
  model.addEventListener("fault", ({ detail }) => {
    if (!detail.problems?.some(({ key }) => key === "on")) return;
    if (model.trigger.on === known) known = "";
    at("trigger-on").value = known;
    model.wait(known, model.trigger.mode);
  });
}

function found({ sweep, instant, instant_us: us, range_m: range, values, is_blanked: isBlanked }) {
  const told = Object.entries(values).map(([name, value]) => `${name} ${Number(value.toPrecision(6))}`);
  const time = us === null ? `line ${instant}` : `sample ${instant.toFixed(3)}, ${us.toFixed(3)} µs`;
  const place = range === null ? "" : `, ${range.toFixed(2)} m`;
  return `Met in sweep ${sweep} at ${time}${place}: ${told.join(", ")}.${isBlanked ? " The beam is off there." : ""}`;
}
