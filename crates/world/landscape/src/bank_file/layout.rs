//! Sizes, offsets and names of the container; docs/bank-format.md is their other copy.

/// First eight bytes of a bank file.
pub(super) const MAGIC: [u8; 8] = *b"LUNOBANK";
/// Version of the container that is written; newer ones are refused.
pub const FORMAT: u32 = 1;
/// Header, table entry, level header: bytes each, and what section offsets are multiples of.
pub(super) const BLOCK: usize = 64;
/// Bytes of a checksum (BLAKE3).
pub(super) const HASH: usize = 32;

/// Kind of a section that holds one level.
pub(super) const LEVEL: [u8; 8] = *b"level\0\0\0";
/// Kind of the section that holds the place on the Moon.
pub(super) const PLACE: [u8; 8] = *b"place\0\0\0";
/// Kind of the section that holds the direction of true north.
pub(super) const NORTH: [u8; 8] = *b"north\0\0\0";
/// Kind of the section that says how the axes lie in the map of the elevation file.
pub(super) const MAP: [u8; 8] = *b"map\0\0\0\0\0";
/// Kind of the section that holds the regions without data.
pub(super) const VOIDS: [u8; 8] = *b"voids\0\0\0";
/// Kind of the section that holds the title.
pub(super) const TITLE: [u8; 8] = *b"title\0\0\0";

/// Where the file's length stands in the header.
pub(super) const FILE_LENGTH_AT: usize = 16;
/// Where the checksum of the table stands in the header.
pub(super) const TABLE_HASH_AT: usize = 32;
/// Where the checksum of a section stands in its table entry.
pub(super) const SECTION_HASH_AT: usize = 32;

/// The next multiple of [`BLOCK`].
pub(super) fn aligned(length: usize) -> usize {
    length.next_multiple_of(BLOCK)
}
