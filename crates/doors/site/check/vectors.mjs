// Which vector instructions a module has: of fixed width, or relaxed ones, whose results differ from machine to machine.

/** Reads numbers of a binary one after another. */
class Reader {
  constructor(bytes, at = 0) {
    this.bytes = bytes;
    this.at = at;
  }

  byte() {
    return this.bytes[this.at++];
  }

  /** A number in LEB128; its sign is of no use here. */
  leb() {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = this.byte();
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  }

  skip(count) {
    this.at += count;
  }

  times(count, read) {
    for (let done = 0; done < count; done += 1) read();
  }

  memoryArgument() {
    this.leb();
    this.leb();
  }
}

/** The first of the relaxed instructions behind the prefix 0xfd. */
const RELAXED = 0x100;

/** Counts of vector instructions in the code of a module. */
export function vectors(bytes) {
  const reader = new Reader(bytes, 8);
  const counts = { fixed: 0, relaxed: 0 };
  while (reader.at < bytes.length) {
    const [section, length] = [reader.byte(), reader.leb()];
    const end = reader.at + length;
    if (section === 10) reader.times(reader.leb(), () => walk(reader, counts));
    reader.at = end;
  }
  return counts;
}

function walk(reader, counts) {
  const length = reader.leb();
  const end = reader.at + length;
  reader.times(reader.leb(), () => reader.memoryArgument());
  while (reader.at < end) instruction(reader, counts);
  if (reader.at !== end) throw new Error(`an instruction at ${reader.at} goes beyond its function`);
}

function instruction(reader, counts) {
  const code = reader.byte();
  if (code === 0xfd) return vector(reader, counts);
  if (code === 0xfc) return long(reader);
  if (code === 0x0e) return reader.times(reader.leb() + 1, () => reader.leb());
  if (code === 0x1c) return reader.times(reader.leb(), () => reader.byte());
  if (code === 0x43) return reader.skip(4);
  if (code === 0x44) return reader.skip(8);
  if (code === 0x11 || code === 0x13 || (code >= 0x28 && code <= 0x3e)) return reader.memoryArgument();
  const hasOne = [0x02, 0x03, 0x04, 0x0c, 0x0d, 0x10, 0x12, 0x3f, 0x40, 0x41, 0x42, 0xd0, 0xd2].includes(code);
  if (hasOne || (code >= 0x20 && code <= 0x26)) reader.leb();
  return undefined;
}

function long(reader) {
  const code = reader.leb();
  if ([8, 10, 12, 14].includes(code)) reader.memoryArgument();
  else if (code >= 9 && code <= 17) reader.leb();
}

function vector(reader, counts) {
  const code = reader.leb();
  counts[code >= RELAXED ? "relaxed" : "fixed"] += 1;
  if (code <= 11 || code === 92 || code === 93) reader.memoryArgument();
  else if (code === 12 || code === 13) reader.skip(16);
  else if (code >= 21 && code <= 34) reader.skip(1);
  else if (code >= 84 && code <= 91) {
    reader.memoryArgument();
    reader.skip(1);
  }
}
