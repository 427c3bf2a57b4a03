// Welch's test of whether two noisy means differ, over any type of number. Included inside a namespace that has a Real: no
// guard, by design.

// The level of the test, two-sided: how probable it is that equal means are told apart. A standard normal variable is
// further from 0 than `critical_normal` with this probability.
constexpr float test_level = 0.01f, critical_normal = 2.5758293f;

// One over the degrees of freedom of the difference of two independent means with variances a and b, above 0, that are
// estimated with 1 / inverse_a and 1 / inverse_b degrees of freedom. [Welch 1947, "The generalization of 'Student's'
// problem when several different population variances are involved"; Satterthwaite 1946]
inline Real inverse_freedom(Real a, Real inverse_a, Real b, Real inverse_b)
{
    const Real share = a / (a + b), rest = 1.0f - share;
    return share * share * inverse_a + rest * rest * inverse_b;
}

// Square of the t quantile of the test's level for `inverse` of a degree of freedom, from 0 to 1/4: within 3 %.
// [Cornish and Fisher's expansion: Abramowitz and Stegun 1964, 26.7.5]
inline Real squared_critical_t(Real inverse)
{
    constexpr float z = critical_normal, z2 = z * z;
    constexpr float first = (z2 + 1.0f) / 4.0f, second = ((5.0f * z2 + 16.0f) * z2 + 3.0f) / 96.0f,
                    third = (((3.0f * z2 + 19.0f) * z2 + 17.0f) * z2 - 15.0f) / 384.0f;
    const Real t = z * (1.0f + inverse * (first + inverse * (second + inverse * third)));
    return t * t;
}

// Squared difference of two means over that above which the test tells them apart: they differ if this is above 1.
// Variances of the means as above, degrees of freedom 4 or more.
inline Real welch_ratio(Real difference, Real a, Real inverse_a, Real b, Real inverse_b)
{
    return difference * difference /
           ((a + b) * squared_critical_t(inverse_freedom(a, inverse_a, b, inverse_b)));
}
