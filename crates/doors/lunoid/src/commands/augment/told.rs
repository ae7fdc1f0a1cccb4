//! What `lunoid augment` tells of what it did.

use clap::ValueEnum;
use serde_json::{Value, json};
use timing::Comparison;
use vehicle_shadow::{Augmentation, FrameWork, GroundLaw, Method, SUN_POINTS, ScanConverter, Sequence};

use command_line::Failure;
use command_line::output::{print, print_json};
use command_line::program::COMMIT;

use super::Augment;
use super::probing::Recorded;

/// Differences from a baseline that are told one by one.
const TOLD: usize = 60;

impl Augment {
    /// The keys of the record that decide every picture beside the old ones.
    pub(super) fn decides(&self, augmentation: &Augmentation, sequence: &Sequence) -> Value {
        let function = augmentation.shape.function();
        let camera = sequence.camera();
        json!({
            "program": { "name": "lunoid", "version": env!("CARGO_PKG_VERSION"), "commit": COMMIT },
            "camera": {
                "field_of_view_deg": camera.angles_of_view(),
                "roll_drawn": camera.rolls,
            },
            "vehicle": {
                "shape": self.vehicle,
                "eye_height_m": augmentation.eye_height,
                "figures": function.figures().len(),
                "string_points": function.points().len(),
                "points": function.vertices(),
            },
            "sun_deg": self.sun,
            "sun_points": if self.penumbra { SUN_POINTS } else { 1 },
            "ground": self.ground,
            "outline": matches!(augmentation.ground, GroundLaw::Flat(_)).then(|| word(&self.outline)),
            "track_patches": match &augmentation.ground {
                GroundLaw::Flat(_) => 0,
                GroundLaw::True { tracks, .. } => tracks.len(),
            },
            "method": method_record(&augmentation.method, word(&self.method)),
        })
    }

    /// All of it, as a document: what `decides`, and what came of it.
    pub(super) fn record(&self, decides: Value, sequence: &Sequence, made: &[FrameWork]) -> Value {
        let most = |time: fn(&FrameWork) -> f64| made.iter().map(time).fold(0.0, f64::max);
        let largest = |count: fn(&FrameWork) -> u64| made.iter().map(count).max().unwrap_or(0);
        let mut record = decides;
        record["schema"] = "lunoid.augment/1".into();
        record["frames_of"] = self.frames.display().to_string().into();
        record["poses"] = self.poses.display().to_string().into();
        record["timing"] = json!({
            "picture_period_s": sequence.period(),
            "largest_setup_s": most(|frame| frame.times.setup_s),
            "largest_write_s": most(|frame| frame.times.write_s),
            "most_pictures": largest(|frame| frame.times.pictures),
            "most_line_generators": largest(|frame| frame.work.line_generators),
        });
        record["frames"] = json!(made);
        record
    }

    /// Prints it, with what was probed and what came of the baseline.
    pub(super) fn print(
        &self,
        mut record: Value,
        probed: Option<&Recorded>,
        check: Option<&Comparison>,
    ) -> Result<(), Failure> {
        match (self.saying.json, self.saying.quiet) {
            (true, _) => {
                if let Some(probed) = probed {
                    record["probe"] = probed.json();
                }
                if let Some(check) = check {
                    record["timing_check"] = check.json();
                }
                print_json(&record)
            }
            (_, true) => Ok(()),
            _ => {
                let check = check.map(|check| check.text(TOLD));
                let parts = [Some(self.text(&record)), probed.map(Recorded::text), check];
                print(&parts.into_iter().flatten().collect::<String>())
            }
        }
    }

    fn text(&self, record: &Value) -> String {
        let timing = &record["timing"];
        let ms = |key: &str| 1e3 * timing[key].as_f64().unwrap_or(0.0);
        let frames = record["frames"].as_array().map_or(0, Vec::len);
        format!(
            "{}: {frames} frames with the shadow of {}\n  gear of 1969: set-up {:.1} ms and writing {:.1} ms of a picture of \
             {:.1} ms, so a new shadow every {}; {} line generators\n",
            self.out.display(),
            self.vehicle,
            ms("largest_setup_s"),
            ms("largest_write_s"),
            ms("picture_period_s"),
            match timing["most_pictures"].as_u64() {
                Some(1) => "picture".to_owned(),
                most => format!("{} pictures", most.unwrap_or(0)),
            },
            timing["most_line_generators"],
        )
    }
}

/// The word of the command line.
pub(super) fn word(value: &impl ValueEnum) -> String {
    value.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
}

fn method_record(method: &Method, name: String) -> Value {
    match method {
        Method::Synchronised { dac_bits } => json!({ "name": name, "dac_bits": dac_bits }),
        Method::ScanConverter(ScanConverter { tv_lines, registration, gain }) => {
            json!({ "name": name, "tv_lines": tv_lines, "registration_share": registration, "gain": gain })
        }
    }
}
