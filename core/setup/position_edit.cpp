// Positions written into poses and rows of tables, and orientations into poses.
#include "core/setup/position_edit.h"

#include <charconv>
#include <cmath>

#include "core/math/rotation.h"

namespace covaria {

namespace {

/// Coordinate in `unit`; `before` (in `unit`) where it has not moved by a step.
double rounded(double si, double step, const Unit& unit, double before) {
    if (std::abs(si - unit.to_si(before)) < 0.5 * step) return before;
    const double digits = std::floor(std::log10(unit.interval_from_si(step)));
    const double cell = std::pow(10.0, std::abs(digits));
    const double value = unit.from_si(si);
    return digits < 0 ? std::round(value * cell) / cell : std::round(value / cell) * cell;
}

bool write_pose(PoseValue& pose, const Eigen::Vector3d& p, double step) {
    for (int i = 0; i < 3; ++i) {
        double& coordinate = pose.position[static_cast<std::size_t>(i)];
        coordinate = rounded(p[i], step, pose.length_unit, coordinate);
    }
    return true;
}

bool write_row(const FieldSpec& field, SetupTable& table, std::size_t row, const Eigen::Vector3d& p,
               double step) {
    if (row >= table.rows.size()) return false;
    std::vector<SetupCell>& cells = table.rows[row];
    const char* const keys[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        const std::size_t column = SetupSchema::column(field, keys[i]);
        if (column == SetupSchema::npos || column >= cells.size() || column >= table.units.size())
            return false;
        const double* before = std::get_if<double>(&cells[column]);
        if (!before) return false;
        cells[column] = rounded(p[i], step, table.units[column], *before);
    }
    table.csv_file.clear();
    table.csv_columns.clear();
    return true;
}

/// "/targets/rows/3" -> 3
bool row_of(const std::string& text, std::size_t& row) {
    constexpr std::string_view rows = "/rows/";
    if (!text.starts_with(rows)) return false;
    const char* const end = text.data() + text.size();
    const auto [last, problem] = std::from_chars(text.data() + rows.size(), end, row);
    return problem == std::errc() && last == end;
}

}  // namespace

bool write_position(const SetupSchema& schema, Setup& setup, const std::string& path,
                    const Eigen::Vector3d& p, double step) {
    const std::size_t slash = path.find('/', 1);
    const std::string key =
        path.empty() ? "" : path.substr(1, slash == std::string::npos ? slash : slash - 1);
    const FieldSpec* field = schema.find(key);
    if (!field || !p.allFinite() || !(step > 0.0)) return false;
    SetupValue value = value_of(*field, setup);
    bool written = false;
    std::size_t row = 0;
    if (auto* pose = std::get_if<PoseValue>(&value); pose && slash == std::string::npos)
        written = write_pose(*pose, p, step);
    else if (auto* table = std::get_if<SetupTable>(&value);
             table && slash != std::string::npos && row_of(path.substr(slash), row))
        written = write_row(*field, *table, row, p, step);
    if (written) setup.values[key] = std::move(value);
    return written;
}

bool write_orientation(const SetupSchema& schema, Setup& setup, const std::string& path,
                       const Eigen::Matrix3d& R, double step) {
    const std::string key = path.empty() ? "" : path.substr(1);
    const FieldSpec* field = schema.find(key);
    if (!field || !R.allFinite() || !(step > 0.0)) return false;
    SetupValue value = value_of(*field, setup);
    auto* pose = std::get_if<PoseValue>(&value);
    if (!pose) return false;
    const Vector3<double> angles = zyx_from_rotation<double>(R);
    for (int i = 0; i < 3; ++i) {
        double& angle = pose->angles[static_cast<std::size_t>(i)];
        angle = rounded(angles[i], step, pose->angle_unit, angle);
    }
    setup.values[key] = std::move(value);
    return true;
}

}  // namespace covaria
