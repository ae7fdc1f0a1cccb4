//! One cell of made heights in three formats.

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

/// The samples line by line, the northern line first, the lowest byte first.
pub fn samples() -> Vec<u8> {
    let line = |north: u32| (0..SIDE).flat_map(move |east| height(north, east).to_le_bytes());
    (0..SIDE).rev().flat_map(line).collect()
}

/// A PDS4 label of the samples, which stand in `cell.dat`. Its bounds are the edges of the outermost samples.
pub fn pds4() -> String {
    let step = 1.0 / 120.0;
    format!(
        "<?xml version=\"1.0\"?>
<Product_Observational xmlns=\"http://pds.nasa.gov/pds4/pds/v1\" xmlns:cart=\"http://pds.nasa.gov/pds4/cart/v1\" xmlns:disp=\"http://pds.nasa.gov/pds4/disp/v1\">
<Identification_Area><title>Cell</title></Identification_Area>
<Observation_Area><Discipline_Area>
<disp:Display_Settings>
<disp:vertical_display_direction>Top to Bottom</disp:vertical_display_direction>
</disp:Display_Settings>
<cart:Cartography>
<cart:latitude_resolution unit=\"deg\">{step:.17}</cart:latitude_resolution>
<cart:longitude_resolution unit=\"deg\">{step:.17}</cart:longitude_resolution>
<cart:north_bounding_coordinate unit=\"deg\">{north:.12}</cart:north_bounding_coordinate>
<cart:west_bounding_coordinate unit=\"deg\">{west:.12}</cart:west_bounding_coordinate>
<cart:a_axis_radius unit=\"m\">6378137</cart:a_axis_radius>
<cart:b_axis_radius unit=\"m\">6378137</cart:b_axis_radius>
<cart:c_axis_radius unit=\"m\">6378137</cart:c_axis_radius>
</cart:Cartography>
</Discipline_Area></Observation_Area>
<File_Area_Observational><File><file_name>cell.dat</file_name></File>
<Array_2D_Image>
<offset unit=\"byte\">0</offset><axes>2</axes><axis_index_order>Last Index Fastest</axis_index_order>
<Element_Array><data_type>SignedLSB2</data_type><unit>m</unit></Element_Array>
<Axis_Array><axis_name>Line</axis_name><elements>{SIDE}</elements><sequence_number>1</sequence_number></Axis_Array>
<Axis_Array><axis_name>Sample</axis_name><elements>{SIDE}</elements><sequence_number>2</sequence_number></Axis_Array>
</Array_2D_Image>
</File_Area_Observational>
</Product_Observational>\n",
        north = 11.0 + 0.5 * step,
        west = 20.0 - 0.5 * step,
    )
}

/// A GeoTIFF of the same samples: WGS 84, each sample a point, the northern line first.
pub fn geotiff() -> Vec<u8> {
    let shorts = |values: &[u16]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>();
    let doubles = |values: &[f64]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>();
    let data = samples();
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
    let mut values: Vec<u8> = Vec::new();
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
