// Resolves the sources of a call and their #includes, within the folders that may be read.
#pragma once

#include <glslang/Public/ShaderLang.h>

#include <filesystem>
#include <list>
#include <string>
#include <vector>

#include "probe/call.h"
#include "probe/generate.h"

namespace etalon {

// A source file is found beside the file that includes it, then under the roots. What lies above
// the folders of the sources and the roots is refused, links resolved; so is a file that includes
// itself, directly or not.
class Includer : public glslang::TShader::Includer {
  public:
    explicit Includer(const Call& call);

    IncludeResult* includeLocal(const char* header, const char* includer, size_t depth) override;
    IncludeResult* includeSystem(const char* header, const char* includer, size_t depth) override;
    void releaseInclude(IncludeResult* result) override;

    // What is known of the sources read so far.
    const Dialect& dialect() const { return dialect_; }

    // The source that comes last in the shader, as the user calls it.
    std::string last_source() const { return last_source_; }

  private:
    IncludeResult* Include(const std::string& header, const std::string& includer, bool beside);
    IncludeResult* Open(const std::filesystem::path& path);
    IncludeResult* Refuse(const std::string& reason);
    bool MayRead(const std::filesystem::path& path) const;

    const Call& call_;
    std::vector<std::string> inputs_;             // their names
    std::vector<std::filesystem::path> allowed_;  // canonical
    std::vector<std::filesystem::path> open_;  // canonical; the files being read, outermost first
    std::list<std::string> texts_;             // glslang keeps pointers into these
    std::string refused_;  // reason of the last refusal, until something is read
    std::string last_source_;
    Dialect dialect_;
};

}  // namespace etalon
