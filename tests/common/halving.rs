//! Places where something changes, found by halving an interval.

/// Halves until the interval is `width` wide or its ends are neighbouring numbers; `is_low` says of
/// a number whether the place lies above it.
pub fn bisect(
    [mut low, mut high]: [f64; 2], width: f64, mut is_low: impl FnMut(f64) -> bool,
) -> [f64; 2] {
    while high - low > width {
        let middle = low + 0.5 * (high - low);
        if middle <= low || middle >= high {
            break;
        }
        if is_low(middle) { low = middle } else { high = middle }
    }
    [low, high]
}

/// The same, always into the half over which a function changes more, as long as it has values:
/// the lower end and the values at both. Of a jump all is left, of other changes nothing.
pub fn steepest<T: Copy>(
    ends: [f64; 2], [mut below, mut above]: [T; 2], width: f64,
    mut at: impl FnMut(f64) -> Option<T>, distance: impl Fn(T, T) -> f64,
) -> (f64, [T; 2]) {
    let [mut low, mut high] = ends;
    while high - low > width {
        let middle = low + 0.5 * (high - low);
        let own = if middle <= low || middle >= high { None } else { at(middle) };
        let Some(own) = own else { break };
        if distance(below, own) > distance(own, above) {
            (high, above) = (middle, own);
        } else {
            (low, below) = (middle, own);
        }
    }
    (low, [below, above])
}
