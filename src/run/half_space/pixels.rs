//! Pixels under way: what they remember, what pulls them, and what presses them next.

use super::attraction::Attraction;
use super::coupled::Coupled;
use super::dent::Dent;
use super::lone::LoneSprings;
use super::memory::{Memory, Step};
use super::pressed::{Pressed, area};
use super::rounds::Rounds;
use super::state::Pressing;
use crate::contact::adhesion::line::Energy;
use crate::halfspace::{Boundary, HalfSpaceError, Prescribed, PressedMap, Solution, Start, SurfaceResponse, solve_on};
use crate::scene::plan::HalfSpacePlan;
use ndarray::{Array2, Zip};

/// Pixels on their way through a history.
pub(super) struct Pixels<'p> {
    pressing: Pressing<'p>,
    memory: Option<Memory>,
    attraction: Option<Attraction>,
    /// Its pixels, if their neighbours do nothing to them.
    lone: Option<LoneSprings>,
    /// Energy that they have lost in jumps \[J per m² of a pixel\].
    snapped: f64,
    /// What pressures do to a surface that yields.
    yielding: Option<SurfaceResponse>,
    pull: Option<Array2<f64>>,
    /// What has been dented, of bodies that yield.
    dent: Option<Dent>,
    /// Shear that is found together with the pressures.
    coupled: Option<Coupled<'p>>,
    /// Contact pressures of the last state.
    last: Option<Array2<f64>>,
    /// Those of the one before, of bodies that remember, and the time \[s\] between the two.
    earlier: Option<(Array2<f64>, f64)>,
}

/// What a state leaves to the next.
#[derive(Clone)]
pub(super) struct Past {
    memory: Option<Memory>,
    pull: Option<Array2<f64>>,
    snapped: f64,
    dent: Option<Dent>,
    last: Option<Array2<f64>>,
    earlier: Option<(Array2<f64>, f64)>,
}

/// Part of the range of an attraction by which it moves bodies that do not move, nearly.
const UNMOVED: f64 = 1e-4;

impl<'p> Pixels<'p> {
    pub(super) fn new(plan: &HalfSpacePlan, pressing: Pressing<'p>) -> Self {
        let (pixels, side) = (pressing.heights.values.dim(), area(pressing.heights.pixel).sqrt());
        let attraction = Attraction::of(plan.attraction, side, pressing.modulus);
        let rigid = attraction.map_or(0.0, |attraction| attraction.stress * side / (UNMOVED * attraction.range()));
        let memory = plan.relaxation.clone().map(|relaxation| Memory::new(relaxation, pixels, rigid));
        let stiffness = pressing.response.alone().map(|give| pressing.modulus / give);
        let lone = attraction.zip(stiffness).map(|(attraction, stiffness)| LoneSprings::new(attraction, stiffness));
        let dent = plan.hardness.map(|hardness| Dent { hardness, depth: Array2::zeros(pixels), dissipated: 0.0 });
        let yielding = plan.hardness.map(|hardness| pressing.response.clone().yielding_under(hardness));
        Self {
            pressing,
            memory,
            dent,
            pull: attraction.map(|_| Array2::zeros(pixels)),
            attraction,
            lone,
            snapped: 0.0,
            yielding,
            coupled: Coupled::of(plan, &pressing),
            last: None,
            earlier: None,
        }
    }

    pub(super) fn attraction(&self) -> Option<Attraction> {
        self.attraction
    }

    /// Whether all that a jump under a prescribed depth loses is known.
    pub(super) fn knows_losses(&self) -> bool {
        self.lone.is_some()
    }

    /// What the last state leaves to the next.
    pub(super) fn past(&self) -> Past {
        let Self { memory, pull, snapped, dent, last, earlier, .. } = self;
        Past {
            memory: memory.clone(),
            pull: pull.clone(),
            snapped: *snapped,
            dent: dent.clone(),
            last: last.clone(),
            earlier: earlier.clone(),
        }
    }

    /// Whether the end of a step is the same on whatever steps it is come to, as long as they lead one way: a contact that
    /// approaches or is withdrawn stays on its branch as far as that goes. On a surface that repeats what pulls in one place
    /// lifts the others, whose mean stays where it is, and two that would join at once may do so one after the other.
    pub(super) fn keeps_its_branch(&self) -> bool {
        self.memory.is_none() && self.dent.is_none() && self.pressing.boundary == Boundary::Free
    }

