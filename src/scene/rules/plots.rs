//! Figures against the parts they show.

use super::draft::Draft;
use super::parts::is_without_bed;
use super::pictures;
use super::plastic::yields;
use crate::contact::adhesion::{Adhesion, Range};
use crate::friction::{Friction, Slip};
use crate::input::problem::Problem;
use crate::scene::Plot;
use crate::scene::mended::Look;
use crate::shape::Shape;

/// Figures of what the scene lacks.
pub(super) fn not_drawn(draft: &Draft<'_>) -> Vec<Problem> {
    let problem = |(index, plot): (usize, Plot)| {
        let what = format!("{plot:?} cannot be drawn: {}", lacks(draft, plot)?);
        Some(Problem::new(format!("plots[{index}]"), what))
    };
    draft.plots().filter_map(problem).collect()
}

/// What the scene lacks for a figure.
fn lacks(draft: &Draft<'_>, plot: Plot) -> Option<&'static str> {
    let shape = draft.shape()?;
    if draft.chooses_solver()? {
        return lacks_on_pixels(draft, plot, shape);
    }
    if let Some(what) = unfit_for_ground(draft, plot, shape) {
        return Some(what);
    }
    if let Plot::Bed | Plot::Surface = plot {
        return pictures::lacks(draft, plot);
    }
    if let Some(what) = unfit(draft, plot)? {
        return Some(what);
    }
    let (there, what) = match plot {
        Plot::Force | Plot::Energy | Plot::Shape | Plot::Bed | Plot::Surface => return None,
        Plot::Radius | Plot::Pressure | Plot::Stress | Plot::Field => {
            (!shape.is_rough(), "a rough bed does not know its contact area: expected Force, Energy or Shape")
        }
        Plot::Moduli => {
            (draft.bodies(Look::Kind).map(|(one, two)| one.relaxes() || two.relaxes())?, "expected a Viscoelastic body")
        }
        Plot::Friction | Plot::Stick | Plot::Shear | Plot::Fretting => return lacks_of_slip(draft, plot, shape),
        Plot::Wear => (draft.wears()?, "expected a wear such as Archard(coefficient: \"1e-15 m^2/N\")"),
        Plot::Coefficient => (
            !draft.adheres()? && slides_as_a_whole(draft)?,
            "expected CoulombOrowan or Pressure friction, and no adhesion",
        ),
        Plot::Contact | Plot::Distribution | Plot::Leak => (false, "expected solver: HalfSpace(…)"),
        Plot::Area => (at_an_edge(draft)? && slides_as_a_whole(draft)?, "expected Jkr adhesion and Pressure friction"),
        Plot::Machine => (draft.is_driven()?, "expected a machine, and Drive, Ring or Fall in the history"),
        Plot::Resistance => {
            (draft.glides()? && !draft.has_traction()?, "expected Glide or Roll in the history, without a traction")
        }
        Plot::Traction => (draft.has_traction()?, "expected Roll with creepage or traction in the history"),
        Plot::Restitution => (draft.speeds()? > 1, "expected an Impact with a list of at least two speeds"),
    };
    (!there).then_some(what)
}

/// Why the shape or the ground has no such figure, if so.
fn unfit_for_ground(draft: &Draft<'_>, plot: Plot, shape: &Shape) -> Option<&'static str> {
    let of_plane = is_without_bed(shape).then(|| lacks_of_plane(plot)).flatten();
    let of_plane = of_plane.or_else(|| shape.is_plane().then(|| lacks_of_section(plot)).flatten());
    let of_ground = (is_of_stresses(plot) && draft.bodies(Look::Kind).is_some_and(|(one, two)| one.is_uneven() || two.is_uneven()))
        .then_some("the stress below is computed of half-spaces that are alike at all depths: expected Force, Radius, Pressure or Energy");
    of_plane.or(of_ground)
}

/// Why stresses, pressures or slip of the scene are not known, if they are not; `None` where too little of it is read.
fn unfit(draft: &Draft<'_>, plot: Plot) -> Option<Option<&'static str>> {
    if (is_of_stresses(plot) || plot == Plot::Fretting) && draft.wear().is_some() {
        return Some(Some(
            "it is not computed of a profile that wears: expected Wear, Friction, Stick or Pressure, or no wear",
        ));
    }
    if (is_of_stresses(plot) || plot == Plot::Fretting) && draft.is_driven()? {
        return Some(Some("it is not computed of a contact in a machine: expected Machine, Force, Friction or Energy"));
    }
    if is_of_stresses(plot) && yields(draft)? {
        return Some(Some(
            "the stress below a body that yields is not known: expected Force, Radius, Pressure or Energy, or Elastic bodies",
        ));
    }
    if (is_of_stresses(plot) || plot == Plot::Pressure) && draft.moves_along()? {
        return Some(Some(
            "the contact of a body that moves along is not round: expected Force, Radius, Energy or Resistance",
        ));
    }
    unfit_for_slip(draft, plot)
}

/// Why slip within the contact is not known, if it is not; `None` where too little of the scene is read.
fn unfit_for_slip(draft: &Draft<'_>, plot: Plot) -> Option<Option<&'static str>> {
    if plot == Plot::Stick && matches!(draft.friction(Look::Kind), Some(Friction::RateState(_))) {
        return Some(Some(
            "a contact with rate and state slips as a whole, however slowly: expected Machine, Friction or Energy",
        ));
    }
    if let Plot::Friction | Plot::Stick | Plot::Shear | Plot::Fretting = plot
        && draft.has_traction()?
    {
        return Some(Some("what rolls steadily slides along no way: expected Traction, Force, Radius or Pressure"));
    }
    Some(None)
}

/// What the scene lacks for a figure of friction.
fn lacks_of_slip(draft: &Draft<'_>, plot: Plot, shape: &Shape) -> Option<&'static str> {
    if plot != Plot::Friction && shape.is_rough() {
        return Some(
            "a rough bed does not know where in its contact it slips: expected Force, Energy, Shape or Friction",
        );
    }
    let (there, what) = if plot == Plot::Fretting {
        let sticks = draft.rubs()? && !slides_as_a_whole(draft)?;
        (sticks, "expected Coulomb friction and Shake or a Table with slide_m")
    } else {
        (draft.rubs()?, "expected a friction")
    };
    (!there).then_some(what)
}

/// Whether the bodies adhere at an edge.
fn at_an_edge(draft: &Draft<'_>) -> Option<bool> {
    let adheres = draft.adheres()?;
    let held = |adhesion: &Adhesion| matches!(adhesion.traits().range, Range::Vanishing(_));
    Some(adheres && draft.adhesion(Look::Kind).is_some_and(held))
}

/// Whether a figure shows stresses below the surface.
fn is_of_stresses(plot: Plot) -> bool {
    matches!(plot, Plot::Stress | Plot::Field)
}

const STRESS_OF_PLANE: &str =
    "the stress below a plane contact is not computed: expected Force, Radius, Pressure or Energy";

/// What a plane contact lacks for a figure, whatever else the scene has.
fn lacks_of_plane(plot: Plot) -> Option<&'static str> {
    match plot {
        Plot::Force
        | Plot::Energy
        | Plot::Radius
        | Plot::Pressure
        | Plot::Moduli
        | Plot::Area
        | Plot::Restitution
        | Plot::Machine
        | Plot::Resistance
        | Plot::Traction => None,
        Plot::Stress | Plot::Field => Some(STRESS_OF_PLANE),
        Plot::Bed => {
            Some("a wave that is solved by a series has no bed of springs: expected Force, Radius, Pressure or Energy")
        }
        Plot::Surface => Some(pictures::SURFACE_OF_SECTION),
        Plot::Shape => {
            Some("a plane contact has no one-dimensional profile g(x): expected Force, Radius, Pressure or Energy")
        }
        Plot::Contact | Plot::Distribution | Plot::Leak => {
            Some("a series of the half-plane knows no maps: expected Force, Radius, Pressure or Energy")
        }
        Plot::Friction | Plot::Stick | Plot::Shear | Plot::Fretting | Plot::Wear | Plot::Coefficient => {
            Some("a series of the half-plane knows no friction: expected Force, Radius, Pressure or Energy")
        }
    }
}

/// What a contact on pixels lacks.
fn lacks_on_pixels(draft: &Draft<'_>, plot: Plot, shape: &Shape) -> Option<&'static str> {
    let asked = draft.half_space(Look::Whole)?;
    match plot {
        Plot::Force | Plot::Energy | Plot::Area | Plot::Contact | Plot::Distribution => None,
        Plot::Radius if !shape.is_rough() => None,
        Plot::Leak if asked.leak.is_some() => None,
        Plot::Leak => Some("no fluid is in the gap: expected leak: (viscosity: …) in the solver"),
        Plot::Friction | Plot::Stick | Plot::Shear if draft.rubs()? => None,
        Plot::Friction | Plot::Stick | Plot::Shear => Some("the scene has no friction: expected a friction"),
        Plot::Radius
        | Plot::Pressure
        | Plot::Stress
        | Plot::Field
        | Plot::Bed
        | Plot::Surface
        | Plot::Shape
        | Plot::Moduli
        | Plot::Fretting
        | Plot::Wear
        | Plot::Coefficient
        | Plot::Machine
        | Plot::Resistance
        | Plot::Traction
        | Plot::Restitution => {
            Some("a contact on pixels is drawn as a map: expected Force, Energy, Area, Contact or Distribution")
        }
    }
}

/// What the bed of a section lacks.
fn lacks_of_section(plot: Plot) -> Option<&'static str> {
    match plot {
        Plot::Stress | Plot::Field => Some(STRESS_OF_PLANE),
        Plot::Bed => Some(
            "the springs of a lying body stand where their stiffness says, not where the body is: expected Force, Radius, Pressure or Shape",
        ),
        Plot::Surface => Some(pictures::SURFACE_OF_SECTION),
        Plot::Fretting => {
            Some("where a lying contact loses its energy is not mapped: expected Friction, Stick or Shear")
        }
        Plot::Force
        | Plot::Radius
        | Plot::Pressure
        | Plot::Energy
        | Plot::Shape
        | Plot::Moduli
        | Plot::Friction
        | Plot::Stick
        | Plot::Shear
        | Plot::Wear
        | Plot::Coefficient
        | Plot::Area
        | Plot::Contact
        | Plot::Distribution
        | Plot::Leak
        | Plot::Restitution
        | Plot::Machine
        | Plot::Resistance
        | Plot::Traction => None,
    }
}

/// Whether the friction is one of gross sliding.
fn slides_as_a_whole(draft: &Draft<'_>) -> Option<bool> {
    let gross = |friction: &Friction| matches!(friction.slip(), Slip::Gross);
    draft.rubs().map(|_| draft.friction(Look::Kind).is_some_and(gross))
}
