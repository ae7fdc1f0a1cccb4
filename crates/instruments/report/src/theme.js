"use strict";
// Before anything is painted: that there is a script, and the colours that were chosen last. A page from a disk may have no
// store of its own.
document.documentElement.dataset.script = "on";
try {
  const word = localStorage.getItem("lunoid-theme");
  if (["light", "dark"].includes(word)) document.documentElement.dataset.theme = word;
} catch { /* as the system prefers */ }
