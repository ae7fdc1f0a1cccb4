//! Runs of one scene under the overlays, and what differs.

use std::collections::BTreeSet;
use std::sync::Arc;

use generator::Planes;
use hardware_model::{HardwareModel, ModelSource};
use landscape::{CraterGrain, Landscape};
use lunoid_tests::Shipped;
use machine::Prepare;
use signal::{Probe, Waveform};

use crate::overlays::drawing::family;
use crate::overlays::listed::Overlay;

/// Sweeps of the frame, of which those in [`LOOKED_AT`] are recorded.
const SWEEPS: u32 = 96;
const LOOKED_AT: std::ops::Range<u32> = 32..64;
const FRAME: u64 = 60;

/// Rubble in craters of one type, dust in those of another, so that the wire of the grain is there.
const CRATER_GAIN: [f64; 3] = [2.0, 0.5, 3.0];

/// A frame in which every block works, on regions of the report's order.
pub struct Scene {
    shipped: Shipped,
    folder: tempfile::TempDir,
}

impl Scene {
    pub fn new() -> Self {
        let mut shipped = Shipped::read("full-drive", Some(SWEEPS));
        shipped.scenario.texture.as_mut().expect("grain").crater_gain = CRATER_GAIN;
        let landscape = Landscape::clone(&shipped.landscape);
        shipped.landscape = Arc::new(landscape.with_crater_grain(CraterGrain::new(CRATER_GAIN)));
        Self { shipped, folder: tempfile::tempdir().expect("a folder of its own") }
    }

    /// All signals by the ideal machine, with an overlay if there is one. Occlusion is by derivative, so that its circuit is there.
    pub fn waveforms(&self, overlay: Option<&Overlay>) -> Vec<Waveform> {
        let overlays: Vec<_> = overlay
            .map(|overlay| {
                let file = self.folder.path().join(format!("{}.toml", overlay.name));
                std::fs::write(&file, overlay.text()).expect("a file");
                file
            })
            .into_iter()
            .collect();
        let sets = [("dpp.occlusion".to_owned(), "\"derivative\"".to_owned())];
        let ideal = ModelSource::BuiltIn("ideal".into());
        let model = HardwareModel::load(&ideal, &overlays, &sets).unwrap_or_else(|e| panic!("{e}")).model;
        let settings = front_door::settings(&self.shipped.scenario, &model).expect("settings of an overlay");
        let settings =
            hardware_model::Settings { shadow_cache: self.shipped.settings.shadow_cache.clone(), ..settings };
        let mut shipped = self.shipped.clone();
        shipped.settings = settings;
        let stage = match shipped.settings.data_banks.drum {
            None => shipped.stage(),
            // What a drum has brought depends on the frames before.
            Some(_) => front_door::build(&shipped.scenario, shipped.settings.clone()).expect("full drive"),
        };
        let session = stage.prepare();
        let mut probe = Probe::new(vec!["*".into()], LOOKED_AT);
        let pose = shipped.pose(FRAME).pose;
        session.frame(FRAME, &pose, &mut Planes::new(0, 0, &[]), &mut probe).expect("a frame");
        probe.waveforms
    }
}

/// Families of which a waveform differs.
pub fn moved(clean: &[Waveform], faulty: &[Waveform]) -> BTreeSet<String> {
    assert_eq!(clean.len(), faulty.len());
    let differs = |(a, b): &(&Waveform, &Waveform)| {
        assert_eq!((a.signal.name, a.sweep), (b.signal.name, b.sweep));
        bits(&a.values) != bits(&b.values) || bits(&a.times) != bits(&b.times)
    };
    clean.iter().zip(faulty).filter(differs).map(|(a, _)| family(a.signal.name)).collect()
}

/// The bits of numbers, which compare in blocks in a program without optimisation as well.
fn bits(numbers: &[f64]) -> &[u64] {
    bytemuck::cast_slice(numbers)
}

/// `yoke.angle` of frames of the rough ride, under an overlay if there is one (rad).
pub fn yoke_angles(overlay: Option<&Overlay>, frames: std::ops::Range<u64>) -> Vec<f64> {
    let folder = tempfile::tempdir().expect("a folder of its own");
    let file = folder.path().join("overlay.toml");
    let overlays =
        overlay.map(|overlay| std::fs::write(&file, overlay.text()).map(|()| file.clone()).expect("a file"));
    let source = ModelSource::BuiltIn("ideal".into());
    let overlays: Vec<_> = overlays.into_iter().collect();
    let model = HardwareModel::load(&source, &overlays, &[]).unwrap_or_else(|e| panic!("{e}")).model;
    let mut shipped = Shipped::read("rough-ride", Some(16));
    shipped.settings = front_door::settings(&shipped.scenario, &model).expect("settings of an overlay");
    // Shadows take most of such a frame, and no yoke minds them.
    shipped.settings.shadows = None;
    let session = shipped.stage().prepare();
    let angle = |frame: u64| {
        let pose = shipped.pose(frame).pose;
        let mut probe = Probe::new(vec!["yoke.angle".into()], 3..4);
        session.frame(frame, &pose, &mut Planes::new(0, 0, &[]), &mut probe).expect("a frame");
        let [wave] = probe.waveforms.as_slice() else { panic!("one wire") };
        assert_eq!((wave.values[0], wave.times.as_slice()), (pose.yoke, &[0.0][..]));
        wave.values[0]
    };
    frames.map(angle).collect()
}
