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

/** Fills the body of `table`; answers how many are late. `effect` is called with a late event whose pixels are wanted, as text. */
export function showEvents(table, events, tickUs, effect) {
  const rows = events.filter((event, at) => at < FIRST || isLate(event)).map((event) => {
    const row = document.createElement("tr");
    const slack = event.slack_ticks === null ? "" : `${Math.round(event.slack_ticks * tickUs * 1000)} ns`;
    for (const text of [event.time_us.toFixed(3), event.unit, event.event, about(event), slack]) {
      row.append(Object.assign(document.createElement("td"), { textContent: text }));
    }
    row.classList.toggle("late", isLate(event));
    row.append(pixels(event, effect));
    return row;
  });
  table.tBodies[0].replaceChildren(...rows);
  return events.filter(isLate).length;
}

/** A cell with a button for the pixels of a late event; empty for another. */
function pixels(event, effect) {
  const cell = document.createElement("td");
  if (!WORDS.has(event.event)) return cell;
  const button = Object.assign(document.createElement("button"), { type: "button", textContent: "Pixels" });
  button.setAttribute("aria-label", `Pixels that this late event changed, at ${event.time_us.toFixed(3)} µs`);
  button.addEventListener("click", () => effect(JSON.stringify(event)));
  cell.append(button);
  return cell;
}
