//! timing
#[path = "../tests/pictures/scenes.rs"]
#[allow(dead_code)]
mod common;
use common::*;
use landscape::relief::*;
use scenario::*;
use std::sync::Arc;
use std::time::Instant;
fn main() {
    let mut relief = Relief::flat(7, [12_000.0, 12_000.0], 40.0);
    relief.undulation =
        Some(Undulation { rms_height: 25.0, hurst: 0.85, longest: 4000.0, shortest: 130.0, waves: 400 });
    println!("rms slope {}", relief.undulation.as_ref().unwrap().rms_slope());
    let level = relief.build().unwrap();
    let land = landscape(level, 1.0);
    let h = land.height(6000.0, 6000.0).unwrap();
    for (name, projection, pitch) in [
        ("exact 0", Projection::Exact, 0.0),
        ("exact -3", Projection::Exact, -3.0),
        ("as-rep -3", Projection::AsReported, -3.0),
    ] {
        for rule in [PixelRule::Centre, PixelRule::LineMean] {
            for end in [5000.0] {
                let s = settings(1000, 575, laws(projection, Curvature::Parabolic, rule), [1.5, end]);
                let t = Instant::now();
                let session = prepare(Arc::clone(&land), sun(120.0, 10.0), &s);
                let tp = t.elapsed();
                let mut planes = generator::Planes::new(1000, 575, &[generator::PlaneKind::Intensity]);
                let t = Instant::now();
                session
                    .frame(
                        0,
                        &pose([6000.0, 6000.0, h + 1.63], pitch, 33.0),
                        &mut planes,
                        &mut signal::Probe::off(),
                    )
                    .unwrap();
                let v = planes.get(generator::PlaneKind::Intensity).unwrap();
                println!(
                    "{name} {rule:?} {end}: prepare {tp:?} frame {:?} mean {}",
                    t.elapsed(),
                    v.iter().sum::<f32>() / v.len() as f32
                );
                if rule == PixelRule::LineMean {
                    let mut out = b"P5 1000 575 255\n".to_vec();
                    out.extend(v.iter().map(|i| (i.sqrt() * 255.0).min(255.0) as u8));
                    std::fs::write(format!("/tmp/exact-{}.pgm", name.replace(' ', "_")), out).unwrap();
                }
            }
        }
    }
}
