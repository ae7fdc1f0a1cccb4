//! Sequences on disk: what is read, what is refused, what is written.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use picture::{ColourPicture, Curve, Depth, GreyPicture, Limits, read_png, write_png};
use serde_json::Value;
use tempfile::TempDir;
use vehicle_shadow::{
    AugmentError, Augmentation, Camera, FrameWork, GroundLaw, Look, MadeFrom, Method, OutlineRule,
    ScanConverter, Sequence, ShadowFolder, Shape,
};

use crate::scenes::sun;

pub const SIZE: [usize; 2] = [100, 60];
const CAMERA: &str = r#"{ "columns": 100, "lines": 60, "tan_half_field": [0.466, 0.268], "roll_drawn": false,
    "projection": "exact: the formulas hold for every pixel" }"#;

/// A sequence of three frames, 4 to 6.
pub struct Folder(TempDir);

impl Folder {
    /// Three frames of even grey with their poses and camera.
    pub fn new() -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        fs::create_dir(folder.join("frames")).unwrap();
        (4..7).for_each(|frame| folder.picture(&format!("frame-{frame:06}.png"), SIZE));
        let pose = |frame: u32| format!("{frame},{},10,20,1.6334,30,-12,0,1.5\n", f64::from(frame) / 10.0);
        let poses: String = (4..7).map(pose).collect();
        folder.write(
            "poses.csv",
            &format!("frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg,speed_m_s\n{poses}"),
        );
        folder.write("camera.json", CAMERA);
        folder
    }

    pub fn join(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        fs::write(self.join(name), text).unwrap();
    }

    fn picture(&self, name: &str, [columns, lines]: [usize; 2]) {
        let picture = GreyPicture::new(columns, lines, Depth::Eight, vec![180; columns * lines]).unwrap();
        self.put(name, &picture);
    }

    /// Rows of frame, time, eye, heading, pitch and roll.
    pub fn poses(&self, rows: &str) {
        self.write("poses.csv", &format!("frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg\n{rows}"));
    }

    pub fn put(&self, name: &str, picture: &GreyPicture) {
        write_png(self.join("frames").join(name), picture, &[]).unwrap();
    }

    pub fn sequence(&self) -> Result<Sequence, AugmentError> {
        let camera = || Camera::read(&self.join("camera.json"));
        Sequence::read(&self.join("frames"), &self.join("poses.csv"), camera)
    }

    fn run(&self, method: Method, out: &Path) -> Result<Vec<FrameWork>, AugmentError> {
        let augmentation = Augmentation {
            inputs: String::new(),
            shape: Shape::find("rover", 1.6334).unwrap(),
            eye_height: 1.6334,
            sun: Some(sun(215.0, 22.0)),
            penumbra: false,
            ground: GroundLaw::Flat(OutlineRule::Parts),
            method,
        };
        let sequence = self.sequence()?;
        let from = MadeFrom { inputs: String::new(), keys: Value::Null };
        let out = ShadowFolder::claim(out, &sequence, &from, false)?;
        augmentation.run(&sequence, &out, &AtomicBool::new(false), &|_| {}, &mut Look::off())
    }

    fn refused(&self) -> String {
        self.run(SYNCHRONISED, &self.join("out")).unwrap_err().to_string()
    }
}

const SYNCHRONISED: Method = Method::Synchronised { dac_bits: 10 };

fn mean(picture: &GreyPicture) -> f64 {
    picture.levels().sum::<f64>() / (picture.columns() * picture.lines()) as f64
}

#[test]
fn new_pictures_stand_beside_the_old() {
    let folder = Folder::new();
    let out = folder.join("out");
    let done = folder.run(SYNCHRONISED, &out).unwrap();
    assert_eq!(done.iter().map(|work| work.frame).collect::<Vec<_>>(), [4, 5, 6]);
    let names: Vec<_> = done.iter().map(|work| work.file.as_str()).collect();
    assert_eq!(names, ["frame-000004.png", "frame-000005.png", "frame-000006.png"]);
    let new = read_png(out.join(names[0]), &Limits::default()).unwrap();
    assert_eq!(new.pixel_hash(), done[0].pixels_blake3);
    let share = done[0].work.dark;
    assert!(share > 0.02 && share < 0.6, "{share}");
    assert!((mean(&new) - (1.0 - share) * 180.0 / 255.0).abs() < 2e-3);
    // The shadow lies ahead, on the ground: nothing of the sky is dark.
    assert!(new.line(0).iter().all(|&code| code == 180));
    // The same again gives the same bytes, the other method another picture of nearly the same darkness.
    let bytes = fs::read(out.join(names[1])).unwrap();
    folder.run(SYNCHRONISED, &out).unwrap();
    assert_eq!(fs::read(out.join(names[1])).unwrap(), bytes);
    let tube = Method::ScanConverter(ScanConverter::default());
    let other = folder.run(tube, &folder.join("tube")).unwrap();
    assert_ne!(other[0].pixels_blake3, done[0].pixels_blake3);
    assert!((other[0].work.dark - share).abs() < 0.02 * share.max(0.1), "{} {share}", other[0].work.dark);
    assert!(done[0].times.setup_s > other[0].times.setup_s && other[0].times.write_s > 0.033);
    assert!(done[0].work.line_generators >= 4 && done[0].work.intersections > 50);
    assert_eq!(folder.sequence().unwrap().period(), 0.6 - 0.5);
}

