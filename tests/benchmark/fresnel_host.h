// fresnel_transmittance of shaders/optics/fresnel.glsl, compiled for the host as C++.
#pragma once

namespace etalon {

float FresnelTransmittance(float n1, float n2, float cos_i);

}  // namespace etalon
