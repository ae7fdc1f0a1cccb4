"use strict";
(() => {
  const part = id => document.getElementById(id);
  const run = JSON.parse(part("data").textContent);
  const screen = part("screen"), last = run.end - 1;
  const svgLine = name => { const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
                            line.setAttribute("class", name); return line; };
  const clamp = (value, low, high) => Math.max(low, Math.min(high, value));
  const fixed = (value, places) => value.toFixed(places).replace(/^-(?=[0.]*$)/, "").replace("-", "\u2212");

  /* Theme */
  const root = document.documentElement, dark = matchMedia("(prefers-color-scheme: dark)");
  const isDark = () => root.dataset.theme ? root.dataset.theme === "dark" : dark.matches;
  function sayTheme() {
    part("theme").textContent = isDark() ? "Light" : "Dark";
    part("theme").setAttribute("aria-pressed", isDark());
    part("theme").setAttribute("aria-label", isDark() ? "Light page" : "Dark page");
  }
  function turnTheme() {
    root.dataset.theme = isDark() ? "light" : "dark";
    try { localStorage.setItem("lunoid-theme", root.dataset.theme); } catch { /* only for this time */ }
    sayTheme();
  }
  part("theme").onclick = turnTheme;
  dark.addEventListener("change", sayTheme);
  sayTheme();

  /* Frames: those to come are decoded before they are due. The page has them at its end, and works before it is read. */
  const AHEAD = 12, KEPT = 28;
  const held = new Map(), first = part("frame").src;
  const nearest = (list, picture) => list.reduce((a, b) => Math.abs(b - picture) < Math.abs(a - picture) ? b : a);
  const isRead = id => part(id)?.nextElementSibling || document.readyState !== "loading";
  async function ofPage(picture) {
    if (picture === run.first) return first;
    while (!isRead("film-" + picture)) await new Promise(done => setTimeout(done, 10));
    return "data:image/png;base64," + part("film-" + picture).textContent;
  }
  const source = async picture => run.film.includes(picture) ? ofPage(picture)
    : "frames/frame-" + String(picture).padStart(6, "0") + ".png";
  const standIn = async picture => run.film.length ? ofPage(nearest(run.film, picture))
    : document.querySelector(`.sheet [data-picture="${nearest(run.strip, picture)}"] img`).src;
  async function decoded(image, address) {
    image.src = address;
    await image.decode();
  }
  function hold(picture) {
    if (held.has(picture)) return held.get(picture);
    const image = new Image();
    const entry = { image, isReady: false, isReduced: false };
    image.decoding = "async";
    image.id = "frame";
    image.alt = "Picture " + picture;
    image.dataset.picture = picture;
    image.draggable = false;
    entry.ready = source(picture).then(address => decoded(image, address)).catch(() => {
      entry.isReduced = true;
      return standIn(picture).then(address => decoded(image, address)).catch(() => {});
    }).then(() => { entry.isReady = true; });
    held.set(picture, entry);
    return entry;
  }
  function holdAround(picture) {
    for (let i = picture; i <= Math.min(picture + AHEAD, last); i++) hold(i);
    if (picture > run.first) hold(picture - 1);
    for (const i of held.keys()) {
      if (held.size <= KEPT) break;
      if (i < picture - 4 || i > picture + AHEAD) held.delete(i);
    }
  }

  let at = run.first, chosen = null;
  const frameOf = picture => Math.floor(picture / run.showings);
  const frame = () => frameOf(at);
  const pose = () => run.poses[frame() - frameOf(run.first)];
  function put(picture, entry) {
    if (picture !== at) return;
    const shown = part("frame");
    if (shown !== entry.image) shown.replaceWith(entry.image);
    part("reduced").hidden = !entry.isReduced;
  }
  function show(picture) {
    at = clamp(picture, run.first, last);
    const entry = hold(at);
    if (entry.isReady) put(at, entry); else { const due = at; entry.ready.then(() => put(due, entry)); }
    holdAround(at);
    read();
    drawMarks();
    drawLate();
    drawChosen();
  }
  function read() {
    const [, x, y, z, heading, pitch, roll] = pose();
    const seconds = at / run.rate;
    part("number").textContent = at;
    part("time").textContent = fixed(seconds, 3) + " s";
    for (const [id, value] of [["north", x], ["east", y], ["height", z]]) part(id).textContent = fixed(value, 2) + " m";
    for (const [id, value] of [["heading", heading], ["pitch", pitch], ["roll", roll]])
      part(id).textContent = fixed(value, 2) + "°";
    part("at").value = at;
    part("at").setAttribute("aria-valuetext", `frame ${at}, ${fixed(seconds, 3)} seconds`);
    for (const link of document.querySelectorAll(".sheet a"))
      if (Number(link.dataset.picture) === at) link.setAttribute("aria-current", "true");
      else link.removeAttribute("aria-current");
  }
  function remember() {
    const place = "#frame=" + frame() + (chosen === null ? "" : "&sweep=" + chosen);
    try { history.replaceState(null, "", place); } catch { /* a page without a place of its own */ }
  }

  /* Play: the clock waits for a frame that is not decoded yet. */
  let playing = false, from = at, since = 0, speed = run.speed;
  const rate = () => run.rate * run.speeds[speed];
  function begin(now) { from = at; since = now; }
  function tick(now) {
    if (!playing) return;
    // The time of a paint may lie before the click that began it.
    const due = from + Math.floor(Math.max(0, now - since) / 1000 * rate());
    if (due > last) { if (hold(run.first).isReady) { show(run.first); begin(now); } }
    else if (due !== at) { if (hold(due).isReady) show(due); else { holdAround(at); begin(now - 1000 / rate() * 0.99); } }
    requestAnimationFrame(tick);
  }
  function sayPlay() {
    part("play").textContent = playing ? "Pause" : "Play";
    part("play").setAttribute("aria-label", playing ? "Pause" : "Play");
  }
  function stop() {
    if (playing) { playing = false; sayPlay(); }
    part("said").textContent = "Frame " + at;
    remember();
  }
  function play() {
    if (playing) { stop(); return; }
    playing = true;
    if (at === last) show(run.first);
    begin(performance.now());
    sayPlay();
    requestAnimationFrame(tick);
  }
  const go = picture => { playing = false; sayPlay(); show(picture); stop(); };
  const step = by => go(at + by);
  function setSpeed(to) {
    speed = clamp(to, 0, run.speeds.length - 1);
    part("speed").value = speed;
    begin(performance.now());
  }
  part("play").onclick = play;
  part("first").onclick = () => go(run.first);
  part("back").onclick = () => step(-1);
  part("on").onclick = () => step(1);
  part("last").onclick = () => go(last);
  part("at").oninput = () => go(Number(part("at").value));
  part("speed").onchange = () => setSpeed(Number(part("speed").value));
  for (const link of document.querySelectorAll(".sheet a"))
    link.onclick = event => {
      if (event.ctrlKey || event.metaKey || event.shiftKey) return;
      event.preventDefault();
      go(Number(link.dataset.picture));
      part("picture").scrollIntoView();
      screen.focus({ preventScroll: true });
    };

  /* Sweeps: report section 15.3 inverted; `sight` has its numbers for each frame. */
  const sight = run.sight;
  const line = () => sight && sight.frames[frame() - sight.first];
  const turned = ([x, y], angle) => [Math.cos(angle) * x - Math.sin(angle) * y, Math.sin(angle) * x + Math.cos(angle) * y];
  function sweepAt(across, down) {
    if (!line()) return null;
    const [edge, sin, cos, yoke] = line(), count = sight.sweeps;
    const [x, y] = turned([across * sight.field[0], down * sight.field[1]], yoke);
    const share = sight.tube ? x / (cos + sin * y) / edge : x / sight.raster;
    return clamp(Math.round(0.5 * ((share + 1) * count - 1)), 0, count - 1);
  }
  /* Two places of the screen between which a sweep lies, far beyond its edges. */
  function ends(sweep) {
    const [edge, sin, cos, yoke] = line(), share = (2 * sweep + 1) / sight.sweeps - 1;
    return [-4, 4].map(times => {
      const y = times * sight.field[1];
      const x = sight.tube ? share * edge * (cos + sin * y) : share * sight.raster;
      const [across, down] = turned([x, y], -yoke);
      return [across / sight.field[0], down / sight.field[1]];
    });
  }
  function draw(element, sweep) {
    const [[x1, y1], [x2, y2]] = sweep === null || !line() ? [[9, -1], [9, 1]] : ends(sweep);
    for (const [name, value] of Object.entries({ x1, y1, x2, y2 })) element.setAttribute(name, value);
  }
  const drawChosen = () => draw(part("chosen"), chosen);
  function drawMarks() {
    part("marks").replaceChildren(...run.scopes.filter(([of]) => of === frame()).map(([, sweep]) => {
      const mark = svgLine("mark");
      draw(mark, sweep);
      return mark;
    }));
  }
  /* Short strokes at both edges of the picture, where the sweeps with misses of its frame begin and end. */
  const EDGE = 0.06;
  function drawLate() {
    const found = run.late.find(([of]) => of === frame());
    const stroke = sweep => {
      const [[x1, y1], [x2, y2]] = ends(sweep);
      const at = y => [x1 + (x2 - x1) * (y - y1) / (y2 - y1), y].map(value => value.toFixed(4)).join(" ");
      return `M${at(-1)}L${at(-1 + EDGE)}M${at(1 - EDGE)}L${at(1)}`;
    };
    part("late").setAttribute("d", found && line() ? found[1].map(stroke).join("") : "");
    if (!part("late-says")) return;
    part("late-says").textContent = found ? `${found[1].length} of ${sight.sweeps}` : "not timed";
  }
  function placeOf(event) {
    const box = screen.getBoundingClientRect();
    const u = clamp((event.clientX - box.left) / box.width, 0, 1), v = clamp((event.clientY - box.top) / box.height, 0, 1);
    const column = Math.min(Math.floor(u * run.columns), run.columns - 1), row = Math.min(Math.floor(v * run.lines), run.lines - 1);
    const middle = (index, count) => (2 * index + 1) / count - 1;
    return { column, row, sweep: sweepAt(middle(column, run.columns), middle(row, run.lines)) };
  }
  /* The place that the readings name. A click has whole coordinates, and could name the pixel beside it. */
  let under = null;
  screen.onpointermove = event => {
    under = placeOf(event);
    const { column, row, sweep } = under;
    part("place").textContent = column + ", " + row;
    if (part("under")) part("under").textContent = sweep ?? "–";
    draw(part("hover"), sweep);
  };
  screen.onpointerleave = () => {
    under = null;
    part("place").textContent = "–";
    if (part("under")) part("under").textContent = "–";
    draw(part("hover"), null);
  };
  screen.onclick = event => {
    const { column, row, sweep } = under ?? placeOf(event);
    if (playing) stop();
    if (sweep === null) look(null, [column, row]); else { choose(sweep); open([column, row]); }
  };

  function choose(sweep) {
    chosen = sweep === null ? null : clamp(sweep, 0, sight.sweeps - 1);
    drawChosen();
    part("look").hidden = true;
    if (chosen !== null) part("said").textContent = "Sweep " + chosen;
    remember();
  }
  const moveCursor = by => { if (line()) { choose((chosen ?? Math.floor(sight.sweeps / 2) - by) + by); look(chosen, null); } };
  const isRecorded = sweep => run.scopes.some(([of, which]) => of === frame() && which === sweep);
  /* To the plot of the chosen sweep, or to the commands that make one. */
  function open(pixel) {
    look(chosen, pixel);
    if (!isRecorded(chosen)) { if (matchMedia("(max-width: 56rem)").matches) part("look").scrollIntoView({ block: "nearest" }); return; }
    const plot = part(`scope-${frame()}-${chosen}`);
    plot.scrollIntoView();
    plot.focus({ preventScroll: true });
  }
  const quoted = word => /^[\w\-./,:=+@%]+$/.test(word) ? word : "'" + word.replaceAll("'", "'\\''") + "'";
  const folder = () => location.protocol === "file:" ? quoted(decodeURIComponent(location.pathname).replace(/\/[^/]*$/, "")) : "FOLDER";
  function commands(sweep, pixel) {
    const stage = run.stage || "SCENARIO", frames = frameOf(run.first) + ".." + (frameOf(last) + 1);
    const list = [];
    if (sweep !== null) list.push(
      ["Its waveforms", `lunoid probe ${stage} --frame ${frame()} --sweep ${sweep} --out sweep.png`],
      ["Put them on this page", `lunoid replay ${stage} --frames ${frames}${run.pictures} --out ${folder()} --probe ${frame()}:${sweep}`]);
    if (pixel && sweep !== null)
      list.splice(1, 0, ["This pixel, to its cause", `lunoid explain ${stage} --frame ${frame()} --pixel ${pixel.join(",")}`]);
    return list;
  }
  function command([what, text]) {
    const item = document.createElement("li"), says = document.createElement("span"), code = document.createElement("code");
    const copy = document.createElement("button");
    says.textContent = what;
    code.textContent = text;
    copy.type = "button";
    copy.textContent = "Copy";
    copy.setAttribute("aria-label", "Copy: " + what);
    copy.onclick = () => copied(text, code, copy);
    item.append(says, code, copy);
    return item;
  }
  function copied(text, code, button) {
    const done = () => { button.textContent = "Copied"; setTimeout(() => { button.textContent = "Copy"; }, 1500); };
    const choose = () => { getSelection().selectAllChildren(code); };
    if (navigator.clipboard) navigator.clipboard.writeText(text).then(done, choose); else choose();
  }
  function look(sweep, pixel) {
    const there = sweep !== null && isRecorded(sweep);
    part("look-title").textContent = sweep === null ? `Pixel ${pixel.join(", ")}` : `Sweep ${sweep} of frame ${frame()}`;
    part("look-text").replaceChildren();
    if (there) {
      const link = document.createElement("a");
      link.href = `#scope-${frame()}-${sweep}`;
      link.textContent = "Its waveforms";
      part("look-text").append(link, " are on this page.");
    } else part("look-text").textContent = sweep === null ? "No sweep drew it: there are no signals behind it." : "It was not recorded.";
    part("commands").replaceChildren(...commands(sweep, pixel).filter(([what]) => !there || what.startsWith("This pixel")).map(command));
    part("look").hidden = false;
    // A page that a program serves computes a sweep that was not recorded.
    document.dispatchEvent(new CustomEvent("sweep", { detail: { frame: frame(), sweep, isRecorded: there } }));
  }
  for (const button of document.querySelectorAll("[data-sweep]"))
    button.onclick = () => {
      go(Number(button.dataset.frame) * run.showings);
      choose(Number(button.dataset.sweep));
      look(chosen, null);
      part("picture").scrollIntoView();
      screen.focus({ preventScroll: true });
    };

  /* Keys: an element that has a use for a key keeps it. */
  const keys = {
    " ": play, "ArrowLeft": event => step(event.shiftKey ? -10 : -1), "ArrowRight": event => step(event.shiftKey ? 10 : 1),
    "Home": () => go(run.first), "End": () => go(last),
    "+": () => setSpeed(speed + 1), "=": () => setSpeed(speed + 1), "-": () => setSpeed(speed - 1),
    ",": () => moveCursor(-1), ".": () => moveCursor(1), "<": () => moveCursor(-10), ">": () => moveCursor(10),
    "Escape": () => choose(null), "d": turnTheme,
  };
  document.addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const own = event.target.closest("button, a, summary, select, .wide");
    if (own && (event.key === " " || event.key === "Enter" || own.matches("select, .wide"))) return;
    if (event.key === "Enter") { if (chosen !== null) open(null); return; }
    const act = keys[event.key];
    if (act) { event.preventDefault(); act(event); }
  });

  /* #frame=12&sweep=500 */
  function follow() {
    const place = /^#frame=(\d+)(?:&sweep=(\d+))?$/.exec(location.hash);
    if (!place) return false;
    playing = false;
    sayPlay();
    show(Number(place[1]) * run.showings);
    if (place[2] !== undefined && line()) { choose(Number(place[2])); look(chosen, null); }
    return true;
  }
  addEventListener("hashchange", () => { if (follow()) part("picture").scrollIntoView(); });
  if (!follow()) show(run.first);
})();
