/* Inputs for the self-test and for the measurements: random and hard ones, the same bits on every
 * machine. Only IEEE operations that are exact or correctly rounded; compile with -ffp-contract=off.
 */
#ifndef CASES_H
#define CASES_H

#include "kstrip.h"

static uint32_t cases_state = 1;

static void cases_restart(void)
{
    cases_state = 1;
}

/* Numerical Recipes' linear congruential generator, the upper 16 bits. */
static uint32_t cases_bits(void)
{
    cases_state = cases_state * 1664525u + 1013904223u;
    return cases_state >> 16;
}

/* Between 0 and 1. */
static float cases_unit(void)
{
    return (float)cases_bits() * (1.0f / 65536.0f);
}

/* Between low and high, evenly in every octave: 2^k (1 + u) with high = 2^octaves low. */
static float cases_spread(float low, uint32_t octaves)
{
    uint32_t k = cases_bits() % octaves;
    float x = low * (1.0f + cases_unit());
    while (k-- > 0) {
        x *= 2.0f;
    }
    return x;
}

static float cases_signed(float x)
{
    return (cases_bits() & 1u) != 0 ? x : -x;
}

/* Case `i`; call in order. Three of four are ordinary, every fourth is one of the hard ones. */
static void cases_next(uint32_t i, kstrip_contact_f32 *contact, kstrip_creepage_f32 *creepage)
{
    float ratio = cases_spread(0.1f, 6);        /* a/b: 0.1 to 6.4 */
    float b = cases_spread(0.5e-3f, 5);         /* 0.5 mm to 16 mm */
    float unit;                                 /* 2 mu p0/G, the creepage that slides */
    float spin_unit, size;
    contact->a = ratio * b;
    contact->b = b;
    contact->shear_modulus = 82e9f;
    contact->poisson_ratio = 0.5f * cases_unit();
    contact->friction = 0.05f + 0.6f * cases_unit();
    contact->mismatch = 0.0f;
    /* peak pressure 0.3 to 2.4 GPa */
    contact->normal_force = cases_spread(0.3e9f, 3) * contact->a * b * (2.0943951f);
    unit = 2.0f * contact->friction * (contact->normal_force / (2.0943951f * contact->a * b) / 82e9f);
    spin_unit = unit / contact->a;
    /* |xi|, |eta| up to 4 at any ratio to each other, |psi| up to 3 */
    size = cases_spread(1.0f / 64.0f, 7);
    creepage->longitudinal = cases_signed(unit * size * cases_unit());
    creepage->lateral = cases_signed(unit * size * cases_unit());
    creepage->spin = cases_signed(spin_unit * cases_spread(1.0f / 64.0f, 7) * cases_unit() * 1.5f);
    if (i % 4u != 3u) {
        return;
    }
    switch ((i / 4u) % 10u) {
    case 0: /* at rest */
        creepage->longitudinal = creepage->lateral = creepage->spin = 0.0f;
        break;
    case 1: /* tiny creepage */
        creepage->longitudinal *= 1e-12f;
        creepage->lateral *= 1e-14f;
        creepage->spin *= 1e-13f;
        break;
    case 2: /* full sliding */
        creepage->longitudinal *= 1e3f;
        creepage->lateral *= 1e3f;
        break;
    case 3: /* eta psi < 0 and |psi| next to 1, where kappa = (S + eta psi)/(1 - psi^2) cancels */
        creepage->lateral = -unit * (0.1f + 0.8f * cases_unit());
        creepage->spin = spin_unit * (1.0f - cases_spread(1e-6f, 14));
        break;
    case 4: /* pure spin, also beyond the theory */
        creepage->longitudinal = creepage->lateral = 0.0f;
        creepage->spin = spin_unit * 3.0f * cases_unit();
        break;
    case 5: /* slender along rolling */
        contact->b = contact->a * 0.1f;
        break;
    case 6: /* slender across rolling */
        contact->a = contact->b * 0.1f;
        break;
    case 7: /* the end of adhesion: |(xi, eta)| = 1 */
        creepage->longitudinal = unit * (1.0f - contact->poisson_ratio) * 0.6f;
        creepage->lateral = unit * 0.8f;
        creepage->spin *= 1e-4f;
        break;
    case 8: /* without load */
        contact->normal_force = 0.0f;
        break;
    default: /* spin balances lateral creepage: adhesion beyond |psi| = 1 */
        creepage->lateral = -unit * 1.5f * cases_unit();
        creepage->longitudinal = unit * 0.1f * cases_unit();
        creepage->spin = spin_unit * (1.0f + cases_unit());
        break;
    }
}

#endif
