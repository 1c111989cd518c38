"""One table of all times: a row for who and what, a column a conductor; the times of one sum, and how often the best exact peer's."""

import sys

rows, zeros, conductors = {}, {}, []
for line in open(sys.argv[1], encoding="utf-8"):
    who, what, conductor, time, note = [part.strip() for part in line.split(";")]
    conductors.append(int(conductor))
    rows.setdefault((who, what), {})[int(conductor)] = None if time == "none" else float(time)
    if time != "none":
        zeros.setdefault(int(conductor), set()).add(int(note))
conductors = sorted(set(conductors))
for conductor, found in zeros.items():
    if len(found) != 1:
        print(f"the numbers of sums that vanish differ at conductor {conductor}: {sorted(found)}", file=sys.stderr)


def written(time):
    if time is None:
        return "cannot"
    return f"{time:.0f} ns" if time < 1000 else f"{time / 1000:.3g} µs" if time < 1e6 else f"{time / 1e6:.3g} ms"


def line(cells):
    print("| " + " | ".join(cells) + " |")


line(["", "a sum of eight terms", *(f"N = {conductor:,}" for conductor in conductors)])
line(["---"] * (len(conductors) + 2))
for (who, what), times in rows.items():
    line([who, what, *(written(times.get(conductor)) for conductor in conductors)])
line(["", "sums that vanish, of 28", *("/".join(map(str, sorted(zeros[conductor]))) for conductor in conductors)])

ours = {what: times for (who, what), times in rows.items() if who == "crankstar"}


def best(conductor):
    peers = [times[conductor] for (who, what), times in rows.items() if what == "verdict" and who != "crankstar" and times.get(conductor)]
    return min(peers, default=None)


def ratio(over, under):
    return "–" if over is None or under is None else f"{over / under:.2g}"


print()
line(["Ratio", *(f"N = {conductor:,}" for conductor in conductors)])
line(["---"] * (len(conductors) + 1))
line(["best exact peer / verdict", *(ratio(best(n), ours["verdict"][n]) for n in conductors)])
for what in list(ours)[1:]:
    line([f"{what} / verdict", *(ratio(ours[what][n], ours["verdict"][n]) for n in conductors)])
