#include "cmd/report_option.h"

namespace etalon {
namespace {

Error Named(const char* option, const Error& error) {
    return Error{std::string(option) + ": " + error.message};
}

}  // namespace

void ReportOption::AddTo(CLI::App& word) {
    CLI::Option* const report =
        word.add_option("--report", folder_,
                        "add the results to the report in the folder DIR: index.html, a page that "
                        "needs no network, and report.json, its data")
            ->type_name("DIR");
    word.add_flag("--svg", has_pictures_,
                  "write each chart into DIR as a picture too; needs the program node")
        ->needs(report);
}

Status<> ReportOption::Check() const {
    if (folder_.empty()) {
        return Ok();
    }
    if (auto usable = CheckReport(folder_); !usable) {
        return Named("--report", usable.error());
    }
    if (has_pictures_) {
        if (auto usable = CheckPictures(); !usable) {
            return Named("--svg", usable.error());
        }
    }
    return Ok();
}

Status<> ReportOption::Add(ReportSection section, const std::string& key,
                           const std::function<std::string()>& json) const {
    if (folder_.empty()) {
        return Ok();
    }
    const std::string text = json();
    if (auto added = AddToReport(folder_, section, key, text); !added) {
        return Named("--report", added.error());
    }
    if (has_pictures_) {
        if (auto written = WritePictures(folder_, section, key, text); !written) {
            return Named("--svg", written.error());
        }
    }
    return Ok();
}

}  // namespace etalon
