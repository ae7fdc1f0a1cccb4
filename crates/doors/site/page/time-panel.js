// The controls of time: the bar, the reader's marks, the search for late frames, and slow motion.

import { LateFrames } from "./late-frames.js";
import { TimeBar } from "./time-bar.js";

/** Wires `at`, the elements by id, to the drives of `model` and to slow motion. `stop` ends playing; `failed` is told of faults. */
export function timePanel(at, model, slow, { stop, failed }) {
  const bar = new TimeBar(at("bar"), at("marks"), model);
  const late = new LateFrames(model);
  for (const name of ["picture", "driven", "opened"]) model.addEventListener(name, () => bar.show());

  at("mark").addEventListener("click", () => {
    const text = at("mark-text").value.trim() || "mark";
    model.drives.marks.push({ lane: model.lane, frame: model.view.frame, text });
    bar.show();
  });
  at("find-late").addEventListener("click", async ({ target }) => {
    const isOn = target.getAttribute("aria-pressed") === "true";
    late.stop();
    target.setAttribute("aria-pressed", String(!isOn));
    if (isOn) return;
    const { frames } = model;
    await late.find((done, found) => {
      at("late-says").textContent = `${found} late frames among ${done} of ${frames}.`;
      bar.show();
    }).catch(failed);
    target.setAttribute("aria-pressed", "false");
  });

  const rate = () => Number(at("rate").value);
  const go = (once) => {
    stop();
    once().catch((error) => { slow.leave(); failed(error); });
  };
  at("slow-on").addEventListener("click", () => go(() => slow.run(rate())));
  at("slow-back").addEventListener("click", () => go(() => slow.run(-rate())));
  at("slow-pause").addEventListener("click", () => slow.stop());
  at("sweep-on").addEventListener("click", () => go(() => slow.step(1)));
  at("sweep-back").addEventListener("click", () => go(() => slow.step(-1)));
  at("slow-leave").addEventListener("click", () => slow.leave());
  slow.addEventListener("moved", ({ detail: way }) => {
    at("slow-on").setAttribute("aria-pressed", String(way > 0));
    at("slow-back").setAttribute("aria-pressed", String(way < 0));
  });
  at("rate").addEventListener("change", () => {
    const way = at("slow-on").getAttribute("aria-pressed") === "true" ? 1 : at("slow-back").getAttribute("aria-pressed") === "true" ? -1 : 0;
    if (way) go(() => slow.run(way * rate()));
  });
}
