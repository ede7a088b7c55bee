/* Solves contacts of the whole input space for a long time and watches: scripts/soak.sh [solves] [state file]
 *
 * The state is written after every block of 2^20; started again with the same file it goes on where it was. It stops with an
 * error when a promise is broken: an output that is not finite or beyond the friction bound, a power that is negative, an output
 * written on error, other bits for the same inputs as at the start, memory that grows. */
#include "kstrip.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define BLOCK (UINT64_C(1) << 20)
/* Solves of the first block that are repeated, and after how many blocks: to see that nothing has drifted */
#define SAMPLE (UINT64_C(1) << 17)
#define CHECK_EVERY 64
#define FNV UINT64_C(0x100000001b3)

/* Mostly cheap models: the point is the number of inputs. */
static const kstrip_options MIX[16] = {
    {KSTRIP_MODEL_TOTAL, 16},     {KSTRIP_MODEL_LINEAR, 16}, {KSTRIP_MODEL_STRIP_1967, 4}, {KSTRIP_MODEL_TOTAL, 16},
    {KSTRIP_MODEL_LINEAR, 16},    {KSTRIP_MODEL_STRIP_1967_CONTINUOUS, 4}, {KSTRIP_MODEL_TOTAL, 16}, {KSTRIP_MODEL_STRIP, 4},
    {KSTRIP_MODEL_TOTAL, 16},     {KSTRIP_MODEL_LINEAR, 16}, {KSTRIP_MODEL_STRIP_1967, 8}, {KSTRIP_MODEL_TOTAL, 16},
    {KSTRIP_MODEL_STRIP, 8},      {KSTRIP_MODEL_STRIP_1967_CONTINUOUS, 8}, {KSTRIP_MODEL_STRIP_1967, 16}, {KSTRIP_MODEL_STRIP, 16},
};

/* What is carried from run to run: the hash of all results, and that of the sample. */
typedef struct state {
    uint64_t solves, refused, warned, hash, sample;
    double seconds;
} state;

