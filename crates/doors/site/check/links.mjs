// Every link and every anchor of the pages of a site, and what they load: node links.mjs SITE

import { existsSync } from "node:fs";
import { readdir, readFile } from "node:fs/promises";
import { join, relative } from "node:path";

/** An address that a page of any host can be at. */
const BASE = "http://site/";

/** Elements that load what they name as soon as a page is opened. */
const LOADS = /<(?:img|script|link|source|iframe|video|audio|object|embed)\b[^>]*?\s(?:src|href|data)="([^"]*)"/g;
const NAMES = /\s(?:href|src)="([^"]*)"/g;
const ANCHORS = /\s(?:id|name)="([^"]*)"/g;
const COMMENTS = /<!--.*?-->/gs;

const found = (text, pattern) => [...text.matchAll(pattern)].map(([, value]) => value.replaceAll("&amp;", "&"));

/** The pages of `site`, by their names from there. */
export async function pages(site) {
  const names = await readdir(site, { recursive: true });
  return names.filter((name) => name.endsWith(".html")).sort();
}

/** What is wrong with the links of `site`, in words; and how many there are. */
export async function links(site) {
  const names = await pages(site);
  const texts = new Map(await Promise.all(names.map(async (name) => [name, (await readFile(join(site, name), "utf8")).replace(COMMENTS, "")])));
  const anchors = new Map([...texts].map(([name, text]) => [name, new Set(found(text, ANCHORS))]));
  const faults = [];
  let count = 0;
  for (const [page, text] of texts) {
    for (const address of found(text, LOADS)) {
      if (/^([a-z]+:)?\/\//.test(address)) faults.push(`${page} loads ${address}`);
    }
    for (const address of found(text, NAMES)) {
      const url = new URL(address, BASE + page);
      if (url.origin + "/" !== BASE) continue;
      count += 1;
      const file = relative(".", decodeURIComponent(url.pathname).slice(1)) || page;
      const anchor = decodeURIComponent(url.hash.slice(1));
      if (!existsSync(join(site, file))) faults.push(`${page}: no file for ${address}`);
      // What stands behind the sign in the instrument's address is what it shows.
      else if (anchor && anchors.has(file) && !anchor.includes("=") && !anchors.get(file).has(anchor)) faults.push(`${page}: no anchor for ${address}`);
    }
  }
  return { pages: names.length, links: count, faults };
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const told = await links(process.argv[2]);
  console.log(`${told.pages} pages, ${told.links} links`);
  if (told.faults.length) throw new Error(told.faults.join("\n"));
}
