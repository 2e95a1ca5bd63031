#include "core/kinds/ballbar/evidence.h"

#include <algorithm>
#include <cmath>

#include "core/evidence/seen.h"
#include "core/text/numbers.h"

namespace covaria::tcp {

namespace {

/// Derivatives of the places of the supports by the lengths between them, then by their heights: central
/// differences of a smooth function, exact to 1e-9 of themselves.
std::vector<std::vector<Eigen::Vector3d>> support_derivatives(const BallbarSource& ballbars) {
    std::vector<double> x;
    const std::size_t lengths = ballbars.support_lengths().size(), n = ballbars.supports();
    for (const SupportLength& length : ballbars.support_lengths()) x.push_back(length.length);
    for (const SupportHeight& height : ballbars.heights()) x.push_back(height.z);
    const auto places = [&](const std::vector<double>& at) {
        std::vector<Eigen::Vector3d> found(n);
        support_positions<double>({at.data(), lengths}, {at.data() + lengths, at.size() - lengths},
                                  found.data());
        return found;
    };
    const double h = 1e-5 * x.front();
    std::vector<std::vector<Eigen::Vector3d>> by(x.size());
    for (std::size_t q = 0; q < x.size(); ++q) {
        std::vector<double> more = x, less = x;
        more[q] += h;
        less[q] -= h;
        const auto above = places(more), below = places(less);
        for (std::size_t j = 0; j < n; ++j) by[q].push_back((above[j] - below[j]) / (2.0 * h));
    }
    return by;
}

class LengthsAsReadings {
public:
    LengthsAsReadings(const TcpSetup& setup, const TcpInputs& inputs)
        : setup_(setup), inputs_(inputs), by_(support_derivatives(*setup.ballbars)), fits_(inputs.set) {
        fits_.over({tell<"length">(), Unit::of("m"), {}});
        fits_.over({tell<"height of the point">(), Unit::of("m"), {}});
    }

    ComponentEvidence evidence() {
        name_figures();
        for (std::size_t i = 0; i < setup_.points.size(); ++i) {
            std::vector<FitsWithSharedComponents::Row> rows;
            for (std::size_t bar = 0; bar < setup_.supports.size(); ++bar) rows.push_back(row(i, bar));
            fits_.add(rows);
        }
        return fits_.evidence(figures_);
    }

private:
    FitsWithSharedComponents::Row row(std::size_t i, std::size_t bar) const {
        const Point& point = setup_.points[i];
        const Eigen::Vector3d along = (point.p_B - setup_.supports[bar]).normalized();
        const double u = setup_.ballbars->reading(bar, point.length[bar]).distribution.standard_uncertainty();
        FitsWithSharedComponents::Row row{tell<"bar %1, point %2">(bar + 1, point.name),
                                          along / u,
                                          point.misfit[bar] / u,
                                          {{inputs_.of_points[i].reading + bar, 1.0 / u}},
                                          {point.length[bar], point.p_B.z()}};
        for (std::size_t q = 0; q < by_.size(); ++q)
            if (const double effect = along.dot(by_[q][bar]); effect != 0.0)
                row.parts.push_back({q, effect / u});
        return row;
    }

    void name_figures() {
        const Unit um = Unit::of("um");
        const std::string source = tcp_fields().place(&StatedTcp::ballbars);
        const auto own_of = [&](std::size_t quantity) {
            return inputs_.set.quantities[quantity].shares.front().component;
        };
        for (const PointInputs& places : inputs_.of_points)
            for (std::size_t bar = 0; bar < setup_.supports.size(); ++bar)
                figures_[own_of(places.reading + bar)] = {"1", tell<"readings of the bars">(), um, source};
        const std::size_t lengths = setup_.ballbars->support_lengths().size();
        for (std::size_t q = 0; q < by_.size(); ++q)
            figures_[own_of(q)] = q < lengths
                                      ? FigureOfComponent{"3", tell<"lengths between supports">(), um, source}
                                      : FigureOfComponent{"4", tell<"heights of supports">(), um, source};
        for (const SharedLengthDeviation& deviation : setup_.ballbars->shared()) {
            const std::string id = setup_.ballbars.id + "." + deviation.component.id;
            const auto& all = inputs_.set.components;
            const auto at = std::ranges::find(all, id, &UncertaintyComponent::id) - all.begin();
            if (!deviation.is_scale)
                figures_[static_cast<std::size_t>(at)] = {"2", tell<"constants of the bars">(), um, source};
        }
    }

    const TcpSetup& setup_;
    const TcpInputs& inputs_;
    const std::vector<std::vector<Eigen::Vector3d>> by_;
    FitsWithSharedComponents fits_;
    std::map<std::size_t, FigureOfComponent> figures_;
};

bool states_every_reading(const TcpSetup& setup) {
    return std::ranges::all_of(setup.points, [&](const Point& point) {
        for (std::size_t bar = 0; bar < setup.supports.size(); ++bar)
            if (!(setup.ballbars->reading(bar, point.length[bar]).distribution.standard_uncertainty() > 0.0))
                return false;
        return true;
    });
}

}  // namespace

ComponentEvidence evidence_of(const TcpSetup& setup, const TcpInputs& inputs) {
    if (!setup.has_lengths() || setup.supports.size() < 4 || !states_every_reading(setup)) return {};
    return LengthsAsReadings(setup, inputs).evidence();
}

Table residuals_of_lengths(const TcpSetup& setup) {
    const Unit um = Unit::of("um");
    Table table{"residuals", "Residuals of the lengths"};
    table.add("point");
    table.add("bar");
    table.add("length").in(Unit::of("mm")).figure(7);
    table.add("residual").in(um).figure(3);
    table.add("u of the reading").in(um).figure(2);
    for (const Point& point : setup.points)
        for (std::size_t bar = 0; bar < setup.supports.size(); ++bar)
            table.row({point.name, std::to_string(bar + 1), point.length[bar] + point.misfit[bar],
                       point.misfit[bar],
                       setup.ballbars->reading(bar, point.length[bar]).distribution.standard_uncertainty()});
    return table;
}

void warn_of_lengths(const ComponentEvidence& evidence, Problems& problems) {
    if (!evidence.readings) return;
    const evidence::Seen test = evidence::global_test(*evidence.readings, 0.001);
    if (test.degrees_of_freedom <= 0 || test.s0 <= test.s0_high) return;
    problems.add(
        {.severity = Severity::warning,
         .path = tcp_fields().place(&StatedTcp::lengths),
         .message =
             tell<"the lengths contradict each other by %1 times what their uncertainties allow (at most %2 "
                  "by chance): look for a mistyped or exchanged length, or for figures of the ballbars that "
                  "are too small">(Message::number(format_significant(test.s0, 3)),
                                   Message::number(format_significant(test.s0_high, 3))),
         .remedies = {remedy_as_seen(tcp_fields().place(&StatedTcp::uncertainties))}});
}

}  // namespace covaria::tcp
