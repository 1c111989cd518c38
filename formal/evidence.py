"""The second checker, verify.py: loads, comparisons and sweeps, numbers with verdicts as their evidence (src/proof/README.md)."""
from verify import check_classify, demand, each


def check(document, notes):
    """Of loads, comparisons and sweeps: the documents of verdicts in them, and what the rest repeats of those."""
    notes.add("all numbers outside of `evidence`")
    proved, kind = [], document["format"]
    for one in each("evidence", document["evidence"]):
        demand(one["format"] == "crankstar classify 2", "it is no document of verdicts")
        proved.append(check_classify(one, notes))
    demand(proved and (kind != "crankstar loads 2" or len(proved) == 1), "there is no evidence, or too much")
    if kind == "crankstar loads 2":
        judged = proved[0][0]
        for entry in each("orders", document["orders"]):
            both = judged[entry["quantity"], entry["order"]]
            whole = True if both == [True, True] else False if False in both else None
            said = entry["direct"]["vanishes"], entry["reverse"]["vanishes"], entry["vanishes"]
            demand(all(one is due for one, due in zip(said, (*both, whole))), "the evidence differs")
        for entry in each("torque", document["torque"]):
            demand(entry["vanishes"] is judged["torque", entry["order"]][0], "the evidence differs")
    if kind == "crankstar compare 2":
        for (_, shapes), engine in each("engines", document["engines"], proved):
            for entry in each("orders", engine["orders"]):
                for quantity in ("force", "moment"):
                    demand(entry[quantity]["shape"] == shapes[quantity, entry["order"]], "the evidence differs")
