//! At which instants of a step signals are evaluated, where a picture needs no more: the rule of the default quality.
//!
//! **Law.** A picture is drawn straight between instants if nothing stands in the way ([`instants_obstacle`]), and if the economy says
//! how many, or the counts of the scene do: craters that a sweep meets on the mean, and whether there are boundaries of shadow. The
//! counts are those of the stage alone, so all frames of a run, and all machines that draw a part of it, have one number.
//! **Our choice.** The numbers of instants are the least whose picture is no worse than the whole machine's, against the closed form
//! (docs/economy.md, *Quality*).

use hardware_model::{Economy, Gate, Settings};
use scenario::FeatureLight;

use crate::stage::MachineStage;

/// What of a machine of `settings` keeps it from drawing straight between instants; `None` if nothing does.
///
/// It needs parts that are ideal beside those of the terrain generators, and laws under which terrain and features
/// are lit as one surface. Tubes may have parts: they come after.
pub fn instants_obstacle(settings: &Settings) -> Option<&'static str> {
    let parts = &settings.analog;
    let obstacles = [
        (settings.laws.feature_light != FeatureLight::Combined, "features lit apart from the terrain"),
        (settings.mixing_unit.gate != Gate::Presence, "video switches keyed by the video itself"),
        (parts.reflectivity.delay_mismatch != 0.0, "a delay of the reflectivity against the height"),
        (!parts.features_are_ideal(), "parts of the feature generator"),
        (!parts.shadow_lines_are_ideal(), "parts of the shadow controller"),
        (!parts.texture_is_ideal(), "parts of the texture generator"),
        (!parts.body_switch_is_ideal(), "parts of the third video switch"),
        (!parts.switching_is_ideal(), "parts of the mixing unit"),
        (!parts.beam_is_ideal(), "parts of the display projection processor or of the write gun"),
    ];
    obstacles.into_iter().find(|(stands, _)| *stands).map(|(_, what)| what)
}

/// Instants a step of the accumulators at which the machine for `stage` evaluates its signals, if it draws straight between instants.
/// Where parts that are left remember the step before (`has_memory`), a step has one instant, and the rule draws the whole machine.
pub(crate) fn instants(stage: &MachineStage, has_memory: bool) -> Option<u32> {
    let settings = &stage.settings;
    let wished = match settings.economy {
        Economy::Instants(_) if has_memory => Some(1),
        Economy::Instants(count) => Some(count),
        Economy::Normal if !has_memory => by_counts(&Counts::of(stage)),
        _ => None,
    };
    wished.filter(|_| instants_obstacle(settings).is_none())
}

/// What the rule asks of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Counts {
    /// Craters that a sweep meets in a step of the accumulators, on the mean over the ground.
    craters: f64,
    /// Whether boundaries of remote shadow are drawn.
    has_shadows: bool,
}

impl Counts {
    fn of(stage: &MachineStage) -> Self {
        let settings = &stage.settings;
        let [south, west, north, east] = stage.landscape.level().extent();
        let craters = stage.landscape.features().craters();
        let width: f64 = (0..craters.len() as u32).map(|index| 2.0 * craters.circle(index).1).sum();
        let met = width * settings.range.end / ((north - south) * (east - west));
        Self { craters: met / f64::from(settings.raster.samples), has_shadows: settings.shadows.is_some() }
    }
}

/// Craters a step from which on a step needs more instants. Chosen, as the numbers below: docs/economy.md has the errors.
const MANY: f64 = 0.05;

/// Craters a step from which on the whole machine, which lights each step once, is no better (inferred; one shipped scene has as many).
const MORE_THAN_LIGHT: f64 = 2.0;

/// Instants a step; `None` where the whole machine is as quick.
fn by_counts(counts: &Counts) -> Option<u32> {
    match *counts {
        Counts { craters, .. } if (MANY..MORE_THAN_LIGHT).contains(&craters) => Some(5),
        Counts { craters, has_shadows } if craters > 0.0 || has_shadows => Some(4),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use hardware_model::{HardwareModel, ModelSource, Settings};
    use scenario::{Display, FieldOfView, LawWishes, RasterWishes, Scalar};

    use super::{Counts, by_counts, instants_obstacle};

    fn settings(model: &str) -> Settings {
        let model = HardwareModel::load(&ModelSource::BuiltIn(model.into()), &[], &[]).unwrap().model;
        let field = FieldOfView { tan_half_width: 0.4, tan_half_height: 0.3 };
        let (raster, laws, display) =
            (RasterWishes::default(), LawWishes::default(), Display { white: 1.0, gamma: 1.0 });
        Settings::resolve(&model, field, raster, None, laws, Scalar::F32, display).unwrap()
    }

    #[test]
    fn ideal_parts_are_drawn_at_instants_and_others_name_what_is_in_the_way() {
        assert_eq!(instants_obstacle(&settings("ideal")), None);
        let delayed = "a delay of the reflectivity against the height";
        assert_eq!(instants_obstacle(&settings("pra-nominal")), Some(delayed));
    }

    /// The counts of the shipped scenes that the table of docs/economy.md has.
    #[test]
    fn the_rule_is_that_of_the_table() {
        let of = |craters, has_shadows| by_counts(&Counts { craters, has_shadows });
        assert_eq!(of(0.0, false), None, "first light");
        assert_eq!([of(0.028, true), of(0.0, true), of(0.01, false)], [Some(4); 3], "full drive");
        assert_eq!([of(0.28, true), of(0.13, true), of(0.89, true)], [Some(5); 3], "craters");
        assert_eq!(of(2.4, true), Some(4), "showpiece");
    }
}
