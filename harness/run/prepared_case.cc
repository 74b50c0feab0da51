#include "run/prepared_case.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "compile/compile.h"
#include "run/given.h"
#include "run/images.h"
#include "run/truths.h"

namespace etalon {
namespace {

Status<> CheckThere(const std::filesystem::path& file, const Place& place, const char* key) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) {
        return Error{place.Text() + "'" + key + "': there is no file " + file.string()};
    }
    return Ok();
}

Result<Call> CallOf(const Case& source, const Table& table) {
    Call call;
    call.source = source.root / source.source;
    for (const std::string& root : source.include) {
        call.include_roots.push_back(source.root / root);
    }
    // All below the root may include each other.
    call.include_roots.push_back(source.root);
    call.defines = source.define;
    ETALON_TRY_STEP(CheckFiles(source));
    if (auto added = AddWith(source.with, source.root, call); !added) {
        return Error{source.with_place.Text() + "'with': " + added.error().message};
    }
    ETALON_TRY_STEP(AddImages(source.images, source.root, call));
    for (const Variable& variable : table.variables) {
        call.arguments.push_back({variable.name, variable.type, true, false});
    }
    for (const auto& [name, type] : source.out) {
        const auto same = std::find_if(
            call.arguments.begin(), call.arguments.end(),
            [&, &wanted = name](const Argument& argument) { return argument.name == wanted; });
        if (same != call.arguments.end()) {
            same->is_output = true;
        } else {
            call.arguments.push_back({name, type, false, true});
        }
    }
    return call;
}

// The truths of an expectation's columns, one by one.
Result<std::vector<Truth>> Truths(const Expectation& expectation, std::size_t columns,
                                  const Table& table) {
    Expression truth = *expectation.truth;
    ETALON_TRY(components, truth.Bind(Symbols(table.variables)));
    if (columns != components) {
        return Error{expectation.place.Text() + "'" + expectation.output + "' has " +
                     std::to_string(columns) + " components, its oracle " +
                     std::to_string(components)};
    }
    return TruthsOf(truth, table);
}

// The name of the device's own specification.
constexpr std::string_view kOwnSpec = "device";

// Null where none is named, and for that of the device.
Result<const evaluate::Profile*> SpecOf(const Expectation& expectation) {
    const evaluate::Profile* profile = evaluate::FindProfile(expectation.spec);
    if (profile != nullptr || expectation.spec.empty() || expectation.spec == kOwnSpec) {
        return profile;
    }
    std::string names;
    for (const std::string_view name : evaluate::ProfileNames()) {
        names += (names.empty() ? "" : ", ") + std::string(name);
    }
    return Error{expectation.place.Text() + "'spec': there is no '" + expectation.spec +
                 "'; there are " + names + ", and '" + std::string(kOwnSpec) +
                 "' for the device's own"};
}

Result<std::vector<JudgedColumn>> JudgedColumns(const Case& source, const Table& table,
                                                const Call& call, const Signature& signature) {
    const std::vector<ProbeColumn> outputs = OutputColumns(call, signature);
    std::vector<JudgedColumn> judged;
    for (const Expectation& expectation : source.expectations) {
        ETALON_TRY(spec, SpecOf(expectation));
        std::vector<JudgedColumn> columns;
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            const std::string& name = outputs[i].name;
            const std::size_t end = name.find_first_of(".[");
            if (name.substr(0, end) == expectation.output) {
                columns.push_back({name, i, outputs[i].scalar, expectation.accept, spec,
                                   expectation.spec == kOwnSpec, Truth{}});
            }
        }
        if (columns.empty()) {
            return Error{expectation.place.Text() + "the call has no output '" +
                         expectation.output + "'"};
        }
        for (const JudgedColumn& column : columns) {
            if (column.accept.shares && column.accept.shares->beyond &&
                column.scalar != Scalar::kFloat) {
                return Error{expectation.place.Text() + "'" + column.name +
                             "' is no float, and no way to a hit: 'wrong' goes with exact = true"};
            }
        }
        if (expectation.truth) {
            ETALON_TRY(truths, Truths(expectation, columns.size(), table));
            for (std::size_t k = 0; k < columns.size(); ++k) {
                columns[k].truth = std::move(truths[k]);
            }
        }
        std::move(columns.begin(), columns.end(), std::back_inserter(judged));
    }
    return judged;
}

