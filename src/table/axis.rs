//! An axis of a table: the nodes around a place, and their weights.
//!
//! Between two nodes a number is the mean of two parabolas, each through both nodes and the next
//! one on a side, weighted with the nearness: its derivative is continuous, also where nodes are at
//! unequal distances. Beyond the ends it is linear.
//!
//! ```text
//! p = p₁ + u (p₂ − p₁) − u (1 − u) h² ((1 − u) D₁ + u D₂)
//! D₂ = ((p₃ − p₂)/d − (p₂ − p₁)/h)/(h + d),   D₁ likewise
//! ```

use crate::number::{Float, add_at};

/// Nodes around a place with their weights: as many as are not zero.
#[derive(Clone, Copy)]
pub(super) struct Around<F> {
    /// Number of the first.
    pub first: usize,
    pub weights: [F; 4],
    /// How many there are.
    pub count: usize,
}

impl<F: Float> Around<F> {
    /// The nodes around a place on an axis of a number of nodes in ascending order.
    pub fn new(node: impl Fn(usize) -> F, nodes: usize, place: F) -> Self {
        let (zero, one) = (F::zero(), F::one());
        if nodes < 2 {
            return Self { first: 0, weights: [one, zero, zero, zero], count: 1 };
        }
        let (mut k, mut above) = (0, nodes - 1);
        while above - k > 1 {
            let middle = (above + k) / 2;
            if node(middle) <= place {
                k = middle;
            } else {
                above = middle;
            }
        }
        let (from, to) = (node(k), node(k + 1));
        let length = to - from;
        let (share, square) = ((place - from) / length, length * length);
        let rest = one - share;
        // factors of both bends
        let [mut by_first, mut by_last] = if share < zero {
            [-share * square, zero]
        } else if share > one {
            [zero, -rest * square]
        } else {
            let size = -(share * rest) * square;
            [size * rest, size * share]
        };
        let (has_before, has_after) = (k > 0, k + 2 < nodes);
        match (has_before, has_after) {
            (false, true) => by_last += by_first,
            (true, false) => by_first += by_last,
            _ => {}
        }
        let first = k.saturating_sub(1);
        let own = k - first;
        let mut weights = [zero; 4];
        add_at(&mut weights, own, rest);
        add_at(&mut weights, own + 1, share);
        // the second difference of three nodes
        let mut bend = |outer: usize, near: usize, far: usize, distance: F, factor: F| {
            let per_sum = factor / (length + distance);
            add_at(&mut weights, outer, per_sum / distance);
            add_at(&mut weights, near, -(per_sum / distance + per_sum / length));
            add_at(&mut weights, far, per_sum / length);
        };
        if has_before {
            bend(own - 1, own, own + 1, from - node(k - 1), by_first);
        }
        if has_after {
            bend(own + 2, own + 1, own, node(k + 2) - to, by_last);
        }
        Self { first, weights, count: own + 2 + usize::from(has_after) }
    }

    /// Numbers and weights of the nodes.
    pub fn nodes(&self) -> impl Iterator<Item = (usize, F)> + '_ {
        let own = self.weights.iter().take(self.count);
        own.enumerate().map(|(k, weight)| (self.first + k, *weight))
    }

    /// A number between those of the nodes.
    pub fn blend(&self, of: impl Fn(usize) -> F) -> F {
        self.nodes().fold(F::zero(), |sum, (k, weight)| sum + weight * of(k))
    }
}
