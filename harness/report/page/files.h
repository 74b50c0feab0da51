// The page's parts, as the build put them into the program.
#pragma once

#include <string_view>

namespace etalon {

std::string_view PageHtml();    // with <!--STYLE-->, <!--SCRIPT--> and <!--DATA--> where they go
std::string_view PageStyle();   // CSS
std::string_view PageScript();  // the libraries and our own modules; defines the global `Etalon`
std::string_view PageSchema();  // JSON Schema of report.json

}  // namespace etalon
