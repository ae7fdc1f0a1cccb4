// The scenarios that lie beside the page.

/** What can be opened: see `Shipped` in lunoid.d.ts. */
export async function scenarios() {
  return (await (await fetched("scenarios.json")).json()).scenarios;
}

/** The contents of files of the site by their names. */
export async function contents(names) {
  const content = async (name) => [name, new Uint8Array(await (await fetched(name)).arrayBuffer())];
  return Object.fromEntries(await Promise.all(names.map(content)));
}

async function fetched(name) {
  const response = await fetch(new URL(name, import.meta.url));
  if (!response.ok) throw new Error(`${name}: the server says ${response.status}; build the site again`);
  return response;
}
