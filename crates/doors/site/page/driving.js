// How far the vehicle goes.

/** Most that the report lets the vehicle do (section 3): 16 km/h, and 30 degrees a second here (chosen). */
export const MOST = { kmh: 16, turn: 30 };

/** What a vehicle at so many km/h and degrees a second does in so many seconds, within what it may. */
export function way(kmh, turn, seconds) {
  const bound = (value, most) => Math.max(-most, Math.min(most, Number(value) || 0));
  return { metres: (bound(kmh, MOST.kmh) / 3.6) * seconds, turn_deg: bound(turn, MOST.turn) * seconds };
}
