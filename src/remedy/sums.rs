//! What is a vector with coefficients of the motion in it? One exact sum for each coefficient.

use num_complex::Complex;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::exact::{PhasorSum, Turn};
use crate::layout::{Layout, Rod};
use crate::loads::{self, Factor, Missing, Parts, Weighing};
use crate::motion::SliderCrank;
use crate::numbers::{self, Direction, Form};
use crate::proof::Sense;

/// `Σ coefficient · sum`, in multiples of m r: none is the coefficient 1, else c_k of a rod. Sums that are zero are left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sums(Parts);

impl Sums {
    fn new(parts: impl IntoIterator<Item = (Factor, PhasorSum)>) -> Self {
        let collected = parts.into_iter().map(|(factor, sum)| (factor, PhasorSum::new(sum.collected())));
        Sums(collected.filter(|(_, sum)| !sum.vanishes()).collect())
    }

    /// A sum whose coefficient is 1.
    pub fn plain(sum: PhasorSum) -> Self {
        Sums::new([(None, sum)])
    }

    /// The sums with their coefficients.
    pub fn parts(&self) -> &Parts {
        &self.0
    }

    /// Whether the vector is zero, whatever the coefficients are.
    pub fn vanishes(&self) -> bool {
        self.0.is_empty()
    }

    /// The sum of both.
    pub fn plus(&self, other: &Sums) -> Sums {
        let mut all = self.0.clone();
        for (factor, sum) in &other.0 {
            all.entry(factor.clone()).and_modify(|there| *there = there.plus(sum)).or_insert_with(|| sum.clone());
        }
        Sums::new(all)
    }

    /// A multiple.
    pub fn scaled(&self, by: &BigRational) -> Sums {
        Sums::new(self.0.iter().map(|(factor, sum)| (factor.clone(), sum.scaled(by))))
    }

    /// The first less the second.
    pub fn minus(&self, other: &Sums) -> Sums {
        self.plus(&other.scaled(&-BigRational::one()))
    }

    /// The one sum with its coefficient; `None` where there are several, or none.
    pub fn only(&self) -> Option<(&Factor, &PhasorSum)> {
        let mut parts = self.0.iter();
        parts.next().filter(|_| parts.next().is_none())
    }

    /// The length in closed form, in multiples of m r, and of |c_k| where [`Sums::only`] names a rod.
    pub fn modulus(&self) -> Option<Form> {
        match self.only() {
            Some((_, sum)) => numbers::modulus(sum),
            None => self.vanishes().then(|| Form::rational(BigRational::zero())),
        }
    }

    /// The direction in closed form; `None` where it is none, or where a coefficient that is not real turns it.
    pub fn direction(&self, order: u32) -> Option<Direction> {
        let (factor, sum) = self.only()?;
        match factor {
            None => numbers::direction_of(sum),
            // c_2, c_6, … are above 0, c_4, c_8, … below (theory, section 2).
            Some(rod) if rod.offset.is_zero() && order.is_multiple_of(4) => {
                numbers::direction_of(&sum.turned(&Turn::fraction(1, 2)))
            }
            Some(rod) if rod.offset.is_zero() => numbers::direction_of(sum),
            Some(_) => None,
        }
    }
}

/// An engine as remedies see it: its rods may be unknown, then c_k stays a symbol.
#[derive(Clone, Debug)]
pub struct Subject {
    layout: Layout,
    rods_known: bool,
}

impl Subject {
    /// The engine of this layout.
    ///
    /// # Errors
    /// What the layout lacks for its masses to be compared.
    pub fn new(layout: &Layout) -> Result<Self, Missing> {
        loads::comparable(layout)?;
        let mut layout = layout.clone();
        let rods_known = !layout.mechanism.rods.is_empty();
        if !rods_known {
            // The sums are the same for every rod ratio; only the coefficients, which stay symbols, are not.
            let rod = Rod { ratio: BigRational::new(1.into(), 4.into()), offset: BigRational::zero() };
            layout.mechanism.rods = vec![rod; layout.cylinders.len()];
        }
        Ok(Subject { layout, rods_known })
    }

    /// The layout; its rods are made up where it names none.
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Whether the layout names its rods.
    pub fn rods_known(&self) -> bool {
        self.rods_known
    }

    /// The vector of one order and sense, each force weighed by its position.
    pub fn sums(&self, weighing: Weighing, order: u32, sense: Sense) -> Sums {
        Sums::new(loads::sums(&self.layout, weighing, order, sense))
    }

    /// The force of one order and sense.
    pub fn force(&self, order: u32, sense: Sense) -> Sums {
        self.sums(&|_| BigRational::one(), order, sense)
    }

    /// Its moment about position 0.
    pub fn moment(&self, order: u32, sense: Sense) -> Sums {
        self.sums(&BigRational::clone, order, sense)
    }

    /// A vector in multiples of m r; `None` where its coefficient is not known.
    pub fn value(&self, sums: &Sums, order: u32, sense: Sense) -> Option<Complex<f64>> {
        let term = |(factor, sum): (&Factor, &PhasorSum)| {
            let coefficient = match factor {
                None => Complex::new(1.0, 0.0),
                Some(_) if !self.rods_known => return None,
                Some(rod) => {
                    SliderCrank::new(rod.ratio.clone(), rod.offset.clone()).ok()?.coefficient(order).to_complex()
                }
            };
            let coefficient = if sense == Sense::Reverse { coefficient.conj() } else { coefficient };
            Some(coefficient * numbers::evaluate(sum))
        };
        sums.parts().iter().map(term).sum()
    }

    /// m r in kilogram-metres, and r in metres; `None` where the layout does not give them.
    pub fn scale(&self) -> Option<[BigRational; 2]> {
        let radius = self.layout.mechanism.crank_radius.clone()?;
        self.layout.mechanism.mass.as_ref()?;
        Some([loads::unit_mass(&self.layout) * &radius, radius])
    }
}
