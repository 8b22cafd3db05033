//! Which parts of a scene cannot be computed together: one table, every problem at once.
//!
//! # Examples
//! ```
//! use springbed::scene::rules::{Part, RULES};
//!
//! // Which parts ask whether they go with friction.
//! let with_friction = RULES.iter().filter(|rule| rule.between.0 == Part::Friction || rule.between.1 == Part::Friction);
//! assert!(with_friction.count() > 3);
//! ```

mod adhesion;
mod depth;
mod draft;
mod glide;
mod ground;
mod history;
mod machine;
mod pad;
mod parts;
mod pixels;
mod pictures;
mod plastic;
mod plots;
mod power_law;
mod slip;
mod spring;
mod traction;
mod wear;

pub use draft::Draft;
pub(super) use draft::{Parts, Written};
pub(super) use pixels::tips_without_pixels;

use crate::input::problem::Problem;
use crate::scene::history::EntryTraits;
use Part::{Adhesion, Bodies, Friction, History, Machine, Plots, Shape, Solver, Springs, Wear};

/// What is wrong with a draft, in the order of the table.
#[must_use]
pub fn problems(draft: &Draft<'_>) -> Vec<Problem> {
    RULES.iter().flat_map(|rule| rule.problems(draft)).collect()
}

/// What a scene is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// The shape of the indenter.
    Shape,
    /// The two bodies.
    Bodies,
    /// The adhesion.
    Adhesion,
    /// The friction.
    Friction,
    /// The wear.
    Wear,
    /// The machine.
    Machine,
    /// The history.
    History,
    /// A number of springs.
    Springs,
    /// A solver of one's own choice.
    Solver,
    /// The figures.
    Plots,
}

/// Two parts that cannot always be computed together.
#[derive(Debug, Clone, Copy)]
pub struct Rule {
    /// The parts.
    pub between: (Part, Part),
    refuses: Refuses,
}

