//! Whole numbers as bits, by the code of Rice: a quotient in unary, the rest in `k` bits. Rows choose `k` for themselves.

/// Quotients from here on are escaped: the number then follows in 64 bits.
const ESCAPE: u32 = 20;

/// Bits that are written one after the other, the lowest first.
#[derive(Default)]
pub(crate) struct Writer {
    bytes: Vec<u8>,
    waiting: u64,
    count: u32,
}

impl Writer {
    /// Writes the low bits of a number, 32 at most; the number has no others.
    pub fn put(&mut self, value: u64, bits: u32) {
        self.waiting |= value << self.count;
        self.count += bits;
        while self.count >= 8 {
            self.bytes.push(self.waiting as u8);
            self.waiting >>= 8;
            self.count -= 8;
        }
    }

    /// Writes the low bits of a number, 64 at most.
    fn put_long(&mut self, value: u64, bits: u32) {
        self.put(value & low(bits.min(32)), bits.min(32));
        if bits > 32 {
            self.put((value >> 32) & low(bits - 32), bits - 32);
        }
    }

    /// Writes a number in the code with the parameter `k`, 63 at most.
    pub fn rice(&mut self, value: u64, k: u32) {
        let quotient = value >> k;
        if quotient < u64::from(ESCAPE) {
            self.put(1 << quotient, quotient as u32 + 1);
            self.put_long(value, k);
        } else {
            self.put(1 << ESCAPE, ESCAPE + 1);
            self.put_long(value, 64);
        }
    }

    /// All bytes; the last one is filled up with zeros.
    pub fn finish(mut self) -> Vec<u8> {
        if self.count > 0 {
            self.put(0, 8 - self.count);
        }
        self.bytes
    }
}

/// Bits of a number in the code.
pub(crate) fn bits(value: u64, k: u32) -> u64 {
    let quotient = value >> k;
    if quotient < u64::from(ESCAPE) { quotient + 1 + u64::from(k) } else { u64::from(ESCAPE) + 65 }
}

/// Bits that are read one after the other; `None` where they end.
pub(crate) struct Reader<'b> {
    bytes: &'b [u8],
    waiting: u64,
    count: u32,
}

impl<'b> Reader<'b> {
    /// Bits of these bytes.
    pub fn new(bytes: &'b [u8]) -> Self {
        Self { bytes, waiting: 0, count: 0 }
    }

    /// Has 56 bits waiting, or all that are left.
    fn refill(&mut self) {
        if let Some(word) = self.bytes.first_chunk() {
            self.waiting |= u64::from_le_bytes(*word) << self.count;
            let taken = (63 - self.count) / 8;
            self.bytes = &self.bytes[taken as usize..];
            self.count += 8 * taken;
        } else {
            while let (true, Some((first, rest))) = (self.count <= 56, self.bytes.split_first()) {
                self.waiting |= u64::from(*first) << self.count;
                (self.bytes, self.count) = (rest, self.count + 8);
            }
        }
    }

    /// The number of the next bits, 32 at most.
    pub fn take(&mut self, bits: u32) -> Option<u64> {
        self.refill();
        self.took(bits)
    }

    fn took(&mut self, bits: u32) -> Option<u64> {
        self.count = self.count.checked_sub(bits)?;
        let value = self.waiting & low(bits);
        self.waiting >>= bits;
        Some(value)
    }

    /// The number of the next bits, 64 at most.
    fn take_long(&mut self, bits: u32) -> Option<u64> {
        let first = self.take(bits.min(32))?;
        if bits <= 32 { Some(first) } else { Some(first | (self.take(bits - 32)? << 32)) }
    }

    /// The next number in the code with the parameter `k`, 63 at most.
    pub fn rice(&mut self, k: u32) -> Option<u64> {
        self.refill();
        let quotient = self.waiting.trailing_zeros();
        if quotient > ESCAPE {
            return None;
        }
        self.took(quotient + 1)?;
        match quotient {
            ESCAPE => self.take_long(64),
            // 56 bits were waiting, so 32 are left.
            _ if k <= 32 => Some(self.took(k)? | (u64::from(quotient) << k)),
            _ => Some(self.take_long(k)? | (u64::from(quotient) << k)),
        }
    }

    /// Whether all bits are read but for zeros in the last byte.
    pub fn is_finished(&self) -> bool {
        self.bytes.is_empty() && self.count < 8 && self.waiting == 0
    }
}

/// A number whose low bits are set, 63 at most.
fn low(bits: u32) -> u64 {
    (1 << bits) - 1
}
