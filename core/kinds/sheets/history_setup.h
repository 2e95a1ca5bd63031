// The set-up of "history of an instrument": what its calibrations found, and the rule of the next one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/dates.h"
#include "core/setup/fields.h"

namespace covaria::sheets {

/// A calibration, in the unit of the values.
struct HistoryRow {
    std::string date;
    double found = 0.0;
    std::optional<double> left = {};  ///< empty: it was not adjusted
    std::optional<double> u = {};     ///< u of this value alone
};

/// The figure that the limit is for.
enum class DueRule { none, drift, deviation };

/// The set-up as it is typed; numbers in `unit`.
struct StatedHistory {
    std::string symbol, name;
    Unit unit;
    std::vector<HistoryRow> rows;
    bool from_residuals = true;
    double common_u = 0.0;  ///< u of a deviation that all values share
    std::string used_on;    ///< date of use; empty: none is asked for
    DueRule rule = DueRule::none;
    double limit = 0.0, nominal = 0.0;
    double factor = 2.0;          ///< k of the rule
    double longest_years = 10.0;  ///< interval that is never exceeded
};

/// A value as it would be without the adjustments before it.
struct HistoryValue {
    Days day;
    double value = 0.0;  ///< SI, less `HistorySetup::reference`
    double u = 0.0;      ///< SI
};

struct HistorySetup : StatedHistory {
    std::vector<HistoryValue> values;
    double reference = 0.0;  ///< the first value found, SI
    double adjusted = 0.0;   ///< sum of all adjustments, SI: what an undisturbed value has become by them
    std::optional<Days> use = {};
    double degrees_of_freedom() const { return double(values.size()) - 2.0; }
};

const Fields<StatedHistory>& history_fields();
std::optional<HistorySetup> read_history_setup(const SetupReader& reader, const AssetLibrary& assets,
                                               Problems& problems);

/// Years of 365.25 days between two days.
double years_between(Days from, Days to);

}  // namespace covaria::sheets
