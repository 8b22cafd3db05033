//! Kinds of files that come out of a scene.
//!
//! # Examples
//! ```
//! use springbed::app::format::Format;
//!
//! assert_eq!(Format::Svg.ending(), "svg");
//! assert!(Format::Pdf.is_picture() && !Format::Csv.is_picture());
//! ```

/// One kind of output.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, clap::ValueEnum)]
pub enum Format {
    /// Tables of records and fields.
    Csv,
    /// Summary.
    Json,
    /// Figure for pages and editors.
    Svg,
    /// Figure as a raster; needs the feature `pictures`.
    Png,
    /// Figure for print; needs the feature `pictures`.
    Pdf,
}

impl Format {
    /// What the names of its files end with, without the dot.
    #[must_use]
    pub fn ending(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Svg => "svg",
            Self::Png => "png",
            Self::Pdf => "pdf",
        }
    }

    /// Whether it holds a figure.
    #[must_use]
    pub fn is_picture(self) -> bool {
        matches!(self, Self::Svg | Self::Png | Self::Pdf)
    }
}
