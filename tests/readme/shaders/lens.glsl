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
