// Height of a spherical lens surface at `aperture` from its axis; both in millimetres.
float sagitta(float radius, float aperture)
{
    return radius - sqrt(radius * radius - aperture * aperture);
}

// The same without the difference of nearly equal numbers.
float sagitta_stable(float radius, float aperture)
{
    return aperture * aperture / (radius + sqrt((radius - aperture) * (radius + aperture)));
}

// The first terms of its series in (aperture / radius)^2.
float sagitta_series(float radius, float aperture, int terms)
{
    float q = aperture * aperture / (radius * radius);
    float term = 0.5 * q;
    float sum = term;
    for (int k = 1; k < terms; ++k) {
        term *= q * float(2 * k - 1) / float(2 * k + 2);
        sum += term;
    }
    return radius * sum;
}
