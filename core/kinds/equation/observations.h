// Observations of quantities as the table lists them, and their Type A evaluation.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/kinds/equation/setup.h"
#include "core/quantity/type_a.h"

namespace covaria::equation_model {

class Observations {
public:
    explicit Observations(const std::vector<Observation>& rows);

    bool has(const std::string& quantity) const { return of_.contains(quantity); }
    std::vector<std::string> quantities() const;
    /// All series of the quantity, in its unit; empty without any.
    ObservedQuantity listed(const InputQuantity& quantity) const;

    struct Mean {
        double mean = 0.0;  ///< mean as typed
        double u = 0.0;     ///< standard uncertainty of the mean
        double degrees_of_freedom = 0.0;
        std::size_t count = 0;
    };
    /// Mean of the series without a name, or of the only series (JCGM 100 4.2).
    Result<Mean> mean_of(const std::string& quantity) const;
    /// u = s_p/sqrt(n) from all series together; the mean is that of the series without a name, if there is
    /// one (JCGM 100 4.2.4). `n` is the number of observations in the mean; empty: as many as that series
    /// has.
    Result<Mean> pooled(const std::string& quantity, std::optional<double> n) const;
    /// Correlation coefficient of the means of two quantities observed together; empty if they were not
    /// (JCGM 100 5.2.3).
    std::optional<double> correlation(const std::string& first, const std::string& second) const;

private:
    struct Series {
        std::vector<double> values;
        std::vector<int> numbers;  ///< numbers of simultaneous observations; empty if one has none
    };
    using SeriesByName = std::map<std::string, Series>;
    const Series* present_series(const std::string& quantity) const;
    std::map<std::string, SeriesByName> of_;
};

}  // namespace covaria::equation_model
