//! Where the strips of the Hertz ellipse lie.
//!
//! Gauss-Legendre rules on either half of the contact (64 strips: on its quarters), because the
//! longitudinal slip of spin changes its sign near the middle: with 16 strips the totals are then three to seven
//! times closer to the limit of many strips than with one rule over the whole width.
//! Written by `fit/fit_strip.py --nodes`; a test checks the rules.
// Generated: change the script, not this file.

use super::{Marched, Strips};
use crate::number::Float;

/// Strips of the Hertz ellipse, ascending in `y`; all lengths dimensionless.
#[derive(Clone, Copy, Debug)]
pub struct Rule<F, const N: usize> {
    /// `Y = y/b` of the centre line.
    pub y: [F; N],
    /// Half length `C = √(1 − Y²)`.
    pub half_length: [F; N],
    /// Width in `Y`; their sum is 2.
    pub width: [F; N],
    /// `1/C`
    pub inverse: [F; N],
    /// `(0.4 − Y²) Y`
    pub bend: [F; N],
    /// Share of the friction bound `(3/4) C² ΔY`.
    pub load: [F; N],
    /// Share times `Y`.
    pub moment_y: [F; N],
    /// Share times `C`.
    pub moment_x: [F; N],
    /// Share of the area.
    pub area: [F; N],
    /// `(π/2)/Σ C ΔY`: makes the linear forces exact.
    pub stretch: F,
    /// `(π/8)/Σ C Y² ΔY`: makes the linear moment of spin exact.
    pub lever: F,
}

/// Strip counts that have a rule: 4, 8, 16, 32, 64.
pub trait Placed<const N: usize>: Float + Marched {
    /// The rule, in the precision of the caller.
    const RULE: &'static Rule<Self, N>;
    /// Its strips, whose type does not know how many they are.
    const STRIPS: &'static Strips<'static, Self>;
}

/// The half of a rule with `Y > 0`: `Y`, `C`, width.
type Half<const H: usize> = [[f64; 3]; H];

macro_rules! placed {
    ($float:ident, $count:literal, $half:ident) => {
        #[allow(clippy::unnecessary_cast, clippy::indexing_slicing)]
        impl Placed<$count> for $float {
            const RULE: &'static Rule<Self, $count> = &{
                let zero = [0.0; $count];
                let mut rule = Rule {
                    y: zero,
                    half_length: zero,
                    width: zero,
                    inverse: zero,
                    bend: zero,
                    load: zero,
                    moment_y: zero,
                    moment_x: zero,
                    area: zero,
                    stretch: 0.0,
                    lever: 0.0,
                };
                let (mut stretch, mut lever) = (0.0, 0.0);
                let mut i = 0;
                while i < $count / 2 {
                    let [y, c, width] = $half[i];
                    stretch += 2.0 * width * c;
                    lever += 2.0 * width * c * (y * y);
                    i += 1;
                }
                let mut i = 0;
                while i < $count {
                    let upper = i >= $count / 2;
                    let [y, c, width] =
                        $half[if upper { i - $count / 2 } else { $count / 2 - 1 - i }];
                    let y = if upper { y } else { -y };
                    let load = 0.75 * width * (c * c);
                    rule.y[i] = y as $float;
                    rule.half_length[i] = c as $float;
                    rule.width[i] = width as $float;
                    rule.inverse[i] = (1.0 / c) as $float;
                    rule.bend[i] = ((0.4 - y * y) * y) as $float;
                    rule.load[i] = load as $float;
                    rule.moment_y[i] = (load * y) as $float;
                    rule.moment_x[i] = (load * c) as $float;
                    rule.area[i] = (width * c / stretch) as $float;
                    i += 1;
                }
                rule.stretch = (core::f64::consts::FRAC_PI_2 / stretch) as $float;
                rule.lever = (core::f64::consts::FRAC_PI_8 / lever) as $float;
                rule
            };
            const STRIPS: &'static Strips<'static, Self> = &<Self as Placed<$count>>::RULE.strips();
        }
    };
}

placed!(f64, 4, HALF_OF_4);
placed!(f32, 4, HALF_OF_4);
placed!(f64, 8, HALF_OF_8);
placed!(f32, 8, HALF_OF_8);
placed!(f64, 16, HALF_OF_16);
placed!(f32, 16, HALF_OF_16);
placed!(f64, 32, HALF_OF_32);
placed!(f32, 32, HALF_OF_32);
placed!(f64, 64, HALF_OF_64);
placed!(f32, 64, HALF_OF_64);

#[rustfmt::skip]
const HALF_OF_4: Half<2> = [
    [0.2113248654051871, 0.9774158793786193, 0.5],
    [0.7886751345948129, 0.6148101593759279, 0.5],
];

