//! The drive over the south pole from a photograph: what `panels` shows of the ground, against the closed form over the same elevations.

use std::sync::Arc;

use exact::Exact;
use generator::{Generator, PlaneKind, Planes, Session};
use hardware_model::HardwareModel;
use photo_camera::Light;
use photo_make::{import, write_imported};
use quantities::radians;
use scenario::{PhotographWish, PoseTable, Scenario};
use signal::Probe;
use survey::{ReadOptions, SurveyOptions, survey};

use crate::shared;

/// Columns and lines of the pictures: a quarter of the scenario's.
const SIZE: [u32; 2] = [160, 90];
/// Step of range, as a part of it, that makes a ridge.
const RIDGE: f32 = 0.2;

/// How far a picture is from the closed form.
#[derive(Debug)]
struct Geometry {
    /// Share of the pixels that show ground in one picture and sky in the other.
    mask: f64,
    /// Mean distance of the ranges beside ridges, as a part of the range.
    mean: f64,
    /// Share of the pixels beside ridges whose range is off by more than a hundredth.
    off: f64,
}

impl Geometry {
    fn of(found: &[f32], right: &[f32]) -> Self {
        let [columns, lines] = SIZE.map(|side| side as usize);
        let pixels = (columns * lines) as f64;
        let is_ridge = compare::ridge_mask(right, columns, lines, RIDGE).expect("a range plane");
        let other = found.iter().zip(right).filter(|(a, b)| a.is_finite() != b.is_finite()).count();
        let errors: Vec<f64> = (0..found.len())
            .filter(|at| !is_ridge[*at] && found[*at].is_finite() && right[*at].is_finite())
            .map(|at| f64::from((found[at] - right[at]).abs() / right[at]))
            .collect();
        let off = errors.iter().filter(|error| **error > 0.01).count();
        Self {
            mask: other as f64 / pixels,
            mean: errors.iter().sum::<f64>() / errors.len() as f64,
            off: off as f64 / errors.len() as f64,
        }
    }
}

#[test]
fn a_drive_over_a_photograph_has_the_geometry_of_the_closed_form() {
    let Some(data) = shared::data() else { return };
    let read = |file: &str| {
        survey::read(data.join("lunar").join(file), &ReadOptions::default()).expect("a readable file")
    };
    let folder = tempfile::tempdir().expect("a folder");
    let image = read("nac_southpole_image_M139939938LE_1m.tif");
    // The sun of docs/real-ground.md: azimuth from the grid's north and elevation.
    let light = Light::new(Some([355.3, 4.9].map(radians)), None).expect("a sun");
    write_imported(folder.path(), &import(&image, Some(400.0), &light).expect("light")).expect("a folder");
    let [file, camera] = ["photo.png", "camera.json"].map(|name| folder.path().join(name));

    let path = shared::scenario("south-pole-photo.toml");
    let scenario = Scenario::read_beside(path, &registry::parameter_tables()).expect("a sound scenario");
    let mut scenario = Scenario { photographs: vec![PhotographWish { file, camera }], ..scenario };
    (scenario.raster.columns, scenario.raster.lines) = (Some(SIZE[0]), Some(SIZE[1]));
    let options = SurveyOptions { held_out: 0.1, ..SurveyOptions::new(6.0) };
    let found = survey(&read("nac_southpole_stereo_dem_1m.tif"), &options, &mut |_| {})
        .expect("ground that can be fitted");
    let settings = front_door::settings(&scenario, &HardwareModel::ideal()).expect("settings");
    let stage = front_door::over(found.bank, &scenario, settings).expect("a stage").stage();
    let poses = PoseTable::resolve(&scenario, &stage.landscape, stage.view.update, None, 0..160)
        .unwrap_or_else(|problems| panic!("{problems}"));

    let sets = [("panels.spacing_m", "1"), ("panels.relight", "true"), ("panels.pattern", "\"1\"")];
    let panels: Arc<dyn Generator> =
        registry::configure_with(&panels::ROW, &sets).unwrap_or_else(|problems| panic!("{problems}"));
    let [panels, exact] = [panels.prepare(stage.clone()), Exact.prepare(stage)].map(Result::unwrap);
    for frame in [0, 80, 159] {
        let draw = |session: &dyn Session| {
            let mut planes =
                Planes::new(SIZE[0] as usize, SIZE[1] as usize, &[PlaneKind::Intensity, PlaneKind::Range]);
            let pose = poses.rows()[frame].pose;
            session
                .frame(frame as u64, &pose, &mut planes, &mut Probe::off())
                .expect("a pose that can be drawn");
            planes.get(PlaneKind::Range).expect("asked for").to_vec()
        };
        let geometry = Geometry::of(&draw(&*panels), &draw(&*exact));
        println!("south-pole-photo frame {frame}: {geometry:?}");
        assert!(
            geometry.mask < 0.01 && geometry.mean < 0.005 && geometry.off < 0.05,
            "frame {frame}: {geometry:?}"
        );
    }
}
