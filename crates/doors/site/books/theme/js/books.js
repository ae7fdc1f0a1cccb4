// What the theme's own pages say inside of them: where the books lie, that no key is a shortcut, and whether they are light or dark.

/* exported base_url, shortcuts */
var base_url = new URL("..", document.currentScript.src).href;
var shortcuts = {};

{
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const look = () => document.documentElement.setAttribute("data-bs-theme", dark.matches ? "dark" : "light");
  dark.addEventListener("change", look);
  look();
}
