#include "looped_call.h"

#include <algorithm>

#include "base/file.h"

namespace etalon {
namespace {

// Adds each scalar of a variable to a sum.
std::string Sum(const std::string& sum, const std::string& variable, const Type& type) {
    std::string text;
    for (const Leaf& leaf : Leaves(type)) {
        const std::string value = variable + leaf.path;
        text += "            " + sum + " += " +
                (leaf.scalar == Scalar::kBool ? "(" + value + " ? 1.0 : 0.0)"
                                              : "float(" + value + ")") +
                ";\n";
    }
    return text;
}

// Where the turn's bit `copy` is set, a value's last bit is cleared: the compiler cannot know that
// two values are the same, and no special one, such as one or zero, is lost.
std::string Vary(const std::string& variable, const Type& type, unsigned copy) {
    std::string text;
    for (const Leaf& leaf : Leaves(type)) {
        const std::string value = variable + leaf.path;
        if (leaf.scalar == Scalar::kFloat) {
            text += "            " + value + " = cost_vary(" + value + ", cost_turn >> " +
                    std::to_string(copy) + ");\n";
        }
    }
    return text;
}

}  // namespace

Result<Call> LoopedCall(const PreparedCase& prepared, const std::filesystem::path& file,
                        unsigned copies, bool empty) {
    const Call& plain = prepared.call;
    const Signature& signature = prepared.signature;
    const auto is_uniform = [&](const std::string& name) {
        const auto& uniforms = signature.dialect.uniforms;
        return std::find(uniforms.begin(), uniforms.end(), name) != uniforms.end();
    };

    std::string parameters;
    std::string arguments;
    Call call = plain;
    call.arguments.clear();
    for (std::size_t i = 0; i < plain.arguments.size(); ++i) {
        const Argument& argument = plain.arguments[i];
        if (argument.is_input) {
            parameters += TypeText(signature.arguments[i]) + " cost_" + std::to_string(i) + ", ";
            arguments += argument.name + ", ";
            call.arguments.push_back({argument.name, argument.type, true, false});
        }
    }
    call.arguments.push_back({kLoops, "int", true, false});

    std::string sums;
    std::string turn;
    std::string total = "0.0";
    for (unsigned copy = 0; copy < copies; ++copy) {
        // A sum of its own for each copy: they need not wait for each other.
        const std::string sum = "cost_sum" + std::to_string(copy);
        sums += "    float " + sum + " = 0.0;\n";
        total += " + " + sum;
        turn += "        {\n";
        std::string results;
        for (std::size_t i = 0; i < plain.arguments.size(); ++i) {
            const Argument& argument = plain.arguments[i];
            const Type& type = signature.arguments[i];
            turn += "            " + (is_uniform(argument.name) ? "" : TypeText(type) + " ") +
                    argument.name + (argument.is_input ? " = cost_" + std::to_string(i) : "") +
                    ";\n";
            if (argument.is_input) {
                turn += Vary(argument.name, type, copy) + Sum(sum, argument.name, type);
            }
            if (argument.is_output) {
                results += Sum(sum, argument.name, type);
            }
        }
        if (!empty) {
            const Type& type = signature.wanted.front();
            const bool is_void = type.kind == Type::Kind::kVoid;
            turn += "            " + (is_void ? "" : TypeText(type) + " cost_result = ") +
                    plain.wanted.front().text + ";\n" +
                    (is_void ? "" : Sum(sum, "cost_result", type)) + results;
        }
        turn += "        }\n";
    }
    // The scene's definitions come after the source, and this text after both.
    const std::string text =
        "float cost_vary(float value, int turn)\n{\n"
        "    return uintBitsToFloat(floatBitsToUint(value) & ~(uint(turn) & 1u));\n}\n"
        "float cost_loop(" +
        parameters + "int turns)\n{\n" + sums +
        "    for (int cost_turn = 0; cost_turn < turns; ++cost_turn) {\n" + turn +
        "    }\n    return " + total + ";\n}\n";
    ETALON_TRY_STEP(WriteFile(file, text));
    call.with.push_back(file);
    call.wanted = {{"result", "cost_loop(" + arguments + kLoops + ")", "the loop"}};
    return call;
}

}  // namespace etalon
