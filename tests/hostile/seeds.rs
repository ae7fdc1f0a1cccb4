//! Whole files, from which damaged ones are made.

use std::sync::Arc;

use landscape::{Bank, Georeference};
use loop_protocol::{Message, Plane};
use lunoid_tests::{level_of, plane};
use picture::{Depth, GreyPicture, encode_png};
use run_record::Program;
use serde_json::json;
use state::{Block, BlockKind, Hashes, Head, Identity, Place, State};

use crate::build::{Tiff, doubles, npy};

const LABEL: &str = include_str!("../../crates/world/survey/tests/ground.lbl");
const PDS4: &str = include_str!("../../crates/world/survey/tests/elevation/ground.xml");
const CUBE_LABEL: &str = include_str!("../../crates/world/survey/tests/elevation/ground.pvl");
const ENVI: &str = include_str!("../../crates/world/survey/tests/elevation/ground.hdr");
const SYSTEM: &str = include_str!("../../crates/world/survey/tests/elevation/ground.prj");

const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\no box\n\
                    f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

const STL: &str = "solid t\nfacet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n\
                   facet normal 0 -1 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n\
                   facet normal -1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n\
                   facet normal 1 1 1\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid t\n";

/// A cube with a dent in its top.
const PLY: &str = "ply\nformat ascii 1.0\ncomment dented\nelement vertex 9\nproperty float x\nproperty float y\nproperty float z\n\
                   element face 9\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n\
                   1 1 1\n0 1 1\n0.5 0.5 0.4\n4 0 3 2 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n3 4 5 8\n3 5 6 8\n3 6 7 8\n3 7 4 8\n";

const RUN: &str = r#"{"schema":"lunoid.run/2",
"format":1,
"fingerprint":"00ff",
"program":{"name":"lunoid","version":"0.1.0","commit":"unknown","result_family":"unfused"},
"scenario":{"file":null,"title":"Craters","shows":"Craters."},
"references":[],
"generator":"hybrid",
"line":"sweep",
"model":{"name":"ideal","files":[],"values":[]},
"ground":{"source":"generated","title":"Craters","content_blake3":"dd","albedo":1.0,"levels":[{"region_size_m":20.0,"origin_m":[0.0,0.0],"corners":[201,151]}],"generator":null},
"scenery":{"craters":164838,"rock_bodies":0,"culture_bodies":0,"track_patches":0,"silhouettes":0,"texture":true,"photometry":"LunarLambert","blake3":"ee"},
"sun":{"azimuth_deg":285.0,"elevation_deg":16.0},
"vehicle":{"eye_height_m":1.6334,"wheelbase_m":2.3,"track_m":1.83,"max_speed_m_s":4.877,"max_turn_deg_s":10.0,"max_slope_deg":25.0},
"path":{"waypoints":2,"waypoints_blake3":"ab"},
"view":{"columns":20,"lines":11,"field_of_view_deg":[50.0,29.999999999999996],"update":"10 Hz","refresh":"30 Hz","display":{"white":1.25,"gamma":2.2},"laws":{"body_visibility":"depth","curvature":"parabolic","feature_light":"combined","occlusion":"peak-hold","pixel_rule":"line-mean","projection":"exact","shadowed_bodies":"dark","texture_in_shadow":"off"},"ranges_m":[2.0,4000.0],"yoke":null,"levels":null,"shadows":{"finest_m":0.05,"angle_mrad":1.0,"reach_m":null}},
"settings":{},
"pictures":{"kind":"grey PNG","depth":8,"one_file_for_each":"update"},
"omissions":[],
"limits":[],
"range":[0,1],
"totals":{},
"frames":[{"frame":0,"time_s":0.0,"pixels_blake3":"aa","files":[{"file":"frames/frame-000000.png","blake3":"bb"}],"counts":{}}],
"outputs":[{"file":"poses.csv","blake3":"cc"}]}"#;

