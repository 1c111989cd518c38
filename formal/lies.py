"""Turns theorems on an engine round, for coqc to refuse: `python3 lies.py NAME.v > lies.v`.

The file that it writes builds on NAME.v. It states each theorem that it makes false once more as it is, with its proof, and then the false one, whose
proof must fail: the one difference between the two is what fails.
"""

import re
import sys

BLOCK = re.compile(r"^Theorem (\w+) :\n(.*?)\nProof\. (.*?) Qed\.$", re.M | re.S)

# What `vanishes` proves says `= 0`: the statement alone is turned round, then statement and lemma. Of every order another modulus is told of
# residues (of none it would be as true), then, in statement and lemma, that a sum vanishes at all orders of a kind.
ON_VECTORS = [
    (r"[^>] = 0%R\.$", [("s", r"= 0%R\.$", "<> 0%R.")]),
    (r"[^>] = 0%R\.$", [("s", r"= 0%R\.$", "<> 0%R."), ("p", r"@vanishes ", "@is_left ")]),
    (r"<> 0%R\.$", [("s", r"<> 0%R\.$", "= 0%R.")]),
    (r"<> 0%R\.$", [("s", r"<> 0%R\.$", "= 0%R."), ("p", r"@is_left ", "@vanishes ")]),
    (r"<-> \(k mod \d+\) \\\w+ \(\[", [("s", r"\(k mod \d+\)", "(k mod 17)")]),
    (r"\\notin \(nil :", [("s", r"\\notin \(nil :", r"\\notin ([:: 0] :"), ("p", r"^(    [0-9 ]*) nil$", r"\1 [:: 0]")]),
]
# Of the exact motion another turn, in the statement, then in statement and lemma.
ON_MOTION = [
    (r"radians \(1 # \d+\)", [("s", r"radians \(1 # \d+\)", "radians (1 # 7)")]),
    (
        r"radians \(1 # \d+\)",
        [("s", r"\(1 # \d+\)( [/r])", r"(1 # 7)\1"), ("p", r"\(1 # \d+\)( [/r])", r"(1 # 7)\1"), ("p", r" \(1 # \d+\) (\d* \d* \()", r" (1 # 7) \1")],
    ),
]
# A force of one order: what it says of every number c and every crank angle, or of some, is said the other way.
ON_FORCES = [
    (r"^  forall \(c : R \* R\) \(theta : R\), (.*) = (.*)\.$", r"  forall c : R * R, c <> (0, 0) -> exists theta : R, \1 <> \2."),
    (r"^  forall c : R \* R, c <> \(0, 0\) -> exists theta : R, (.*) <> (.*)\.$", r"  forall (c : R * R) (theta : R), \1 = \2."),
    (r"^  forall \((c_.*) : R \* R\) \(theta : R\), (.*) = (.*)\.$", r"  forall \1 : R * R, exists theta : R, \2 <> \3."),
    (r"^  forall theta : R, (.*) = (.*)\.$", r"  exists theta : R, \1 <> \2."),
    (r"^  exists theta : R, (.*) <> (.*)\.$", r"  forall theta : R, \1 = \2."),
]


def changed(text, pattern, by):
    """The text with every match replaced; there is one."""
    new, count = re.subn(pattern, by, text, flags=re.M)
    if count == 0 or new == text:
        sys.exit(f"nothing was made false by {pattern}")
    return new


def turned_round(theorems, lies):
    """Each lie on the first theorem that it is about: the theorem's name, then statement and proof."""
    for about, changes in lies:
        found = next((one for one in theorems if re.search(about, one[1], re.M)), None)
        if found is None:
            continue
        name, statement, proof = found
        for part, pattern, by in changes:
            if part == "s":
                statement = changed(statement, pattern, by)
            else:
                proof = changed(proof, pattern, by)
        yield name, statement, proof


def forces_turned_round(theorems):
    """Every theorem on a force of one order."""
    for name, statement, proof in theorems:
        if not re.fullmatch(r"real_.*_order_\d+", name):
            continue
        for pattern, by in ON_FORCES:
            if re.search(pattern, statement):
                yield name, changed(statement, pattern, by), proof
                break
        else:
            sys.exit(f"{name}: its statement is of no known kind")


def stated(theorems, lies):
    """The theorems that are made false as they are, and the false ones, which fail."""
    known = {name: (statement, proof) for name, statement, proof in theorems}
    lines, true = [], set()
    for number, (name, statement, proof) in enumerate(lies):
        if name not in true:
            true.add(name)
            lines.append("Theorem true_{} :\n{}\nProof. {} Qed.".format(name, *known[name]))
        lines.append(f"Theorem false_{number}_{name} :\n{statement}\nProof. Fail {proof} Abort.")
    return lines


def main():
    path = sys.argv[1]
    name = path.removesuffix(".v")
    with open(path) as file:
        text = file.read()
    # Forces have scopes of their own, which are opened after the section of the vectors.
    vectors, forces = text.split("End Verdicts.\n")
    opened = [re.findall(r"^(?:From|Local Open|Section|Variables).*$", part, re.M) for part in (vectors, forces)]
    on_vectors, on_forces = ([match.groups() for match in BLOCK.finditer(part)] for part in (vectors, forces))
    lies = list(turned_round(on_vectors, ON_VECTORS))
    lies_on_forces = [*turned_round(on_forces, ON_MOTION), *forces_turned_round(on_forces)]
    if not lies or not lies_on_forces:
        sys.exit(f"{path}: no false verdict is tried")
    print("\n".join(opened[0][:-2] + [f"From Crankstar Require Import {name}."] + opened[0][-2:]))
    print("\n".join(stated(on_vectors, lies)))
    print("End Verdicts.")
    print("\n".join(opened[1] + stated(on_forces, lies_on_forces)))


main()
