//! One step of the conjugate gradients on the present contact, in seven digits.

use std::cmp::Ordering;

use rayon::prelude::*;

use super::{Budget, Goal, GridContact, Iterate};
use crate::halfspace::precision::{Precision, Scratch};
use crate::halfspace::vector::{each_mut, scale, sum, swept, update};

/// Part of a prescribed sum up to which what a step adds to it is taken off as a factor.
const MORE: f64 = 1e-3;

impl GridContact<'_> {
    /// Stiffness of the present contact against a uniform displacement.
    pub(super) fn stiffen(&self, state: &mut Iterate, scratch: &mut Scratch) {
        if state.uniform.is_empty() {
            return;
        }
        state.level.clear();
        let ones = &mut state.residual;
        each_mut(ones).zip(&state.contact).for_each(|(one, &contact)| *one = f32::from(u8::from(contact)));
        self.operators.stiffness.apply(ones, &mut state.uniform, scratch);
        state.uniform_total = keep_where(&mut state.uniform, &state.contact);
    }

    /// One step of the conjugate gradients on the present contact.
    pub(super) fn step(&self, pressure: &mut [f64], state: &mut Iterate, effort: &mut Budget, scratch: &mut Scratch) {
        let approach = self.approach(state);
        let per_unit = state.unit.recip();
        let known = each_mut(&mut state.residual).zip(&state.lift).zip(&state.contact);
        known.for_each(|((residual, lift), &contact)| {
            *residual = if contact { f32::nearest(per_unit * (approach - lift)) } else { 0.0 };
        });
        self.operators.stiffness.apply(&state.residual, &mut state.work, scratch);
        let total = keep_where(&mut state.work, &state.contact);
        let share = if state.uniform.is_empty() { 0.0 } else { f32::nearest(-total / state.uniform_total) };
        let (uniform, residual) = (&state.uniform, &state.residual);
        let slope = swept(&mut state.work, |range, work| {
            if !uniform.is_empty() {
                work.iter_mut().zip(&uniform[range.clone()]).for_each(|(value, uniform)| *value += share * uniform);
            }
            product(work, &residual[range])
        });
        let memory = f32::nearest(if state.slope > 0.0 { slope / state.slope } else { 0.0 });
        state.slope = slope;
        let work = &state.work;
        let added = swept(&mut state.direction, |range, direction| {
            direction
                .iter_mut()
                .zip(&work[range])
                .for_each(|(direction, value)| *direction = value + memory * *direction);
            direction.iter().map(|&direction| f64::from(direction)).sum()
        });
        self.operators.swift.apply(&state.direction, &mut state.work, scratch);
        effort.iterations += 1;
        effort.products += 1;
        let (direction, work) = (&state.direction, &state.work);
        let curvature = sum(pressure.len(), |range| product(&direction[range.clone()], &work[range]));
        // A contact of one pixel under a prescribed force has no direction to go; nor has one solved to rounding.
        if slope.partial_cmp(&0.0) != Some(Ordering::Greater) || curvature.partial_cmp(&0.0) != Some(Ordering::Greater)
        {
            state.slope = 0.0;
            return;
        }
        let length = state.unit * (slope / curvature);
        update(pressure, &state.direction, |p, direction| *p += length * f64::from(direction));
        update(&mut state.lift, &state.work, |lift, change| *lift += length * f64::from(change));
        if let Goal::Sum(wanted) = self.goal {
            let more = length * added;
            if more.abs() <= MORE * wanted {
                self.rescale(pressure, &mut state.lift, wanted / (wanted + more));
            } else {
                self.level(state, effort, scratch);
                take_off(more, pressure, state);
            }
        }
    }

    /// What a uniform pressure on the present contact displaces.
    fn level(&self, state: &mut Iterate, effort: &mut Budget, scratch: &mut Scratch) {
        let Iterate { contact, level, residual, .. } = state;
        if level.is_empty() {
            each_mut(residual).zip(&*contact).for_each(|(one, &contact)| *one = f32::from(u8::from(contact)));
            level.resize(residual.len(), 0.0);
            self.operators.swift.apply(residual, level, scratch);
            effort.products += 1;
        }
    }

    /// Pressure and displacement `by` times.
    pub(super) fn rescale(&self, pressure: &mut [f64], lift: &mut [f64], by: f64) {
        scale(pressure, by);
        update(lift, self.heights, |lift, height| {
            if height.is_finite() {
                *lift = height + by * (*lift - height);
            }
        });
    }
}

/// Takes `more` off the sum of the pressures, evenly over the contact. Steps on a contact that is much too large add
/// pressures that push and pull, and their sum is rounded to seven digits of them: more than a small force asked for, which
/// as a factor would leave nothing of the step.
fn take_off(more: f64, pressure: &mut [f64], state: &mut Iterate) {
    let Iterate { contact, level, lift, .. } = state;
    let each = more / contact.iter().filter(|&&contact| contact).count() as f64;
    each_mut(pressure).zip(&*contact).filter(|(_, contact)| **contact).for_each(|(p, _)| *p -= each);
    update(lift, level, |lift, level| *lift -= each * f64::from(level));
}

/// Values in contact are kept, all others zero; the sum of those kept.
fn keep_where(values: &mut [f32], contact: &[bool]) -> f64 {
    swept(values, |range, values| {
        values
            .iter_mut()
            .zip(&contact[range])
            .for_each(|(value, &contact)| *value = if contact { *value } else { 0.0 });
        values.iter().map(|&value| f64::from(value)).sum()
    })
}

/// Σ x·y of a piece.
fn product(x: &[f32], y: &[f32]) -> f64 {
    x.iter().zip(y).map(|(&x, &y)| f64::from(x) * f64::from(y)).sum()
}
