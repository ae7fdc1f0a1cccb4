"use strict";
/* A frame enlarged, machine by machine, and blinking between a machine and the one that it is held against. */
(() => {
  const BLINK = 500;
  const part = id => document.getElementById(id);
  const large = part("large"), shown = part("large-picture");
  let row = [], at = 0, other = null, timer = null;

  const isJudge = link => link.dataset.machine === large.dataset.judge;
  function show(link) {
    const { machine, frame } = link.dataset;
    shown.onerror = () => { shown.onerror = null; shown.src = link.querySelector("img").src; };
    shown.src = link.href;
    shown.alt = `Frame ${frame} by ${machine}`;
    part("large-says").textContent = `Frame ${frame}, ${machine}`;
    shown.dataset.machine = machine;
  }
  function steady() {
    clearInterval(timer);
    timer = null;
    part("large-blink").setAttribute("aria-pressed", false);
  }
  function go(to) {
    steady();
    at = (to + row.length) % row.length;
    other = isJudge(row[at]) ? row[(at + 1) % row.length] : row.find(isJudge) ?? row[(at + 1) % row.length];
    part("large-blink").textContent = `Blink with ${other.dataset.machine}`;
    part("large-blink").disabled = row.length < 2;
    show(row[at]);
  }
  function blink() {
    if (timer !== null) { go(at); return; }
    let isOther = false;
    const turn = () => { isOther = !isOther; show(isOther ? other : row[at]); };
    turn();
    timer = setInterval(turn, BLINK);
    part("large-blink").setAttribute("aria-pressed", true);
  }
  for (const link of document.querySelectorAll(".side a"))
    link.addEventListener("click", event => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      row = [...link.closest(".side").querySelectorAll("a")];
      part("large-place").textContent = "–";
      large.showModal();
      go(row.indexOf(link));
    });
  part("large-before").onclick = () => go(at - 1);
  part("large-next").onclick = () => go(at + 1);
  part("large-blink").onclick = blink;
  part("large-close").onclick = () => large.close();
  large.addEventListener("close", steady);
  large.addEventListener("keydown", event => {
    const act = { ArrowLeft: () => go(at - 1), ArrowRight: () => go(at + 1), b: blink }[event.key];
    if (act) { event.preventDefault(); act(); }
  });

  /* The pixel under the pointer; a click keeps it, whatever machine is shown. */
  let kept = null;
  const placeOf = event => {
    const { left, top, width, height } = shown.getBoundingClientRect();
    const within = (share, count) => Math.max(0, Math.min(count - 1, Math.floor(share * count)));
    return [within((event.clientX - left) / width, Number(large.dataset.columns)), within((event.clientY - top) / height, Number(large.dataset.lines))];
  };
  let under = null;
  const say = () => { part("large-place").textContent = (under ?? kept ?? ["–"]).join(", ") + (kept ? ` (kept: ${kept.join(", ")})` : ""); };
  shown.onpointermove = event => { under = placeOf(event); say(); };
  shown.onpointerleave = () => { under = null; say(); };
  shown.onclick = event => { kept = under ?? placeOf(event); say(); };
})();
