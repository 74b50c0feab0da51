#include "compile/compile.h"

#include <glslang/Include/intermediate.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "compile/includer.h"
#include "compile/spirv.h"
#include "compile/stubs.h"
#include "compile/text.h"
#include "compile/types.h"

namespace etalon {
namespace {

constexpr std::uint32_t kVersion = 450;
constexpr std::size_t kMostWords = 4096;

EShLanguage StageOf(Stage stage) {
    return stage == Stage::kCompute ? EShLangCompute : EShLangFragment;
}

// A shader in glslang's hands: the pieces, whose text it points into, and what it includes.
class FrontEnd {
  public:
    FrontEnd(const Call& call, Stage stage, const std::vector<Piece>& pieces)
        : includer_(call), shader_(StageOf(stage)), text_(Assemble(pieces)) {
        static std::once_flag once;
        std::call_once(once, [] { glslang::InitializeProcess(); });
        shader_.setStringsWithLengthsAndNames(&data_, &length_, &name_, 1);
    }

    void AimAt(Target::Client client) {
        // The binding of the first image follows those of the buffers; see probe/program.h.
        shader_.setShiftBinding(glslang::EResTexture, kFirstImageBinding);
        shader_.setShiftBinding(glslang::EResSampler, kFirstImageBinding);
        shader_.setAutoMapBindings(true);
        shader_.setAutoMapLocations(true);
        if (client == Target::Client::kVulkan) {
            shader_.setEnvInput(glslang::EShSourceGlsl, shader_.getStage(),
                                glslang::EShClientVulkan, 100);
            shader_.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
            shader_.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
            shader_.setEnvInputVulkanRulesRelaxed();
        } else {
            shader_.setEnvInput(glslang::EShSourceGlsl, shader_.getStage(),
                                glslang::EShClientOpenGL, 100);
            shader_.setEnvClient(glslang::EShClientOpenGL, glslang::EShTargetOpenGL_450);
            shader_.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
        }
    }

    static EShMessages Rules(std::optional<Target::Client> client) {
        if (!client) {
            return EShMsgDefault;
        }
        return *client == Target::Client::kVulkan
                   ? static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules)
                   : EShMsgSpvRules;
    }

    Status<> Parse(std::uint32_t version, std::optional<Target::Client> client) {
        if (!shader_.parse(GetDefaultResources(), static_cast<int>(version), ECoreProfile, true,
                           false, Rules(client), includer_)) {
            return Error{InUsersWords(FirstError(shader_.getInfoLog()))};
        }
        return Ok();
    }

    Result<std::string> Preprocess(std::uint32_t version) {
        std::string text;
        if (!shader_.preprocess(GetDefaultResources(), static_cast<int>(version), ECoreProfile,
                                true, false, Rules({}), &text, includer_)) {
            return Error{FirstError(shader_.getInfoLog())};
        }
        return text;
    }

    glslang::TShader& shader() { return shader_; }
    const Dialect& dialect() const { return includer_.dialect(); }

  private:
    // What is found wrong in the generated text, which follows the sources, was left open by them.
    std::string InUsersWords(const std::string& error) const {
        const std::string mark = std::string(kGenerated) + ":";
        if (!error.starts_with(mark)) {
            return error;
        }
        const std::size_t reason = error.find(": ", mark.size());
        return includer_.last_source() + ": does not end where it should" +
               (reason == std::string::npos ? "" : ": " + error.substr(reason + 2));
    }

    // glslang forgets the names of further strings after an #include in the first, hence one string
    // and #line.
    static std::string Assemble(const std::vector<Piece>& pieces) {
        std::string text = "#extension GL_GOOGLE_cpp_style_line_directive : enable\n";
        for (const Piece& piece : pieces) {
            std::string name = piece.name;  // GLSL knows no escapes
            std::replace(name.begin(), name.end(), '"', '\'');
            std::replace(name.begin(), name.end(), '\n', ' ');
            text += "\n#line 1 \"" + name + "\"\n" + piece.text;
        }
        return text;
    }

