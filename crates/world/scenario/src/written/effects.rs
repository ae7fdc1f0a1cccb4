//! What is seen beside ground and bodies: `[[light]]`, `[[sheet]]`, `[[overlay]]`, `[stars]`, `[earth]`, `disc` of `[sun]`.

use std::path::Path;

use diagnostics::{Problems, Reader};

use super::scenery::report_twins;
use super::{earth, lights, overlays, part, sheets, stars};
use crate::{EffectWishes, Object};

/// The effects of a scenario. Nothing is known of `sun` where there is no such table, nor of `objects` if one has a fault.
pub(super) fn effects(
    root: &Reader,
    sun: Option<&Reader>,
    objects: Option<&[Object]>,
    folder: &Path,
    white_magnitude: Option<f64>,
    problems: &Problems,
) -> Option<EffectWishes> {
    let is_dated = sun.is_some_and(|table| table.has("at"));
    let sun_disc = sun.map_or(Some(false), |table| table.bool("disc").default(false));
    let tables = ["light", "sheet", "overlay"].map(|key| root.tables(key));
    let (light_ids, lights) = lights::lights(&tables[0], objects);
    let (sheet_ids, sheets) = sheets::sheets(&tables[1]);
    let (overlay_ids, overlays) = overlays::overlays(&tables[2]);
    let ids = [&light_ids, &sheet_ids, &overlay_ids];
    let named = tables.iter().zip(ids).flat_map(|(tables, ids)| tables.iter().zip(ids));
    let twins = report_twins(named, "lights, sheets or overlays");
    let stars = part(root, "stars", |table| stars::stars(table, is_dated, folder, problems));
    let earth = part(root, "earth", |table| earth::earth(table, is_dated));
    let (lights, sheets, overlays) = (lights?, sheets?, overlays?);
    let (stars, earth, sun_disc, white_magnitude) = (stars?, earth?, sun_disc?, white_magnitude?);
    let wishes = EffectWishes { lights, sheets, overlays, stars, earth, sun_disc, white_magnitude };
    (!twins).then_some(wishes)
}
