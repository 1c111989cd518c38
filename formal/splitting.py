"""A certificate of the second checker, verify.py: `splitting`, that a sum over a large denominator is not zero."""
from fractions import Fraction
from math import gcd, lcm

from verify import collect, demand, primes_of


def check(total, certificate):
    """Each step keeps a part that would be zero if the whole were; one vector that is left at the end is not zero."""
    for step in certificate.steps:
        N = lcm(1, *(t.denominator for t in total))
        if "class" in step:
            angle, modulus = step["class"].angle, step["class"].modulus
            demand(modulus.denominator == 1 and modulus > 0, "the modulus of a class is whole and positive")
            # x^p − ζ is irreducible where p² | N, and n < p terms leave a class empty: the classes vanish one by one.
            forced = [p for p in range(2, len(total) + 1) if N % p == 0 and modulus % p and primes_of(p) == [p]]
            demand(not forced, f"{forced} divide the conductor and not the modulus")
            total = collect((t - angle, w) for t, w in total.items() if ((t - angle) * modulus).denominator == 1)
        else:
            p, first, second = step.compare.prime, step.compare.first, step.compare.second
            demand(p <= 1_000_000 and primes_of(p) == [p] and 0 <= min(first, second) < max(first, second) < p, "no two classes of a prime")
            rest = N // gcd(N, p)
            demand(rest % p, "the prime divides the conductor twice")
            # t = u/p + x, the denominator of x prime to p: times p·rest, u·rest ≡ t·p·rest (mod p).
            class_of = {t: int(t * p * rest) * pow(rest, -1, p) % p for t in total}
            # 1 + x + … + x^(p−1) is irreducible over the rest: the classes of a vanishing sum are equal.
            part = lambda u, sign: [(t - Fraction(u, p), sign * w) for t, w in total.items() if class_of[t] == u]
            total = collect(part(first, 1) + part(second, -1))
    demand(len(total) == 1, f"{len(total)} vectors are left instead of one")
