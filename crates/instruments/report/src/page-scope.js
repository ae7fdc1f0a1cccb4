"use strict";
/* Scopes of sweeps. Those of recorded sweeps are drawn when they are opened, from the values that the page has. */
const pageScope = (() => {
  const MOST = 8;
  const run = JSON.parse(document.getElementById("data").textContent);
  const element = (name, properties, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
  };
  const option = (value, text, selected = false) => element("option", { value, textContent: text, selected });
  const labelled = (text, field) => element("label", {}, text + " ", field);

  /* What the scope takes: signals, and a plane of values for each. */
  function traces({ sweep, place, places, signals }, names) {
    const shown = signals.filter(({ name }) => names.includes(name));
    const planes = { places: { values: places } };
    for (const { name, times, values } of shown) {
      planes[name] = { values: values.map(value => value ?? NaN) };
      if (times.length > 0) planes["times:" + name] = { values: times };
    }
    return { sweeps: [sweep, sweep + 1], place, signals: shown, planes };
  }

  /* Fills `box` with a scope of `sweep`. `signals` are those to choose from; `told` makes what the scope takes of the names that are chosen. */
  function fill(box, { frame, sweep, sampleUs, signals, told }) {
    const wires = element("select", { multiple: true, size: 6 }, ...signals.map(({ name }, at) => option(name, name, at < MOST)));
    const across = element("select", {}, option("sample", "sweep time"), option("place", "range"), option("xy", "the first wire (X-Y)"));
    const whole = element("button", { type: "button", textContent: "Whole sweep" });
    const canvas = element("canvas", { tabIndex: 0 });
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `Waveforms of sweep ${sweep} of frame ${frame}`);
    const words = element("p", {});
    words.setAttribute("role", "status");
    const table = element("table", {}, element("thead"), element("tbody"));
    const wide = element("div", { className: "wide", tabIndex: 0 }, table);
    wide.setAttribute("role", "group");
    wide.setAttribute("aria-label", "Values at the cursors and under the pointer");
    box.append(element("div", { className: "scope-fields" }, labelled("Wires", wires), labelled("Across", across), whole), canvas, words, wide);
    const scope = new live.Scope(canvas, values => live.showValues(words, table, values));
    scope.sampleUs = sampleUs;
    const show = () => scope.show(told([...wires.selectedOptions].map(({ value }) => value)));
    wires.onchange = show;
    across.onchange = () => scope.along(across.value);
    whole.onclick = () => scope.whole();
    show();
  }

  function open(box) {
    const waves = run.waves.find(({ frame, sweep }) => frame === Number(box.dataset.frame) && sweep === Number(box.dataset.of));
    const { frame, sweep, sample_us: sampleUs, signals } = waves;
    fill(box, { frame, sweep, sampleUs, signals, told: names => traces(waves, names) });
  }

  for (const box of document.querySelectorAll("details.live")) box.addEventListener("toggle", () => open(box), { once: true });
  return { fill };
})();
