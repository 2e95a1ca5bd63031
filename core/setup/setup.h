// The values a user gave for the fields of a SetupSchema, kept as typed (with their units), read as SI.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/error.h"
#include "core/base/unit.h"

namespace covaria {

class SetupSchema;

/// A pose as typed: X_AB by position and ZYX angles (R = Rz(gamma) Ry(beta) Rx(alpha)).
struct PoseValue {
    std::array<double, 3> position{};  ///< coordinates in length_unit
    std::array<double, 3> angles{};    ///< alpha, beta, gamma in angle_unit
    Unit length_unit = Unit::of("mm");
    Unit angle_unit = Unit::of("deg");
    Eigen::Isometry3d si() const;
    std::array<double, 6> coordinates_si() const;  ///< position in m, angles in rad
    bool operator==(const PoseValue&) const = default;
};

using SetupCell =
    std::variant<std::monostate, double, std::string, bool>;  ///< numbers in the unit of their column

struct SetupTable {
    std::vector<Unit> units;  ///< one per column of the schema (unit one for columns without)
    std::vector<std::vector<SetupCell>> rows;
    std::string csv_file =
        {};  ///< if not empty: rows were read from this file beside the project, and are not saved
    /// Headers of that file that stand for another: {"Fx_mV_per_V", "Fx [mV/V]"}; an empty text: a column
    /// that is not read.
    std::vector<std::pair<std::string, std::string>> csv_columns = {};
    bool operator==(const SetupTable&) const = default;
};

/// Value of a field: nothing, a number, an integer/flag/choice/text/reference, a table, a pose.
using SetupValue = std::variant<std::monostate, Quantity, bool, std::string, SetupTable, PoseValue>;

/// Plain value: key -> value. Keys missing here take the schema's default. Equality is as typed (bytes on
/// disk follow).
struct Setup {
    std::map<std::string, SetupValue> values;
    bool operator==(const Setup&) const = default;
};

/// A set-up together with the schema that gives defaults and units; read by Fields (core/setup/fields.h).
/// Valid only while both live.
class SetupReader {
public:
    SetupReader(const SetupSchema& schema, const Setup& setup) : schema_(&schema), setup_(&setup) {}
    const SetupSchema& schema() const { return *schema_; }
    const Setup& setup() const { return *setup_; }

private:
    const SetupSchema* schema_;
    const Setup* setup_;
};

}  // namespace covaria
