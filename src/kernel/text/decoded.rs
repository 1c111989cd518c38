//! In which encoding were the bytes of a text written? What spreadsheets, measuring instruments and old editors write, as one string.

/// Which half of the pairs of bytes of UTF-16 is the low one.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Low {
    First,
    Last,
}

/// What Windows-1252 has at the bytes 0x80 to 0x9F; what it leaves open is the control character of Latin-1.
const WINDOWS_1252: &str = "€\u{81}‚ƒ„…†‡ˆ‰Š‹Œ\u{8d}Ž\u{8f}\u{90}‘’“”•–—˜™š›œ\u{9d}žŸ";

/// The text of these bytes without its byte-order mark. UTF-16 is known by its mark, or by its zero bytes, which no text
/// of bytes has; anything else that is not UTF-8 is read as Windows-1252, in which every byte is a character, and the printable ones are those of Latin-1. Half a pair of UTF-16
/// becomes U+FFFD.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::text::decoded;
/// assert_eq!(decoded(b"\xff\xfe\xb0\0"), "°");
/// assert_eq!(decoded(b"K\xf6nig"), "König");
/// ```
pub fn decoded(bytes: &[u8]) -> String {
    match (utf16(bytes), std::str::from_utf8(bytes)) {
        (Some(low), _) => of_utf16(bytes, low),
        (None, Ok(text)) => text.strip_prefix('\u{feff}').unwrap_or(text).to_owned(),
        (None, Err(_)) => bytes.iter().map(|&byte| of_windows_1252(byte)).collect(),
    }
}

/// Which UTF-16 the bytes are, by their mark, or by zeros in half of the pairs or more, always on the same side.
fn utf16(bytes: &[u8]) -> Option<Low> {
    match bytes {
        [0xff, 0xfe, ..] => return Some(Low::First),
        [0xfe, 0xff, ..] => return Some(Low::Last),
        _ => {}
    }
    let zeros = |side: usize| bytes.chunks_exact(2).filter(|pair| pair[side] == 0).count();
    match (zeros(0), zeros(1)) {
        (0, low_first) if low_first > 0 && 4 * low_first >= bytes.len() => Some(Low::First),
        (high_first, 0) if high_first > 0 && 4 * high_first >= bytes.len() => Some(Low::Last),
        _ => None,
    }
}

fn of_utf16(bytes: &[u8], low: Low) -> String {
    let pairs = bytes.chunks(2).map(|pair| match (pair, low) {
        (&[first, second], Low::Last) => u16::from_be_bytes([first, second]),
        (&[first, second], Low::First) => u16::from_le_bytes([first, second]),
        // A byte without its other half.
        _ => 0xfffd,
    });
    let characters = char::decode_utf16(pairs).map(|read| read.unwrap_or(char::REPLACEMENT_CHARACTER));
    characters
        .enumerate()
        .filter(|&(place, letter)| place > 0 || letter != '\u{feff}')
        .map(|(_, letter)| letter)
        .collect()
}

fn of_windows_1252(byte: u8) -> char {
    match byte {
        0x80..=0x9f => WINDOWS_1252.chars().nth(usize::from(byte) - 0x80).unwrap_or(char::REPLACEMENT_CHARACTER),
        _ => char::from(byte),
    }
}
