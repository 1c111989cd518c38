//! Is a text read as it was meant, in the encodings that editors, spreadsheets and instruments write?

use crankstar::text::{Encoding, decoded};
use proptest::prelude::*;

fn little(text: &str) -> Vec<u8> {
    text.encode_utf16().flat_map(u16::to_le_bytes).collect()
}

fn big(text: &str) -> Vec<u8> {
    text.encode_utf16().flat_map(u16::to_be_bytes).collect()
}

const TABLE: &str = "Winkel [°];Druck [bar]\r\n-360,0;1,05\r\n";

#[test]
fn every_encoding_of_a_table_is_the_same_text() {
    let latin: Vec<u8> = TABLE.chars().map(|letter| u8::try_from(u32::from(letter)).expect("Latin-1")).collect();
    let marked = |mark: &[u8], text: Vec<u8>| [mark, &text].concat();
    for (bytes, encoding) in [
        (TABLE.as_bytes().to_vec(), Encoding::Utf8),
        (marked(b"\xef\xbb\xbf", TABLE.as_bytes().to_vec()), Encoding::Utf8),
        (latin, Encoding::Windows1252),
        (marked(b"\xff\xfe", little(TABLE)), Encoding::Utf16Le),
        (marked(b"\xfe\xff", big(TABLE)), Encoding::Utf16Be),
        (little(TABLE), Encoding::Utf16Le),
        (big(TABLE), Encoding::Utf16Be),
    ] {
        assert_eq!(decoded(&bytes), (TABLE.to_owned(), encoding));
    }
}

#[test]
fn windows_1252_has_its_own_signs_where_latin_1_has_controls() {
    let (text, encoding) = decoded(b"\x80 \x85 \x93crank\x94 \x96360\xb0 \x9f \xff");
    assert_eq!((text.as_str(), encoding), ("€ … “crank” –360° Ÿ ÿ", Encoding::Windows1252));
}

#[test]
fn halves_of_utf_16_are_told_and_lose_nothing_else() {
    assert_eq!(decoded(b"\xff\xfea\0\x00\xd8b\0c"), ("a\u{fffd}b\u{fffd}".to_owned(), Encoding::Utf16Le));
    assert_eq!(decoded(b"").0, "");
    assert_eq!(decoded(b"\xff\xfe").0, "");
}

proptest! {
    #[test]
    fn a_text_survives_utf_8_and_marked_utf_16(text in "\\PC*") {
        let marked = format!("\u{feff}{text}");
        prop_assert_eq!(decoded(marked.as_bytes()), (text.clone(), Encoding::Utf8));
        prop_assert_eq!(decoded(&little(&marked)), (text.clone(), Encoding::Utf16Le));
        prop_assert_eq!(decoded(&big(&marked)), (text, Encoding::Utf16Be));
    }

    #[test]
    fn any_bytes_are_read(bytes in proptest::collection::vec(any::<u8>(), 0..64)) {
        let (text, encoding) = decoded(&bytes);
        if encoding == Encoding::Windows1252 {
            prop_assert_eq!(text.chars().count(), bytes.len());
        }
    }
}
