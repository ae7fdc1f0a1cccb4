use super::*;
use std::time::Instant;
#[test]
fn bench() {
    let scene = Scene::long();
    let mut lean = AnalogParts::ideal();
    lean.full_scale = 10.0;
    lean.function_generator.bandwidth = Some(5e6);
    lean.multiplier.bandwidth = Some(8e6);
    lean.multiplying_dac.bandwidth = Some(4e6);
    lean.multiplying_dac.bits = Some(12);
    lean.amplifier.gain_bandwidth = Some(80e6);
    lean.amplifier.slew = Some(200e6);
    lean.amplifier.saturation = Some(11.0);
    lean.amplifier.recovery = 1e-6;
    lean.summer_inputs = Some(6);
    let mut full = super::plain::of_1970(|p| p.amplifier.noise = 5e-4);
    full.sweep.glitch = 20e-9;
    for (name, parts) in [("lean", lean), ("full", full)]
        .into_iter()
        .filter(|(n, _)| std::env::var("ONLY").map_or(true, |o| o == *n))
    {
        let array = PartsArray::<f32>::new(STEP, &scene.level, &parts, 3, "tg");
        let (generator, samples) = (scene.generator(), scene.ranges.len());
        let mut profile = Profile::default();
        profile.resize(samples);
        let state = &mut ArrayState::default();
        let mut best = f64::INFINITY;
        for _ in 0..std::env::var("REPS").map_or(200, |r| r.parse().unwrap()) {
            let t = Instant::now();
            array.trace(&generator, &scene.programs, 0..samples, 40, state, &mut profile, &mut ());
            best = best.min(t.elapsed().as_secs_f64());
        }
        let steps: usize = scene.programs.iter().map(|p| p.steps.len()).sum();
        println!(
            "{name}: {:.1} ns a sample, steps {} {}",
            best * 1e9 / 8000.0,
            steps / 8,
            profile.height[500][3]
        );
    }
}
