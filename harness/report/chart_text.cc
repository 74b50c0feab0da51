#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "report/chart_record.h"
#include "report/text.h"

namespace etalon {
namespace {

struct Column {
    std::string title;
    std::string (*cell)(const ChartPoint& point);
};

std::string NumberText(double value) {
    return std::isnan(value) ? "-" : ShortNumber(value);
}

// A time that was not told from nothing is an upper bound. Nanoseconds where the reference has no
// time.
std::string TimeText(const ChartPoint& point, bool with_spread = true) {
    if (!point.cost) {
        return "-";
    }
    const ChartCost& cost = *point.cost;
    const ChartCost::Ratio time =
        cost.ratio ? *cost.ratio : ChartCost::Ratio{cost.nanoseconds, cost.low, cost.high};
    const char* const unit = cost.ratio ? "" : " ns";
    if (time.low == 0) {
        return format("under {:.2f}{}", std::max(std::ceil(100 * time.high) / 100, 0.01), unit);
    }
    return with_spread ? format("{:.2f} ({:.2f}..{:.2f}){}", time.value, time.low, time.high, unit)
                       : format("{:.2f}{}", time.value, unit);
}

std::string BitsText(const ChartPoint& point) {
    if (!point.accuracy || !std::isfinite(point.accuracy->bits)) {
        return point.accuracy && point.accuracy->bits > 0 ? "exact" : "-";
    }
    const std::string text = format("{:.1f}", point.accuracy->bits);
    return text == "-0.0" ? "0.0" : text;
}

std::string CountText(const ChartPoint& point, double ChartCounts::*count) {
    return point.mean ? format("{:.4g}", (*point.mean).*count) : "-";
}

std::string AccuracyText(const ChartPoint& point, double ChartAccuracy::*number) {
    return point.accuracy ? NumberText((*point.accuracy).*number) : "-";
}

std::string ShareText(const ChartPoint& point, double ChartAccuracy::*share) {
    return point.accuracy ? format("{:.3g} %", 100 * (*point.accuracy).*share) : "-";
}

std::vector<Column> Columns(const ChartRecord& chart) {
    std::vector<Column> columns;
    if (chart.cost_by == "time") {
        columns.push_back({"time", [](const ChartPoint& point) { return TimeText(point); }});
    }
    columns.push_back({"operations", [](const ChartPoint& point) {
                           return CountText(point, &ChartCounts::total);
                       }});
    columns.push_back(
        {"fetches", [](const ChartPoint& point) { return CountText(point, &ChartCounts::fetch); }});
    const auto any = [&chart](auto has) {
        return std::any_of(chart.points.begin(), chart.points.end(), has);
    };
    if (any([](const ChartPoint& point) { return point.accuracy.has_value(); })) {
        columns.push_back({"worst", [](const ChartPoint& point) {
                               return AccuracyText(point, &ChartAccuracy::worst);
                           }});
        columns.push_back({"99.9 %", [](const ChartPoint& point) {
                               return AccuracyText(point, &ChartAccuracy::p999);
                           }});
        columns.push_back({"rms", [](const ChartPoint& point) {
                               return AccuracyText(point, &ChartAccuracy::rms);
                           }});
        columns.push_back({"bits", BitsText});
        if (chart.search) {
            columns.push_back({"missed", [](const ChartPoint& point) {
                                   return ShareText(point, &ChartAccuracy::missed);
                               }});
            columns.push_back({"wrong", [](const ChartPoint& point) {
                                   return ShareText(point, &ChartAccuracy::wrong);
                               }});
        }
    }
    if (any([](const ChartPoint& point) { return point.published_ratio.has_value(); })) {
        columns.push_back({"published", [](const ChartPoint& point) {
                               return point.published_ratio
                                          ? format("{:.2f}", *point.published_ratio)
                                          : "-";
                           }});
    }
    return columns;
}

// What a line says behind the label.
std::string RemarkText(const ChartPoint& point) {
    std::string text;
    const auto add = [&text](const std::string& remark) {
        text += (text.empty() ? "" : "; ") + remark;
    };
    if (point.accuracy && point.accuracy->not_finite > 0) {
        add(format("{} of {} rows not finite", point.accuracy->not_finite, point.accuracy->judged));
    }
    if (point.accuracy && point.accuracy->refused > 0) {
        add(format("{} values refused", point.accuracy->refused));
    }
    if (!point.reason.empty()) {
        add(point.reason);
    }
    return text.empty() ? "" : "  (" + text + ")";
}

// Rows of cells in columns, those from `left` on to the left, the others to the right.
std::string AlignedText(const std::vector<std::vector<std::string>>& rows, std::size_t left) {
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const auto& row : rows) {
        for (std::size_t k = 0; k < row.size(); ++k) {
            widths[k] = std::max(widths[k], row[k].size());
        }
    }
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t k = 0; k + 1 < row.size(); ++k) {
            text += k < left ? format("{:>{}}  ", row[k], widths[k])
                             : format("{:<{}}  ", row[k], widths[k]);
        }
        text += row.back() + "\n";
    }
    return text;
}

std::string PointsText(const ChartRecord& chart, const std::vector<const ChartPoint*>& points) {
    const std::vector<Column> columns = Columns(chart);
    std::vector<std::vector<std::string>> rows(1);
    rows[0].emplace_back(" ");
    for (const Column& column : columns) {
        rows[0].push_back(column.title);
    }
    rows[0].emplace_back("member");
    for (const ChartPoint* point : points) {
        std::vector<std::string> row = {point->front ? "*" : point->refused ? "!" : " "};
        for (const Column& column : columns) {
            row.push_back(column.cell(*point));
        }
        row.push_back(point->label + RemarkText(*point));
        rows.push_back(std::move(row));
    }
    return AlignedText(rows, rows.front().size());
}

