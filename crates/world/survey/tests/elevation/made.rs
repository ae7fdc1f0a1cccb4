//! Elevation files made byte by byte: a PDS3 label with its image, and a TIFF of any tags and directories.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use survey::{Elevation, ReadOptions, read};
use tempfile::TempDir;

/// Lines and columns of all made files.
pub const SIDE: usize = 24;

/// Height of a sample (m): a plane with a step of 0.25 m to the east and 0.5 m to the north.
pub fn height(line: usize, column: usize) -> f64 {
    50.0 + 0.25 * column as f64 + 0.5 * (SIDE - 1 - line) as f64
}

/// Heights line by line.
pub fn heights() -> Vec<f64> {
    (0..SIDE * SIDE).map(|index| height(index / SIDE, index % SIDE)).collect()
}

/// A folder with files, of which the first is to be read.
pub struct Made {
    _folder: TempDir,
    /// Path of the file to read.
    pub path: PathBuf,
}

impl Made {
    /// Files by name and content.
    pub fn new(files: &[(&str, &[u8])]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        files.iter().for_each(|(name, bytes)| fs::write(folder.path().join(name), bytes).unwrap());
        let path = folder.path().join(files[0].0);
        Self { _folder: folder, path }
    }

    /// What is read, or what is said instead.
    pub fn read(&self, options: &ReadOptions) -> Result<Elevation, String> {
        read(&self.path, options).map_err(|error| error.to_string())
    }

    /// What is read without options.
    pub fn plain(&self) -> Result<Elevation, String> {
        self.read(&ReadOptions::default())
    }

    /// The error without options.
    pub fn refusal(&self) -> String {
        match self.plain() {
            Ok(read) => panic!("is read, with notes {:?}", read.notes),
            Err(error) => error,
        }
    }
}

/// Samples that are void, and the largest difference of the others from `scale * height + offset`.
pub fn against(elevation: &Elevation, scale: f64, offset: f64) -> (usize, f64) {
    let (mut voids, mut worst) = (0, 0.0_f64);
    for (line, column) in (0..SIDE * SIDE).map(|index| (index / SIDE, index % SIDE)) {
        match elevation.height(line, column) {
            Some(found) => worst = worst.max((found - scale * height(line, column) - offset).abs()),
            None => voids += 1,
        }
    }
    (voids, worst)
}

/// A label of 24 x 24 samples, 10 m apart; what stands in it can be replaced.
pub const LABEL: &str = "PDS_VERSION_ID = PDS3
RECORD_TYPE = FIXED_LENGTH
RECORD_BYTES = 48
^IMAGE = \"made.img\"
OBJECT = IMAGE
  LINES = 24
  LINE_SAMPLES = 24
  SAMPLE_TYPE = LSB_INTEGER
  SAMPLE_BITS = 16
  UNIT = METER
  SCALING_FACTOR = 0.25
END_OBJECT = IMAGE
OBJECT = IMAGE_MAP_PROJECTION
  MAP_PROJECTION_TYPE = \"EQUIRECTANGULAR\"
  A_AXIS_RADIUS = 1737.4 <KM>
  CENTER_LATITUDE = 0 <DEG>
  CENTER_LONGITUDE = 0 <DEG>
  MAP_SCALE = 10.0 <METERS/PIXEL>
  LINE_PROJECTION_OFFSET = 2000.0
  SAMPLE_PROJECTION_OFFSET = -1000.0
END_OBJECT = IMAGE_MAP_PROJECTION
END
";

/// Stored numbers of an image of quarter metres.
pub fn quarters() -> Vec<f64> {
    heights().iter().map(|height| 4.0 * height).collect()
}

/// Bytes of a 16-bit little-endian image.
pub fn words(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|number| (*number as i64 as u16).to_le_bytes()).collect()
}

/// A label with replacements, and an image beside it.
pub fn labelled(replace: &[(&str, &str)], image: &[u8]) -> Made {
    let mut label = LABEL.to_owned();
    for (old, new) in replace {
        assert_eq!(label.matches(old).count(), 1, "{old}");
        label = label.replace(old, new);
    }
    Made::new(&[("made.lbl", label.as_bytes()), ("made.img", image)])
}

/// Values of a tag.
#[derive(Clone)]
pub enum Field {
    /// Text, which ends with a NUL.
    Text(String),
    /// Whole numbers of 16 bits.
    Shorts(Vec<u16>),
    /// Whole numbers of 32 bits.
    Longs(Vec<u32>),
    /// Floating-point numbers of 64 bits.
    Doubles(Vec<f64>),
}

impl Field {
    fn encoded(&self) -> (u16, usize, Vec<u8>) {
        match self {
            Self::Text(text) => (2, text.len() + 1, [text.as_bytes(), b"\0"].concat()),
            Self::Shorts(v) => (3, v.len(), v.iter().flat_map(|n| n.to_le_bytes()).collect()),
            Self::Longs(v) => (4, v.len(), v.iter().flat_map(|n| n.to_le_bytes()).collect()),
            Self::Doubles(v) => (12, v.len(), v.iter().flat_map(|n| n.to_le_bytes()).collect()),
        }
    }
}

/// One directory: its tags, and the bytes of its strips or tiles; a block without bytes is left out of the file.
#[derive(Clone)]
pub struct Directory {
    pub tags: BTreeMap<u16, Field>,
    pub blocks: Vec<Vec<u8>>,
    /// Tags of the places and sizes of the blocks.
    pub place: [u16; 2],
}

