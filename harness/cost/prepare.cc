#include "compile/compile.h"
#include "cost/cost.h"

namespace etalon {
namespace {

// What judges stays away.
Case CallAlone(Case source) {
    source.laws.clear();
    source.expectations.clear();
    return source;
}

Result<PreparedCase> WithCall(PreparedCase prepared) {
    const Case& source = prepared.source;
    prepared.call.wanted = {{"result", source.call, source.call_place.Text() + "call"}};
    ETALON_TRY(signature, Inspect(prepared.call));
    prepared.signature = signature;
    return prepared;
}

}  // namespace

Result<PreparedCase> PrepareCall(const Case& source) {
    ETALON_TRY(prepared, Prepare(CallAlone(source)));
    return WithCall(std::move(prepared));
}

Result<PreparedCase> PrepareCall(const Case& source, Table table) {
    ETALON_TRY(prepared, PrepareRows(CallAlone(source), std::move(table)));
    return WithCall(std::move(prepared));
}

}  // namespace etalon
