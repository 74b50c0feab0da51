#include "probe/call.h"

namespace etalon {
namespace {

void Append(const std::string& name, const Type& type, std::vector<ProbeColumn>& columns) {
    for (const Leaf& leaf : Leaves(type)) {
        columns.push_back({name + leaf.path, leaf.scalar});
    }
}

}  // namespace

std::vector<ProbeColumn> InputColumns(const Call& call, const Signature& signature) {
    std::vector<ProbeColumn> columns;
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        if (call.arguments[i].is_input) {
            Append(call.arguments[i].name, signature.arguments[i], columns);
        }
    }
    return columns;
}

std::vector<ProbeColumn> OutputColumns(const Call& call, const Signature& signature) {
    std::vector<ProbeColumn> columns;
    for (std::size_t i = 0; i < call.wanted.size(); ++i) {
        Append(call.wanted[i].name, signature.wanted[i], columns);
    }
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        if (call.arguments[i].is_output) {
            Append(call.arguments[i].name, signature.arguments[i], columns);
        }
    }
    return columns;
}

std::uint32_t Signature::InputWords(const Call& call) const {
    return static_cast<std::uint32_t>(InputColumns(call, *this).size());
}

std::uint32_t Signature::OutputWords(const Call& call) const {
    return static_cast<std::uint32_t>(OutputColumns(call, *this).size());
}

}  // namespace etalon
