#include "report/html.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/file.h"
#include "base/file_lock.h"
#include "report/json_value.h"
#include "report/page/files.h"
#include "report/record.h"

namespace etalon {
namespace {

using nlohmann::ordered_json;

constexpr std::string_view kFormat = "etalon report 1";
constexpr std::string_view kMark = "<meta name=\"generator\" content=\"etalon\">";

constexpr ReportSection kSections[] = {ReportSection::kRun, ReportSection::kSweeps,
                                       ReportSection::kCharts, ReportSection::kMaps};

Result<ordered_json> ReadReport(const std::filesystem::path& file) {
    ETALON_TRY(text, ReadFile(file));
    const ordered_json read = ordered_json::parse(text, nullptr, false);
    if (read.is_discarded()) {
        return Error{file.string() + ": is no report: it is cut, or no JSON"};
    }
    const auto format = read.is_object() ? read.find("format") : read.end();
    if (!read.is_object() || format == read.end() || !format->is_string()) {
        return Error{file.string() + ": is no report of etalon"};
    }
    if (*format != kFormat) {
        return Error{file.string() + ": is an '" + format->get<std::string>() + "', not an '" +
                     std::string(kFormat) + "'"};
    }
    for (const ReportSection section : kSections) {
        const auto found = read.find(SectionName(section));
        if (found != read.end() && !found->is_object()) {
            return Error{file.string() + ": is no report of etalon: '" + SectionName(section) +
                         "' is no object"};
        }
    }
    return read;
}

Status<> CheckPage(const std::filesystem::path& file) {
    ETALON_TRY(text, ReadFile(file));
    if (text.find(kMark) == std::string::npos) {
        return Error{file.string() + ": is a page that etalon did not write; it stays as it is"};
    }
    return Ok();
}

// What is there already; null where nothing is.
Result<ordered_json> OldReport(const std::filesystem::path& folder) {
    std::error_code ignored;
    if (std::filesystem::exists(folder / "index.html", ignored)) {
        ETALON_TRY_STEP(CheckPage(folder / "index.html"));
    }
    if (!std::filesystem::exists(folder / "report.json", ignored)) {
        return ordered_json();
    }
    return ReadReport(folder / "report.json");
}

Status<> MakeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        return Error{folder.string() + ": " + error.message()};
    }
    if (!std::filesystem::is_directory(folder, error)) {
        return Error{folder.string() + ": is a file, not a folder"};
    }
    if (access(folder.c_str(), W_OK | X_OK) != 0) {
        return Error{folder.string() + ": " + std::strerror(errno)};
    }
    return Ok();
}

std::string Compact(const ordered_json& json) {
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

// Leaves out what the page does not show of a record that is as it should be.
void Trim(ordered_json& record) {
    for (const char* const unused : {"family", "covers", "seed"}) {
        record.erase(unused);
    }
    const auto verdict = record.find("verdict");
    if (verdict == record.end() || *verdict != VerdictName(Verdict::kPass)) {
        return;
    }
    if (const auto parts = record.find("worst_parts"); parts != record.end()) {
        for (ordered_json& part : *parts) {
            part.erase("inputs");
            part.erase("output");
        }
    }
    if (const auto held = record.find("specification"); held != record.end() && held->is_object()) {
        held->erase("worst_outside");
    }
}

void Replace(std::string& text, std::string_view token, std::string_view by) {
    const std::size_t at = text.find(token);
    ETALON_CHECK(at != std::string::npos);
    text.replace(at, token.size(), by);
}

// A '<' can only stand in a string of JSON; there it must not end the script element.
std::string Escaped(const std::string& json) {
    std::string escaped;
    escaped.reserve(json.size() + json.size() / 64);
    for (const char c : json) {
        c == '<' ? escaped += "\\u003c" : escaped += c;
    }
    return escaped;
}

std::string PageOf(ordered_json report) {
    if (const auto run = report.find("run"); run != report.end() && run->contains("records")) {
        for (ordered_json& record : (*run)["records"]) {
            Trim(record);
        }
    }
    std::string page(PageHtml());
    // The data last: it may hold anything, these tokens too.
    Replace(page, "<!--STYLE-->", PageStyle());
    Replace(page, "<!--SCRIPT-->", PageScript());
    const std::size_t at = page.rfind("<!--DATA-->");
    ETALON_CHECK(at != std::string::npos);
    page.replace(at, std::strlen("<!--DATA-->"), Escaped(Compact(report)));
    return page;
}

// In the documented order, whatever the order in which the commands ran.
ordered_json Merged(const ordered_json& old, ReportSection section, const std::string& key,
                    ordered_json added) {
    ordered_json report = {
        {"format", kFormat}, {"version", ETALON_VERSION}, {"processor", ProcessorName()}};
    for (const ReportSection each : kSections) {
        const char* const name = SectionName(each);
        if (old.is_object() && old.contains(name)) {
            report[name] = old[name];
        } else if (each != ReportSection::kRun) {
            report[name] = ordered_json::object();
        }
    }
    ordered_json& place = report[SectionName(section)];
    (section == ReportSection::kRun ? place : place[key]) = std::move(added);
    return report;
}

}  // namespace

const char* SectionName(ReportSection section) {
    switch (section) {
        case ReportSection::kRun:
            return "run";
        case ReportSection::kSweeps:
            return "sweeps";
        case ReportSection::kCharts:
            return "charts";
        case ReportSection::kMaps:
            return "maps";
    }
    return "";
}

Status<> CheckReport(const std::filesystem::path& folder) {
    ETALON_TRY_STEP(MakeFolder(folder));
    ETALON_TRY_STEP(OldReport(folder));
    return Ok();
}

Status<> AddToReport(const std::filesystem::path& folder, ReportSection section,
                     const std::string& key, std::string_view json) {
    ETALON_CHECK(key.empty() == (section == ReportSection::kRun));
    ordered_json added = ordered_json::parse(json, nullptr, false);
    ETALON_CHECK(added.is_object());
    ETALON_TRY_STEP(MakeFolder(folder));
    const Result<FileLock> lock = FileLock::OnFolder(folder);
    if (!lock) {
        return lock.error();
    }
    ETALON_TRY(old, OldReport(folder));
    ordered_json report = Merged(old, section, key, std::move(added));
    ETALON_TRY_STEP(WriteFile(folder / "report.json", Compact(report) + "\n"));
    ETALON_TRY_STEP(WriteFile(folder / "report.schema.json", PageSchema()));
    return WriteFile(folder / "index.html", PageOf(std::move(report)));
}

std::string ReportPage(std::string_view report_json) {
    ordered_json report = ordered_json::parse(report_json, nullptr, false);
    ETALON_CHECK(report.is_object());
    return PageOf(std::move(report));
}

}  // namespace etalon
