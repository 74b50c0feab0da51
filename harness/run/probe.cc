#include "run/probe.h"

#include <algorithm>
#include <cctype>
#include <ostream>

#include "case/read_images.h"
#include "compile/compile.h"
#include "run/csv.h"
#include "run/fit.h"
#include "run/images.h"

namespace etalon {
namespace {

// A table of text that grows by rows: CSV at once, or aligned columns at the end.
class TableWriter {
  public:
    TableWriter(bool csv, std::ostream& out) : csv_(csv), out_(out) {}
    ~TableWriter() { Flush(); }
    TableWriter(const TableWriter&) = delete;
    TableWriter& operator=(const TableWriter&) = delete;

    std::string& Cell() {
        cells_.emplace_back();
        return cells_.back();
    }
    void EndRow() {
        if (csv_) {
            for (std::size_t i = 0; i < cells_.size(); ++i) {
                text_ += (i == 0 ? "" : ",") + cells_[i];
            }
            text_ += '\n';
            constexpr std::size_t kBlock = 1u << 20;
            if (text_.size() > kBlock) {
                out_ << text_;
                text_.clear();
            }
        } else {
            widths_.resize(std::max(widths_.size(), cells_.size()));
            for (std::size_t i = 0; i < cells_.size(); ++i) {
                widths_[i] = std::max(widths_[i], cells_[i].size());
            }
            rows_.push_back(cells_);
        }
        cells_.clear();
    }

  private:
    void Flush() {
        for (const std::vector<std::string>& row : rows_) {
            std::string line;
            for (std::size_t i = 0; i < row.size(); ++i) {
                line += row[i] + std::string(widths_[i] - row[i].size() + 2, ' ');
            }
            line.erase(line.find_last_not_of(' ') + 1);
            text_ += line + '\n';
        }
        out_ << text_;
    }

    bool csv_;
    std::ostream& out_;
    std::vector<std::string> cells_;
    std::vector<std::vector<std::string>> rows_;
    std::vector<std::size_t> widths_;
    std::string text_;
};

Result<Argument> ParseDeclaration(const std::string& option, const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos || colon == 0 || colon + 1 == text.size()) {
        return Error{option + " '" + text + "': it reads NAME:TYPE, as in hit:vec3"};
    }
    return Argument{text.substr(0, colon), text.substr(colon + 1), false, false};
}

// Names of the output's own columns.
Status<> CheckFree(const Argument& argument) {
    for (const char* taken : {"device", "recipe", "result"}) {
        if (argument.name == taken) {
            return Error{"'" + argument.name +
                         "' is the name of a column of the output; call the variable otherwise"};
        }
    }
    return Ok();
}

bool IsMacro(const std::string& name, const std::string& value) {
    const bool is_name = !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
                         std::all_of(name.begin(), name.end(), [](unsigned char c) {
                             return std::isalnum(c) != 0 || c == '_';
                         });
    return is_name && value.find_first_of("\n\r\\#") == std::string::npos &&
           value.find("/*") == std::string::npos && value.find("//") == std::string::npos;
}

// The call and its table of inputs, from what the user chose.
struct Request {
    Call call;
    Signature signature;
    std::vector<std::uint32_t> words;
    std::uint64_t rows = 1;
};

// Whether the file lies below the current folder, and that is not all of the file system.
bool IsBelowHere(const std::filesystem::path& file) {
    std::error_code ignored;
    const auto here = std::filesystem::weakly_canonical(".", ignored);
    const auto path = std::filesystem::weakly_canonical(file, ignored);
    return here.has_relative_path() &&
           std::mismatch(here.begin(), here.end(), path.begin(), path.end()).first == here.end();
}

Result<Call> BaseCall(const ProbeChoice& choice) {
    Call call;
    call.source = choice.source;
    call.include_roots = choice.include;
    // So may the files of a project whose folder the user stands in.
    if (IsBelowHere(choice.source)) {
        call.include_roots.emplace_back(".");
    }
    for (const std::string& define : choice.defines) {
        const std::size_t equals = define.find('=');
        const std::string name = define.substr(0, equals);
        const std::string value = equals == std::string::npos ? "1" : define.substr(equals + 1);
        if (!IsMacro(name, value)) {
            return Error{"-D '" + define + "': it reads NAME or NAME=VALUE"};
        }
        call.defines[name] = value;
    }
    for (const std::filesystem::path& root : choice.include) {
        if (!std::filesystem::is_directory(root)) {
            return Error{"--include '" + root.string() + "': is not a folder"};
        }
    }
    ETALON_TRY_STEP(AddWith(choice.with, "", call));
    for (const std::string& text : choice.images) {
        ETALON_TRY(images, ReadImages(text, "--image"));
        ETALON_TRY_STEP(AddImages(images, "", call));
    }
    call.wanted = {{"result", choice.call, "CALL"}};
    return call;
}

Result<Request> MakeRequest(const ProbeChoice& choice) {
    Request request;
    ETALON_TRY(call, BaseCall(choice));
    request.call = std::move(call);
    InputTable table;
    table.rows = 1;
    std::string origin = "--in";
    if (!choice.inputs.empty()) {
        ETALON_TRY(read, ReadCsv(choice.inputs));
        table = std::move(read);
        origin = choice.inputs.string() + ":1";
    } else if (!choice.at.empty()) {
        ETALON_TRY(read, ReadAt(choice.at));
        table = std::move(read);
        origin = "--at";
    }
    std::vector<Argument> declared;
    for (const std::string& text : choice.in) {
        ETALON_TRY(argument, ParseDeclaration("--in", text));
        argument.is_input = true;
        declared.push_back(argument);
    }
    ETALON_TRY(arguments, ArgumentsOf(table, declared, origin));
    request.call.arguments = std::move(arguments);
    for (const std::string& text : choice.out) {
        ETALON_TRY(argument, ParseDeclaration("--out", text));
        const auto same =
            std::find_if(request.call.arguments.begin(), request.call.arguments.end(),
                         [&](const Argument& other) { return other.name == argument.name; });
        if (same == request.call.arguments.end()) {
            argument.is_output = true;
            request.call.arguments.push_back(argument);
        } else if (same->is_output || same->type != argument.type) {
            return Error{"--out '" + text + "': '" + argument.name + "' is already a " +
                         same->type};
        } else {
            same->is_output = true;
        }
    }
    for (const Argument& argument : request.call.arguments) {
        ETALON_TRY_STEP(CheckFree(argument));
    }
    ETALON_TRY(signature, Inspect(request.call));
    for (const BoundImage& image : request.call.images) {
        const auto& reached = signature.images;
        if (std::find(reached.begin(), reached.end(), image.name) == reached.end()) {
            return Error{"image '" + image.name + "': the call reaches no sampler '" + image.name +
                         "'"};
        }
    }
    request.signature = std::move(signature);
    ETALON_TRY(words, Arrange(table, InputColumns(request.call, request.signature), origin));
    request.words = std::move(words);
    request.rows = table.rows;
    return request;
}

class Probe {
  public:
    Probe(const Request& request, TableWriter& table, std::ostream& notes)
        : request_(request),
          table_(table),
          notes_(notes),
          inputs_(InputColumns(request.call, request.signature)),
          outputs_(OutputColumns(request.call, request.signature)) {}

