// The panel of the block diagram: it asks for the values of the wires only while it is open.

import { showBlock } from "./block-card.js";
import { Diagram } from "./diagram.js";

/** Wires `at`, the elements by id, to the blocks of `model`. `scope` is called with a wire that is to be shown; `failed` is told of faults. */
export function diagramPanel(at, model, { scope, failed }) {
  let parameters = [];
  const card = (block) => showBlock(at("block"), block, parameters, scope);
  const diagram = new Diagram(at("diagram"), { wire: scope, block: card });
  const panel = at("diagram-panel");
  const instant = () => diagram.at(model.view.sample ?? 0);

  const fill = async () => {
    const [{ blocks }, { signals }, told] = await Promise.all([model.beside((machine) => machine.blocks()), model.beside((machine) => machine.signals()), model.parameters()]);
    parameters = told.parameters;
    diagram.show(blocks, signals);
    const isEmpty = blocks.length === 0;
    at("sheet").hidden = isEmpty;
    at("block").replaceChildren(isEmpty ? `${model.facts.drawn_by} has no blocks: choose a hardware model to see them.` : "A click on a block shows its parts and numbers, and a click on a wire puts it on the scope.");
    model.watch(diagram.wires);
  };
  const look = () => (panel.open && model.facts ? fill().catch(failed) : model.watch([]));
  panel.addEventListener("toggle", look);
  model.addEventListener("opened", look);
  model.addEventListener("wires", ({ detail }) => {
    diagram.take(detail);
    instant();
  });
  model.addEventListener("cursor", instant);
}
