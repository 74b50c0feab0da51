// fresnel_transmittance of shaders/optics/fresnel.glsl, on the host.
#pragma once

namespace etalon {

float FresnelTransmittance(float n1, float n2, float cos_i);

}  // namespace etalon
