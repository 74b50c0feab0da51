// Reads a case out of its keys, from wherever they were gathered.
#pragma once

#include "case/case.h"
#include "case/toml_reader.h"

namespace etalon {

// What is asked of the keys beside a call and a domain.
enum class Purpose : std::uint8_t {
    kJudge,    // an oracle with its acceptance, or a law: something must be judged
    kMeasure,  // nothing: without `accept` each oracle has an exact rule, laws and what else
               // belongs to a judged case are passed over
};

// The case without its path, file and root. The keys are described in case.cc; errors name the file
// and line of the key.
Result<Case> ReadCaseKeys(const TomlReader& reader, const toml::table& keys, Purpose purpose);

}  // namespace etalon
