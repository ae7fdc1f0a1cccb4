//! Tiles on disk, from run to run.
//!
//! Each question that had to compute tiles leaves one file of them: no file is ever changed, so runs side by side do
//! not disturb each other. A folder that is full keeps what it has. A file has, in little-endian order: magic, key, number of
//! tiles, the tiles, and the BLAKE3 hash of all these.

use std::fs::{self, DirEntry};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use files::{FolderError, Kind};
use landscape::{Landscape, Sun, bank_file};

use crate::axes::SunAxes;
use crate::chains::Chains;
use crate::lattice::{Corner, GroundLattice, Lattice};
use crate::outlines::Corners;
use crate::tile::{Place, STRIPS};
use crate::{Outlines, Tile};

/// Names the format; another number if the meaning of a tile changes.
const MAGIC: [u8; 8] = *b"lnshad03";
/// Digits of the version at the end of the name.
const VERSION_DIGITS: usize = 2;
/// Largest file that is read (bytes).
const MAX_BYTES: u64 = 1 << 30;
const HASH: usize = blake3::OUT_LEN;
const EXTENSION: &str = "shadow";
/// Digits of the key and of the content in a name.
const DIGITS: [usize; 2] = [32, 16];

/// A folder of tiles of one landscape at one resolution.
#[derive(Debug)]
pub(crate) struct Cache {
    folder: PathBuf,
    ground: blake3::Hasher,
    /// Distance between the profiles of the finest tiles (m).
    finest: f64,
    /// Bytes that the folder keeps at most.
    most_bytes: u64,
    /// Bytes of tiles that were there at the start, and of those that came from here.
    held: AtomicU64,
}

/// Whether a file of this name is one of tiles.
pub fn is_tile_file(name: &str) -> bool {
    let is_hexadecimal = |part: &str, digits: usize| {
        part.len() == digits && part.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f'))
    };
    let stem = name.strip_suffix(EXTENSION).and_then(|stem| stem.strip_suffix('.'));
    stem.and_then(|stem| stem.split_once('-'))
        .is_some_and(|(key, own)| is_hexadecimal(key, DIGITS[0]) && is_hexadecimal(own, DIGITS[1]))
}

/// Whether a file that begins with these bytes is one of tiles, of this version of the format or of an earlier one.
pub fn has_tiles(head: &[u8]) -> bool {
    head.starts_with(&MAGIC[..MAGIC.len() - VERSION_DIGITS])
}

impl Cache {
    pub(crate) fn new(folder: &Path, landscape: &Landscape, finest: f64, most_bytes: u64) -> Self {
        let mut ground = blake3::Hasher::new();
        ground.update(&MAGIC);
        ground.update(&STRIPS.to_le_bytes());
        ground.update(&finest.to_le_bytes());
        ground.update(&bank_file::content_hash(landscape.bank()));
        for crater in landscape.features().craters().iter() {
            for number in numbers(&crater) {
                ground.update(&number.to_le_bytes());
            }
        }
        let cache = Self { folder: folder.to_owned(), ground, finest, most_bytes, held: AtomicU64::new(0) };
        Self { held: AtomicU64::new(cache.size()), ..cache }
    }

    /// All tiles of `sun` that are kept, whole and right.
    pub(crate) fn read(&self, sun: &Sun) -> Vec<(Place, Tile)> {
        let key = self.key(sun);
        let prefix = name_prefix(&key);
        let paths = self.files().filter(|(name, _)| name.starts_with(&prefix)).map(|(_, entry)| entry.path());
        let axes = SunAxes::new(sun);
        let lattice = |place| Lattice::new(self.finest, place).on_ground(axes);
        let tiles = paths.filter_map(|path| decode(&files::read_all(&path, MAX_BYTES).ok()?, &key, lattice));
        tiles.flatten().collect()
    }

    /// Keeps `tiles` of `sun` where the folder has room for them; makes the folder if need be.
    pub(crate) fn write(&self, sun: &Sun, tiles: &[(Place, &Arc<Tile>)]) -> Result<(), FolderError> {
        let held = self.held.load(Ordering::Relaxed);
        if held >= self.most_bytes {
            return Ok(());
        }
        let key = self.key(sun);
        let bytes = encode(&key, tiles);
        let more = bytes.len() as u64;
        if more > self.most_bytes - held {
            return Ok(());
        }
        self.held.fetch_add(more, Ordering::Relaxed);
        files::make_folder(&self.folder)?;
        let own = blake3::hash(&bytes).to_hex();
        let name = format!("{}{}.{EXTENSION}", name_prefix(&key), &own[..DIGITS[1]]);
        Ok(files::write_atomic(self.folder.join(name), |out: &mut dyn Write| out.write_all(&bytes))?)
    }

