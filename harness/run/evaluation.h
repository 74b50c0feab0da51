// Evaluation: what a program means at the rows of a table, by the evaluator on the host. The strict
// reading, the method without rounding, and what the specifications allow; each computed once, by
// the thread that asks for it first, and shared by all devices.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "device/device_info.h"
#include "evaluate/profile.h"
#include "judge/budget.h"
#include "run/programs.h"
#include "run/runner.h"

namespace etalon {

// The specification to which a device is held where a case names none: GLSL's for OpenGL, Vulkan's
// for all others.
const evaluate::Profile& ProfileOf(const DeviceInfo& device);

class Evaluation {
  public:
    // Of a compute program in SPIR-V with inputs at run time, which all must outlive it.
    Evaluation(const Program& program, const Rows& inputs);
    // Of a program that there is not: nothing can be evaluated, and this is why.
    explicit Evaluation(std::string reason);
    ~Evaluation();
    Evaluation(const Evaluation&) = delete;
    Evaluation& operator=(const Evaluation&) = delete;

    // M as the evaluator leaves it: what is no float has its words alone.
    struct Method {
        std::vector<std::uint32_t> words;
        std::vector<double> numbers;

        double At(std::size_t index, Scalar scalar) const;
    };
    // R and M of all outputs at all rows, by columns: of column c at row r, [c * rows + r]; M by
    // binary64.
    struct Values {
        std::vector<std::uint32_t> strict;
        Method method;
    };

    // What is allowed, likewise by columns. R is a conforming result: where a bound leaves it out
    // the bound is wrong, which is Etalon's fault and no driver's; it is counted and void.
    struct Bounds {
        std::vector<Allowed> allowed;
        std::vector<bool> is_void;
    };

    // Fail, in one short reason, where the program cannot be evaluated. The references stay valid
    // as long as this object.
    const Result<Values>& Get();
    const Result<Bounds>& BoundsBy(const evaluate::Profile& profile);

    // M by Big, of an output at a row; by binary64 where the evaluation fails at that
    // precision. Only where Get has not failed. A row is evaluated once.
    double MethodAt(std::uint64_t row, std::size_t column, Scalar scalar);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// The evaluations of a run, by program and rows.
class Evaluations {
  public:
    // Programs are shared with the devices of the run.
    explicit Evaluations(std::shared_ptr<Programs> programs);

    // Of the call as a device runs it by this recipe: what is baked, optimised, a fragment shader
    // or text follows the plain SPIR-V compute program; `precise` SPIR-V has a program of its own.
    // Rows are known by the address of their words, which must not change.
    Evaluation& Of(const Call& call, const Signature& signature, const Recipe& recipe,
                   const Rows& rows);

    // Ends the evaluations at the rows of these words, of which none may be in use.
    void Forget(std::span<const std::uint32_t> words);

  private:
    std::shared_ptr<Programs> programs_;
    std::mutex mutex_;
    // By the address of the rows' words, then by program.
    std::map<const std::uint32_t*, std::map<std::string, std::unique_ptr<Evaluation>>> entries_;
};

}  // namespace etalon
