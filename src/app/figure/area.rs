//! Filled areas: bodies, and what lies under a curve.

use plotters::style::RGBColor;

use super::canvas::Dot;
use super::curve::Map;

/// An area of one shade; what leaves the frame is cut at it.
#[derive(Clone, Debug, PartialEq)]
pub struct Area {
    /// Its outline in SI units, close enough that a side across the frame does not show.
    pub outline: Vec<(f64, f64)>,
    /// How dark it is.
    pub shade: Shade,
}

/// How dark an area is: apart from its neighbours in grey too.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shade {
    /// Light, cold.
    Light,
    /// Darker, warm.
    Medium,
    /// Dark grey, of what is rigid.
    Dark,
}

/// Colour of a shade.
fn rgb(shade: Shade) -> RGBColor {
    match shade {
        Shade::Light => RGBColor(231, 238, 246),
        Shade::Medium => RGBColor(222, 205, 176),
        Shade::Dark => RGBColor(140, 140, 140),
    }
}

/// An area in px, inside the frame.
pub(super) fn filled(area: &Area, map: &Map) -> (Vec<Dot>, RGBColor) {
    let inside = |dot: Dot| (dot.0.clamp(0.0, map.size.0), dot.1.clamp(0.0, map.size.1));
    let places = area.outline.iter().filter_map(|&point| map.place(point));
    (places.map(inside).collect(), rgb(area.shade))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shades_differ_in_grey() {
        let grey = |shade| {
            let RGBColor(r, g, b) = rgb(shade);
            0.299 * f64::from(r) + 0.587 * f64::from(g) + 0.114 * f64::from(b)
        };
        let [light, medium, dark] = [Shade::Light, Shade::Medium, Shade::Dark].map(grey);
        // A tenth of the full scale is told apart at a glance on paper.
        assert!(255.0 - light > 12.0 && light - medium > 25.5 && medium - dark > 25.5);
    }
}
