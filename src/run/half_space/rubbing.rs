//! Friction on pixels: stick and slip by the memory of turning points, or gross sliding on the pressures found.
//!
//! Where what tangential tractions do along the surface is in one ratio G*/E* to what pressures do across it, the tractions
//! of partial slip are differences of pressures, q = μ Σ σ Δp (Ciavarella 1998; Jäger 1998; for rough bodies Paggi, Pohrt &
//! Popov 2014): every depth at which the memory has a turning point is one more solution without friction. Left out is
//! what tractions do across their own direction, and how they and pressures change each other.

use super::load::{PixelLoad, is_rigid};
use super::pressed::{Dragged, Pressed, area};
use super::state::{Pressing, State};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::state::Tangential;
use crate::friction::contact::GrossSlip;
use crate::friction::sliding::SlidingLaw;
use crate::friction::turning::Piece;
use crate::friction::{FrictionError, Grip, Pose, TangentialMemory, chords};
use crate::halfspace::{HalfSpaceError, Prescribed, Solution, Start, lengthwise};
use crate::material::Pair;
use crate::scene::law::PixelFriction;
use crate::scene::plan::{HalfSpacePlan, PixelledIndenter};
use crate::scene::stage::Path;
use ndarray::Array2;
use std::f64::consts::PI;

/// Finest bend of a depth that grows with a force while the contact is slid, as part of the depth.
const FINEST: f64 = 1e-4;

/// A way from record to record.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    /// What is prescribed, at the beginning and the end.
    pub(super) control: Control,
    pub(super) values: [f64; 2],
    /// Tangential displacements at the beginning and the end \[m\].
    pub(super) slide: [f64; 2],
    /// Duration \[s\].
    pub(super) over: f64,
}

impl Stroke {
    /// Of bodies that just touch.
    pub(super) const NONE: Self = Self { control: Control::Indentation, values: [0.0; 2], slide: [0.0; 2], over: 0.0 };
}

/// What rubs.
pub(super) enum Rubbing<'p> {
    /// Stick and slip.
    Partial(Box<TangentialMemory<PixelLoad<'p>>>),
    /// Stick and slip that have been found with the contact of the last state.
    Coupled(Option<Box<(Solution, Dragged)>>),
    /// Gross sliding, on the contact of the last state.
    Gross { slip: Box<GrossSlip>, pressed: Option<Box<Solution>> },
}

/// The shear of a state, of which maps can be made.
#[derive(Debug, Clone)]
pub(super) enum Sheared {
    /// Pieces of the memory, and the depth \[m\] at which they are.
    Pieces {
        /// Depth \[m\].
        depth: f64,
        /// What each depth has added.
        pieces: Vec<Piece>,
    },
    /// What has been found already.
    Found(Box<Rubbed>),
}

/// A contact under shear.
#[derive(Debug, Clone)]
pub(super) struct Rubbed {
    /// What presses.
    pub(super) contact: Solution,
    /// Shear stress \[Pa\].
    pub(super) shear: Array2<f64>,
}

impl<'p> Rubbing<'p> {
    /// The friction of a plan, if it has one.
    pub(super) fn of(plan: &'p HalfSpacePlan, pressing: Pressing<'p>) -> Option<Self> {
        Some(match plan.friction.as_ref()? {
            PixelFriction::Partial { coefficient } => {
                let tip = plan.profile().is_some() && plan.surface().is_none();
                let load = PixelLoad::new(pressing, tip.then_some(&plan.scene.shape));
                let grip = Grip { tangential_modulus: pressing.tangential, ..plan.grip(*coefficient) };
                Self::Partial(Box::new(TangentialMemory::over(load, grip)))
            }
            PixelFriction::Coupled { .. } => Self::Coupled(None),
            PixelFriction::Gross(interface) => {
                Self::Gross { slip: Box::new(GrossSlip::new(interface.clone())), pressed: None }
            }
        })
    }

    /// Whether a state is wanted with its stiffness and energy.
    pub(super) fn is_partial(&self) -> bool {
        matches!(self, Self::Partial(_))
    }

    /// Takes over the contact of a state that gross sliding acts on, and shear that has been found with it.
    pub(super) fn press(&mut self, state: Option<&Pressed>) {
        match self {
            Self::Partial(_) => {}
            Self::Coupled(dragged) => {
                *dragged = state.and_then(|state| {
                    let shear = state.dragged.as_ref()?;
                    Some(Box::new((state.contact.clone(), shear.as_ref().clone())))
                });
            }
            Self::Gross { pressed, .. } => *pressed = state.map(|state| Box::new(state.contact.clone())),
        }
    }

