// The journal of a sweep: what was found in the blocks that are done. A small text file that is
// written anew after each block, so that a sweep that is killed goes on where it was. What a sweep
// prints follows from its journal alone, and journals of its shards add up to that of all of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "case/domain.h"
#include "numeric/acceptance.h"
#include "numeric/histogram.h"
#include "report/sweep_record.h"

namespace etalon {

// What a sweep is; two journals can be added, and a sweep goes on with a journal, only where all of
// this is the same.
struct SweepHeader {
    struct Output {
        std::string name;
        Scalar scalar = Scalar::kFloat;
        std::string rule;
    };

    std::string version;  // of Etalon
    std::string case_path;
    std::string content;  // a hash of the program, the oracles, the rules and the other inputs
    std::string device;
    std::string driver;
    std::string fingerprint;
    std::string recipe;
    std::string options;          // that repeat commands need: "--root DIR", or empty
    std::vector<Column> columns;  // of the inputs
    std::size_t swept = 0;        // among them
    std::uint32_t from = 0;       // bits of the first and the last float
    std::uint32_t to = 0;
    std::string fixed;           // the other inputs, as they are told
    std::uint64_t settings = 1;  // combinations of them
    std::uint64_t block_rows = 0;
    std::uint64_t laws = 0;
    std::vector<Output> outputs;

    // Rows go through all floats at the first setting, then at the next. Blocks do not cross
    // settings: the last one of each may be shorter.
    std::uint64_t Floats() const;
    std::uint64_t BlocksPerSetting() const;
    std::uint64_t Blocks() const { return settings * BlocksPerSetting(); }
    // The first row of a block; that of the block behind the last is the number of rows.
    std::uint64_t FirstRow(std::uint64_t block) const;
};

// One value that stands out.
struct SweptValue {
    std::uint64_t row = 0;
    std::vector<std::uint32_t> inputs;
    std::uint32_t actual = 0;
    double expected = 0;
    Judgement judgement;
};

// What was found of one output.
struct SweptColumn {
    Summary summary;  // its indices are rows
    UlpHistogram histogram;
    // At the rows that the summary names; absent where it names none.
    std::optional<SweptValue> worst_ulp;
    std::optional<SweptValue> worst_used;
    std::optional<SweptValue> first_refused;

    // What both say together, whichever comes first.
    void Add(const SweptColumn& other);
};

struct SweepShard {
    std::uint64_t index = 1;  // 1 .. count
    std::uint64_t count = 1;
};

struct SweepJournal {
    SweepHeader header;
    SweepShard shard;
    std::uint64_t first = 0;  // blocks of the shard: first .. end - 1
    std::uint64_t next = 0;   // those before are done
    std::uint64_t end = 0;
    std::vector<SweptColumn> found;  // one for each output
};

// A journal of nothing yet. Fails where the shard has no block.
Result<SweepJournal> NewJournal(const SweepHeader& header, SweepShard shard);

std::string JournalText(const SweepJournal& journal);
// The error is one line that begins with `name`: it is no journal, or was cut or changed.
Result<SweepJournal> ParseJournal(const std::string& name, const std::string& text);
Result<SweepJournal> ReadJournal(const std::filesystem::path& path);

// In what the two differ: "'device' is 'a', not 'b'"; empty where they are of one sweep.
std::string Difference(const SweepHeader& theirs, const SweepHeader& here);

// All of a sweep from the journals of its shards, in any order. Fails where they are of different
// sweeps, overlap, are not finished, or where one is missing.
Result<SweepJournal> MergeJournals(const std::vector<std::filesystem::path>& paths);

SweepRecord RecordOf(const SweepJournal& journal);

}  // namespace etalon
