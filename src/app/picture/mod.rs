//! Figures as the bytes of SVG, PNG and PDF files.
//!
//! PNG and PDF are drawn with DejaVu Sans, which comes with the feature `pictures`: the same figure gives the same
//! bytes on every machine, whatever fonts it has.
//!
//! # Examples
//! ```
//! use springbed::app::figure::{Axis, Figure, Panel, Series};
//! use springbed::app::picture::Drawing;
//! use springbed::app::format::Format;
//!
//! let panel = Panel::new(Axis::linear("x", "m"), Axis::linear("y", "m"));
//! let figure = Figure::new("a line").with(panel.with(Series::new("", [(0.0, 0.0), (1.0, 1.0)])));
//! assert_eq!(Drawing::default().bytes(&figure, Format::Svg)?, Some(figure.svg().into_bytes()));
//! // A table is no picture.
//! assert_eq!(Drawing::default().bytes(&figure, Format::Csv)?, None);
//! # Ok::<(), springbed::app::picture::PictureError>(())
//! ```

#[cfg(feature = "pictures")]
mod font;
#[cfg(feature = "pictures")]
mod printed;

#[cfg(feature = "plot")]
use super::figure::Figure;
use super::format::Format;
use super::medium::Medium;

/// How figures are drawn.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Drawing {
    /// The sheet.
    pub medium: Medium,
    /// Dots per inch of PNG; `None` for what suits the sheet, 200 on a screen and 600 on paper. 20 to 2400: fewer
    /// cannot be read, more than that fills the memory.
    pub dots: Option<u32>,
}

/// Why there is no picture.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PictureError {
    /// The program was built without them.
    #[error(
        "{} needs the feature `pictures`, which this program was built without: expected csv, json or svg, or a \
         program from `cargo install --path . --features pictures`",
        .0.ending()
    )]
    Feature(Format),
    /// A raster of a size that cannot be held.
    #[error("a picture of {width} by {height} dots is too large: expected fewer dots per inch")]
    Size {
        /// Dots across.
        width: u32,
        /// Dots down.
        height: u32,
    },
    /// The libraries that draw have failed.
    #[error("the picture could not be drawn: {0}")]
    Library(String),
}

impl Drawing {
    /// Dots per inch of a raster.
    #[must_use]
    pub fn dots_per_inch(self) -> u32 {
        self.dots.unwrap_or(self.medium.dots_per_inch())
    }

    /// The figure as a file of a format; none if that is no picture.
    ///
    /// # Errors
    /// The feature is missing, or the raster is too large.
    #[cfg(feature = "plot")]
    pub fn bytes(self, figure: &Figure, format: Format) -> Result<Option<Vec<u8>>, PictureError> {
        if format.is_picture() {
            of_svg(figure.drawn(self.medium), format, self.dots_per_inch()).map(Some)
        } else {
            Ok(None)
        }
    }
}

/// A figure that is SVG already as a file of a format; a raster of so many dots per inch.
///
/// # Errors
/// The feature is missing, the format is no picture, or the raster is too large.
pub fn of_svg(svg: String, format: Format, dots_per_inch: u32) -> Result<Vec<u8>, PictureError> {
    available(&[format])?;
    match format {
        Format::Svg => Ok(svg.into_bytes()),
        #[cfg(feature = "pictures")]
        Format::Png => printed::png(&svg, dots_per_inch),
        #[cfg(feature = "pictures")]
        Format::Pdf => printed::pdf(&svg),
        #[cfg(not(feature = "pictures"))]
        Format::Png | Format::Pdf => Err(PictureError::Feature(format)),
        Format::Csv | Format::Json => {
            let _ = dots_per_inch;
            Err(PictureError::Library(format!("{} is no picture", format.ending())))
        }
    }
}

/// Whether this program can write all `formats`.
///
/// # Errors
/// The first that needs a feature it was built without.
pub fn available(formats: &[Format]) -> Result<(), PictureError> {
    let lacking = formats.iter().find(|format| matches!(format, Format::Png | Format::Pdf));
    match lacking.filter(|_| !cfg!(feature = "pictures")) {
        Some(format) => Err(PictureError::Feature(*format)),
        None => Ok(()),
    }
}

/// What to beware of if `text` is to stand in PNG or PDF: characters the font does not have.
#[must_use]
pub fn unwritable(text: &str, formats: &[Format]) -> Option<String> {
    #[cfg(feature = "pictures")]
    if formats.iter().any(|format| matches!(format, Format::Png | Format::Pdf)) {
        let missing = font::missing(text);
        return (!missing.is_empty()).then(|| {
            format!("PNG and PDF show boxes for {missing}, which their font, DejaVu Sans, does not have; SVG has them")
        });
    }
    let _ = (text, formats);
    None
}
