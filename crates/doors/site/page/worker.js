// The worker that holds the module. It takes one request at a time and knows nothing of what requests mean.

let machine = null;

/** The bytes of the module's memory from an address on. The memory may have grown since the last look. */
function memory(at, length) {
  return new Uint8Array(machine.memory.buffer, at, length);
}

function answer(request) {
  const at = machine.reserve(request.length);
  if (at === 0) return { refused: `there is no memory for a request of ${request.length} bytes` };
  memory(at, request.length).set(request);
  machine.answer();
  const reply = memory(machine.reply(), machine.reply_length()).slice();
  machine.release();
  return { reply, memory: machine.memory.buffer.byteLength };
}

/** What the module said before it ended; the words of the browser where it said nothing. */
function lastWords(error) {
  try {
    const text = memory(machine.panic_message(), machine.panic_message_length());
    return text.length ? new TextDecoder().decode(text) : String(error);
  } catch {
    return String(error);
  }
}

self.onmessage = async ({ data }) => {
  try {
    if (data.module) {
      machine = (await WebAssembly.instantiate(data.module, {})).exports;
      self.postMessage({ ready: true });
    } else if (data.fail) {
      machine.fail();
    } else {
      const answered = answer(data.request);
      self.postMessage(answered, answered.reply ? [answered.reply.buffer] : []);
    }
  } catch (error) {
    self.postMessage({ ended: lastWords(error) });
  }
};
