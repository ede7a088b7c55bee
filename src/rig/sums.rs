//! The sum of the squares that a fit makes least, and its normal equations.

use crate::number::Float;
use nalgebra::{Matrix6, Vector6};

/// The sum of the squares over `N²`, half of its derivatives, and the normal equations.
#[derive(Clone, Copy)]
pub(super) struct Sums<F> {
    pub total: F,
    pub gradient: Vector6<F>,
    pub normal: Matrix6<F>,
}

impl<F: Float> Sums<F> {
    pub fn add(&mut self, weight: F, error: F, row: &Vector6<F>) {
        self.total += weight * error * error;
        self.gradient.zip_apply(row, |entry, slope| *entry += weight * slope * error);
        for (mut column, slope) in self.normal.column_iter_mut().zip(row) {
            column.zip_apply(row, |entry, other| *entry += weight * *slope * other);
        }
    }

    /// The inverse of the damped normal equations of free parameters, zero for the others; none
    /// where they are singular.
    pub fn inverted(&self, free: &Vector6<bool>, damping: F) -> Option<Matrix6<F>> {
        let (zero, one) = (F::zero(), F::one());
        // in units that make the diagonal one
        let own = self.normal.diagonal();
        if own.iter().zip(free).any(|(own, free)| *free && !(*own > zero)) {
            return None;
        }
        let scale = own.zip_map(free, |own, free| if free { one / own.sqrt() } else { zero });
        let scaled = |matrix: &Matrix6<F>| {
            let mut scaled = *matrix;
            for (mut column, own) in scaled.column_iter_mut().zip(&scale) {
                column.zip_apply(&scale, |entry, other| *entry = *entry * *own * other);
            }
            scaled
        };
        let mut matrix = scaled(&self.normal);
        matrix.fill_diagonal(one + damping);
        F::inverse_of_normal(matrix).map(|inverse| scaled(&inverse))
    }
}
