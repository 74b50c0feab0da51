#include "run/findings.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/format.h"
#include "numeric/number_text.h"
#include "report/reproducer.h"
#include "run/fit.h"
#include "run/observe.h"

namespace etalon {
namespace {

constexpr std::uint32_t kStorageVersion = 430;  // of GLSL: compute shaders and storage buffers
constexpr std::uint32_t kTextVersion = 450;

bool IsVulkan(const DeviceInfo& device) {
    return device.name.starts_with("vulkan:");
}

bool IsOpenGl(const DeviceInfo& device) {
    return device.name.starts_with("osmesa:") || device.name.starts_with("egl:");
}

FindingValue Told(Scalar scalar, std::uint32_t word, std::string name = "") {
    const Value value = ValueOf(scalar, word);
    return {std::move(name), value.decimal, value.hex, word};
}

std::string FileName(const Finding& finding, bool is_vulkan) {
    std::string name = finding.devices.front() + "-" +
                       finding.case_path.substr(finding.case_path.rfind('/') + 1) +
                       (is_vulkan ? ".c" : ".shader_test");
    std::replace(name.begin(), name.end(), ':', '-');
    return name;
}

// One candidate on its way to a finding.
class Closer {
  public:
    Closer(const Record& record, const DeviceInfo& device, Evaluations& evaluations,
           Programs& programs)
        : record_(record), device_(device), evaluations_(evaluations), programs_(programs) {
        const Observation& worst = *record.worst_outside;
        finding_.devices = {device.name};
        finding_.case_path = record.case_path;
        finding_.recipe = record.recipe;
        finding_.profile = record.profile;
        finding_.output = worst.output;
        finding_.excess = worst.allowed->excess;
        finding_.outside = record.outside;
        finding_.held = record.held;
        finding_.cause = record.known_cause;
        finding_.actual = {"", worst.actual.decimal, worst.actual.hex, 0};
        finding_.low = {"", worst.allowed->low.decimal, worst.allowed->low.hex, 0};
        finding_.high = {"", worst.allowed->high.decimal, worst.allowed->high.hex, 0};
    }

    // The error is why it does not stand; what is known is in finding().
    Result<std::string> Reproducer(const Case& source) {
        finding_.call = source.call;
        ETALON_TRY(prepared, PrepareAt(source, At()));
        const std::vector<ProbeColumn> outputs = OutputColumns(prepared.call, prepared.signature);
        const auto output =
            std::find_if(outputs.begin(), outputs.end(),
                         [&](const ProbeColumn& one) { return one.name == finding_.output; });
        if (prepared.judged.empty() || output == outputs.end()) {
            return Error{"it is of a law's side, of which there is no reproducer"};
        }
        ETALON_TRY(recipe, ParseRecipe(record_.recipe));
        const auto column = static_cast<std::size_t>(output - outputs.begin());
        ETALON_TRY_STEP(Confirm(prepared, recipe, column, output->scalar));
        Reproduction reproduction;
        reproduction.inputs = recipe.baked ? std::vector<std::uint32_t>{} : prepared.table.words;
        reproduction.outputs = static_cast<std::uint32_t>(outputs.size());
        reproduction.output = static_cast<std::uint32_t>(column);
        reproduction.is_float = output->scalar == Scalar::kFloat;
        reproduction.low = finding_.low.word;
        reproduction.high = finding_.high.word;
        return Write(prepared, recipe, std::move(reproduction));
    }

    Finding& finding() { return finding_; }

  private:
    std::string At() const {
        std::string at;
        for (const auto& [name, value] : record_.worst_outside->inputs) {
            at += (at.empty() ? "" : ",") + name + "=" + value.hex;
        }
        return at;
    }

    // Whether the strict reading is itself allowed, and the result is not, at this row alone.
    Status<> Confirm(const PreparedCase& prepared, const Recipe& recipe, std::size_t column,
                     Scalar scalar) {
        for (std::size_t i = 0; i < prepared.table.columns.size(); ++i) {
            finding_.inputs.push_back(Told(prepared.table.columns[i].scalar,
                                           prepared.table.At(0, i),
                                           prepared.table.columns[i].name));
        }
        Evaluation& evaluation =
            evaluations_.Of(prepared.call, prepared.signature, recipe,
                            {prepared.table.words, 1, prepared.table.columns.size()});
        const Result<Evaluation::Values>& values = evaluation.Get();
        if (!values) {
            return values.error();
        }
        const Result<Evaluation::Bounds>& bounds = evaluation.BoundsBy(ProfileOf(device_));
        if (!bounds) {
            return bounds.error();
        }
        if (bounds->is_void[column]) {
            return Error{"the strict evaluation in binary32 lies outside too"};
        }
        const Allowed& allowed = bounds->allowed[column];
        if (allowed.kind == Allowed::Kind::kUnbounded) {
            return Error{"at this input alone there is no bound"};
        }
        const bool is_number = allowed.kind == Allowed::Kind::kNumber;
        finding_.low =
            Told(scalar, is_number ? std::bit_cast<std::uint32_t>(allowed.low) : allowed.word);
        finding_.high =
            Told(scalar, is_number ? std::bit_cast<std::uint32_t>(allowed.high) : allowed.word);
        finding_.strict = Told(scalar, values->strict[column]);
        ETALON_TRY(actual, ParseWord(scalar, record_.worst_outside->actual.hex));
        finding_.actual = Told(scalar, actual);
        if (Excess(allowed, actual) == 0) {
            return Error{"at this input alone the result is allowed"};
        }
        return Ok();
    }

