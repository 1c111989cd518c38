//! The theorems in plain words, each with a proof that a student follows.

/// Heading, theorem, proof.
pub(super) const THEOREMS: [[&str; 3]; 9] = [
    [
        "Why five cylinders keep a first-order couple",
        "**Theorem.** With five cylinders, or any number that is a power of a prime, the moment of order 1 vanishes for no star. Gaps of other rational lengths do not change that.",
        "Number the throws along the shaft 0, 1, 2, 3, 4: these places are whole numbers $w$, one for each of the five directions, and up to a constant that adds nothing (other rational places are whole numbers in a smaller unit) the moment is the sum of the directions, each $w$ times. With whole weights five equally spread directions add up to 0 only if all weights are equal, because $1 + x + x^2 + x^3 + x^4$ is irreducible (with a prime power $q^b$: only if weights $1/q$ of a turn apart are). But no two throws coincide.",
    ],
    [
        "Why it can vanish with six",
        "**Theorem.** Every number of cylinders that is not a power of a prime has a star without the moment of order 1.",
        "Give the throw at $x$ sixths of a turn the place $w = x_2 + 2\\,x_3$, where $x_q$ is the remainder of $x$ divided by $q$: this counts 0 to 5, each once. The part $x_2$ is the same for three directions a third of a turn apart, \
         which add up to 0; the part $x_3$ is the same for two opposite directions, which do too. So does the whole. With more prime powers there are more parts, and each is the same for some regular polygon.",
    ],
    [
        "Why orders 1 and 2 can vanish with twelve, and 1, 2 and 4 with fifteen",
        "**Theorem.** Orders 1, 2, 4, … $2^j$ can vanish together exactly where the number of cylinders, divided by what it has in common with $2^j$, is neither 1 nor a power of a prime.",
        "(An order and its multiples by numbers coprime to $n$ vanish together, as arms are rational.) At order $k$ the $n$ directions become $n$ divided by the greatest common divisor of $n$ and $k$, each taken equally often. If that number is neither 1 nor a power of a prime at the last of these orders, it is neither at the others, and the star of remainders makes all of them vanish, as above. If at the last of these orders the number is a power of a prime $q$, all orders that would distinguish throws $1/q$ of a turn apart are among those that have to vanish: the places, put together from the orders that remain, would repeat themselves after $1/q$ of a turn, and no two throws coincide. If it is 1, the number of cylinders is a power of 2, and order 1 remains. Fifteen cylinders without order 1 are without 2, 4 and 8, and keep both 6 and 10: were one lost, throws a fifth or a third of a turn apart would coincide.",
    ],
    [
        "Why every moment can vanish with thirty",
        "**Theorem.** A two-stroke engine of several cylinders in line that fires evenly can be without any moment of any order that exists without a pin offset (1, 2, 4, 6, …) exactly where its number of cylinders is even and has two different odd prime factors.",
        "Let throws half a turn apart be mirrored about the middle of the shaft: their arms are opposite, and at every even order they point one way, so that all even orders vanish. Order 1 remains. Thirty is $2 \\cdot 15$, and fifteen has the star of remainders: put it on every other direction, with the places of the second half of the shaft, and its mirror image on the opposite ones; then order 1 vanishes for each half by itself. (Of $2^a c$ cylinders, $c$ odd, each $2^{a-1}$-th direction and each $2^{a-1}$-th place make such a pair of halves.) With at most one odd prime, the theorem before forbids it. An odd number: every order has the kind of an even one, so all would vanish, and all places be equal.",
    ],
    [
        "How many stars have no moment of order 1",
        "**Theorem.** For a product $pq$ of two different primes exactly $2\\,(p-1)!\\,(q-1)!$ stars with cylinder 1 at 0° have no moment of order 1.",
        "The moment is 0 exactly if the places are sums $a_i + b_j$, $i$ and $j$ the remainders by $p$ and $q$: of the places $w(i, j)$, each times the direction of $j$, the sums over $j$ at each $i$ must be equal, so $w(i, j) - w(0, j)$ does not depend on $j$. So 0, 1, …, $pq - 1$ are the sums of $p$ and of $q$ numbers, each once: as a product of polynomials, $(1 + x + \\dots + x^{pq-1}) = A(x)\\,B(x)$. It has three irreducible \
         factors, with values $p$, $q$ and 1 at $x = 1$, and $A$ has the value $p$ there: so $A$ is $0, 1, \\dots, p-1$ or that times $q$. Each set can be put on its remainders in any order, and $pq$ rotations are one star.",
    ],
    [
        "The residual of order 2",
        "**Theorem.** Without order 1, $2p$ cylinders ($p$ an odd prime) keep at order 2 at least twice the least moment of order 1 of $p$ cylinders; some keep no more.",
        "At order 2 the two terms of $a_i + b_j$ separate: $a_i$ adds 0, and $b_j$ is a star of $p$ throws, each taken twice, with places one apart or two apart.",
    ],
    [
        "Four-stroke engines",
        "**Theorem.** With an odd number of cylinders the throws, and all of the above, are those of the two-stroke engine. With an even number each direction is taken twice, and the moments of all orders 1, 2, 3, … vanish exactly if the shaft is its own mirror image.",
        "Add the two arms of each direction. If all orders vanish, these sums are 0 by Fourier's inversion: the two throws of every direction are mirrored. The other way round they cancel at every order. Odd orders above 1 exist only with a pin offset; without one, other stars lose all orders too: with twelve cylinders 48 beside the 120.",
    ],
    [
        "Other spacings",
        "**Theorem.** At rational places the moment of order 1 of $pq$ cylinders (two different primes) can vanish exactly if the places are the sums of $p$ and $q$ numbers. Irrational places can do what rational ones cannot.",
        "The first half is proved as above, but without polynomials. For the second: five throws with the arms $\\sin(4\\pi x/5)$ at the angles $2\\pi x/5$ have gaps in the golden ratio, 1 : φ : φ : 1; an arm is the difference of two rotating vectors, and what they add at order 1 is two sums over five directions, both 0.",
    ],
    [
        "No bank angle helps",
        "**Theorem.** Two equal banks, an angle γ apart, on shared pins that stand one in each of $m$ evenly spread directions leave two rotating moments at order $k$, with the crank and against it: each is $\\lvert\\cos\\tfrac{(k \\mp 1)\\gamma}{2}\\rvert$ times the greatest moment of the pins in line. At order 1 the couple that turns with the crank is as large as the greatest of the pins.",
        "The pins in line have two vectors, each half as large as their greatest moment. The vectors of the two cylinders of a pin are $(k \\mp 1)\\gamma$ apart, for every pin. For $k = 1$ that is 0 with the crank. So a V8 on four such pins or a V10 on five keeps a couple that turns with the crank, for counterweights to cancel, and a V12 on six need not.",
    ],
];
