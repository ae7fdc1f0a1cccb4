// A picture of the machine on a canvas.

/** The bytes of a canvas for a plane `picture`: grey or colour, 8 or 16 bits a code. */
export function pixels({ shape: [lines, columns, parts = 1], values }) {
  const shift = values instanceof Uint16Array ? 8 : 0;
  const data = new Uint8ClampedArray(4 * lines * columns);
  for (let pixel = 0; pixel < lines * columns; pixel += 1) {
    for (let part = 0; part < 3; part += 1) {
      data[4 * pixel + part] = values[parts * pixel + (parts === 3 ? part : 0)] >> shift;
    }
    data[4 * pixel + 3] = 255;
  }
  return new ImageData(data, columns, lines);
}

/** Shows a plane `picture`, one pixel of the canvas each. */
export function show(canvas, picture) {
  const image = pixels(picture);
  canvas.width = image.width;
  canvas.height = image.height;
  canvas.getContext("2d").putImageData(image, 0, 0);
}
