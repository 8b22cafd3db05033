//! SVG to PNG and PDF.

use super::PictureError;
use super::font::{FAMILY, fonts};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use svg2pdf::{ConversionOptions, PageOptions};

/// Pixels of SVG per inch.
const PIXELS_PER_INCH: f32 = 96.0;
/// Tenths of a millimetre in an inch.
const INCH: u32 = 254;
/// Largest number of dots of a raster, a gigabyte of memory.
const MOST_DOTS: u64 = 1 << 28;

fn library(error: impl ToString) -> PictureError {
    PictureError::Library(error.to_string())
}

/// The document with its text set in the font.
pub(super) fn tree(svg: &str) -> Result<Tree, PictureError> {
    let options =
        Options { dpi: PIXELS_PER_INCH, font_family: FAMILY.to_owned(), fontdb: fonts(), ..Options::default() };
    Tree::from_str(svg, &options).map_err(library)
}

/// A PDF of one page as large as the figure; its text can be searched and copied.
///
/// Several fonts would stand in the file in an order that changes from run to run: bold letters are those of the one
/// font with an outline.
pub fn pdf(svg: &str) -> Result<Vec<u8>, PictureError> {
    let page = PageOptions { dpi: PIXELS_PER_INCH };
    let svg = svg.replace(" font-weight=\"bold\"", BOLD);
    svg2pdf::to_pdf(&tree(&svg)?, ConversionOptions::default(), page).map_err(library)
}

/// An outline for letters 120 to 150 units high.
const BOLD: &str = " stroke=\"#000000\" stroke-width=\"6\"";

/// A PNG of so many dots per inch, which it says itself.
pub fn png(svg: &str, dots_per_inch: u32) -> Result<Vec<u8>, PictureError> {
    let tree = tree(svg)?;
    #[expect(clippy::cast_precision_loss, reason = "a few hundred")]
    let scale = dots_per_inch as f32 / PIXELS_PER_INCH;
    let (width, height) = (dots(tree.size().width() * scale), dots(tree.size().height() * scale));
    let held = u64::from(width) * u64::from(height) <= MOST_DOTS;
    let raster = if held { Pixmap::new(width, height) } else { None };
    let mut raster = raster.ok_or(PictureError::Size { width, height })?;
    raster.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut raster.as_mut());
    encoded(&raster, dots_per_inch)
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the cast saturates")]
fn dots(length: f32) -> u32 {
    length.ceil() as u32
}

/// On a white ground nothing shines through: three bytes a dot are all there is.
fn encoded(raster: &Pixmap, dots_per_inch: u32) -> Result<Vec<u8>, PictureError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, raster.width(), raster.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_adaptive_filter(png::AdaptiveFilterType::Adaptive);
    let per_metre = (dots_per_inch * 10_000).div_ceil(INCH);
    encoder.set_pixel_dims(Some(png::PixelDimensions { xppu: per_metre, yppu: per_metre, unit: png::Unit::Meter }));
    let colours: Vec<u8> = raster.pixels().iter().flat_map(|dot| [dot.red(), dot.green(), dot.blue()]).collect();
    encoder.write_header().and_then(|mut writer| writer.write_image_data(&colours)).map_err(library)?;
    Ok(bytes)
}
