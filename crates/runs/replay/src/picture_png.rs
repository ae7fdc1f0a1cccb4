//! A picture of a mission as the PNG that a run keeps.

use landscape::Attitude;
use picture::{AnyPicture, PictureError};
use quantities::{Rate, degrees};
use run_record::Program;
use scenario::PoseRow;

/// The PNG of a picture that `program` has drawn from the pose of `row`, with its text chunks. `index` is the picture's number
/// at `rate`, the clock that each picture of the mission belongs to.
///
/// # Errors
/// If the picture cannot be packed.
pub fn picture_png(
    program: &Program,
    (index, rate): (u64, Rate),
    row: &PoseRow,
    picture: &AnyPicture,
) -> Result<Vec<u8>, PictureError> {
    let [x, y, z] = row.pose.eye;
    let Attitude { roll, pitch, heading } = row.pose.attitude;
    let [heading, pitch, roll] = [heading, pitch, roll].map(degrees);
    let texts = [
        ("Software", format!("{} {}", program.name, program.version)),
        ("Frame", index.to_string()),
        ("Time", format!("{} s", index as f64 / rate.hertz())),
        ("Pose", format!("x_m={x} y_m={y} z_m={z} heading_deg={heading} pitch_deg={pitch} roll_deg={roll}")),
    ];
    picture.encode_png(&texts.each_ref().map(|(key, text)| (*key, text.as_str())))
}
