//! What a figure is drawn for.
//!
//! # Examples
//! ```
//! use springbed::app::medium::Medium;
//!
//! assert_eq!(Medium::Paper.millimetres(), Some(85.0));
//! assert_eq!(Medium::Screen.millimetres(), None);
//! ```

/// What a figure is drawn on.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, clap::ValueEnum)]
pub enum Medium {
    /// A screen: as large as its panels need, under its title.
    #[default]
    Screen,
    /// One column of a journal, 85 mm wide: panels below each other with letters, no title, letters of 6.5 to 8 pt.
    Paper,
    /// Both columns of a journal, 175 mm wide: two panels in a row.
    PaperWide,
}

impl Medium {
    /// Width of the sheet in mm; on a screen it follows the panels.
    #[must_use]
    pub fn millimetres(self) -> Option<f64> {
        match self {
            Self::Screen => None,
            Self::Paper => Some(85.0),
            Self::PaperWide => Some(175.0),
        }
    }

    /// Dots per inch of a raster that suits it.
    #[must_use]
    pub fn dots_per_inch(self) -> u32 {
        match self {
            Self::Screen => 200,
            Self::Paper | Self::PaperWide => 600,
        }
    }
}