/// Of a camera: in colour, the second under the name that cameras give. What comes out is grey, and a PNG.
#[test]
fn pictures_in_colour_become_grey_by_their_luminance() {
    let folder = Folder::new();
    let codes = [200, 100, 50].repeat(SIZE[0] * SIZE[1]);
    let colour = ColourPicture::new(SIZE[0], SIZE[1], Depth::Eight, codes).unwrap();
    let expected = colour.to_grey(Curve::Srgb).code(0, 0);
    write_png(folder.join("frames/frame-000004.png"), &colour, &[]).unwrap();
    fs::remove_file(folder.join("frames/frame-000005.png")).unwrap();
    write_png(folder.join("frames/frame-000005.JPG"), &colour, &[]).unwrap();
    let done = folder.run(SYNCHRONISED, &folder.join("out")).unwrap();
    let names: Vec<_> = done.iter().map(|work| work.file.as_str()).collect();
    assert_eq!(names, ["frame-000004.png", "frame-000005.png", "frame-000006.png"]);
    for (name, sky) in names.iter().zip([expected, expected, 180]) {
        let new = read_png(folder.join("out").join(name), &Limits::default()).unwrap();
        assert!(new.line(0).iter().all(|&code| code == sky), "{name}");
    }
    fs::write(folder.join("frames/frame-000005.JPG"), b"\xFF\xD8\xFF\xE0 cut off").unwrap();
    let said = folder.run(SYNCHRONISED, &folder.join("again")).unwrap_err().to_string();
    assert!(said.contains("frame-000005.JPG: not a whole JPEG"), "{said}");
}

#[test]
fn gaps_are_named() {
    let folder = Folder::new();
    fs::remove_file(folder.join("frames/frame-000005.png")).unwrap();
    assert!(folder.refused().contains("no picture of frame 5, which"), "{}", folder.refused());
    let folder = Folder::new();
    (7..20).for_each(|frame| folder.picture(&format!("frame-{frame:06}.png"), SIZE));
    let said = folder.refused();
    assert!(said.contains("no pose of frames 7, 8, 9, 10, 11 and 8 others, which"), "{said}");
    let folder = Folder::new();
    folder.picture("again-4.png", SIZE);
    assert!(folder.refused().contains("both are frame 4"), "{}", folder.refused());
    let folder = Folder::new();
    for frame in 4..7 {
        fs::remove_file(folder.join(&format!("frames/frame-{frame:06}.png"))).unwrap();
    }
    assert!(folder.refused().contains("no picture here: expected PNG files"), "{}", folder.refused());
}

#[test]
fn sizes_are_the_cameras() {
    let folder = Folder::new();
    folder.picture("frame-000006.png", [100, 61]);
    let said = folder.refused();
    assert!(
        said.contains("frame-000006.png: 100 columns and 61 lines, expected 100 and 60 as camera.json"),
        "{said}"
    );
    assert!(folder.join("out/frame-000005.png").exists() && !folder.join("out/frame-000006.png").exists());
    let said = folder.run(SYNCHRONISED, &folder.join("frames")).unwrap_err().to_string();
    assert!(said.contains("would replace the old ones"), "{said}");
}

