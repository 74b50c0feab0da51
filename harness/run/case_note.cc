#include "run/case_note.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <tuple>

#include "base/file.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

bool IsWordPart(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::size_t SkipSpace(const std::string& text, std::size_t at) {
    return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
}

// Past the bracket that closes the one at `at`, or the end of the text.
std::size_t Behind(const std::string& text, std::size_t at, char open, char close) {
    int depth = 0;
    for (; at < text.size(); ++at) {
        depth += text[at] == open ? 1 : 0;
        depth -= text[at] == close ? 1 : 0;
        if (depth == 0) {
            return at + 1;
        }
    }
    return at;
}

// The position of the first word in [from, end) that a '(' follows, and the word.
std::pair<std::size_t, std::string> NextCall(const std::string& text, std::size_t from) {
    while (from < text.size()) {
        if (!IsWordPart(text[from])) {
            ++from;
            continue;
        }
        std::size_t end = from;
        while (end < text.size() && IsWordPart(text[end])) {
            ++end;
        }
        const std::size_t next = SkipSpace(text, end);
        if (next < text.size() && text[next] == '(') {
            return {from, text.substr(from, end - from)};
        }
        from = end;
    }
    return {text.size(), ""};
}

std::vector<std::string> CallsIn(const std::string& text) {
    std::vector<std::string> calls;
    for (auto [at, name] = NextCall(text, 0); at < text.size();
         std::tie(at, name) = NextCall(text, at + name.size())) {
        calls.push_back(name);
    }
    return calls;
}

std::string WithoutComments(const std::string& text) {
    std::string code;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t line = text.find("//", at);
        const std::size_t block = text.find("/*", at);
        const std::size_t begin = std::min({line, block, text.size()});
        code += text.substr(at, begin - at) + " ";
        if (begin == text.size()) {
            break;
        }
        at = begin == line ? text.find('\n', begin) : text.find("*/", begin + 2);
        at = at == std::string::npos ? text.size() : at + (begin == line ? 0 : 2);
    }
    return code;
}

struct Definition {
    fs::path file;
    std::string body;
};

// The functions that a case's sources define, by name.
class Definitions {
  public:
    explicit Definitions(const Case& source) : case_(source) {
        Read(source.root / source.source);
        for (const std::string& with : source.with) {
            Read(source.root / with);
        }
    }

    const Definition* Find(const std::string& name) const {
        const auto found = by_name_.find(name);
        return found == by_name_.end() ? nullptr : &found->second;
    }

  private:
    // What cannot be read has been complained of where the case was compiled.
    void Read(const fs::path& path) {
        const fs::path file = path.lexically_normal();
        if (!seen_.insert(file).second) {
            return;
        }
        const Result<std::string> text = ReadTextFile(file);
        if (!text) {
            return;
        }
        std::string code;
        const std::string plain = WithoutComments(*text);
        for (std::size_t at = 0; at < plain.size();) {
            const std::size_t end = std::min(plain.find('\n', at), plain.size());
            const std::string line = plain.substr(at, end - at);
            const std::size_t first = line.find_first_not_of(" \t");
            if (first != std::string::npos && line[first] == '#') {
                ReadInclude(line, file);
            } else {
                code += line + "\n";
            }
            at = end + 1;
        }
        for (auto [at, name] = NextCall(code, 0); at < code.size();) {
            const std::size_t behind = Behind(code, code.find('(', at), '(', ')');
            const std::size_t brace = SkipSpace(code, behind);
            std::size_t next = at + name.size();
            if (brace < code.size() && code[brace] == '{') {
                next = Behind(code, brace, '{', '}');
                by_name_.try_emplace(name, Definition{file, code.substr(brace, next - brace)});
            }
            std::tie(at, name) = NextCall(code, next);
        }
    }

    void ReadInclude(const std::string& line, const fs::path& file) {
        const std::size_t open = line.find_first_of("\"<");
        if (line.find("include") == std::string::npos || open == std::string::npos) {
            return;
        }
        const std::size_t close = line.find_first_of("\">", open + 1);
        const std::string name = line.substr(open + 1, close - open - 1);
        std::vector<fs::path> folders = {file.parent_path()};
        for (const std::string& include : case_.include) {
            folders.push_back(case_.root / include);
        }
        for (const fs::path& folder : folders) {
            std::error_code ignored;
            if (fs::is_regular_file(folder / name, ignored)) {
                Read(folder / name);
                return;
            }
        }
    }

    const Case& case_;
    std::set<fs::path> seen_;
    std::map<std::string, Definition> by_name_;
};

class Search {
  public:
    explicit Search(const Case& source) : case_(source), definitions_(source) {}

    void Add(const std::string& text) {
        for (const std::string& name : CallsIn(text)) {
            const Definition* definition = definitions_.Find(name);
            if (definition == nullptr || !seen_.insert(name).second) {
                continue;
            }
            const std::string file =
                definition->file.lexically_relative(case_.root.empty() ? "." : case_.root)
                    .generic_string();
            if (file.starts_with("cases/")) {
                Add(definition->body);
            } else {
                found_.push_back({name, file});
            }
        }
    }
    const std::vector<FunctionNote>& found() const { return found_; }

  private:
    const Case& case_;
    Definitions definitions_;
    std::set<std::string> seen_;
    std::vector<FunctionNote> found_;
};

}  // namespace

CaseNote NoteOf(const Case& source) {
    CaseNote note;
    note.path = source.path;
    note.covers = source.covers;
    Search search(source);
    // A case of laws alone has a call that nothing judges.
    if (!source.expectations.empty()) {
        search.Add(source.call);
    }
    for (const Law& law : source.laws) {
        search.Add(law.left);
        search.Add(law.right);
    }
    note.functions = search.found();
    for (const Expectation& expectation : source.expectations) {
        if (expectation.truth) {
            note.oracles.push_back(expectation.truth->text());
        }
    }
    note.laws = source.laws.size();
    return note;
}

}  // namespace etalon
