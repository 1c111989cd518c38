//! What can crank stars lose, and what never? The sentences of the theorems, and the page of all numbers of cylinders.

mod words;

pub(super) use words::told;
