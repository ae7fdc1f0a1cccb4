//! `lunoid state load`: the machine from a file, and on.

use std::path::{Path, PathBuf};

use clap::Args;
use files::make_folder;
use generator::{PlaneKind, Planes};
use picture::{Depth, Encoder, Transfer};
use replay::picture_png;
use scenario::View;
use serde_json::{Value, json};
use state::{Bench, State};

use super::held::{HeldArgs, bench};
use command_line::output::{Place, ending, expect_outputs, print, print_json};
use command_line::{Failure, Verdict, values};

const AFTER: &str = "Examples:
  lunoid state load there.state
  lunoid state load there.state --out frame.png
  lunoid state load there.state --frames 3 --out after
  lunoid state load there.state moved/nominal-drive.toml --machine pra-overloaded --out frame.png

What the file holds is used, and not drawn again: rows of the frame, earlier stores, earlier
pictures. The pictures are those of `lunoid replay`, to the byte. Without --out the state is
read and told.";

/// Read the machine from a file and draw the rest of its frame, and frames after it.
#[derive(Debug, Args)]
#[command(after_help = AFTER)]
pub struct Load {
    #[command(flatten)]
    held: HeldArgs,
    /// Number of frames that are drawn, with the one that the state is in.
    #[arg(long, value_name = "N", default_value = "1", value_parser = values::at_least(1_u64))]
    frames: u64,
    /// PNG of the frame; or a folder, into which frames are written as frame-NNNNNN.png.
    #[arg(short, long, value_name = "PNG|FOLDER")]
    out: Option<PathBuf>,
    /// Print what the state holds, and what was written, as JSON.
    #[arg(long)]
    json: bool,
}

impl Load {
    /// Restores the machine, draws the frames, and says what the state holds.
    pub fn run(&self) -> Result<Verdict, Failure> {
        let state = self.held.read()?;
        let stage = self.held.stage(&state)?;
        expect_outputs(&self.outputs()?, &self.held.sources(&stage))?;
        let rehearsal = self.held.rehearsal(&stage, &state)?;
        let bench = bench(&rehearsal, &stage);
        let view = rehearsal.stage.settings.view();
        let written = rehearsal.pool.install(|| -> Result<_, Failure> {
            bench.restore(&state, &self.held.file)?;
            self.expect_frames(&bench, &state)?;
            match &self.out {
                Some(out) => self.draw(&bench, &view, &state, out),
                None => Ok(Vec::new()),
            }
        })?;
        self.tell(&state, &written)?;
        Ok(Verdict::Yes)
    }

    /// What is written: a picture or a folder, as the name says.
    fn outputs(&self) -> Result<Vec<Place>, Failure> {
        let Some(out) = &self.out else {
            return match self.frames {
                1 => Ok(Vec::new()),
                frames => {
                    Err(Failure::usage(format!("--frames {frames}: expected --out with a folder for them")))
                }
            };
        };
        match (is_picture(out), self.frames) {
            (true, 1) => Ok(vec![Place::file("--out", out)]),
            (true, frames) => Err(Failure::usage(format!(
                "--out {}: a picture has one frame, --frames asks for {frames}; name a folder",
                out.display()
            ))),
            (false, _) => Ok(vec![Place::folder("--out", out, is_frame)]),
        }
    }

    fn expect_frames(&self, bench: &Bench<'_>, state: &State) -> Result<(), Failure> {
        let (frame, end) = (state.head.place.frame, bench.clock().frames());
        if self.frames <= end - frame {
            return Ok(());
        }
        Err(Failure::usage(format!(
            "--frames {}: the state is in frame {frame}, and the scenario has frames 0..{end}; expected at most {}",
            self.frames,
            end - frame
        )))
    }

    /// Draws and writes frame by frame; the files.
    fn draw(
        &self,
        bench: &Bench<'_>,
        view: &View,
        state: &State,
        out: &Path,
    ) -> Result<Vec<String>, Failure> {
        if !is_picture(out) {
            make_folder(out)?;
        }
        let first = state.head.place.frame;
        let mut written = Vec::new();
        for frame in first..first + self.frames {
            let planes = if frame == first { bench.go_on(state)? } else { bench.frame(frame)? };
            let path =
                if is_picture(out) { out.to_owned() } else { out.join(format!("frame-{frame:06}.png")) };
            let png = png(bench, view, frame, &planes)?;
            files::write_atomic(&path, |file| file.write_all(&png))?;
            written.push(path.display().to_string());
        }
        Ok(written)
    }

    fn tell(&self, state: &State, written: &[String]) -> Result<(), Failure> {
        let file = self.held.file.display();
        if self.json {
            let mut document = state.json();
            document["schema"] = Value::from("lunoid.state.load/1");
            document["file"] = json!(file.to_string());
            document["written"] = json!(written);
            return print_json(&document);
        }
        let lines: String = written.iter().map(|path| format!("{path}\n")).collect();
        print(&format!("{file}: {}{lines}", state.text()))
    }
}

fn is_picture(out: &Path) -> bool {
    ending(out) == "png"
}

fn is_frame(name: &str) -> bool {
    name.starts_with("frame-") && name.ends_with(".png")
}

/// The picture of a frame as `lunoid replay` writes it.
fn png(bench: &Bench<'_>, view: &View, frame: u64, planes: &Planes) -> Result<Vec<u8>, Failure> {
    let transfer = Transfer::new(view.display.white as f32, view.display.gamma as f32);
    let encoder = Encoder::new(transfer.map_err(Failure::input)?, Depth::Eight);
    let intensity = planes.get(PlaneKind::Intensity).unwrap_or_default();
    let picture = encoder.encode(intensity, planes.columns(), planes.lines()).map_err(Failure::input)?;
    let row = bench.row(frame)?;
    picture_png(bench.program(), (frame, view.update), &row, &picture.into()).map_err(Failure::input)
}
