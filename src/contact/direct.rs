//! The direct path: a contact whose state depends on the present depth or force alone.
//!
//! No spring is allocated. The edge is a root of the equilibrium curve on g(x) itself and the force
//! an integral up to it, so the state is exact to rounding for any shape with a closed g(x).
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::direct::QuasiStatic;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // R = E* = w = 1 under a growing pull: off at −(3/2)πwR (JKR), and never back.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let mut ball = QuasiStatic::new(EdgeLine::new(ground, 1.0));
//! ball.press(1.0)?;
//! let jumps = ball.press(-5.0)?;
//! assert!((jumps[0].before.force + 1.5 * std::f64::consts::PI).abs() < 1e-12);
//! assert!(!ball.present().joined && ball.dissipated() > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::contact::adhesion::dmt::DmtBall;
pub use crate::contact::adhesion::elastic::ElasticAttraction;
use crate::contact::adhesion::equilibrium::{Balance, BranchError, Branches, Control, Equilibrium, Leap, Search};
use crate::contact::adhesion::line::{EdgeLine, Energy};
use crate::contact::adhesion::sprung::Sprung;
use crate::contact::foundation::Foundation;
use crate::contact::loaded::Loaded;
use crate::shape::{Profile, Rim};

/// A sudden change of the contact, at a given depth or force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// What was prescribed.
    pub control: Control,
    /// Its value: a depth, or where the far end of a spring is [m], or a force [N].
    pub at: f64,
    /// State just before; the contact radius is zero where the bodies were apart.
    pub before: Balance,
    /// State just after; `None` where the bodies have parted.
    pub after: Option<Balance>,
    /// Energy lost in the jump [J].
    pub dissipated: f64,
    /// Stored energy before and after the jump [J].
    pub stored: (Energy, Energy),
}

/// Present state of a quasi-static contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Present {
    /// Whether the bodies touch or attract each other.
    pub joined: bool,
    /// Equilibrium; of a parted contact only the indentation has a meaning, and none if it parted
    /// under a prescribed force (NaN then).
    pub balance: Balance,
}

/// A quasi-static contact of two elastic bodies, and the energy it has lost in jumps.
#[derive(Debug, Clone)]
pub struct QuasiStatic {
    attraction: ElasticAttraction,
    by_depth: Option<Branches>,
    by_force: Option<Branches>,
    s: f64,
    present: Present,
    dissipated: f64,
    /// Compliance [m/N] of a spring by whose far end the contact is led; zero without one.
    compliance: f64,
    /// What has been prescribed as a depth [m], to the last digit; `None` under a force.
    led: Option<f64>,
}

impl QuasiStatic {
    /// Bodies that just touch, d = 0, before any attraction has acted; `attraction` is what holds the edge.
    #[must_use]
    pub fn new(attraction: impl Into<ElasticAttraction>) -> Self {
        let attraction = attraction.into();
        let s = attraction.start();
        let balance = Balance { contact_radius: 0.0, reach: 0.0, indentation: 0.0, force: 0.0 };
        let present = Present { joined: false, balance };
        Self { attraction, by_depth: None, by_force: None, s, present, dissipated: 0.0, compliance: 0.0, led: None }
    }

    /// The same bodies before any attraction has acted.
    #[must_use]
    pub fn apart(&self) -> Self {
        Self { compliance: self.compliance, ..Self::new(self.attraction.clone()) }
    }

    /// The same bodies, led by the far end of a spring of the stiffness `stiffness` [N/m]: what is prescribed as a depth is
    /// d + F/k from now on.
    #[must_use]
    pub fn on_a_spring(&self, stiffness: f64) -> Self {
        Self { compliance: stiffness.recip(), ..self.apart() }
    }

    /// What is prescribed as a depth [m]: d, or d + F/k of a contact on a spring; `None` where bodies have parted under a force.
    #[must_use]
    pub fn position(&self) -> Option<f64> {
        self.led.or(Some(self.far_end(&self.present.balance))).filter(|position| !position.is_nan())
    }

    /// d + F/k of a state [m].
    #[must_use]
    pub fn far_end(&self, balance: &Balance) -> f64 {
        if self.compliance > 0.0 { balance.indentation + self.compliance * balance.force } else { balance.indentation }
    }

