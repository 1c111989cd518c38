//! In which encoding were the bytes of a text written? What spreadsheets, measuring instruments and old editors write, as one string.

/// How a text was encoded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, with or without a byte-order mark.
    Utf8,
    /// UTF-16, the low byte first.
    Utf16Le,
    /// UTF-16, the high byte first.
    Utf16Be,
    /// Windows-1252, and Latin-1, whose printable characters are the same there.
    Windows1252,
}

/// What Windows-1252 has at the bytes 0x80 to 0x9F; what it leaves open is the control character of Latin-1.
const WINDOWS_1252: &str = "€\u{81}‚ƒ„…†‡ˆ‰Š‹Œ\u{8d}Ž\u{8f}\u{90}‘’“”•–—˜™š›œ\u{9d}žŸ";

/// The text of these bytes without its byte-order mark, and how it was encoded. UTF-16 is known by its mark, or by its zero bytes, which no text
/// of bytes has; anything else that is not UTF-8 is read as Windows-1252, in which every byte is a character. Half a pair of UTF-16
/// becomes U+FFFD.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// # use crankstar_kernel as crankstar;
/// use crankstar::text::{Encoding, decoded};
/// assert_eq!(decoded(b"\xff\xfe\xb0\0"), ("°".to_owned(), Encoding::Utf16Le));
/// assert_eq!(decoded(b"K\xf6nig"), ("König".to_owned(), Encoding::Windows1252));
/// ```
pub fn decoded(bytes: &[u8]) -> (String, Encoding) {
    match utf16(bytes) {
        Some(encoding) => (of_utf16(bytes, encoding), encoding),
        None => match std::str::from_utf8(bytes) {
            Ok(text) => (text.strip_prefix('\u{feff}').unwrap_or(text).to_owned(), Encoding::Utf8),
            Err(_) => (bytes.iter().map(|&byte| of_windows_1252(byte)).collect(), Encoding::Windows1252),
        },
    }
}

/// Which UTF-16 the bytes are, by their mark, or by zeros in half of the pairs or more, always on the same side.
fn utf16(bytes: &[u8]) -> Option<Encoding> {
    match bytes {
        [0xff, 0xfe, ..] => return Some(Encoding::Utf16Le),
        [0xfe, 0xff, ..] => return Some(Encoding::Utf16Be),
        _ => {}
    }
    let zeros = |side: usize| bytes.chunks_exact(2).filter(|pair| pair[side] == 0).count();
    match (zeros(0), zeros(1)) {
        (0, low_first) if low_first > 0 && 4 * low_first >= bytes.len() => Some(Encoding::Utf16Le),
        (high_first, 0) if high_first > 0 && 4 * high_first >= bytes.len() => Some(Encoding::Utf16Be),
        _ => None,
    }
}

fn of_utf16(bytes: &[u8], encoding: Encoding) -> String {
    let pairs = bytes.chunks(2).map(|pair| match (pair, encoding) {
        (&[first, second], Encoding::Utf16Be) => u16::from_be_bytes([first, second]),
        (&[first, second], _) => u16::from_le_bytes([first, second]),
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