#[test]
fn angles_in_the_other_unit_are_told() {
    let notes = |name: &str, headings: [f64; 2]| {
        let folder = Folder::new();
        let row =
            |(index, heading): (usize, &f64)| format!("{index},{index},{},5,3,{heading},0,0\n", 10 * index);
        let rows: String = headings.iter().enumerate().map(row).collect();
        folder.write("poses.csv", &format!("frame,t_s,x_m,y_m,z_m,{name},pitch_deg,roll_deg\n{rows}"));
        vehicle_shadow::read_poses(&folder.join("poses.csv")).unwrap().notes.join("; ")
    };
    assert!(notes("heading_rad", [90.0, 45.0]).contains("heading_rad goes up to 90, more than 2 pi"));
    assert!(notes("heading_rad", [3.0, 2.0]).contains("only if they are those of a column heading_deg"));
    assert!(notes("heading_deg", [370.0, 360.0]).contains("heading_deg goes up to 370"));
    assert_eq!([notes("heading_deg", [3.0, 2.0]), notes("heading_rad", [0.05, 0.03])], ["", ""]);
}

#[test]
fn poses_are_refused_with_their_line() {
    let header = "frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg";
    for (rest, words) in [
        ("\n4,0.4,1,2,3,4,5,six\n", "`roll_deg` must be a number from -36000 to 36000, not six"),
        ("\n4,0.4,1,2,3,4,NaN,6\n", "`pitch_deg` must be a number from -36000 to 36000, not NaN"),
        ("\n4,0.4,1,2,3,4,5\n", "a row of 7 cells under a header of 8"),
        ("\n# a remark\n-1,0.4,1,2,3,4,5,6\n", "`frame` must be a frame number, whole and from 0, not -1"),
        ("\n4,0.4,1,2,3,4,5,6\n4,0.5,1,2,3,4,5,6\n", "`frame` must be a frame that no row before has, not 4"),
        ("\n4,0.4,1,2,3,4,5,6\n5,0.4,1,2,3,4,5,6\n", "t = 0.4 s is not after the frame before, at 0.4 s"),
        (",height_m\n4,0.4,1,2,3,4,5,6,-2\n", "`height_m` must be a height above 0 m, not -2"),
        ("\n", "a table of poses without rows"),
        (",colour\n4,0.4,1,2,3,4,5,6,7\n", "unknown column `colour`"),
        (";height_m\n", "two kinds of separators in one header"),
    ] {
        let folder = Folder::new();
        folder.write("poses.csv", &format!("{header}{rest}"));
        assert!(folder.refused().contains(words), "{words}: {}", folder.refused());
    }
    let folder = Folder::new();
    folder.write("poses.csv", "frame,t_s\n1,2\n");
    assert!(folder.refused().contains("missing column `x_m`"), "{}", folder.refused());
}

#[test]
fn cameras_are_perspective() {
    for (old, new, words) in [
        ("exact:", "as-reported:", "the projection law `as-reported`; expected a perspective"),
        ("[0.466, 0.268]", "[0.466, -1]", "expected two tangents above 0"),
        ("tan_half_field", "tan_field", "missing field `tan_half_field`"),
    ] {
        let folder = Folder::new();
        folder.write("camera.json", &CAMERA.replace(old, new));
        assert!(folder.refused().contains(words), "{words}: {}", folder.refused());
    }
    let folder = Folder::new();
    fs::remove_file(folder.join("camera.json")).unwrap();
    assert!(folder.refused().contains("name its file by --camera, or give --field"), "{}", folder.refused());
    assert_eq!(Camera::of_field([0.0, 30.0]), None);
    let field = Camera::of_field([50.0, 30.0]).unwrap().field;
    assert!((field.tan_half_width - 0.466307658).abs() < 1e-9);
}

/// A roll that is not drawn, one that is, and one that the file tells by itself.
#[test]
fn pictures_roll_with_their_camera() {
    let folder = Folder::new();
    folder.write(
        "poses.csv",
        "frame,t_s,x_m,y_m,z_m,heading_deg,pitch_deg,roll_deg,yoke_deg,height_m\n4,0,1,2,3,0,0,10,-3,55\n",
    );
    let told = vehicle_shadow::read_poses(&folder.join("poses.csv")).unwrap().by_frame[&4];
    let [still, rolling] =
        [false, true].map(|rolls| Camera { rolls, ..Camera::of_field([50.0, 30.0]).unwrap() });
    assert!((told.shot(&rolling, 1.6).camera.roll - quantities::radians(-3.0)).abs() < 1e-15);
    assert_eq!(told.shot(&rolling, 1.6).height, 55.0);
    let untold = vehicle_shadow::FramePose { yoke: None, height: None, ..told };
    assert_eq!(untold.shot(&still, 1.6).camera.roll, 0.0);
    assert_eq!(untold.shot(&rolling, 1.6).camera.roll, untold.attitude.roll);
    assert_eq!((untold.shot(&still, 1.6).height, untold.shot(&still, 1.6).vehicle), (1.6, untold.attitude));
}
