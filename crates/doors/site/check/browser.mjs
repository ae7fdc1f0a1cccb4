// What every browser does alike. Its own class has `script`, which runs a text in the page, and `act`, which takes actions of WebDriver.

/** Keys by their codes in WebDriver. */
const KEYS = { Tab: "\ue004", Enter: "\ue007", Shift: "\ue008", Space: "\ue00d", Left: "\ue012", Up: "\ue013", Right: "\ue014", Down: "\ue015" };

export class Browser {
  /** What the body of an async function returns in the page; `lunoid` is the module of the site, for pages beside it. */
  run(body, ...values) {
    return this.script(`const lunoid = await import(new URL("lunoid.js", document.baseURI)); ${body}`, ...values);
  }

  /** Presses keys as a keyboard does, one after another: names of `KEYS` or letters, with `Shift+` before them. */
  keys(...names) {
    const actions = names.flatMap((name) => {
      const keys = name.split("+").map((word) => KEYS[word] ?? word);
      return [...keys.map((value) => ({ type: "keyDown", value })), ...keys.reverse().map((value) => ({ type: "keyUp", value }))];
    });
    return this.act([{ type: "key", id: "keyboard", actions }]);
  }
}
