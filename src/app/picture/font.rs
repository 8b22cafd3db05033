//! The font of PNG and PDF.

use resvg::usvg::fontdb::Database;
use std::collections::BTreeSet;
use std::sync::{Arc, OnceLock};

/// Name of the family.
pub const FAMILY: &str = "DejaVu Sans";

/// A base with this font and no other.
pub fn fonts() -> Arc<Database> {
    static FONTS: OnceLock<Arc<Database>> = OnceLock::new();
    let read = || {
        let mut base = Database::new();
        base.load_font_data(dejavu::sans::regular().to_vec());
        base.load_font_data(dejavu::sans::bold().to_vec());
        base.set_sans_serif_family(FAMILY);
        Arc::new(base)
    };
    FONTS.get_or_init(read).clone()
}

/// The characters of `text` that the font does not have, each once.
pub fn missing(text: &str) -> String {
    let Ok(face) = ttf_parser::Face::parse(dejavu::sans::regular(), 0) else { return String::new() };
    let lacks = |c: &char| !c.is_control() && !c.is_whitespace() && face.glyph_index(*c).is_none();
    text.chars().filter(lacks).collect::<BTreeSet<char>>().into_iter().collect()
}
