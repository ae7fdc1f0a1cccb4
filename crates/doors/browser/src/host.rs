//! A session with its buffers.

use loop_protocol::Session;

use crate::Page;

/// A session, and the bytes of the request and of the reply.
pub struct Host {
    session: Session<Page>,
    request: Vec<u8>,
    reply: Vec<u8>,
}

impl Default for Host {
    fn default() -> Self {
        Self { session: Session::new(Page), request: Vec::new(), reply: Vec::new() }
    }
}

impl Host {
    /// Room for a request of `length` bytes; `None` where there is no memory for it.
    pub fn reserve(&mut self, length: usize) -> Option<&mut [u8]> {
        self.request.clear();
        self.request.try_reserve_exact(length).ok()?;
        self.request.resize(length, 0);
        Some(&mut self.request)
    }

    /// Answers the request in the buffer, whose memory is let go.
    pub fn answer(&mut self) {
        let request = std::mem::take(&mut self.request);
        self.reply = self.session.answer_bytes(&request);
    }

    /// Bytes of the last reply; none before the first.
    pub fn reply(&self) -> &[u8] {
        &self.reply
    }

    /// Lets the last reply go.
    pub fn release(&mut self) {
        self.reply = Vec::new();
    }
}
