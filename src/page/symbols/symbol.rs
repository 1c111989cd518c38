//! Which symbols of the pages can have another name?

/// A symbol of the pages that can have another name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Symbol {
    /// The key of the file.
    pub key: &'static str,
    /// A command of TeX, or a letter that has an index.
    pub tex: &'static str,
    /// The letter in words.
    pub letter: char,
    /// Whether the letter means the symbol only before an index.
    pub has_index: bool,
}

const fn greek(key: &'static str, tex: &'static str, letter: char) -> Symbol {
    Symbol { key, tex, letter, has_index: false }
}

const fn indexed(key: &'static str, tex: &'static str, letter: char) -> Symbol {
    Symbol { key, tex, letter, has_index: true }
}

pub(super) const SYMBOLS: [Symbol; 18] = [
    greek("alpha", "alpha", 'α'),
    greek("beta", "beta", 'β'),
    greek("gamma", "gamma", 'γ'),
    greek("delta", "delta", 'δ'),
    greek("theta", "theta", 'θ'),
    greek("lambda", "lambda", 'λ'),
    greek("rho", "rho", 'ρ'),
    greek("phi", "varphi", 'φ'),
    greek("psi", "psi", 'ψ'),
    greek("omega", "omega", 'ω'),
    indexed("c_k", "c", 'c'),
    indexed("t_k", "t", 't'),
    indexed("C_k", "C", 'C'),
    indexed("F_k", "F", 'F'),
    indexed("M_k", "M", 'M'),
    indexed("P_k", "P", 'P'),
    indexed("Q_k", "Q", 'Q'),
    indexed("V_k", "V", 'V'),
];
