use proptest::prelude::*;

use super::*;

mod samples;

/// Attribute values `name="…"` of a document.
fn values<'a>(svg: &'a str, name: &'a str) -> impl Iterator<Item = &'a str> {
    let start = format!(" {name}=\"");
    let parts: Vec<&str> = svg.split(start.as_str()).skip(1).collect();
    parts.into_iter().filter_map(|part| part.split('"').next())
}

/// Numbers of all attributes that carry coordinates.
fn coordinates(svg: &str) -> Vec<(f64, f64)> {
    let pair = |text: &str| {
        let (x, y) = text.split_once(',')?;
        Some((x.parse().ok()?, y.parse().ok()?))
    };
    let points = values(svg, "points").flat_map(|p| p.split_whitespace().filter_map(pair));
    points.chain(values(svg, "d").flat_map(path)).collect()
}

/// Places of a path written in differences; of rectangles their corners.
fn path(d: &str) -> Vec<(f64, f64)> {
    let mut at = (0.0, 0.0);
    let mut places = Vec::new();
    for piece in d.split('m').skip(1) {
        for step in piece.split(['h', 'z']).next().unwrap().split_whitespace() {
            let (x, y) = step.split_once(',').unwrap();
            let by: (f64, f64) = (x.parse().unwrap(), y.parse().unwrap());
            at = (at.0 + by.0, at.1 + by.1);
            places.push(at);
        }
    }
    places
}

/// All samples on all sheets.
fn on_all_sheets() -> impl Iterator<Item = (&'static str, Figure, Medium)> {
    let styles = [Medium::Screen, Medium::Paper, Medium::PaperWide];
    samples::all().into_iter().flat_map(move |(name, figure)| styles.map(|style| (name, figure.clone(), style)))
}

#[test]
#[ignore = "writes pictures to look at into the directory for temporary files"]
fn write_samples() -> std::io::Result<()> {
    for (name, figure) in samples::all() {
        let path = std::env::temp_dir().join(format!("springbed-{name}.svg"));
        std::fs::write(path, figure.svg())?;
    }
    Ok(())
}

#[test]
#[ignore = "a clock, to be read with nothing else running"]
fn write_times() {
    for (name, figure) in samples::all() {
        let mut bytes = 0;
        let mut times = (0..20).map(|_| {
            let start = std::time::Instant::now();
            bytes = figure.svg().len();
            1e3 * start.elapsed().as_secs_f64()
        });
        let first = times.next().unwrap_or(f64::NAN);
        let best = times.fold(first, f64::min);
        println!("{name}: first {first:.2} ms, best {best:.2} ms, {bytes} bytes");
    }
}

#[test]
fn a_figure_is_the_same_bytes_twice_and_small() {
    for (name, figure, style) in on_all_sheets() {
        let svg = figure.drawn(style);
        assert_eq!(svg, figure.drawn(style), "{name}");
        assert!(svg.len() < 60_000, "{name}: {} bytes", svg.len());
    }
}

#[test]
fn curves_stay_on_the_sheet() {
    for (name, figure, style) in on_all_sheets() {
        let svg = figure.drawn(style);
        let sheet: Vec<f64> =
            values(&svg, "viewBox").flat_map(|v| v.split(' ').filter_map(|n| n.parse().ok())).collect();
        let dots = coordinates(&svg);
        assert!(dots.len() > 50, "{name}");
        let on = |d: &(f64, f64)| (0.0..=sheet[2]).contains(&d.0) && (0.0..=sheet[3]).contains(&d.1);
        assert!(dots.iter().all(on), "{name}");
    }
}

/// Text without the escapes of XML.
fn plain(text: &str) -> String {
    let escapes = [("&lt;", "<"), ("&gt;", ">"), ("&quot;", "\""), ("&apos;", "'"), ("&amp;", "&")];
    let unescape = |text: String, (from, to): (&str, &str)| text.replace(from, to);
    escapes.into_iter().fold(text.to_owned(), unescape)
}

