#include "run/sweep_journal.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <sstream>

#include "base/file.h"
#include "base/format.h"
#include "base/hash.h"
#include "numeric/number_text.h"
#include "numeric/ulp.h"
#include "run/observe.h"

namespace etalon {
namespace {

constexpr std::string_view kTitle = "etalon sweep journal 1";
constexpr std::string_view kNone = "none";

// The header, line by line; what two journals differ in is told by these keys too.
std::vector<std::pair<std::string, std::string>> HeaderLines(const SweepHeader& header) {
    std::vector<std::pair<std::string, std::string>> lines = {
        {"version", header.version},
        {"case", header.case_path},
        {"device", header.device},
        {"driver", header.driver},
        {"fingerprint", header.fingerprint},
        {"recipe", header.recipe},
        {"options", header.options},
        {"swept", std::to_string(header.swept)},
        {"from", HexFloat(FromBits(header.from))},
        {"to", HexFloat(FromBits(header.to))},
        {"fixed", header.fixed},
        {"settings", std::to_string(header.settings)},
        {"block", std::to_string(header.block_rows)},
        {"laws", std::to_string(header.laws)},
        {"content", header.content},
        {"inputs", std::to_string(header.columns.size())},
    };
    for (const Column& column : header.columns) {
        lines.emplace_back("input", std::string(ScalarName(column.scalar)) + " " + column.name);
    }
    lines.emplace_back("outputs", std::to_string(header.outputs.size()));
    for (const SweepHeader::Output& output : header.outputs) {
        lines.emplace_back("output", std::string(ScalarName(output.scalar)) + " " + output.name);
        lines.emplace_back("rule", output.rule);
    }
    return lines;
}

std::string ValueLine(const std::optional<SweptValue>& value) {
    if (!value) {
        return std::string(kNone);
    }
    std::string line =
        format("{} {} {} {} {} {}", value->row, value->actual, HexFloat(value->expected),
               HexFloat(value->judgement.error), HexFloat(value->judgement.ulp_error),
               HexFloat(value->judgement.used));
    for (const std::uint32_t word : value->inputs) {
        line += format(" {}", word);
    }
    return line;
}

std::string HashText(std::string_view text) {
    Hash hash;
    hash.Add(text);
    return format("{:016x}", hash.value());
}

// Reads lines "key value" in their order. After a line that is not what is asked for all values are
// empty or 0, and ok() is false.
class LineReader {
  public:
    explicit LineReader(const std::string& text) : stream_(text) {}

    bool ok() const { return ok_; }

    std::string Text(std::string_view key) {
        std::string line;
        const bool is_there = ok_ && std::getline(stream_, line) && line.starts_with(key) &&
                              line.size() > key.size() && line[key.size()] == ' ';
        ok_ = is_there;
        return is_there ? line.substr(key.size() + 1) : "";
    }
    std::uint64_t Number(std::string_view key) { return ToNumber(Text(key)); }
    std::uint32_t Float(std::string_view key) {
        const Result<std::uint32_t> word = ParseWord(Scalar::kFloat, Text(key));
        ok_ = ok_ && word;
        return ok_ ? *word : 0;
    }
    // "float name"
    std::pair<Scalar, std::string> Typed(std::string_view key) {
        const std::string text = Text(key);
        const std::size_t space = text.find(' ');
        const auto scalar = ScalarFromName(text.substr(0, space));
        ok_ = ok_ && scalar && space != std::string::npos;
        return ok_ ? std::pair(*scalar, text.substr(space + 1)) : std::pair(Scalar::kFloat, "");
    }
    // The words of a line, of which there must be `count`.
    std::vector<std::string> Words(std::string_view key, std::size_t count) {
        std::vector<std::string> words = Split(Text(key));
        ok_ = ok_ && words.size() == count;
        words.resize(count);
        return words;
    }
    std::optional<SweptValue> Value(std::string_view key, std::size_t inputs) {
        const std::string text = Text(key);
        if (text == kNone) {
            return std::nullopt;
        }
        std::vector<std::string> words = Split(text);
        ok_ = ok_ && words.size() == 6 + inputs;
        words.resize(6 + inputs);
        SweptValue value;
        value.row = ToNumber(words[0]);
        value.actual = static_cast<std::uint32_t>(ToNumber(words[1]));
        value.expected = ToDouble(words[2]);
        value.judgement.error = ToDouble(words[3]);
        value.judgement.ulp_error = ToDouble(words[4]);
        value.judgement.used = ToDouble(words[5]);
        for (std::size_t k = 0; k < inputs; ++k) {
            value.inputs.push_back(static_cast<std::uint32_t>(ToNumber(words[6 + k])));
        }
        return value;
    }

