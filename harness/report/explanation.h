// Explanation: what `etalon explain` found of one input, as plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/record.h"

namespace etalon {

// A number, or a word, that an operation yields.
struct ExplainedValue {
    std::string part;  // ".x" of a vector; else empty
    Value strict;      // binary32
    Value exact;
    double error_ulp = 0;      // |strict - exact| in ulp of the exact value
    double amplification = 0;  // how much larger the relative error of the result can be than those
                               // of the operands
    double lost_bits = 0;      // log2 of the error over the operands' largest, or over half an ulp
    bool reaches_output = false;
};

struct ExplainedStep {
    std::uint32_t number = 0;  // from 1, in the order of execution
    std::string file;          // the user's; empty for generated text
    std::uint32_t line = 0;
    std::string text;       // of the line
    std::string name;       // of the variable that keeps the result; empty for none
    std::string operation;  // "radius - #3"
    std::vector<ExplainedValue> values;
    bool is_decision = false;        // its values are no floats; they have no errors
    bool decides_otherwise = false;  // with exact operands
};

// The first operation at which a device's results differ from the strict ones, operands alike.
struct ExplainedParting {
    bool happens = false;
    std::uint32_t step = 0;  // ExplainedStep::number
    std::string part;
    Value strict;
    Value device;
    std::string text;  // one sentence, whatever was found: also why nothing was
};

struct ExplainedDevice {
    Record record;  // of this one row and output: verdict, budget, what is allowed
    Value result;   // empty where there is none
    ExplainedParting parting;
};

struct Explanation {
    std::string case_path;
    std::vector<std::pair<std::string, Value>> inputs;
    std::string chosen;  // how the input was chosen where the user gave none
    std::string output;  // "result.x"
    std::string rule;    // that judges it; empty where none does
    std::optional<Value> truth;
    Value method;  // M, the program without rounding
    Value strict;  // R
    std::vector<ExplainedDevice> devices;
    std::vector<ExplainedStep> steps;
    std::uint32_t worst_step = 0;  // where most bits are lost on the way to the output; 0: nowhere
    std::size_t worst_value = 0;
    bool is_cut = false;  // the path goes on beyond the last step
};

// What a person reads. Without `all`, of a long path the first and last steps, and those that are
// of interest.
std::string ExplanationText(const Explanation& explanation, bool all);

std::string ExplanationJson(const Explanation& explanation);

}  // namespace etalon
