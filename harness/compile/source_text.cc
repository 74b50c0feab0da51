#include "compile/source_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string_view>

namespace etalon {
namespace {

constexpr std::string_view kReserved = "etalon_";

constexpr std::array kBuiltIns = {"abs",
                                  "acos",
                                  "acosh",
                                  "all",
                                  "any",
                                  "asin",
                                  "asinh",
                                  "atan",
                                  "atanh",
                                  "bitCount",
                                  "bitfieldExtract",
                                  "bitfieldInsert",
                                  "bitfieldReverse",
                                  "ceil",
                                  "clamp",
                                  "cos",
                                  "cosh",
                                  "cross",
                                  "degrees",
                                  "determinant",
                                  "distance",
                                  "dot",
                                  "equal",
                                  "exp",
                                  "exp2",
                                  "faceforward",
                                  "findLSB",
                                  "findMSB",
                                  "floatBitsToInt",
                                  "floatBitsToUint",
                                  "floor",
                                  "fma",
                                  "fract",
                                  "frexp",
                                  "greaterThan",
                                  "greaterThanEqual",
                                  "intBitsToFloat",
                                  "inverse",
                                  "inversesqrt",
                                  "isinf",
                                  "isnan",
                                  "ldexp",
                                  "length",
                                  "lessThan",
                                  "lessThanEqual",
                                  "log",
                                  "log2",
                                  "matrixCompMult",
                                  "max",
                                  "min",
                                  "mix",
                                  "mod",
                                  "modf",
                                  "noise1",
                                  "noise2",
                                  "noise3",
                                  "noise4",
                                  "normalize",
                                  "notEqual",
                                  "outerProduct",
                                  "packHalf2x16",
                                  "packSnorm2x16",
                                  "packSnorm4x8",
                                  "packUnorm2x16",
                                  "packUnorm4x8",
                                  "pow",
                                  "radians",
                                  "reflect",
                                  "refract",
                                  "round",
                                  "roundEven",
                                  "sign",
                                  "sin",
                                  "sinh",
                                  "smoothstep",
                                  "sqrt",
                                  "step",
                                  "tan",
                                  "tanh",
                                  "texture",
                                  "textureLod",
                                  "transpose",
                                  "trunc",
                                  "uintBitsToFloat",
                                  "unpackHalf2x16",
                                  "unpackSnorm2x16",
                                  "unpackSnorm4x8",
                                  "unpackUnorm2x16",
                                  "unpackUnorm4x8"};

bool IsBuiltIn(std::string_view word) {
    return std::find(kBuiltIns.begin(), kBuiltIns.end(), word) != kBuiltIns.end();
}

bool IsCapitalOrDigit(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool IsWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Words and single other characters, without comments, each with its line.
class Tokens {
  public:
    explicit Tokens(std::string_view text) : text_(text) {}

    // Empty at the end.
    std::string_view Next() {
        Skip();
        if (at_ >= text_.size()) {
            return {};
        }
        const std::size_t from = at_++;
        begin_ = from;
        if (IsWordCharacter(text_[from])) {
            while (at_ < text_.size() && IsWordCharacter(text_[at_])) {
                ++at_;
            }
        }
        return text_.substr(from, at_ - from);
    }
    std::size_t line() const { return line_; }
    // Where the last token begins.
    std::size_t begin() const { return begin_; }

  private:
    void Skip() {
        while (at_ < text_.size()) {
            const std::string_view rest = text_.substr(at_);
            if (rest[0] == '\n') {
                ++line_;
                ++at_;
            } else if (std::isspace(static_cast<unsigned char>(rest[0])) != 0) {
                ++at_;
            } else if (rest.starts_with("//")) {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (rest.starts_with("/*")) {
                const std::size_t end = std::min(rest.find("*/", 2), rest.size() - 2) + 2;
                line_ += static_cast<std::size_t>(std::count(
                    rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
                at_ += end;
            } else {
                return;
            }
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;
    std::size_t line_ = 1;
};

void AddOnce(std::string_view word, std::vector<std::string>& words) {
    if (std::find(words.begin(), words.end(), word) == words.end()) {
        words.emplace_back(word);
    }
}

// GLSL before 4.20 has no line continuation, but sources of other versions use it.
void JoinLines(std::string& text) {
    if (text.find('\\') == std::string::npos) {
        return;
    }
    std::string joined;
    std::size_t owed = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool crlf = text.compare(i, 3, "\\\r\n") == 0;
        if (crlf || text.compare(i, 2, "\\\n") == 0) {
            ++owed;
            i += crlf ? 2 : 1;
        } else {
            joined += text[i];
            if (text[i] == '\n') {
                joined.append(owed, '\n');
                owed = 0;
            }
        }
    }
    text = std::move(joined);
}

// Blanks the #version line, which only the generated shader may have, and reports what it said.
void TakeVersion(std::string& text, Dialect& dialect) {
    std::size_t line = 0;
    while (line < text.size()) {
        const std::size_t end = std::min(text.find('\n', line), text.size());
        std::size_t at = text.find_first_not_of(" \t", line);
        if (at < end && text[at] == '#') {
            at = text.find_first_not_of(" \t", at + 1);
            if (at < end && text.compare(at, 7, "version") == 0) {
                at = std::min(text.find_first_not_of(" \t", at + 7), end);
                std::uint32_t version = 0;
                std::from_chars(text.data() + at, text.data() + end, version);
                const std::string_view rest(text.data() + at, end - at);
                dialect.es = dialect.es || version == 100 || rest.find(" es") != rest.npos;
                dialect.version = std::max(dialect.version, version);
                std::fill(text.begin() + static_cast<std::ptrdiff_t>(line),
                          text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
                return;
            }
        }
        line = end + 1;
    }
}

// What a declaration says, from the word after `uniform` to the one before the semicolon.
struct Uniforms {
    std::vector<std::string> names;
    std::vector<std::string> with_value;  // those that the declaration gives a value
    bool is_opaque = false;               // samplers and the like
};

// sampler2D, usamplerCube, image2D, texture2D, subpassInput, sampler, atomic_uint
bool IsOpaque(std::string_view type) {
    if (type == "atomic_uint") {
        return true;
    }
    type.remove_prefix(type.starts_with('i') && !type.starts_with("image") ? 1 : 0);
    type.remove_prefix(type.starts_with('u') ? 1 : 0);
    for (const std::string_view kind : {"sampler", "image", "texture", "subpass"}) {
        const std::string_view rest = type.substr(type.starts_with(kind) ? kind.size() : 0);
        if (type.starts_with(kind) && (rest.empty() || IsCapitalOrDigit(rest.front()))) {
            return true;
        }
    }
    return false;
}

Uniforms ReadUniforms(const std::vector<std::string_view>& tokens) {
    Uniforms uniforms;
    int depth = 0;
    bool is_named = false;  // the present declarator has told its name
    std::string_view last;
    for (const std::string_view token : tokens) {
        // What stands before a name or a size may be a type; a name may be any word.
        const bool is_behind = IsWordCharacter(token.front()) || token == "[";
        uniforms.is_opaque = uniforms.is_opaque || (is_behind && IsOpaque(last));
        if (depth == 0 && !is_named && (token == "[" || token == "=" || token == ",")) {
            uniforms.names.emplace_back(last);
            is_named = true;
        }
        if (depth == 0 && token == "=") {
            uniforms.with_value.push_back(uniforms.names.back());
        }
        if (token == "[" || token == "(") {
            ++depth;
        } else if (token == "]" || token == ")") {
            --depth;
        } else if (depth == 0 && token == ",") {
            is_named = false;
        }
        last = token;
    }
    if (!is_named && !last.empty()) {
        uniforms.names.emplace_back(last);
    }
    return uniforms;
}

constexpr std::string_view kUniform = "uniform";

// What replaces a part of the text.
struct Edit {
    std::size_t place;
    std::size_t length;
    std::string_view text;
};

// Words that may stand before `in` and `out`, but not before `uniform`.
bool IsInterpolation(std::string_view word) {
    return word == "flat" || word == "smooth" || word == "noperspective" || word == "centroid" ||
           word == "sample" || word == "invariant";
}

// How the variables of a shader's stage are declared, in GLSL of any version.
bool IsOfStage(std::string_view word) {
    return word == "in" || word == "out" || word == "varying" || word == "attribute";
}

bool Has(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

// Reads the declarations of the text. `edits` receives what must change in it, in its order.
class NameReader {
  public:
    NameReader(std::string_view text, const std::vector<std::string>& inputs, Dialect& dialect,
               std::vector<Edit>& edits)
        : tokens_(text), inputs_(inputs), dialect_(dialect), edits_(edits) {}

    Status<> Read() {
        std::string_view before;
        std::string_view last;
        int depth = 0;
        int brackets = 0;
        std::size_t layout = 0;  // where the last one begins
        for (std::string_view token = tokens_.Next(); !token.empty(); token = tokens_.Next()) {
            if (token.starts_with(kReserved)) {
                return Error{std::to_string(tokens_.line()) + ": '" + std::string(token) +
                             "': names that begin with '" + std::string(kReserved) +
                             "' belong to the probe"};
            }
            const bool is_outside = depth == 0 && brackets == 0;
            if (token == kUniform) {
                ETALON_TRY(end, TakeUniforms({tokens_.begin(), kUniform.size(), ""}));
                token = end;
            } else if (is_outside && IsOfStage(token)) {
                ETALON_TRY(end, TakeStageVariables(token));
                token = end;
            } else if (is_outside && IsInterpolation(token)) {
                qualifiers_.push_back({tokens_.begin(), token.size(), ""});
            } else if (is_outside && token == "layout") {
                layout = tokens_.begin();
            } else if (is_outside && token != "(") {
                qualifiers_.clear();
            }
            if (token == "{" || token == "}") {
                depth += token == "{" ? 1 : -1;
            } else if (token == "(") {
                is_layout_ = is_outside && last == "layout";
                ++brackets;
            } else if (token == ")") {
                --brackets;
                if (is_layout_ && brackets == 0) {
                    qualifiers_.push_back({layout, tokens_.begin() + 1 - layout, ""});
                }
            }
            // "TYPE name (" at the top level defines or declares a function.
            if (depth == 0 && token == "(" && IsBuiltIn(last) && !before.empty() &&
                IsWordCharacter(before[0])) {
                AddOnce(last, dialect_.redefined);
            }
            before = last;
            last = token;
        }
        return Ok();
    }

  private:
    // Reads to the end of the declaration, or of the head of a block; returns the token there.
    std::string_view ReadDeclaration(std::vector<std::string_view>& declaration) {
        std::string_view token = tokens_.Next();
        for (; !token.empty() && token != ";" && token != "{"; token = tokens_.Next()) {
            declaration.push_back(token);
        }
        return token;
    }

    // The variables of a whole shader, between whose stages the probe does not stand: what comes in
    // is as good as a uniform, so that an input can set it, and what goes out a global variable.
    Result<std::string_view> TakeStageVariables(std::string_view direction) {
        // A vertex shader writes to its varyings.
        const bool is_out = direction == "out" || direction == "varying";
        const Edit word{tokens_.begin(), direction.size(), is_out ? "" : kUniform};
        const std::vector<Edit> before = std::move(qualifiers_);
        qualifiers_.clear();
        std::vector<std::string_view> declaration;
        const std::string_view end = ReadDeclaration(declaration);
        // "layout(...) in;" is no variable, and a block must stay what it is.
        if (declaration.empty() || end != ";") {
            return end;
        }
        edits_.insert(edits_.end(), before.begin(), before.end());
        edits_.push_back(word);
        return SetByInputs(ReadUniforms(declaration), {word.place, word.length, ""}, end);
    }

    Result<std::string_view> TakeUniforms(Edit without_word) {
        std::vector<std::string_view> declaration;
        const std::string_view end = ReadDeclaration(declaration);
        if (end != ";") {
            return end;
        }
        return SetByInputs(ReadUniforms(declaration), without_word, end);
    }

    // Makes those uniforms global variables that have a value or receive one from an input.
    Result<std::string_view> SetByInputs(const Uniforms& uniforms, Edit without_word,
                                         std::string_view end) {
        if (uniforms.is_opaque) {
            for (const std::string& name : uniforms.names) {
                AddOnce(name, dialect_.samplers);
            }
            return end;
        }
        std::string without;
        bool any_input = false;
        for (const std::string& name : uniforms.names) {
            if (Has(inputs_, name)) {
                any_input = true;
                AddOnce(name, dialect_.uniforms);
            } else if (!Has(uniforms.with_value, name)) {
                without = name;
            }
        }
        // A uniform without a value stays one, so that the compiler tells whether the call reaches
        // it; those that are declared together go together.
        if (without.empty()) {
            if (!edits_.empty() && edits_.back().place == without_word.place) {
                edits_.pop_back();
            }
            edits_.push_back(without_word);
        } else if (any_input) {
            return Error{
                std::to_string(tokens_.line()) + ": uniform '" + without +
                "' has no value, but stands in one declaration with one that an input sets"};
        }
        return end;
    }

    Tokens tokens_;
    const std::vector<std::string>& inputs_;
    Dialect& dialect_;
    std::vector<Edit>& edits_;
    std::vector<Edit> qualifiers_;  // those just read, should a variable of the stage follow
    bool is_layout_ = false;        // of the bracket that is open
};

}  // namespace

Result<std::string> PrepareSource(std::string text, const std::vector<std::string>& inputs,
                                  Dialect& dialect) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.starts_with(kByteOrderMark)) {
        text.erase(0, kByteOrderMark.size());
    }
    JoinLines(text);
    TakeVersion(text, dialect);
    std::vector<Edit> edits;
    ETALON_TRY_STEP(NameReader(text, inputs, dialect, edits).Read());
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
        text.replace(edit->place, edit->length, edit->text);
    }
    // A last line without its end would run into the line after the #include.
    text.push_back('\n');
    return text;
}

}  // namespace etalon
