#include "report/page/files.h"

// Of embed.S.
extern "C" {
extern const char etalon_page_html[], etalon_page_html_end[];
extern const char etalon_page_css[], etalon_page_css_end[];
extern const char etalon_page_js[], etalon_page_js_end[];
extern const char etalon_page_schema[], etalon_page_schema_end[];
}

namespace etalon {

std::string_view PageHtml() {
    return {etalon_page_html, etalon_page_html_end};
}

std::string_view PageStyle() {
    return {etalon_page_css, etalon_page_css_end};
}

std::string_view PageScript() {
    return {etalon_page_js, etalon_page_js_end};
}

std::string_view PageSchema() {
    return {etalon_page_schema, etalon_page_schema_end};
}

}  // namespace etalon
