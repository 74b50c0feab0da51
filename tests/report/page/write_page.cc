// write_page REPORT.json PAGE.html: the page of a report, for the page's tests.
#include <iostream>

#include "base/file.h"
#include "report/html.h"

int main(int count, char** words) {
    const auto report = etalon::ReadFile(count == 3 ? words[1] : "");
    if (!report) {
        std::cerr << report.error().message << "\n";
        return 2;
    }
    return etalon::WriteFile(words[2], etalon::ReportPage(*report)) ? 0 : 2;
}
