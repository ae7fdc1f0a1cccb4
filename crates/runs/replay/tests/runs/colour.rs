//! Frames in colour, of a generator that paints three planes by formula.

use std::fs;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use generator::{
    Counter, FrameCounts, FrameError, Generator, Omission, PlaneKind, Planes, PrepareError, Session, Stage,
};
use picture::{AnyPicture, Depth, Encoder, Limits, Transfer, png_texts, read_any_png};
use quantities::{Rate, luminance};
use replay::{Control, HeldRun, Job, Phases, Pictures, ReplayError, RunFolder, run, write_y4m};
use run_record::{Inputs, Program};
use scenario::{Pose, Scenario};
use signal::Probe;
use tempfile::tempdir;

use crate::stage::{SCENARIO, document, settings, stage};

/// Paints red to the right, green downwards, blue by frame; its intensity is their luminance.
struct Painter {
    planes: &'static [PlaneKind],
}

const COLOUR: Painter =
    Painter { planes: &[PlaneKind::Intensity, PlaneKind::Red, PlaneKind::Green, PlaneKind::Blue] };

impl Generator for Painter {
    fn name(&self) -> &'static str {
        "painter"
    }

    fn counters(&self) -> &'static [Counter] {
        &[]
    }

    fn planes(&self) -> &'static [PlaneKind] {
        self.planes
    }

    fn prepare(&self, _: Stage) -> Result<Box<dyn Session>, PrepareError> {
        Ok(Box::new(Brush))
    }
}

struct Brush;

/// Linear red, green and blue of a pixel.
fn paint(frame: u64, at: usize, [columns, lines]: [usize; 2]) -> [f64; 3] {
    let share = |index: usize, count: usize| (index as f64 + 0.5) / count as f64;
    [share(at % columns, columns), share(at / columns, lines), frame as f64 / 4.0]
}

impl Session for Brush {
    fn frame(
        &self,
        frame: u64,
        _: &Pose,
        planes: &mut Planes,
        _: &mut Probe,
    ) -> Result<FrameCounts, FrameError> {
        let size = [planes.columns(), planes.lines()];
        for kind in COLOUR.planes {
            let Some(values) = planes.get_mut(*kind) else { continue };
            for (at, value) in values.iter_mut().enumerate() {
                let colour = paint(frame, at, size);
                let channel = PlaneKind::COLOUR.iter().position(|channel| channel == kind);
                *value = channel.map_or(luminance(colour), |channel| colour[channel]) as f32;
            }
        }
        Ok(FrameCounts::default())
    }

    fn check(&self, _: u64, _: &Pose) -> Result<(), FrameError> {
        Ok(())
    }

    fn omissions(&self) -> Vec<Omission> {
        Vec::new()
    }
}

fn drawn(
    generator: Arc<dyn Generator>,
    pictures: Pictures,
    frames: Range<u64>,
    out: &Path,
) -> Result<(), ReplayError> {
    let scenario = Scenario::parse("test.toml", SCENARIO).expect("the scenario is right");
    let [name, version, commit, result_family] = ["lunoid", "0", "c", "unfused"].map(str::to_owned);
    let job = Job {
        program: Program { name, version, commit, result_family },
        inputs: Inputs { model: "ideal".into(), ..Inputs::default() },
        scenario: &scenario,
        generator,
        stage: stage(&scenario).stage(),
        frames,
        shard: None,
        pictures,
        check: 0,
    };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("threads");
    let cancel = AtomicBool::new(false);
    let folder = RunFolder::claim(out, false)?;
    let control = Control { pool: &pool, cancel: &cancel, progress: &|_| () };
    run(&job, &folder, &control, &mut Phases::since(Instant::now())).map(|_| ())
}

fn pictures(depth: Depth, colour: bool) -> Pictures {
    Pictures { depth, colour, refresh: false, film: true }
}

fn frame(out: &Path, number: u64) -> AnyPicture {
    read_any_png(out.join(format!("frames/frame-{number:06}.png")), &Limits::default()).expect("a frame")
}

