//! Labels and headers of the made heights (see `made`): 24 x 24 quarter metres, 10 m apart, equirectangular on the Moon. One
//! element, keyword or key stands on a line, so that it can be replaced.

use crate::made::{Made, SIDE, heights, quarters, words};

/// A PDS4 label, whose samples stand in `made.dat`.
pub const PDS4: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Product_Observational xmlns="http://pds.nasa.gov/pds4/pds/v1" xmlns:cart="c" xmlns:disp="d">
<Identification_Area>
<title>Made</title>
</Identification_Area>
<Observation_Area>
<Discipline_Area>
<disp:Display_Settings>
<disp:vertical_display_direction>Top to Bottom</disp:vertical_display_direction>
</disp:Display_Settings>
<cart:Cartography>
<Local_Internal_Reference>
<local_identifier_reference>heights</local_identifier_reference>
</Local_Internal_Reference>
<cart:map_projection_name>Equirectangular</cart:map_projection_name>
<cart:standard_parallel_1 unit="deg">0</cart:standard_parallel_1>
<cart:longitude_of_central_meridian unit="deg">0</cart:longitude_of_central_meridian>
<cart:latitude_of_projection_origin unit="deg">0</cart:latitude_of_projection_origin>
<cart:pixel_resolution_x unit="m/pixel">10</cart:pixel_resolution_x>
<cart:pixel_resolution_y unit="m/pixel">10</cart:pixel_resolution_y>
<cart:upperleft_corner_x unit="km">10</cart:upperleft_corner_x>
<cart:upperleft_corner_y unit="m">20000</cart:upperleft_corner_y>
<cart:a_axis_radius unit="km">1737.4</cart:a_axis_radius>
<cart:b_axis_radius unit="km">1737.4</cart:b_axis_radius>
<cart:c_axis_radius unit="km">1737.4</cart:c_axis_radius>
</cart:Cartography>
</Discipline_Area>
</Observation_Area>
<File_Area_Observational>
<File>
<file_name>made.dat</file_name>
</File>
<Array_2D_Image>
<local_identifier>heights</local_identifier>
<offset unit="byte">0</offset>
<axes>2</axes>
<axis_index_order>Last Index Fastest</axis_index_order>
<Element_Array>
<data_type>SignedLSB2</data_type>
<unit>m</unit>
<scaling_factor>0.25</scaling_factor>
</Element_Array>
<Axis_Array>
<axis_name>Line</axis_name><elements>24</elements><sequence_number>1</sequence_number>
</Axis_Array>
<Axis_Array>
<axis_name>Sample</axis_name><elements>24</elements><sequence_number>2</sequence_number>
</Axis_Array>
<Special_Constants>
</Special_Constants>
<Object_Statistics>
</Object_Statistics>
</Array_2D_Image>
</File_Area_Observational>
</Product_Observational>
"#;

/// An ISIS label, whose samples stand from byte 4097 on.
pub const ISIS: &str = "Object = IsisCube
  Object = Core
    StartByte = 4097
    Format = BandSequential
    Group = Dimensions
      Samples = 24
      Lines = 24
      Bands = 1
    End_Group
    Group = Pixels
      Type = SignedWord
      ByteOrder = Lsb
      Base = 0.0
      Multiplier = 0.25
    End_Group
  End_Object
  Group = BandBin
    Unit = METER
  End_Group
  Group = Mapping
    ProjectionName = SimpleCylindrical
    CenterLongitude = 0.0
    EquatorialRadius = 1737400.0 <meters>
    PolarRadius = 1737400.0 <meters>
    UpperLeftCornerX = 10000.0 <meters>
    UpperLeftCornerY = 20000.0 <meters>
    PixelResolution = 10.0 <meters/pixel>
  End_Group
End_Object
End
";

/// An ENVI header, whose samples stand in `made.dat`.
pub const ENVI: &str = r#"ENVI
samples = 24
lines = 24
bands = 1
header offset = 0
data type = 2
interleave = bsq
byte order = 0
data gain values = {0.25}
map info = {Equirectangular, 1, 1, 10000, 20000, 10, 10}
coordinate system string = {PROJCS["m",GEOGCS["g",DATUM["d",SPHEROID["s",1737400.0,0.0]],PRIMEM["p",0],UNIT["Degree",0.0174532925199433]],PROJECTION["Equidistant_Cylindrical"],PARAMETER["Central_Meridian",0],UNIT["Meter",1.0]]}
"#;

/// A coordinate system as a `.prj` has it.
pub const PRJ: &str = r#"PROJCS["m",GEOGCS["g",DATUM["d",SPHEROID["s",1737400.0,0.0]],PRIMEM["p",0],UNIT["Degree",0.0174532925199433]],PROJECTION["Equidistant_Cylindrical"],PARAMETER["Central_Meridian",0],UNIT["Meter",1.0]]"#;

/// The head of an Arc ASCII grid.
pub const HEAD: &str = "ncols 24
nrows 24
xllcorner 10000
yllcorner 19760
cellsize 10
NODATA_value -1
";

/// A PDS4 label with the made samples, and more behind them.
pub fn pds4(label: &str) -> Made {
    let samples = [words(&quarters()), vec![0; 2048]].concat();
    Made::new(&[("made.xml", label.as_bytes()), ("made.dat", &samples)])
}

/// A cube with the made samples.
pub fn isis(label: &str) -> Made {
    Made::new(&[("made.cub", &cube(label, &words(&quarters())))])
}

/// The bytes of a cube whose core stands from byte 4097 on.
pub fn cube(label: &str, core: &[u8]) -> Vec<u8> {
    let mut bytes = label.as_bytes().to_vec();
    bytes.resize(4096, b' ');
    [bytes, core.to_vec(), vec![0; 2048]].concat()
}

/// A header with the made samples, and more behind them.
pub fn envi(header: &str) -> Made {
    let samples = [words(&quarters()), vec![0; 2048]].concat();
    Made::new(&[("made.hdr", header.as_bytes()), ("made.dat", &samples)])
}

/// A grid with the made heights as text, and its coordinate system.
pub fn ascii(head: &str, prj: &str) -> Made {
    Made::new(&[("made.asc", format!("{head}{}", numbers()).as_bytes()), ("made.prj", prj.as_bytes())])
}

/// The made heights as lines of text.
pub fn numbers() -> String {
    let line = |line: &[f64]| line.iter().map(f64::to_string).collect::<Vec<_>>().join(" ") + "\n";
    heights().chunks(SIDE).map(line).collect()
}

/// `text` with one part replaced, which it must have once.
pub fn replaced(text: &str, old: &str, new: &str) -> String {
    assert_eq!(text.matches(old).count(), 1, "{old}");
    text.replace(old, new)
}
