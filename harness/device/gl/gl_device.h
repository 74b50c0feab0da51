// OpenGL off screen, by two doors: OSMesa and surfaceless EGL.
#pragma once

#include "device/backends.h"

namespace etalon {

std::vector<Candidate> OsmesaCandidates(const Driver& driver);
DeviceResult<std::unique_ptr<Device>> OpenOsmesaDevice(const Candidate& candidate);

std::vector<Candidate> EglCandidates(const Driver& driver);
DeviceResult<std::unique_ptr<Device>> OpenEglDevice(const Candidate& candidate);

}  // namespace etalon