Result<PreparedLaw> PrepareLaw(const Law& law, const Call& call) {
    PreparedLaw prepared;
    prepared.law = law;
    prepared.call = call;
    const std::string origin = law.place.Text() + "law '" + law.name + "'";
    prepared.call.wanted = {{"left", law.left, origin}, {"right", law.right, origin}};
    // The law's own calls declare nothing; only the inputs are theirs.
    std::erase_if(prepared.call.arguments,
                  [](const Argument& argument) { return !argument.is_input; });
    for (Argument& argument : prepared.call.arguments) {
        argument.is_output = false;
    }
    ETALON_TRY(signature, Inspect(prepared.call));
    prepared.signature = signature;
    const std::size_t left = Leaves(signature.wanted[0]).size();
    const std::size_t right = Leaves(signature.wanted[1]).size();
    if (left == 0 || right == 0 || (right != left && right != 1)) {
        return Error{origin + ": the sides have " + std::to_string(left) + " and " +
                     std::to_string(right) + " components"};
    }
    const std::vector<ProbeColumn> outputs = OutputColumns(prepared.call, signature);
    for (std::size_t i = 0; i < left; ++i) {
        const std::size_t other = left + (right == 1 ? 0 : i);
        if (outputs[i].scalar != outputs[other].scalar) {
            return Error{origin + ": the sides have different types"};
        }
        prepared.pairs.emplace_back(i, other);
        prepared.scalars.push_back(outputs[i].scalar);
    }
    return prepared;
}

}  // namespace

Status<> CheckFiles(const Case& source) {
    ETALON_TRY_STEP(CheckThere(source.root / source.source, source.source_place, "source"));
    for (const std::string& one : source.with) {
        const std::size_t equals = one.find('=');  // of NAME=IMAGE
        const std::string file = equals == std::string::npos ? one : one.substr(equals + 1);
        ETALON_TRY_STEP(CheckThere(source.root / file, source.with_place, "with"));
    }
    return Ok();
}

Result<PreparedCase> PrepareRows(const Case& source, Table table) {
    PreparedCase prepared;
    prepared.source = source;
    prepared.table = std::move(table);
    prepared.all_rows = prepared.table.rows;
    ETALON_TRY(call, CallOf(source, prepared.table));
    prepared.call = std::move(call);
    if (!source.expectations.empty()) {
        prepared.call.wanted = {{"result", source.call, source.call_place.Text() + "call"}};
        ETALON_TRY(signature, Inspect(prepared.call));
        prepared.signature = signature;
        ETALON_TRY(judged, JudgedColumns(source, prepared.table, prepared.call, signature));
        prepared.judged = std::move(judged);
    }
    for (const Law& law : source.laws) {
        ETALON_TRY(one, PrepareLaw(law, prepared.call));
        prepared.laws.push_back(std::move(one));
    }
    return prepared;
}

Result<PreparedCase> Prepare(const Case& source) {
    ETALON_TRY(table, Expand(source.domains, source.seed));
    ETALON_TRY_STEP(CheckAcceptance(source, table));
    return PrepareRows(source, std::move(table));
}

Result<PreparedCase> PrepareAt(const Case& source, const std::string& at) {
    ETALON_TRY(all, Expand(source.domains, source.seed));
    Table table = RowsOf(all, {0});
    ETALON_TRY(given, ReadGiven(table.columns, at));
    for (std::size_t i = 0; i < given.size(); ++i) {
        if (!given[i]) {
            return Error{"--at: no value for input '" + table.columns[i].name + "'"};
        }
        table.words[i] = *given[i];
    }
    ETALON_TRY(prepared, PrepareRows(source, std::move(table)));
    prepared.extent = Extent::kGiven;
    return std::move(prepared);
}

namespace {

// Few rows cannot show a small share: one value may be off where any may.
void GrantOne(const std::vector<double>& truths, Shares& shares) {
    const auto grant = [](double& share, std::ptrdiff_t count) {
        if (share > 0 && count > 0) {
            share = std::max(share, 1 / static_cast<double>(count));
        }
    };
    grant(shares.missed, std::ranges::count_if(truths, [](double truth) { return truth >= 0; }));
    grant(shares.wrong,
          std::ranges::count_if(truths, [](double truth) { return !std::isnan(truth); }));
}

}  // namespace

PreparedCase Thin(const PreparedCase& prepared, std::uint64_t count) {
    const std::uint64_t rows = prepared.table.rows;
    if (rows <= count) {
        return prepared;
    }
    std::vector<std::uint64_t> chosen;
    for (std::uint64_t i = 0; i < count; ++i) {
        chosen.push_back(count == 1 ? 0 : i * (rows - 1) / (count - 1));
    }
    PreparedCase thin = prepared;
    thin.extent = Extent::kSome;
    thin.table = RowsOf(prepared.table, chosen);
    for (JudgedColumn& column : thin.judged) {
        Truth some;
        for (std::size_t i = 0; column.HasTruth() && i < chosen.size(); ++i) {
            some.values.push_back(column.truth.values[chosen[i]]);
            some.errors.push_back(column.truth.errors[chosen[i]]);
            for (const Truth::Alternative& other : column.truth.alternatives) {
                if (other.row == chosen[i]) {
                    some.alternatives.push_back({i, other.value, other.error});
                }
            }
        }
        column.truth = std::move(some);
        if (column.accept.shares) {
            GrantOne(column.truth.values, *column.accept.shares);
        }
    }
    return thin;
}

}  // namespace etalon
