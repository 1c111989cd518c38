//! How is a text written in XML, as between the tags of an SVG file?

use super::terminal::harmless_lines;

/// The text between two tags or in a quoted attribute.
pub fn xml(text: &str) -> String {
    let text = harmless_lines(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    // Two signs that no XML file may hold.
    text.replace('"', "&quot;").replace(['\u{fffe}', '\u{ffff}'], "\u{fffd}")
}
