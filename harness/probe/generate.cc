#include "probe/generate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <set>

namespace etalon {
namespace {

// Words that became keywords after the version in which a source is written: they are renamed while
// it is read.
std::vector<std::string> LaterKeywords(const Dialect& dialect) {
    if (dialect.es) {
        return dialect.version < 310 ? std::vector<std::string>{"buffer", "shared", "precise"}
                                     : std::vector<std::string>{};
    }
    if (dialect.version == 0) {
        return {"sample", "patch", "shared", "buffer"};
    }
    std::vector<std::string> words;
    if (dialect.version < 400) {
        words = {"sample", "patch", "subroutine", "precise"};
    }
    if (dialect.version < 420) {
        for (const char* word : {"coherent", "restrict", "readonly", "writeonly"}) {
            words.emplace_back(word);
        }
    }
    if (dialect.version < 430) {
        words.emplace_back("buffer");
        words.emplace_back("shared");
    }
    return words;
}

// Built-in functions of GLSL 1.x that later versions call otherwise.
std::vector<std::pair<std::string, std::string>> OldNames(const Dialect& dialect) {
    const bool old = dialect.version <= 120 && !(dialect.es && dialect.version >= 300);
    if (!old) {
        return {};
    }
    return {{"texture2D", "texture"},
            {"textureCube", "texture"},
            {"texture2DLod", "textureLod"},
            {"texture2DProj", "textureProj"},
            {"texture2DLodEXT", "textureLod"},
            {"varying", ""},
            {"attribute", ""}};
}

class Text {
  public:
    explicit Text(std::vector<Piece>& pieces) : pieces_(pieces) {}
    Text& operator<<(std::string_view more) {
        if (pieces_.empty() || pieces_.back().name != kGenerated) {
            pieces_.push_back({kGenerated, ""});
        }
        pieces_.back().text += more;
        return *this;
    }
    Text& operator<<(std::size_t number) { return *this << std::to_string(number); }
    void User(const std::string& origin, const std::string& text) {
        pieces_.push_back({origin, text});
    }
    void Append(const std::vector<Piece>& more) {
        pieces_.insert(pieces_.end(), more.begin(), more.end());
    }

