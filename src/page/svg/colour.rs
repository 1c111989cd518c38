//! What is an ink called, and which colour is it, on a light page and on a dark one?

use super::super::figure::Ink;

/// `cs-stroke-red`, `cs-fill-40` for a shade.
pub fn class(paint: &str, ink: Ink) -> String {
    let name = match ink {
        Ink::Black => "black",
        Ink::Grey => "grey",
        Ink::Light => "light",
        Ink::Blue => "blue",
        Ink::Orange => "orange",
        Ink::Green => "green",
        Ink::Red => "red",
        Ink::Shade(percent) => return format!("cs-{paint}-{}", percent.min(100)),
    };
    format!("cs-{paint}-{name}")
}

/// Blue, green and orange rise in lightness by equal steps, so that they differ in grey and for the colour-blind.
pub fn on_light(ink: Ink) -> String {
    let known = match ink {
        Ink::Black => "#111111",
        Ink::Grey => "#8a8a8a",
        Ink::Light => "#e8e8e8",
        Ink::Blue => "#1f4e9c",
        Ink::Orange => "#e69f00",
        Ink::Green => "#2e8b57",
        Ink::Red => "#b2182b",
        Ink::Shade(percent) => return grey(255, 0, percent),
    };
    known.to_owned()
}

/// The same on a dark page, in the same order of lightness, and darker than the vectors upon them.
pub fn on_dark(ink: Ink) -> String {
    let known = match ink {
        Ink::Black => "#f0f0f0",
        Ink::Grey => "#8f959c",
        Ink::Light => "#3a3f46",
        Ink::Blue => "#3a7ae0",
        Ink::Orange => "#e3ab32",
        Ink::Green => "#35a066",
        Ink::Red => "#ff6b6b",
        Ink::Shade(percent) => return grey(17, 255, percent),
    };
    known.to_owned()
}

/// A grey this many per cent of the way from the ground.
fn grey(ground: u8, ink: u8, percent: u8) -> String {
    let percent = f64::from(percent.min(100)) / 100.0;
    let level = f64::from(ground) + (f64::from(ink) - f64::from(ground)) * percent;
    let level = level.round() as u8;
    format!("#{level:02x}{level:02x}{level:02x}")
}
