"use strict";
(() => {
  const part = name => document.getElementById(name);
  const [mix, relief, shown, blink] = ["mix", "relief", "shown", "blink"].map(part);
  const show = share => {
    mix.value = share;
    relief.style.opacity = share / 100;
    shown.textContent = share <= 0 ? "photograph" : share >= 100 ? "relief" : `${share} % relief`;
  };
  const flip = () => show(Number(mix.value) < 50 ? 100 : 0);
  let clock = 0;
  part("flip").addEventListener("click", flip);
  document.querySelector(".stack").addEventListener("click", flip);
  mix.addEventListener("input", () => show(Number(mix.value)));
  blink.addEventListener("click", () => {
    clearInterval(clock);
    clock = clock ? 0 : setInterval(flip, 600);
    blink.setAttribute("aria-pressed", String(clock !== 0));
  });
  document.addEventListener("keydown", event => {
    if (event.key === " " && !["BUTTON", "INPUT"].includes(event.target.tagName)) {
      event.preventDefault();
      flip();
    }
  });
  show(0);
})();
