// Operations of a module in the words of its GLSL source.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "evaluate/trace.h"
#include "spirv/module.h"

namespace etalon {

class SourceTerms {
  public:
    // The module must outlive it.
    explicit SourceTerms(const spirv::Module& module);

    // "radius - #3": operands are variables by their names where they are read from them,
    // constants, or the numbers of the steps that yielded them.
    std::string Operation(const evaluate::Trace& trace, const evaluate::TracedStep& step) const;

    // The variable that the step's result is kept in ("v.x"); empty where it is in none of the
    // source's.
    std::string Name(const evaluate::TracedStep& step) const;

    // The operation as GLSL over these operands: "(a) - (b)".
    std::string Glsl(const spirv::Instruction& instruction,
                     const std::vector<std::string>& operands) const;

    // "vec3"; empty for what is neither a scalar, a vector nor a matrix.
    std::string TypeName(std::uint32_t type) const;

    // ".x", "[2].y" of the leaf of a type; empty for a scalar.
    std::string LeafName(std::uint32_t type, std::uint32_t leaf) const;

  private:
    std::string Label(const evaluate::Trace& trace, const evaluate::Origin& origin) const;
    std::string Operand(const evaluate::Trace& trace, std::uint32_t value,
                        const std::vector<evaluate::TracedOperand>& numbers,
                        const std::vector<std::uint32_t>& words) const;
    std::string Text(std::uint32_t value) const;
    std::string Constant(std::uint32_t value) const;
    std::string Pointer(std::uint32_t value) const;
    std::string Part(std::uint32_t& type, std::uint32_t index) const;

    const spirv::Module& module_;
    std::vector<const spirv::Instruction*> definitions_;  // by value
};

}  // namespace etalon
