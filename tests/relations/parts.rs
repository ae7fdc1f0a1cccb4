//! What a part does wrong goes to nothing with the figure that it has for it.

use control_plane::MachineStage;
use generator::{PlaneKind, Planes};
use hardware_model::{AnalogParts, HardwareModel, Settings};
use lunoid_tests::{ComparedScene, random};
use machine::Prepare;
use scenario::Scalar;
use signal::Probe;

/// A figure of a part, as a share of a plain fault.
type Figure = fn(&mut AnalogParts, f64);

const FIGURES: [(&str, Figure); 10] = [
    ("multiplier.error", |parts, s| parts.multiplier.error = 0.01 * s),
    ("multiplier.feedthrough", |parts, s| parts.multiplier.feedthrough = 0.5 * s),
    ("multiplying_dac.gain_error", |parts, s| parts.multiplying_dac.gain_error = 0.01 * s),
    ("function_generator.error", |parts, s| parts.function_generator.error = 0.01 * s),
    ("sweep.smoother", |parts, s| parts.sweep.smoother = 2e-6 * s),
    ("projection.error", |parts, s| parts.projection.error = 0.02 * s),
    ("video_switch.level_mismatch", |parts, s| parts.video_switch.level_mismatch = 0.05 * s),
    ("amplifier.noise", |parts, s| parts.amplifier.noise = 0.0005 * s),
    ("wires.bandwidth", |parts, s| parts.wires.bandwidth = Some(1e5 / s)),
    ("video_bandwidth", |parts, s| parts.video_bandwidth = Some(1e6 / s)),
];

fn picture(scene: &ComparedScene, parts: &AnalogParts) -> Vec<f32> {
    let stage = scene.stage();
    let settings = Settings { analog: parts.clone(), ..stage.settings.clone() };
    let session = (MachineStage { settings, ..stage }).prepare();
    let mut planes = Planes::new(scene.sweeps as usize, scene.lines as usize, &[PlaneKind::Intensity]);
    session.frame(1, &scene.pose(), &mut planes, &mut Probe::off()).unwrap();
    planes.get(PlaneKind::Intensity).unwrap().to_vec()
}

/// Mean amount by which two pictures differ: that of edges goes to nothing as their shift does.
fn mean_difference(a: &[f32], b: &[f32]) -> f64 {
    a.iter().zip(b).map(|(a, b)| f64::from((a - b).abs())).sum::<f64>() / a.len() as f64
}

#[test]
fn artefacts_go_to_nothing_with_their_figures() {
    let ideal = HardwareModel::ideal().analog;
    for (name, figure) in FIGURES {
        let sizes = [1.0, 1e-2, 1e-4].map(|share| {
            let of_seed = |seed: u64| {
                let scene = ComparedScene { scalar: Scalar::F64, ..random::landscape(seed) };
                // Blocks of parts draw straight lines between samples: what is compared is parts with parts.
                let with = |share: f64| {
                    let mut parts = ideal.clone();
                    figure(&mut parts, share);
                    picture(&scene, &parts)
                };
                mean_difference(&with(share), &with(1e-9))
            };
            (5000..5006).map(of_seed).sum::<f64>() / 6.0
        });
        println!("{name}: {sizes:?}");
        assert!(sizes[0] > 1e-6, "{name}: nothing to be seen of it: {sizes:?}");
        assert!(sizes[1] < 0.2 * sizes[0] && sizes[2] < 0.2 * sizes[1], "{name}: {sizes:?}");
    }
}
