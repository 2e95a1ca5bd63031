#include "core/propagation/condensed_law.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "core/propagation/contributions.h"
#include "core/propagation/term_maker.h"

namespace covaria::detail {
namespace {

constexpr std::size_t least_rows = 20;  // of an output

/// The same tags, the same group of quantities: one rest.
struct RestKey {
    std::string contributor, group;
    std::vector<std::pair<std::string, std::string>> tags;
    auto operator<=>(const RestKey&) const = default;
};

Message name_of_rest(const BudgetComponent& one) {
    if (!one.group.empty()) return tell<"further components of %1">(said_name(one.group));
    return one.owner.empty() ? tell<"further components">() : tell<"further components of %1">(one.owner);
}

/// The rest that each component belongs to. Rests are added to the components of a budget.
std::vector<std::size_t> add_rests(const InputSet& inputs, std::vector<BudgetComponent>& components) {
    std::vector<std::size_t> rest_of;
    std::map<RestKey, std::size_t> known;
    for (std::size_t c = 0; c < inputs.components.size(); ++c) {
        RestKey key{inputs.components[c].contributor, components[c].group, {}};
        for (const GroupTag& tag : components[c].tags) key.tags.emplace_back(tag.grouping, tag.group);
        const auto [place, is_new] = known.try_emplace(std::move(key), components.size());
        rest_of.push_back(place->second);
        if (!is_new) continue;
        BudgetComponent rest;
        rest.id = "rest-" + std::to_string(known.size());
        rest.name = name_of_rest(components[c]);
        rest.owner = components[c].owner;
        rest.group = components[c].group;
        rest.tags = components[c].tags;
        rest.is_rest = true;
        components.push_back(std::move(rest));
    }
    return rest_of;
}

/// What the outputs share while the law of propagation is applied to one after the other.
class Condenser {
public:
    Condenser(const SensitivitySource& source, const InputSet& inputs, const Correlations& correlations,
              std::size_t most_rows, LawOfPropagation& law)
        : source_(source),
          inputs_(inputs),
          correlations_(correlations),
          law_(law),
          sums_(inputs, law, correlations) {
        const std::size_t outputs = law.differentiable.size();
        kept_->budget.components = budget_components(inputs);
        rest_of_ = add_rests(inputs, kept_->budget.components);
        kept_->budget.rows.resize(outputs);
        most_of_output_ = std::max(least_rows, most_rows / std::max<std::size_t>(outputs, 1));
        law.degrees_of_freedom.setConstant(static_cast<Eigen::Index>(outputs), infinity);
        is_known_.assign(outputs, 1);
        for (const UncertaintyComponent& c : inputs.components)
            has_degrees_ = has_degrees_ || std::isfinite(degrees_of_freedom_of(c));
    }

    void run() {
        if (law_.covariance.is_whole())
            take_whole();
        else
            in_parallel(law_.covariance.blocks().list().size(), [this](Worker& worker, std::size_t k) {
                const OutputBlocks::Block& block = law_.covariance.blocks().list()[k];
                std::vector<std::vector<PropagationTerm>> terms(static_cast<std::size_t>(block.size));
                for (Eigen::Index i = 0; i < block.size; ++i)
                    make_terms(worker, block.first + i, terms[static_cast<std::size_t>(i)]);
                Eigen::MatrixXd& covariance = law_.covariance.block(k);
                for (Eigen::Index i = 0; i < block.size; ++i)
                    for (Eigen::Index j = 0; j <= i; ++j)
                        covariance(i, j) = covariance(j, i) = covariance_of_pair(
                            terms[static_cast<std::size_t>(i)], terms[static_cast<std::size_t>(j)]);
                for (Eigen::Index i = 0; i < block.size; ++i)
                    take(worker, block.first + i, terms[static_cast<std::size_t>(i)]);
            });
        if (sums_.are_several()) kept_->contributors = sums_.take_results();
        law_.degrees_of_freedom_approximate = is_approximate_;
        for (std::size_t j = 0; j < is_known_.size(); ++j) {
            law_.differentiable[j] = is_known_[j] != 0;
            if (!law_.differentiable[j])
                law_.covariance.set(static_cast<Eigen::Index>(j), std::numeric_limits<double>::quiet_NaN());
        }
        law_.condensed = kept_;
    }

private:
    /// Numbers of one thread.
    struct Worker {
        Worker(const Condenser& of)
            : maker(of.inputs_, of.correlations_, of.law_.u),
              rule(degrees_of_freedom_rule(of.inputs_, of.correlations_)),
              rests(of.kept_->budget.components.size() - of.inputs_.components.size()) {}
        TermMaker maker;
        WelchSatterthwaite rule;
        std::vector<Sensitivity> row = {};
        std::vector<WelchSatterthwaite::Part> parts = {};
        std::vector<std::size_t> order = {};
        struct Rest {
            double squares = 0.0, share = 0.0;
            bool is_any = false;
        };
        std::vector<Rest> rests;
    };

    template <class Task>
    void in_parallel(std::size_t count, const Task& task) {
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            Worker worker(*this);
            for (std::size_t i = next++; i < count; i = next++) task(worker, i);
        };
        std::vector<std::future<void>> others;
        for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k)
            others.push_back(std::async(std::launch::async, work));
        work();
        for (std::future<void>& other : others) other.get();
    }

