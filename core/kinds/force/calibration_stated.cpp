// Values that a certificate or a paper prints beside those computed: which reproduce and which differ.
#include <algorithm>
#include <cmath>

#include "core/kinds/force/calibration.h"
#include "core/setup/message_text.h"

namespace covaria::force {

namespace {

/// Decimals needed to write a number that was typed with few of them.
int decimals_of(double value) {
    int decimals = 0;
    for (double scale = 1.0; decimals < 9; ++decimals, scale *= 10.0)
        if (std::abs(std::round(value * scale) / scale - value) < 1e-11 * std::max(1.0, std::abs(value)))
            break;
    return decimals;
}

/// Half of the last printed digit of a column, SI.
double half_digit(const Stated& stated, std::size_t column) {
    int decimals = 0;
    for (const StatedRow& row : stated.rows)
        if (!std::isnan(row.values[column]))
            decimals = std::max(decimals, decimals_of(stated.units[column].from_si(row.values[column])));
    return stated.units[column].interval_to_si(0.5 * std::pow(10.0, -decimals));
}

struct Compared {
    std::string sensor;
    double stated = 0.0, computed = 0.0;
    double half = 0.0;      ///< of the last digit printed
    double rounding = 0.0;  ///< by which rounded inputs may move the computed value
    bool reproduces() const { return std::abs(stated - computed) <= half * (1.0 + 1e-6); }
    bool inside_rounding() const { return std::abs(stated - computed) <= (half + rounding) * (1.0 + 1e-6); }
};

class StatedTable {
public:
    explicit StatedTable(const Calibration& calibration) : calibration_(calibration) {
        table_.id = "stated";
        table_.title = "Stated values beside the computed ones";
        table_.columns = {{.header = "quantity", .is_symbol = false},
                          {.header = "sensor"},
                          {.header = "stated"},
                          {.header = "computed", .digits = 4},
                          {.header = "status"}};
    }

    DataTable build() {
        const Stated& stated = calibration_.stated;
        for (std::size_t c = 0; c < stated.headers.size(); ++c) add_quantity(c);
        add_interference();
        table_.notes.push_back(
            "Reproduces: equal in all printed digits. Inside rounding: what it is computed from was rounded, "
            "too. Interference, percent: the row's sensor, then the column's axis.");
        return std::move(table_);
    }

private:
    double computed(const std::string& key, std::size_t h) const {
        const ForceChannel& channel = calibration_.channels[h];
        const double relative = calibration_.U(h) / std::abs(channel.rated_output);
        if (key == "rated_output") return channel.rated_output;
        if (key == "zero_error") return channel.zero;
        if (key == "u_A") return channel.u_a;
        if (key == "u_B") return calibration_.u_b_computed(h);
        if (key == "hysteresis") return channel.hysteresis;
        if (key == "interference") return calibration_.largest_interference(h);
        if (key == "u_c") return calibration_.u_c(h);
        if (key == "U") return calibration_.U(h);
        return key == "U_relative" ? relative : relative * channel.rated_load;
    }

    /// Of values computed from a summary, whose last digit is rounded: u_c depends on two such values, U on
    /// those and two more, with k.
    double rounding(const std::string& key, std::size_t h) const {
        if (calibration_.from_readings) return 0.0;
        const double digit = half_of("u_A");
        const ForceChannel& channel = calibration_.channels[h];
        const double of_U = (2.0 + calibration_.k) * digit;
        if (key == "u_c" || key == "u_B") return digit;
        if (key == "U") return of_U;
        if (key == "U_relative") return of_U / std::abs(channel.rated_output);
        if (key == "U_load") return of_U / std::abs(channel.rated_output) * channel.rated_load;
        return 0.0;
    }

    double half_of(const std::string& key) const {
        const auto& headers = calibration_.stated.headers;
        const auto found = std::find(headers.begin(), headers.end(), key);
        const auto column = static_cast<std::size_t>(found - headers.begin());
        return column < headers.size() ? half_digit(calibration_.stated, column) : 0.0;
    }

    void add_quantity(std::size_t c) {
        const Stated& stated = calibration_.stated;
        std::vector<Compared> rows;
        for (const StatedRow& row : stated.rows)
            if (!std::isnan(row.values[c]))
                rows.push_back({calibration_.channels[row.channel].kind().key, row.values[c],
                                computed(stated.headers[c], row.channel), half_digit(stated, c),
                                rounding(stated.headers[c], row.channel)});
        add(stated.titles[c], stated.units[c], rows);
    }

    void add_interference() {
        const Stated& stated = calibration_.stated_interference;
        std::vector<Compared> cells, largest;
        for (const StatedRow& row : stated.rows) {
            const ForceChannel& channel = calibration_.channels[row.channel];
            const double output = std::abs(channel.rated_output);
            const double rounding = half_of("interference") / output;
            for (std::size_t c = 0; c < calibration_.size(); ++c) {
                const std::size_t column = calibration_.channels[c].axis;
                if (c == row.channel || std::isnan(row.values[column])) continue;
                const double e =
                    std::abs(calibration_.rated_outputs(Eigen::Index(row.channel), Eigen::Index(c))) / output;
                cells.push_back({std::string(channel.kind().key) + ", " + calibration_.channels[c].kind().key,
                                 row.values[column], e, half_digit(stated, column), rounding});
            }
            if (const double value = row.values[most_channels]; !std::isnan(value))
                largest.push_back({channel.kind().key, value,
                                   calibration_.largest_interference(row.channel) / output,
                                   half_digit(stated, most_channels), rounding});
        }
        add("interference, percent", Unit::of("%"), cells);
        add("largest interference, percent", Unit::of("%"), largest);
    }

    /// One line for all that reproduce, one for each other value.
    void add(const std::string& quantity, const Unit& unit, const std::vector<Compared>& rows) {
        if (rows.empty()) return;
        const auto equal =
            std::count_if(rows.begin(), rows.end(), [](const Compared& r) { return r.reproduces(); });
        table_.rows.push_back({quantity, std::to_string(equal) + " of " + std::to_string(rows.size()),
                               std::monostate{}, std::monostate{}, std::string("reproduces")});
        for (const Compared& r : rows) {
            if (r.reproduces()) continue;
            table_.rows.push_back({std::string(), r.sensor, Quantity{unit.from_si(r.stated), unit},
                                   Quantity{unit.from_si(r.computed), unit},
                                   std::string(r.inside_rounding() ? "inside rounding" : "differs")});
        }
    }

    const Calibration& calibration_;
    DataTable table_;
};

}  // namespace

DataTable stated_table(const Calibration& calibration) {
    return StatedTable(calibration).build();
}

}  // namespace covaria::force
