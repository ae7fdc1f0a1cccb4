//! The page of a check: photograph and relief, to be flipped.

use maud::{DOCTYPE, Markup, PreEscaped, html};
use picture::{ColourPicture, PictureError, encode_png};
use text::data_url;

use crate::{Overlay, Report};

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// Nothing from anywhere but this file.
const POLICY: &str = "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'; \
                      base-uri 'none'; form-action 'none'";

/// The page: one file that needs no other, and no network.
///
/// # Errors
/// If a picture cannot be made.
pub fn page(overlay: &Overlay, report: &Report) -> Result<String, PictureError> {
    let [photo, relief] = [url(&overlay.photo()?)?, url(&overlay.relief()?)?];
    let [columns, lines] = overlay.size();
    let [name, ground] = &report.files;
    let page: Markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="generator" content="lunoid";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                link rel="icon" href="data:,";
                title { (name) " over " (ground) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (name) " over " (ground) }
                p {
                    "Both pictures are in map geometry, north up. Space or a click flips them; the slider mixes them. \
                     Amber posts were void in the elevation file. Violet ground is hidden from the camera by other ground. Dark blue \
                     has no ground or no photograph."
                }
                div.controls {
                    button type="button" id="flip" { "Flip" }
                    button type="button" id="blink" aria-pressed="false" { "Blink" }
                    label { "photograph " input type="range" id="mix" min="0" max="100" value="0"; " relief" }
                    output id="shown" for="mix" { "photograph" }
                }
                div.stack {
                    img src=(photo) width=(columns) height=(lines) alt="The photograph in map geometry";
                    img id="relief" src=(relief) width=(columns) height=(lines) alt="The elevation grid, shaded";
                }
                h2 { "Figures" }
                pre { (report.text()) }
                script { (PreEscaped(SCRIPT)) }
            }
        }
    };
    Ok(text::visible(&page.into_string()).into_owned())
}

fn url(picture: &ColourPicture) -> Result<String, PictureError> {
    Ok(data_url("image/png", &encode_png(picture, &[])?))
}
