// Messages of lunoid.loop/1: a prefix of 24 bytes, a header in JSON, planes of little-endian numbers.

const MAGIC = "lunoid.1";
const PREFIX = 24;

/** Array types by the words of a header. */
const ARRAYS = {
  u8: Uint8Array,
  u16: Uint16Array,
  u32: Uint32Array,
  i32: Int32Array,
  f32: Float32Array,
  f64: Float64Array,
};

/** The bytes of a message. A plane is `{ name, dtype, shape, values }`; of bytes alone, `{ name, values: Uint8Array }`. */
export function encode(header, planes = []) {
  const listed = planes.map(({ name, dtype = "u8", shape, values }) => ({ name, dtype, shape: shape ?? [values.length] }));
  const text = new TextEncoder().encode(JSON.stringify(planes.length ? { ...header, planes: listed } : header));
  const parts = planes.map(({ values }) => new Uint8Array(values.buffer, values.byteOffset, values.byteLength));
  const count = parts.reduce((sum, part) => sum + part.length, 0);
  const bytes = new Uint8Array(PREFIX + text.length + count);
  bytes.set(new TextEncoder().encode(MAGIC));
  const view = new DataView(bytes.buffer);
  view.setBigUint64(8, BigInt(text.length), true);
  view.setBigUint64(16, BigInt(count), true);
  bytes.set(text, PREFIX);
  let at = PREFIX + text.length;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

/** The header and the planes of a message. Throws an `Error` if the bytes are none. */
export function decode(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < PREFIX || new TextDecoder().decode(bytes.subarray(0, 8)) !== MAGIC) {
    throw new Error(`a message of ${bytes.length} bytes that does not begin with ${MAGIC}`);
  }
  const end = PREFIX + Number(view.getBigUint64(8, true));
  const { planes: listed = [], ...header } = JSON.parse(new TextDecoder().decode(bytes.subarray(PREFIX, end)));
  let at = end;
  const planes = listed.map(({ name, dtype, shape }) => {
    const Numbers = ARRAYS[dtype];
    const length = shape.reduce((product, axis) => product * axis, 1) * Numbers.BYTES_PER_ELEMENT;
    // A copy of its own lies at a multiple of the size of its numbers.
    const values = new Numbers(bytes.slice(at, at + length).buffer);
    at += length;
    return { name, dtype, shape, values };
  });
  if (at !== bytes.length) throw new Error(`a message of ${bytes.length} bytes whose planes end at ${at}`);
  return { header, planes };
}