/// Texts of a document with the box each takes by the estimate of its width: left, top, right, bottom.
fn boxes(svg: &str) -> Vec<(String, [f64; 4])> {
    let number = |tag: &str, name| values(tag, name).next().and_then(|v| v.parse::<f64>().ok());
    let parts = svg.split("<text").skip(1).filter_map(|part| part.split_once('>'));
    parts
        .filter_map(|(tag, rest)| {
            let tag = format!("{tag} ");
            let content = plain(rest.split("</text>").next()?.trim());
            let (x, y, size) = (number(&tag, "x")?, number(&tag, "y")?, number(&tag, "font-size")?);
            let bold = if tag.contains("bold") { text::BOLD } else { 1.0 };
            let long = bold * text::width(&content, size);
            let before = match values(&tag, "text-anchor").next()? {
                "start" => 0.0,
                "middle" => 0.5 * long,
                _ => long,
            };
            let high = 0.5 * size;
            let area = if tag.contains("rotate") {
                [x - high, y + before - long, x + high, y + before]
            } else {
                [x - before, y - high, x - before + long, y + high]
            };
            Some((content, area))
        })
        .collect()
}

/// The first text that sticks out of the sheet, if any.
fn cut_off(svg: &str) -> Option<String> {
    let sheet: Vec<f64> = values(svg, "viewBox").flat_map(|v| v.split(' ').filter_map(|n| n.parse().ok())).collect();
    let cut = |b: &[f64; 4]| b[0] < 0.0 || b[1] < 0.0 || b[2] > sheet[2] || b[3] > sheet[3];
    let first = boxes(svg).into_iter().find(|(_, area)| cut(area));
    first.map(|(content, area)| format!("{content:?} at {area:?} on {sheet:?}"))
}

/// Two texts that cover each other, if any.
fn overlapping(svg: &str) -> Option<(String, String)> {
    let all = boxes(svg);
    let apart = |a: &[f64; 4], b: &[f64; 4]| a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1];
    let pairs = (0..all.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let mut hits = pairs.filter(|(i, j)| !apart(&all[*i].1, &all[*j].1));
    hits.next().map(|(i, j)| (all[i].0.clone(), all[j].0.clone()))
}

#[test]
fn no_text_is_cut_off_or_covered_by_another() {
    for (name, figure, style) in on_all_sheets() {
        let svg = figure.drawn(style);
        assert!(boxes(&svg).len() > 10, "{name}");
        assert_eq!(cut_off(&svg), None, "{name} {style:?}");
        assert_eq!(overlapping(&svg), None, "{name} {style:?}");
    }
}

/// Journals want letters of at least 5 to 6 pt and lines of at least 0.25 pt.
#[test]
fn on_paper_letters_and_lines_are_large_enough_and_the_sheet_as_wide_as_a_column() {
    const POINTS_PER_MM: f64 = 72.0 / 25.4;
    for (name, figure, style) in on_all_sheets() {
        let Some(wide) = style.millimetres() else { continue };
        let svg = figure.drawn(style);
        assert!(svg.contains(&format!(" width=\"{wide}mm\" ")), "{name}");
        let across: f64 = values(&svg, "viewBox").next().and_then(|v| v.split(' ').nth(2)?.parse().ok()).unwrap();
        let points = |units: &str| units.parse::<f64>().unwrap() * wide * POINTS_PER_MM / across;
        // A caption that does not fit is shrunk by up to 0.7.
        let letters: Vec<f64> = values(&svg, "font-size").map(points).collect();
        assert!(letters.iter().all(|size| (5.4..8.0).contains(size)), "{name} {style:?}: {letters:?}");
        // What is filled has an outline of one unit in its own colour.
        let lines: Vec<f64> = values(&svg, "stroke-width").filter(|units| *units != "1").map(points).collect();
        assert!(lines.iter().all(|width| (0.3..1.6).contains(width)), "{name} {style:?}: {lines:?}");
        assert_eq!(figure.panels.len() > 1, svg.contains("\n(a)"), "{name}");
    }
}

#[test]
fn what_a_user_types_cannot_break_the_document() {
    let axis = Axis::linear("a < b & \"c\"", "N<m>");
    let panel = Panel::new(axis.clone(), axis).titled("<svg>\u{1}");
    let svg = Figure::new("</title><script>").with(panel).svg();
    assert!(!svg.contains("<script>") && !svg.contains('\u{1}'));
    assert_eq!(svg.matches("<svg").count(), 1);
    assert_eq!(svg.matches("</svg>").count(), 1);
}

