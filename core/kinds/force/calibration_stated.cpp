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
template <class Row>
double half_digit(const std::vector<Row>& rows, std::size_t column, const Unit& unit) {
    int decimals = 0;
    for (const Row& row : rows)
        if (row.figures[column])
            decimals = std::max(decimals, decimals_of(unit.from_si(*row.figures[column])));
    return unit.interval_to_si(0.5 * std::pow(10.0, -decimals));
}

struct Compared {
    std::string sensor;
    double stated = 0.0, computed = 0.0;
    double half = 0.0;      ///< half of the last digit printed
    double rounding = 0.0;  ///< most that rounded inputs may move the computed value
    bool reproduces() const { return std::abs(stated - computed) <= half * (1.0 + 1e-6); }
    bool inside_rounding() const { return std::abs(stated - computed) <= (half + rounding) * (1.0 + 1e-6); }
};

class StatedTable {
public:
    explicit StatedTable(const Calibration& calibration) : calibration_(calibration) {
        table_.id = "stated";
        table_.title = "Stated values beside the computed ones";
        table_.add("quantity");
        table_.add("sensor");
        table_.add("stated");
        table_.add("computed").figure(4);
        table_.add("status");
    }

    Table build() {
        const auto columns = sensor_fields().columns(&StatedSensor::stated).specs();
        for (std::size_t c = 1; c < columns.size(); ++c)
            add_quantity(static_cast<Figure>(c - 1), columns[c].title, columns[c].unit);
        add_interference();
        table_.notes.push_back(
            tell<"Reproduces: equal in all printed digits. Inside rounding: what it is computed from was "
                 "rounded, too. Interference, percent: the row's sensor, then the column's axis.">());
        return std::move(table_);
    }

private:
    /// Computed values of a channel, in the order of Figure.
    std::array<double, static_cast<std::size_t>(Figure::count)> computed(std::size_t h) const {
        const ForceChannel& channel = calibration_.channels[h];
        const double U = calibration_.U(h), U_relative = U / std::abs(channel.rated_output);
        return {channel.rated_output, channel.zero,
                channel.u_a,          calibration_.u_b_computed(h),
                channel.hysteresis,   calibration_.largest_interference(h),
                calibration_.u_c(h),  U,
                U_relative,           U_relative * channel.rated_load};
    }

    /// Largest rounding of a value computed from a summary, whose last digit is rounded: u_c depends on two
    /// such values, U on those and two more, with k.
    double rounding(Figure figure, std::size_t h) const {
        if (calibration_.from_readings) return 0.0;
        const double digit = half_of(Figure::u_A);
        const ForceChannel& channel = calibration_.channels[h];
        const double of_U = (2.0 + calibration_.k) * digit;
        if (figure == Figure::u_c || figure == Figure::u_B) return digit;
        if (figure == Figure::U) return of_U;
        if (figure == Figure::U_relative) return of_U / std::abs(channel.rated_output);
        if (figure == Figure::U_load) return of_U / std::abs(channel.rated_output) * channel.rated_load;
        return 0.0;
    }

    double half_of(Figure figure) const {
        const auto c = static_cast<std::size_t>(figure);
        return half_digit(calibration_.stated, c,
                          sensor_fields().columns(&StatedSensor::stated).specs()[c + 1].unit);
    }

    void add_quantity(Figure figure, const std::string& title, const Unit& unit) {
        std::vector<Compared> rows;
        for (const StatedFigures& row : calibration_.stated) {
            const auto h = calibration_.channel_of(row.axis);
            const auto c = static_cast<std::size_t>(figure);
            if (h && row.figures[c])
                rows.push_back({force_axes[row.axis].key, *row.figures[c], computed(*h)[c], half_of(figure),
                                rounding(figure, *h)});
        }
        add(title, unit, rows);
    }

    void add_interference() {
        const Unit percent = Unit::of("%");
        const auto half = [&](std::size_t column) {
            return half_digit(calibration_.stated_interference, column, percent);
        };
        std::vector<Compared> cells, largest;
        for (const StatedInterference& row : calibration_.stated_interference) {
            const auto h = calibration_.channel_of(row.axis);
            if (!h) continue;
            const std::string name = force_axes[row.axis].key;
            const double output = std::abs(calibration_.channels[*h].rated_output);
            const double rounding = half_of(Figure::interference) / output;
            for (std::size_t c = 0; c < calibration_.size(); ++c) {
                const std::size_t column = calibration_.channels[c].axis;
                if (c == *h || !row.figures[column]) continue;
                const double e =
                    std::abs(calibration_.rated_outputs(Eigen::Index(*h), Eigen::Index(c))) / output;
                cells.push_back(
                    {name + ", " + force_axes[column].key, *row.figures[column], e, half(column), rounding});
            }
            if (const auto& value = row.figures[most_channels])
                largest.push_back({name, *value, calibration_.largest_interference(*h) / output,
                                   half(most_channels), rounding});
        }
        add("interference, percent", percent, cells);
        add("largest interference, percent", percent, largest);
    }

    /// Adds one line for all that reproduce, and one for each other value.
    void add(const std::string& quantity, const Unit& unit, const std::vector<Compared>& rows) {
        if (rows.empty()) return;
        const auto equal =
            std::count_if(rows.begin(), rows.end(), [](const Compared& r) { return r.reproduces(); });
        table_.row({quantity, tell<"%1 out of %2">(equal, rows.size()), std::monostate{}, std::monostate{},
                    tell<"reproduces">()});
        for (const Compared& r : rows) {
            if (r.reproduces()) continue;
            table_.row({std::string(), r.sensor, Quantity{unit.from_si(r.stated), unit},
                        Quantity{unit.from_si(r.computed), unit},
                        r.inside_rounding() ? tell<"inside rounding">() : tell<"differs">()});
        }
    }

    const Calibration& calibration_;
    Table table_;
};

}  // namespace

Table stated_table(const Calibration& calibration) {
    return StatedTable(calibration).build();
}

}  // namespace covaria::force
