//! Gauss–Legendre rules on `[-1, 1]`.
//!
//! Roots and weights to 18 digits, computed with mpmath at 40 digits from `P_n(x) = 0`,
//! `w = 2/((1 − x²) P_n'(x)²)`; a test checks that `n` nodes integrate every power up to `2n − 1`.

use crate::number::Float;

/// A node and its weight.
pub type Node<F> = (F, F);

/// How a number of strips is dealt to the panels of a contact.
#[derive(Clone, Copy, Debug)]
pub struct StripRule<F: 'static> {
    /// Nodes of a sliding panel, on each side.
    pub slide: &'static [Node<F>],
    /// The positive nodes of an adhesion panel; each stands for its mirror image too.
    pub stick: &'static [Node<F>],
    /// Whether the strips with adhesion are two panels, divided where `ξ̄ = 0`.
    pub split: bool,
}

/// Rules in the precision of the caller. Associated constants, so that single-precision firmware
/// carries no double-precision table.
pub trait Tabulated: Float {
    /// 2 nodes.
    const GAUSS_2: &'static [Node<Self>];
    /// 8 nodes.
    const GAUSS_8: &'static [Node<Self>];
    /// 16 nodes.
    const GAUSS_16: &'static [Node<Self>];
    /// For 4, 8, 16, 32 and 64 strips.
    const STRIPS: [StripRule<Self>; 5];
}

/// The last nodes of a table in the precision `$float`.
macro_rules! narrow {
    ($float:ident, $table:ident, $count:literal) => {{
        const NODES: [Node<$float>; $count] = {
            let mut nodes = [(0.0, 0.0); $count];
            let skipped = $table.0.len() - $count;
            let mut i = 0;
            while i < $count {
                nodes[i] = ($table.0[skipped + i] as $float, $table.1[skipped + i] as $float);
                i += 1;
            }
            nodes
        };
        &NODES
    }};
}

/// Nodes of each sliding panel, positive nodes of each adhesion panel, and whether there are two of these.
macro_rules! strip_rule {
    ($float:ident: $slide:ident $slide_count:literal, $stick:ident $stick_count:literal, $split:literal) => {
        StripRule {
            slide: narrow!($float, $slide, $slide_count),
            stick: narrow!($float, $stick, $stick_count),
            split: $split,
        }
    };
}

macro_rules! tabulated {
    ($float:ident) => {
        #[allow(clippy::unnecessary_cast)]
        impl Tabulated for $float {
            const GAUSS_2: &'static [Node<Self>] = narrow!($float, GAUSS_2, 2);
            const GAUSS_8: &'static [Node<Self>] = narrow!($float, GAUSS_8, 8);
            const GAUSS_16: &'static [Node<Self>] = narrow!($float, GAUSS_16, 16);
            const STRIPS: [StripRule<Self>; 5] = [
                strip_rule!($float: GAUSS_1 1, GAUSS_2 1, false),
                strip_rule!($float: GAUSS_2 2, GAUSS_4 2, false),
                strip_rule!($float: GAUSS_5 5, GAUSS_6 3, false),
                strip_rule!($float: GAUSS_8 8, GAUSS_8 4, true),
                strip_rule!($float: GAUSS_16 16, GAUSS_16 8, true),
            ];
        }
    };
}

tabulated!(f64);
tabulated!(f32);

/// 1 node.
#[allow(clippy::excessive_precision)]
const GAUSS_1: ([f64; 1], [f64; 1]) = ([0.0], [2.0]);

/// 2 nodes.
#[allow(clippy::excessive_precision)]
const GAUSS_2: ([f64; 2], [f64; 2]) = ([-0.577350269189625765, 0.577350269189625765], [1.0, 1.0]);

/// 4 nodes.
#[allow(clippy::excessive_precision)]
const GAUSS_4: ([f64; 4], [f64; 4]) = (
    [-0.861136311594052575, -0.339981043584856265, 0.339981043584856265, 0.861136311594052575],
    [0.347854845137453857, 0.652145154862546143, 0.652145154862546143, 0.347854845137453857],
);

/// 5 nodes.
#[allow(clippy::excessive_precision)]
const GAUSS_5: ([f64; 5], [f64; 5]) = (
    [-0.906179845938663993, -0.538469310105683091, 0.0, 0.538469310105683091, 0.906179845938663993],
    [
        0.236926885056189088,
        0.478628670499366468,
        0.568888888888888889,
        0.478628670499366468,
        0.236926885056189088,
    ],
);

/// 6 nodes.
#[allow(clippy::excessive_precision)]
const GAUSS_6: ([f64; 6], [f64; 6]) = (
    [
        -0.932469514203152028,
        -0.661209386466264514,
        -0.238619186083196909,
        0.238619186083196909,
        0.661209386466264514,
        0.932469514203152028,
    ],
    [
        0.171324492379170345,
        0.360761573048138608,
        0.467913934572691047,
        0.467913934572691047,
        0.360761573048138608,
        0.171324492379170345,
    ],
);

/// 8 nodes.
#[allow(clippy::excessive_precision)]
const GAUSS_8: ([f64; 8], [f64; 8]) = (
    [
        -0.960289856497536232,
        -0.79666647741362674,
        -0.525532409916328986,
        -0.183434642495649805,
        0.183434642495649805,
        0.525532409916328986,
        0.79666647741362674,
        0.960289856497536232,
    ],
    [
        0.101228536290376259,
        0.222381034453374471,
        0.313706645877887287,
        0.362683783378361983,
        0.362683783378361983,
        0.313706645877887287,
        0.222381034453374471,
        0.101228536290376259,
    ],
);

/// 16 nodes.
#[allow(clippy::excessive_precision)]
const GAUSS_16: ([f64; 16], [f64; 16]) = (
    [
        -0.989400934991649933,
        -0.944575023073232576,
        -0.865631202387831744,
        -0.755404408355003034,
        -0.617876244402643748,
        -0.458016777657227386,
        -0.281603550779258913,
        -0.0950125098376374402,
        0.0950125098376374402,
        0.281603550779258913,
        0.458016777657227386,
        0.617876244402643748,
        0.755404408355003034,
        0.865631202387831744,
        0.944575023073232576,
        0.989400934991649933,
    ],
    [
        0.0271524594117540949,
        0.0622535239386478929,
        0.0951585116824927848,
        0.124628971255533872,
        0.149595988816576732,
        0.169156519395002538,
        0.182603415044923589,
        0.189450610455068496,
        0.189450610455068496,
        0.182603415044923589,
        0.169156519395002538,
        0.149595988816576732,
        0.124628971255533872,
        0.0951585116824927848,
        0.0622535239386478929,
        0.0271524594117540949,
    ],
);
