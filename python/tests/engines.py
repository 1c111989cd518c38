"""Engines that several tests ask about."""

import crankstar

#: A V6 with masses and a speed, so that its loads are newtons.
V6 = dict(
    vee={"bank_angle": 60, "throws": [0, 120, 240], "pin_split": -60, "spacing": "0.108"},
    cycle="four-stroke",
    firing_order="1-4-2-5-3-6",
    speed="6000 rpm",
    effects=["torque"],
    bearings=["0.162", "0.054", "-0.054", "-0.162"],
    mechanism={
        "stroke": "90 mm",
        "rod_length": "150 mm",
        "reciprocating_mass": "0.6 kg",
        "rotating_mass": "0.5 kg",
    },
)


def v6() -> crankstar.Engine:
    return crankstar.Engine("V6, 60 degrees", **V6)