    Result<std::string> Write(const PreparedCase& prepared, Recipe recipe,
                              Reproduction reproduction) {
        if (!IsVulkan(device_) && !IsOpenGl(device_)) {
            return Error{"no other tool runs this device"};
        }
        recipe.stage = Stage::kCompute;
        Target target;
        if (IsOpenGl(device_)) {
            recipe.form = Form::kGlsl;
            recipe.optimise = Recipe::Optimise::kNone;
            target = {Target::Client::kOpenGl, kTextVersion};
        }
        std::vector<std::vector<std::uint32_t>> baked;
        if (recipe.baked) {
            baked = {prepared.table.words};
        }
        const Programs::Compiled& program =
            programs_.Get(prepared.call, prepared.signature, recipe, target, baked);
        if (!program) {
            return Error{"there is no program for a reproducer: " + program.error().reason};
        }
        if (!program->images.empty()) {
            return Error{"it reads images, which no reproducer brings"};
        }
        finding_.reproducer = FileName(finding_, IsVulkan(device_));
        reproduction.notes = Notes();
        if (IsVulkan(device_)) {
            const std::string& name = device_.description;
            return VulkanProgram(reproduction, program->spirv, name.substr(0, name.find(" (")));
        }
        return ShaderTest(reproduction, program->glsl,
                          device_.glsl_version >= kStorageVersion
                              ? std::min(device_.glsl_version, kTextVersion)
                              : 330);
    }

    std::vector<std::string> Notes() const {
        std::vector<std::string> notes = {
            format("{} returns for {}", device_.description, finding_.call), ""};
        for (const FindingValue& input : finding_.inputs) {
            notes.push_back(format("    {} = {} = {} ({:#010x})", input.name, input.decimal,
                                   input.hex, input.word));
        }
        const auto line = [&](const char* what, const FindingValue& value) {
            notes.push_back(
                format("    {} {} = {} ({:#010x})", what, value.decimal, value.hex, value.word));
        };
        line((finding_.output + ":").c_str(), finding_.actual);
        notes.push_back("");
        notes.push_back(format("{} allows", finding_.profile));
        notes.push_back("");
        line("from", finding_.low);
        line("to  ", finding_.high);
        notes.push_back("");
        notes.push_back(
            format("Seen on {}, {} {}.", device_.name, device_.driver, device_.version));
        if (IsVulkan(device_)) {
            notes.push_back(format("Run: cc {} -lvulkan && ./a.out", finding_.reproducer));
        } else {
            notes.push_back(format("Run: shader_runner {} -auto -fbo", finding_.reproducer));
        }
        return notes;
    }

    const Record& record_;
    const DeviceInfo& device_;
    Evaluations& evaluations_;
    Programs& programs_;
    Finding finding_;
};

}  // namespace

FoundOutside FindOutside(const RunRecord& run, const std::map<std::string, const Case*>& cases,
                         const std::shared_ptr<Programs>& programs) {
    struct Furthest {
        const Record* worst = nullptr;
        std::vector<std::string> devices;
    };
    // By the place of an implementation's first device, and case.
    std::map<std::pair<std::size_t, std::string>, Furthest> candidates;
    std::map<std::string, std::size_t> implementations;  // by fingerprint
    for (std::size_t i = 0; i < run.devices.size(); ++i) {
        const DeviceInfo& device = run.devices[i];
        const std::size_t place = implementations.try_emplace(Fingerprint(device), i).first->second;
        for (const Record& record : run.records) {
            if (record.device != device.name || !record.worst_outside) {
                continue;
            }
            Furthest& candidate = candidates[{place, record.case_path}];
            if (candidate.devices.empty() || candidate.devices.back() != device.name) {
                candidate.devices.push_back(device.name);
            }
            if (candidate.worst == nullptr || candidate.worst->worst_outside->allowed->excess <
                                                  record.worst_outside->allowed->excess) {
                candidate.worst = &record;
            }
        }
    }
    FoundOutside found;
    for (const auto& [key, candidate] : candidates) {
        const Record& worst = *candidate.worst;
        const auto device =
            std::find_if(run.devices.begin(), run.devices.end(),
                         [&](const DeviceInfo& one) { return one.name == worst.device; });
        // Evaluations know rows by their address, and those of a candidate end with it.
        Evaluations evaluations(programs);
        Closer closer(worst, *device, evaluations, *programs);
        Result<std::string> text = closer.Reproducer(*cases.at(key.second));
        Finding& finding = closer.finding();
        if (text) {
            found.reproducers[finding.reproducer] = std::move(*text);
        } else {
            finding.doubt = text.error().message;
            finding.reproducer.clear();
        }
        finding.devices = candidate.devices;
        found.findings.push_back(std::move(finding));
    }
    return found;
}

}  // namespace etalon