    fn sprung(&self) -> Sprung<'_, ElasticAttraction> {
        Sprung { curve: &self.attraction, compliance: self.compliance }
    }

    /// The same state with nothing lost on the way to it.
    #[must_use]
    pub fn without_losses(self) -> Self {
        Self { dissipated: 0.0, ..self }
    }

    /// What holds the edge.
    #[must_use]
    pub fn attraction(&self) -> &ElasticAttraction {
        &self.attraction
    }

    /// Energy lost in jumps so far [J].
    #[must_use]
    pub fn dissipated(&self) -> f64 {
        self.dissipated
    }

    /// Present state.
    #[must_use]
    pub fn present(&self) -> Present {
        self.present
    }

    /// Moves to the indentation `to` [m]; returns the jumps on the way, in order.
    ///
    /// # Errors
    /// The contact would leave the profile or cannot be followed.
    pub fn indent(&mut self, to: f64) -> Result<Vec<Jump>, BranchError> {
        self.follow(Control::Indentation, to)
    }

    /// Moves to the normal force `to` [N]; returns the jumps on the way, in order.
    ///
    /// # Errors
    /// The contact would leave the profile or cannot be followed.
    pub fn press(&mut self, to: f64) -> Result<Vec<Jump>, BranchError> {
        self.follow(Control::Force, to)
    }

    fn follow(&mut self, control: Control, to: f64) -> Result<Vec<Jump>, BranchError> {
        let led = (control == Control::Indentation).then_some(to);
        if let ElasticAttraction::Outside(ball) = &self.attraction {
            let ball = ball.clone();
            self.led = led;
            return Ok(self.follow_hertz(&ball, control, to));
        }
        let curve = Sprung { curve: &self.attraction, compliance: self.compliance };
        let slot = if control == Control::Indentation { &mut self.by_depth } else { &mut self.by_force };
        let mut branches = match slot.take() {
            Some(branches) => branches,
            None => Branches::new(&curve, control)?,
        };
        let (s, leaps) = branches.follow(&curve, self.s, to)?;
        *slot = Some(branches);
        let jumps = leaps.iter().map(|leap| self.jump(control, leap)).collect::<Result<Vec<_>, _>>()?;
        self.present = self.state_at(control, s, to)?;
        (self.s, self.led) = (s, led);
        for jump in &jumps {
            self.dissipated += jump.dissipated;
        }
        Ok(jumps)
    }

    /// Moves a contact that is Hertz's under its load and an attraction; it joins and parts at d = 0.
    fn follow_hertz(&mut self, ball: &DmtBall, control: Control, to: f64) -> Vec<Jump> {
        let before = self.present.joined;
        let state = ball.brought(before, (control, to), self.compliance);
        let indentation = if control == Control::Indentation { to } else { f64::NAN };
        let apart = Balance { contact_radius: 0.0, reach: 0.0, indentation, force: 0.0 };
        let touching = Balance { indentation: 0.0, ..apart };
        self.s = state.map_or(0.0, |state| state.contact_radius);
        self.present = Present { joined: state.is_some(), balance: state.unwrap_or(apart) };
        let parting = ball.at(0.0);
        let (at, from, landed) = match (before, state.is_some(), control) {
            (true, true, _) | (false, false, _) => return Vec::new(),
            (true, false, Control::Indentation) => (self.far_end(&parting), parting, None),
            (true, false, Control::Force) => (parting.force, parting, None),
            // At d = 0 and no force, from where bodies do no work as they come together.
            (false, true, _) => (0.0, touching, ball.brought(false, (control, 0.0), self.compliance)),
        };
        let energy =
            |balance: &Balance| if balance.force < 0.0 { self.energy_of(Some(balance)) } else { Energy::default() };
        let spring = if control == Control::Force { self.spring_energy(&from) } else { 0.0 };
        let landed_energy = landed.as_ref().map_or_else(Energy::default, |landed| self.energy_of(Some(landed)));
        let stored = (energy(&from), landed_energy);
        let dissipated = stored.0.stored() - spring - stored.1.stored();
        self.dissipated += dissipated;
        vec![Jump { control, at, before: from, after: landed, dissipated, stored }]
    }

    /// States on the stable path from the reach `from` to the reach `to` [m] at which the force turns,
    /// in the order of the path: the pull-off force under prescribed depth is one of them.
    ///
    /// # Errors
    /// The contact cannot be followed.
    pub fn force_turns(&mut self, from: f64, to: f64) -> Result<Vec<Balance>, BranchError> {
        let attraction = &self.attraction;
        if attraction.search() == Search::Nowhere {
            return Ok(Vec::new());
        }
        let mut branches = match self.by_force.take() {
            Some(branches) => branches,
            None => Branches::new(attraction, Control::Force)?,
        };
        let mut turns = branches.turns_between(attraction, from.min(to), from.max(to))?;
        self.by_force = Some(branches);
        if to < from {
            turns.reverse();
        }
        Ok(turns.into_iter().map(|s| attraction.at(s)).collect())
    }

    /// Stored energy of a state in equilibrium.
    #[must_use]
    pub fn energy_at(&self, balance: &Balance) -> Energy {
        self.energy_of(Some(balance))
    }

    fn state_at(&self, control: Control, s: f64, to: f64) -> Result<Present, BranchError> {
        let attraction = self.sprung();
        let at_end = s >= attraction.end();
        if at_end && attraction.value(control, s) < to {
            return self.beyond_end(control, s, to);
        }
        let start = attraction.start();
        let joined = s > start || start > 0.0 && attraction.value(control, start) < to;
        let mut balance = if joined { self.prescribed(control, s, to) } else { self.attraction.at(s) };
        if !joined {
            let indentation = match control {
                Control::Indentation => to,
                Control::Force if to < 0.0 => f64::NAN,
                Control::Force => balance.indentation,
            };
            balance = Balance { contact_radius: 0.0, reach: 0.0, indentation, force: 0.0 };
        }
        Ok(Present { joined, balance })
    }

    /// The state with the parameter `s` and the prescribed value `to`.
    ///
    /// At the edge of a flat and near the equator of a sphere g rises without bound, so the radius
    /// alone says d and F to few digits; both follow from each other at a given radius to rounding.
    /// Without adhesion ∂F/∂a = 2E*(d − g) vanishes at the edge.
    fn prescribed(&self, control: Control, s: f64, to: f64) -> Balance {
        let ends = !matches!(self.profile().rim(), Rim::None);
        let steep = |line: &EdgeLine| self.profile().kink().is_some() || ends && line.elongation(s) <= 0.0;
        match (&self.attraction, control) {
            (ElasticAttraction::Line(line), Control::Indentation) if steep(line) => self.held_by_wall(line, s, to),
            (ElasticAttraction::Line(line), Control::Force) if steep(line) => {
                Balance { force: to, ..line.under_wall(s, line.indentation_under_wall(s, to)) }
            }
            (smooth, Control::Indentation) if self.compliance > 0.0 => smooth.at(s),
            (smooth, Control::Indentation) => Balance { indentation: to, ..smooth.at(s) },
            (smooth, Control::Force) => Balance { force: to, ..smooth.at(s) },
        }
    }

    /// A contact held by a wall; an error at the end of a profile that is not defined further.
    fn beyond_end(&self, control: Control, s: f64, to: f64) -> Result<Present, BranchError> {
        let (ElasticAttraction::Line(line), Rim::Wall(_)) = (&self.attraction, self.profile().rim()) else {
            return Err(BranchError::BeyondEnd { end: self.profile().contact_radius(s) });
        };
        let balance = match control {
            Control::Indentation => self.held_by_wall(line, s, to),
            Control::Force => line.under_wall(s, line.indentation_under_wall(s, to)),
        };
        let force = if control == Control::Force { to } else { balance.force };
        Ok(Present { joined: true, balance: Balance { force, ..balance } })
    }

    /// The contact of the radius `a` held by a wall with `to` [m] prescribed: d, or d + F/k with F linear in d.
    fn held_by_wall(&self, line: &EdgeLine, a: f64, to: f64) -> Balance {
        if self.compliance <= 0.0 {
            return line.under_wall(a, to);
        }
        let (free, given) = (line.indentation_under_wall(a, 0.0), self.compliance * line.ground().stiffness(a));
        line.under_wall(a, free + (to - free) / (1.0 + given))
    }

    fn jump(&self, control: Control, leap: &Leap) -> Result<Jump, BranchError> {
        let before = self.end_of_leap(control, leap.from, leap.at)?;
        let after = self.end_of_leap(control, leap.to, leap.at)?;
        let stored = (self.energy_of(before.as_ref()), self.energy_of(after.as_ref()));
        // A prescribed force keeps what the spring holds.
        let kept = |balance: Option<&Balance>| match control {
            Control::Indentation => 0.0,
            Control::Force => balance.map_or(0.0, |balance| self.spring_energy(balance)),
        };
        let held = kept(before.as_ref()) - kept(after.as_ref());
        let released = stored.0.stored() - stored.1.stored() - held;
        let apart = Balance { contact_radius: 0.0, reach: 0.0, indentation: 0.0, force: 0.0 };
        let work = match (control, &before, &after) {
            (Control::Indentation, ..) => 0.0,
            (Control::Force, Some(from), None) => leap.at * (self.parting_depth(leap.from)? - from.indentation),
            (Control::Force, from, Some(to)) => leap.at * (to.indentation - from.map_or(0.0, |from| from.indentation)),
            (Control::Force, None, None) => 0.0,
        };
        let indentation = if control == Control::Indentation { leap.at } else { 0.0 };
        let before = before.unwrap_or(Balance { indentation, ..apart });
        Ok(Jump { control, at: leap.at, before, after, dissipated: released + work, stored })
    }

    fn end_of_leap(&self, control: Control, s: f64, at: f64) -> Result<Option<Balance>, BranchError> {
        let state = self.state_at(control, s, at)?;
        Ok(state.joined.then_some(state.balance))
    }

    /// Depth at which the contact with parameter `s` parts if the depth is prescribed, all its jumps passed.
    fn parting_depth(&self, s: f64) -> Result<f64, BranchError> {
        let balance = self.attraction.at(s);
        Self { s, present: Present { joined: true, balance }, ..self.clone() }.last_depth()
    }

    /// Depth [m] at which a slow retraction parts the bodies from the present state.
    ///
    /// # Errors
    /// The contact cannot be followed.
    pub fn last_depth(&self) -> Result<f64, BranchError> {
        let mut probe = self.clone();
        let jumps = probe.indent(-f64::MAX)?;
        Ok(jumps.last().map_or(self.first_touch(), |jump| jump.at))
    }

    /// Depth [m] at which the bodies, coming from afar, first act on each other.
    #[must_use]
    pub fn first_touch(&self) -> f64 {
        self.sprung().value(Control::Indentation, self.attraction.start())
    }

    /// Stored energy of the present state.
    #[must_use]
    pub fn energy(&self) -> Energy {
        self.energy_of(self.present.joined.then_some(&self.present.balance))
    }

    fn energy_of(&self, balance: Option<&Balance>) -> Energy {
        let Some(balance) = balance else { return Energy::default() };
        let energy = match &self.attraction {
            ElasticAttraction::Line(line) => line.energy(balance.contact_radius, balance.indentation),
            ElasticAttraction::Outside(ball) => ball.energy(balance),
            ElasticAttraction::Range(disc) => disc.energy(balance),
        };
        Energy { elastic: energy.elastic + self.spring_energy(balance), ..energy }
    }

    /// F²/2k [J] of the spring the contact is led by.
    #[must_use]
    pub fn spring_energy(&self, balance: &Balance) -> f64 {
        if self.compliance > 0.0 { 0.5 * self.compliance * balance.force * balance.force } else { 0.0 }
    }

    /// Contact stiffness k(a) [N/m]: dF/dd at constant contact radius, 2E*a on a half-space (Popov & Heß
    /// 2015, eq. 3.25).
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        self.stiffness_at(self.present.balance.contact_radius)
    }

    /// The same of a contact of radius `a` [m].
    #[must_use]
    pub fn stiffness_at(&self, a: f64) -> f64 {
        self.ground().stiffness(a)
    }

    /// Whether the edge carries no load: no adhesion and no wall.
    fn is_smooth(&self) -> bool {
        self.attraction.search() == Search::Nowhere && self.s < self.attraction.end()
    }

    /// The profile.
    #[must_use]
    pub fn profile(&self) -> &dyn Profile {
        self.ground().profile()
    }
}