  private:
    std::vector<Piece>& pieces_;
};

// The identifiers of a text, each once.
std::vector<std::string> Identifiers(const std::vector<Piece>& pieces) {
    std::set<std::string> words;
    for (const Piece& piece : pieces) {
        std::string word;
        for (const char c : piece.text + " ") {
            const bool is_part = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
            if (is_part) {
                word += c;
                continue;
            }
            if (!word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) == 0) {
                words.insert(word);
            }
            word.clear();
        }
    }
    return {words.begin(), words.end()};
}

void Sources(const Call& call, const Dialect& dialect, Text& out) {
    const std::size_t sources = call.with.size() + 1;
    for (std::size_t i = 0; i < sources; ++i) {
        out << "#include \"" << kSourceMark << (dialect.with_first ? (i + 1) % sources : i)
            << "\"\n";
    }
}

void Defines(const Call& call, Text& out) {
    for (const auto& [name, value] : call.defines) {
        out << "#define " << name << " " << value << "\n";
    }
}

// True for an input that sets a uniform of the sources, which has become a global variable.
bool IsUniform(const Argument& argument, const Dialect& dialect) {
    return std::find(dialect.uniforms.begin(), dialect.uniforms.end(), argument.name) !=
           dialect.uniforms.end();
}

// What comes before the sources. The conversions stand here, under names of the generator's own,
// because a source may have functions or macros of the built-in ones' names.
void Prologue(const Call& call, const Dialect& dialect, Text& out) {
    out << "#extension GL_GOOGLE_include_directive : enable\n"
           "uint etalon_bits(float value) { return floatBitsToUint(value); }\n"
           "float etalon_value(uint bits) { return uintBitsToFloat(bits); }\n";
    for (const BoundImage& image : call.images) {
        const auto& declared = dialect.samplers;
        if (std::find(declared.begin(), declared.end(), image.name) == declared.end()) {
            const bool is_cube = image.image->shape == ImageShape::kCube;
            out << "uniform " << (is_cube ? "samplerCube " : "sampler2D ") << image.name << ";\n";
        }
    }
    out << "#define main etalon_word_main\n"
           "vec4 etalon_word_position;\n"
           "#define gl_Position etalon_word_position\n";
    if (dialect.rename_redefined) {
        for (const std::string& word : dialect.redefined) {
            out << "#define " << word << " etalon_word_" << word << "\n";
        }
    }
    Defines(call, out);
    for (const auto& [old, now] : OldNames(dialect)) {
        out << "#define " << old << " " << now << "\n";
    }
    for (const std::string& word : LaterKeywords(dialect)) {
        out << "#define " << word << " etalon_word_" << word << "\n";
    }
    Sources(call, dialect, out);
}

// Appends the generator's own part, in which no macro of the sources may have a meaning.
void AppendUntouched(const std::vector<Piece>& own, Text& out) {
    out << "\n";
    for (const std::string& word : Identifiers(own)) {
        if (!word.starts_with("gl_") && !word.starts_with("GL_")) {
            out << "#undef " << word << "\n";
        }
    }
    out.Append(own);
}

std::string Origin(const Argument& argument) {
    return (argument.is_output ? "out parameter '" : "input '") + argument.name + "'";
}

// `first` tells whether nothing stands before them.
void Parameters(const Call& call, const Dialect& dialect, bool first, Text& out) {
    for (const Argument& argument : call.arguments) {
        if (IsUniform(argument, dialect)) {
            continue;
        }
        const char* direction = argument.is_input ? "inout " : "out ";
        out << (first ? "" : ", ") << (argument.is_output ? direction : "");
        out.User(Origin(argument), argument.type + " " + argument.name);
        first = false;
    }
}

std::string ToWord(Scalar scalar, const std::string& value) {
    switch (scalar) {
        case Scalar::kFloat:
            return "etalon_bits(" + value + ")";
        case Scalar::kInt:
            return "uint(" + value + ")";
        case Scalar::kUint:
            return value;
        case Scalar::kBool:
            return "(" + value + " ? 1u : 0u)";
    }
    return value;
}

std::string FromWord(Scalar scalar, const std::string& word) {
    switch (scalar) {
        case Scalar::kFloat:
            return "etalon_value(" + word + ")";
        case Scalar::kInt:
            return "int(" + word + ")";
        case Scalar::kUint:
            return word;
        case Scalar::kBool:
            return "(" + word + " != 0u)";
    }
    return word;
}

// A literal of exactly this value. 17 digits of the binary64 leave no double rounding to the
// compiler.
std::string Literal(Scalar scalar, std::uint32_t word) {
    std::string bits = std::to_string(word) + "u";
    switch (scalar) {
        case Scalar::kFloat: {
            const float value = std::bit_cast<float>(word);
            if (!std::isfinite(value)) {
                return "etalon_value(" + bits + ")";
            }
            std::array<char, 40> digits{};
            std::snprintf(digits.data(), digits.size(), "%.17e",
                          std::abs(static_cast<double>(value)));
            return (std::signbit(value) ? "(-" : "(") + std::string(digits.data()) + ")";
        }
        case Scalar::kInt:
            return "int(" + bits + ")";
        case Scalar::kUint:
            return bits;
        case Scalar::kBool:
            return word != 0 ? "true" : "false";
    }
    return bits;
}

// Writes the body of main for one row: arguments, call, stores.
class RowWriter {
  public:
    RowWriter(const Call& call, const Signature& signature, const Recipe& recipe)
        : call_(call), signature_(signature), recipe_(recipe) {}

    // `word(column)` yields the GLSL of an input word; `literals`, if not null, stand in its place.
    template <typename Word, typename Store>
    void Write(Text& out, const std::vector<std::uint32_t>* literals, Word word, Store store) {
        std::size_t column = 0;
        for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
            const std::string local = "etalon_a" + std::to_string(i);
            out << "        " << TypeText(signature_.arguments[i]) << " " << local << ";\n";
            if (!call_.arguments[i].is_input) {
                continue;
            }
            for (const Leaf& leaf : Leaves(signature_.arguments[i])) {
                out << "        " << local << leaf.path << " = "
                    << (literals != nullptr ? Literal(leaf.scalar, (*literals)[column])
                                            : FromWord(leaf.scalar, word(column)))
                    << ";\n";
                ++column;
            }
        }
        std::string arguments;
        for (std::size_t i = 0; i < call_.wanted.size(); ++i) {
            if (signature_.wanted[i].kind != Type::Kind::kVoid) {
                const std::string local = "etalon_r" + std::to_string(i);
                out << "        "
                    << (recipe_.precise && recipe_.form == Form::kGlsl ? "precise " : "")
                    << TypeText(signature_.wanted[i]) << " " << local << ";\n";
                arguments += (arguments.empty() ? "" : ", ") + local;
            }
        }
        for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
            const std::string local = "etalon_a" + std::to_string(i);
            if (IsUniform(call_.arguments[i], signature_.dialect)) {
                out << "        " << call_.arguments[i].name << " = " << local << ";\n";
            } else {
                arguments += (arguments.empty() ? "" : ", ") + local;
            }
        }
        out << "        etalon_evaluate(" << arguments << ");\n";
        std::size_t output = 0;
        const auto write = [&](const std::string& local, const Type& type) {
            for (const Leaf& leaf : Leaves(type)) {
                out << "        " << store(output++, ToWord(leaf.scalar, local + leaf.path))
                    << "\n";
            }
        };
        for (std::size_t i = 0; i < call_.wanted.size(); ++i) {
            write("etalon_r" + std::to_string(i), signature_.wanted[i]);
        }
        for (std::size_t i = 0; i < call_.arguments.size(); ++i) {
            if (call_.arguments[i].is_output) {
                write("etalon_a" + std::to_string(i), signature_.arguments[i]);
            }
        }
    }

  private:
    const Call& call_;
    const Signature& signature_;
    const Recipe& recipe_;
};

