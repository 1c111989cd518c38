//! What is an ink called, and which colour is it, on a light page and on a dark one?

use super::super::figure::Ink;

/// `cs-stroke-red`, `cs-fill-40` for a shade.
pub fn class(paint: &str, ink: Ink) -> String {
    match ink {
        Ink::Shade(percent) => format!("cs-{paint}-{}", percent.min(100)),
        named => format!("cs-{paint}-{}", named.name()),
    }
}

/// Each ink on a light page and on a dark one. Blue, green and orange rise in lightness by equal steps, so that they differ in grey and for the
/// colour-blind; on the dark page they are in the same order of lightness, and darker than the vectors upon them.
pub fn colours(ink: Ink) -> [String; 2] {
    let known = match ink {
        Ink::Black => ["#111111", "#f0f0f0"],
        Ink::Grey => ["#8a8a8a", "#8f959c"],
        Ink::Light => ["#e8e8e8", "#3a3f46"],
        Ink::Blue => ["#1f4e9c", "#3a7ae0"],
        Ink::Orange => ["#e69f00", "#e3ab32"],
        Ink::Green => ["#2e8b57", "#35a066"],
        Ink::Red => ["#b2182b", "#ff6b6b"],
        Ink::Shade(percent) => return [grey(255, 0, percent), grey(17, 255, percent)],
    };
    known.map(str::to_owned)
}

/// A grey this many per cent of the way from the ground.
fn grey(ground: u8, ink: u8, percent: u8) -> String {
    let percent = f64::from(percent.min(100)) / 100.0;
    let level = f64::from(ground) + (f64::from(ink) - f64::from(ground)) * percent;
    let level = level.round() as u8;
    format!("#{level:02x}{level:02x}{level:02x}")
}
