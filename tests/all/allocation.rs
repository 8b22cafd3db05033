//! A scene pays for what it uses: memory taken on the way, counted by the allocator.

#![allow(unsafe_code, reason = "an allocator that counts is one by nature")]

use springbed::friction::{Coulomb, Friction};
use springbed::input::quantity::{Displacement, Duration, Length, Modulus, Poisson, Ratio, Stress, Viscosity};
use springbed::input::table::InMemory;
use springbed::material::{Body, Elastic, Shear, Term, Terms, Viscoelastic};
use springbed::run::record::Record;
use springbed::run::{self, Wanted};
use springbed::scene::Scene;
use springbed::scene::history::{Entry, Indent, Slide};
use springbed::scene::plan::Plan;
use springbed::shape::{Paraboloid, Shape};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::num::NonZeroUsize;

struct Counting;

thread_local! {
    static TAKEN: Cell<usize> = const { Cell::new(0) };
    static LARGEST: Cell<usize> = const { Cell::new(0) };
}

/// Counts what this thread takes; the other threads of the test program do not disturb it.
fn taken(size: usize) {
    let _ = TAKEN.try_with(|total| total.set(total.get() + size));
    let _ = LARGEST.try_with(|largest| largest.set(largest.get().max(size)));
}

// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        taken(layout.size());
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        taken(size);
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn over() -> Duration {
    Duration::new(1.0).unwrap()
}

fn elastic() -> Scene {
    let steel =
        Elastic { young: Modulus::new(210e9).unwrap(), poisson: Poisson::new(0.3).unwrap(), yield_stress: None };
    Scene {
        title: String::new(),
        shape: Shape::Paraboloid(Paraboloid { radius: Length::new(0.01).unwrap() }),
        bodies: (Body::Elastic(steel), Body::Rigid),
        adhesion: None,
        friction: None,
        history: vec![Entry::Indent(Indent { to: Displacement::new(1e-6).unwrap(), over: over() })],
        accuracy: None,
        springs: None,
        steps: NonZeroUsize::new(10),
        plots: None,
        wear: None,
        machine: None,
        sweep: None,
        fit: None,
        solver: None,
    }
}

fn ready(scene: Scene) -> Plan {
    scene.resolve(&InMemory::default()).unwrap()
}

/// Bytes taken in all, and in the largest piece, while a scene is run.
fn run(plan: &Plan, wanted: Wanted) -> (usize, usize) {
    // What is made once for the whole program is not the scene's.
    run::run(plan, wanted).unwrap();
    TAKEN.set(0);
    LARGEST.set(0);
    run::run(plan, wanted).unwrap();
    (TAKEN.get(), LARGEST.get())
}

/// Eleven records, in room for four, eight and sixteen of them on the way, and the text of plan and results: there
/// is no room in it for a bed of a thousand springs, a Prony state per spring or a friction state.
#[test]
fn an_elastic_scene_allocates_no_spring_no_prony_state_no_friction_state() {
    let (taken, largest) = run(&ready(elastic()), Wanted::NOTHING);
    let records = (4 + 8 + 16) * size_of::<Record>();
    assert!(taken < records + 5_000 && largest < 8_000, "{taken} bytes, {largest} in one piece");
}

#[test]
fn springs_friction_and_prony_elements_cost_what_they_say() {
    let bare = run(&ready(elastic()), Wanted::NOTHING).0;
    let springs = 10_000;
    let bed = run(&ready(Scene { springs: NonZeroUsize::new(springs), ..elastic() }), Wanted::NOTHING).0;
    assert!(bed > bare + 16 * springs, "{bed} bytes with springs, {bare} without");

    let slide = Entry::Slide(Slide { to: Displacement::new(1e-7).unwrap(), over: over() });
    let sliding = Scene {
        friction: Some(Friction::Coulomb(Coulomb { coefficient: Ratio::new(0.3).unwrap() })),
        history: [elastic().history, vec![slide]].concat(),
        ..elastic()
    };
    let sliding = run(&ready(sliding), Wanted::NOTHING);
    assert!(sliding.0 > bare && sliding.1 < 16 * springs, "{sliding:?} bytes with friction, {bare} without");

    let term = Term { modulus: Stress::new(1e6).unwrap(), time: over() };
    let shear = Shear {
        equilibrium: Stress::new(1e6).unwrap(),
        terms: Terms::List(vec![term]),
        viscosity: Viscosity::new(0.0).unwrap(),
        power_law: None,
    };
    let rubber =
        Body::Viscoelastic(Viscoelastic { poisson: Poisson::new(0.5).unwrap(), shear, temperature: None, shift: None });
    let relaxing = run(&ready(Scene { bodies: (rubber, Body::Rigid), ..elastic() }), Wanted::NOTHING).0;
    assert!(relaxing > bare, "{relaxing} bytes with a Prony element, {bare} without");
}

/// A field has 161 radii of three numbers.
#[test]
fn fields_and_stresses_nobody_wants_are_not_computed() {
    let plan = ready(elastic());
    let bare = run(&plan, Wanted::NOTHING).0;
    let fields = run(&plan, Wanted { fields: true, ..Wanted::NOTHING }).0;
    let stresses = run(&plan, Wanted { stresses: true, ..Wanted::NOTHING }).0;
    assert!(fields > bare + 161 * 24 && stresses > bare + 96 * 24, "{bare}, {fields}, {stresses} bytes");
    let outcome = run::run(&plan, Wanted::NOTHING).unwrap();
    assert!(outcome.fields.is_empty() && outcome.tables.is_empty());
}

/// The plan tells what a scene leaves out.
#[test]
fn the_plan_names_the_parts_used_and_left_out() {
    let plan = run::run(&ready(elastic()), Wanted::NOTHING).unwrap().plan;
    for part in ["springs", "stick and slip by turning points", "Prony elements"] {
        assert!(plan.left_out.contains(&part) && !plan.used.contains(&part), "{plan:?}");
    }
    assert!(plan.springs == 0 && plan.state_bytes < 1024, "{plan:?}");
}
