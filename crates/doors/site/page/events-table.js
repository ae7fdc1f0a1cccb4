// Digital events of a sweep in a table; what is late stands out.

/** Events that stand in the table beside the late ones. */
const FIRST = 400;

/** What an event is about, in a few words. */
function about({ colour, register, corner, axis, level, cause, words }) {
  const parts = [colour, register, corner && `corner ${corner.join(", ")}`, axis && `${axis}-fold`, level === "coarse" && level, cause, words > 0 && `${words} words`];
  return parts.filter(Boolean).join(", ");
}

/** Whether words came after they were wanted. */
export function isLate({ event, slack_ticks }) {
  return event === "late" || (slack_ticks !== null && slack_ticks < 0);
}

/** Fills the body of `table`; answers how many are late. */
export function showEvents(table, events, tickUs) {
  const rows = events.filter((event, at) => at < FIRST || isLate(event)).map((event) => {
    const row = document.createElement("tr");
    const slack = event.slack_ticks === null ? "" : `${Math.round(event.slack_ticks * tickUs * 1000)} ns`;
    for (const text of [event.time_us.toFixed(3), event.unit, event.event, about(event), slack]) {
      row.append(Object.assign(document.createElement("td"), { textContent: text }));
    }
    row.classList.toggle("late", isLate(event));
    return row;
  });
  table.tBodies[0].replaceChildren(...rows);
  return events.filter(isLate).length;
}