    /// Follows a step that has led to a state.
    pub(super) fn follow(
        &mut self,
        stroke: Stroke,
        state: &State,
        pressing: &Pressing<'_>,
    ) -> Result<Tangential, String> {
        match self {
            Self::Partial(memory) => {
                if is_rigid(state, pressing) {
                    // What has never been slid carries nothing, and its way through the depths leaves no trace.
                    if stroke.slide.iter().all(|slide| slide.abs() <= 0.0)
                        && memory.state().tangential_force.abs() <= 0.0
                    {
                        let stick_radius = round(state.pixels.area);
                        return Ok(Tangential { stick_radius, stiffness: f64::INFINITY, ..told(memory) });
                    }
                    return Err("friction in full contact of a surface that repeats cannot be computed, for its pixels stick at any slide or slip all at once: expected less force".to_owned());
                }
                memory.curve().learn(state);
                let refused = |error: FrictionError, memory: &TangentialMemory<PixelLoad<'_>>| {
                    memory.curve().refusal().map_or_else(|| error.to_string(), |refusal| refusal.to_string())
                };
                for to in poses(memory, stroke, state).map_err(|error| error.to_string())? {
                    memory.advance(to).map_err(|error| refused(error, memory))?;
                }
                Ok(told(memory))
            }
            Self::Coupled(dragged) => {
                let at_rest = Tangential { stored: Some(0.0), dissipated: Some(0.0), ..Tangential::default() };
                let tangential = dragged.as_ref().map_or(at_rest, |dragged| dragged.1.tangential);
                Ok(Tangential { slide: stroke.slide[1], ..tangential })
            }
            Self::Gross { slip, pressed } => {
                let limit = |law: &dyn SlidingLaw| pressed.as_ref().map_or(0.0, |contact| friction(contact, law));
                let speed = (stroke.slide[1] - stroke.slide[0]).abs() / stroke.over;
                let radius = state.normal.contact_radius.unwrap_or_else(|| round(state.pixels.area));
                slip.follow((stroke.slide, speed), radius, limit).map_err(|error| error.to_string())?;
                Ok(slip.state())
            }
        }
    }

    /// The present shear, if it is known.
    pub(super) fn sheared(&self) -> Option<Sheared> {
        match self {
            Self::Partial(memory) => {
                Some(Sheared::Pieces { depth: memory.position().indentation, pieces: memory.pieces().collect() })
            }
            Self::Coupled(dragged) => {
                let (contact, Dragged { shear, .. }) = dragged.as_ref()?.as_ref().clone();
                Some(Sheared::Found(Box::new(Rubbed { contact, shear })))
            }
            Self::Gross { slip, pressed } => {
                let contact = pressed.as_ref()?;
                let stress = |&pressure: &f64| if pressure > 0.0 { slip.stress(Some(pressure)) } else { Some(0.0) };
                let shear: Option<Vec<f64>> = contact.pressure.iter().map(stress).collect();
                let shear = Array2::from_shape_vec(contact.pressure.dim(), shear?).ok()?;
                Some(Sheared::Found(Box::new(Rubbed { contact: contact.as_ref().clone(), shear })))
            }
        }
    }

    /// The contact of a shear, and its tractions.
    pub(super) fn shown(&self, sheared: &Sheared) -> Result<Option<Rubbed>, HalfSpaceError> {
        match (self, sheared) {
            (Self::Partial(memory), Sheared::Pieces { depth, pieces }) => {
                let (load, coefficient) = (memory.curve(), memory.grip().coefficient);
                let contact = load.solution(*depth)?;
                let mut shear = Array2::zeros(contact.pressure.dim());
                let mut lower = Array2::zeros(contact.pressure.dim());
                for piece in pieces {
                    let upper = load.solution(piece.upper.depth())?.pressure;
                    shear.scaled_add(coefficient * piece.slope, &(&upper - &lower));
                    lower = upper;
                }
                Ok(Some(Rubbed { contact, shear }))
            }
            (_, Sheared::Found(rubbed)) => Ok(Some(rubbed.as_ref().clone())),
            (Self::Gross { .. } | Self::Coupled(_), Sheared::Pieces { .. }) => Ok(None),
        }
    }

    /// Bytes of what is kept from state to state: pressures and displacements.
    pub(super) fn bytes(&self) -> usize {
        let pixels = match self {
            Self::Partial(memory) => memory.curve().pixels(),
            Self::Coupled(dragged) => dragged.as_ref().map_or(0, |dragged| dragged.0.pressure.len()),
            Self::Gross { pressed, .. } => pressed.as_ref().map_or(0, |contact| contact.pressure.len()),
        };
        16 * pixels
    }
}

