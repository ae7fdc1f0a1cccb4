"use strict";
/* Follows a run that is drawn, and goes on to its page when that is there. */
(() => {
  const EVERY_MS = 500;
  const part = id => document.getElementById(id);
  const later = () => setTimeout(ask, EVERY_MS);

  async function ask() {
    if (document.hidden) { later(); return; }
    const reply = await fetch("live.json").catch(() => null);
    if (reply === null) { say("The program has ended or does not answer."); later(); return; }
    if (!reply.ok) { say((await reply.text()).trim().replace(/^lunoid: /, "")); return; }
    const told = await reply.json();
    if (told.is_finished) { location.replace("index.html"); return; }
    follow(told);
    later();
  }

  function follow({ what, done, frames, picture }) {
    part("bar").max = Math.max(1, frames);
    part("bar").value = done;
    const words = `${what[0].toUpperCase()}${what.slice(1)}: ${done} of ${frames}.`;
    say(picture ? `${words} Picture ${picture.index} stands below.` : words);
    if (picture && Number(part("frame").dataset.picture) !== picture.index) show(picture);
  }

  /* A picture is put in when it is decoded, so that none is seen half. */
  function show({ index, file }) {
    const image = new Image();
    image.src = file;
    image.decode().then(() => {
      Object.assign(image, { id: "frame", alt: "Picture " + index });
      image.style.aspectRatio = part("frame").style.aspectRatio;
      image.dataset.picture = index;
      part("frame").replaceWith(image);
    }, () => {});
  }

  function say(text) {
    if (part("said").textContent !== text) part("said").textContent = text;
  }

  ask();
})();
