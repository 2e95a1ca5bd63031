#include "core/kinds/network/sensitivities.h"

#include "core/kinds/network/equations.h"
#include "core/model/equation_model.h"
#include "core/model/sensitivity_rows.h"

namespace covaria::network {

namespace {

struct InputRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Collects the gradient of outputs by the coordinates of at most three targets, eight at a time.
class Gradient {
public:
    static constexpr std::size_t most = 9;
    explicit Gradient(std::size_t first_output) : first_output_(first_output) {}
    void begin(std::size_t first) { first_ = first; }
    void set(std::size_t output, const Dual& value) {
        if (output - first_output_ >= by_.size()) by_.resize(output - first_output_ + 1);
        for (std::size_t k = 0; k < Dual::size && first_ + k < most; ++k)
            by_[output - first_output_][first_ + k] = value.partials()[k];
    }
    const std::vector<std::array<double, most>>& values() const { return by_; }

private:
    std::size_t first_output_, first_ = 0;
    std::vector<std::array<double, most>> by_;
};

class RowMaker {
public:
    RowMaker(const NetworkSetup& setup, std::span<const double> x, SensitivityRows& rows)
        : setup_(setup), x_(x), rows_(rows), sum_(x.size()) {}

    bool make() {
        rows_.assign(setup_.outputs(), {});
        for (const JointSetUp& joint : setup_.set_ups)
            if (!add_targets(joint)) return false;
        return add_derived();
    }

private:
    bool add_targets(const JointSetUp& joint) {
        if (joint.together()) return add_part(joint, joint.first, joint.targets);
        for (std::size_t t = 0; t < joint.targets; ++t)
            if (!add_part(joint, joint.first + t, 1)) return false;
        return true;
    }

    bool add_part(const JointSetUp& joint, std::size_t first, std::size_t count) {
        std::vector<InputRange> ranges{{setup_.station_input(joint.index, 0), 6 * setup_.sensors.size()}};
        for (std::size_t t = first; t < first + count; ++t)
            for (const Sight& sight : setup_.targets[t].sights)
                for (std::size_t i = 0; i < 3; ++i)
                    if (sight.has[i]) add(ranges, sight.input[i]);
        for (const std::size_t b : joint.bars) add(ranges, setup_.bars[b].input);
        for (const InputRange& range : ranges)
            for (std::size_t done = 0; done < range.count; done += Dual::size) {
                const std::size_t at = range.first + done;
                const Inputs<Dual> variables(x_.data(), at);
                DualRows out(rows_, at, std::min(Dual::size, range.count - done));
                locate_stations(setup_, variables, joint.index, places_.data());
                if (!some_targets(setup_, joint, first, count, places_.data(), variables, out)) return false;
                if (!out.finite()) return false;
            }
        return true;
    }

    static void add(std::vector<InputRange>& ranges, std::size_t input) {
        InputRange& last = ranges.back();
        if (input == last.first + last.count)
            ++last.count;
        else
            ranges.push_back({input, 1});
    }

    /// By the chain rule, from the coordinates.
    bool add_derived() {
        for (std::size_t t = 0; t < setup_.targets.size(); ++t)
            positions_.push_back(setup_.targets[t].nominal);
        std::vector<double> y(setup_.outputs());
        Outputs<double> values(y.data());
        if (!all_targets<double>(setup_, Inputs<double>(x_.data()), values) || !values.finite()) return false;
        for (std::size_t t = 0; t < positions_.size(); ++t)
            positions_[t] = Eigen::Vector3d(y[3 * t], y[3 * t + 1], y[3 * t + 2]);
        std::size_t out = 3 * setup_.targets.size();
        for (const Distance& d : setup_.distances) out = add(d, {d.from, d.to}, out);
        for (const Angle& a : setup_.angles) out = add(a, {a.from, a.at, a.to}, out);
        for (const TargetFrame& f : setup_.frames)
            out = add(f, {f.targets[0], f.targets[1], f.targets[2]}, out);
        for (const ScaleBar& b : setup_.bars) {
            out = add(b, {b.from, b.to}, out);
            rows_[out - 1].push_back({b.input, -1.0});
            sum_.add(rows_[out - 1], 1.0);
            rows_[out - 1] = sum_.take();
        }
        return true;
    }

    template <class Item>
    std::size_t add(const Item& item, const std::vector<std::size_t>& targets, std::size_t out) {
        Gradient gradient(out);
        for (std::size_t first = 0; first < 3 * targets.size(); first += Dual::size) {
            gradient.begin(first);
            const auto target = [&](std::size_t t) {
                const auto place =
                    static_cast<std::size_t>(std::find(targets.begin(), targets.end(), t) - targets.begin());
                Vector3<Dual> p;
                for (int c = 0; c < 3; ++c) {
                    const std::size_t k = 3 * place + static_cast<std::size_t>(c);
                    p[c] = k >= first && k < first + Dual::size ? Dual::variable(positions_[t][c], k - first)
                                                                : Dual(positions_[t][c]);
                }
                return p;
            };
            const Inputs<Dual> constants(x_.data(), x_.size());
            Derived<Dual, Inputs<Dual>, Gradient, decltype(target)>(setup_, constants, target, gradient)
                .put(item, out);
        }
        for (const auto& by : gradient.values()) {
            for (std::size_t k = 0; k < 3 * targets.size(); ++k)
                sum_.add(rows_[3 * targets[k / 3] + k % 3], by[k]);
            rows_[out++] = sum_.take();
        }
        return out;
    }

    const NetworkSetup& setup_;
    std::span<const double> x_;
    SensitivityRows& rows_;
    RowSum sum_;
    std::array<Place<Dual>, most_sensors> places_;
    std::vector<Eigen::Vector3d> positions_;
};

}  // namespace

bool network_sensitivities(const NetworkSetup& setup, std::span<const double> x, SensitivityRows& rows) {
    return RowMaker(setup, x, rows).make();
}

}  // namespace covaria::network
