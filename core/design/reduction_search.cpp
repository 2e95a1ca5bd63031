#include "core/design/reduction_search.h"

#include <algorithm>
#include <cmath>

#include "core/random/uniforms.h"

namespace covaria::detail {

namespace {

constexpr int most_rounds = 50;           ///< rounds of coverage factors
constexpr double same_factor = 1e-10;     ///< relative
constexpr double same_variance = 1e-8;    ///< relative: what rounding may make of a sum
constexpr std::size_t trial_factors = 3;  ///< factors at which the sum is checked
constexpr std::size_t front_points = 15;

class ReductionSearch {
public:
    explicit ReductionSearch(SearchBook& book)
        : book_(book),
          reductions_(book.design().design.reductions),
          targets_(book.judges().lend()->references()) {}

    Result<FoundReductions> find() {
        if (auto known = find_variances(); !known) return fail(known.error());
        FoundReductions found;
        CheapestReductions best;
        if (auto solved = solve(1.0, best); !solved) return fail(solved.error());
        found.factors = best.factors;
        found.cost = best.cost;
        for (std::size_t k = 0; k < targets_.size(); ++k)
            found.prices.push_back(2.0 * best.multipliers(static_cast<Eigen::Index>(k)) / targets_[k]);
        if (auto drawn = draw_front(found.front); !drawn) return fail(drawn.error());
        return found;
    }

private:
    Result<Judged> judged(const std::vector<double>& factors, const std::string& search) {
        Judged judged = book_.judge_all({Candidate{factors, {}}}, search).front();
        if (!judged.feasible()) return fail(ErrorCode::bad_input, judged.reason);
        return judged;
    }

    /// Variances as a sum: from what halving each one alone changes.
    Result<void> find_variances() {
        const std::size_t n = reductions_.size();
        std::vector<Candidate> candidates(n + 1, Candidate{std::vector<double>(n, 1.0), {}});
        for (std::size_t j = 0; j < n; ++j) candidates[j].values[j] = 0.5;
        const std::vector<Judged> judged = book_.judge_all(candidates, "each by itself");
        for (const Judged& one : judged)
            if (!one.feasible()) return fail(ErrorCode::bad_input, one.reason);
        const auto k = static_cast<Eigen::Index>(targets_.size());
        part_.resize(k, static_cast<Eigen::Index>(n));
        const Eigen::VectorXd whole = variances(judged.back());
        for (std::size_t j = 0; j < n; ++j)
            part_.col(static_cast<Eigen::Index>(j)) = ((whole - variances(judged[j])) / 0.75).cwiseMax(0.0);
        rest_ = (whole - part_.rowwise().sum()).cwiseMax(0.0);
        return check_sum(whole);
    }

    static Eigen::VectorXd variances(const Judged& judged) {
        return Eigen::Map<const Eigen::VectorXd>(judged.standard.data(),
                                                 static_cast<Eigen::Index>(judged.standard.size()))
            .cwiseAbs2();
    }

    Eigen::VectorXd predicted(const std::vector<double>& factors) const {
        return rest_ + part_ * Eigen::Map<const Eigen::VectorXd>(factors.data(), part_.cols()).cwiseAbs2();
    }

    Result<void> check_sum(const Eigen::VectorXd& whole) {
        for (std::size_t trial = 0; trial < trial_factors; ++trial) {
            std::vector<double> factors(reductions_.size());
            uniforms(book_.design().design.seed, DrawPurpose::design_starts,
                     static_cast<std::uint32_t>(trial), 0, factors);
            for (std::size_t j = 0; j < factors.size(); ++j)
                factors[j] = reductions_[j].number.from + factors[j] * (1.0 - reductions_[j].number.from);
            const auto found = judged(factors, "check");
            if (!found) return fail(found.error());
            const Eigen::VectorXd difference = (variances(*found) - predicted(factors)).cwiseAbs();
            if ((difference.array() > same_variance * whole.array()).any())
                return fail(ErrorCode::bad_input,
                            tell<"the variances are not a sum over what is reduced: some of it is "
                                 "correlated, or changes more than a component of uncertainty">());
        }
        return {};
    }

    /// Finds the reductions for targets `ratio` times as large.
    Result<void> solve(double ratio, CheapestReductions& best) {
        std::vector<double> factors(reductions_.size(), 1.0);
        std::vector<double> coverage;
        for (int round = 0; round < most_rounds; ++round) {
            const auto now = judged(factors, "cheapest reductions");
            if (!now) return fail(now.error());
            std::vector<double> next;
            double change = coverage.empty() ? 1.0 : 0.0;
            for (std::size_t k = 0; k < targets_.size(); ++k) {
                next.push_back(now->standard[k] > 0.0 ? now->expanded[k] / now->standard[k] : 1.0);
                if (!coverage.empty()) change = std::max(change, std::abs(next[k] / coverage[k] - 1.0));
            }
            if (change < same_factor) return {};
            coverage = next;
            best = cheapest_reductions(task_for(ratio, coverage));
            factors = best.factors;
        }
        return {};
    }

    ReductionTask task_for(double ratio, const std::vector<double>& coverage) const {
        ReductionTask task{reductions_, part_, rest_};
        for (std::size_t k = 0; k < targets_.size(); ++k) {
            const auto row = static_cast<Eigen::Index>(k);
            const double limit = std::pow(ratio * targets_[k] / coverage[k], 2);
            task.part.row(row) /= limit;
            task.rest(row) /= limit;
        }
        return task;
    }

    /// Draws the costs from nearly the smallest ratio that can be reached to the one that costs nothing.
    Result<void> draw_front(std::vector<DesignCost>& front) {
        std::vector<double> least;
        for (const DesignReduction& reduction : reductions_) least.push_back(reduction.number.from);
        const auto at_least = judged(least, "front");
        const auto present = judged(std::vector<double>(least.size(), 1.0), "front");
        if (!at_least || !present) return fail(at_least ? present.error() : at_least.error());
        const double low = at_least->objective, high = present->objective;
        if (!(high > low)) return {};
        for (std::size_t i = 1; i < front_points; ++i) {
            const double ratio =
                low * std::pow(high / low, static_cast<double>(i) / static_cast<double>(front_points));
            CheapestReductions best;
            if (auto solved = solve(ratio, best); !solved) return solved;
            if (best.possible) front.push_back({ratio, best.cost});
        }
        front.push_back({high, 0.0});
        return {};
    }

    SearchBook& book_;
    const std::vector<DesignReduction>& reductions_;
    const References targets_;
    Eigen::MatrixXd part_;
    Eigen::VectorXd rest_;
};

}  // namespace

Result<FoundReductions> find_reductions(SearchBook& book) {
    return ReductionSearch(book).find();
}

}  // namespace covaria::detail