    std::uint64_t ToNumber(const std::string& text) {
        std::uint64_t number = 0;
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data(), end, number);
        ok_ = ok_ && read.ec == std::errc() && read.ptr == end;
        return ok_ ? number : 0;
    }
    double ToDouble(const std::string& text) {
        char* end = nullptr;
        const double number = std::strtod(text.c_str(), &end);
        ok_ = ok_ && !text.empty() && *end == '\0';
        return ok_ ? number : 0;
    }

  private:
    static std::vector<std::string> Split(const std::string& text) {
        std::istringstream stream(text);
        std::vector<std::string> words;
        for (std::string word; stream >> word;) {
            words.push_back(word);
        }
        return words;
    }

    std::istringstream stream_;
    bool ok_ = true;
};

// More than any call has; a count beyond it is not read.
constexpr std::uint64_t kMostColumns = 1u << 16;

SweepHeader ReadHeader(LineReader& lines) {
    SweepHeader header;
    header.version = lines.Text("version");
    header.case_path = lines.Text("case");
    header.device = lines.Text("device");
    header.driver = lines.Text("driver");
    header.fingerprint = lines.Text("fingerprint");
    header.recipe = lines.Text("recipe");
    header.options = lines.Text("options");
    header.swept = lines.Number("swept");
    header.from = lines.Float("from");
    header.to = lines.Float("to");
    header.fixed = lines.Text("fixed");
    header.settings = lines.Number("settings");
    header.block_rows = lines.Number("block");
    header.laws = lines.Number("laws");
    header.content = lines.Text("content");
    header.columns.resize(std::min(lines.Number("inputs"), kMostColumns));
    for (Column& column : header.columns) {
        std::tie(column.scalar, column.name) = lines.Typed("input");
    }
    header.outputs.resize(std::min(lines.Number("outputs"), kMostColumns));
    for (SweepHeader::Output& output : header.outputs) {
        std::tie(output.scalar, output.name) = lines.Typed("output");
        output.rule = lines.Text("rule");
    }
    return header;
}

SweptColumn ReadColumn(LineReader& lines, std::size_t inputs) {
    SweptColumn column;
    const auto counts = lines.Words("values", 2);
    column.summary.judged = lines.ToNumber(counts[0]);
    column.summary.refused = lines.ToNumber(counts[1]);
    const auto bins = lines.Words("histogram", UlpHistogram::kBins);
    for (std::size_t bin = 0; bin < UlpHistogram::kBins; ++bin) {
        column.histogram.counts()[bin] = lines.ToNumber(bins[bin]);
    }
    column.worst_ulp = lines.Value("worst-ulp", inputs);
    column.worst_used = lines.Value("worst-used", inputs);
    column.first_refused = lines.Value("first-refused", inputs);
    if (column.worst_ulp) {
        column.summary.worst_ulp_error = column.worst_ulp->judgement.ulp_error;
        column.summary.worst_ulp_at = column.worst_ulp->row;
    }
    if (column.worst_used) {
        column.summary.worst_used = column.worst_used->judgement.used;
        column.summary.worst_used_at = column.worst_used->row;
    }
    if (column.first_refused) {
        column.summary.first_refused = column.first_refused->row;
    }
    return column;
}

// What the numbers must have in common if nobody has tampered with them.
bool IsSound(const SweepJournal& journal) {
    const SweepHeader& header = journal.header;
    if (header.swept >= header.columns.size() || header.block_rows == 0 || header.settings == 0 ||
        OrderedBits(FromBits(header.from)) > OrderedBits(FromBits(header.to)) ||
        journal.first >= journal.end || journal.next < journal.first ||
        journal.next > journal.end || journal.end > header.Blocks()) {
        return false;
    }
    const std::uint64_t rows = header.FirstRow(journal.next) - header.FirstRow(journal.first);
    return std::all_of(journal.found.begin(), journal.found.end(), [&](const auto& column) {
        return column.summary.judged == rows && column.histogram.Total() == rows &&
               (column.summary.refused > 0) == column.first_refused.has_value();
    });
}

Observation ObservationOf(const SweepHeader& header, const SweepHeader::Output& output,
                          const SweptValue& value) {
    Observation seen;
    seen.output = output.name;
    seen.rule = output.rule;
    for (std::size_t c = 0; c < header.columns.size(); ++c) {
        seen.inputs.emplace_back(header.columns[c].name,
                                 ValueOf(header.columns[c].scalar, value.inputs[c]));
    }
    seen.actual = ValueOf(output.scalar, value.actual);
    seen.expected = Value{Shortest(value.expected), HexFloat(value.expected)};
    seen.error = value.judgement.error;
    seen.ulp_error = value.judgement.ulp_error;
    seen.used = value.judgement.used;
    return seen;
}

}  // namespace