#[test]
fn frames_are_the_three_planes_through_the_display_law() {
    for depth in [Depth::Eight, Depth::Sixteen] {
        let at = tempdir().unwrap();
        drawn(Arc::new(COLOUR), pictures(depth, true), 0..3, at.path()).unwrap();
        let held = HeldRun::read(at.path()).unwrap();
        assert_eq!(document(&held)["pictures"]["kind"], "RGB PNG");
        let display = &document(&held)["view"]["display"];
        let [white, gamma] = ["white", "gamma"].map(|key| display[key].as_f64().unwrap() as f32);
        let encoder = Encoder::new(Transfer::new(white, gamma).unwrap(), depth);
        for number in 0..3 {
            let AnyPicture::Colour(found) = frame(at.path(), number) else { panic!("a frame in colour") };
            let size = [found.columns(), found.lines()];
            let plane = |channel: usize| -> Vec<f32> {
                (0..size[0] * size[1]).map(|pixel| paint(number, pixel, size)[channel] as f32).collect()
            };
            let planes = [plane(0), plane(1), plane(2)];
            let expected =
                encoder.encode_colour(planes.each_ref().map(|plane| &plane[..]), size[0], size[1]).unwrap();
            assert_eq!(found, expected);
            assert_eq!(held.frames[number as usize].pixels_blake3, found.pixel_hash());
        }
        let bytes = fs::read(at.path().join("frames/frame-000001.png")).unwrap();
        assert_eq!(
            png_texts(&bytes).iter().map(|(key, _)| key.as_str()).collect::<Vec<_>>(),
            ["Software", "Frame", "Time", "Pose"]
        );
    }
}

#[test]
fn sheet_film_and_y4m_are_in_colour() {
    let at = tempdir().unwrap();
    drawn(Arc::new(COLOUR), pictures(Depth::Sixteen, true), 0..3, at.path()).unwrap();
    let first = frame(at.path(), 0).to_eight_bits();
    let read = |name: &str| read_any_png(at.path().join(name), &Limits::default()).unwrap();
    assert_eq!(read("animation.png"), first);
    let sheet = read("contact-sheet.png");
    assert!(sheet.is_colour() && sheet.columns() > first.columns());
    let (mut film, held) = (Vec::new(), HeldRun::read(at.path()).unwrap());
    write_y4m(&mut film, at.path(), &held, Rate::new(10, 1).unwrap()).unwrap();
    let heading = film.iter().position(|byte| *byte == b'\n').unwrap() + 1;
    assert!(String::from_utf8_lossy(&film[..heading]).ends_with(" C444 XCOLORRANGE=FULL XMATRIX=BT709\n"));
    assert_eq!(film.len() - heading, 3 * (6 + 3 * first.columns() * first.lines()));
}

/// The same generator in grey: luminance, and another run than that in colour.
#[test]
fn grey_and_colour_are_two_runs_of_one_picture() {
    let at = tempdir().unwrap();
    let (grey, colour) = (at.path().join("grey"), at.path().join("colour"));
    drawn(Arc::new(COLOUR), pictures(Depth::Eight, false), 0..3, &grey).unwrap();
    drawn(Arc::new(COLOUR), pictures(Depth::Eight, true), 0..3, &colour).unwrap();
    let documents = [&grey, &colour].map(|out| HeldRun::read(out).unwrap());
    assert_ne!(documents[0].fingerprint, documents[1].fingerprint);
    assert_eq!(document(&documents[0])["pictures"]["kind"], "grey PNG");
    let gamma = document(&documents[0])["view"]["display"]["gamma"].as_f64().unwrap();
    let (grey, of_colour) = (frame(&grey, 2), frame(&colour, 2).to_grey(picture::Curve::Power(gamma)));
    let AnyPicture::Grey(grey) = grey else { panic!("a grey frame") };
    // Each channel was rounded to a code before.
    let far = |(a, b): (&u16, &u16)| a.abs_diff(*b) > 1;
    assert!(!grey.codes().iter().zip(of_colour.codes()).any(far));
}

#[test]
fn a_generator_without_colour_is_refused_before_anything_is_drawn() {
    let at = tempdir().unwrap();
    let part = Painter { planes: &[PlaneKind::Intensity, PlaneKind::Red, PlaneKind::Green] };
    let scenario = Scenario::parse("test.toml", SCENARIO).expect("the scenario is right");
    let machine = machine::HybridMachine::new(settings(&scenario));
    let generators: [Arc<dyn Generator>; 2] = [Arc::new(machine), Arc::new(part)];
    for generator in generators {
        let name = generator.name();
        let refused = drawn(generator, pictures(Depth::Eight, true), 0..1, &at.path().join("x"));
        let said = refused.expect_err("it has no colour").to_string();
        let expected = format!("{name} draws no colour: expected a generator that fills");
        assert!(said.starts_with(&expected), "{said}");
        assert!(!at.path().join("x/frames").exists());
    }
}
