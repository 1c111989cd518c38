/* Which of the sums vanish, by FLINT: the remainder of a polynomial modulo the cyclotomic one, which is at hand. */
#include <flint/fmpz_poly.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define SUMS 28
#define TERMS 8
#define BATCHES 41
/* A dense polynomial of more terms is not tried. */
#define LARGEST 1000000

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e9 * t.tv_sec + t.tv_nsec;
}

static ulong exponents[SUMS][TERMS];
static slong weights[SUMS][TERMS];

static int all(const fmpz_poly_t cyclotomic, ulong conductor, fmpz_poly_t sum, fmpz_poly_t remainder)
{
    int zeros = 0;
    for (int i = 0; i < SUMS; i++) {
        /* One vector of coefficients, written in place: the fastest way in found. */
        fmpz_poly_zero(sum);
        fmpz_poly_fit_length(sum, conductor);
        _fmpz_vec_zero(sum->coeffs, conductor);
        for (int j = 0; j < TERMS; j++)
            fmpz_add_si(sum->coeffs + exponents[i][j], sum->coeffs + exponents[i][j], weights[i][j]);
        _fmpz_poly_set_length(sum, conductor);
        _fmpz_poly_normalise(sum);
        fmpz_poly_rem(remainder, sum, cyclotomic);
        zeros += fmpz_poly_is_zero(remainder);
    }
    return zeros;
}

static void measure(ulong conductor)
{
    fmpz_poly_t cyclotomic, sum, remainder;
    fmpz_poly_init(cyclotomic);
    fmpz_poly_init(sum);
    fmpz_poly_init(remainder);
    fmpz_poly_cyclotomic(cyclotomic, conductor);
    double start = now();
    int zeros = all(cyclotomic, conductor, sum, remainder);
    long rounds = 1 + (long) (4e6 / (now() - start));
    double least = 1e300;
    for (int batch = 0; batch < BATCHES; batch++) {
        start = now();
        for (long round = 0; round < rounds; round++)
            zeros = all(cyclotomic, conductor, sum, remainder);
        double time = (now() - start) / ((double) rounds * SUMS);
        if (time < least) least = time;
    }
    printf("FLINT %s in C; verdict; %lu; %.1f; %d\n", FLINT_VERSION, conductor, least, zeros);
    fmpz_poly_clear(cyclotomic);
    fmpz_poly_clear(sum);
    fmpz_poly_clear(remainder);
}

int main(int count, char **arguments)
{
    FILE *file = count == 2 ? fopen(arguments[1], "r") : NULL;
    if (!file) return fprintf(stderr, "flint: which file of sums?\n"), 1;
    ulong conductor;
    for (int i = 0; fscanf(file, "%lu", &conductor) == 1; i = (i + 1) % SUMS) {
        for (int j = 0; j < TERMS; j++)
            if (fscanf(file, "%lu %ld", &exponents[i][j], &weights[i][j]) != 2) return 1;
        if (i == SUMS - 1 && conductor <= LARGEST) measure(conductor);
        else if (i == SUMS - 1) printf("FLINT %s in C; verdict; %lu; none; a polynomial of that many terms\n", FLINT_VERSION, conductor);
    }
    return 0;
}
