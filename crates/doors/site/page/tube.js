// The tube: a picture, a marker, and the pixel that is pointed at.

import { pixels } from "./picture.js";

/** How far an arrow key moves the marker, and with Shift (pixels). */
const STEPS = [1, 10];

export class Tube {
  #canvas;
  #image = null;
  #marker = null;

  /** `pick` is called with the column and the line of a pixel that was chosen. */
  constructor(canvas, pick) {
    this.#canvas = canvas;
    canvas.addEventListener("click", (event) => pick(...this.#pixel(event)));
    canvas.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!way || !this.#image) return;
      event.preventDefault();
      const step = STEPS[Number(event.shiftKey)];
      const [column, line] = this.#marker ?? [this.#image.width >> 1, this.#image.height >> 1];
      pick(...this.#inside(column + step * way[0], line + step * way[1]));
    });
  }

  /** Shows a plane `picture` and the hash of its pixels. */
  show(picture, hash) {
    this.#image = pixels(picture);
    this.#canvas.width = this.#image.width;
    this.#canvas.height = this.#image.height;
    this.#canvas.dataset.hash = hash;
    this.#draw();
  }

  /** Marks a pixel, or none. */
  mark(column, line) {
    this.#marker = column === null || line === null ? null : [column, line];
    this.#draw();
  }

  /** Pixels of the screen for one of the picture; "fit" fills the width. */
  zoom(scale) {
    const width = this.#image?.width ?? this.#canvas.width;
    this.#canvas.style.width = scale === "fit" ? "100%" : `${width * Number(scale)}px`;
    this.#canvas.style.imageRendering = Number(scale) > 1 ? "pixelated" : "auto";
  }

  #pixel(event) {
    const { left, top, width, height } = this.#canvas.getBoundingClientRect();
    const share = [(event.clientX - left) / width, (event.clientY - top) / height];
    return this.#inside(Math.floor(share[0] * this.#canvas.width), Math.floor(share[1] * this.#canvas.height));
  }

  #inside(column, line) {
    const { width, height } = this.#canvas;
    return [Math.max(0, Math.min(width - 1, column)), Math.max(0, Math.min(height - 1, line))];
  }

  #draw() {
    if (!this.#image) return;
    const context = this.#canvas.getContext("2d");
    context.putImageData(this.#image, 0, 0);
    if (!this.#marker) return;
    const [x, y] = this.#marker.map((at) => at + 0.5);
    for (const [width, colour] of [[3, "#000"], [1, "#ffd54a"]]) {
      context.lineWidth = width;
      context.strokeStyle = colour;
      context.beginPath();
      for (const [from, to] of [[-12, -4], [4, 12]]) {
        context.moveTo(x + from, y);
        context.lineTo(x + to, y);
        context.moveTo(x, y + from);
        context.lineTo(x, y + to);
      }
      context.stroke();
    }
  }
}
