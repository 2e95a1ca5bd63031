#include "core/setup/setup.h"

#include <cmath>
#include <cstdio>
#include <exception>

#include "core/setup/setup_schema.h"

namespace covaria {

namespace {

[[noreturn]] void misuse(const std::string& key, const char* what) {
    std::fprintf(stderr, "covaria: set-up field '%s' %s\n", key.c_str(), what);
    std::terminate();
}

const FieldSpec& field_of(const SetupSchema& schema, const std::string& key) {
    const FieldSpec* field = schema.find(key);
    if (!field) misuse(key, "is not in the schema");
    return *field;
}

template <class T>
const T& read(const SetupSchema& schema, const Setup& setup, const std::string& key) {
    const SetupValue& value = value_of(field_of(schema, key), setup);
    const T* typed = std::get_if<T>(&value);
    if (!typed) misuse(key, "is read as another kind than it has, or was not given");
    return *typed;
}

const SetupTable& table_of(const SetupSchema& schema, const Setup& setup, const std::string& key) {
    static const SetupTable no_rows;
    const FieldSpec& field = field_of(schema, key);
    if (field.kind != FieldKind::table) misuse(key, "is not a table");
    const SetupTable* table = std::get_if<SetupTable>(&value_of(field, setup));
    return table ? *table : no_rows;
}

struct CellPlace {
    const SetupCell& cell;
    Unit unit;
};

CellPlace cell_at(const SetupSchema& schema, const Setup& setup, const std::string& key, std::size_t row,
                  const std::string& column) {
    static const SetupCell empty;
    const std::size_t index = SetupSchema::column(field_of(schema, key), column);
    if (index == SetupSchema::npos) misuse(key + "/" + column, "is not a column of the table");
    const SetupTable& table = table_of(schema, setup, key);
    if (row >= table.rows.size()) misuse(key, "has fewer rows than are read");
    const auto& cells = table.rows[row];
    return {index < cells.size() ? cells[index] : empty,
            index < table.units.size() ? table.units[index] : Unit{}};
}

}  // namespace

Eigen::Isometry3d PoseValue::si() const {
    const auto angle = [&](std::size_t i, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(angle_unit.to_si(angles[i]), axis);
    };
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = (angle(2, Eigen::Vector3d::UnitZ()) * angle(1, Eigen::Vector3d::UnitY()) *
                     angle(0, Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
    for (int i = 0; i < 3; ++i)
        pose.translation()[i] = length_unit.to_si(position[static_cast<std::size_t>(i)]);
    return pose;
}

std::array<double, 6> PoseValue::coordinates_si() const {
    std::array<double, 6> si{};
    for (std::size_t i = 0; i < 3; ++i) {
        si[i] = length_unit.to_si(position[i]);
        si[i + 3] = angle_unit.to_si(angles[i]);
    }
    return si;
}

bool SetupReader::has(const std::string& key) const {
    return !std::holds_alternative<std::monostate>(value_of(field_of(*schema_, key), *setup_));
}

double SetupReader::number(const std::string& key) const {
    return read<Quantity>(*schema_, *setup_, key).si();
}

int SetupReader::integer(const std::string& key) const {
    return static_cast<int>(std::lround(read<Quantity>(*schema_, *setup_, key).value));
}

bool SetupReader::flag(const std::string& key) const {
    return read<bool>(*schema_, *setup_, key);
}

std::string SetupReader::text(const std::string& key) const {
    return read<std::string>(*schema_, *setup_, key);
}

Eigen::Isometry3d SetupReader::pose(const std::string& key) const {
    return read<PoseValue>(*schema_, *setup_, key).si();
}

std::array<double, 6> SetupReader::pose_coordinates(const std::string& key) const {
    return read<PoseValue>(*schema_, *setup_, key).coordinates_si();
}

std::size_t SetupReader::rows(const std::string& table) const {
    return table_of(*schema_, *setup_, table).rows.size();
}

bool SetupReader::cell_empty(const std::string& table, std::size_t row, const std::string& column) const {
    return std::holds_alternative<std::monostate>(cell_at(*schema_, *setup_, table, row, column).cell);
}

double SetupReader::cell_number(const std::string& table, std::size_t row, const std::string& column) const {
    const CellPlace place = cell_at(*schema_, *setup_, table, row, column);
    const double* value = std::get_if<double>(&place.cell);
    if (!value) misuse(table + "/" + column, "is read as a number, but is empty or something else");
    return place.unit.to_si(*value);
}

std::string SetupReader::cell_text(const std::string& table, std::size_t row,
                                   const std::string& column) const {
    const SetupCell& cell = cell_at(*schema_, *setup_, table, row, column).cell;
    if (std::holds_alternative<std::monostate>(cell)) return {};
    const std::string* value = std::get_if<std::string>(&cell);
    if (!value) misuse(table + "/" + column, "is read as text, but is something else");
    return *value;
}

bool SetupReader::cell_flag(const std::string& table, std::size_t row, const std::string& column) const {
    const SetupCell& cell = cell_at(*schema_, *setup_, table, row, column).cell;
    if (std::holds_alternative<std::monostate>(cell)) return false;
    const bool* value = std::get_if<bool>(&cell);
    if (!value) misuse(table + "/" + column, "is read as a flag, but is something else");
    return *value;
}

Eigen::Vector3d SetupReader::cell_vector(const std::string& table, std::size_t row,
                                         const std::string& first_column) const {
    const FieldSpec& field = field_of(*schema_, table);
    const std::size_t first = SetupSchema::column(field, first_column);
    if (first == SetupSchema::npos || first + 3 > field.columns.size())
        misuse(table + "/" + first_column, "does not begin three columns of the table");
    Eigen::Vector3d vector;
    for (int i = 0; i < 3; ++i)
        vector[i] = cell_number(table, row, field.columns[first + static_cast<std::size_t>(i)].key);
    return vector;
}

}  // namespace covaria