    void make_terms(Worker& worker, Eigen::Index output, std::vector<PropagationTerm>& terms) {
        const auto j = static_cast<std::size_t>(output);
        is_known_[j] = source_.row(j, worker.row) ? 1 : 0;
        if (!is_known_[j]) worker.row.clear();
        worker.maker.make(worker.row, terms);
    }

    /// Covariances of every pair: the outputs beside each other as rows of a matrix, each once.
    void take_whole() {
        const auto outputs = static_cast<Eigen::Index>(is_known_.size()), width = law_.u.size();
        using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        Rows contribution = Rows::Zero(outputs, width);
        Rows correlated = correlations_.empty() ? Rows() : Rows(Rows::Zero(outputs, width));
        in_parallel(is_known_.size(), [&](Worker& worker, std::size_t j) {
            std::vector<PropagationTerm> terms;
            const auto row = static_cast<Eigen::Index>(j);
            make_terms(worker, row, terms);
            double variance = 0.0;
            for (const PropagationTerm& term : terms) {
                const auto c = static_cast<Eigen::Index>(term.component);
                contribution(row, c) = term.contribution;
                if (!correlations_.empty()) correlated(row, c) = term.correlated;
                variance += term.contribution * term.correlated;
            }
            law_.covariance.block(0)(row, row) = std::max(variance, 0.0);
            take(worker, row, terms);
        });
        Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(outputs, outputs);
        if (correlations_.empty()) {
            covariance.selfadjointView<Eigen::Lower>().rankUpdate(contribution);
            covariance.triangularView<Eigen::StrictlyUpper>() = covariance.transpose();
        } else {
            covariance.noalias() = correlated * contribution.transpose();
            covariance = (0.5 * (covariance + covariance.transpose())).eval();
        }
        covariance.diagonal() = covariance.diagonal().cwiseMax(0.0);
        law_.covariance.block(0) = std::move(covariance);
    }

    /// The figures of one output, whose variance is known.
    void take(Worker& worker, Eigen::Index output, const std::vector<PropagationTerm>& terms) {
        const auto j = static_cast<std::size_t>(output);
        const double variance = law_.covariance(output, output);
        if (has_degrees_) {
            worker.parts.clear();
            for (const PropagationTerm& term : terms)
                worker.parts.push_back({term.component, term.contribution * term.correlated});
            const auto effective = worker.rule.effective(worker.parts, variance);
            law_.degrees_of_freedom(output) = effective.degrees_of_freedom;
            if (effective.approximate) is_approximate_ = true;
        }
        kept_->budget.rows[j] = rows_of(worker, terms, variance);
        if (!sums_.are_several()) return;
        const std::lock_guard lock(of_sums_);
        sums_.take(j, terms, is_known_[j] != 0);
    }

    std::vector<BudgetRow> rows_of(Worker& worker, const std::vector<PropagationTerm>& terms,
                                   double variance) const {
        std::vector<std::size_t>& order = worker.order;
        order.clear();
        for (std::size_t i = 0; i < terms.size(); ++i)
            if (terms[i].sensitivity != 0.0) order.push_back(i);
        const auto weight = [&](std::size_t i) {
            return std::abs(terms[i].contribution * terms[i].correlated);
        };
        const std::size_t kept = std::min(most_of_output_, order.size());
        if (kept < order.size())
            std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept), order.end(),
                             [&](std::size_t a, std::size_t b) {
                                 return weight(a) != weight(b) ? weight(a) > weight(b) : a < b;
                             });
        const auto share_of = [&](const PropagationTerm& term) {
            return variance > 0.0 ? term.contribution * term.correlated / variance : 0.0;
        };
        std::vector<BudgetRow> rows;
        std::sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept));
        for (std::size_t k = 0; k < kept; ++k) {
            const PropagationTerm& term = terms[order[k]];
            rows.push_back({term.component, term.sensitivity, std::abs(term.contribution), share_of(term)});
        }
        const std::size_t components = inputs_.components.size();
        for (std::size_t k = kept; k < order.size(); ++k) {
            const PropagationTerm& term = terms[order[k]];
            auto& rest = worker.rests[rest_of_[term.component] - components];
            rest.squares += term.contribution * term.contribution;
            rest.share += share_of(term);
            rest.is_any = true;
        }
        for (std::size_t r = 0; r < worker.rests.size(); ++r) {
            auto& rest = worker.rests[r];
            if (rest.is_any) rows.push_back({components + r, 1.0, std::sqrt(rest.squares), rest.share});
            rest = {};
        }
        sort_rows(rows);
        return rows;
    }

    const SensitivitySource& source_;
    const InputSet& inputs_;
    const Correlations& correlations_;
    LawOfPropagation& law_;
    std::shared_ptr<CondensedTerms> kept_ = std::make_shared<CondensedTerms>();
    std::vector<std::size_t> rest_of_;  ///< number of the budget's component
    std::vector<char> is_known_;
    std::size_t most_of_output_ = 0;
    bool has_degrees_ = false;
    std::atomic<bool> is_approximate_ = false;
    std::mutex of_sums_;
    ContributorSums sums_;
};

}  // namespace

void condense(const SensitivitySource& source, const MeasurementModel& model, const InputSet& inputs,
              const Correlations& correlations, std::size_t most_rows, LawOfPropagation& law) {
    law.covariance = OutputCovariance(OutputBlocks::of(model.outputs()));
    Condenser(source, inputs, correlations, most_rows, law).run();
}

}  // namespace covaria::detail
