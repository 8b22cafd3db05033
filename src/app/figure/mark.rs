//! Marks at points.

use plotters::style::{RGBColor, WHITE};

use super::Mark;
use super::canvas::{Canvas, Dot, Pen};

/// Half the size of a mark in px.
const HALF: f64 = 3.6;

/// Radius of a point in px.
const POINT: f64 = 2.2;

/// A mark on the canvas; open ones are white inside.
pub(super) fn mark(canvas: &mut Canvas, at: Dot, shape: Mark, colour: RGBColor) {
    let near = |corners: &[Dot]| -> Vec<Dot> { corners.iter().map(|c| offset(at, *c)).collect() };
    match shape {
        Mark::Point => canvas.disc(at, POINT, colour),
        Mark::Disc => canvas.disc(at, HALF, colour),
        Mark::Ring => {
            canvas.disc(at, HALF + 0.4, colour);
            canvas.disc(at, HALF - 1.2, WHITE);
        }
        Mark::Block => canvas.polygon(&near(&SQUARE), colour),
        Mark::Triangle => canvas.polygon(&near(&TRIANGLE), colour),
        Mark::Square => open(canvas, &near(&SQUARE), colour),
        Mark::Diamond => open(canvas, &near(&DIAMOND), colour),
        Mark::Cross => strokes(canvas, &[near(&CROSS[..2]), near(&CROSS[2..])], colour),
        Mark::Plus => strokes(canvas, &[near(&PLUS[..2]), near(&PLUS[2..])], colour),
    }
}

const SQUARE: [Dot; 4] = [(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)];
const DIAMOND: [Dot; 4] = [(0.0, -1.25), (1.25, 0.0), (0.0, 1.25), (-1.25, 0.0)];
const TRIANGLE: [Dot; 3] = [(0.0, -1.25), (1.15, 0.85), (-1.15, 0.85)];
const CROSS: [Dot; 4] = [(-0.95, -0.95), (0.95, 0.95), (-0.95, 0.95), (0.95, -0.95)];
const PLUS: [Dot; 4] = [(-1.25, 0.0), (1.25, 0.0), (0.0, -1.25), (0.0, 1.25)];

fn offset(at: Dot, by: Dot) -> Dot {
    (at.0 + HALF * by.0, at.1 + HALF * by.1)
}

fn open(canvas: &mut Canvas, corners: &[Dot], colour: RGBColor) {
    canvas.polygon(corners, WHITE);
    let closed: Vec<Dot> = corners.iter().chain(&corners[..2]).copied().collect();
    canvas.path(&closed, Pen { colour, width: 1.4 });
}

fn strokes(canvas: &mut Canvas, lines: &[Vec<Dot>], colour: RGBColor) {
    for line in lines {
        canvas.path(line, Pen { colour, width: 1.8 });
    }
}