    /// Files of tiles in the folder, links never among them.
    fn files(&self) -> impl Iterator<Item = (String, DirEntry)> {
        let is_folder = Kind::of(&self.folder).is_ok_and(|found| found == Kind::Folder);
        let entries = is_folder.then(|| fs::read_dir(&self.folder)).into_iter().flatten().flatten().flatten();
        let named = entries.map(|entry| (entry.file_name().to_string_lossy().into_owned(), entry));
        named.filter(|(name, entry)| {
            is_tile_file(name) && entry.file_type().is_ok_and(|found| Kind::of_type(found) == Kind::File)
        })
    }

    /// Bytes of all tiles in the folder.
    fn size(&self) -> u64 {
        self.files().filter_map(|(_, entry)| entry.metadata().ok()).map(|found| found.len()).sum()
    }

    fn key(&self, sun: &Sun) -> [u8; HASH] {
        let mut hasher = self.ground.clone();
        hasher.update(&sun.azimuth.to_le_bytes());
        hasher.update(&sun.elevation.to_le_bytes());
        *hasher.finalize().as_bytes()
    }
}

fn numbers(crater: &features::Crater) -> [f64; 8] {
    let (kind, radii) = match crater.shape() {
        features::Shape::Bowl { r1 } => (1.0, [r1, 0.0, 0.0]),
        features::Shape::RimmedBowl { r1, r2 } => (2.0, [r1, r2, 0.0]),
        features::Shape::FlatFloor { r1, r2, r3 } => (3.0, [r1, r2, r3]),
    };
    let [north, east] = crater.centre();
    [kind, north, east, radii[0], radii[1], radii[2], crater.depth(), crater.rim()]
}

fn name_prefix(key: &[u8; HASH]) -> String {
    let hex = blake3::Hash::from_bytes(*key).to_hex();
    format!("{}-", &hex[..DIGITS[0]])
}

fn encode(key: &[u8; HASH], tiles: &[(Place, &Arc<Tile>)]) -> Vec<u8> {
    let mut bytes = [&MAGIC[..], key].concat();
    bytes.extend((tiles.len() as u64).to_le_bytes());
    for (place, tile) in tiles {
        bytes.extend(u64::from(place.level).to_le_bytes());
        bytes.extend(place.at.iter().flat_map(|index| index.to_le_bytes()));
        bytes.extend(tile.spacing.to_le_bytes());
        let (corners, ends) = (lattice_corners(&tile.outlines), tile.outlines.ends());
        bytes.extend([corners.len(), ends.len()].iter().flat_map(|&count| (count as u64).to_le_bytes()));
        for Corner { along, across } in corners {
            bytes.extend(along.to_le_bytes());
            bytes.extend(across.to_le_bytes());
        }
        bytes.extend(ends.iter().flat_map(|end| end.to_le_bytes()));
    }
    let hash = blake3::hash(&bytes);
    bytes.extend(hash.as_bytes());
    bytes
}

/// Corners of a tile as its lattice has them.
fn lattice_corners(outlines: &Outlines) -> Vec<Corner> {
    match outlines.corners() {
        Corners::Anywhere(_) => Vec::new(),
        Corners::OfTile(corners) => corners.iter().collect(),
    }
}

/// The tiles of a file on their lattices; `None` if it is damaged or of another key.
fn decode(
    bytes: &[u8],
    key: &[u8; HASH],
    lattice: impl Fn(Place) -> GroundLattice,
) -> Option<Vec<(Place, Tile)>> {
    let (content, hash) = bytes.split_last_chunk::<HASH>()?;
    if blake3::hash(content) != *hash {
        return None;
    }
    let mut rest = content.strip_prefix(&MAGIC)?.strip_prefix(key)?;
    let count = u64::from_le_bytes(word(&mut rest)?);
    (0..count).map(|_| tile(&mut rest, &lattice)).collect()
}

fn tile(rest: &mut &[u8], lattice: impl Fn(Place) -> GroundLattice) -> Option<(Place, Tile)> {
    let level = u64::from_le_bytes(word(rest)?).try_into().ok()?;
    let at = [i64::from_le_bytes(word(rest)?), i64::from_le_bytes(word(rest)?)];
    let place = Place { level, at };
    let spacing = f64::from_le_bytes(word(rest)?);
    let [corners, ends] = [u64::from_le_bytes(word(rest)?), u64::from_le_bytes(word(rest)?)];
    let corners = (0..corners).map(|_| corner(rest)).collect::<Option<_>>()?;
    let ends = (0..ends).map(|_| Some(u32::from_le_bytes(word(rest)?))).collect::<Option<_>>()?;
    let chains = Some(Chains { corners, ends }).filter(Chains::is_whole)?;
    Some((place, Tile { spacing, outlines: Outlines::of_tile(lattice(place), &chains) }))
}

fn corner(rest: &mut &[u8]) -> Option<Corner> {
    let (along, across) = (i32::from_le_bytes(word(rest)?), i16::from_le_bytes(word(rest)?));
    Some(Corner { along, across })
}

fn word<const BYTES: usize>(rest: &mut &[u8]) -> Option<[u8; BYTES]> {
    let (word, tail) = rest.split_first_chunk()?;
    *rest = tail;
    Some(*word)
}
