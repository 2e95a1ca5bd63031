// A study as one table: axes, outputs, points in space, remarks.
#include <cmath>

#include "core/result/representation.h"
#include "core/result_files/result_tables.h"

namespace covaria {
namespace {

Unit squared(const Unit& unit) {
    if (unit == Unit{}) return unit;
    const auto square = Unit::parse(unit.text() + "^2");
    return square ? *square : Unit{};
}

std::string of_group(const std::string& symbol, const std::string& group) {
    return group.empty() ? symbol : group + " " + symbol;
}

void add_heads(const StudyResult& study, Table& table) {
    const auto add = [&](const std::string& head, const Unit& unit) { table.add(head).in(unit); };
    for (const StudyAxisValues& axis : study.axes) add(axis.title.message().english(), axis.unit);
    for (const OutputQuantity& output : study.outputs) {
        const std::string name = of_group(output.symbol, output.group);
        add(name, output.unit);
        add("u " + name, output.unit);
        add("U " + name, output.unit);
    }
    static const char* const pairs[] = {"xx", "xy", "xz", "yy", "yz", "zz"};
    for (const StudyTriple& triple : study.triples) {
        const Unit& unit = study.outputs[triple.outputs[0]].unit;
        for (const char* axis : {"x", "y", "z"}) add(triple.name + " position " + axis, unit);
        add("u_3D " + triple.name, unit);
        for (const char* pair : pairs) add(triple.name + " covariance " + pair, squared(unit));
    }
    if (study.trials > 0) add("failed trials", {});
    add("remark", {});
}

void add_place(const StudyPlace& place, const Unit& unit, std::vector<Cell>& row) {
    for (const double coordinate : place.p_W) row.emplace_back(Quantity{unit.from_si(coordinate), unit});
    row.emplace_back(Quantity{unit.interval_from_si(place.standard_uncertainty()), unit});
    const Unit square = squared(unit);
    for (Eigen::Index a = 0; a < 3; ++a)
        for (Eigen::Index b = a; b < 3; ++b)
            row.emplace_back(Quantity{square.from_si(place.covariance(a, b)), square});
}

std::vector<Cell> row_of(const StudyResult& study, std::size_t index, std::size_t columns) {
    const StudyPoint& point = study.points[index];
    std::vector<Cell> row;
    const std::vector<std::size_t> at = study.indices_of(index);
    for (std::size_t axis = 0; axis < at.size(); ++axis)
        row.emplace_back(Quantity{study.axes[axis].values[at[axis]], study.axes[axis].unit});
    for (std::size_t j = 0; point.has_values() && j < study.outputs.size(); ++j) {
        const Unit& unit = study.outputs[j].unit;
        row.emplace_back(Quantity{unit.from_si(point.values[j].estimate), unit});
        row.emplace_back(Quantity{unit.interval_from_si(point.values[j].standard_uncertainty), unit});
        row.emplace_back(Quantity{unit.interval_from_si(point.values[j].expanded_uncertainty), unit});
    }
    for (std::size_t t = 0; point.has_values() && t < study.triples.size(); ++t)
        add_place(point.places[t], study.outputs[study.triples[t].outputs[0]].unit, row);
    row.resize(columns);
    if (study.trials > 0 && point.has_values()) row[columns - 2] = static_cast<double>(point.failed_trials);
    if (Message remark = remark_on(study, index); !remark.empty()) row.back() = std::move(remark);
    return row;
}

}  // namespace

Table study_table(const StudyResult& study) {
    Table table{"study-" + study.id, study.name};
    add_heads(study, table);
    for (std::size_t i = 0; i < study.points.size(); ++i) table.row(row_of(study, i, table.columns.size()));
    return table;
}

}  // namespace covaria