    // An error where the user's input is at fault; all else is counted.
    Status<> RunOn(Runner& runner, Recipe recipe) {
        if (request_.signature.stage == Stage::kFragment) {
            recipe.stage = Stage::kFragment;
        }
        const std::string& device = runner.info().name;
        const Result<Recipe> fitted = FitRecipe(recipe, runner.info());
        if (!fitted) {
            notes_ << "skipped: " << fitted.error().message << "\n";
            return Ok();
        }
        const std::string text = RecipeText(*fitted);
        const Rows rows{request_.words, request_.rows, inputs_.size()};
        const auto evaluated = runner.Evaluate(
            request_.call, request_.signature, *fitted, rows,
            [&](std::uint64_t first, std::uint32_t count, std::span<const std::uint32_t> words) {
                Write(device, text, first, count, words);
            });
        if (!runner.flake().empty()) {
            notes_ << device << " (" << text << ") failed once and not again: " << runner.flake()
                   << "\n";
        }
        if (evaluated) {
            ++ran_;
            return Ok();
        }
        using Kind = EvaluationFailure::Kind;
        switch (evaluated.error().kind) {
            case Kind::kInput:
                return Error{evaluated.error().reason};
            case Kind::kUnsupported:
                notes_ << "skipped: " << device << " (" << text << "): " << evaluated.error().reason
                       << "\n";
                return Ok();
            case Kind::kRejected:
            case Kind::kStopped:
                notes_ << "fail: ";
                break;
            case Kind::kCrash:
                notes_ << "crash: ";
                break;
            case Kind::kTimeout:
                notes_ << "timeout: ";
                break;
        }
        notes_ << device << " (" << text << "): " << evaluated.error().reason << "\n";
        ++failed_;
        return Ok();
    }

    int ran() const { return ran_; }
    int failed() const { return failed_; }

  private:
    void Header() {
        table_.Cell() = "device";
        table_.Cell() = "recipe";
        for (const auto* columns : {&inputs_, &outputs_}) {
            for (const ProbeColumn& column : *columns) {
                table_.Cell() = column.name;
            }
        }
        table_.EndRow();
    }

    void Write(const std::string& device, const std::string& recipe, std::uint64_t first,
               std::uint32_t count, std::span<const std::uint32_t> words) {
        if (!has_header_) {
            Header();
            has_header_ = true;
        }
        for (std::uint32_t row = 0; row < count; ++row) {
            table_.Cell() = device;
            table_.Cell() = recipe;
            for (std::size_t c = 0; c < inputs_.size(); ++c) {
                AppendWord(table_.Cell(), inputs_[c].scalar,
                           request_.words[c * request_.rows + first + row]);
            }
            for (std::size_t c = 0; c < outputs_.size(); ++c) {
                AppendWord(table_.Cell(), outputs_[c].scalar, words[c * count + row]);
            }
            table_.EndRow();
        }
    }

    const Request& request_;
    TableWriter& table_;
    std::ostream& notes_;
    std::vector<ProbeColumn> inputs_;
    std::vector<ProbeColumn> outputs_;
    bool has_header_ = false;
    int ran_ = 0;
    int failed_ = 0;
};

}  // namespace

Result<int> RunProbe(const ProbeChoice& choice, std::ostream& out, std::ostream& notes) {
    std::vector<Recipe> recipes;
    for (const std::string& text : choice.recipes) {
        ETALON_TRY(recipe, ParseRecipe(text));
        recipes.push_back(recipe);
    }
    ETALON_TRY(request, MakeRequest(choice));
    ETALON_TRY(devices, OpenDevices(choice.devices));
    TableWriter table(choice.csv, out);
    Probe probe(request, table, notes);
    for (const auto& runner : devices.runners) {
        const std::vector<Recipe> wanted =
            recipes.empty() ? std::vector<Recipe>{DefaultRecipe(runner->info())} : recipes;
        for (const Recipe& recipe : wanted) {
            ETALON_TRY_STEP(probe.RunOn(*runner, recipe));
        }
    }
    if (probe.ran() == 0 && probe.failed() == 0) {
        return Error{"no device can run this probe"};
    }
    return probe.failed() > 0 ? 1 : 0;
}

}  // namespace etalon