void Evaluate(const Call& call, const Signature& signature, const Recipe& recipe, Text& out) {
    if (recipe.precise) {
        // A source of before 4.00 may use the word as a name; here it is the keyword.
        out << "\n#undef precise";
    }
    out << "\nvoid etalon_evaluate(";
    bool first = true;
    for (std::size_t i = 0; i < call.wanted.size(); ++i) {
        if (signature.wanted[i].kind != Type::Kind::kVoid) {
            out << (first ? "" : ", ")
                << (recipe.precise && recipe.form == Form::kGlsl ? "precise out " : "out ")
                << TypeText(signature.wanted[i]) << " etalon_r" << i;
            first = false;
        }
    }
    Parameters(call, signature.dialect, first, out);
    out << ") {\n";
    for (std::size_t i = 0; i < call.wanted.size(); ++i) {
        if (signature.wanted[i].kind != Type::Kind::kVoid) {
            out << "    etalon_r" << i << " = (";
            out.User(call.wanted[i].origin, call.wanted[i].text + ");");
            out << "\n";
        } else {
            out.User(call.wanted[i].origin, call.wanted[i].text + ";");
            out << "\n";
        }
    }
    out << "}\n";
}

void StorageMain(RowWriter rows, const Recipe& recipe,
                 std::span<const std::vector<std::uint32_t>> baked, Text& out) {
    const bool is_baked = recipe.baked;
    if (recipe.stage == Stage::kCompute) {
        out << "layout(local_size_x = " << std::size_t{kLocalSize} << ") in;\n";
    }
    out << "layout(std430, binding = 0) readonly buffer etalon_Inputs {\n"
           "    uint etalon_rows;\n    uint etalon_in[];\n};\n"
           "layout(std430, binding = 1) writeonly buffer etalon_Outputs { uint etalon_out[]; };\n"
           "void main() {\n";
    if (recipe.stage == Stage::kCompute) {
        out << "    uint etalon_row = gl_GlobalInvocationID.x;\n";
    } else {
        out << "    uint etalon_row = uint(gl_FragCoord.y) * " << std::size_t{kFragmentWidth}
            << "u + uint(gl_FragCoord.x);\n";
    }
    out << "    if (etalon_row >= etalon_rows) {\n        return;\n    }\n";
    const auto word = [](std::size_t column) {
        return "etalon_in[" + std::to_string(column) + "u * etalon_rows + etalon_row]";
    };
    const auto store = [](std::size_t column, const std::string& value) {
        return "etalon_out[" + std::to_string(column) + "u * etalon_rows + etalon_row] = " + value +
               ";";
    };
    if (!is_baked) {
        out << "    {\n";
        rows.Write(out, nullptr, word, store);
        out << "    }\n";
    }
    for (std::size_t i = 0; i < baked.size(); ++i) {
        out << "    if (etalon_row == " << i << "u) {\n";
        rows.Write(out, &baked[i], word, store);
        out << "    }\n";
    }
    out << "}\n";
}

