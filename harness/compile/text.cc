#include "compile/text.h"

#include <algorithm>
#include <regex>
#include <vector>

#include "probe/generate.h"

namespace etalon {
namespace {

std::string_view Trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<std::string_view> Lines(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    }
    return lines;
}

}  // namespace

std::string FirstError(std::string_view log) {
    constexpr std::string_view kError = "ERROR: ";
    for (std::string_view line : Lines(log)) {
        line = Trim(line);
        if (!line.starts_with(kError)) {
            continue;
        }
        std::string message(line.substr(kError.size()));
        // What the includer says of a refused file is complete in itself.
        const std::size_t header = message.find("for header name: ");
        if (const std::size_t mark = message.find("'#include' : ");
            mark != std::string::npos && header != std::string::npos) {
            const std::size_t reason = mark + std::string_view("'#include' : ").size();
            message = message.substr(0, mark) +
                      std::string(Trim(std::string_view(message).substr(reason, header - reason)));
        }
        return message;
    }
    const std::string_view all = Trim(log);
    return all.empty() ? "the compiler failed without a message" : std::string(all.substr(0, 300));
}

std::string LinkError(std::string_view log, const std::string& source) {
    const std::vector<std::string_view> lines = Lines(log);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].find("No function definition (body) found") != std::string_view::npos &&
            i + 1 < lines.size()) {
            const std::string_view mangled = Trim(lines[i + 1]);
            return source + ": function '" + std::string(mangled.substr(0, mangled.find('('))) +
                   "' is declared but not defined; --with FILE adds a source that defines it";
        }
        if (lines[i].find("Recursion detected") != std::string_view::npos && i + 1 < lines.size()) {
            // "f(f1; calling g(f1;", mangled.
            const std::string_view calls = Trim(lines[i + 1]);
            const std::string caller(calls.substr(0, calls.find('(')));
            const std::size_t calling = calls.rfind(' ') + 1;
            const std::string called(calls.substr(calling, calls.find('(', calling) - calling));
            return source + ": recursion: function '" + caller + "' calls " +
                   (called == caller ? "itself" : "'" + called + "', which leads back to it");
        }
    }
    return source + ": " + FirstError(log);
}

std::string DriverText(std::string_view preprocessed, std::uint32_t version,
                       std::vector<std::string>& names) {
    names = {kGenerated};
    std::string head = "#version " + std::to_string(version) + " core\n";
    std::string body;
    for (const std::string_view line : Lines(preprocessed)) {
        const std::string_view directive = Trim(line);
        if (directive.starts_with("#extension")) {
            // The compiler's own extensions, and those of OpenGL ES, are nothing to a desktop
            // driver.
            if (directive.find("GL_GOOGLE_") == std::string_view::npos &&
                directive.find("GL_OES_") == std::string_view::npos) {
                head += std::string(directive) + "\n";
            }
        } else if (directive.starts_with("#line")) {
            const std::size_t open = directive.find('"');
            const std::size_t close = directive.rfind('"');
            if (open != std::string_view::npos && close > open) {
                const std::string name(directive.substr(open + 1, close - open - 1));
                auto known = std::find(names.begin(), names.end(), name);
                if (known == names.end()) {
                    known = names.insert(names.end(), name);
                }
                body += std::string(directive.substr(0, open)) +
                        std::to_string(known - names.begin()) + "\n";
                continue;  // a #line counts from the line after it, so it must add none of its own
            }
        } else if (!directive.starts_with("#pragma")) {
            body.append(line);
        }
        body += '\n';
    }
    return head + "#line 1 0\n" + body;
}

std::string DriverError(std::string_view log, const std::vector<std::string>& names) {
    static const std::regex mesa(R"(^(\d+):(\d+)\(\d+\): error: (.*)$)");
    static const std::regex nvidia(R"(^(\d+)\((\d+)\) : error \S+ (.*)$)");
    std::string first;
    int told = 0;
    for (const std::string_view raw : Lines(log)) {
        const std::string line(Trim(raw));
        // The device's own sentence, and what the log begins with.
        if (!line.empty() && told < 2) {
            first += (told++ == 0 ? "" : ": ") + line;
        }
        std::smatch match;
        if (std::regex_match(line, match, mesa) || std::regex_match(line, match, nvidia)) {
            const std::size_t name = std::stoul(match[1]);
            return (name < names.size() ? names[name] : match[1].str()) + ":" + match[2].str() +
                   ": " + match[3].str();
        }
    }
    return first;
}

}  // namespace etalon