impl Directory {
    /// With one number a tag.
    pub fn new(shorts: &[(u16, u16)], blocks: Vec<Vec<u8>>) -> Self {
        let tags = shorts.iter().map(|(tag, number)| (*tag, Field::Shorts(vec![*number]))).collect();
        Self { tags, blocks, place: [273, 279] }
    }

    /// The made heights as 32-bit floats in strips of four lines, 10 m apart, equirectangular on the Moon.
    pub fn ground() -> Self {
        let side = SIDE as u16;
        let strips = heights().chunks(4 * SIDE).map(floats).collect();
        let shorts = [(256, side), (257, side), (258, 32), (259, 1), (262, 1), (277, 1), (278, 4), (339, 3)];
        let mut made = Self::new(&shorts, strips);
        made.put(33550, Field::Doubles(vec![10.0, 10.0, 0.0]));
        made.put(33922, Field::Doubles(vec![0.0, 0.0, 0.0, 10_000.0, 20_000.0, 0.0]));
        made.keys(&[(1024, 1.0), (1025, 1.0), (2057, 1_737_400.0), (3075, 17.0), (3076, 9001.0)]);
        made
    }

    /// The same with other samples: all in one strip.
    pub fn of(samples: Vec<u8>, bits: u16, format: u16) -> Self {
        let mut made = Self::ground();
        made.blocks = vec![samples];
        for (tag, number) in [(258, bits), (339, format), (278, SIDE as u16)] {
            made.put(tag, Field::Shorts(vec![number]));
        }
        made
    }

    /// Sets the values of a tag.
    pub fn put(&mut self, tag: u16, field: Field) {
        self.tags.insert(tag, field);
    }

    /// The same with a tag.
    pub fn with(mut self, tag: u16, field: Field) -> Self {
        self.put(tag, field);
        self
    }

    /// Sets all geo keys; numbers that are no codes go to the tag of numbers.
    pub fn keys(&mut self, keys: &[(u16, f64)]) {
        let (mut directory, mut numbers) = (vec![1, 1, 0, keys.len() as u16], Vec::new());
        for (key, number) in keys {
            match number.fract() == 0.0 && (0.0..65536.0).contains(number) {
                true => directory.extend([*key, 0, 1, *number as u16]),
                false => {
                    directory.extend([*key, 34736, 1, numbers.len() as u16]);
                    numbers.push(*number);
                }
            }
        }
        self.put(34735, Field::Shorts(directory));
        match numbers.is_empty() {
            true => drop(self.tags.remove(&34736)),
            false => self.put(34736, Field::Doubles(numbers)),
        }
    }

    /// With other geo keys.
    pub fn with_keys(mut self, keys: &[(u16, f64)]) -> Self {
        self.keys(keys);
        self
    }

    /// With items of GDAL's metadata for the first band.
    pub fn with_items(self, items: &[(&str, &str)]) -> Self {
        let item = |(name, text): &(&str, &str)| format!("<Item name=\"{name}\" sample=\"0\">{text}</Item>");
        let items: String = items.iter().map(item).collect();
        self.with(42112, Field::Text(format!("<GDALMetadata>{items}</GDALMetadata>")))
    }

    /// A file with this directory alone.
    pub fn made(self) -> Made {
        tiff(&[self])
    }

    /// Appends the blocks, the long values and the directory; gives where the offset of the next directory stands.
    fn append(&self, file: &mut Vec<u8>) -> usize {
        let (mut places, mut sizes) = (Vec::new(), Vec::new());
        for block in &self.blocks {
            places.push(if block.is_empty() { 0 } else { file.len() as u32 });
            sizes.push(block.len() as u32);
            file.extend(block);
        }
        let mut tags = self.tags.clone();
        // A tag that a test sets by itself stays.
        tags.entry(self.place[0]).or_insert(Field::Longs(places));
        tags.entry(self.place[1]).or_insert(Field::Longs(sizes));
        let mut entries = (tags.len() as u16).to_le_bytes().to_vec();
        for (tag, field) in &tags {
            let (kind, count, bytes) = field.encoded();
            entries.extend([tag.to_le_bytes(), kind.to_le_bytes()].concat());
            entries.extend((count as u32).to_le_bytes());
            if bytes.len() > 4 {
                entries.extend((file.len() as u32).to_le_bytes());
                file.extend(bytes);
            } else {
                entries.extend(bytes.into_iter().chain([0; 4]).take(4));
            }
        }
        let at = file.len() as u32;
        file.extend(entries);
        file.extend(at.to_le_bytes());
        file.len() - 4
    }
}

/// A file `made.tif` with these directories.
pub fn tiff(directories: &[Directory]) -> Made {
    Made::new(&[("made.tif", &bytes(directories))])
}

/// The bytes of a TIFF with these directories.
pub fn bytes(directories: &[Directory]) -> Vec<u8> {
    let mut file = b"II*\0\0\0\0\0".to_vec();
    let mut link = 4;
    for directory in directories {
        let next = directory.append(&mut file);
        // The place of a directory stands where that of the next one will.
        let at: [u8; 4] = file[next..next + 4].try_into().unwrap();
        file[link..link + 4].copy_from_slice(&at);
        file[next..next + 4].fill(0);
        link = next;
    }
    file
}

/// Bytes of 32-bit floats.
pub fn floats(numbers: &[f64]) -> Vec<u8> {
    numbers.iter().flat_map(|number| (*number as f32).to_le_bytes()).collect()
}
