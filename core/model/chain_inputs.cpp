// The inputs of the models of a chain as one set: each component once, whatever ways lead to it.
#include <algorithm>
#include <map>
#include <set>

#include "core/model/composed_model.h"

namespace covaria {

namespace {

constexpr std::size_t left_out = InputSet::npos;

bool stated_alike(const UncertaintyComponent& a, const UncertaintyComponent& b) {
    return a.distribution == b.distribution && a.held == b.held && a.normal_draws == b.normal_draws &&
           a.degrees_of_freedom == b.degrees_of_freedom;
}

class ChainMerge {
public:
    explicit ChainMerge(const std::vector<ChainPart>& parts) : parts_(parts) {
        merged_.quantities.resize(parts.size());
    }

    ChainInputs run() {
        add(parts_.size() - 1);
        for (std::size_t p = 0; p + 1 < parts_.size(); ++p) add(p);
        return std::move(merged_);
    }

private:
    InputSet& inputs() { return merged_.inputs; }
    bool is_last(std::size_t p) const { return p + 1 == parts_.size(); }
    /// Name of the part; with its id where another part has the same name.
    std::string title(std::size_t p) const {
        const std::string& name = parts_[p].name;
        if (name.empty()) return parts_[p].id;
        const auto alike = std::count_if(parts_.begin(), parts_.end(), [&](const ChainPart& other) {
            return other.name == name && other.id != parts_[p].id;
        });
        return alike == 0 ? name : name + " (" + parts_[p].id + ")";
    }

    void add(std::size_t p) {
        const InputSet& own = parts_[p].inputs;
        const std::vector<bool> linked = linked_inputs(p);
        const std::vector<bool> wanted = wanted_components(own, linked);
        place_.assign(own.components.size(), left_out);
        for (std::size_t c = 0; c < own.components.size(); ++c)
            if (wanted[c]) place_[c] = place_of(p, own.components[c]);
        for (std::size_t i = 0; i < own.quantities.size(); ++i)
            merged_.quantities[p].push_back(linked[i] ? left_out : add_quantity(p, own.quantities[i]));
        for (const ComponentCorrelation& c : own.correlations) add_correlation(c);
        for (const IsotropicVector& vector : own.vectors) add_vector(vector);
        for (const VarianceEstimate& estimate : own.variance_estimates) add_estimate(p, estimate);
    }

    std::vector<bool> linked_inputs(std::size_t p) const {
        std::vector<bool> linked(parts_[p].inputs.quantities.size(), false);
        for (const ModelLink& link : parts_[p].links) linked[link.input] = true;
        return linked;
    }

    /// All components but those that only linked quantities use. A vector of random direction stays whole.
    static std::vector<bool> wanted_components(const InputSet& own, const std::vector<bool>& linked) {
        std::vector<bool> in_linked(own.components.size(), false), in_free = in_linked;
        for (std::size_t i = 0; i < own.quantities.size(); ++i)
            for (const Share& share : own.quantities[i].shares)
                (linked[i] ? in_linked : in_free)[share.component] = true;
        for (const IsotropicVector& vector : own.vectors)
            if (std::any_of(vector.components.begin(), vector.components.end(),
                            [&](std::size_t c) { return in_free[c]; }))
                for (const std::size_t c : vector.components) in_free[c] = true;
        for (std::size_t c = 0; c < in_free.size(); ++c) in_free[c] = in_free[c] || !in_linked[c];
        return in_free;
    }

