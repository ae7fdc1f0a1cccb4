//! What decoders of JPEG pass over in silence.

/// Bytes of a marker's head: the marker itself, then the length of its segment.
const MARKER: usize = 2;

/// Components of the picture, from its frame header: 1 grey, 3 colour, 4 inks. Nothing if there is no frame header.
pub fn components(bytes: &[u8]) -> Option<u8> {
    let mut at = MARKER;
    loop {
        match *bytes.get(at..at + 4)? {
            // Any number of these may stand in front of a marker.
            [0xFF, 0xFF, ..] => at += 1,
            [0xFF, marker, high, low] if is_frame(marker) => {
                let header =
                    bytes.get(at + MARKER..at + MARKER + usize::from(u16::from_be_bytes([high, low])))?;
                // Length, bits, lines, columns.
                return header.get(2 + 1 + 2 + 2).copied();
            }
            [0xFF, _, high, low] => at += MARKER + usize::from(u16::from_be_bytes([high, low])),
            _ => return None,
        }
    }
}

/// Start of frame, of any process; four codes of the range mean something else.
fn is_frame(marker: u8) -> bool {
    (0xC0..=0xCF).contains(&marker) && ![0xC4, 0xC8, 0xCC].contains(&marker)
}

/// Whether the end of the image stands behind the start of its last scan. Within a scan no marker can stand by chance; a
/// small picture for previews has its own end in front of the scan.
pub fn is_whole(bytes: &[u8]) -> bool {
    let last = |marker: u8| bytes.windows(MARKER).rposition(|pair| pair == [0xFF, marker]);
    let (scan, end) = (last(0xDA), last(0xD9));
    end > scan
}
