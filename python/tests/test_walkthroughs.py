"""Does what docs/walkthroughs.md does in Python run, over fewer points?"""

import os
from pathlib import Path

ROOT = Path(__file__).parents[2]


def test_the_sweep_of_the_walkthrough_makes_a_data_frame() -> None:
    page = (ROOT / "docs/walkthroughs.md").read_text(encoding="utf-8")
    code = page.split("```python\n")[1].split("```")[0]
    for (written, fewer) in [(":250", ":4750"), (":0.001", ":0.009"), ("== 200", "== 4")]:
        assert written in code
        code = code.replace(written, fewer)
    names: dict = {}
    before = Path.cwd()
    os.chdir(ROOT)
    try:
        exec(code, names)
    finally:
        os.chdir(before)
    frame = names["frame"]
    assert set(frame["speed"]) == {1000, 5750} and (frame["bearings_worst_force_N"] > 0).all()
    # The larger ring leaves the smaller torque, and is found as the best.
    assert names["smallest"] == 0.011 and len(names["largest"]) == 2
