//! How is JSON written in the script of an HTML page? As the same JSON, in which no sign ends the script or begins markup.

use super::json::json;

/// JSON for between `<script type="application/json">` and `</script>`.
///
/// ```standalone_crate
/// # use crankstar_kernel as crankstar;
/// use crankstar::text::json_in_script;
/// assert_eq!(json_in_script("[\"</script><!--\u{2028}\"]"), r#"["\u003c/script\u003e\u003c!--\u2028"]"#);
/// ```
pub fn json_in_script(written: &str) -> String {
    // Such signs stand only inside the strings of JSON.
    json(written).replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026")
}
