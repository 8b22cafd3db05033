//! What holds the edge of a contact between elastic bodies: one curve of equilibrium of whichever kind.

use super::dmt::DmtBall;
use super::equilibrium::{Balance, Control, Equilibrium, Search};
use super::line::EdgeLine;
use super::range::RangeDisc;

/// What holds the edge of the contact.
#[derive(Debug, Clone)]
pub enum ElasticAttraction {
    /// Nothing, or an attraction of vanishing range.
    Line(EdgeLine),
    /// An attraction outside the contact that bends nothing.
    Outside(DmtBall),
    /// An attraction of finite range.
    Range(RangeDisc),
}

impl From<EdgeLine> for ElasticAttraction {
    fn from(line: EdgeLine) -> Self {
        Self::Line(line)
    }
}

impl From<DmtBall> for ElasticAttraction {
    fn from(ball: DmtBall) -> Self {
        Self::Outside(ball)
    }
}

impl From<RangeDisc> for ElasticAttraction {
    fn from(disc: RangeDisc) -> Self {
        Self::Range(disc)
    }
}

impl ElasticAttraction {
    pub(in crate::contact) fn at(&self, s: f64) -> Balance {
        match self {
            Self::Line(line) => line.at(s),
            Self::Outside(ball) => ball.at(s),
            Self::Range(disc) => disc.at(s),
        }
    }
}

impl Equilibrium for ElasticAttraction {
    fn value(&self, control: Control, s: f64) -> f64 {
        match self {
            Self::Line(line) => line.value(control, s),
            Self::Outside(ball) => ball.value(control, s),
            Self::Range(disc) => disc.value(control, s),
        }
    }

    fn slope(&self, control: Control, s: f64) -> f64 {
        match self {
            Self::Line(line) => line.slope(control, s),
            Self::Outside(ball) => ball.slope(control, s),
            Self::Range(disc) => disc.slope(control, s),
        }
    }

    fn known(&self, control: Control, target: f64) -> Option<f64> {
        match self {
            Self::Line(line) => line.known(control, target),
            Self::Outside(ball) => ball.known(control, target),
            Self::Range(disc) => disc.known(control, target),
        }
    }

    fn start(&self) -> f64 {
        match self {
            Self::Line(line) => line.start(),
            Self::Outside(ball) => ball.start(),
            Self::Range(disc) => disc.start(),
        }
    }

    fn end(&self) -> f64 {
        match self {
            Self::Line(line) => line.end(),
            Self::Outside(ball) => ball.end(),
            Self::Range(disc) => disc.end(),
        }
    }

    fn scale(&self) -> f64 {
        match self {
            Self::Line(line) => line.scale(),
            Self::Outside(ball) => ball.scale(),
            Self::Range(disc) => disc.scale(),
        }
    }

    fn search(&self) -> Search {
        match self {
            Self::Line(line) => line.search(),
            Self::Outside(ball) => ball.search(),
            Self::Range(disc) => disc.search(),
        }
    }
}
