// The vertex shader of fragment programs.
#pragma once

#include <string>

namespace etalon {

// One triangle that covers the viewport, made of gl_VertexID alone, in GLSL `version`. A separable
// one stands alone in a program pipeline.
inline std::string TriangleShader(unsigned version, bool separable) {
    return "#version " + std::to_string(version) + " core\n" +
           (separable ? "out gl_PerVertex { vec4 gl_Position; };\n" : "") +
           "void main() {\n"
           "    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
           "    gl_Position = vec4(corner, 0.0, 1.0);\n"
           "}\n";
}

}  // namespace etalon