/// G* \[Pa\] along x of the contact under the greatest load that is prescribed: 1/G* = 1/G*₀ (1 + (1 − G*₀/E*)(1 − 2⟨cos²φ⟩)),
/// G*₀ that of a round contact.
pub(super) fn tangential_modulus(plan: &HalfSpacePlan, pressing: &Pressing<'_>) -> f64 {
    let Pair { normal, tangential, .. } = plan.pair;
    let drawn_out = match (&plan.friction, &plan.indenter) {
        (None | Some(PixelFriction::Gross(_) | PixelFriction::Coupled { .. }), _)
        | (_, PixelledIndenter::Smooth(_)) => None,
        (
            Some(PixelFriction::Partial { .. }),
            PixelledIndenter::Ellipsoid(..) | PixelledIndenter::Tips(_) | PixelledIndenter::Rough(..),
        ) => greatest(plan, pressing)
            .and_then(|contact| lengthwise(contact.pressure.view(), contact.pixel, pressing.boundary)),
    };
    tangential / (1.0 + (1.0 - tangential / normal) * drawn_out.map_or(0.0, |of| 1.0 - 2.0 * of))
}

/// The contact under the greatest depth or force that is prescribed, whichever presses more.
fn greatest(plan: &HalfSpacePlan, pressing: &Pressing<'_>) -> Option<Solution> {
    let of = |wanted: Control| {
        let (mut reached, mut control, mut greatest) = (0.0, Control::Indentation, 0.0_f64);
        for stage in &plan.stages {
            control = stage.control.unwrap_or(control);
            let swing = if let Path::Wave(wave) = stage.normal { wave.amplitude } else { 0.0 };
            if control == wanted {
                reached = stage.normal.at(reached, 1.0, stage.over);
                greatest = greatest.max(reached + swing);
            }
        }
        greatest
    };
    let prescribed = [
        (of(Control::Indentation), Prescribed::Indentation(pressing.touch + of(Control::Indentation))),
        (of(Control::Force), Prescribed::Force(of(Control::Force))),
    ];
    let loaded = prescribed.into_iter().filter(|(value, _)| *value > 0.0);
    let solved = loaded.filter_map(|(_, prescribed)| pressing.solve(prescribed, Start::Coarser).ok());
    solved.max_by(|one, other| one.force().total_cmp(&other.force()))
}

/// The straight steps of a way: one under a prescribed depth, chords of a depth that grows with a force.
fn poses(memory: &TangentialMemory<PixelLoad<'_>>, stroke: Stroke, state: &State) -> Result<Vec<Pose>, HalfSpaceError> {
    let end = state.normal.indentation.unwrap_or(0.0);
    let from = memory.position().indentation.max(0.0);
    let slides = (stroke.slide[1] - stroke.slide[0]).abs() > 0.0;
    if stroke.control == Control::Indentation || !slides || end <= from {
        return Ok(vec![Pose { indentation: end, slide: stroke.slide[1] }]);
    }
    let load = memory.curve();
    let refused = std::cell::RefCell::new(None);
    let depth = |t: f64| match t {
        t if t <= 0.0 => from,
        t if t >= 1.0 => end,
        t => load.depth(stroke.values[0] + t * (stroke.values[1] - stroke.values[0])).unwrap_or_else(|error| {
            refused.borrow_mut().get_or_insert(error);
            end
        }),
    };
    let ends = chords(&depth, (stroke.slide[0], stroke.slide[1]), FINEST);
    refused.into_inner().map_or(Ok(ends), Err)
}

/// Radius \[m\] of a disc of an area \[m²\], which stands for a contact that is none.
pub(super) fn round(area: f64) -> f64 {
    (area.max(0.0) / PI).sqrt()
}

fn told(memory: &TangentialMemory<PixelLoad<'_>>) -> Tangential {
    let (state, stick) = (memory.state(), memory.curve().at(memory.stick()));
    Tangential {
        slide: memory.position().slide,
        force: state.tangential_force,
        stick_radius: stick.radius.unwrap_or_else(|| round(stick.area)),
        stiffness: state.stiffness,
        stored: Some(memory.stored()),
        dissipated: Some(state.dissipated),
        area_ratio: None,
    }
}

/// Friction \[N\] of pressures in gross sliding; what counting whole pixels adds along the edges has no pressure.
fn friction(contact: &Solution, law: &dyn SlidingLaw) -> f64 {
    let stress: f64 =
        contact.pressure.iter().filter(|&&pressure| pressure > 0.0).map(|&pressure| law.stress(pressure)).sum();
    let added = if contact.contact_pixels() == contact.pressure.len() {
        0.0
    } else {
        contact.contact_area() - contact.corrected_area()
    };
    area(contact.pixel) * stress - law.stress(0.0) * added
}
