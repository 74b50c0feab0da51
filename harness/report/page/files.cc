#include "report/page/files.h"

// Of embed.S.
extern "C" {
extern const char kEtalonPageHtml[], kEtalonPageHtmlEnd[];
extern const char kEtalonPageStyle[], kEtalonPageStyleEnd[];
extern const char kEtalonPageScript[], kEtalonPageScriptEnd[];
extern const char kEtalonPageSchema[], kEtalonPageSchemaEnd[];
}

namespace etalon {

std::string_view PageHtml() {
    return {kEtalonPageHtml, kEtalonPageHtmlEnd};
}

std::string_view PageStyle() {
    return {kEtalonPageStyle, kEtalonPageStyleEnd};
}

std::string_view PageScript() {
    return {kEtalonPageScript, kEtalonPageScriptEnd};
}

std::string_view PageSchema() {
    return {kEtalonPageSchema, kEtalonPageSchemaEnd};
}

}  // namespace etalon
