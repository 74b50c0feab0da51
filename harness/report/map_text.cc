#include <algorithm>
#include <array>
#include <cmath>

#include "base/format.h"
#include "report/map_record.h"
#include "report/text.h"

namespace etalon {
namespace {

constexpr std::size_t kMostColumns = 64;
constexpr std::size_t kMostLines = 24;

// By MapMark.
constexpr char kSigns[] = {'.', 'x', 'm', 'w', 'N', 'I', 's', '?', '!'};
constexpr char kBoundary = '+';

constexpr char SignOf(MapMark mark) {
    return kSigns[static_cast<std::size_t>(mark)];
}

std::array<std::uint64_t, kMapMarks> Count(const std::vector<MapMark>& marks) {
    std::array<std::uint64_t, kMapMarks> counts = {};
    for (const MapMark mark : marks) {
        ++counts[static_cast<std::size_t>(mark)];
    }
    return counts;
}

std::string AxisText(const MapAxis& axis) {
    const std::vector<double>& ends = axis.is_whole ? axis.values : axis.edges;
    return format("{}, {} cells from {} to {}, {}", axis.name, axis.values.size(),
                  ShortNumber(ends.front()), ShortNumber(ends.back()),
                  axis.is_log ? "logarithmic" : "linear");
}

std::string InputsText(const std::vector<std::pair<std::string, Value>>& inputs, bool hexadecimal) {
    std::string text;
    for (const auto& [name, value] : inputs) {
        text += (text.empty() ? "" : ", ") + name + "=" + (hexadecimal ? value.hex : value.decimal);
    }
    return text;
}

// The map in as many blocks of cells as there are characters. What fails in a block is shown,
// however few of its cells do.
class Picture {
  public:
    Picture(const MapRecord& map, const std::vector<MapMark>& marks)
        : map_(map),
          marks_(marks),
          width_(map.x.values.size()),
          height_(map.y.values.size()),
          columns_(std::min(width_, kMostColumns)),
          lines_(std::min(height_, kMostLines)) {}

    std::string Text() const {
        std::string text;
        for (std::size_t line = lines_; line-- > 0;) {
            text += "    ";
            for (std::size_t column = 0; column < columns_; ++column) {
                const char sign = SignAt(column, line);
                text += IsFailure(sign) || !IsBoundary(column, line) ? sign : kBoundary;
            }
            text += "\n";
        }
        return text;
    }

    // How many cells a character stands for where it is more than one.
    std::string BlockText() const {
        const std::size_t across = (width_ + columns_ - 1) / columns_;
        const std::size_t along = (height_ + lines_ - 1) / lines_;
        return across * along == 1
                   ? ""
                   : format("  (up to {}x{} cells each; what fails goes first)", across, along);
    }

  private:
    static bool IsFailure(char sign) {
        return sign != SignOf(MapMark::kHolds) && sign != SignOf(MapMark::kUndecided);
    }

    // The cells of a block: first and behind the last.
    std::pair<std::size_t, std::size_t> Across(std::size_t column) const {
        return {column * width_ / columns_, (column + 1) * width_ / columns_};
    }
    std::pair<std::size_t, std::size_t> Along(std::size_t line) const {
        return {line * height_ / lines_, (line + 1) * height_ / lines_};
    }

    // The mark that most of its failed cells have; of all its cells where none failed.
    char SignAt(std::size_t column, std::size_t line) const {
        std::array<std::uint64_t, kMapMarks> counts = {};
        const auto [left, right] = Across(column);
        const auto [low, high] = Along(line);
        for (std::size_t y = low; y < high; ++y) {
            for (std::size_t x = left; x < right; ++x) {
                ++counts[static_cast<std::size_t>(marks_[y * width_ + x])];
            }
        }
        std::uint64_t& holds = counts[static_cast<std::size_t>(MapMark::kHolds)];
        std::uint64_t& undecided = counts[static_cast<std::size_t>(MapMark::kUndecided)];
        if (holds + undecided < (right - left) * (high - low)) {
            holds = undecided = 0;
        }
        return kSigns[std::max_element(counts.begin(), counts.end()) - counts.begin()];
    }

    // Whether the prediction changes inside of the block, or towards the one to the left or below;
    // or towards the others where a failure there hides it.
    bool IsBoundary(std::size_t column, std::size_t line) const {
        if (!map_.prediction) {
            return false;
        }
        const auto [left, right] = Across(column);
        const auto [low, high] = Along(line);
        const bool sees_right = column + 1 < columns_ && IsFailure(SignAt(column + 1, line));
        const bool sees_above = line + 1 < lines_ && IsFailure(SignAt(column, line + 1));
        const std::size_t from_x = left - (left > 0 ? 1 : 0);
        const std::size_t from_y = low - (low > 0 ? 1 : 0);
        const auto at = [&](std::size_t x, std::size_t y) {
            return map_.prediction->cells[y * width_ + x];
        };
        const MapForecast first = at(left, low);
        for (std::size_t y = from_y; y < high + (sees_above ? 1 : 0); ++y) {
            for (std::size_t x = from_x; x < right + (sees_right ? 1 : 0); ++x) {
                const bool is_corner = (x < left || x >= right) && (y < low || y >= high);
                if (!is_corner && at(x, y) != first) {
                    return true;
                }
            }
        }
        return false;
    }

