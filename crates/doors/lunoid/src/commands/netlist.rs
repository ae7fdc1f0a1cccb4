//! `lunoid netlist`: the chain of one sweep as a circuit for ngspice, an array or its light.

use std::path::PathBuf;

use ::lockstep::Engines;
use ::netlist::{Agreement, Circuit, INSTANTS, LightCircuit, Netlist, compare, of_array, of_light, run};
use ::text::table;
use between::Between;
use clap::{Args, ValueEnum};
use front_door::Opened;
use rayon::ThreadPool;
use scenario::Pose;
use scope::Looking;
use serde_json::json;
use signal::Waveform;

use crate::frame::FrameArgs;
use command_line::loading::{expect_machine, machine_stage};
use command_line::output::{Place, expect_outputs, print, print_json};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid netlist scenarios/first-light.toml --machine pra-nominal --frame 10 --sweep 200 \\
    --out chain.cir
  lunoid netlist scenarios/nominal-drive.toml --machine pra-nominal --frame 10 --sweep 200 \\
    --block coarse --out far.cir --check

The circuit runs as it stands: ngspice -b -r chain.raw chain.cir. --check runs it, and compares
the ramps, two function generators and the three sums with the machine's, at eight instants of
every sample, by the waveform norm (1e-3 of the value and 1e-4 of full scale). With --block
light it compares the wires of the stage that makes light of slopes, which is given the
machine's slopes. The exit code is 1 if a signal is farther off.";

/// Write the terrain generator's chain of one sweep as a circuit that ngspice runs.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct NetlistCommand {
    #[command(flatten)]
    chosen: FrameArgs,
    /// Sweep of the frame, from 0 at the left.
    #[arg(long, value_name = "S", value_parser = values::at_least(0_u32))]
    sweep: u32,
    /// Terrain generator whose chain is written, or the light behind both.
    #[arg(long, value_enum, default_value_t = Block::Fine)]
    block: Block,
    /// File of the circuit.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Run the circuit with ngspice and compare its waveforms with the machine's; the raw file stands beside the circuit.
    #[arg(long)]
    check: bool,
    /// Print the comparison as JSON.
    #[arg(long, requires = "check")]
    json: bool,
}

/// Blocks that have a circuit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Block {
    /// Terrain generator of near ground.
    Fine,
    /// Terrain generator of far ground, of a scenario with two levels.
    Coarse,
    /// Stage that makes light of the slopes.
    Light,
}

