// The fields of a model's or asset's set-up, listed once: form, validation, `covaria describe`, report and
// help derive from it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/base/unit.h"
#include "core/setup/setup.h"

namespace covaria {

enum class FieldKind { number, integer, choice, text, flag, pose, table, reference };

struct Choice {
    std::string key;    ///< name in files: "zyx"
    std::string title;  ///< name for people: "Z-Y-X (yaw, pitch, roll)"
};

/// The field is shown and used only where another field has one of these values.
struct Condition {
    std::string key;
    std::vector<std::string> values;  ///< choice keys; "true"/"false" for flags
};

struct Range {
    double low = -infinity_value;  ///< SI
    double high = infinity_value;
    bool low_open = false;  ///< value must be greater than, not equal to, low
    static constexpr double infinity_value = std::numeric_limits<double>::infinity();
};

/// A column of a table: number, integer, choice, text, flag or reference.
struct ColumnSpec {
    std::string key;
    std::string title;  ///< may be a symbol: "x", "u_x"
    FieldKind kind = FieldKind::number;
    Unit unit = {};  ///< default unit of the column; files may use any unit of the same dimension
    Range range = {};
    bool optional = false;  ///< cell may be empty
    std::vector<Choice> choices = {};
    std::string help = {};
    std::vector<std::string> capabilities = {};  ///< what a reference asks for, as in FieldSpec
    /// Whether its numbers are observations, of the quantity and series in columns of these names, if there
    /// are any: such numbers are written alike (`shared_decimals`).
    bool observed = false;
};

struct FieldSpec {
    std::string key;
    std::string title;
    FieldKind kind = FieldKind::number;
    std::string help;  ///< one or two sentences; never empty (contract test)
    Unit unit = {};    ///< default unit of a number
    Range range = {};
    SetupValue default_value = {};  ///< monostate = must be given, unless optional
    bool optional = false;
    std::vector<Choice> choices = {};
    std::vector<ColumnSpec> columns = {};  ///< columns of a table
    std::size_t min_rows = 0;
    std::vector<std::string> capabilities =
        {};  ///< an asset of a reference must offer one of these ("point-uncertainty")
    std::optional<Condition> shown_if = {};
    /// Condition under which the angles of a pose are omega, phi, kappa; else they are alpha, beta, gamma.
    std::optional<Condition> photogrammetric_if = {};
    std::string section = {};  ///< heading under which forms and reports show the field
    /// Whether the rows of a table state components of input quantities, in columns symbol, name, value,
    /// unit, statement, a, b and nu: a budget is typed into it.
    bool states_quantities = false;
    /// Whether the rows of a table are observations, in columns quantity, number, series and value.
    bool observes_quantities = false;
    /// Whether the rows of a table are what was read, observed or calibrated, which nobody can choose.
    bool measured = false;
    bool several_lines = false;  ///< a text is a list of lines in files; problems name the line ("/text/2")
    /// Ending of the names of files beside the project that a text names ("stl"); empty: it names none.
    std::string file_ending = {};
};

class SetupSchema {
public:
    SetupSchema() = default;
    explicit SetupSchema(std::vector<FieldSpec> fields) : fields_(std::move(fields)) {}
    const std::vector<FieldSpec>& fields() const { return fields_; }
    const FieldSpec* find(const std::string& key) const;
    /// The first that says so: find(&FieldSpec::states_quantities). Null: there is none.
    const FieldSpec* find(bool FieldSpec::*says) const;
    /// Index of a table's column, or npos.
    static std::size_t column(const FieldSpec& table, const std::string& key);
    static constexpr std::size_t npos = static_cast<std::size_t>(-1);
    std::vector<std::string> keys() const;  ///< keys of all fields, in order

private:
    std::vector<FieldSpec> fields_;
};

/// Value of the field: as given, else the default, else monostate.
const SetupValue& value_of(const FieldSpec& field, const Setup& setup);
/// Whether the set-up fulfils the condition; a field that is not shown fulfils none.
bool holds(const Condition& condition, const SetupSchema& schema, const Setup& setup);
/// Whether the field's condition holds (fields that are not shown are neither required nor used).
bool is_shown(const SetupSchema& schema, const FieldSpec& field, const Setup& setup);
/// Kinds, units' dimensions, ranges, choices, required fields, unknown keys, NaN. Paths are relative to the
/// set-up ("/alpha").
/// Every problem is reported; a cell is named by row and column ("/base_points/rows/2/x").
void check_setup(const SetupSchema& schema, const Setup& setup, Problems& problems);

/// A number as given for `title`, which is to be in a unit like `expected`. Empty if it may be used;
/// otherwise why not: another dimension, not finite, or a temperature difference given on the scale of degC.
Message unit_objection(const Message& title, const Quantity& given, const Unit& expected);
/// Objection to a unit of a table's column; empty: there is none.
Message column_unit_objection(const FieldSpec& table, const ColumnSpec& column, const Unit& unit);

}  // namespace covaria