#[rustfmt::skip]
const HALF_OF_8: Half<4> = [
    [0.06943184420297371, 0.9975866974907865, 0.17392742256872692],
    [0.33000947820757187, 0.9439776185340234, 0.32607257743127305],
    [0.6699905217924281, 0.7423696523352162, 0.32607257743127305],
    [0.9305681557970263, 0.3661187067284618, 0.17392742256872692],
];

#[rustfmt::skip]
const HALF_OF_16: Half<8> = [
    [0.019855071751231884, 0.9998028686324887, 0.05061426814518813],
    [0.10166676129318664, 0.9948185109094795, 0.11119051722668724],
    [0.2372337950418355, 0.9714525858167492, 0.15685332293894363],
    [0.4082826787521751, 0.9128555494879506, 0.181341891689181],
    [0.591717321247825, 0.8061455276408215, 0.181341891689181],
    [0.7627662049581645, 0.6466743512570445, 0.15685332293894363],
    [0.8983332387068134, 0.43931468474719515, 0.11119051722668724],
    [0.9801449282487681, 0.19828242390140685, 0.05061426814518813],
];

#[rustfmt::skip]
const HALF_OF_32: Half<16> = [
    [0.005299532504175033, 0.999985957379021, 0.013576229705877048],
    [0.02771248846338371, 0.999615935238713, 0.031126761969323947],
    [0.06718439880608412, 0.9977405757796287, 0.04757925584124639],
    [0.12229779582249849, 0.99249345042522, 0.06231448562776694],
    [0.19106187779867811, 0.9815779942786222, 0.07479799440828837],
    [0.2709916111713863, 0.9625817090900576, 0.08457825969750127],
    [0.35919822461037054, 0.9332612900130155, 0.09130170752246179],
    [0.4524937450811813, 0.8917675765929186, 0.09472530522753425],
    [0.5475062549188188, 0.8368015898794465, 0.09472530522753425],
    [0.6408017753896295, 0.7677063791955222, 0.09130170752246179],
    [0.7290083888286137, 0.6845047618662041, 0.08457825969750127],
    [0.8089381222013219, 0.587893795212536, 0.07479799440828837],
    [0.8777022041775016, 0.47920646988741233, 0.06231448562776694],
    [0.9328156011939158, 0.36035406778505125, 0.04757925584124639],
    [0.9722875115366163, 0.2337883549493735, 0.031126761969323947],
    [0.994700467495825, 0.10281527106216887, 0.013576229705877048],
];

#[rustfmt::skip]
const HALF_OF_64: Half<32> = [
    [0.0026497662520875167, 0.9999964893632424, 0.006788114852938524],
    [0.013856244231691855, 0.9999039976396693, 0.015563380984661973],
    [0.03359219940304206, 0.9994356228088261, 0.023789627920623196],
    [0.06114889791124924, 0.9981286551763954, 0.03115724281388347],
    [0.09553093889933906, 0.9954264612280561, 0.037398997204144184],
    [0.13549580558569316, 0.9907779199541561, 0.042289129848750634],
    [0.17959911230518527, 0.9837398837391872, 0.045650853761230896],
    [0.22624687254059064, 0.9740699937199594, 0.047362652613767126],
    [0.2737531274594094, 0.9617999923093119, 0.047362652613767126],
    [0.32040088769481473, 0.9472820441475573, 0.045650853761230896],
    [0.36450419441430687, 0.9312017462689689, 0.042289129848750634],
    [0.40446906110066094, 0.9145516817612604, 0.037398997204144184],
    [0.4388511020887508, 0.8985597977850383, 0.03115724281388347],
    [0.4664078005969579, 0.884569818353706, 0.023789627920623196],
    [0.48614375576830815, 0.8738788524317793, 0.015563380984661973],
    [0.4973502337479125, 0.8675498515883089, 0.006788114852938524],
    [0.5026497662520876, 0.8644901459743319, 0.006788114852938524],
    [0.5138562442316918, 0.8578763082543426, 0.015563380984661973],
    [0.533592199403042, 0.8457419019631368, 0.023789627920623196],
    [0.5611488979112492, 0.8277148750463473, 0.03115724281388347],
    [0.5955309388993391, 0.8033323725667176, 0.037398997204144184],
    [0.6354958055856932, 0.7721043200779224, 0.042289129848750634],
    [0.6795991123051853, 0.733583701123467, 0.045650853761230896],
    [0.7262468725405906, 0.6874339823757705, 0.047362652613767126],
    [0.7737531274594094, 0.633487251447717, 0.047362652613767126],
    [0.8204008876948147, 0.5717887577327487, 0.045650853761230896],
    [0.8645041944143068, 0.5026256040434772, 0.042289129848750634],
    [0.9044690611006609, 0.4265392332619461, 0.037398997204144184],
    [0.9388511020887508, 0.3443234062719787, 0.03115724281388347],
    [0.966407800596958, 0.2570135462292803, 0.023789627920623196],
    [0.9861437557683082, 0.165893016607618, 0.015563380984661973],
    [0.9973502337479124, 0.07274964771725242, 0.006788114852938524],
];
