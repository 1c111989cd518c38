//! What was compared in large, kept as pages of `reports/trust` by the tests that compare it.

use std::path::Path;
use std::{env, fs};

/// Writes a page where `CRANKSTAR_RENEW` is set.
pub fn renew(name: &str, page: &str) {
    println!("{page}");
    if env::var_os("CRANKSTAR_RENEW").is_some() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("reports/trust");
        fs::create_dir_all(&folder).expect("a folder");
        fs::write(folder.join(name), page).expect("the page");
    }
}

/// `1234567` as `1,234,567`.
pub fn grouped(number: usize) -> String {
    let digits = number.to_string();
    let groups: Vec<&str> =
        digits.as_bytes().rchunks(3).rev().map(|group| std::str::from_utf8(group).expect("digits")).collect();
    groups.join(",")
}
