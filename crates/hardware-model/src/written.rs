//! A model as written: the keys of its parts.

mod blocks;

use diagnostics::Reader;
use quantities::Rate;
use scenario::{Laws, words};
use sweep_program::{Colour, PreloadRegister};

use crate::{
    Cpu, CrossingServer, DataBanks, HardwareModel, LatePolicy, LoadDelay, Loader, ModelRaster,
    SweepMemoryKind,
};

/// Format of model files that this program reads.
pub const FORMAT: u64 = 1;

const COLOURS: [(&str, Colour); 4] =
    [("yellow", Colour::Yellow), ("green", Colour::Green), ("black", Colour::Black), ("red", Colour::Red)];

const REGISTERS: [(&str, PreloadRegister); 2] =
    [("x-first", PreloadRegister::XFirst), ("y-first", PreloadRegister::YFirst)];

/// The model of all layers. Every key is needed; what a file leaves out, its base has.
pub(crate) fn model(root: &Reader, name: String) -> Option<HardwareModel> {
    let raster = root.table("raster").map(|table| raster(&table));
    let range = root.table("range").map(|table| words::range(&table));
    let clock = root.table("dpu").map(|table| words::rate(&table, "clock_mhz", 1_000_000).required());
    let loader = root.table("loader").map(|table| loader(&table, clock.flatten()));
    let dpp = root.table("dpp");
    let memory = root.table("sweep_memory");
    let kind = memory.as_ref().map(sweep_memory);
    let features = root.table("feature_generator");
    let shadows = root.table("shadow_controller").map(|table| blocks::shadow_controller(&table));
    let mixing = root.table("mixing_unit");
    let polyhedra = root.table("polyhedron_generator");
    let roll = root.table("roll").map(|table| blocks::roll(&table));
    let laws = laws(&LawTables { dpp, memory, features: &features, mixing: &mixing, polyhedra });
    let feature_generator = features.as_ref().map(blocks::feature_generator);
    let mixing_unit = mixing.as_ref().map(blocks::mixing_unit);
    root.finish();
    Some(HardwareModel {
        name,
        raster: raster??,
        range: range??,
        master_clock: clock??,
        cpu: Cpu::default(),
        loader: loader??,
        data_banks: DataBanks { drum: None, buffer_words: None },
        seed: 0,
        laws: laws?,
        sweep_memory: kind??,
        feature_generator: feature_generator??,
        shadow_controller: shadows??,
        mixing_unit: mixing_unit??,
        yoke: roll??,
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

fn loader(table: &Reader, clock: Option<Rate>) -> Option<Loader> {
    let access = table.f64("access_ns").between(0.0, 1e9).unit("ns").required();
    let late_policy = table
        .one_of(
            "late_policy",
            &[("strobe-through", LatePolicy::StrobeThrough), ("latched", LatePolicy::Latched)],
        )
        .required();
    let tables = table.tables("delay");
    let delays: Vec<_> = tables.iter().map(delay).collect();
    refuse_twins(&tables, &delays);
    Some(Loader {
        served_by: CrossingServer::WiredPointers,
        words_per_access: 9,
        access: ticks(access?, clock?),
        pointer: 0,
        strobe: 0,
        urgent_first: true,
        diagonal_register: false,
        late_policy: late_policy?,
        delays: delays.into_iter().collect::<Option<_>>()?,
    })
}

/// One word of one request can be held back once: two entries would send it twice.
fn refuse_twins(tables: &[Reader], delays: &[Option<LoadDelay>]) {
    let which = |delay: &LoadDelay| (delay.sweep, delay.crossing, delay.colour, delay.register, delay.word);
    let meet = |a: Option<u64>, b: Option<u64>| a.is_none() || b.is_none() || a == b;
    for (index, delay) in delays.iter().enumerate() {
        let Some(delay) = delay else { continue };
        let mut earlier = delays[..index].iter().flatten();
        if earlier.any(|other| which(other) == which(delay) && meet(other.frame, delay.frame)) {
            let problem =
                tables[index].problem("word", "the same word of the same crossing is delayed twice");
            let help = "join both entries into one, or give them different frames";
            tables[index].report(problem.expected("one entry for each word").help(help));
        }
    }
}

/// Whole ticks that `nanoseconds` take: a word is there at the first tick after it came.
fn ticks(nanoseconds: f64, clock: Rate) -> u64 {
    let ticks = nanoseconds * clock.hertz() / 1e9;
    // 950 ns at 20 MHz is 19 ticks, not 20 because of a last bit.
    (ticks - 1e-9 * ticks).ceil() as u64
}

fn delay(table: &Reader) -> Option<LoadDelay> {
    let frame = table.u64("frame").optional();
    let sweep = table.u32("sweep").below(8192).required();
    let crossing = table.u32("crossing").required();
    let colour = table.one_of("colour", &COLOURS).required();
    let register = table.one_of("register", &REGISTERS).required();
    let orders = table.u64_list("word").must("the two orders [p, q], each 0 to 2", |orders| {
        orders.len() == 2 && orders.iter().all(|&order| order <= 2)
    });
    let word = orders.map(|orders| (3 * orders[0] + orders[1]) as usize).required();
    let ticks = table.u64("ticks").required();
    Some(LoadDelay {
        frame,
        sweep: sweep?,
        crossing: crossing?,
        colour: colour?,
        register: register?,
        word: word?,
        ticks: ticks?,
    })
}

/// The list of delays as a model file has it, in one line.
pub(crate) fn delays_as_written(delays: &[LoadDelay]) -> String {
    let tables: Vec<String> = delays.iter().map(delay_as_written).collect();
    format!("[{}]", tables.join(", "))
}

fn delay_as_written(delay: &LoadDelay) -> String {
    let frame = delay.frame.map_or(String::new(), |frame| format!("frame = {frame}, "));
    let LoadDelay { sweep, crossing, ticks, .. } = delay;
    let colour = word(&COLOURS, delay.colour);
    let register = word(&REGISTERS, delay.register);
    let [p, q] = [delay.word / 3, delay.word % 3];
    format!(
        "{{ {frame}sweep = {sweep}, crossing = {crossing}, colour = {colour:?}, register = {register:?}, \
         word = [{p}, {q}], ticks = {ticks} }}"
    )
}

fn word<T: PartialEq>(words: &[(&'static str, T)], meaning: T) -> &'static str {
    words.iter().find(|(_, known)| *known == meaning).map_or("", |(word, _)| word)
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
    Some(Laws {
        projection: projection?,
        curvature: curvature?,
        occlusion: occlusion?,
        pixel_rule: pixel_rule?,
        feature_light: feature_light?,
        body_visibility: body_visibility?,
        shadowed_bodies: shadowed?,
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
