// Errors in the words of the page. The machine's messages name options of the command line, which a reader of the page does not have.

/** Words of the command line with those of the page, in the order in which they are looked for. */
const WORDS = [
  [/^--set:\d+: /, ""],
  [/^--(machine|overlay): /, ""],
  [/given:/g, ""],
  [/^(\S+): \1: /, "$1: "],
  [/--set (\S+?): /g, "$1: "],
  [/with --set (\S+?)=(\S+)/g, "by the setting $1 = $2"],
  [/--set (\S+?)=(\S+)/g, "the setting $1 = $2"],
  [/give --machine a hardware model/g, "choose a hardware model"],
  [/draw it with --machine (\S+)/g, "choose the machine $1"],
  [/--machine (\S+)/g, "the machine $1"],
  [/--signals (\S+?): /g, "wire $1: "],
  [/`lunoid signals` lists them/g, "the block diagram shows them"],
  [/; a file of your own is named by its path/g, ""],
  [/--set\b/g, "a setting"],
];

/** What an error says to a reader of the page. */
export function inWords(error) {
  return WORDS.reduce((text, [found, instead]) => text.replace(found, instead), error.message);
}

/** What is wrong, without the place, what was found and what was expected. */
export function inShort(error) {
  return inWords({ message: error.problems?.[0].title ?? error.message });
}