    const MapRecord& map_;
    const std::vector<MapMark>& marks_;
    std::size_t width_;
    std::size_t height_;
    std::size_t columns_;
    std::size_t lines_;
};

std::string LegendText(const std::array<std::uint64_t, kMapMarks>& counts, bool has_prediction) {
    std::string text = "    ";
    std::string separator;
    for (std::size_t mark = 0; mark < kMapMarks; ++mark) {
        if (counts[mark] > 0) {
            text += format("{}{} {}", separator, kSigns[mark], kMapMarkNames[mark]);
            separator = "  ";
        }
    }
    return text + (has_prediction
                       ? format("{}{} where the prediction changes", separator, kBoundary)
                       : "");
}

std::string CountsText(const std::array<std::uint64_t, kMapMarks>& counts, std::size_t cells) {
    std::string text;
    for (std::size_t mark = 0; mark < kMapMarks; ++mark) {
        if (counts[mark] > 0) {
            text += format("{}{} {} ({:.4g} %)", text.empty() ? "" : ", ", counts[mark],
                           kMapMarkNames[mark],
                           100 * static_cast<double>(counts[mark]) / static_cast<double>(cells));
        }
    }
    return text;
}

std::string ObservedText(const Observation& worst) {
    std::string text = format("  worst     {}: {} ulp, {} absolute\n", worst.output,
                              ShortNumber(worst.ulp_error), ShortNumber(worst.error));
    text += "    input     " + InputsText(worst.inputs, false) + "\n";
    text += "              " + InputsText(worst.inputs, true) + "\n";
    text += format("    actual    {} = {}\n", worst.actual.decimal, worst.actual.hex);
    if (worst.expected) {
        text += format("    expected  {} = {}\n", worst.expected->decimal, worst.expected->hex);
    }
    return text;
}

std::string DeviceText(const MapRecord& map, const MappedDevice& device) {
    std::string text = format("\n{} ({}), {}\n", device.device, device.recipe, device.driver);
    if (!device.reason.empty()) {
        text += "  reason    " + device.reason + "\n";
    }
    if (device.mark.empty()) {
        return text;
    }
    const auto counts = Count(device.mark);
    text += "  cells     " + CountsText(counts, device.mark.size()) + "\n";
    if (device.worst) {
        text += ObservedText(*device.worst);
    }
    const Picture picture(map, device.mark);
    return text + picture.Text() + LegendText(counts, map.prediction.has_value()) +
           picture.BlockText() + "\n";
}

// The greatest of all cells and where it is.
std::string GreatestText(const MapRecord& map, const std::string& what,
                         const std::vector<double>& numbers) {
    std::size_t at = numbers.size();
    for (std::size_t cell = 0; cell < numbers.size(); ++cell) {
        if (!std::isnan(numbers[cell]) && (at == numbers.size() || numbers[cell] > numbers[at])) {
            at = cell;
        }
    }
    if (at == numbers.size()) {
        return "";
    }
    const std::size_t width = map.x.values.size();
    return format("  {:9} up to {}, at {}={}, {}={}\n", what, ShortNumber(numbers[at]), map.x.name,
                  ShortNumber(map.x.values[at % width]), map.y.name,
                  ShortNumber(map.y.values[at / width]));
}

std::string PredictionText(const PredictionSeen& prediction) {
    std::string text = "\nprediction: " + prediction.because + "\n";
    if (!prediction.fails.empty()) {
        text += "  fails     " + prediction.fails + "\n";
    }
    if (!prediction.safe.empty()) {
        text += "  safe      " + prediction.safe + "\n";
    }
    for (const MapAgreement& one : prediction.agreement) {
        text += format("  {:9} {}: {} of {} cells that must fail do, {} of {} that must hold do\n",
                       one.Holds() ? "agrees" : "DIFFERS", one.device, one.failed, one.fails,
                       one.safe_held, one.safe);
    }
    return text;
}

}  // namespace

bool MapRecord::Good() const {
    const bool crashed =
        std::any_of(devices.begin(), devices.end(), [](const MappedDevice& device) {
            return !device.mark.empty() && device.mark.front() == MapMark::kCrash;
        });
    return !crashed && !(prediction && prediction->contradiction);
}

std::string ContradictionText(const MapRecord& map) {
    const MapContradiction& first = *map.prediction->contradiction;
    return format("{} on {} ({}): {}, at {}\n  repeat    {}\n", map.case_path, first.device,
                  first.recipe, first.what, InputsText(first.inputs, true), first.repeat);
}

std::string MapText(const MapRecord& map) {
    std::string text = map.case_path + ", " + map.output + " by " + map.tolerance + "\n";
    if (!map.description.empty()) {
        text += "  about     " + map.description + "\n";
    }
    text += "  across    " + AxisText(map.x) + "\n";
    text += "  upwards   " + AxisText(map.y) + "\n";
    if (!map.fixed.empty()) {
        text += "  others    " + map.fixed + "\n";
    }
    text += GreatestText(map, "condition", map.condition);
    text += GreatestText(map, "apart", map.disagreement);
    for (const MappedDevice& device : map.devices) {
        text += DeviceText(map, device);
    }
    if (map.prediction) {
        text += PredictionText(*map.prediction);
    }
    return text + "\nrepeat: " + map.repeat + "\n";
}

}  // namespace etalon
