#include "compile/includer.h"

#include <algorithm>

#include "base/check.h"
#include "base/file.h"
#include "compile/source_text.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

fs::path Canonical(const fs::path& path) {
    std::error_code ignored;
    fs::path canonical = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
    return canonical;
}

fs::path FolderOf(const fs::path& file) {
    const fs::path parent = file.parent_path();
    return parent.empty() ? fs::path(".") : parent;
}

// A file with an #include for each line must end some time, also where it has no guards.
constexpr std::size_t kMostIncludes = 4096;

}  // namespace

Includer::Includer(const Call& call) : call_(call) {
    for (const Argument& argument : call.arguments) {
        if (argument.is_input) {
            inputs_.push_back(argument.name);
        }
    }
    allowed_.push_back(Canonical(FolderOf(call.source)));
    for (const fs::path& with : call.with) {
        allowed_.push_back(Canonical(FolderOf(with)));
    }
    for (const fs::path& root : call.include_roots) {
        allowed_.push_back(Canonical(root));
    }
}

bool Includer::MayRead(const fs::path& path) const {
    return std::any_of(allowed_.begin(), allowed_.end(), [&](const fs::path& root) {
        const auto [end, at] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
        // A root that ends in a separator has an empty last element.
        return end == root.end() || (std::next(end) == root.end() && end->empty());
    });
}

Includer::IncludeResult* Includer::Refuse(const std::string& reason) {
    texts_.push_back(reason);
    refused_ = reason;
    return new IncludeResult("", texts_.back().data(), texts_.back().size(), nullptr);
}

Includer::IncludeResult* Includer::Open(const fs::path& path) {
    if (path.string().find_first_of("\"\n") != std::string::npos) {
        return Refuse("'" + path.string() +
                      "' has a quote or a line's end in its name, which GLSL cannot tell");
    }
    const fs::path canonical = Canonical(path);
    if (!MayRead(canonical)) {
        return Refuse("'" + path.string() +
                      "' is outside the folders that may be read; --include DIR adds one");
    }
    if (std::find(open_.begin(), open_.end(), canonical) != open_.end()) {
        return Refuse("'" + path.string() + "' includes itself");
    }
    Result<std::string> text = ReadTextFile(path);
    if (!text) {
        return Refuse(text.error().message);
    }
    if (texts_.size() >= kMostIncludes) {
        return Refuse("more than " + std::to_string(kMostIncludes) + " files are included");
    }
    Result<std::string> prepared = PrepareSource(std::move(*text), inputs_, dialect_);
    if (!prepared) {
        return Refuse(path.string() + ":" + prepared.error().message);
    }
    texts_.push_back(std::move(*prepared));
    open_.push_back(canonical);
    refused_.clear();
    return new IncludeResult(path.string(), texts_.back().data(), texts_.back().size(), this);
}

Includer::IncludeResult* Includer::Include(const std::string& header, const std::string& includer,
                                           bool beside) {
    const std::string_view mark(kSourceMark);
    if (header.starts_with(mark) && open_.empty()) {
        const std::size_t index = std::stoul(header.substr(mark.size()));
        const fs::path& source = index == 0 ? call_.source : call_.with.at(index - 1);
        last_source_ = source.string();
        return Open(source);
    }
    std::vector<fs::path> places;
    if (beside) {
        places.push_back(FolderOf(includer));
    }
    places.insert(places.end(), call_.include_roots.begin(), call_.include_roots.end());
    std::error_code ignored;
    for (const fs::path& place : places) {
        // The folder "." is left out of names, so that a source beside the user is called as the
        // user calls it.
        const fs::path path = (place == "." ? fs::path(header) : place / header).lexically_normal();
        if (fs::exists(path, ignored)) {
            return Open(path);
        }
    }
    return Refuse("'" + header + "' is not found" +
                  (beside ? " beside the file or under --include" : " under --include"));
}

Includer::IncludeResult* Includer::includeLocal(const char* header, const char* includer, size_t) {
    return Include(header, includer, true);
}

Includer::IncludeResult* Includer::includeSystem(const char* header, const char* includer, size_t) {
    // glslang comes here with a quoted header too, after includeLocal refused it; the first reason
    // is the better one.
    if (!refused_.empty()) {
        return Refuse(std::string(refused_));
    }
    return Include(header, includer, false);
}

void Includer::releaseInclude(IncludeResult* result) {
    if (result != nullptr && result->userData == this) {
        ETALON_CHECK(!open_.empty());
        open_.pop_back();
    }
    delete result;
}

}  // namespace etalon