// What a search that holds a bound with its right hits does with the others: " (2.2 % wrong)".
std::string OffText(const ChartPoint& point) {
    std::string text;
    for (const auto& [share, what] :
         {std::pair(&ChartAccuracy::missed, "missed"), std::pair(&ChartAccuracy::wrong, "wrong")}) {
        if ((*point.accuracy).*share > 0) {
            text += (text.empty() ? " (" : ", ") + ShareText(point, share) + " " + what;
        }
    }
    return text.empty() ? "" : text + ")";
}

// "1.00  exp2": with the ratio of its time, or with its operations.
std::string BoundText(const ChartRecord& chart, const ChartBound& bound) {
    if (!bound.point) {
        return "none";
    }
    const ChartPoint& point = chart.points[*bound.point];
    return (chart.cost_by == "time" ? TimeText(point, false)
                                    : CountText(point, &ChartCounts::total)) +
           "  " + point.label + OffText(point);
}

std::string BoundsText(const ChartRecord& chart, const std::string& device,
                       const std::string& scene) {
    std::vector<std::vector<std::string>> rows = {
        {"error up to", chart.search ? "cheapest by its worst right hit" : "cheapest by its worst",
         chart.search ? "cheapest by 99.9 % of its right hits" : "cheapest by 99.9 % of the rows"}};
    for (const ChartBound& bound : chart.bounds) {
        if (bound.device != device || bound.scene != scene) {
            continue;
        }
        if (bound.by == "worst") {
            rows.push_back({bound.text, BoundText(chart, bound), ""});
        } else {
            rows.back().back() = BoundText(chart, bound);
        }
    }
    return rows.size() > 1 ? "\n" + AlignedText(rows, 1) : "";
}

// Actual and expected values, where the chart was made at one input.
std::string ValuesText(const std::vector<const ChartPoint*>& points) {
    std::string text;
    for (const ChartPoint* point : points) {
        if (point->accuracy && point->accuracy->shown) {
            const Observation& shown = *point->accuracy->shown;
            text += format("\n{}, {}\n  actual    {} = {}\n  expected  {} = {}\n", point->label,
                           shown.output, shown.actual.decimal, shown.actual.hex,
                           shown.expected->decimal, shown.expected->hex);
        }
    }
    return text;
}

bool HasErrors(const ChartRecord& chart) {
    return std::any_of(chart.points.begin(), chart.points.end(),
                       [](const ChartPoint& point) { return point.accuracy.has_value(); });
}

std::string SceneText(const ChartRecord& chart, const DeviceInfo& device,
                      const std::string& scene) {
    std::vector<const ChartPoint*> points;
    for (const ChartPoint& point : chart.points) {
        if (point.device == device.name && point.scene == scene) {
            points.push_back(&point);
        }
    }
    if (points.empty()) {
        return "";
    }
    // Costs alone stand in the family's order: it may be that of techniques one upon the other.
    if (HasErrors(chart)) {
        std::stable_sort(points.begin(), points.end(),
                         [&chart](const ChartPoint* a, const ChartPoint* b) {
                             const double first = CostOf(chart, *a);
                             const double second = CostOf(chart, *b);
                             return std::isnan(second) ? !std::isnan(first) : first < second;
                         });
    }
    const bool is_one = chart.scenes.size() == 1 && chart.scenes.front().name.empty();
    return format("\n{} ({}){}\n", device.name, points.front()->recipe,
                  is_one           ? ""
                  : scene == "all" ? format(", all {} scenes", chart.scenes.size())
                                   : ", scene '" + scene + "'") +
           PointsText(chart, points) + (chart.at.empty() ? "" : ValuesText(points)) +
           (chart.at.empty() ? BoundsText(chart, device.name, scene) : "");
}

}  // namespace

std::string ChartText(const ChartRecord& chart, bool with_scenes) {
    std::string text = chart.family;
    if (!chart.quantity.empty()) {
        text += ": " + chart.quantity;
    }
    text += "\n";
    if (!chart.at.empty()) {
        text += "  at        " + chart.at + "\n";
    }
    const bool has_errors = HasErrors(chart);
    if (has_errors) {
        text += "  errors    " + chart.measure + (chart.unit.empty() ? "" : ", " + chart.unit) +
                (chart.search ? ", of right hits\n" : "\n");
    }
    text += chart.cost_by == "time" ? "  times     over that of '" + chart.reference + "'\n"
                                    : "  cost      operations of a call\n";
    const bool has_refused = std::any_of(chart.points.begin(), chart.points.end(),
                                         [](const ChartPoint& point) { return point.refused; });
    if (has_errors) {
        text += "  marks     * on the front of cost and worst error" +
                std::string(has_refused ? ", ! refused by the family's 'accept'\n" : "\n");
    }
    for (const DeviceInfo& device : chart.devices) {
        const bool is_named = chart.scenes.size() > 1 || !chart.scenes.front().name.empty();
        if (with_scenes && is_named) {
            for (const ChartScene& scene : chart.scenes) {
                text += SceneText(chart, device, scene.name);
            }
        }
        text += SceneText(chart, device, "all");
    }
    return text;
}

}  // namespace etalon
