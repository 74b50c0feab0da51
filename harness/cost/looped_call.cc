#include "cost/looped_call.h"

#include <algorithm>

#include "base/file.h"
#include "compile/compile.h"

namespace etalon {
namespace {

constexpr const char* kTurns = "cost_loops";
constexpr const char* kDone = "cost_done";

// A bit of the turn's number that is never set, as no compiler can know.
constexpr unsigned kHighestBit = 30;
static_assert(1u << (kHighestBit - kMostCopies) > kMostTurns);

constexpr const char* kFunctions =
    "float cost_vary(float value, int zero)\n{\n"
    "    return uintBitsToFloat(floatBitsToUint(value) ^ uint(zero));\n}\n"
    "int cost_vary(int value, int zero)\n{\n    return value ^ zero;\n}\n"
    "uint cost_vary(uint value, int zero)\n{\n    return value ^ uint(zero);\n}\n"
    "bool cost_vary(bool value, int zero)\n{\n    return value != (zero != 0);\n}\n";

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
    LoopWriter(const PreparedCase& prepared, unsigned copies, bool empty)
        : call_(prepared.call), signature_(prepared.signature), copies_(copies), is_empty_(empty) {}

    std::string Text() {
        std::string parameters;
        for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
            if (call_.arguments[i].is_input) {
                parameters +=
                    TypeText(signature_.arguments[i]) + " cost_" + std::to_string(i) + ", ";
            }
        }
        std::string sums;
        std::string total = "0.0";
        std::string turn;
        for (unsigned copy = 0; copy < copies_; ++copy) {
            // A sum of its own for each: they need not wait for each other.
            sum_ = "cost_sum" + std::to_string(copy);
            sums += "    float " + sum_ + " = 0.0;\n";
            total += " + " + sum_;
            turn += "        {\n            int cost_zero = cost_turn >> " +
                    std::to_string(kHighestBit - copy) + ";\n";
            turn += Inputs();
            turn += Results();
            turn += "        }\n";
        }
        return std::string(kFunctions) + "float cost_loop(" + parameters +
               "int turns, out int done)\n{\n" + sums +
               "    int cost_turn = 0;\n    for (; cost_turn < turns; ++cost_turn) {\n" + turn +
               "    }\n    done = cost_turn;\n    return " + total + ";\n}\n";
    }

  private:
    bool IsUniform(const std::string& name) const {
        const auto& uniforms = signature_.dialect.uniforms;
        return std::find(uniforms.begin(), uniforms.end(), name) != uniforms.end();
    }

    std::string Add(const std::string& value) const {
        return "            " + sum_ + " += " + value + ";\n";
    }

    std::string AddAll(const std::string& variable, const Type& type) const {
        std::string text;
        for (const Leaf& leaf : Leaves(type)) {
            text += Add(AsFloat(variable + leaf.path, leaf.scalar));
        }
        return text;
    }

    // Declares the call's arguments and adds up the inputs.
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
                text += "            " + value + " = cost_vary(" + value + ", cost_zero);\n";
                any_input_ = AsFloat(value, leaf.scalar);
            }
            text += AddAll(argument.name, type);
        }
        return text;
    }

    std::string Results() const {
        const Type& type = signature_.wanted.front();
        const bool is_void = type.kind == Type::Kind::kVoid;
        std::string text;
        if (is_empty_) {
            std::size_t count = Leaves(type).size();
            for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
                count += call_.arguments[i].is_output ? Leaves(signature_.arguments[i]).size() : 0;
            }
            for (std::size_t i = 0; i < count; ++i) {
                text += Add(any_input_);
            }
            return text;
        }
        text = "            " + (is_void ? "" : TypeText(type) + " cost_result = ") +
               call_.wanted.front().text + ";\n" + AddAll("cost_result", type);
        for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
            if (call_.arguments[i].is_output) {
                text += AddAll(call_.arguments[i].name, signature_.arguments[i]);
            }
        }
        return text;
    }

    const Call& call_;
    const Signature& signature_;
    unsigned copies_;
    bool is_empty_;
    std::string sum_;
    std::string any_input_ = "1.0";  // where there is none
};

}  // namespace

Result<LoopedCall> LoopCall(const PreparedCase& prepared, const std::filesystem::path& file,
                            unsigned copies, bool empty) {
    ETALON_CHECK(!prepared.call.wanted.empty() && copies > 0 && copies <= kMostCopies);
    ETALON_TRY_STEP(WriteFile(file, LoopWriter(prepared, copies, empty).Text()));
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