/// Whole files of the reader of that name.
pub fn seeds(name: &str) -> Vec<Vec<u8>> {
    let texts: &[&str] = match name {
        "scenario" => &[
            include_str!("../../crates/doors/lunoid/tests/tiny.toml"),
            include_str!("../../scenarios/showpiece.toml"),
            include_str!("../../scenarios/low-sun.toml"),
        ],
        "path-csv" => &[
            "t_s,x_m,y_m,heading_deg\n0,100,200,\n2.5,108,205,40\n5,116,206,\n",
            "# a climb\nt_s,x_m,y_m,z_m,pitch_deg\n0,100,200,30,-10\n5,110,201,20,-12\n",
        ],
        "path-tum" => &["# t tx ty tz qx qy qz qw\n0 100 200 -3.2 0 0 0 1\n1 102 201 -3.2 0 0 0.1 0.995\n"],
        "path-gpx" => &[
            "<?xml version=\"1.0\"?>\n<gpx xmlns=\"http://www.topografix.com/GPX/1/1\"><trk><name>a</name><trkseg>\
             <trkpt lat=\"5.73\" lon=\"11.46\"><ele>3</ele><time>2026-11-26T22:00:00Z</time></trkpt>\
             <trkpt lat=\"5.731\" lon=\"11.461\"><ele>4</ele><time>2026-11-26T22:00:10Z</time></trkpt>\
             </trkseg></trk></gpx>\n",
        ],
        "path-lon-lat" => &[
            "t_utc;lat_deg;lon_deg;heading_rad;height_m\r\n2026-11-26T22:00:00Z;5,73;11,46;0,5;2,5\r\n\
             2026-11-26T22:00:05Z;\"5,731\";11,461;\"\";2\r\n",
            "t_s,lat_deg,lon_deg,qx,qy,qz,qw\n1700000000,5.73,11.46,0,0,0,1\n1700000001,5.731,11.461,0,0,0.6,0.8\n",
        ],
        "model" => &[
            include_str!("../../hardware-models/pra-nominal.toml"),
            "format = 1\nname = \"mine\"\nbase = \"ideal\"\n[loader]\naccess_ns = 90\n",
        ],
        "craters" => &[
            "x_m,y_m,radius_m,depth_m,rim_m,type,outer_m,floor_m\n200,200,10,2,0,1,,\n210,190,8,1,0.2,2,12,\n\
                        150,150,20,2,0.5,3,30,9\n",
        ],
        "stars" => &[
            "name,right_ascension_deg,declination_deg,magnitude,b_v\nSirius,101.287,-16.716,-1.46,0.0\nVega,279.234,38.784,0.03,\n",
            "right_ascension_deg;declination_deg;magnitude\r\n88,79;7,41;0,5\r\n",
        ],
        "obj" => &[CUBE],
        "effect" => &[
            include_str!("../../scenarios/effects/weapon-flash.toml"),
            include_str!("../../scenarios/effects/rotor-downwash.toml"),
            include_str!("../../scenarios/effects/confused-sea.toml"),
            "format = 1\ntitle = \"Flag\"\nabout = \"By pitch\"\n[[group]]\nname = \"flag\"\npriority = 3\nvertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0]]\n\
             face = [{ corners = [0, 1, 2], colour = [1, 0, 0], shading = \"flat\" }, { corners = [2, 1, 0], colour = [0, 0, 1], sides = \"both\" }]\n\
             [[group.sequence]]\nmembers = 2\nmode = \"driven\"\nsignal = \"pitch\"\nlow = -3\nstep = 1.5\n",
        ],
        "envi" => &[ENVI],
        "prj" => &[SYSTEM],
        "ascii" => &[
            "ncols 3\nnrows 2\nxllcorner 10\nyllcorner -5.5\ncellsize 10\nNODATA_value -9\n1 2 -9\n4 5.5 6e1\n",
            "NCOLS 2\r\nNROWS 2\r\nXLLCENTER 1\r\nYLLCENTER 2\r\nDX 1\r\nDY 2\r\n1 2\r\nnan 4\r\n",
        ],
        "baseline" => &[include_str!("../timing-baselines/first-light.ideal.json")],
        "run" => &[RUN],
        "poses" => &[
            "frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg,yoke_deg,height_m\n0,0,1,2,3,4,5,6,0,1.6\n1,0.1,1,2,3,4,5,6,0,1.6\n",
        ],
        "camera" => &[
            r#"{"schema":"lunoid.camera/1","tan_half_field":[0.466,0.268],"columns":40,"lines":23,"projection":"exact","roll_drawn":false}"#,
        ],
        "photo-file" => &[
            r#"{"format":1,"focal_length_m":0.15,"principal_point_m":[0,0],"perspective_centre_m":[1500,2000,1906.4],
"image_axes":[[1,0,0],[0,1,0],[0,0,1]],"affine_x_um":[157,0,-40192],"affine_y_um":[0,-157,40192],"axes":"landscape",
"sun_azimuth_elevation_rad":[4.97,0.28],"grey_white_gamma":[1.25,2.2]}"#,
            r#"{"format":1,"focal_length_m":0.153197,"principal_point_m":[2e-6,0],
"perspective_centre_m":[-2693765.9,-4304520.4,3859018.3],"omega_phi_kappa_rad":[0.8341764,-0.4563699,3.0761254],
"affine_x_um":[20.11,6.02,-34954],"affine_y_um":[-6.02,20.1,-22566],
"body":{"semi_major_axis_m":6378206.4,"eccentricity_squared":0.006768658}}"#,
            r#"{"format":1,"camera":"map","unit":"deg","east_of_pixel":[0.5,0,-122],"north_of_pixel":[0,-0.5,43]}"#,
        ],
        "control-points" => &[
            "name,latitude,longitude,height_m,i_px,j_px\nrim,0:06:00 N,0:12:00 E,5,1,1\nfloor,0.2,0.3,,0.5,1.5\n",
            "latitude;longitude;i_px;j_px\n0,1;0,2;1,5;0,25\n",
        ],
        _ => &[],
    };
    match name {
        "bank" => banks(),
        "geotiff" => vec![
            Tiff::plane().bytes(),
            Tiff { bands: 2, heights: vec![1.5; 800], no_data: Some("-9999"), ..Tiff::plane() }.bytes(),
        ],
        "stl" => vec![stl(), STL.as_bytes().to_vec()],
        "ply" => vec![PLY.as_bytes().to_vec(), ply()],
        "gltf" => vec![gltf(Some(&base64(&triangles()))).into_bytes()],
        "glb" => vec![glb()],
        "pds" => vec![label()],
        "dted" => vec![cell()],
        "pds4" => vec![PDS4.replace("made.dat", "dem.dat").into_bytes()],
        "isis" => vec![cube("BandSequential"), cube("Tile\n    TileSamples = 10\n    TileLines = 7")],
        "message" => messages(),
        "npy" => vec![
            npy("<f8", "(5, 5)", &doubles(&[1.0; 25])),
            npy("<i2", "(3, 4)", &[7; 24]),
            npy(">f4", "(2, 2)", &[0; 16]),
        ],
        "state" => vec![state(0, 3), state(2, 0)],
        "png" => [Depth::Eight, Depth::Sixteen].into_iter().map(png).collect(),
        _ => texts.iter().map(|text| text.as_bytes().to_vec()).collect(),
    }
}

