//! One cell of made heights in two formats.

/// Samples to a side: one degree, 30 seconds apart.
const SIDE: u32 = 121;

/// Height of a sample (m), counted from the south-west.
fn height(north: u32, east: u32) -> i16 {
    let [x, y] = [north, east].map(|index| 0.07 * f64::from(index));
    (400.0 + 60.0 * libm::sin(x) + 40.0 * libm::cos(1.3 * y)).round() as i16
}

/// DTED of level 0: 10 to 11 degrees north, 20 to 21 degrees east.
pub fn dted() -> Vec<u8> {
    let mut bytes = vec![b' '; 3428];
    let fields = [
        (0, "UHL10200000E0100000N03000300NA  U"),
        (47, "012101210"),
        (80, "DSIU"),
        (139, "DTED0"),
        (221, "E96WGS84"),
        (265, "100000.0N0200000.0E"),
        (344, "0000000.00300030001210121"),
        (728, "ACC"),
    ];
    for (at, text) in fields {
        bytes[at..at + text.len()].copy_from_slice(text.as_bytes());
    }
    for east in 0..SIDE {
        let mut record = vec![0xaa];
        record.extend(&east.to_be_bytes()[1..]);
        record.extend((east as u16).to_be_bytes());
        record.extend([0, 0]);
        record.extend((0..SIDE).flat_map(|north| height(north, east).to_be_bytes()));
        let sum: u32 = record.iter().map(|byte| u32::from(*byte)).sum();
        bytes.extend(record);
        bytes.extend(sum.to_be_bytes());
    }
    bytes
}

/// A GeoTIFF of the same samples: WGS 84, each sample a point, the northern line first.
pub fn geotiff() -> Vec<u8> {
    let shorts = |values: &[u16]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>();
    let doubles = |values: &[f64]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>();
    let data: Vec<u8> = (0..SIDE)
        .rev()
        .flat_map(|north| (0..SIDE).flat_map(move |east| height(north, east).to_le_bytes()))
        .collect();
    let step = 1.0 / 120.0;
    let keys = [1, 1, 0, 4, 1024, 0, 1, 2, 1025, 0, 1, 2, 2048, 0, 1, 4326, 4099, 0, 1, 9001];
    // Tag, type (3: u16, 4: u32, 12: f64), values.
    let entries: [(u16, u16, Vec<u8>); 13] = [
        (256, 3, shorts(&[SIDE as u16])),
        (257, 3, shorts(&[SIDE as u16])),
        (258, 3, shorts(&[16])),
        (259, 3, shorts(&[1])),
        (262, 3, shorts(&[1])),
        (273, 4, 8_u32.to_le_bytes().to_vec()),
        (277, 3, shorts(&[1])),
        (278, 3, shorts(&[SIDE as u16])),
        (279, 4, (data.len() as u32).to_le_bytes().to_vec()),
        (339, 3, shorts(&[2])),
        (33550, 12, doubles(&[step, step, 0.0])),
        (33922, 12, doubles(&[0.0, 0.0, 0.0, 20.0, 11.0, 0.0])),
        (34735, 3, shorts(&keys)),
    ];
    let directory = 8 + data.len();
    let values_at = directory + 2 + 12 * entries.len() + 4;
    let mut file = [&b"II*\0"[..], &(directory as u32).to_le_bytes(), &data].concat();
    file.extend((entries.len() as u16).to_le_bytes());
    let mut values = Vec::new();
    for (tag, kind, bytes) in &entries {
        let size = if *kind == 12 { 8 } else { 2 * (kind - 2) as usize };
        file.extend([tag.to_le_bytes(), kind.to_le_bytes()].concat());
        file.extend(((bytes.len() / size) as u32).to_le_bytes());
        if bytes.len() <= 4 {
            file.extend(bytes.iter().copied().chain([0; 4]).take(4));
        } else {
            file.extend(((values_at + values.len()) as u32).to_le_bytes());
            values.extend(bytes);
        }
    }
    file.extend([0; 4]);
    file.extend(values);
    file
}
