// The Stewart platform of Porath et al. as set-ups made in code, for tests.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/kinds/registries.h"
#include "core/result/uncertainty_result.h"

namespace covaria::stewart {

inline constexpr int poses = 13;
using Row = std::array<double, poses>;

/// Table 3 with z = 1175 mm for poses 6-13 (printed: 0). Millimetres and degrees.
inline constexpr std::array<std::array<double, 6>, poses> table_3{{{-120, 120, 1235, 0, 0, 0},
                                                                   {-120, -120, 1235, 0, 0, 0},
                                                                   {0, 0, 1175, 0, 0, 0},
                                                                   {120, 120, 1115, 0, 0, 0},
                                                                   {120, -120, 1115, 0, 0, 0},
                                                                   {0, 0, 1175, -5, 0, 0},
                                                                   {0, 0, 1175, 5, 0, 0},
                                                                   {0, 0, 1175, 0, -5, 0},
                                                                   {0, 0, 1175, 0, 5, 0},
                                                                   {0, 0, 1175, 0, 0, -5},
                                                                   {0, 0, 1175, 0, 0, 5},
                                                                   {0, 0, 1175, -5, -5, -5},
                                                                   {0, 0, 1175, 5, 5, 5}}};

/// Table 4 as published: U(x), U(y), U(z) in mm; U of every angle is 0.10 degrees.
inline constexpr std::array<Row, 3> table_4{
    {{.52, .53, .51, .48, .50, .51, .51, .51, .51, .50, .52, .50, .52},
     {.63, .63, .61, .60, .60, .61, .61, .61, .61, .62, .60, .62, .60},
     {.40, .40, .40, .41, .41, .40, .40, .40, .40, .40, .40, .40, .40}}};

using Points = std::vector<std::array<double, 3>>;
/// Equilateral triangles of side 688 and 392 mm.
inline const Points base_688{{-344, 196, 0}, {344, 196, 0}, {0, -399.825, 0}};
inline const Points platform_392{{-196, -111, 0}, {196, -111, 0}, {0, 228.482, 0}};
/// The triangles that Table 4 implies.
inline const Points base_678{{-344, 196, 0}, {334, 196, 0}, {-5, -391.165, 0}};
inline const Points platform_391{{-196, -111, 0}, {195, -111, 0}, {-0.5, 227.616, 0}};

inline const ModelDescriptor& descriptor() {
    return *find_model("pose-from-points");
}

inline Quantity mm(double value) {
    return {value, Unit::of("mm")};
}

inline SetupTable empty_table(const std::string& key) {
    SetupTable table;
    for (const ColumnSpec& column : descriptor().schema.find(key)->columns)
        table.units.push_back(column.unit);
    return table;
}

inline SetupTable points_table(const std::string& key, const std::string& letter, const Points& points) {
    SetupTable table = empty_table(key);
    for (std::size_t i = 0; i < points.size(); ++i)
        table.rows.push_back(
            {letter + std::to_string(i + 1), points[i][0], points[i][1], points[i][2], {}, {}, {}});
    return table;
}

inline std::string pose_name(std::size_t k) {
    return "pose " + std::to_string(k + 1);
}

inline SetupTable poses_table(const std::vector<std::array<double, 6>>& values) {
    SetupTable table = empty_table("poses");
    for (std::size_t k = 0; k < values.size(); ++k) {
        std::vector<SetupCell> row{pose_name(k)};
        for (double v : values[k]) row.emplace_back(v);
        table.rows.push_back(std::move(row));
    }
    return table;
}

/// Typed uncertainties in mm for the base (x, y, z) and, alike in all directions, for the platform.
inline Setup setup(const Points& base = base_688, const Points& platform = platform_392,
                   const std::array<double, 3>& u_b = {.066, .110, .105}, double u_p = .236) {
    Setup s;
    s.values["base_points"] = points_table("base_points", "b", base);
    s.values["moving_points"] = points_table("moving_points", "p", platform);
    s.values["poses"] = poses_table({table_3.begin(), table_3.end()});
    const std::array<const char*, 3> axes{"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i) {
        s.values[std::string("base_u_") + axes[i]] = mm(u_b[i]);
        s.values[std::string("moving_u_") + axes[i]] = mm(u_p);
    }
    s.values["base_shift_x"] = mm(344);
    s.values["base_shift_y"] = mm(-196);
    s.values["moving_shift_x"] = mm(196);
    s.values["moving_shift_y"] = mm(111);
    return s;
}

/// Checks the set-up as the program does, then creates.
inline std::unique_ptr<MeasurementModel> make(const Setup& s, Problems& problems,
                                              const AssetLibrary& assets = {}) {
    check_setup(descriptor().schema, s, problems);
    if (problems.has_errors()) return nullptr;
    return descriptor().create(SetupReader(descriptor().schema, s), assets, problems);
}

/// Terminates a test if the set-up has errors.
inline std::unique_ptr<MeasurementModel> make(const Setup& s, const AssetLibrary& assets = {}) {
    Problems problems;
    auto model = make(s, problems, assets);
    if (!model)
        throw std::runtime_error(problems.items().front().path + ": " +
                                 problems.items().front().message.english());
    return model;
}

inline std::vector<double> estimates(const InputSet& inputs) {
    std::vector<double> x;
    for (std::size_t i = 0; i < inputs.quantities.size(); ++i) x.push_back(estimate_of(inputs, i));
    return x;
}

/// 2u of output j (0 ... 5) of pose k, in mm or degrees.
inline double expanded(const UncertaintyResult& result, std::size_t k, std::size_t j,
                       bool first_order = false) {
    const OutputResult& out = result.outputs.at(6 * k + j);
    const double u =
        first_order ? out.first_order.standard_uncertainty : out.monte_carlo.value().standard_uncertainty;
    return 2.0 * out.quantity.unit.interval_from_si(u);
}

/// Makes an asset of a kind, for the library under the id "a".
AssetLibrary library_of(const std::string& kind, const Setup& s);

}  // namespace covaria::stewart
