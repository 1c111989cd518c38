"""Decides exactly how a reciprocating engine balances, and writes the proof."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from os import PathLike
from typing import Any, Literal, TypeAlias, final

import numpy as np
from numpy.typing import NDArray
from typing_extensions import disjoint_base

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
    "flywheel",
    "moments",
    "rotor",
    "search",
    "values",
    "verify",
]

__version__: str

# A number, taken exactly as Python shows it; a str may have a unit: "22.5 deg", "3/2", "90 mm".
_Number: TypeAlias = int | float | str | Fraction | Decimal | np.number[Any]
_Numbers: TypeAlias = Iterable[_Number] | NDArray[Any]
_Orders: TypeAlias = int | Iterable[int] | NDArray[Any]
# "0..180:10", "80..120:5 mm", or from, to and step.
_Range: TypeAlias = str | tuple[_Number, _Number, _Number]
_Key: TypeAlias = _Number | bool | None | Iterable[Any] | Mapping[str, Any]
# A column: decimals (nan where there is nothing to say), whole numbers and truths as arrays; texts, and what has gaps, as lists.
_Column: TypeAlias = NDArray[np.float64] | NDArray[np.int64] | NDArray[np.bool_] | list[Any]
_Columns: TypeAlias = dict[str, _Column]
_Format: TypeAlias = Literal["markdown", "html", "latex", "typst", "text"]
# The code of a list of words, such as "de"; of another one the error says which there are.
_Language: TypeAlias = str

class CrankstarError(ValueError):
    """What was asked for cannot be answered; the message says what would be right."""

class LayoutError(CrankstarError):
    """A layout that cannot be read; its text is that of the command line."""

    message: str
    right: str
    file: str
    line: int | None
    column: int | None

class ProofError(CrankstarError):
    """A document that the checker does not accept."""

    place: str | None

@final
class Star:
    """One vector star `S = Σ weight · e^{2πi·angle}`, a term for each source of force."""

    @property
    def sense(self) -> Literal["direct", "reverse"] | None: ...
    @property
    def vanishes(self) -> bool: ...
    @property
    def exact(self) -> str | None: ...
    @property
    def value(self) -> float: ...
    @property
    def angle_deg(self) -> float | None: ...
    @property
    def terms(self) -> list[tuple[Fraction, Fraction]]: ...
    @property
    def certificate(self) -> dict[str, Any]: ...

@final
class Verdict:
    """The residual of one quantity of one order."""

    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Verdict: ...
    def __deepcopy__(self, _memo: Any, /) -> Verdict: ...
    @property
    def quantity(self) -> Literal["force", "moment", "torque", "roll"]: ...
    @property
    def order(self) -> int: ...
    @property
    def exists(self) -> bool: ...
    @property
    def vanishes(self) -> bool | None: ...
    @property
    def shape(
        self,
    ) -> Literal["balanced", "rotating", "counter-rotating", "planar", "elliptical", "not decided", "does not exist"] | None: ...
    @property
    def exact(self) -> str | None: ...
    @property
    def value(self) -> float | None: ...
    @property
    def is_couple(self) -> bool | None: ...
    @property
    def of(self) -> str | None: ...
    @property
    def text(self) -> str: ...
    @property
    def tex(self) -> str: ...
    @property
    def stars(self) -> list[Star]: ...
    @property
    def parts(self) -> list[Verdict]: ...

@final
class Verdicts:
    """The verdicts on an engine, order by order: a sequence."""

    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Verdicts: ...
    def __deepcopy__(self, _memo: Any, /) -> Verdicts: ...
    def __len__(self) -> int: ...
    def __getitem__(self, index: int, /) -> Verdict: ...
    def __iter__(self) -> Iterator[Verdict]: ...
    def of(self, quantity: str, order: int) -> Verdict: ...
    @property
    def pistons(self) -> list[Verdict] | None: ...
    @property
    def columns(self) -> _Columns: ...
    @property
    def tables(self) -> dict[str, _Columns]: ...
    @property
    def about(self) -> dict[str, dict[str, tuple[str, str]]]: ...
    @property
    def json(self) -> str: ...
    def document(self) -> dict[str, Any]: ...
    def _repr_html_(self) -> str: ...
    def _repr_latex_(self) -> str: ...

@disjoint_base
class Answer:
    """An answer: its columns, its document, its page."""

    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Answer: ...
    def __deepcopy__(self, _memo: Any, /) -> Answer: ...
    @property
    def columns(self) -> _Columns: ...
    @property
    def tables(self) -> dict[str, _Columns]: ...
    @property
    def about(self) -> dict[str, dict[str, tuple[str, str]]]: ...
    @property
    def json(self) -> str: ...
    def document(self) -> dict[str, Any]: ...
    def report(self, format: _Format = "markdown", *, language: _Language = "en") -> str: ...
    def figure(self, name: str) -> str: ...
    def _repr_html_(self) -> str: ...

@final
class Remedy(Answer):
    """Counterweights and balancer shafts that balance an engine; its main table is the weights."""

    @property
    def holds(self) -> bool: ...
    @property
    def layout(self) -> str: ...

@final
class Checked:
    """What a check that found nothing wrong was about."""

    @property
    def title(self) -> str: ...
    @property
    def certificates(self) -> int: ...
    @property
    def polygons(self) -> int: ...
    @property
    def residues(self) -> int: ...
    @property
    def splittings(self) -> int: ...
    @property
    def decimals(self) -> int: ...
    @property
    def orders(self) -> list[str]: ...
    @property
    def quantities(self) -> list[str]: ...
    @property
    def masses(self) -> list[str]: ...
    @property
    def wholes(self) -> int: ...
    @property
    def open_wholes(self) -> int: ...
    @property
    def shapes(self) -> int: ...
    @property
    def theorems(self) -> int: ...
    @property
    def not_covered(self) -> list[str]: ...

@final
class Engine:
    """An engine: its cylinders with exact angles and positions, and what else its layout says."""

    def __eq__(self, other: object, /) -> bool: ...
    def __hash__(self) -> int: ...
    def __copy__(self) -> Engine: ...
    def __deepcopy__(self, _memo: Any, /) -> Engine: ...
    def __new__(
        cls,
        title: str | None = None,
        *,
        throws: _Numbers | None = None,
        banks: _Numbers | None = None,
        positions: _Numbers | None = None,
        masses: _Numbers | None = None,
        names: Iterable[str | int] | None = None,
        **keys: _Key,
    ) -> Engine: ...
    @staticmethod
    def named(name: str) -> Engine: ...
    @staticmethod
    def parse(text: str, name: str = "layout") -> Engine: ...
    @staticmethod
    def read(path: str | PathLike[str]) -> Engine: ...
    @property
    def title(self) -> str: ...
    @property
    def layout(self) -> str: ...
    @property
    def usual_orders(self) -> list[int]: ...
    def __len__(self) -> int: ...
    def classify(
        self,
        orders: _Orders | None = None,
        *,
        masses: Literal["reciprocating", "rotating", "counterweights", "all"] | None = None,
        torque: bool = False,
        all_orders: bool = False,
    ) -> Verdicts:
        """Does force or moment vanish, order by order, and what is the residual? Orders from 1 to 1000; the usual ones where omitted."""
    def loads(self, orders: _Orders | None = None) -> Answer:
        """Forces in N, moments and torques in N m where the layout gives masses, a crank radius and a speed; amplitudes zero to peak."""
    def bearings(self, orders: _Orders | None = None) -> Answer:
        """What the main bearings feel, in N where the layout gives masses, a crank radius and a speed."""
    def remedy(
        self,
        orders: _Orders | None = None,
        *,
        planes: _Numbers | None = None,
        balance_factor: _Number | _Numbers | None = None,
        skew: _Number | _Numbers | None = None,
        radius: str | None = None,
    ) -> Remedy: ...
    def firing(
        self,
        orders: _Number | _Numbers | None = None,
        *,
        mode_shape: _Numbers | None = None,
    ) -> Answer: ...
    def mounts(
        self,
        orders: _Number | _Numbers | None = None,
        speed: float | None = None,
        start: float | None = None,
        end: float | None = None,
    ) -> Answer:
        """The engine on its mounts: modes, what each order moves and what the mounts pass on, the torque-roll axis; needs `[block]` and
        `[[mount]]` in the layout.

        orders: such as [0.5, 1, 2]; those up to 6 where omitted. speed: in place of that of the layout, in rpm; start and end: the range of
        speeds, from a tenth of its end to the speed where omitted.
        """
    def torsion(self, orders: _Number | _Numbers | None = None, *, misfire: str | None = None) -> Answer:
        """Natural frequencies, critical speeds, and with damping what every order twists; needs `[torsion]` in the layout.

        misfire: the name of a cylinder that does not fire.
        """
    def angle(
        self,
        at: Iterable[float] | None = None,
        *,
        every: float | None = None,
        gravity: float | None = None,
    ) -> Answer:
        """Motion, forces and torque of every piston at crank angles, in degrees; each tenth where none is named."""
    def torque(self, *, misfire: str | None = None) -> Answer:
        """The torque of gas and inertia in N m; needs `[gas]` in the layout.

        misfire: the name of a cylinder that does not fire.
        """
    def accuracy(self, rod_ratios: _Number | _Numbers | None = None, *, timing: bool = True) -> Answer:
        """The largest loads by several methods, each with error, guarantee and time."""
    def optimise(self, orders: _Orders | None = None, *, couple: _Number | None = None, points: int = 9) -> Answer:
        """For each mass of the crankshaft the counterweights with the least bearing load."""
    def sweep(
        self,
        ranges: dict[str, _Range] | None = None,
        *,
        bank_angle: _Range | None = None,
        pin_split: _Range | None = None,
        spacing: _Range | None = None,
        rod_ratio: _Range | None = None,
        balance_factor: _Range | None = None,
        speed: _Range | None = None,
        orders: _Orders | None = None,
        firing_orders: _Number | _Numbers | None = None,
        values: Sequence[str] | None = None,
    ) -> Answer: ...
    def report(
        self,
        format: _Format = "markdown",
        *,
        orders: _Orders | None = None,
        language: _Language = "en",
    ) -> str: ...
    def report_files(
        self,
        format: _Format = "markdown",
        *,
        orders: _Orders | None = None,
        language: _Language = "en",
    ) -> list[tuple[str, str]]: ...
    def figure(self, name: str) -> str: ...
    def _repr_html_(self) -> str: ...
    def _repr_latex_(self) -> str: ...

def catalogue() -> list[str]: ...
def compare(engines: Sequence[Engine], orders: _Orders | None = None, *, values: Sequence[str] | None = None) -> Answer: ...
def moments(engines: Sequence[Engine]) -> Answer:
    """External moments and guide-force moments in kN m, as a maker's project guide lists them."""
def rotor(text: str) -> Answer:
    """The masses that balance a shaft, of a file of [[mass]] tables; what it omits is found."""
def flywheel(text: str) -> Answer:
    """The fluctuation of energy of a turning-moment diagram, and its flywheel."""
def values(engines: Sequence[Engine], names: Sequence[str], *, files: Sequence[str] | None = None) -> Answer: ...
def search(
    cylinders: int,
    cycle: Literal["two-stroke", "four-stroke"],
    *,
    orders: _Orders | None = None,
    bank_angle: _Number | None = None,
    directions: int | None = None,
    grid: int | None = None,
    neighbours: bool = False,
    pin_split: _Number | None = None,
    bank_offset: _Number | None = None,
    minor_orders: _Number | _Numbers | None = None,
    torsion: bool = False,
    mode_shape: _Numbers | None = None,
    limits: dict[int, _Number] | None = None,
    sizes: Engine | None = None,
    resume: str | PathLike[str] | None = None,
    threads: int | None = None,
) -> Answer: ...
def verify(document: str | bytes | Mapping[str, Any]) -> Checked: ...
