// Effects: what the faults that are on predict and what is seen, and which pixels a late word changed.

import { difference, predicted, seen } from "./compare.js";

/** Wires `at`, the elements by id, to `model` and `tube`. `failed` is told of faults. */
export function effectsPanel(at, model, tube, { failed }) {
  let standing = null;
  let without = null;
  /** The pixel that the late word changed most, as column, line and levels. */
  let most = null;
  const isShown = () => at("without").getAttribute("aria-pressed") === "true";

  model.addEventListener("picture", ({ detail }) => {
    standing = detail;
    without = null;
    at("without").disabled = true;
    at("without").setAttribute("aria-pressed", "false");
    at("seen").textContent = "";
    at("effect").textContent = "";
    at("largest").hidden = true;
    at("predicted").replaceChildren();
  });

  const compare = async () => {
    if (standing === null) return;
    const { faults } = await model.faults();
    const rows = predicted(faults, model.view.faults);
    const shown = standing;
    const healthy = await model.healthy();
    if (shown !== standing) return;
    without = healthy;
    at("predicted").replaceChildren(...rows.map((text) => Object.assign(document.createElement("li"), { textContent: text })));
    const found = difference(shown.planes.picture, healthy.planes.picture);
    at("seen").textContent = seen(found);
    at("without").disabled = false;
  };

  /** Marks the pixels that late words changed: a late event, or its place as "260:60". */
  const effect = async (late) => {
    at("effect").textContent = "Drawing the frame with the words in time.";
    at("largest").hidden = true;
    const shown = standing;
    const { document: told } = await model.beside((machine, which) => machine.effect(late, which));
    const [{ changed, seen: levels, pixels, largest }] = told.frames;
    if (shown !== standing) return;
    tube.changed(pixels);
    most = largest;
    at("largest").hidden = !most;
    const where = largest ? ` The largest is ${largest[2]} levels at column ${largest[0]}, line ${largest[1]}.` : "";
    if (changed === 0) {
      at("effect").textContent = "The word changed no pixel of this frame: the beam did not show what it was late for.";
      return;
    }
    at("effect").textContent = `The word changed ${changed} pixels, ${levels} of them by a grey level or more.${where} Orange pixels are brighter by it, blue ones darker. Other frames: ${told.later}.`;
  };
  const tell = (late) => effect(late).catch((error) => { at("effect").textContent = ""; failed(error); });

  at("largest").addEventListener("click", () => model.show({ column: most[0], line: most[1] }));
  at("compare").addEventListener("click", () => compare().catch(failed));
  at("without").addEventListener("click", ({ target }) => {
    target.setAttribute("aria-pressed", String(!isShown()));
    const { planes, hash } = isShown() ? without : standing;
    tube.show(planes.picture, hash);
    tube.mark(model.view.column, model.view.line);
  });
  model.addEventListener("explained", ({ detail }) => {
    const told = detail?.document;
    const word = (told?.late ?? []).findLast(({ in_force: isInForce }) => isInForce);
    at("word").disabled = !word;
    at("word").dataset.late = word ? JSON.stringify({ sweep: told.place.sweep, event: "late", level: word.level, crossing: word.crossing }) : "";
  });
  at("word").addEventListener("click", ({ target }) => tell(target.dataset.late));
  return tell;
}
