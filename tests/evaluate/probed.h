// A GLSL function, compiled as a probe and evaluated on the host.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/evaluate.h"
#include "probe/call.h"
#include "probe/program.h"

namespace etalon {

class Probed {
  public:
    // `inputs` are declarations: "float x", "ivec2 v".
    Probed(const std::string& source, const std::string& expression,
           const std::vector<std::string>& inputs, const std::string& recipe = "spirv",
           std::vector<BoundImage> images = {});

    // Why there is no program or no plan; empty where there is.
    const std::string& error() const { return error_; }
    const Program& program() const { return program_; }
    const std::shared_ptr<const evaluate::Plan>& plan() const { return plan_; }

    // Columns of words in, columns of words out.
    template <typename Number = float>
    Result<std::vector<std::uint32_t>> Words(const std::vector<std::vector<std::uint32_t>>& inputs,
                                             std::vector<Number>* exact = nullptr,
                                             evaluate::Limits limits = {}) const {
        const auto rows = static_cast<std::uint32_t>(inputs.at(0).size());
        std::vector<std::uint32_t> in;
        for (const auto& column : inputs) {
            in.insert(in.end(), column.begin(), column.end());
        }
        std::vector<std::uint32_t> out(std::size_t{program_.output_words} * rows);
        std::vector<evaluate::Texture> images;
        for (const BoundImage& image : program_.images) {
            images.push_back({image.image, image.sampling});
        }
        evaluate::Evaluator<Number> evaluator(plan_, images, limits);
        evaluate::Rows<Number> run{rows, in, out};
        if (exact != nullptr) {
            exact->resize(out.size());
            run.exact = *exact;
        }
        ETALON_TRY_STEP(evaluator.Run(run));
        return out;
    }
    // Of floats.
    std::vector<float> Floats(const std::vector<std::vector<float>>& inputs) const;

  private:
    std::string error_;
    Program program_;
    std::shared_ptr<const evaluate::Plan> plan_;
};

}  // namespace etalon
