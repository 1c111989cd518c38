"""Decides exactly how a reciprocating engine balances, and writes the proof."""

from ._crankstar import (
    Answer,
    Checked,
    CrankstarError,
    Engine,
    LayoutError,
    ProofError,
    Remedy,
    Star,
    Verdict,
    Verdicts,
    __version__,
    catalogue,
    compare,
    search,
    values,
    verify,
)

__all__ = [
    "Answer",
    "Checked",
    "CrankstarError",
    "Engine",
    "LayoutError",
    "ProofError",
    "Remedy",
    "Star",
    "Verdict",
    "Verdicts",
    "__version__",
    "catalogue",
    "compare",
    "search",
    "values",
    "verify",
]
