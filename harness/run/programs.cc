#include "run/programs.h"

#include <bit>

namespace etalon {

std::string Programs::KeyOf(const Call& call, const Recipe& recipe) {
    std::string key = RecipeText(recipe) + '\n' + call.source.string() + '\n';
    for (const auto& with : call.with) {
        key += with.string() + '\n';
    }
    for (const auto& root : call.include_roots) {
        key += root.string() + '\n';
    }
    for (const auto& [name, value] : call.defines) {
        key += name + '=' + value + '\n';
    }
    for (const BoundImage& bound : call.images) {
        key += bound.name + ' ' + std::to_string(std::bit_cast<std::uintptr_t>(bound.image.get())) +
               (bound.sampling.filter == Filter::kLinear ? " linear" : " nearest") +
               (bound.sampling.wrap == Wrap::kRepeat ? " repeat" : " clamp") + '\n';
    }
    for (const Argument& argument : call.arguments) {
        key += argument.type + ' ' + argument.name + (argument.is_input ? " in" : "") +
               (argument.is_output ? " out" : "") + '\n';
    }
    for (const Wanted& wanted : call.wanted) {
        key += wanted.text + '\n';
    }
    return key;
}

const Programs::Compiled& Programs::Get(const Call& call, const Signature& signature,
                                        const Recipe& recipe, Target target,
                                        const std::vector<std::vector<std::uint32_t>>& baked) {
    std::string key = KeyOf(call, recipe) +
                      (target.client == Target::Client::kVulkan ? "vulkan " : "opengl ") +
                      std::to_string(target.glsl_version) + '\n';
    for (const std::vector<std::uint32_t>& row : baked) {
        for (const std::uint32_t word : row) {
            key += std::to_string(word) + ' ';
        }
    }
    std::promise<std::unique_ptr<const Compiled>> promise;
    std::shared_future<std::unique_ptr<const Compiled>> future;
    bool is_new = false;
    {
        const std::lock_guard lock(mutex_);
        auto [entry, added] = entries_.try_emplace(key);
        if (added) {
            entry->second = {promise.get_future().share(), call.images};
        }
        is_new = added;
        future = entry->second.compiled;
    }
    if (is_new) {
        promise.set_value(
            std::make_unique<const Compiled>(Compile(call, signature, recipe, target, baked)));
    }
    return *future.get();
}

std::size_t Programs::size() const {
    const std::lock_guard lock(mutex_);
    return entries_.size();
}

}  // namespace etalon
