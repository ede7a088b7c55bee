//! A number of 200 bits that the library's own formulas can be evaluated with, to see what their
//! arithmetic loses in double and single precision.
//!
//! Constants and tables are those of double precision, exactly; square roots and logarithms are
//! good to 200 bits. The library's numbers are copied freely, so what has more digits than a double
//! is kept in a list of this thread, and a number is its place there.

use dashu_float::{FBig, round::mode::HalfEven};
use kstrip::number::lanes::Lanes;
use kstrip::number::{Arithmetic, Float, InRegisters, Number, Real, Strips};
use std::any::Any;
use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

const BITS: usize = 200;

pub type Digits = FBig<HalfEven, 2>;

thread_local! {
    static KEPT: RefCell<Vec<Digits>> = const { RefCell::new(Vec::new()) };
    /// Tables by their address.
    static TABLES: RefCell<HashMap<(usize, usize, usize), &'static dyn Any>> =
        RefCell::new(HashMap::new());
}

#[derive(Clone, Copy, Debug)]
pub enum Precise {
    Double(f64),
    Kept(usize),
}

impl Default for Precise {
    fn default() -> Self {
        Self::Double(0.0)
    }
}

impl Precise {
    /// Forgets every number that is kept: none may be used any more.
    pub fn forget() {
        KEPT.with_borrow_mut(Vec::clear);
    }

    pub fn digits(self) -> Digits {
        match self {
            Self::Double(x) => {
                let exact = Digits::try_from(x).unwrap_or_else(|_| panic!("{x} is no number"));
                exact.with_precision(BITS).value()
            }
            Self::Kept(place) => KEPT.with_borrow(|kept| kept[place].clone()),
        }
    }

    fn keep(digits: Digits) -> Self {
        KEPT.with_borrow_mut(|kept| {
            kept.push(digits);
            Self::Kept(kept.len() - 1)
        })
    }

    /// `(value − self)/unit`
    pub fn distance(self, value: f64, unit: f64) -> f64 {
        let difference = (Self::Double(value) - self).digits();
        (difference / Self::Double(unit).digits()).to_f64().value()
    }
}

macro_rules! operators {
    ($($operator:ident $function:ident),*) => {
        $(impl $operator for Precise {
            type Output = Self;
            fn $function(self, other: Self) -> Self {
                Self::keep($operator::$function(self.digits(), other.digits()))
            }
        })*
    };
}

operators!(Add add, Sub sub, Mul mul);

/// By zero it is zero: formulas that are not chosen may ask for it.
impl Div for Precise {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other == Self::Double(0.0) { other } else { Self::keep(self.digits() / other.digits()) }
    }
}

impl AddAssign for Precise {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Precise {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Neg for Precise {
    type Output = Self;
    fn neg(self) -> Self {
        Self::keep(-self.digits())
    }
}

impl PartialEq for Precise {
    fn eq(&self, other: &Self) -> bool {
        self.digits() == other.digits()
    }
}

impl PartialOrd for Precise {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        self.digits().partial_cmp(&other.digits())
    }
}

impl Arithmetic for Precise {
    type Value = Self;

    fn constant(x: f64) -> Self {
        Self::Double(x)
    }
    fn tiny() -> Self {
        Self::TINY
    }
    fn from_base(x: Self) -> Self {
        x
    }
    fn value(self) -> Self {
        self
    }
    fn composed<const N: usize>(value: Self, _: [Self; N], _: [Self; N]) -> Self {
        value
    }
    fn scale(self, factor: Self) -> Self {
        self * factor
    }
    fn shift(self, term: Self) -> Self {
        self + term
    }
    /// Of a negative number zero: formulas that are not chosen may ask for it.
    fn sqrt(self) -> Self {
        if self < Self::zero() { Self::zero() } else { Self::keep(self.digits().sqrt()) }
    }
    fn abs(self) -> Self {
        if self < Self::zero() { -self } else { self }
    }
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    fn choose(self, yes: Self, no: Self) -> Self {
        if self > Self::zero() { yes } else { no }
    }
}

impl Number for Precise {
    type Base = Self;
    type Pair = Lanes<Self, 2>;
    const LARGEST: Self = Self::Double(f64::LARGEST);
    const TINY: Self = Self::Double(f64::TINY);
    const ROOT_TINY: Self = Self::Double(f64::ROOT_TINY);
    const HUGE: Self = Self::Double(f64::HUGE);
    const EPSILON: Self = Self::Double(f64::EPSILON);

    fn exceeds(self, other: Self) -> bool {
        self > other
    }
}

impl Real for Precise {
    type Four = Lanes<Self, 4>;
    type Eight = Lanes<Self, 8>;
    type WideFour = Self::Four;
    type WideEight = Self::Eight;
    type WideRow = Lanes<Self, 1>;
    type WideSixteen = Lanes<Self, 16>;
    type Stored = Self;

    fn stored(x: Self) -> Self {
        x
    }
    fn binary_quotient(self, _: Self) -> (Self, Self) {
        unreachable!("the logarithm of a quotient is computed without it")
    }
    fn ln_quotient(self, divisor: Self) -> Self {
        (self / divisor).ln()
    }
    fn ln_quotients<P: Strips<Self>>(x: P, divisor: Self) -> P {
        P::gather(|i| x.lane(i).ln_quotient(divisor))
    }
    fn atan_of_unit(self) -> Self {
        self.atan()
    }
    fn lies_between(self, low: Self, high: Self) -> bool {
        self >= low && self <= high
    }
}

impl InRegisters for Precise {
    fn any_exceeds<const N: usize>(a: [Self; N], b: [Self; N]) -> bool {
        a.iter().zip(&b).any(|(a, b)| a > b)
    }
    fn all_between<const N: usize>(a: [Self; N], low: [Self; N], high: [Self; N]) -> bool {
        (0..N).all(|k| a[k] >= low[k] && a[k] <= high[k])
    }
}

impl Float for Precise {
    type Contacts = Lanes<Self, 2>;
    type WideContacts = Lanes<Self, 2>;
    const ZERO: Self = Self::Double(0.0);
    const ARTANH: &'static [Self] = &[];
    const ARCTAN: &'static [Self] = &[];

    fn widened(x: f32) -> Self {
        Self::Double(x.into())
    }
    /// No kernel with two hundred bits inverts a matrix.
    fn inverse_of_normal(_: nalgebra::Matrix6<Self>) -> Option<nalgebra::Matrix6<Self>> {
        None
    }
    fn to_f64(self) -> f64 {
        self.digits().to_f64().value()
    }
    fn whole(self) -> i32 {
        self.to_f64() as i32
    }
    fn is_finite_number(self) -> bool {
        true
    }
    fn cube_root(self) -> Self {
        Self::keep(self.digits().nth_root(3))
    }
    fn exp(self) -> Self {
        Self::keep(self.digits().exp())
    }
    fn atan(self) -> Self {
        Self::keep(self.digits().atan())
    }
    fn ln(self) -> Self {
        Self::keep(self.digits().ln())
    }
    fn table<const R: usize, const C: usize>(
        _: &'static [[f32; C]; R], double: &'static [[f64; C]; R],
    ) -> &'static [[Self; C]; R] {
        TABLES.with_borrow_mut(|tables| {
            let table = *tables.entry((double.as_ptr().addr(), R, C)).or_insert_with(|| {
                let table: Box<[[Self; C]; R]> = Box::new(double.map(|row| row.map(Self::Double)));
                Box::leak(table)
            });
            table.downcast_ref().expect("one size at one address")
        })
    }
}
