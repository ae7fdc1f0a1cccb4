//! Whether a machine can draw a preview: signals at the samples alone.

use hardware_model::{Gate, Settings};
use scenario::FeatureLight;

/// What of a machine of `settings` keeps it from drawing a preview; `None` if nothing does.
///
/// A preview needs parts that are ideal beside those of the terrain generators, and laws under which terrain and features
/// are lit as one surface. Tubes may have parts: they come after.
pub fn preview_obstacle(settings: &Settings) -> Option<&'static str> {
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

#[cfg(test)]
mod tests {
    use hardware_model::{HardwareModel, ModelSource, Settings};
    use scenario::{Display, FieldOfView, LawWishes, RasterWishes, Scalar};

    use super::preview_obstacle;

    fn settings(model: &str) -> Settings {
        let model = HardwareModel::load(&ModelSource::BuiltIn(model.into()), &[], &[]).unwrap().model;
        let field = FieldOfView { tan_half_width: 0.4, tan_half_height: 0.3 };
        let (raster, laws, display) =
            (RasterWishes::default(), LawWishes::default(), Display { white: 1.0, gamma: 1.0 });
        Settings::resolve(&model, field, raster, None, laws, Scalar::F32, display).unwrap()
    }

    #[test]
    fn ideal_parts_draw_a_preview_and_others_name_what_is_in_the_way() {
        assert_eq!(preview_obstacle(&settings("ideal")), None);
        let delayed = "a delay of the reflectivity against the height";
        assert_eq!(preview_obstacle(&settings("pra-nominal")), Some(delayed));
    }
}
