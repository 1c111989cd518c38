//! Which operations does the motion of an engine need of its numbers?

/// A kind of number: floats, intervals, or either with its derivative.
pub(super) trait Real: Clone {
    fn zero_like(&self) -> Self;
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    /// The square root of a number that is not negative.
    fn root(&self) -> Self;
    /// The reciprocal of a positive number.
    fn inverse(&self) -> Self;
    /// Divided by a positive whole number.
    fn over(&self, divisor: u32) -> Self;

    fn squared(&self) -> Self {
        self.times(self)
    }
}

/// Cosine and sine of `|x| ≤ π/4` by their series, nested: `cos x = 1 − x²/(1·2) (1 − x²/(3·4) (…))`.
///
/// `innermost` stands for the brackets omitted: 1, or an interval that encloses them.
pub(super) fn cos_sin<T: Real>(x: &T, one: &T, innermost: &T, brackets: u32) -> [T; 2] {
    let square = x.squared();
    let nested = |first: u32| {
        (0..brackets).rev().fold(innermost.clone(), |bracket, place| {
            let divisor = (2 * place + first) * (2 * place + first + 1);
            one.minus(&square.times(&bracket).over(divisor))
        })
    };
    [nested(1), x.times(&nested(2))]
}

/// Cosine and sine of an angle that is some quarters of a turn farther.
pub(super) fn turned<T>([cos, sin]: [T; 2], quarters: i64, minus: impl Fn(T) -> T) -> [T; 2] {
    match quarters.rem_euclid(4) {
        0 => [cos, sin],
        1 => [minus(sin), cos],
        2 => [minus(cos), minus(sin)],
        _ => [sin, minus(cos)],
    }
}
