//! A model as written: the keys of its parts.

mod analog;
mod blocks;
mod digital;
mod kind_banks;
mod loader;

use analog::SharedTables;
use diagnostics::Reader;
use scenario::{Laws, words};

pub(crate) use loader::delays_as_written;

use crate::{HardwareModel, ModelRaster, SweepMemoryKind};

/// Format of model files that this program reads.
pub const FORMAT: u64 = 1;

/// The model of all layers. Every key is needed; what a file leaves out, its base has.
pub(crate) fn model(root: &Reader, name: String) -> Option<HardwareModel> {
    let raster = root.table("raster").map(|table| raster(&table));
    let range = root.table("range").map(|table| words::range(&table));
    let clock = root.table("dpu").map(|table| words::rate(&table, "clock_mhz", 1_000_000).required());
    let known_clock = clock.flatten();
    let cpu = root.table("cpu").map(|table| digital::cpu(&table, known_clock));
    let level_turn = digital::level_turn(&root.table_or_empty("level_turn"));
    let io_processor = root.table("io_processor").map(|table| loader::io_processor(&table, known_clock));
    let loader =
        root.table("loader").map(|table| loader::loader(&table, known_clock, io_processor.flatten()));
    let drums = root.table("drum");
    let drum = drums.as_ref().map(|table| digital::drum(table, known_clock));
    let channels = root.table("channel").map(|table| digital::channels(&table, known_clock));
    let buffers = root.table("buffer");
    let buffer = buffers
        .as_ref()
        .map(|table| digital::data_banks(drum.flatten().flatten(), channels.flatten(), table));
    let kind_banks = kind_banks::kind_banks(root, [&drums, &buffers], known_clock);
    let spread = root.table("spread");
    let seed = spread.as_ref().map(|table| table.u64("seed").required());
    let (dpp, memory) = (root.table("dpp"), root.table("sweep_memory"));
    let (features, shadows) = (root.table("feature_generator"), root.table("shadow_controller"));
    let shared =
        SharedTables { spread: &spread, dpp: &dpp, memory: &memory, features: &features, shadows: &shadows };
    let analog = analog::analog(root, &shared);
    let kind = memory.as_ref().map(sweep_memory);
    let feature_words = features.as_ref().map(blocks::load_words);
    let segment_words = shadows.as_ref().map(blocks::load_words);
    let shadow_controller = shadows.as_ref().map(blocks::shadow_controller);
    let mixing = root.table("mixing_unit");
    let polyhedra = root.table("polyhedron_generator");
    let yoke = root.table("roll").map(|table| blocks::yoke(&table));
    let laws = laws(&LawTables { dpp, memory, features: &features, mixing: &mixing, polyhedra });
    let feature_generator = features.as_ref().map(blocks::feature_generator);
    let mixing_unit = mixing.as_ref().map(blocks::mixing_unit);
    root.finish();
    drum??;
    Some(HardwareModel {
        name,
        raster: raster??,
        range: range??,
        master_clock: clock??,
        cpu: cpu??,
        level_turn: level_turn?,
        loader: loader??,
        data_banks: buffer??,
        kind_banks: kind_banks?,
        seed: seed??,
        laws: laws?,
        sweep_memory: kind??,
        feature_generator: feature_generator??,
        shadow_controller: shadow_controller??,
        mixing_unit: mixing_unit??,
        yoke: yoke??,
        feature_words: feature_words??,
        segment_words: segment_words??,
        analog: analog?,
    })
}

fn raster(table: &Reader) -> Option<ModelRaster> {
    let sweeps = table.u32("sweeps").between(1, 8192).required();
    let samples = table.u32("samples_per_sweep").between(2, 65_536).required();
    let blanking_fraction = table.f64("blanking_fraction").between(0.0, 0.9).required();
    let update = words::rate(table, "update_hz", 1).required();
    let refresh = words::rate(table, "refresh_hz", 1).required();
    words::check_refresh(table, update, refresh);
    Some(ModelRaster {
        sweeps: sweeps?,
        samples: samples?,
        blanking_fraction: blanking_fraction?,
        update: update?,
        refresh: refresh?,
    })
}

/// Tables that hold the laws that the machine is wired for.
struct LawTables<'a> {
    dpp: Option<Reader<'a>>,
    memory: Option<Reader<'a>>,
    features: &'a Option<Reader<'a>>,
    mixing: &'a Option<Reader<'a>>,
    polyhedra: Option<Reader<'a>>,
}

/// Every table is asked for its laws before one that is missing ends the reading.
fn laws(of: &LawTables) -> Option<Laws> {
    let projection = of.dpp.as_ref().and_then(|table| words::projection(table).required());
    let curvature = of.dpp.as_ref().and_then(|table| words::curvature(table).required());
    let occlusion = of.dpp.as_ref().and_then(|table| words::occlusion(table).required());
    let pixel_rule = of.memory.as_ref().and_then(|table| words::pixel_rule(table).required());
    let feature_light =
        of.features.as_ref().and_then(|table| words::feature_light(table, "light").required());
    let texture = of.mixing.as_ref().and_then(|table| words::texture_in_shadow(table).required());
    let visibility = |table: &Reader| words::body_visibility(table, "visibility").required();
    let body_visibility = of.polyhedra.as_ref().and_then(visibility);
    let shadowed = of.polyhedra.as_ref().and_then(|table| words::shadowed_bodies(table).required());
    let shading = |table: &Reader| words::body_shading(table, "shading").required();
    let body_shading = of.polyhedra.as_ref().and_then(shading);
    Some(Laws {
        projection: projection?,
        curvature: curvature?,
        occlusion: occlusion?,
        pixel_rule: pixel_rule?,
        feature_light: feature_light?,
        body_visibility: body_visibility?,
        shadowed_bodies: shadowed?,
        body_shading: body_shading?,
        texture_in_shadow: texture?,
    })
}

fn sweep_memory(table: &Reader) -> Option<SweepMemoryKind> {
    let kinds = [
        ("scan-converter", SweepMemoryKind::ScanConverter),
        ("digital-memory", SweepMemoryKind::DigitalMemory),
    ];
    table.one_of("kind", &kinds).required()
}
