//! Marks as SVG text: letters are outlines of the same font, every glyph once, so nothing depends on the fonts of
//! whoever reads it.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use text::visible_line;

use crate::colour::Colour;
use crate::lettering;
use crate::mark::{Area, Letters, Mark, Surface};

/// An SVG document in the making.
pub(crate) struct Svg {
    columns: u32,
    lines: u32,
    title: String,
    body: String,
    /// Signs used, and areas that clip: definitions of the document.
    signs: BTreeSet<char>,
    clips: BTreeSet<String>,
    clip: Option<String>,
    /// Colours, and what they are for whoever prefers dark.
    dark: BTreeMap<Colour, Colour>,
}

impl Svg {
    /// Paper of one colour.
    pub fn new(columns: u32, lines: u32, paper: Colour, title: &str) -> Self {
        let mut body = String::new();
        let colour = hex(paper);
        let _ = writeln!(body, "<path d=\"M0 0H{columns}V{lines}H0Z\" fill=\"{colour}\"/>");
        let (signs, clips) = (BTreeSet::new(), BTreeSet::new());
        let (clip, dark) = (None, BTreeMap::new());
        Self { columns, lines, title: escaped(title), body, signs, clips, clip, dark }
    }

    /// Whoever prefers dark sees `dark` instead of `colour`.
    pub fn in_the_dark(&mut self, colour: Colour, dark: Colour) {
        self.dark.insert(colour, dark);
    }

    /// Returns the SVG document as text.
    pub fn finish(self) -> String {
        let Self { columns, lines, title, body, .. } = &self;
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{columns}\" height=\"{lines}\" \
             viewBox=\"0 0 {columns} {lines}\" role=\"img\">\n<title>{title}</title>\n\
             <metadata>lunoid</metadata>\n{}<defs>\n",
            self.dark_style()
        );
        for sign in &self.signs {
            let outline = lettering::sign(*sign);
            let _ = writeln!(out, "<path id=\"{}\" d=\"{outline}\"/>", id(*sign));
        }
        for clip in &self.clips {
            let _ = writeln!(out, "<clipPath id=\"c{}\"><path d=\"{clip}\"/></clipPath>", clip_id(clip));
        }
        out + "</defs>\n" + body + "</svg>\n"
    }

    /// A rule for every colour: a rule goes before what stands with the stroke itself.
    fn dark_style(&self) -> String {
        if self.dark.is_empty() {
            return String::new();
        }
        let rule = |(colour, dark): (&Colour, &Colour)| {
            let (colour, dark) = (hex(*colour), hex(*dark));
            format!("[fill=\"{colour}\"]{{fill:{dark}}}[stroke=\"{colour}\"]{{stroke:{dark}}}")
        };
        let rules: String = self.dark.iter().map(rule).collect();
        format!("<style>@media (prefers-color-scheme:dark){{{rules}}}</style>\n")
    }

    fn clip(&mut self, area: Option<Area>) {
        self.clip = area.map(outline);
        self.clips.extend(self.clip.clone());
    }

    fn clipped(&self) -> String {
        self.clip.as_ref().map_or(String::new(), |clip| format!(" clip-path=\"url(#c{})\"", clip_id(clip)))
    }

    fn line(&mut self, points: &[(f32, f32)], width: f32, dash: Option<[f32; 2]>, colour: Colour) {
        let dash = dash.map_or(String::new(), |[ink, gap]| {
            format!(" stroke-dasharray=\"{} {}\"", number(ink), number(gap))
        });
        let (path, width, colour, clip) = (joined(points), number(width), hex(colour), self.clipped());
        let _ = writeln!(
            self.body,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" \
             stroke-linejoin=\"bevel\"{dash}{clip}/>"
        );
    }

    fn filled(&mut self, path: &str, colour: Colour) {
        let (colour, clip) = (hex(colour), self.clipped());
        let _ = writeln!(self.body, "<path d=\"{path}\" fill=\"{colour}\"{clip}/>");
    }

    fn letters(&mut self, letters: &Letters) {
        let Letters { text, at: (x, y), upwards, size, colour } = letters;
        let (x, y, colour, label) = (number(*x), number(*y), hex(*colour), escaped(text));
        let turn = if *upwards { " rotate(-90)" } else { "" };
        let em = lettering::em(*size);
        let _ = write!(
            self.body,
            "<g role=\"img\" aria-label=\"{label}\" fill=\"{colour}\" \
             transform=\"translate({x} {y}){turn} scale({em} -{em})\">"
        );
        let mut left = 0.0;
        for sign in text.chars() {
            if !lettering::sign(sign).is_empty() {
                self.signs.insert(sign);
                let _ = write!(self.body, "<use href=\"#{}\" x=\"{}\"/>", id(sign), number(left));
            }
            left += lettering::advance(sign);
        }
        self.body.push_str("</g>\n");
    }

    /// As an image within the document: its pixels are not smoothed.
    fn image(&mut self, area: Area, colours: &[Colour]) {
        let Area { left, top, width, height } = area;
        let data = text::data_url("image/png", &png(width as u32, height as u32, colours));
        let [left, top, width, height] = [left.floor(), top.floor(), width.floor(), height.floor()];
        let _ = writeln!(
            self.body,
            "<image x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" \
             style=\"image-rendering:pixelated\" href=\"{data}\"/>"
        );
    }
}

impl Surface for Svg {
    fn take(&mut self, mark: &Mark) {
        match mark {
            Mark::Clip(area) => self.clip(*area),
            Mark::Fill(area, colour) => self.filled(&outline(*area), *colour),
            Mark::Line { points, width, dash, colour } => self.line(points, *width, *dash, *colour),
            Mark::Polygon(points, colour) => self.filled(&(joined(points) + "Z"), *colour),
            Mark::Letters(letters) => self.letters(letters),
            Mark::Image(area, colours) => self.image(*area, colours),
        }
    }
}

fn outline(area: Area) -> String {
    let [left, top, right, bottom] = [area.left, area.top, area.right(), area.bottom()].map(number);
    format!("M{left} {top}H{right}V{bottom}H{left}Z")
}

fn joined(points: &[(f32, f32)]) -> String {
    let mut path = String::new();
    for (index, &(x, y)) in points.iter().enumerate() {
        let word = if index == 0 { 'M' } else { 'L' };
        let _ = write!(path, "{word}{} {}", number(x), number(y));
    }
    path
}

/// A hundredth of a pixel is enough for any printer.
fn number(value: f32) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn hex([r, g, b]: Colour) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Named by what it is, so that two drawings on one page may share it.
fn id(sign: char) -> String {
    format!("hack{:x}", u32::from(sign))
}

fn clip_id(outline: &str) -> String {
    outline.replace([' ', '.'], "-")
}

fn escaped(text: &str) -> String {
    visible_line(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Bytes that no choice of a compression library changes: the coder is that of the PNG crate itself.
fn png(columns: u32, lines: u32, colours: &[Colour]) -> Vec<u8> {
    let mut bytes = vec![];
    let mut encoder = png::Encoder::new(&mut bytes, columns, lines);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(colours.as_flattened())?;
        writer.finish()
    });
    written.expect("a vector takes every byte, and the size is that of the area");
    bytes
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_are_short() {
        let texts = [0.0, -0.001, 1.0, 10.0, 0.126, -3.5].map(number);
        assert_eq!(texts, ["0", "0", "1", "10", "0.13", "-3.5"]);
    }
}