std::uint64_t SweepHeader::Floats() const {
    return static_cast<std::uint64_t>(OrderedBits(FromBits(to)) - OrderedBits(FromBits(from))) + 1;
}

std::uint64_t SweepHeader::BlocksPerSetting() const {
    return (Floats() + block_rows - 1) / block_rows;
}

std::uint64_t SweepHeader::FirstRow(std::uint64_t block) const {
    const std::uint64_t setting = block / BlocksPerSetting();
    return setting * Floats() + block % BlocksPerSetting() * block_rows;
}

void SweptColumn::Add(const SweptColumn& other) {
    const Summary before = summary;
    summary.Add(other.summary);
    histogram.Add(other.histogram);
    if (summary.worst_ulp_at != before.worst_ulp_at) {
        worst_ulp = other.worst_ulp;
    }
    if (summary.worst_used_at != before.worst_used_at) {
        worst_used = other.worst_used;
    }
    if (summary.first_refused != before.first_refused) {
        first_refused = other.first_refused;
    }
}

Result<SweepJournal> NewJournal(const SweepHeader& header, SweepShard shard) {
    SweepJournal journal;
    journal.header = header;
    journal.shard = shard;
    const auto begin_of = [&](std::uint64_t index) {
        // Blocks times shards may not fit 64 bits: whole parts first, then what is over.
        const std::uint64_t blocks = header.Blocks();
        return blocks / shard.count * index + blocks % shard.count * index / shard.count;
    };
    journal.first = journal.next = begin_of(shard.index - 1);
    journal.end = begin_of(shard.index);
    if (journal.first == journal.end) {
        return Error{
            format("--shard {}/{}: there are {} blocks to share out, and none for this one",
                   shard.index, shard.count, header.Blocks())};
    }
    journal.found.resize(header.outputs.size());
    return journal;
}

std::string JournalText(const SweepJournal& journal) {
    std::string text = std::string(kTitle) + "\n";
    const auto line = [&text](std::string_view key, const std::string& value) {
        text += std::string(key) + " " + value + "\n";
    };
    for (const auto& [key, value] : HeaderLines(journal.header)) {
        line(key, value);
    }
    line("shard", format("{} {}", journal.shard.index, journal.shard.count));
    line("blocks", format("{} {} {}", journal.first, journal.next, journal.end));
    for (const SweptColumn& column : journal.found) {
        line("values", format("{} {}", column.summary.judged, column.summary.refused));
        std::string bins;
        for (const std::uint64_t count : column.histogram.counts()) {
            bins += (bins.empty() ? "" : " ") + std::to_string(count);
        }
        line("histogram", bins);
        line("worst-ulp", ValueLine(column.worst_ulp));
        line("worst-used", ValueLine(column.worst_used));
        line("first-refused", ValueLine(column.first_refused));
    }
    return text + "end " + HashText(text) + "\n";
}

Result<SweepJournal> ParseJournal(const std::string& name, const std::string& text) {
    if (!text.starts_with(kTitle)) {
        return Error{name + ": is no journal of a sweep"};
    }
    const Error torn{name + ": is a journal that was cut or changed; remove it to begin anew"};
    const std::size_t end = text.rfind("end ");
    if (end == std::string::npos ||
        text.substr(end) != "end " + HashText(std::string_view(text).substr(0, end)) + "\n") {
        return torn;
    }
    LineReader lines(text.substr(kTitle.size() + 1));
    SweepJournal journal;
    journal.header = ReadHeader(lines);
    const auto shard = lines.Words("shard", 2);
    journal.shard = {lines.ToNumber(shard[0]), lines.ToNumber(shard[1])};
    const auto blocks = lines.Words("blocks", 3);
    journal.first = lines.ToNumber(blocks[0]);
    journal.next = lines.ToNumber(blocks[1]);
    journal.end = lines.ToNumber(blocks[2]);
    for (std::size_t k = 0; k < journal.header.outputs.size(); ++k) {
        journal.found.push_back(ReadColumn(lines, journal.header.columns.size()));
    }
    if (!lines.ok() || !IsSound(journal)) {
        return torn;
    }
    return journal;
}

