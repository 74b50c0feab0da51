#include "cost/looped_call.h"

#include <algorithm>

#include "base/file.h"
#include "compile/compile.h"

namespace etalon {
namespace {

constexpr const char* kTurns = "cost_loops";
constexpr const char* kDone = "cost_done";

// A bit that is never set in a turn's number, as no compiler can know.
constexpr unsigned kUnsetBit = 20;
static_assert(1u << kUnsetBit > kMostTurns);

constexpr const char* kFunctions =
    "float cost_vary(float value, int zero)\n{\n"
    "    return uintBitsToFloat(floatBitsToUint(value) ^ uint(zero));\n}\n"
    "int cost_vary(int value, int zero)\n{\n    return value ^ zero;\n}\n"
    "uint cost_vary(uint value, int zero)\n{\n    return value ^ uint(zero);\n}\n"
    "bool cost_vary(bool value, int zero)\n{\n    return value != (zero != 0);\n}\n";

std::string AsInt(const std::string& value, Scalar scalar) {
    return (scalar == Scalar::kFloat ? "floatBitsToInt(" : "int(") + value + ")";
}

std::string AsFloat(const std::string& value, Scalar scalar) {
    switch (scalar) {
        case Scalar::kFloat:
            return value;
        case Scalar::kBool:
            return "(" + value + " ? 1.0 : 0.0)";
        default:
            return "float(" + value + ")";
    }
}

// Writes the function cost_loop, of the inputs, the turns and the turns made.
class LoopWriter {
  public:
    LoopWriter(const PreparedCase& prepared, unsigned slots, unsigned calls)
        : call_(prepared.call), signature_(prepared.signature), slots_(slots), calls_(calls) {}

    std::string Text() {
        std::string parameters;
        for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
            if (call_.arguments[i].is_input) {
                parameters +=
                    TypeText(signature_.arguments[i]) + " cost_" + std::to_string(i) + ", ";
            }
        }
        // The condition stands at the end: llvmpipe runs a turn more, with all lanes off, of a loop
        // that is left at its beginning.
        std::string turn;
        for (unsigned slot = 0; slot < slots_; ++slot) {
            turn +=
                "        {\n            int cost_zero = floatBitsToInt(cost_carry) & cost_none;\n";
            turn += Inputs();
            turn += slot < calls_ ? Results() : Nothing();
            turn += "        }\n";
        }
        return std::string(kFunctions) + "float cost_loop(" + parameters +
               "int turns, out int done)\n{\n    float cost_carry = 0.0;\n    int cost_sum = 0;\n"
               "    int cost_none = 0;\n    int cost_turn = 0;\n"
               "    do {\n        cost_none = cost_turn >> " +
               std::to_string(kUnsetBit) + ";\n" + turn +
               "        ++cost_turn;\n    } while (cost_turn < turns);\n    done = cost_turn;\n"
               "    return intBitsToFloat(floatBitsToInt(cost_carry) ^ (cost_sum & "
               "cost_none));\n}\n";
    }

  private:
    bool IsUniform(const std::string& name) const {
        const auto& uniforms = signature_.dialect.uniforms;
        return std::find(uniforms.begin(), uniforms.end(), name) != uniforms.end();
    }

    // What the next slot waits for.
    static std::string Carry(const std::vector<std::string>& values) {
        std::string text = "            cost_carry = ";
        for (std::size_t i = 0; i < values.size(); ++i) {
            text += (i == 0 ? "" : " + ") + values[i];
        }
        return text + (values.empty() ? "0.0;\n" : ";\n");
    }

    // Declares the call's arguments; all inputs are made, whatever the slot does with them.
    std::string Inputs() {
        std::string text;
        for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
            const Argument& argument = call_.arguments[i];
            const Type& type = signature_.arguments[i];
            text += "            " + (IsUniform(argument.name) ? "" : TypeText(type) + " ") +
                    argument.name + (argument.is_input ? " = cost_" + std::to_string(i) : "") +
                    ";\n";
            if (!argument.is_input) {
                continue;
            }
            for (const Leaf& leaf : Leaves(type)) {
                const std::string value = argument.name + leaf.path;
                text += "            " + value + " = cost_vary(" + value + ", cost_zero);\n" +
                        "            cost_sum += " + AsInt(value, leaf.scalar) + ";\n";
                any_input_ = leaf.scalar == Scalar::kFloat
                                 ? value
                                 : "intBitsToFloat(" + AsInt(value, leaf.scalar) + ")";
            }
        }
        return text;
    }

    std::string Results() const {
        const Type& type = signature_.wanted.front();
        const bool is_void = type.kind == Type::Kind::kVoid;
        std::vector<std::string> values;
        const auto add = [&](const std::string& variable, const Type& of) {
            for (const Leaf& leaf : Leaves(of)) {
                values.push_back(AsFloat(variable + leaf.path, leaf.scalar));
            }
        };
        add("cost_result", type);
        for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
            if (call_.arguments[i].is_output) {
                add(call_.arguments[i].name, signature_.arguments[i]);
            }
        }
        return "            " + (is_void ? "" : TypeText(type) + " cost_result = ") +
               call_.wanted.front().text + ";\n" + Carry(values);
    }

    // As many values as there are results.
    std::string Nothing() const {
        std::size_t count = Leaves(signature_.wanted.front()).size();
        for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
            count += call_.arguments[i].is_output ? Leaves(signature_.arguments[i]).size() : 0;
        }
        return Carry(std::vector<std::string>(count, any_input_));
    }

    const Call& call_;
    const Signature& signature_;
    unsigned slots_;
    unsigned calls_;
    std::string any_input_ = "1.0";  // where there is none
};

}  // namespace

Result<LoopedCall> LoopCall(const PreparedCase& prepared, const std::filesystem::path& file,
                            unsigned slots, unsigned calls) {
    ETALON_CHECK(!prepared.call.wanted.empty() && slots > 0 && slots <= kMostSlots);
    ETALON_CHECK(calls <= slots);
    ETALON_TRY_STEP(WriteFile(file, LoopWriter(prepared, slots, calls).Text()));
    LoopedCall looped;
    looped.call = prepared.call;
    // The loop comes after all that it may call, in whichever order that has to stand.
    if (prepared.signature.dialect.with_first) {
        looped.call.with.push_back(looped.call.source);
        looped.call.source = looped.call.with.front();
        looped.call.with.erase(looped.call.with.begin());
    }
    looped.call.with.push_back(file);
    looped.call.arguments.clear();
    std::string arguments;
    for (const Argument& argument : prepared.call.arguments) {
        if (argument.is_input) {
            looped.call.arguments.push_back({argument.name, argument.type, true, false});
            arguments += argument.name + ", ";
        }
    }
    looped.call.arguments.push_back({kTurns, "int", true, false});
    looped.call.arguments.push_back({kDone, "int", false, true});
    looped.call.wanted = {{"result", "cost_loop(" + arguments + kTurns + ", " + kDone + ")",
                           prepared.call.wanted.front().origin}};
    ETALON_TRY(signature, Inspect(looped.call));
    looped.signature = signature;
    looped.done_column = 1;  // after the sum
    return looped;
}

}  // namespace etalon