    /// The motion turns.
    pub(super) fn turn(&mut self) {
        if let Some(memory) = &mut self.memory {
            memory.turn();
        }
    }

    /// Goes back to a state.
    pub(super) fn go_back(&mut self, past: Past) {
        let Past { memory, pull, snapped, dent, last, earlier } = past;
        (self.memory, self.pull, self.snapped, self.dent) = (memory, pull, snapped, dent);
        (self.last, self.earlier) = (last, earlier);
    }

    /// Bytes of what is kept from state to state.
    pub(super) fn bytes(&self) -> usize {
        let remembered = self.memory.as_ref().map_or(0, Memory::fields);
        let kept =
            usize::from(self.pull.is_some()) + usize::from(self.dent.is_some()) + usize::from(self.last.is_some());
        let coupled = if self.coupled.is_some() { Coupled::FIELDS } else { 0 };
        8 * self.pressing.heights.values.len() * (remembered + kept + coupled)
    }

    /// Whether a state depends on those before it.
    pub(super) fn has_past(&self) -> bool {
        self.acts_beside() || self.coupled.is_some()
    }

    /// Whether something acts beside the contact itself.
    fn acts_beside(&self) -> bool {
        self.memory.is_some() || self.attraction.is_some() || self.dent.is_some()
    }

    /// Leads the pixels on for `over` \[s\] and to a slide \[m\]; `None` where the force pulls more than they do.
    pub(super) fn advance(
        &mut self,
        prescribed: Prescribed,
        (over, slide): (f64, f64),
    ) -> Result<Option<Pressed>, HalfSpaceError> {
        if let Some(coupled) = &mut self.coupled {
            return coupled.advance(&self.pressing, prescribed, slide).map(Some);
        }
        if !self.acts_beside() {
            return self.elastic(prescribed).map(Some);
        }
        let step = self.memory.as_ref().map(|memory| memory.step(over));
        let before = self.last.take();
        self.last = self.expected(before.as_ref(), over);
        let Some(contact) = self.settled(prescribed, step.as_ref())? else {
            self.part(step.as_ref());
            return Ok(None);
        };
        self.last = Some(contact.pressure.clone());
        self.earlier = before.filter(|_| self.memory.is_some()).map(|before| (before, over));
        if let Some(dent) = &mut self.dent {
            dent.deepen(&contact, &self.pressing.heights.values);
        }
        let gap = self.gap(&contact);
        let pull = self.pull.clone();
        let faint = self.attraction.map_or(0.0, Attraction::faint);
        let mut pressed =
            Pressed { contact, pull, faint, gap, stored: Energy::default(), dissipated: 0.0, dragged: None };
        let pressure = pressed.pressure();
        if let (Some(memory), Some(step)) = (&mut self.memory, &step) {
            memory.take(step, &pressure, pressed.contact.displacement.clone());
            if self.attraction.is_some() {
                memory.turn();
            }
        }
        self.tell(&mut pressed, &pressure);
        Ok(Some(pressed))
    }

    /// Pressures to start from: those of the last state, or where they go if they go on as they did.
    fn expected(&self, last: Option<&Array2<f64>>, over: f64) -> Option<Array2<f64>> {
        let last = last?;
        let Some((earlier, took)) = self.earlier.as_ref().filter(|(_, took)| *took > 0.0) else {
            return Some(last.clone());
        };
        let on = (over / took).min(1.0);
        Some(Zip::from(last).and(earlier).map_collect(|&last, earlier| (last + on * (last - earlier)).max(0.0)))
    }

    /// Without a past: what is prescribed decides.
    fn elastic(&mut self, prescribed: Prescribed) -> Result<Pressed, HalfSpaceError> {
        let start = self.last.as_ref().map_or(Start::Coarser, |last| Start::Pressure(last.view()));
        let contact = self.pressing.solve(prescribed, start)?;
        self.last = Some(contact.pressure.clone());
        let gap = self.pressing.gap(&contact);
        Ok(Pressed::elastic(contact, gap))
    }

