// Points of "TCP from ballbars" from measured lengths.
#include <algorithm>
#include <cmath>
#include <map>

#include "core/kinds/ballbar/equations.h"

namespace covaria::tcp {

namespace {

constexpr int reweighings = 3;  ///< weights depend on the place as u on the length: by 1e-6 of a change of it

class PointsOfLengths {
public:
    PointsOfLengths(TcpSetup& setup, Problems& problems) : setup_(setup), problems_(problems) {}

    void take() {
        for (std::size_t row = 0; row < setup_.lengths.size(); ++row) sort_in(row);
        for (std::size_t k = 0; k < setup_.points.size() && !problems_.has_errors(); ++k) place(k);
    }

private:
    std::string row_place(std::size_t row) const { return tcp_fields().place(&StatedTcp::lengths, row); }

    void sort_in(std::size_t row) {
        const StatedTcp::Length& given = setup_.lengths[row];
        const auto [known, added] = numbers_.try_emplace(given.point, setup_.points.size());
        if (added) {
            Point point;
            point.name = given.point;
            point.label = "p" + std::to_string(setup_.points.size() + 1);
            point.source = row_place(row);
            setup_.points.push_back(std::move(point));
            lengths_.emplace_back();
        }
        const auto bar = static_cast<std::size_t>(given.bar);
        if (bar > setup_.supports.size())
            return problems_.error(row_place(row), tell<"there is no bar %1: the ballbars have %2 supports">(
                                                       bar, setup_.supports.size()));
        double& length = lengths_[known->second][bar - 1];
        if (length > 0.0)
            problems_.error(row_place(row), tell<"point %1 has two lengths of bar %2">(given.point, bar));
        length = given.length;
    }

    void place(std::size_t k) {
        Point& point = setup_.points[k];
        const std::array<double, most_supports>& lengths = lengths_[k];
        for (std::size_t bar = 0; bar < setup_.supports.size(); ++bar)
            if (!(lengths[bar] > 0.0))
                return problems_.error(point.source,
                                       tell<"point %1 has no length of bar %2">(point.name, bar + 1));
        const auto& s = setup_.supports;
        const Trilateration<double> by_three(SupportTriangle<double>{s[1].x(), s[2].x(), s[2].y()});
        if (!by_three.locate(lengths.data(), setup_.ballbars->side(), point.p_B))
            return problems_.error(point.source,
                                   tell<"the lengths of the first three bars do not meet at point %1: look "
                                        "for a mistyped or exchanged length">(point.name));
        if (s.size() > 3) adjust(point, lengths);
        weigh(setup_, point);
        for (std::size_t bar = 0; bar < s.size(); ++bar) point.misfit[bar] = lengths[bar] - point.length[bar];
    }

    void adjust(Point& point, const std::array<double, most_supports>& lengths) const {
        for (int k = 0; k < reweighings; ++k) {
            weigh(setup_, point);
            for (int step = 0; step < multilateration_steps; ++step)
                multilateration_step<double>(setup_.supports, lengths.data(), point.weights.data(), 3,
                                             point.p_B);
        }
    }

    TcpSetup& setup_;
    Problems& problems_;
    std::map<std::string, std::size_t> numbers_;
    std::vector<std::array<double, most_supports>> lengths_;  ///< of each point; 0: not given
};

}  // namespace

void take_lengths(TcpSetup& setup, Problems& problems) {
    PointsOfLengths(setup, problems).take();
}

}  // namespace covaria::tcp