/// Requests with and without planes; one of each kind that has keys of its own.
fn messages() -> Vec<Vec<u8>> {
    let headers = [
        json!({ "id": 1, "do": "open", "scenario": "scenarios/first-light.toml", "machine": "ideal", "set": { "loader.access_ns": 9.5 } }),
        json!({ "id": 2, "do": "look", "frame": 1, "pose": { "x_m": 1, "y_m": 2, "z_m": 3, "heading_deg": 4, "pitch_deg": 5, "roll_deg": 6 } }),
        json!({ "id": 3, "do": "probe", "signals": ["mu.*"], "sweeps": [1, 2] }),
        json!({ "id": 4, "do": "hello" }),
    ];
    let planes = vec![Plane::of_file("state", vec![7; 9])];
    let restore = Message::new(json!({ "id": 5, "do": "restore" })).with(planes);
    headers.into_iter().map(Message::new).chain([restore]).map(|message| message.encode()).collect()
}

/// A tetrahedron in metres: its corners, and the corners of each face counter-clockwise.
const CORNERS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
const SIDES: [[u16; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

/// Corners and sides as words of 32 and 16 bits.
fn triangles() -> Vec<u8> {
    let places = CORNERS.iter().flatten().flat_map(|length| length.to_le_bytes());
    places.chain(SIDES.iter().flatten().flat_map(|corner| corner.to_le_bytes())).collect()
}

fn stl() -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend(4_u32.to_le_bytes());
    for side in SIDES {
        bytes.extend([0; 12]);
        let corners = side.iter().flat_map(|&corner| CORNERS[usize::from(corner)]);
        bytes.extend(corners.flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}

/// Big-endian, with a colour for each vertex.
fn ply() -> Vec<u8> {
    let head = "ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
                property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 4\n\
                property list uchar ushort vertex_indices\nend_header\n";
    let mut bytes = head.as_bytes().to_vec();
    for corner in CORNERS {
        bytes.extend(corner.iter().flat_map(|length| length.to_be_bytes()).chain([200, 100, 50]));
    }
    for side in SIDES {
        bytes.extend([3].into_iter().chain(side.iter().flat_map(|corner| corner.to_be_bytes())));
    }
    bytes
}

/// A glTF file whose buffer is its own data, or the chunk of a binary file.
fn gltf(data: Option<&str>) -> String {
    let uri = data.map_or_else(String::new, |data| {
        format!("\"uri\": \"data:application/octet-stream;base64,{data}\", ")
    });
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
"nodes": [{{"children": [1], "scale": [1, 2, 1]}}, {{"mesh": 0, "rotation": [0, 0, 0, 1], "translation": [0, 0, 1]}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1, "material": 0}}]}}],
"materials": [{{"pbrMetallicRoughness": {{"baseColorFactor": [0.5, 0.4, 0.3, 1]}}}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}},
{{"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}}],
"bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": 24}}],
"buffers": [{{{uri}"byteLength": 72}}]}}"#
    )
}

