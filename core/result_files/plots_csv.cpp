// The data of a chart as CSV: one block of columns per series, side by side; a heat map as a matrix.
#include <algorithm>

#include "core/result_files/csv_text.h"
#include "core/result_files/csv_writer.h"
#include "core/text/numbers.h"
#include "core/views/plots.h"

namespace covaria {
namespace {

std::string line(const std::vector<std::string>& fields) {
    std::string out;
    for (std::size_t i = 0; i < fields.size(); ++i) out += (i ? "," : "") + csv_text(fields[i]);
    return out + "\r\n";
}

std::string at(const std::vector<double>& values, std::size_t i) {
    return i < values.size() ? format_exact(values[i]) : std::string();
}

std::string category(const PlotAxis& axis, const std::vector<double>& positions, std::size_t i) {
    if (axis.categories.empty() || i >= positions.size()) return at(positions, i);
    return to_unicode(axis.categories.at(static_cast<std::size_t>(positions[i])));
}

std::string matrix_csv(const PlotSpecification& plot, const PlotSeries& map) {
    std::vector<std::string> head = {csv_head(to_unicode(map.name), map.unit)};
    for (const Text& category : plot.x.categories) head.push_back(to_unicode(category));
    std::string out = line(head);
    const std::size_t columns = plot.x.categories.size();
    for (std::size_t row = 0; row < plot.y.categories.size(); ++row) {
        std::vector<std::string> fields = {to_unicode(plot.y.categories[row])};
        for (std::size_t i = 0; i < columns; ++i) fields.push_back(at(map.z, row * columns + i));
        out += line(fields);
    }
    return out;
}

}  // namespace

std::string plot_csv(const PlotSpecification& plot) {
    std::vector<std::string> head;
    std::size_t rows = 0;
    for (const PlotSeries& series : plot.series) {
        if (series.kind == SeriesKind::heat_map) return matrix_csv(plot, series);
        const Text name = series.name.empty() ? Text() : series.name + ": ";
        head.push_back(csv_head(to_unicode(name + plot.x.title), plot.x.unit));
        head.push_back(csv_head(to_unicode(name + plot.y.title), plot.y.unit));
        rows = std::max({rows, series.x.size(), series.y.size()});
    }
    std::string out = head.empty() ? std::string() : line(head);
    for (std::size_t row = 0; row < rows; ++row) {
        std::vector<std::string> fields;
        for (const PlotSeries& series : plot.series) {
            fields.push_back(category(plot.x, series.x, row));
            fields.push_back(category(plot.y, series.y, row));
        }
        out += line(fields);
    }
    return out;
}

}  // namespace covaria