Result<SweepJournal> ReadJournal(const std::filesystem::path& path) {
    ETALON_TRY(text, ReadTextFile(path));
    return ParseJournal(path.string(), text);
}

std::string Difference(const SweepHeader& theirs, const SweepHeader& here) {
    const auto a = HeaderLines(theirs);
    const auto b = HeaderLines(here);
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        if (a[k] != b[k]) {
            return format("'{}' is '{}', not '{}'", a[k].first, a[k].second, b[k].second);
        }
    }
    return "";
}

Result<SweepJournal> MergeJournals(const std::vector<std::filesystem::path>& paths) {
    ETALON_CHECK(!paths.empty());
    std::vector<std::pair<std::string, SweepJournal>> parts;
    for (const std::filesystem::path& path : paths) {
        ETALON_TRY(journal, ReadJournal(path));
        if (journal.next < journal.end) {
            return Error{format("{}: is not finished ({} of {} blocks); run its sweep again",
                                path.string(), journal.next - journal.first,
                                journal.end - journal.first)};
        }
        if (!parts.empty()) {
            const std::string why = Difference(journal.header, parts[0].second.header);
            if (!why.empty()) {
                return Error{path.string() + ": is of another sweep than " + parts[0].first + ": " +
                             why};
            }
        }
        parts.emplace_back(path.string(), std::move(journal));
    }
    std::sort(parts.begin(), parts.end(),
              [](const auto& a, const auto& b) { return a.second.first < b.second.first; });
    SweepJournal whole = parts[0].second;
    whole.shard = {};
    const auto missing = [&whole](std::uint64_t from, std::uint64_t to) {
        return Error{format("--merge: the shard of the blocks {} to {} of {} is missing", from + 1,
                            to, whole.header.Blocks())};
    };
    if (whole.first > 0) {
        return missing(0, whole.first);
    }
    for (std::size_t k = 1; k < parts.size(); ++k) {
        const SweepJournal& part = parts[k].second;
        if (part.first < whole.end) {
            return Error{parts[k].first + ": has blocks that " + parts[k - 1].first + " has too"};
        }
        if (part.first > whole.end) {
            return missing(whole.end, part.first);
        }
        whole.next = whole.end = part.end;
        for (std::size_t output = 0; output < whole.found.size(); ++output) {
            whole.found[output].Add(part.found[output]);
        }
    }
    if (whole.end < whole.header.Blocks()) {
        return missing(whole.end, whole.header.Blocks());
    }
    return whole;
}

SweepRecord RecordOf(const SweepJournal& journal) {
    const SweepHeader& header = journal.header;
    SweepRecord record;
    record.case_path = header.case_path;
    record.device = header.device;
    record.driver = header.driver;
    record.fingerprint = header.fingerprint;
    record.recipe = header.recipe;
    record.input = header.columns[header.swept].name;
    record.from = ValueOf(Scalar::kFloat, header.from);
    record.to = ValueOf(Scalar::kFloat, header.to);
    record.fixed = header.fixed;
    record.settings = header.settings;
    record.floats = header.Floats();
    record.laws = header.laws;
    if (journal.shard.count > 1) {
        record.shard = format("{}/{}", journal.shard.index, journal.shard.count);
    }
    const std::uint64_t first = header.FirstRow(journal.first);
    record.rows = header.FirstRow(journal.next) - first;
    record.all_rows = header.FirstRow(journal.end) - first;
    record.repeat = "etalon run " + ShellWord(header.case_path) + header.options + " --device " +
                    ShellWord(header.device) + " --recipe " + header.recipe;
    for (std::size_t k = 0; k < header.outputs.size(); ++k) {
        const SweptColumn& column = journal.found[k];
        SweptOutput output;
        output.name = header.outputs[k].name;
        output.rule = header.outputs[k].rule;
        output.judged = column.summary.judged;
        output.refused = column.summary.refused;
        const auto seen = [&](const std::optional<SweptValue>& value) {
            return value ? std::optional(ObservationOf(header, header.outputs[k], *value))
                         : std::nullopt;
        };
        output.worst_ulp = seen(column.worst_ulp);
        output.worst_used = seen(column.worst_used);
        output.first_refused = seen(column.first_refused);
        for (std::size_t bin = 0; bin < UlpHistogram::kBins; ++bin) {
            output.histogram.push_back({UlpHistogram::Upper(bin), column.histogram.counts()[bin]});
        }
        if (output.refused > 0) {
            record.verdict = Verdict::kFail;
        }
        record.outputs.push_back(std::move(output));
    }
    return record;
}

}  // namespace etalon