    std::size_t place_of(std::size_t p, const UncertaintyComponent& own) {
        std::string key = own.identity.empty() ? parts_[p].id + ":" + own.id : own.identity;
        if (const auto known = component_.find(key); known != component_.end()) {
            if (stated_alike(inputs().components[known->second], own)) {
                name_analysis(p, inputs().components[known->second]);
                return known->second;
            }
            merged_.kept_apart.push_back(own.name);
            key = parts_[p].id + ":" + key;
        }
        UncertaintyComponent component = own;
        const bool of_part = key.starts_with(parts_[p].id + ":");
        if (!is_last(p)) component.id = unique(of_part ? key : own.id, ids_);
        ids_.insert(component.id);
        component.identity = key;
        if (!is_last(p) && component.contributor.empty()) {
            component.contributor = "analysis " + parts_[p].id;
            component.contributor_name = title(p);
        }
        name_analysis(p, component);
        return component_[key] = inputs().add(std::move(component));
    }

    static std::string unique(std::string id, const std::set<std::string>& known) {
        while (known.contains(id)) id += "'";
        return id;
    }

    /// "gauge"; of a component that several analyses have: "gauge, probe".
    void name_analysis(std::size_t p, UncertaintyComponent& component) const {
        const auto tag = std::find_if(component.tags.begin(), component.tags.end(),
                                      [](const GroupTag& t) { return t.grouping == "analysis"; });
        if (tag == component.tags.end())
            component.tags.push_back({"analysis", title(p)});
        else if ((", " + tag->group + ", ").find(", " + title(p) + ", ") == std::string::npos)
            tag->group += ", " + title(p);
    }

    std::size_t add_quantity(std::size_t p, InputQuantity quantity) {
        for (Share& share : quantity.shares) share.component = place_[share.component];
        if (!is_last(p)) {
            if (quantity.analysis.empty()) {
                const bool subscript = quantity.symbol.find('_') != std::string::npos;
                quantity.symbol += (subscript ? "," : "_") + parts_[p].id;
                quantity.group = title(p) + (quantity.group.empty() ? "" : ", " + quantity.group);
                quantity.analysis = parts_[p].id;
            }
            quantity.symbol = unique(quantity.symbol, symbols_);
            quantity.source.clear();  // a place in another set-up
        }
        symbols_.insert(quantity.symbol);
        inputs().quantities.push_back(std::move(quantity));
        return inputs().quantities.size() - 1;
    }

    void add_correlation(const ComponentCorrelation& own) {
        const std::size_t first = place_[own.first], second = place_[own.second];
        if (first == left_out || second == left_out || first == second) return;
        if (correlated_.insert(std::minmax(first, second)).second)
            inputs().correlations.push_back({first, second, own.coefficient});
    }

    void add_vector(const IsotropicVector& own) {
        IsotropicVector vector;
        for (std::size_t axis = 0; axis < 3; ++axis) vector.components[axis] = place_[own.components[axis]];
        if (vector.components[0] == left_out || !in_vectors_.insert(vector.components[0]).second) return;
        inputs().vectors.push_back(vector);
    }

    void add_estimate(std::size_t p, const VarianceEstimate& own) {
        std::string id = own.of_asset || is_last(p) ? own.id : parts_[p].id + ":" + own.id;
        for (const std::size_t member : own.components)
            if (const auto known = estimate_of_.find(place_[member]); known != estimate_of_.end())
                id = known->second;
        for (const std::size_t member : own.components) {
            if (place_[member] == left_out || !estimate_of_.try_emplace(place_[member], id).second) continue;
            inputs().rest_on_estimate(id, place_[member], own.of_asset);
        }
    }

    const std::vector<ChainPart>& parts_;
    ChainInputs merged_;
    std::map<std::string, std::size_t> component_;  ///< components by identity
    std::vector<std::size_t> place_;                ///< places of the components of the part being added
    std::set<std::string> ids_, symbols_;
    std::set<std::pair<std::size_t, std::size_t>> correlated_;
    std::set<std::size_t> in_vectors_;
    std::map<std::size_t, std::string> estimate_of_;  ///< id of the estimate of variance of a component
};

}  // namespace

ChainInputs chain_inputs(const std::vector<ChainPart>& parts) {
    return ChainMerge(parts).run();
}

}  // namespace covaria
