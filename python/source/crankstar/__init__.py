"""Decides exactly how a reciprocating engine balances, and writes the proof."""

from ._crankstar import *
from ._crankstar import __version__ as __version__
