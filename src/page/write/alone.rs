//! How does one picture stand by itself, without a page around it?

use serde::Serialize;

use super::super::block::Picture;
use super::super::svg::svg;
use super::super::tikz::tikz;
use super::latex::Latex;
use super::notation::plain;
use super::options::Options;
use super::templates;
use super::writer::Writer;

/// What one picture is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Alone {
    /// A file of SVG.
    Svg,
    /// A `tikzpicture` with its colours, to be input.
    Tikz,
    /// The same as a document of its own.
    TikzDocument,
}

impl Alone {
    /// The picture as a text.
    pub fn write(self, picture: &Picture, options: &Options) -> String {
        let picture = &options.symbols.in_picture(&options.language.picture(&picture.counted_in(options.units)));
        match self {
            Alone::Svg => {
                let drawing = svg(&picture.figure, &plain(&picture.caption, options));
                let stamp = options.stamp.as_ref().map_or_else(String::new, |stamp| format!("<!-- {stamp} -->\n"));
                drawing + &stamp
            }
            Alone::Tikz => in_tex(picture, options, false),
            Alone::TikzDocument => in_tex(picture, options, true),
        }
    }
}

fn in_tex(picture: &Picture, options: &Options, standalone: bool) -> String {
    #[derive(Serialize)]
    struct Drawing<'a> {
        drawing: String,
        standalone: bool,
        /// Width and height in millimetres.
        paper: [f64; 2],
        stamp: Option<&'a str>,
    }
    let figure = &picture.figure;
    // The drawing within margins of 2 mm, with room for what a line of text takes below its baseline.
    let paper = [figure.width + 5.0, figure.height + 6.0].map(f64::ceil);
    let drawing = Drawing { drawing: tikz(figure), standalone, paper, stamp: options.stamp.as_deref() };
    templates::fill(Latex.templates(), "alone", &drawing)
}