/// How a rule finds what is wrong.
#[derive(Debug, Clone, Copy)]
enum Refuses {
    /// In the scene as a whole.
    Once(fn(&Draft<'_>) -> Option<Problem>),
    /// In each entry of the history, by itself.
    Entry(fn(&Draft<'_>, &EntryTraits<'_>) -> Option<Problem>),
    /// In any number of places.
    Many(fn(&Draft<'_>) -> Vec<Problem>),
}

impl Rule {
    const fn once(one: Part, other: Part, refuses: fn(&Draft<'_>) -> Option<Problem>) -> Self {
        Self { between: (one, other), refuses: Refuses::Once(refuses) }
    }

    const fn entry(other: Part, refuses: fn(&Draft<'_>, &EntryTraits<'_>) -> Option<Problem>) -> Self {
        Self { between: (History, other), refuses: Refuses::Entry(refuses) }
    }

    const fn many(one: Part, other: Part, refuses: fn(&Draft<'_>) -> Vec<Problem>) -> Self {
        Self { between: (one, other), refuses: Refuses::Many(refuses) }
    }

    fn problems(&self, draft: &Draft<'_>) -> Vec<Problem> {
        match self.refuses {
            Refuses::Once(refuses) => refuses(draft).into_iter().collect(),
            Refuses::Entry(refuses) => draft.entries().flatten().filter_map(|entry| refuses(draft, entry)).collect(),
            Refuses::Many(refuses) => refuses(draft),
        }
    }
}

/// Every refusal of a pair.
pub const RULES: &[Rule] = &[
    Rule::once(Bodies, Bodies, parts::two_rigid),
    Rule::once(Solver, Solver, pixels::built),
    Rule::once(Solver, Solver, pixels::grid),
    Rule::once(Solver, Adhesion, pixels::adhesion),
    Rule::once(Solver, Friction, pixels::friction),
    Rule::once(Solver, Friction, pixels::tractions),
    Rule::once(Solver, Wear, pixels::wear),
    Rule::once(Solver, Springs, pixels::springs),
    Rule::once(Solver, Shape, pixels::shape),
    Rule::once(Solver, Shape, pixels::window),
    Rule::once(Solver, Shape, pixels::leak),
    Rule::once(Solver, Shape, pixels::tips),
    Rule::entry(Solver, pixels::moves),
    Rule::once(Bodies, Bodies, ground::beside),
    Rule::once(Bodies, Shape, ground::under_shape),
    Rule::once(Bodies, Friction, ground::friction),
    Rule::once(Bodies, Adhesion, ground::adhesion),
    Rule::once(Bodies, Bodies, plastic::on_viscoelastic),
    Rule::once(Bodies, Shape, plastic::on_shape),
    Rule::once(Bodies, Adhesion, plastic::under_adhesion),
    Rule::once(Bodies, Friction, plastic::with_friction),
    Rule::once(Bodies, Springs, plastic::on_springs),
    Rule::once(Adhesion, Bodies, adhesion::between_bodies),
    Rule::once(Adhesion, Bodies, power_law::under_adhesion),
    Rule::once(Bodies, Bodies, power_law::in_layers),
    Rule::once(Adhesion, Adhesion, adhesion::closing_beyond_opening),
    Rule::once(Adhesion, Shape, adhesion::range_on_shape),
    Rule::once(Adhesion, Solver, adhesion::fading),
    Rule::once(Friction, Bodies, parts::friction_of_bodies_in_series),
    Rule::once(Friction, Bodies, parts::gross_sliding_of_viscoelastic),
    Rule::once(Friction, Shape, parts::peeling_on_section),
    Rule::once(Friction, Adhesion, parts::friction_under_adhesion),
    Rule::once(Friction, Adhesion, parts::friction_with_closing),
    Rule::once(Friction, Adhesion, parts::stuck_without_edge),
    Rule::entry(Friction, history::moved_while_stuck),
    Rule::once(Springs, Adhesion, parts::springs_under_adhesion),
    Rule::once(Springs, Adhesion, parts::springs_with_closing),
    Rule::once(Wear, Friction, wear::without_friction),
    Rule::once(Wear, Friction, wear::under_friction),
    Rule::once(Wear, Bodies, wear::of_bodies),
    Rule::once(Wear, Adhesion, wear::under_adhesion),
    Rule::once(Wear, Shape, wear::on_shape),
    Rule::once(Wear, Springs, wear::on_springs),
    Rule::entry(Wear, wear::in_entry),
    Rule::once(Machine, History, machine::without_motion),
    Rule::entry(Machine, machine::without_machine),
    Rule::once(Machine, Machine, spring::without_mass),
    Rule::once(Machine, Bodies, spring::on_bodies),
    Rule::once(Machine, Adhesion, spring::with_parts),
    Rule::entry(Machine, spring::in_history),
    Rule::entry(Machine, machine::suspension),
    Rule::once(Machine, Shape, machine::on_shape),
    Rule::entry(Bodies, machine::of_bodies),
    Rule::entry(Bodies, machine::ring_on_dashpot),
    Rule::entry(Adhesion, machine::under_adhesion),
    Rule::entry(Friction, machine::friction),
    Rule::once(Friction, History, slip::falling_friction),
    Rule::once(Friction, Friction, slip::kinetic_above_static),
    Rule::once(Friction, Friction, slip::without_direct_effect),
    Rule::once(Friction, Friction, slip::large_effects),
    Rule::entry(Friction, slip::slide_before),
    Rule::once(Machine, Wear, machine::with_wear),
    Rule::once(Machine, Springs, machine::on_springs),
    Rule::once(Machine, Solver, machine::on_pixels),
    Rule::entry(History, machine::in_history),
    Rule::entry(History, machine::beside),
    Rule::once(Shape, Adhesion, adhesion::on_shape),
    Rule::once(Shape, Friction, parts::friction_on_shape),
    Rule::once(Shape, Springs, parts::springs_on_shape),
    Rule::many(Shape, Bodies, parts::viscoelastic_on_plane),
    Rule::once(Shape, Bodies, pad::on_bodies),
    Rule::once(Shape, Adhesion, pad::closing_of_summits),
    Rule::entry(Shape, pad::moves),
    Rule::entry(Shape, history::impact_on_plane),
    Rule::entry(Shape, history::slide_on_plane),
    Rule::entry(Shape, history::depth_of_wavy),
    Rule::entry(Shape, history::oblique_on_shape),
    Rule::entry(Bodies, power_law::in_entry),
    Rule::entry(Bodies, power_law::at_once),
    Rule::entry(Adhesion, history::pull_without_adhesion),
    Rule::entry(Adhesion, history::oblique_under_adhesion),
    Rule::entry(Friction, history::slide_without_friction),
    Rule::entry(Friction, history::shake_in_gross_sliding),
    Rule::entry(Springs, history::impact_on_springs),
    Rule::entry(Shape, glide::on_shape),
    Rule::entry(Shape, glide::steep_on_dashpot),
    Rule::entry(Bodies, glide::of_bodies),
    Rule::entry(Adhesion, glide::with_adhesion),
    Rule::entry(Friction, glide::with_friction),
    Rule::entry(Springs, glide::on_springs),
    Rule::entry(History, glide::in_history),
    Rule::entry(History, glide::beside),
    Rule::entry(History, glide::both),
    Rule::entry(History, traction::prescribed),
    Rule::entry(Shape, traction::on_shape),
    Rule::entry(Bodies, traction::of_bodies),
    Rule::entry(Friction, traction::friction),
    Rule::entry(Wear, traction::with_wear),
    Rule::entry(Solver, traction::on_pixels),
    Rule::entry(History, traction::slide_beside),
    Rule::entry(History, history::impact_beside_others),
    Rule::entry(History, history::nothing_to_part),
    Rule::many(History, Shape, depth::too_deep),
    Rule::many(History, Friction, depth::too_fast),
    Rule::many(Plots, History, plots::not_drawn),
];
