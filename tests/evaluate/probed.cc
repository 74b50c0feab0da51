#include "evaluate/probed.h"

#include <unistd.h>

#include <bit>
#include <fstream>

#include "compile/compile.h"
#include "spirv/read.h"

namespace etalon {

Probed::Probed(const std::string& source, const std::string& expression,
               const std::vector<std::string>& inputs, const std::string& recipe,
               std::vector<BoundImage> images) {
    const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                       ("etalon-evaluate-" + std::to_string(getpid()) + ".glsl");
    std::ofstream(path, std::ios::binary) << source;
    Call call;
    call.source = path;
    call.images = std::move(images);
    for (const std::string& input : inputs) {
        const std::size_t space = input.rfind(' ');
        call.arguments.push_back({input.substr(space + 1), input.substr(0, space), true, false});
    }
    call.wanted = {{"result", expression, "CALL"}};
    const Result<Signature> signature = Inspect(call);
    if (!signature) {
        error_ = signature.error().message;
    } else {
        Result<Program, CompileFailure> program =
            Compile(call, *signature, *ParseRecipe(recipe), Target{}, {});
        if (!program) {
            error_ = program.error().reason;
        } else {
            program_ = *program;
            Result<spirv::Module> module = spirv::ReadModule(program_.spirv);
            if (!module) {
                error_ = module.error().message;
            } else if (auto plan = evaluate::MakePlan(std::move(*module)); !plan) {
                error_ = plan.error().message;
            } else {
                plan_ = *plan;
            }
        }
    }
    std::filesystem::remove(path);
}

std::vector<float> Probed::Floats(const std::vector<std::vector<float>>& inputs) const {
    std::vector<std::vector<std::uint32_t>> words;
    for (const auto& column : inputs) {
        words.emplace_back();
        for (const float x : column) {
            words.back().push_back(std::bit_cast<std::uint32_t>(x));
        }
    }
    const auto out = Words<float>(words);
    std::vector<float> floats;
    for (const std::uint32_t word : out.ok() ? *out : std::vector<std::uint32_t>{}) {
        floats.push_back(std::bit_cast<float>(word));
    }
    return floats;
}

}  // namespace etalon