impl QuasiStatic {
    /// What the indenter is pressed into.
    #[must_use]
    pub fn ground(&self) -> &Foundation {
        match &self.attraction {
            ElasticAttraction::Line(line) => line.ground(),
            ElasticAttraction::Outside(ball) => ball.ground(),
            ElasticAttraction::Range(disc) => disc.ground(),
        }
    }

    /// The contact as it is now, under its load.
    #[must_use]
    pub fn loaded(&self) -> Loaded {
        let balance = self.present.balance;
        match &self.attraction {
            ElasticAttraction::Range(disc) if self.present.joined => Loaded::attracted(disc.clone(), balance),
            ElasticAttraction::Range(_) | ElasticAttraction::Outside(_) | ElasticAttraction::Line(_) => {
                Loaded::elastic(self.ground().clone(), balance.contact_radius, self.edge_load())
                    .at_depth(balance.indentation)
            }
        }
    }

    /// q(a) = E*(d − g(a)) [N/m], the singular load at the edge.
    fn edge_load(&self) -> f64 {
        let Balance { contact_radius, indentation, force, .. } = self.present.balance;
        match &self.attraction {
            // A closed wave gives too little for the depth to tell its load.
            ElasticAttraction::Line(line) if self.profile().is_plane() && contact_radius >= line.end() => {
                line.ground().modulus() * line.ground().edge_under(contact_radius, force)
            }
            ElasticAttraction::Line(line) if self.present.joined && !self.is_smooth() => {
                line.ground().modulus() * (indentation - line.ground().depth(contact_radius))
            }
            ElasticAttraction::Line(_) | ElasticAttraction::Outside(_) | ElasticAttraction::Range(_) => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::range::RangeDisc;
    use crate::input::quantity::{Length, Positive};
    use crate::numerics::root;
    use crate::shape::{Cone, Paraboloid, TruncatedCone};
    use std::f64::consts::PI;
    use std::sync::Arc;

    fn paraboloid(radius: f64) -> Paraboloid {
        Paraboloid { radius: Length::new(radius).unwrap() }
    }

    fn jkr<P: Profile + Clone + 'static>(profile: &P, modulus: f64, work: f64) -> QuasiStatic {
        QuasiStatic::new(EdgeLine::new(Foundation::new(Arc::new(profile.clone()), modulus), work))
    }

    fn near(value: f64, expected: f64, bound: f64) {
        assert!((value / expected - 1.0).abs() <= bound, "{value} is not {expected}");
    }

    #[test]
    fn steel_ball() {
        let ball = paraboloid(0.01);
        let modulus = 210e9 / (1.0 - 0.09);
        let mut contact = jkr(&ball, modulus, 0.0);
        contact.indent(1e-6).unwrap();
        let state = contact.present().balance;
        near(state.force, 30.76923076923077, 4e-15);
        near(state.contact_radius, 1e-4, 4e-15);
        near(contact.loaded().pressure(0.0), 1.469122551617495e9, 4e-15);
    }

    #[test]
    fn jkr_turning_points() {
        let ball = paraboloid(1.0);
        let mut contact = jkr(&ball, 1.0, 1.0);
        let jumps = contact.indent(0.0).unwrap();
        assert_eq!(jumps.len(), 1);
        near(contact.present().balance.contact_radius, 1.845270148644028, 1e-15);
        near(contact.present().balance.force, -4.0 / 3.0 * PI, 1e-14);
        let out = contact.indent(-3.0).unwrap();
        assert!(out[0].after.is_none());
        near(out[0].before.contact_radius, 0.732295943780762, 1e-13);
        near(out[0].before.force, -5.0 / 6.0 * PI, 1e-14);
        near(out[0].before.indentation, -1.608_772_047_833_27, 1e-14);
        let mut pulled = jkr(&ball, 1.0, 1.0);
        pulled.press(0.0).unwrap();
        near(pulled.present().balance.indentation, 1.948888544860377, 1e-14);
        near(pulled.present().balance.contact_radius, 2.417987931024707, 1e-14);
        let out = pulled.press(-5.0).unwrap();
        near(out[0].before.force, -1.5 * PI, 1e-14);
        near(out[0].before.indentation, -0.773416931570034, 1e-13);
        assert!(!pulled.present().joined && pulled.present().balance.indentation.is_nan());
    }

    #[test]
    fn jkr_cone_turning_points() {
        let (t, w, e) = (0.3, 2.0, 5.0);
        let cone = Cone { slope: Positive::new(t).unwrap() };
        let mut contact = jkr(&cone, e, w);
        contact.indent(0.0).unwrap();
        let out = contact.indent(-1e3).unwrap();
        near(out[0].before.indentation, -w / (e * t), 1e-14);
        near(out[0].before.force, -6.0 * w * w / (PI * e * t.powi(3)), 1e-13);
    }

    fn truncated(flat_radius: f64, slope: f64) -> TruncatedCone {
        TruncatedCone { flat_radius: Length::new(flat_radius).unwrap(), slope: Positive::new(slope).unwrap() }
    }

    /// A cone whose flat is far smaller than its contact parts like a cone, but once at the rim of the
    /// flat it is held like a punch.
    #[test]
    fn jkr_truncated_cone_turns_like_the_cone_and_like_the_punch() {
        let (t, w, e) = (0.3, 2.0, 5.0);
        let small = truncated(1e-9, t);
        let mut contact = jkr(&small, e, w);
        contact.indent(0.0).unwrap();
        let out = contact.indent(-1e3).unwrap();
        // The flat changes g by tb.
        near(out[0].before.indentation, -w / (e * t), 1e-8);
        near(out[0].before.force, -6.0 * w * w / (PI * e * t.powi(3)), 1e-8);
        let large = truncated(1e6, t);
        let mut contact = jkr(&large, e, w);
        contact.indent(0.0).unwrap();
        let out = contact.indent(-1e4).unwrap();
        assert_eq!(out.len(), 1);
        near(out[0].before.contact_radius, 1e6, 1e-14);
        near(out[0].before.force, -(8.0 * PI * e * w * 1e18).sqrt(), 1e-12);
    }

    /// Between the two a contact leaves the flank first and the flat later: two jumps.
    #[test]
    fn jkr_truncated_cone_parts_in_two_jumps() {
        let (t, w, e) = (0.3, 2.0, 5.0);
        // The cone jumps at d = −w/Et; the flat holds to −√(2πbw/E), deeper if b > w/(2πEt²).
        let shape = truncated(2.0 * w / (2.0 * PI * e * t * t), t);
        let mut contact = jkr(&shape, e, w);
        contact.indent(1.0).unwrap();
        let b = shape.flat_radius();
        let out = contact.indent(-1e3).unwrap();
        let last = out[out.len() - 1].before;
        near(last.contact_radius, b, 1e-12);
        near(last.indentation, -(2.0 * PI * b * w / e).sqrt(), 1e-7);
        near(last.force, -(8.0 * PI * e * w * b.powi(3)).sqrt(), 1e-7);
        assert_eq!(out.len(), 2);
    }

    /// A flat hardly pressed is a punch, F = 2E*bd, however little the flank adds to the radius.
    #[test]
    fn flat_tip_under_a_small_depth() {
        let shape = truncated(1e-3, 0.2);
        for k in 0..60 {
            let d = 1e-4 * 10f64.powf(-0.2 * f64::from(k));
            let mut contact = jkr(&shape, 5.0, 0.0);
            contact.indent(d).unwrap();
            let state = contact.present().balance;
            // d/(tb) = φ sec φ, F = E*tb²(φ sec²φ + tan φ).
            let rise = d / (0.2 * 1e-3);
            let phi = root::brent(|phi| phi / phi.cos() - rise, 0.0, 1.0).unwrap();
            near(state.force, 5.0 * 0.2 * 1e-6 * (phi / phi.cos().powi(2) + phi.tan()), 1e-14);
            let mut pressed = jkr(&shape, 5.0, 0.0);
            pressed.press(state.force).unwrap();
            near(pressed.present().balance.indentation, d, 1e-14);
        }
    }

    /// Work to detach from d = 0: 7.092196 (w⁵R⁴/E*²)^{1/3}.
    #[test]
    fn work_to_detach() {
        let ball = paraboloid(1.0);
        let mut contact = jkr(&ball, 1.0, 1.0);
        contact.indent(0.0).unwrap();
        let start = contact.energy().stored();
        let out = contact.indent(-3.0).unwrap();
        near(out[0].dissipated - start, 7.092196, 1e-7);
    }

    #[test]
    fn maugis_pull_off() {
        // With K = 4E*/3 = 1, R = 1 and πw = 1 the length unit is one and σ₀ = λ/2.
        let ball = paraboloid(1.0);
        let (modulus, work) = (0.75, 1.0 / PI);
        // Least force of the closed equations, by golden section with 30 digits.
        for (lambda, force) in [
            (0.01, -1.998_287_784_321_51),
            (0.1, -1.950_594_892_123_43),
            (0.5, -1.718_245_274_886_17),
            (1.0, -1.600_734_911_254_09),
            (5.0, -1.506_349_967_716_04),
        ] {
            let ground = Foundation::new(Arc::new(ball.clone()), modulus);
            let mut contact = QuasiStatic::new(RangeDisc::new(ground, work, 0.5 * lambda).unwrap());
            contact.press(0.0).unwrap();
            let out = contact.press(-3.0).unwrap();
            near(out.last().unwrap().before.force, force, 1e-13);
        }
    }
}
