"""The second checker, verify.py: is a document written as the format has it, every key of every object, every number exact?

A type tells what an object holds, key by key. Nothing is passed over: no key that is not known or stands twice, no `1` for `true`, no
number in another spelling, nothing that is to be omitted where it is nothing.
"""
import re
from fractions import Fraction
from math import isfinite

PLACE = []  # where the checker is, for its answer

class Refused(Exception):
    """A claim that does not hold."""

class NoDocument(Exception):
    """A file that is no document of crankstar, or outside of what is checked."""

def demand(holds, why):
    if not holds:
        raise Refused(why)

class Entry(dict):
    """An object of a document: its keys as attributes, None for one that may be omitted and is."""
    def __getattr__(self, key):
        return self.get(key) if key in OPTIONAL else self[key]


TYPES, OPTIONAL = {}, set()  # {type: (the words it may be, the objects it may be)}, and the keys that may be omitted

def types(text):
    """`name = word word` or `name: key=type key=type` between semicolons, `name kind:` for the object of that kind. `[type]` is a list,
    `(type,type)` has one of each, `type?` may be null, `key?` may be omitted; `_` in a word is a space; a key without a type has the type of that name, or is an exact number."""
    for part in text.split(";"):
        head, mark, body = re.fullmatch(r"\s*([\w -]+?)\s*([=:])(.*)", part, re.DOTALL).groups()
        name, *kind = head.split()
        words, objects = TYPES.setdefault(name, (set(), []))
        if mark == "=":
            words.update(word.replace("_", " ") for word in body.split())
            continue
        needed, types_of = {"kind"} if kind else set(), {"kind": "text"} if kind else {}
        for key, _, of in (one.partition("=") for one in body.split()):
            bare = key.rstrip("?")
            types_of[bare] = of or (bare if bare in TYPES else "exact")
            (OPTIONAL if key != bare else needed).add(bare)
        objects.append((kind[0] if kind else None, needed, types_of))

def exact_of(text):
    demand(type(text) is str and len(text) <= 5000 and re.fullmatch("-?[0-9]+(/[1-9][0-9]*)?", text), f"{text!r} is no exact number")
    demand(str(Fraction(text)) == text, f"{text} is not in lowest terms")
    return Fraction(text)

PLAIN = {"truth": lambda value: type(value) is bool, "count": lambda value: type(value) is int and 0 <= value < 2**32,
         "sign": lambda value: type(value) is int, "decimal": lambda value: type(value) in (int, Decimal) and isfinite(float(value)),
         "size": lambda value: PLAIN["decimal"](value) and float(value) >= 0, "document": lambda value: type(value) is dict,
         "text": lambda value: type(value) is str and not re.search("[\ud800-\udfff]|^[0-9+/-]{5001,}\Z", value)}

def read(value, of, key="it"):
    """The value, which has to be written as its type is, with exact numbers as fractions."""
    if of[-1] == "?":
        return value if value is None else read(value, of[:-1], key)
    if of[0] == "[":
        return [read(one, of[1:-1], key) for one in each(key, value)]
    if of[0] == "(":
        return [read(one, inner, key) for inner, one in each(key, value, of[1:-1].split(","))]
    if of == "linear":  # an expression of a family: symbols with their coefficients, and the known part
        demand(type(value) is dict and "1" in value, f"{key} has no known part, under \"1\"")
        return {symbol: exact_of(number) for symbol, number in value.items()}
    if of in ("exact", "integer"):
        number = exact_of(value)
        demand(of == "exact" or number.denominator == 1, f"{key} is {number}, which is not whole")
        return number if of == "exact" else int(number)
    if of in PLAIN:
        demand(PLAIN[of](value), f"{key} is {value!r}, which is no {of}")
        return value
    words, objects = TYPES[of]
    if type(value) is str and value in words:
        return value
    demand(type(value) is dict and objects, f"{key} is {value!r}")
    forms = [(needed, types_of) for kind, needed, types_of in objects if kind in (None, value.get("kind"))]
    for needed, types_of in forms:
        lacks, more = sorted(needed - value.keys()), sorted(value.keys() - types_of.keys())
        if not lacks and not more:
            found = Entry((inner, read(entry, types_of[inner], inner)) for inner, entry in value.items())
            empty = [inner for inner in found if inner not in needed and not found[inner]]
            demand(not empty, f"{', '.join(empty)} is omitted where it is nothing")
            return found
    demand(len(forms) == 1, f"{key} has the keys {', '.join(value)}, which is none of its forms")
    raise Refused(f"{key} lacks {', '.join(lacks)}" if lacks else f"{key} has no key {', '.join(more)}")

def no_key_twice(pairs):
    if len(dict(pairs)) < len(pairs):
        raise ValueError("a key stands twice")
    return dict(pairs)

class Decimal:
    """A number with a point, which no verdict is made from."""
    def __init__(self, text):
        self.text = text

    def __repr__(self):
        return self.text

    def __float__(self):
        return float(self.text)

def harmless(text):
    """What a document says, as it may be printed: a terminal obeys what has no shape."""
    return "".join(one if one.isprintable() else one.encode("unicode_escape").decode() for one in text)

def each(name, entries, due=None):
    """The entries of a list, or each thing that is due with its entry; keeps the place."""
    due = entries if due is None else due
    demand(type(entries) is list and len(entries) == len(due), f"{len(entries)} {name} where {len(due)} are due")
    PLACE.append("")
    for index, (one, entry) in enumerate(zip(due, entries)):
        PLACE[-1] = f"{name}[{index}]"
        yield entry if due is entries else (one, entry)
    PLACE.pop()

def equal(entry, **due):
    for key, value in due.items():
        demand(entry[key] == value, f"{key} is {entry[key]}, and {value} is due")
