// The dated record of a run of .ci/site: node record.mjs TO FROM...

import { execFileSync } from "node:child_process";
import { readFile, writeFile } from "node:fs/promises";

const [to, ...parts] = process.argv.slice(2);
const said = (program, ...words) => execFileSync(program, words, { encoding: "utf8" }).trim();
const record = {
  schema: "lunoid.site.record/1",
  command: ".ci/site",
  date: new Date().toISOString().slice(0, 10),
  commit: said("git", "rev-parse", "HEAD"),
  rustc: said("rustc", "--version"),
  ...Object.assign({}, ...(await Promise.all(parts.map((part) => readFile(part, "utf8")))).map(JSON.parse)),
};
await writeFile(to, `${JSON.stringify(record, null, 2)}\n`);
