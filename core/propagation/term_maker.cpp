#include "core/propagation/term_maker.h"

#include <algorithm>

namespace covaria::detail {

const std::vector<std::size_t>& Scratch::touched() {
    if (!std::ranges::is_sorted(touched_)) std::ranges::sort(touched_);
    return touched_;
}

void Scratch::clear() {
    for (const std::size_t c : touched_) {
        values_[c] = 0.0;
        used_[c] = 0;
    }
    touched_.clear();
}

TermMaker::TermMaker(const InputSet& inputs, const Correlations& correlations, const Eigen::VectorXd& u)
    : u_(u),
      partners_(correlations.empty() ? 0 : inputs.components.size()),
      sensitivity_(inputs.components.size()),
      correlated_(inputs.components.size()) {
    for (const InputQuantity& quantity : inputs.quantities) {
        begins_.push_back(shares_.size());
        shares_.insert(shares_.end(), quantity.shares.begin(), quantity.shares.end());
    }
    begins_.push_back(shares_.size());
    for (const ComponentCorrelation& r : correlations) {
        partners_[r.first].push_back({r.second, r.coefficient});
        partners_[r.second].push_back({r.first, r.coefficient});
    }
}

void TermMaker::make(const std::vector<Sensitivity>& row, std::vector<PropagationTerm>& terms) {
    sensitivity_.clear();
    correlated_.clear();
    terms.clear();
    for (const Sensitivity& s : row)
        for (std::size_t k = begins_[s.input]; k < begins_[s.input + 1]; ++k)
            sensitivity_[shares_[k].component] += s.coefficient * shares_[k].factor;
    const std::vector<std::size_t>& touched = sensitivity_.touched();
    if (partners_.empty()) {
        terms.reserve(touched.size());
        for (const std::size_t c : touched)
            terms.push_back({c, sensitivity_.value(c), contribution(c), contribution(c)});
        return;
    }
    for (const std::size_t c : touched) {
        correlated_[c] += contribution(c);
        for (const Partner& partner : partners_[c])
            correlated_[partner.component] += partner.coefficient * contribution(c);
    }
    for (const std::size_t c : correlated_.touched())
        terms.push_back({c, sensitivity_.value(c), contribution(c), correlated_.value(c)});
}

double covariance_of_pair(const std::vector<PropagationTerm>& a, const std::vector<PropagationTerm>& b) {
    double sum = 0.0;
    for (auto s = a.begin(), t = b.begin(); s != a.end() && t != b.end();) {
        if (s->component == t->component) {
            sum += 0.5 * (s->correlated * t->contribution + t->correlated * s->contribution);
            ++s, ++t;
        } else {
            ++(s->component < t->component ? s : t);
        }
    }
    return sum;
}

}  // namespace covaria::detail