void TargetMain(RowWriter rows, const Recipe& recipe, std::uint32_t output_words,
                std::span<const std::vector<std::uint32_t>> baked, Text& out) {
    const std::size_t targets = (std::min(output_words, kTargetWords) + 3) / 4;
    const std::size_t padded = (std::size_t{output_words} + 3) / 4 * 4;
    out << "uniform highp usampler2D etalon_inputs;\nuniform int etalon_lines;\n"
           "uniform int etalon_rows;\nuniform int etalon_first;\n";
    for (std::size_t i = 0; i < targets; ++i) {
        out << "layout(location = " << i << ") out uvec4 etalon_target" << i << ";\n";
    }
    out << "void main() {\n    ivec2 etalon_at = ivec2(gl_FragCoord.xy);\n"
           "    int etalon_row = etalon_at.y * "
        << std::size_t{kFragmentWidth}
        << " + etalon_at.x;\n    if (etalon_row >= etalon_rows) {\n        discard;\n    }\n"
           "    uint etalon_w["
        << padded << "];\n";
    for (std::size_t i = output_words; i < padded; ++i) {
        out << "    etalon_w[" << i << "] = 0u;\n";
    }
    const auto word = [](std::size_t column) {
        return "texelFetch(etalon_inputs, ivec2(etalon_at.x, " + std::to_string(column) +
               " * etalon_lines + etalon_at.y), 0).r";
    };
    const auto store = [](std::size_t column, const std::string& value) {
        return "etalon_w[" + std::to_string(column) + "] = " + value + ";";
    };
    if (!recipe.baked) {
        out << "    {\n";
        rows.Write(out, nullptr, word, store);
        out << "    }\n";
    }
    for (std::size_t i = 0; i < baked.size(); ++i) {
        out << "    if (etalon_row == " << i << ") {\n";
        rows.Write(out, &baked[i], word, store);
        out << "    }\n";
    }
    for (std::size_t i = 0; i < targets; ++i) {
        out << "    etalon_target" << i << " = uvec4(";
        for (std::size_t k = 0; k < 4; ++k) {
            const std::string at = std::to_string(4 * i + k);
            // A program of several passes chooses its words at run time; the last pass may reach
            // past the end.
            out << (k == 0 ? "" : ", ") << "etalon_w["
                << (output_words <= kTargetWords
                        ? at
                        : "etalon_first + " + at + " < " + std::to_string(padded) +
                              " ? etalon_first + " + at + " : 0")
                << "]";
        }
        out << ");\n";
    }
    out << "}\n";
}

}  // namespace

std::vector<Piece> SourcesShader(const Call& call) {
    std::vector<Piece> pieces;
    Text out(pieces);
    out << "#extension GL_GOOGLE_include_directive : enable\n";
    Defines(call, out);
    Sources(call, {}, out);
    return pieces;
}

std::vector<Piece> InspectionShader(const Call& call, const Dialect& dialect) {
    std::vector<Piece> pieces;
    Text out(pieces);
    Prologue(call, dialect, out);
    out << "\nvoid etalon_inspect(";
    Parameters(call, dialect, true, out);
    out << ") {\n";
    for (const Argument& argument : call.arguments) {
        out << "    " << argument.name << ";\n";
    }
    for (const Wanted& wanted : call.wanted) {
        out << "    (";
        out.User(wanted.origin, wanted.text + ");");
        out << "\n";
    }
    out << "}\n";
    // The call from main lets the linker see what it reaches: functions without a body, samplers.
    std::vector<Piece> own;
    Text main(own);
    main << "void main() {\n";
    std::string arguments;
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        const std::string local = "etalon_a" + std::to_string(i);
        main << "    ";
        main.User(Origin(call.arguments[i]), call.arguments[i].type + " " + local);
        main << ";\n";
        if (!IsUniform(call.arguments[i], dialect)) {
            arguments += (arguments.empty() ? "" : ", ") + local;
        }
    }
    main << "    etalon_inspect(" << arguments << ");\n}\n";
    // The arguments' types are still the sources' words.
    out << "#undef main\n";
    out.Append(own);
    return pieces;
}

std::vector<Piece> ProbeShader(const Call& call, const Signature& signature, const Recipe& recipe,
                               std::span<const std::vector<std::uint32_t>> baked) {
    std::vector<Piece> pieces;
    Text out(pieces);
    Prologue(call, signature.dialect, out);
    Evaluate(call, signature, recipe, out);
    std::vector<Piece> own;
    Text main(own);
    const RowWriter rows(call, signature, recipe);
    if (recipe.stage == Stage::kFragment && recipe.form == Form::kGlsl) {
        TargetMain(rows, recipe, signature.OutputWords(call), baked, main);
    } else {
        StorageMain(rows, recipe, baked, main);
    }
    AppendUntouched(own, out);
    return pieces;
}

}  // namespace etalon
