// Keys by their codes in WebDriver.

export const KEYS = { Tab: "\ue004", Enter: "\ue007", Shift: "\ue008", Space: "\ue00d", Left: "\ue012", Up: "\ue013", Right: "\ue014", Down: "\ue015" };
