//! Small files made byte by byte, so that each can be wrong in one place.

/// An array of numpy with any header.
pub fn npy(kind: &str, shape: &str, values: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    // The values begin at a multiple of 64 bytes; the header ends with a line feed.
    let end = (header.len() + 11).next_multiple_of(64);
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend(((end - 10) as u16).to_le_bytes());
    bytes.extend(format!("{header:<width$}\n", width = end - 11).bytes());
    bytes.extend(values);
    bytes
}

/// The values as little-endian doubles, eight bytes each.
pub fn doubles(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

/// A GeoTIFF of f32 in one strip, 10 m a sample.
pub struct Tiff {
    pub columns: u32,
    pub lines: u32,
    pub bands: u16,
    pub no_data: Option<&'static str>,
    pub heights: Vec<f32>,
}

impl Tiff {
    /// 20 x 20 samples of a tilted plane.
    pub fn plane() -> Self {
        let height = |index: u32| (index % 20) as f32 * 0.3 + (index / 20) as f32 * 0.2;
        Self { columns: 20, lines: 20, bands: 1, no_data: None, heights: (0..400).map(height).collect() }
    }

    pub fn bytes(&self) -> Vec<u8> {
        let data: Vec<u8> = self.heights.iter().flat_map(|height| height.to_le_bytes()).collect();
        let (short, long, double) = (3, 4, 12);
        let shorts =
            |values: &[u16]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>();
        let each_band = |value: u16| shorts(&vec![value; self.bands.into()]);
        let one = |value: u32| value.to_le_bytes().to_vec();
        let keys = [1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3076, 0, 1, 9001];
        let mut entries: Vec<(u16, u16, Vec<u8>)> = vec![
            (256, long, one(self.columns)),
            (257, long, one(self.lines)),
            (258, short, each_band(32)),
            (259, short, shorts(&[1])),
            (262, short, shorts(&[1])),
            (273, long, one(0)),
            (277, short, shorts(&[self.bands])),
            (278, long, one(self.lines)),
            (279, long, one(data.len() as u32)),
            (339, short, each_band(3)),
            (33550, double, doubles(&[10.0, 10.0, 0.0])),
            (33922, double, doubles(&[0.0, 0.0, 0.0, 0.0, 10.0 * f64::from(self.lines), 0.0])),
            (34735, short, shorts(&keys)),
        ];
        if self.bands > 1 {
            entries.insert(9, (338, short, shorts(&vec![0; usize::from(self.bands) - 1])));
        }
        if let Some(text) = self.no_data {
            entries.push((42113, 2, format!("{text}\0").into_bytes()));
        }
        assemble(&mut entries, &data)
    }
}

/// Header, one directory, its long values, the strip.
fn assemble(entries: &mut [(u16, u16, Vec<u8>)], strip: &[u8]) -> Vec<u8> {
    let values_at = 8 + 2 + 12 * entries.len() + 4;
    let long = |bytes: &[u8]| if bytes.len() > 4 { bytes.len() } else { 0 };
    let strip_at = values_at + entries.iter().map(|(_, _, bytes)| long(bytes)).sum::<usize>();
    let offset = |at: usize| (at as u32).to_le_bytes();
    let mut file = [&b"II*\0"[..], &offset(8), &(entries.len() as u16).to_le_bytes()].concat();
    let mut values = Vec::new();
    for (tag, kind, bytes) in entries.iter_mut() {
        if *tag == 273 {
            *bytes = offset(strip_at).to_vec();
        }
        let size = match kind {
            2 => 1,
            3 => 2,
            4 => 4,
            _ => 8,
        };
        file.extend([tag.to_le_bytes(), kind.to_le_bytes()].concat());
        file.extend(((bytes.len() / size) as u32).to_le_bytes());
        if bytes.len() > 4 {
            file.extend(offset(values_at + values.len()));
            values.extend(&*bytes);
        } else {
            file.extend(bytes.iter().copied().chain([0; 4]).take(4));
        }
    }
    [file, offset(0).to_vec(), values, strip.to_vec()].concat()
}

/// A whole PNG of one red, green and blue pixel.
pub const COLOUR_PNG: &[u8] = b"\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\
\x00\x00\x00\x01\x00\x00\x00\x01\x08\x02\x00\x00\x00\x90\x77\x53\xde\x00\x00\x00\x0f\x49\x44\x41\x54\
\x78\x01\x01\x04\x00\xfb\xff\x00\x01\x02\x03\x00\x0e\x00\x07\x2d\xa2\x33\xec\x00\x00\x00\x00\x49\x45\
\x4e\x44\xae\x42\x60\x82";