impl NetlistCommand {
    /// Writes the circuit, and compares what ngspice makes of it.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let stage = self.chosen.stage()?;
        expect_outputs(&[Place::file("--out", &self.out)], &stage.sources())?;
        let opened = self.chosen.load(&stage)?;
        expect_machine(&opened, "only the hybrid machine has such a circuit")?;
        self.chosen.expect_in(&opened)?;
        let sweeps = opened.settings.raster.sweeps;
        if self.sweep >= sweeps {
            return Err(Failure::usage(format!(
                "--sweep {}: a frame has sweeps 0..{sweeps}; expected one of them",
                self.sweep
            )));
        }
        let pool = self.chosen.threads.pool()?;
        let (engines, pose) = self.engines(&opened, &pool)?;
        let title = format!(
            "{}, {}, frame {}, sweep {}",
            opened.scenario.title, opened.inputs.model, self.chosen.frame, self.sweep
        );
        let netlist = pool.install(|| self.netlist((&engines, &pose), &title))?;
        files::write_atomic(&self.out, |out| out.write_all(netlist.text.as_bytes()))?;
        if !self.check {
            print(&format!("{}: run it with ngspice -b -r chain.raw {0}\n", self.out.display()))?;
            return Ok(Verdict::Yes);
        }
        let curves = run(&netlist, &self.out, &self.out.with_extension("raw")).map_err(Failure::input)?;
        let machine = self.machine((&engines, &pose), &pool, &opened, &netlist)?;
        let of = |name: &str| machine.iter().find(|wave| wave.signal.name == name);
        let found = compare(&netlist, &curves, |name| of(name).map_or(&[], |wave| &wave.values));
        self.tell(&title, &netlist, &found)?;
        Ok(if found.iter().all(Agreement::holds) { Verdict::Yes } else { Verdict::No })
    }

    fn engines(&self, opened: &Opened, pool: &ThreadPool) -> Result<(Engines, Pose), Failure> {
        let frame = self.chosen.frame;
        let stage = machine_stage(opened, pool)?;
        let poses = opened.poses(&stage.stage(), frame..frame + 1).map_err(Failure::input)?;
        Ok((Engines::new(stage), poses.rows()[0].pose))
    }

    fn netlist(&self, (engines, pose): (&Engines, &Pose), title: &str) -> Result<Netlist, Failure> {
        let at = (self.chosen.frame, pose);
        let (level, name) = match self.block {
            Block::Fine => (0, ""),
            Block::Coarse => (1, "coarse."),
            Block::Light => {
                let lit = engines.light(at, self.sweep).map_err(Failure::input)?;
                let lit = lit.ok_or_else(|| self.no_circuit())?;
                let (stage, slopes) = (&lit.stage, &lit.slopes);
                return Ok(of_light(&LightCircuit {
                    title,
                    stage,
                    slopes,
                    to_sun: lit.to_sun,
                    step: lit.step,
                }));
            }
        };
        let array = engines.array(at, self.sweep, level).map_err(Failure::input)?;
        let array = array.ok_or_else(|| self.no_circuit())?;
        let circuit = Circuit { title, array: &array, broken_lines: engines.broken_lines(), level: name };
        Ok(of_array(&circuit))
    }

    fn no_circuit(&self) -> Failure {
        Failure::usage(match self.block {
            Block::Fine => {
                "--machine: this model has an ideal terrain generator, which has no circuit; expected one with real parts, as pra-nominal has"
            }
            Block::Coarse => {
                "--block coarse: expected a scenario with two levels, and a model whose terrain generator has real parts"
            }
            Block::Light => {
                "--block light: this model makes light by the law, which has no circuit; expected one with a figure of its parts, as reflectivity.divider_bandwidth_mhz"
            }
        })
    }

    /// The machine's waveforms at [`INSTANTS`] a sample.
    fn machine(
        &self,
        (engines, pose): (&Engines, &Pose),
        pool: &ThreadPool,
        opened: &Opened,
        netlist: &Netlist,
    ) -> Result<Vec<Waveform>, Failure> {
        let clocks = opened.settings.timebase;
        let divided = clocks.divided(INSTANTS).map_err(Failure::input)?;
        let between = Between::new(engines, pool, (self.chosen.frame, pose), [clocks, divided]);
        let signals = netlist.signals().map(str::to_owned).collect();
        Ok(between.at(signals, self.sweep..self.sweep + 1)?)
    }

    fn tell(&self, title: &str, netlist: &Netlist, found: &[Agreement]) -> Result<(), Failure> {
        let names: Vec<&str> = netlist.signals().collect();
        if self.json {
            let signals: Vec<_> = found.iter().map(|agreement| {
                let Agreement { node, norm, worst, samples, skipped } = *agreement;
                json!({ "signal": names[node], "norm": norm, "worst": worst, "instants": samples, "skipped": skipped })
            }).collect();
            return print_json(&json!({ "schema": "lunoid.netlist/2", "what": title, "signals": signals }));
        }
        let head = ["signal", "norm", "worst (FS)", "instants", "beside edges"].map(str::to_owned).to_vec();
        let rows = found.iter().map(|agreement| {
            vec![
                names[agreement.node].to_owned(),
                format!("{:.3}", agreement.norm),
                format!("{:.1e}", agreement.worst),
                agreement.samples.to_string(),
                agreement.skipped.to_string(),
            ]
        });
        let verdict =
            if found.iter().all(Agreement::holds) { "the circuit agrees" } else { "the circuit differs" };
        print(&format!(
            "{title}\n\n{}\n{verdict}\n",
            table(&[head].into_iter().chain(rows).collect::<Vec<_>>())
        ))
    }
}
