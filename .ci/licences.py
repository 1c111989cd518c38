"""Is every dependency under a licence that deny.toml allows, and from the registry? Reads what `cargo metadata` prints."""

import json
import re
import sys
import tomllib

with open("deny.toml", "rb") as file:
    allowed = set(tomllib.load(file)["licenses"]["allow"])


def is_allowed(expression: str) -> bool:
    """Of an expression of SPDX, `/` for OR as old crates write it; AND binds more tightly than OR."""
    words = re.findall(r"\(|\)|[^\s()/]+|/", expression)
    place = 0

    def either() -> bool:
        nonlocal place
        found = both()
        while place < len(words) and words[place] in ("OR", "/"):
            place += 1
            found = both() or found
        return found

    def both() -> bool:
        nonlocal place
        found = one()
        while place < len(words) and words[place] == "AND":
            place += 1
            found = one() and found
        return found

    def one() -> bool:
        nonlocal place
        if words[place] == "(":
            place += 1
            found = either()
            place += 1
            return found
        name = words[place]
        place += 1
        if place < len(words) and words[place] == "WITH":
            name += f" WITH {words[place + 1]}"
            place += 2
        return name in allowed

    return either()


for expression, right in [
    ("MIT", True),
    ("MIT/Apache-2.0", True),
    ("GPL-3.0", False),
    ("GPL-3.0 OR MIT", True),
    ("GPL-3.0 AND MIT", False),
    ("(GPL-3.0 OR MIT) AND Unicode-3.0", True),
    ("MIT OR GPL-3.0 AND GPL-2.0", True),
    ("Apache-2.0 WITH LLVM-exception", True),
    ("Apache-2.0 WITH no-exception", False),
]:
    assert is_allowed(expression) == right, expression

wrong = 0
packages = json.load(sys.stdin)["packages"]
dependencies = [package for package in packages if package["source"] is not None]
for package in dependencies:
    told = f"{package['name']} {package['version']}"
    if not package["license"] or not is_allowed(package["license"]):
        print(f"{told}: the licence {package['license']} is not in deny.toml", file=sys.stderr)
        wrong += 1
    if not package["source"].startswith("registry+https://github.com/rust-lang/"):
        print(f"{told} is from {package['source']}", file=sys.stderr)
        wrong += 1
print(f"{len(dependencies)} dependencies, {wrong} that deny.toml does not allow")
sys.exit(wrong > 0 or not dependencies)