    Includer includer_;
    glslang::TShader shader_;
    const std::string text_;
    // glslang keeps the addresses of these three.
    const char* const data_ = text_.data();
    const int length_ = static_cast<int>(text_.size());
    const char* const name_ = kGenerated;
};

// How the sources are written, from the files themselves: the generated text depends on it.
Result<Dialect> ReadDialect(const Call& call) {
    Includer includer(call);
    for (std::size_t i = 0; i <= call.with.size(); ++i) {
        const std::string header = kSourceMark + std::to_string(i);
        auto* result = includer.includeLocal(header.c_str(), kGenerated, 1);
        const bool found = !result->headerName.empty();
        const std::string reason(result->headerData, result->headerLength);
        includer.releaseInclude(result);
        if (!found) {
            return Error{reason};
        }
    }
    // Once more with all that they include. What is wrong in there the compiler tells later.
    FrontEnd front(call, Stage::kFragment, SourcesShader(call));
    (void)front.Preprocess(kVersion);
    return front.dialect();
}

// Images in the order of the bindings that the linked program gives them; text has none, there
// names count. A sampler without an image, and any other uniform, has no value.
Result<std::vector<BoundImage>> BindImages(glslang::TProgram& program, const Call& call,
                                           bool has_bindings) {
    const auto image_of = [&](const std::string& name) {
        return std::find_if(call.images.begin(), call.images.end(),
                            [&](const BoundImage& image) { return image.name == name; });
    };
    std::vector<BoundImage> bound;
    for (int i = 0; i < program.getNumUniformVariables(); ++i) {
        const glslang::TObjectReflection& uniform = program.getUniform(i);
        if (uniform.name.rfind("etalon_", 0) == 0) {
            continue;
        }
        const auto image = image_of(uniform.name);
        const glslang::TType* type = uniform.getType();
        if (type == nullptr || type->getBasicType() != glslang::EbtSampler) {
            return Error{call.source.string() + ": uniform '" + uniform.name +
                         "' has no value; an input of its name gives it one"};
        }
        const glslang::TSampler& sampler = type->getSampler();
        const bool is_cube = sampler.dim == glslang::EsdCube;
        if ((sampler.dim != glslang::Esd2D && !is_cube) || sampler.arrayed || sampler.shadow ||
            sampler.ms || sampler.type != glslang::EbtFloat || !sampler.combined ||
            type->isArray()) {
            return Error{call.source.string() + ": '" + uniform.name +
                         "' is no plain sampler2D or samplerCube, and only these take an image"};
        }
        if (image == call.images.end()) {
            return Error{call.source.string() + ": sampler '" + uniform.name + "' has no image; " +
                         (is_cube ? "--image '" + uniform.name + "={ cube = true, ... }'"
                                  : "--with " + uniform.name + "=IMAGE") +
                         " gives one"};
        }
        if (is_cube != (image->image->shape == ImageShape::kCube)) {
            return Error{
                call.source.string() + ": '" + uniform.name + "' is a " +
                (is_cube ? "samplerCube, its image is flat" : "sampler2D, its image is a cube")};
        }
        if (!has_bindings) {
            bound.push_back(*image);
            continue;
        }
        const int binding = uniform.getBinding() - static_cast<int>(kFirstImageBinding);
        if (binding < 0 || binding > 15) {
            return Error{call.source.string() + ": sampler '" + uniform.name +
                         "' has a binding outside 0..15"};
        }
        if (bound.size() <= static_cast<std::size_t>(binding)) {
            bound.resize(static_cast<std::size_t>(binding) + 1);
        }
        BoundImage& place = bound[static_cast<std::size_t>(binding)];
        if (place.image != nullptr) {
            return Error{call.source.string() + ": samplers '" + place.name + "' and '" +
                         uniform.name + "' have the same binding"};
        }
        place = *image;
    }
    for (BoundImage& image : bound) {
        if (image.image == nullptr) {
            // A gap between explicit bindings: a device expects images without gaps.
            image.image = std::make_shared<Image>(Image{1, 1, {0, 0, 0, 0}});
        }
    }
    return bound;
}

Result<std::vector<BoundImage>> Link(FrontEnd& front, glslang::TProgram& program, const Call& call,
                                     std::optional<Target::Client> client) {
    program.addShader(&front.shader());
    if (!program.link(FrontEnd::Rules(client))) {
        return Error{LinkError(program.getInfoLog(), call.source.string())};
    }
    if (client && !program.mapIO()) {
        return Error{FirstError(program.getInfoLog())};
    }
    program.buildReflection(EShReflectionSeparateBuffers);
    return BindImages(program, call, client.has_value());
}

// The statements of etalon_inspect, in order.
const glslang::TIntermSequence* InspectedStatements(TIntermNode* root) {
    for (TIntermNode* node : root->getAsAggregate()->getSequence()) {
        glslang::TIntermAggregate* function = node->getAsAggregate();
        if (function != nullptr && function->getOp() == glslang::EOpFunction &&
            function->getName().rfind("etalon_inspect(", 0) == 0) {
            const glslang::TIntermSequence& parts = function->getSequence();
            return parts.size() < 2 ? nullptr : &parts[1]->getAsAggregate()->getSequence();
        }
    }
    return nullptr;
}

Result<Signature> InspectIn(const Call& call, Stage stage, const Dialect& dialect) {
    FrontEnd front(call, stage, InspectionShader(call, dialect));
    front.AimAt(Target::Client::kVulkan);
    const std::uint32_t version =
        dialect.es ? kVersion : std::max(kVersion, std::min(dialect.version, 460u));
    ETALON_TRY_STEP(front.Parse(version, Target::Client::kVulkan));
    glslang::TProgram program;
    ETALON_TRY(images, Link(front, program, call, Target::Client::kVulkan));
    Signature signature;
    for (const BoundImage& image : images) {
        signature.images.push_back(image.name);
    }
    signature.dialect = dialect;
    signature.version = version;
    signature.stage = stage;
    const auto* statements = InspectedStatements(front.shader().getIntermediate()->getTreeRoot());
    const std::size_t expected = call.arguments.size() + call.wanted.size();
    if (statements == nullptr || statements->size() != expected) {
        return Error{call.wanted.front().origin + ": is not one expression"};
    }
    for (std::size_t i = 0; i < expected; ++i) {
        const bool is_argument = i < call.arguments.size();
        const std::string what =
            is_argument ? "'" + call.arguments[i].name + "'"
                        : call.wanted[i - call.arguments.size()].origin + ": the result";
        const glslang::TIntermTyped* typed = (*statements)[i]->getAsTyped();
        if (typed == nullptr) {
            return Error{what + " is not an expression"};
        }
        Result<Type> type = FromGlslang(typed->getType());
        if (!type) {
            return Error{what + " " + type.error().message};
        }
        (is_argument ? signature.arguments : signature.wanted).push_back(std::move(*type));
    }
    for (const std::size_t words : {signature.InputWords(call), signature.OutputWords(call)}) {
        if (words > kMostWords) {
            return Error{call.wanted.front().origin + ": " + std::to_string(words) +
                         " values a row are more than the " + std::to_string(kMostWords) +
                         " that a probe carries"};
        }
    }
    if (signature.OutputWords(call) == 0) {
        return Error{call.wanted.front().origin +
                     ": the call has no result and no out parameter, so there is nothing to see; "
                     "--out NAME:TYPE declares one"};
    }
    return signature;
}

// Refuses what would reach beyond the place of an expression in the generated text.
Status<> IsOneExpression(const Call& call) {
    for (const Wanted& wanted : call.wanted) {
        std::string open;
        bool is_broken = wanted.text.find_first_not_of(" \t") == std::string::npos;
        for (const char c : wanted.text) {
            is_broken =
                is_broken || std::string_view(";{}#\\\n\r").find(c) != std::string_view::npos;
            if (c == '(' || c == '[') {
                open += c;
            } else if (c == ')' || c == ']') {
                is_broken = is_broken || open.empty() || open.back() != (c == ')' ? '(' : '[');
                if (!open.empty()) {
                    open.pop_back();
                }
            }
        }
        // A comment would swallow what follows the call.
        is_broken = is_broken || wanted.text.find("//") != std::string::npos ||
                    wanted.text.find("/*") != std::string::npos;
        if (is_broken || !open.empty()) {
            std::string shown = wanted.text;
            std::replace_if(
                shown.begin(), shown.end(), [](unsigned char c) { return c < ' '; }, ' ');
            return Error{wanted.origin + ": '" + shown + "' is not one GLSL expression"};
        }
    }
    return Ok();
}

// In a compute shader, or where that cannot be in a fragment shader: derivatives and the like exist
// only there.
Result<Signature> InspectInEitherStage(const Call& call, const Dialect& dialect) {
    Result<Signature> compute = InspectIn(call, Stage::kCompute, dialect);
    if (compute) {
        return compute;
    }
    Result<Signature> fragment = InspectIn(call, Stage::kFragment, dialect);
    const bool is_about_stage = compute.error().message.find("compute") != std::string::npos;
    return fragment || is_about_stage ? fragment : compute;
}

}  // namespace

