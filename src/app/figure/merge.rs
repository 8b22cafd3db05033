//! Strokes and rectangles of one look as one path: the same picture in a third of the bytes.

use std::fmt::Write;

/// A place in units of the drawing library.
type Place = (i64, i64);

/// A line of the document that can be joined to its like.
struct Piece<'b> {
    /// What it looks like, as attributes.
    look: (&'b str, &'static str),
    outline: Outline,
}

enum Outline {
    /// Connected straight lines.
    Stroke(Vec<Place>),
    /// Corner, width and height.
    Rectangle(Place, Place),
}

/// The document with neighbouring elements of one look joined.
pub(super) fn merged(body: &str) -> String {
    let mut out = String::with_capacity(body.len());
    let mut alike: Vec<(Piece<'_>, &str)> = Vec::new();
    for line in body.split_inclusive('\n') {
        let piece = piece(line.trim_end());
        let joins = |next: &Piece<'_>| alike.first().is_none_or(|(first, _)| first.look == next.look);
        if !piece.as_ref().is_some_and(joins) {
            flush(&mut alike, &mut out);
        }
        match piece {
            Some(piece) => alike.push((piece, line)),
            None => out.push_str(line),
        }
    }
    flush(&mut alike, &mut out);
    out
}

/// Writes what has been gathered.
fn flush(alike: &mut Vec<(Piece<'_>, &str)>, out: &mut String) {
    match &alike[..] {
        [] => {}
        [(_, line)] => out.push_str(line),
        [(first, _), ..] => {
            // Writing into a string does not fail.
            let _ok = write!(out, "<path {}{} d=\"", first.look.0, first.look.1);
            let mut at = (0, 0);
            for (piece, _) in alike.iter() {
                at = piece.outline.write(at, out);
            }
            out.push_str("\"/>\n");
        }
    }
    alike.clear();
}

impl Outline {
    /// Writes it from the present point `at` on, in differences; the point it ends at.
    fn write(&self, at: Place, out: &mut String) -> Place {
        match self {
            Self::Rectangle(corner, (width, height)) => {
                let _ok = write!(out, "m{},{}h{width}v{height}h{}z", corner.0 - at.0, corner.1 - at.1, -width);
                *corner
            }
            Self::Stroke(points) => points.iter().enumerate().fold(at, |at, (k, point)| {
                let before = if k == 0 { 'm' } else { ' ' };
                let _ok = write!(out, "{before}{},{}", point.0 - at.0, point.1 - at.1);
                *point
            }),
        }
    }
}

fn piece(line: &str) -> Option<Piece<'_>> {
    if let Some(rest) = line.strip_prefix("<polyline ") {
        let (look, points) = rest.strip_suffix("\"/>")?.split_once(" points=\"")?;
        let points: Option<Vec<Place>> = points.split_whitespace().map(place).collect();
        return Some(Piece { look: (look, ""), outline: Outline::Stroke(points?) });
    }
    let rest = line.strip_prefix("<rect x=\"")?.strip_suffix(" stroke=\"none\"/>")?;
    let (x, rest) = rest.split_once("\" y=\"")?;
    let (y, rest) = rest.split_once("\" width=\"")?;
    let (width, rest) = rest.split_once("\" height=\"")?;
    let (height, look) = rest.split_once("\" ")?;
    let number = |text: &str| text.parse::<i64>().ok();
    let outline = Outline::Rectangle((number(x)?, number(y)?), (number(width)?, number(height)?));
    Some(Piece { look: (look, " stroke=\"none\""), outline })
}

fn place(text: &str) -> Option<Place> {
    let (x, y) = text.split_once(',')?;
    Some((x.parse().ok()?, y.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_of_one_look_become_one_path() {
        let body = "<polyline stroke=\"#000\" stroke-width=\"7\" points=\"1,2 3,4\"/>\n\
                    <polyline stroke=\"#000\" stroke-width=\"7\" points=\"5,5 6,6\"/>\n\
                    <rect x=\"1\" y=\"2\" width=\"3\" height=\"4\" fill=\"#111\" stroke=\"none\"/>\n\
                    <rect x=\"2\" y=\"2\" width=\"3\" height=\"4\" fill=\"#111\" stroke=\"none\"/>\n";
        let path = "<path stroke=\"#000\" stroke-width=\"7\" d=\"m1,2 2,2m2,1 1,1\"/>\n\
                    <path fill=\"#111\" stroke=\"none\" d=\"m1,2h3v4h-3zm1,0h3v4h-3z\"/>\n";
        assert_eq!(merged(body), path);
    }

    #[test]
    fn what_differs_or_stands_alone_stays() {
        let body = "<polyline stroke=\"#000\" stroke-width=\"7\" points=\"1,2 3,4\"/>\n\
                    <polyline stroke=\"#111\" stroke-width=\"7\" points=\"5,5 6,6\"/>\n\
                    <text x=\"1\">\n<rect>\n</text>\n</svg>";
        assert_eq!(merged(body), body);
    }
}
