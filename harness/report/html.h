// A report of several commands in one folder: report.json, index.html that shows it without any
// network, and report.schema.json, the JSON Schema of the first.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace etalon {

// What a command adds. A run is one; of the others there are several, each with a key of its own:
// of a chart its family, of a map and a sweep what they are over.
enum class ReportSection { kRun, kSweeps, kCharts, kMaps };
const char* SectionName(ReportSection section);  // in report.json

// Makes the folder where there is none. Fails, naming the file and why, where nothing can be
// written there, or where it holds a report.json or index.html that is not whole or not ours.
Status<> CheckReport(const std::filesystem::path& folder);

// Puts `json`, a text that the reporters here write, in the place of what the report had under
// `section` and `key` (which a run has none of), keeps all else, and writes the files anew, each as
// a whole or not at all. Commands at work on one folder wait for each other. Fails as CheckReport
// does, with nothing changed.
Status<> AddToReport(const std::filesystem::path& folder, ReportSection section,
                     const std::string& key, std::string_view json);

// The page of a report. Of records that passed it holds a part only, and says so.
std::string ReportPage(std::string_view report_json);

// Writes each chart and map of what AddToReport takes as FOLDER/NAME.svg, by the program `node`.
// Fails where there is none, or nothing can be written.
Status<> WritePictures(const std::filesystem::path& folder, ReportSection section,
                       const std::string& key, std::string_view json);

// Fails where there is no `node` to write pictures with.
Status<> CheckPictures();

}  // namespace etalon
