// The dated record of a run of .ci/site: node record.mjs FROM TO

import { execFileSync } from "node:child_process";
import { readFile, writeFile } from "node:fs/promises";

const [from, to] = process.argv.slice(2);
const said = (program, ...words) => execFileSync(program, words, { encoding: "utf8" }).trim();
const record = {
  schema: "lunoid.site.record/1",
  command: ".ci/site",
  date: new Date().toISOString().slice(0, 10),
  commit: said("git", "rev-parse", "HEAD"),
  rustc: said("rustc", "--version"),
  ...JSON.parse(await readFile(from, "utf8")),
};
await writeFile(to, `${JSON.stringify(record, null, 2)}\n`);
