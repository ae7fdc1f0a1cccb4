//! The command line: global options, subcommands and version.

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use command_line::output::Colour;
use command_line::program::VERSION;
use ground_commands::{bank, photo, sight, sun, survey, terrain};
use study_commands::{cartridge, lockstep, study};

use crate::commands::{
    augment, beam, check, compare, completions, dataset, drive, explain, farm, info, list, man, merge, model,
    netlist, page, probe, replay, schema, serve, sizing, state, timing, trace, trigger,
};

const AFTER: &str = "Example:
  lunoid replay scenarios/first-light.toml
  lunoid replay --help

Exit codes: 0 done; 1 the answer is no; 2 wrong usage; 3 bad input; 4 output failed; 130
interrupted.";

/// Emulates the hybrid television image generator of a lunar rover simulator (PRA, 1970).
#[derive(Debug, Parser)]
#[command(name = "lunoid", version = VERSION, after_help = AFTER)]
pub struct Cli {
    /// When to colour messages.
    #[arg(long, global = true, value_enum, default_value_t = Colour::Auto)]
    pub color: Colour,
    /// Allow more than a limit does, or less (`lunoid list limits`); may be given several times.
    #[arg(long, global = true, value_name = "NAME=VALUE")]
    pub raise: Vec<String>,
    /// The command to run.
    #[command(subcommand)]
    pub command: Command,
}

impl Cli {
    /// Reads the command line; what is wrong with it ends the program.
    pub fn read() -> Self {
        Self::from_arg_matches(&command().get_matches()).unwrap_or_else(|error| error.exit())
    }
}

/// All commands and options.
pub fn command() -> clap::Command {
    with_negative_numbers(Cli::command())
}

/// A number, a span (`A..B`) or a list (`A,B`) that begins below 0 is a value, so that whoever gives one hears what is expected, and not of an
/// unknown option.
fn with_negative_numbers(command: clap::Command) -> clap::Command {
    let taken = |argument: clap::Arg| {
        let mut names = argument.get_value_names().unwrap_or_default().iter();
        match (
            argument.get_action().takes_values(),
            names.any(|name| name.contains("..") || name.contains(',')),
        ) {
            (false, _) => argument,
            (true, false) => argument.allow_negative_numbers(true),
            (true, true) => argument.allow_hyphen_values(true),
        }
    };
    command.mut_args(taken).mut_subcommands(with_negative_numbers)
}

/// A command of `lunoid`, with its options.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Draw a scenario into a folder of frames.
    Replay(replay::Replay),
    /// Write the page of a run again, from its folder.
    Page(page::PageCommand),
    /// Join the shards of a run into the run of one machine.
    Merge(merge::MergeCommand),
    /// Look at the shards that many workers draw.
    Farm(farm::FarmCommand),
    /// Make labelled frames for learning: samples drawn by a plan, their truth, splits, manifest and data card.
    Dataset(dataset::DatasetCommand),
    /// Put the vehicle's shadow, and its tracks, into an existing picture sequence.
    Augment(augment::Augment),
    /// Say how far one picture, or one run, is from another.
    Compare(compare::Compare),
    /// Read scenarios, hardware models and whatever else is written in TOML, and list every fault.
    Check(check::Check),
    /// List what there is.
    List(list::List),
    /// Say what a file or a run folder holds.
    Info(info::Info),
    /// Record waveforms of some signals of some sweeps.
    Probe(probe::ProbeCommand),
    /// List the signals that can be probed.
    Signals(list::Signals),
    /// Answer requests of another program: pictures of poses, signals, explanations, one step after another.
    Serve(serve::ServeCommand),
    /// Drive the machine in a browser: the instrument as a page, served to this computer alone.
    Drive(drive::DriveCommand),
    /// Explain a pixel: the sweep and sample that made it, and every block there.
    Explain(explain::Explain),
    /// List the light points of a frame that a beam draws.
    Beam(beam::BeamCommand),
    /// Find where in a mission a condition on signals is met.
    Trigger(trigger::TriggerCommand),
    /// List the digital events of a frame, or show all registers at an instant.
    Trace(trace::Trace),
    /// Make, read and draw banks of terrain coefficients.
    Bank(bank::BankCommand),
    /// Fit a bank to an elevation file.
    Survey(survey::SurveyCommand),
    /// Say what ground hides from an observer.
    Sight(sight::SightCommand),
    /// Build landscapes from features, and export them for every generator.
    Terrain(terrain::TerrainCommand),
    /// Say where Sun and Earth stand over a place on the Moon.
    Sun(sun::SunCommand),
    /// Make a photograph of a landscape, and check a photograph against an elevation file.
    Photo(photo::PhotoCommand),
    /// Show, check and list hardware models.
    Model(model::ModelCommand),
    /// Show the timing of the digital side, record it, and hold it to a record.
    Timing(timing::TimingCommand),
    /// Hold the machine in time against its formulas, and search for the slowest parts that would do.
    Sizing(sizing::Sizing),
    /// Run machine and interpreter side by side and compare every signal and every event.
    Lockstep(lockstep::LockstepCommand),
    /// Write the terrain generator's chain of one sweep as a circuit that ngspice runs.
    Netlist(netlist::NetlistCommand),
    /// Write the whole machine at the start of a sweep, go on from there, or step from place to place.
    State(state::StateCommand),
    /// Measure error against run time.
    Study(study::StudyCommand),
    /// Run test cartridges: scenes whose answer is known in closed form.
    Cartridge(cartridge::CartridgeCommand),
    /// Print the JSON Schema of a kind of file, for editors.
    Schema(schema::Schema),
    /// Print the completions of the command line for a shell.
    Completions(completions::Completions),
    /// Write the manual: a page for each command, or print its first page.
    Man(man::ManCommand),
}