/* SplitMix64 (Steele et al. 2014) */
static uint64_t bits(uint64_t *random)
{
    uint64_t z = *random += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

static double from_bits(uint64_t bits)
{
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

static uint64_t bits_of(double number)
{
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return bits;
}

/* low 2^k (1 + u): evenly over so many octaves */
static double octaves(uint64_t *random, double low, uint64_t count)
{
    const uint64_t b = bits(random);
    return low * ldexp(1.0, (int)((b >> 32) % count)) * (1.0 + (double)(b & UINT32_MAX) / 4294967296.0);
}

/* Shapes of 1 : 1000 to 1000 : 1, loads and materials of any size, from no creepage at all to far beyond sliding; one in 64
 * with arbitrary bits in one number. */
static void input(uint64_t *random, kstrip_contact *contact, kstrip_creepage *creepage)
{
    contact->b = octaves(random, 1e-5, 14);
    contact->a = contact->b * octaves(random, 1e-3, 20);
    contact->shear_modulus = octaves(random, 1e6, 20);
    contact->poisson_ratio = 0.5 * (double)(bits(random) >> 11) / 9007199254740992.0;
    contact->friction = octaves(random, 1e-3, 11);
    contact->mismatch = 0;
    /* Peak pressure of 2^-20 G to G/10 */
    const double pressure = contact->shear_modulus * octaves(random, 1e-6, 17);
    contact->normal_force = pressure * contact->a * contact->b * 2.094395102393195;
    const double unit = 2.0 * contact->friction * pressure / contact->shear_modulus;
    /* Each creepage is there or not, and of its own size and sign. */
    const uint64_t which = bits(random);
    double *const parts[3] = {&creepage->longitudinal, &creepage->lateral, &creepage->spin};
    for (int i = 0; i < 3; i++) {
        const double size = which >> 2 * i & 3 ? octaves(random, unit * 1e-6, 26) : 0.0;
        *parts[i] = which >> (8 + i) & 1 ? -size : size;
    }
    creepage->spin /= contact->a;
    if ((which >> 16 & 63) == 0) {
        double *const numbers[8] = {&contact->a,        &contact->b,        &contact->normal_force, &contact->shear_modulus,
                                    &contact->friction, parts[0], parts[1], parts[2]};
        *numbers[which >> 24 & 7] = from_bits(bits(random));
    }
}

/* Solves `count` inputs of a block; 0 with a message when a promise is broken. */
static int solve_block(uint64_t block, uint64_t count, uint64_t *hash, uint64_t *refused, uint64_t *warned)
{
    uint64_t random = block * UINT64_C(0x9E3779B97F4A7C15);
    *hash = UINT64_C(0xcbf29ce484222325);
    for (uint64_t i = 0; i < count; i++) {
        kstrip_contact c;
        kstrip_creepage v;
        input(&random, &c, &v);
        const kstrip_options *options = &MIX[i % 16];
        static const kstrip_result untouched = {-7.0, -7.0, -7.0, -7.0, -7.0, 0, -7};
        kstrip_result r = untouched;
        const kstrip_status status = kstrip_solve(&c, &v, options, &r);
        const double numbers[5] = {r.fx, r.fy, r.mz, r.power, r.adhesion};
        int well = 1;
        if (status < 0) {
            ++*refused;
            well = memcmp(&r, &untouched, sizeof r) == 0;
        } else {
            *warned += status > 0;
            const double bound = c.normal_force > 0.0 ? c.friction * c.normal_force : 0.0;
            const double slip = fabs(v.longitudinal) + fabs(v.lateral) + (c.a + c.b) * fabs(v.spin);
            for (int k = 0; k < 5; k++)
                well &= isfinite(numbers[k]) != 0;
            well &= r.adhesion >= -1.0 && r.adhesion <= 1.0;
            if (options->model != KSTRIP_MODEL_LINEAR)
                well &= hypot(r.fx, r.fy) <= bound * (1.0 + 1e-12) + 1e-300 && r.power >= -1e-12 * bound * slip;
        }
        if (!well) {
            fprintf(stderr,
                    "soak: block %" PRIu64 ", solve %" PRIu64 ", model %d: a %.17g b %.17g N %.17g G %.17g nu %.17g mu %.17g, "
                    "creepage %.17g %.17g spin %.17g give status %d, %.17g %.17g %.17g power %.17g adhesion %.17g\n",
                    block, i, options->model, c.a, c.b, c.normal_force, c.shear_modulus, c.poisson_ratio, c.friction,
                    v.longitudinal, v.lateral, v.spin, status, r.fx, r.fy, r.mz, r.power, r.adhesion);
            return 0;
        }
        for (int k = 0; k < 5; k++)
            *hash = (*hash ^ bits_of(numbers[k])) * FNV;
    }
    return 1;
}

static int sample_is(uint64_t wanted)
{
    uint64_t hash, refused = 0, warned = 0;
    return solve_block(0, SAMPLE, &hash, &refused, &warned) && hash == wanted;
}

/* Resident memory in kB; 0 where the system does not tell */
static long resident(void)
{
    char line[256];
    long kilobytes = 0;
    FILE *file = fopen("/proc/self/status", "r");
    while (file && fgets(line, sizeof line, file))
        if (sscanf(line, "VmRSS: %ld", &kilobytes) == 1)
            break;
    if (file)
        fclose(file);
    return kilobytes;
}

static int load(const char *path, state *s)
{
    FILE *file = path ? fopen(path, "r") : NULL;
    if (!file)
        return 0;
    const int found = fscanf(file, "%" SCNu64 "%" SCNu64 "%" SCNu64 "%" SCNx64 "%" SCNx64 "%lf", &s->solves, &s->refused,
                             &s->warned, &s->hash, &s->sample, &s->seconds);
    fclose(file);
    return found == 6;
}

/* Never half a state: written beside it, then renamed */
static int store(const char *path, const state *s)
{
    char beside[4096];
    if (snprintf(beside, sizeof beside, "%s.new", path) >= (int)sizeof beside)
        return 0;
    FILE *file = fopen(beside, "w");
    if (!file)
        return 0;
    const int written = fprintf(file, "%" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIx64 " %" PRIx64 " %.0f\n", s->solves, s->refused,
                                s->warned, s->hash, s->sample, s->seconds);
    return (fclose(file) == 0) & (written > 0) && rename(beside, path) == 0;
}

static int failed(const char *what)
{
    fprintf(stderr, "soak: %s\n", what);
    return EXIT_FAILURE;
}

int main(int count, char **arguments)
{
    const double wanted = count > 1 ? atof(arguments[1]) : 1e9;
    const char *path = count > 2 ? arguments[2] : NULL;
    if (!(wanted >= 1.0 && wanted < 1e18))
        return failed("how many solves?");
    state s = {0};
    const int resumed = load(path, &s);
    uint64_t sample, ignored = 0;
    if (!solve_block(0, SAMPLE, &sample, &ignored, &ignored))
        return EXIT_FAILURE;
    if (resumed && sample != s.sample)
        return failed("the first block has other results than when this run began");
    s.sample = sample;
    const double before = s.seconds;
    const time_t begin = time(NULL);
    /* Memory is measured once everything has been used. */
    long first = 0, most = 0;
    while ((double)s.solves < wanted) {
        const uint64_t block = s.solves / BLOCK, left = (uint64_t)wanted - s.solves;
        const uint64_t size = left < BLOCK ? left : BLOCK;
        uint64_t hash;
        if (!solve_block(block, size, &hash, &s.refused, &s.warned))
            return EXIT_FAILURE;
        s.hash = (s.hash ^ hash) * FNV;
        s.solves += size;
        s.seconds = before + difftime(time(NULL), begin);
        if ((block + 1) % CHECK_EVERY == 0 && !sample_is(s.sample))
            return failed("the first block has other results than at the start");
        const long memory = resident();
        first = first ? first : memory;
        most = memory > most ? memory : most;
        if (most > first + 4096)
            return failed("memory grows");
        if (path && !store(path, &s))
            return failed("the state cannot be written");
    }
    printf("%" PRIu64 " solves, %" PRIu64 " refused, %" PRIu64 " with a warning, hash %016" PRIx64 "\n", s.solves, s.refused,
           s.warned, s.hash);
    printf("%.0f s (inputs, checks and hash included)\n", s.seconds);
    if (first)
        printf("resident memory: %ld kB after the first block, at most %ld kB\n", first, most);
    else
        printf("resident memory: SKIPPED, this system does not tell\n");
    if (!sample_is(s.sample))
        return failed("the first block has other results than at the start");
    printf("the first block gives the same bits as at the start\n");
    return EXIT_SUCCESS;
}
