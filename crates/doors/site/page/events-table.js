// Digital events of a sweep in a table; what is late stands out.

/** Events that stand in the table beside the late ones. */
const FIRST = 400;

/** Events whose words changed pixels. */
const WORDS = new Set(["late", "crater-late", "crater-dropped", "segment-late", "segment-dropped"]);

/** What an event is about, in a few words. */
function about({ colour, register, corner, axis, level, cause, words }) {
  const parts = [colour, register, corner && `corner ${corner.join(", ")}`, axis && `${axis}-fold`, level === "coarse" && level, cause, words > 0 && `${words} words`];
  return parts.filter(Boolean).join(", ");
}

/** Whether words came after they were wanted. */
export function isLate({ event, slack_ticks }) {
  return event === "late" || (slack_ticks !== null && slack_ticks < 0);
}

/**
 * Fills the body of `table` with `{ events, sweep, tick_us }`. Answers what stands above it: of which sweep it is, and how many are late. Times
 * count from the first sample of the sweep, as those of the scope do. `effect` is called with a late event whose pixels are wanted, as text.
 */
export function showEvents(table, { events, sweep, tick_us: tickUs }, { update_hz: rate, sweeps, sample_us: sampleUs }, effect) {
  const start = (1e6 * sweep) / (rate * sweeps);
  const rows = events.filter((event, at) => at < FIRST || isLate(event)).map((event) => {
    const row = document.createElement("tr");
    const slack = event.slack_ticks === null ? "" : `${Math.round(event.slack_ticks * tickUs * 1000)} ns`;
    const time = event.time_us - start;
    for (const text of [time.toFixed(3), (time / sampleUs).toFixed(1), event.unit, event.event, about(event), slack]) {
      row.append(Object.assign(document.createElement("td"), { textContent: text }));
    }
    row.classList.toggle("late", isLate(event));
    row.append(pixels(event, time, effect));
    return row;
  });
  table.tBodies[0].replaceChildren(...rows);
  if (events.length === 0) return { lead: "Digital events of the sweep: none", late: "" };
  const late = events.filter(isLate).length;
  const shown = rows.length < events.length ? `; the first ${FIRST} and all late ones are listed` : "";
  return { lead: `Digital events of sweep ${sweep}: `, late: `${events.length} events, ${late} of them late${shown}` };
}

/** A cell with a button for the pixels of a late event; empty for another. */
function pixels(event, time, effect) {
  const cell = document.createElement("td");
  if (!WORDS.has(event.event)) return cell;
  const button = Object.assign(document.createElement("button"), { type: "button", textContent: "Pixels" });
  button.setAttribute("aria-label", `Pixels that this late event changed, at ${time.toFixed(3)} µs of the sweep`);
  button.addEventListener("click", () => effect(JSON.stringify(event)));
  cell.append(button);
  return cell;
}