Result<Signature> Inspect(const Call& call) {
    if (auto one = IsOneExpression(call); !one) {
        return one.error();
    }
    ETALON_TRY(dialect, ReadDialect(call));
    Result<Signature> first = InspectInEitherStage(call, dialect);
    if (first) {
        return first;
    }
    // glslang gives parameters a precision for Vulkan but built-in functions none, and then refuses
    // a source's own version of a built-in function, which GLSL allows.
    if (first.error().message.find("must have the same parameter") != std::string::npos) {
        Dialect renaming = dialect;
        renaming.rename_redefined = true;
        if (Result<Signature> renamed = InspectInEitherStage(call, renaming)) {
            return renamed;
        }
        return Error{first.error().message +
                     " (the function has the name of a built-in one; -D NAME=OTHER renames it)"};
    }
    // A further source may define what the first one only declares, or what it uses without a word.
    if (!call.with.empty()) {
        Dialect turned = dialect;
        turned.with_first = true;
        if (Result<Signature> other = InspectInEitherStage(call, turned)) {
            return other;
        }
    }
    return first;
}

Result<Program, CompileFailure> Compile(const Call& call, const Signature& signature,
                                        const Recipe& recipe, Target target,
                                        std::span<const std::vector<std::uint32_t>> baked,
                                        Lines lines) {
    using Kind = CompileFailure::Kind;
    Program program;
    program.stage = recipe.stage;
    program.form = recipe.form;
    program.input_words = recipe.baked ? 0 : signature.InputWords(call);
    program.output_words = signature.OutputWords(call);
    const std::vector<Piece> pieces = ProbeShader(call, signature, recipe, baked);

    const bool is_text = recipe.form == Form::kGlsl;
    std::optional<Target::Client> client;
    std::uint32_t version = signature.version;
    if (!is_text) {
        client = target.client;
    } else {
        version = std::min(signature.version, target.glsl_version);
    }
    FrontEnd front(call, recipe.stage, pieces);
    if (client) {
        front.AimAt(*client);
    }
    if (auto parsed = front.Parse(version, client); !parsed) {
        // The sources compiled when their types were found; what fails now fails for this target.
        return CompileFailure{Kind::kUnsupported, parsed.error().message + " (in GLSL " +
                                                      std::to_string(version) + ")"};
    }
    const std::string stubs = is_text ? StubsFor(*front.shader().getIntermediate()) : "";
    glslang::TProgram linked;
    Result<std::vector<BoundImage>> images = Link(front, linked, call, client);
    if (!images) {
        return CompileFailure{Kind::kInput, images.error().message};
    }
    program.images = std::move(*images);

    if (is_text) {
        FrontEnd reader(call, recipe.stage, pieces);
        Result<std::string> text = reader.Preprocess(version);
        if (!text) {
            return CompileFailure{Kind::kUnsupported, text.error().message};
        }
        program.glsl = DriverText(*text, version, program.line_names) + stubs;
        return program;
    }
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    options.generateDebugInfo = lines == Lines::kKept;
    glslang::GlslangToSpv(*linked.getIntermediate(StageOf(recipe.stage)), program.spirv, &options);
    if (recipe.precise) {
        program.spirv = ForbidContraction(program.spirv);
    }
    if (recipe.optimise != Recipe::Optimise::kNone) {
        auto better = OptimiseSpirv(program.spirv, recipe.optimise, target);
        if (!better) {
            return CompileFailure{Kind::kUnsupported, better.error().message};
        }
        program.spirv = std::move(*better);
    }
    if (auto valid = ValidateSpirv(program.spirv, target); !valid) {
        return CompileFailure{Kind::kUnsupported, valid.error().message};
    }
    return program;
}

}  // namespace etalon