#[test]
fn a_gap_interrupts_the_line() {
    let axis = Axis::linear("", "1");
    let points = vec![(0.0, 0.0), (1.0, 1.0), (f64::NAN, 0.0), (2.0, 0.0), (3.0, 1.0)];
    let panel = Panel::new(axis.clone(), axis).with(Series::new("", points));
    let svg = Figure::new("").with(panel).svg();
    let (_, curve) = svg.split_once("<path stroke=\"#0072B2\"").unwrap();
    assert_eq!(curve.lines().next().unwrap().matches('m').count(), 2);
}

#[test]
fn a_label_that_returns_does_not_hide_the_one_between() {
    let axis = Axis::linear("", "1");
    let line = || vec![(0.0, 0.0), (1.0, 1.0)];
    let labels = ["retract", "approach", "retract"];
    let panel = Panel::new(axis.clone(), axis);
    let panel = labels.iter().fold(panel, |panel, label| panel.with(Series::new(*label, line())));
    let svg = Figure::new("").with(panel).svg();
    let (curves, _legend) = svg.split_once("retract").unwrap_or_default();
    // both curves of the first look are one path; one sample of it stands in the legend, after all curves
    let blue: Vec<usize> = curves.match_indices("#0072B2").map(|m| m.0).collect();
    assert_eq!(blue.len(), 2);
    assert!(curves.find("#E69F00") > blue.first().copied() && curves.find("#E69F00") < blue.last().copied());
}

#[test]
fn a_figure_without_panels_is_a_title() {
    assert!(Figure::new("nothing yet").svg().contains("nothing yet\n</text>"));
}

/// Any double, the awkward ones often.
fn awkward() -> impl Strategy<Value = f64> {
    let special =
        [0.0, -0.0, 1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, 5e-324, 1e300, 1e-300];
    prop_oneof![
        prop::sample::select(special.to_vec()),
        (-310..309i32, -9..10i32).prop_map(|(k, m)| f64::from(m) * 10f64.powi(k)),
        any::<f64>(),
        (0..1000i32).prop_map(|i| 1.0 + f64::from(i) * 1e-16),
    ]
}

fn axes() -> impl Strategy<Value = Axis> {
    let units = prop::sample::select(vec!["N", "m", "m^2", "1", "", "s", "kg", "J/m^2", "µ"]);
    let limit = || prop::option::weighted(0.3, awkward());
    (any::<bool>(), units, limit(), limit()).prop_map(|(log, unit, lo, hi)| {
        let mut axis = if log { Axis::log("x", unit) } else { Axis::linear("x", unit) };
        axis.limits = (lo, hi);
        axis
    })
}

fn guides() -> impl Strategy<Value = Guide> {
    (0..4, awkward(), awkward(), ".{0,20}").prop_map(|(kind, a, b, label)| match kind {
        0 => Guide::horizontal(a, label),
        1 => Guide::vertical(a, label),
        2 => Guide::slope(a, label),
        _ => Guide::Jump { from: (a, b), to: (b, a) },
    })
}

fn panels() -> impl Strategy<Value = Panel> {
    let points = prop::collection::vec((awkward(), awkward()), 0..30);
    let series =
        (".{0,30}", points).prop_map(|(label, points)| Series::new(label, points).marks(Marks::Numbered).arrow());
    let series = prop::collection::vec(series, 0..4);
    let guides = prop::collection::vec(guides(), 0..3);
    (axes(), axes(), series, guides, ".{0,60}").prop_map(|(x, y, series, guides, title)| Panel {
        title: title.clone(),
        series,
        guides,
        notes: vec![title],
        ..Panel::new(x, y)
    })
}

proptest! {
    #![proptest_config(crate::laws::cases(256))]

    #[test]
    fn whatever_the_values_there_is_a_figure(panels in prop::collection::vec(panels(), 0..5), title in ".{0,200}") {
        let figure = Figure { title, panels };
        let svg = figure.svg();
        prop_assert!(svg.ends_with("</svg>\n"));
        let attributes = svg.split(['<', '>']).skip(1).step_by(2);
        prop_assert!(attributes.into_iter().all(|a| !a.contains("NaN") && !a.contains("inf")));
        prop_assert_eq!(cut_off(&svg), None);
        for style in [Medium::Paper, Medium::PaperWide] {
            prop_assert_eq!(cut_off(&figure.drawn(style)), None);
        }
    }
}