    /// What presses the pixels next, with what pulls them; `None` where the force pulls more than they do.
    fn settled(&mut self, prescribed: Prescribed, step: Option<&Step>) -> Result<Option<Solution>, HalfSpaceError> {
        let Pressing { heights, boundary, settings, modulus, .. } = self.pressing;
        let response = self.yielding.as_ref().unwrap_or(self.pressing.response);
        let free = step.map(Step::free);
        let mut lifted = heights.values.clone();
        for more in free.iter().chain(self.dent.as_ref().map(|dent| &dent.depth)) {
            lifted += more;
        }
        let modulus = step.map_or(modulus, |step| step.modulus);
        let map = PressedMap { heights: lifted.view(), pixel: heights.pixel, modulus, boundary, control: prescribed };
        let mut contact = match (self.attraction, &self.pull) {
            (Some(attraction), Some(pull)) => {
                let rounds = Rounds { attraction, lone: self.lone, response, map, settings };
                let Some(settled) = rounds.settled(self.last.as_ref(), pull.clone())? else { return Ok(None) };
                self.snapped += self.lone.map_or(0.0, |lone| lone.lost(pull, &settled.pull));
                self.pull = Some(settled.pull);
                settled.contact
            }
            _ => {
                let start = self.last.as_ref().map_or(Start::Coarser, |last| Start::Pressure(last.view()));
                solve_on(response, &map, start, &settings)?
            }
        };
        if let Some(free) = free {
            contact.displacement += &free;
        }
        Ok(Some(contact))
    }

    /// Gap \[m\] over what has been dented.
    fn gap(&self, contact: &Solution) -> Array2<f64> {
        let gap = self.pressing.gap(contact);
        let Some(dent) = &self.dent else { return gap };
        let touching = contact.pressure.mapv(|pressure| pressure > 0.0);
        let over = |(height, depth): (f64, f64), displacement: f64| {
            (displacement + (height + depth - contact.indentation)).max(0.0)
        };
        let heights = &self.pressing.heights.values;
        Array2::from_shape_fn(gap.dim(), |at| {
            if touching[at] { 0.0 } else { over((heights[at], dent.depth[at]), contact.displacement[at]) }
        })
    }

    /// Deepest dent \[m\] so far, of bodies that yield.
    pub(super) fn deepest(&self) -> Option<f64> {
        Some(self.dent.as_ref()?.depth.iter().copied().fold(0.0, f64::max))
    }

    /// Far apart nothing presses or pulls, and what remembers comes back.
    fn part(&mut self, step: Option<&Step>) {
        (self.last, self.earlier) = (None, None);
        if let Some(pull) = &mut self.pull {
            pull.fill(0.0);
        }
        if let (Some(memory), Some(step)) = (&mut self.memory, step) {
            memory.take(step, &Array2::zeros(step.kept.dim()), step.free());
        }
    }

    fn tell(&self, pressed: &mut Pressed, pressure: &Array2<f64>) {
        let (area, displacement) = (area(self.pressing.heights.pixel), &pressed.contact.displacement);
        let elastic = match &self.memory {
            Some(memory) => area * memory.stored(displacement),
            None => self.pressing.elastic(pressure, displacement),
        };
        let surface = match (self.lone, self.attraction) {
            (Some(lone), _) => lone.surface(&pressed.gap),
            (None, Some(attraction)) => attraction.energy(&pressed.gap, self.pressing.boundary),
            (None, None) => 0.0,
        };
        pressed.stored = Energy { elastic, surface: area * surface };
        pressed.dissipated = self.dissipated();
    }

    /// Energy [J] that bodies which nothing holds together still store.
    pub(super) fn stored_apart(&self) -> f64 {
        area(self.pressing.heights.pixel) * self.memory.as_ref().map_or(0.0, Memory::stored_apart)
    }

    /// The same with what they have lost.
    pub(super) fn accounted_apart(&self) -> f64 {
        self.stored_apart() + self.dissipated()
    }

    /// Energy lost in the bodies so far [J].
    pub(super) fn dissipated(&self) -> f64 {
        let remembered = self.memory.as_ref().map_or(0.0, Memory::dissipated);
        let dented = self.dent.as_ref().map_or(0.0, |dent| dent.dissipated);
        area(self.pressing.heights.pixel) * (remembered + dented + self.snapped)
    }
}
