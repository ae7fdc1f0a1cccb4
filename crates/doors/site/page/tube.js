// The tube: a picture, how far it has built up, the pixels that a word changed, a marker, and the pixel that is pointed at.

import { pixels } from "./picture.js";

/** How far an arrow key moves the marker, and with Shift (pixels). */
const STEPS = [1, 10];
/** Pixels that a late word made brighter, and darker: orange and blue. */
const CHANGED = [[255, 152, 0], [66, 165, 245]];

export class Tube {
  #canvas;
  #image = null;
  #marker = null;
  #build = null;
  #changed = [];

  /** `pick` is called with the column and the line of a pixel that was chosen. */
  constructor(canvas, pick) {
    this.#canvas = canvas;
    canvas.addEventListener("click", (event) => this.#image && pick(...this.#pixel(event)));
    canvas.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!way || !this.#image) return;
      event.preventDefault();
      const step = STEPS[Number(event.shiftKey)];
      const [column, line] = this.#marker ?? [this.#image.width >> 1, this.#image.height >> 1];
      const to = this.#inside(column + step * way[0], line + step * way[1]);
      // The next key may come before the machine has answered.
      this.mark(...to);
      pick(...to);
    });
  }

  /** Shows a plane `picture` and the hash of its pixels, built up as far as `build` says: see `built`. */
  show(picture, hash, build = null) {
    this.#image = pixels(picture);
    this.#canvas.width = this.#image.width;
    this.#canvas.height = this.#image.height;
    this.#canvas.dataset.hash = hash;
    this.#changed = [];
    this.built(build);
  }

  /**
   * Shows the picture as far as sweep `sweep` has written it: `{ sweep, completes, before }`. `completes` has the sweep that completes each
   * pixel, and `before` is the plane of the picture that stood, or null for a dark tube. Null shows all of it.
   */
  built(build) {
    this.#build = build && { ...build, before: build.before && pixels(build.before) };
    this.#canvas.dataset.built = build ? build.sweep : "";
    this.#draw();
  }

  /** Goes on to another sweep of the same build-up. */
  reach(sweep) {
    this.#build.sweep = sweep;
    this.#canvas.dataset.built = sweep;
    this.#draw();
  }

  /** Marks pixels that something changed, each `[column, line, levels]`; none until the next picture where the list is empty. */
  changed(list) {
    this.#changed = list;
    this.#canvas.dataset.changed = list.length;
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

  /** The picture with what is not written yet, and what was changed. */
  #composed() {
    if (!this.#build && this.#changed.length === 0) return this.#image;
    const composed = new ImageData(new Uint8ClampedArray(this.#image.data), this.#image.width);
    if (this.#build) unwritten(composed, this.#build);
    for (const [column, line, levels] of this.#changed) {
      composed.data.set(CHANGED[Number(levels < 0)], 4 * (line * composed.width + column));
    }
    return composed;
  }

  #draw() {
    if (!this.#image) return;
    const context = this.#canvas.getContext("2d");
    context.putImageData(this.#composed(), 0, 0);
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

/** Puts the picture before into the pixels that are still to come. */
function unwritten(image, { sweep, completes, before }) {
  const now = new Uint32Array(image.data.buffer);
  const was = before && new Uint32Array(before.data.buffer);
  const dark = new Uint32Array(new Uint8Array([0, 0, 0, 255]).buffer)[0];
  for (let pixel = 0; pixel < now.length; pixel += 1) {
    if (completes[pixel] >= sweep) now[pixel] = was ? was[pixel] : dark;
  }
}
