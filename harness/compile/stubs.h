// Bodies for functions that a source declares and nobody defines.
#pragma once

#include <glslang/MachineIndependent/localintermediate.h>

#include <string>

namespace etalon {

// GLSL that defines every function which `tree`, a parsed and not yet linked shader, calls and does
// not define. glslang leaves out what main does not reach; a driver's linker may miss a body there.
// A function that main does reach is the linker's affair, before this text is used.
std::string StubsFor(const glslang::TIntermediate& tree);

}  // namespace etalon