fn glb() -> Vec<u8> {
    let mut json = gltf(None).into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunk =
        |kind: &[u8; 4], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes(), &kind[..], bytes].concat();
    let chunks = [chunk(b"JSON", &json), chunk(b"BIN\0", &triangles())].concat();
    let length = chunks.len() as u32 + 12;
    [&b"glTF"[..], &2_u32.to_le_bytes(), &length.to_le_bytes(), &chunks].concat()
}

/// Digits of base64 for bytes whose number is a multiple of three.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let digits = |three: &[u8]| {
        let word = three.iter().fold(0_u32, |word, &byte| word << 8 | u32::from(byte));
        [18, 12, 6, 0].map(|shift| char::from(DIGITS[(word >> shift & 63) as usize]))
    };
    bytes.chunks(3).flat_map(digits).collect()
}

/// A label with its image behind it.
fn label() -> Vec<u8> {
    let mut bytes = LABEL.replace("\"GROUND.IMG\"", "200").into_bytes();
    bytes.resize(199 * 6, b' ');
    bytes.extend([2_i16, -4, 6, 8, -32768, 12].iter().flat_map(|height| height.to_le_bytes()));
    bytes
}

/// A cube whose core stands behind its label, in lines or in tiles.
fn cube(format: &str) -> Vec<u8> {
    let label = CUBE_LABEL.replace("BandSequential", format).replace("4097", "2049");
    let mut bytes = label.into_bytes();
    bytes.resize(2048, b' ');
    bytes.extend((0..12 * 70).flat_map(|sample: i16| sample.to_le_bytes()));
    bytes
}

/// A DTED cell of three meridians of two samples, by the offsets of its headers.
fn cell() -> Vec<u8> {
    let mut bytes = vec![b' '; 3428];
    let fields = [
        (0, "UHL10060000E0450000S01800300NA  U"),
        (47, "000300020"),
        (80, "DSIU"),
        (139, "DTED0"),
        (221, "E96WGS84"),
        (265, "450000.0S0060000.0E"),
        (344, "0000000.003000180000200030"),
        (728, "ACC"),
    ];
    fields.iter().for_each(|(at, text)| bytes[*at..at + text.len()].copy_from_slice(text.as_bytes()));
    for meridian in 0..3_u8 {
        let record = [0xaa, 0, 0, meridian, 0, meridian, 0, 0, 0x80, 7, 0xff, 0xff];
        let sum: u32 = record.iter().map(|byte| u32::from(*byte)).sum();
        bytes.extend(record.iter().copied().chain(sum.to_be_bytes()));
    }
    bytes
}

fn banks() -> Vec<Vec<u8>> {
    let level = |corners| level_of(40.0, [0.0, 10.0], [corners; 2], plane(40.0, 3.0, [0.1, -0.2]));
    let place = Some(Georeference { latitude: 0.1, longitude: 0.2, at: [50.0, 60.0], true_north: None });
    let one = Bank::new("One", vec![level(3)], None).expect("a bank");
    let two = Bank::new("Placed", vec![level(4)], place).expect("a bank");
    [one, two].iter().map(written).collect()
}

fn written(bank: &Bank) -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.bank");
    landscape::bank_file::write(&path, bank).expect("a bank that can be written");
    std::fs::read(path).expect("what was written")
}

/// A machine in frame `frame` at the start of sweep `sweep`, whose tubes keep all frames before.
fn state(frame: u64, sweep: u32) -> Vec<u8> {
    let hash = || "00ff".to_owned();
    let hashes = Hashes { settings: hash(), view: hash(), ground: hash(), scenery: hash(), mission: hash() };
    let program = Program {
        name: "lunoid".into(),
        version: "0.1.0".into(),
        commit: "unknown".into(),
        result_family: "unfused".into(),
    };
    let block = |kind, frame, rows: u64, row: u64| {
        let values = Arc::new(vec![0.5; (rows * row) as usize]);
        Block { kind, frame, rows, row, values }
    };
    let rows = block(BlockKind::Rows, frame, sweep.into(), 6);
    let stores = (0..frame).map(|frame| block(BlockKind::Store, frame, 8, 6));
    let pictures = (0..frame).map(|frame| block(BlockKind::Picture, frame, 5, 8));
    let identity = Identity { program, machine: "ideal".into(), scenario: "Craters".into(), hashes };
    let place = Place::start(frame, sweep);
    let words = vec!["craters.toml".into(), "--sweeps".into(), "8".into()];
    let head = Head { identity, words, place, tick: 77, time_s: 0.1 };
    let blocks = [rows].into_iter().chain(stores).chain(pictures).collect();
    State { head, digital: "{\n  \"levels\": []\n}\n".into(), blocks }.bytes()
}

fn png(depth: Depth) -> Vec<u8> {
    let codes = (0..24_u16).map(|code| code * 7).collect();
    let picture = GreyPicture::new(6, 4, depth, codes).expect("a picture");
    encode_png(&picture, &[("Frame", "3")]).expect("a PNG")
}
