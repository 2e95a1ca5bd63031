#include "core/model/composed_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <xsimd/memory/xsimd_aligned_allocator.hpp>

#include "core/model/dense_jacobian.h"
#include "core/model/sensitivity_rows.h"

namespace covaria {

namespace {

using AlignedNumbers = std::vector<double, xsimd::aligned_allocator<double, 64>>;

struct ChainMemory {
    AlignedNumbers rows;
    std::vector<std::uint8_t> flags;
    std::vector<double> x, values;
};

/// Kept per thread, so that the hot loop allocates nothing; a chain in a chain finds it taken, not
/// overwritten.
thread_local ChainMemory idle_memory;

class BorrowedMemory {
public:
    BorrowedMemory() : memory_(std::exchange(idle_memory, {})) {}
    ~BorrowedMemory() { idle_memory = std::move(memory_); }
    BorrowedMemory(const BorrowedMemory&) = delete;
    BorrowedMemory& operator=(const BorrowedMemory&) = delete;
    ChainMemory* operator->() { return &memory_; }

private:
    ChainMemory memory_;
};

std::size_t padded(std::size_t trials) {
    return (trials + 7) / 8 * 8;
}

/// y = x, for the linked inputs of a part by themselves.
class PassedOn : public MeasurementModel {
public:
    explicit PassedOn(InputSet inputs) : inputs_(std::move(inputs)) {
        for (const InputQuantity& quantity : inputs_.quantities)
            outputs_.push_back({.symbol = quantity.symbol, .name = quantity.name, .unit = quantity.unit});
    }
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        std::copy(x.begin(), x.end(), y.begin());
        return true;
    }
    bool sensitivities(std::span<const double> x, SensitivityRows& rows) const override {
        rows.assign(x.size(), {});
        for (std::size_t i = 0; i < x.size(); ++i) rows[i].push_back({i, 1.0});
        return true;
    }
    Layout layout(std::span<const double>) const override { return {}; }

private:
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_;
};

}  // namespace

ComposedModel::ComposedModel(std::vector<ChainPart> parts)
    : parts_(std::move(parts)), merged_(chain_inputs(parts_)) {
    for (const ChainPart& part : parts_) {
        first_row_.push_back(rows_);
        if (&part != &last()) rows_ += part.model->outputs().size();
        most_inputs_ = std::max(most_inputs_, part.model->inputs().quantities.size());
    }
    place_inputs();
    find_used_outputs();
    std::vector<double> x, rows(rows_), of_last;
    for (std::size_t i = 0; i < merged_.inputs.quantities.size(); ++i)
        x.push_back(estimate_of(merged_.inputs, i));
    if (!evaluate_upstream(x, rows, of_last)) return;  // said by whoever evaluates the chain
    for (std::size_t p = 0; p < used_.size(); ++p)
        for (UsedOutput& used : used_[p]) used.estimate = rows[first_row_[p] + used.output];
    restated_links_ = count_restated_links(of_last);
}

std::size_t ComposedModel::count_restated_links(std::span<const double> x) const {
    const InputSet& stated = last().model->inputs();
    return static_cast<std::size_t>(
        std::count_if(last().links.begin(), last().links.end(), [&](const ModelLink& link) {
            const double own = estimate_of(stated, link.input), linked = x[link.input];
            return std::abs(own - linked) > 1e-9 * std::max(std::abs(own), std::abs(linked)) ||
                   standard_uncertainty_of(stated, link.input) > 0.0;
        }));
}

std::vector<Table> ComposedModel::evaluation() const {
    std::vector<Table> tables = last().model->evaluation();
    if (tables.empty() || restated_links_ == 0) return tables;
    tables.front().notes.push_back(tell<"From the set-up as it is stated. Values and uncertainties that "
                                        "other analyses give (%1 quantities) "
                                        "are in the results, not here.">(restated_links_));
    return tables;
}

void ComposedModel::place_inputs() {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        std::vector<Place> places;
        for (const std::size_t quantity : merged_.quantities[p]) places.push_back({false, quantity, 0});
        for (std::size_t i = 0; i < parts_[p].links.size(); ++i) {
            const ModelLink& link = parts_[p].links[i];
            places[link.input] = {true, first_row_[link.part] + link.output, i};
        }
        places_.push_back(std::move(places));
    }
}

void ComposedModel::find_used_outputs() {
    used_.resize(parts_.size());
    for (const ChainPart& part : parts_)
        for (const ModelLink& link : part.links) {
            std::vector<UsedOutput>& used = used_[link.part];
            const bool known = std::any_of(used.begin(), used.end(), [&](const UsedOutput& other) {
                return other.output == link.output;
            });
            if (!known)
                used.push_back({link.output, parts_[link.part].model->outputs()[link.output].periodic, 0.0});
        }
}

void ComposedModel::gather(std::size_t part, std::span<const double> x, std::span<const double> rows,
                           std::span<double> to) const {
    for (std::size_t i = 0; i < places_[part].size(); ++i) {
        const Place& place = places_[part][i];
        to[i] = place.linked ? rows[place.index] : x[place.index];
    }
}

double ComposedModel::unwrapped(const UsedOutput& used, double y) {
    constexpr double turn = 2.0 * std::numbers::pi;
    return used.periodic ? y - turn * std::nearbyint((y - used.estimate) / turn) : y;
}

bool ComposedModel::evaluate_upstream(std::span<const double> x, std::span<double> rows,
                                      std::vector<double>& of_last) const {
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        of_last.resize(places_[p].size());
        gather(p, x, rows, of_last);
        if (p + 1 == parts_.size()) break;
        const std::span<double> y = rows.subspan(first_row_[p], parts_[p].model->outputs().size());
        if (!parts_[p].model->evaluate(of_last, y)) return false;
        for (const UsedOutput& used : used_[p]) {
            y[used.output] = unwrapped(used, y[used.output]);
            if (!std::isfinite(y[used.output])) return false;
        }
    }
    return true;
}

bool ComposedModel::evaluate(std::span<const double> x, std::span<double> y) const {
    BorrowedMemory memory;
    memory->values.resize(rows_);
    return evaluate_upstream(x, memory->values, memory->x) && last().model->evaluate(memory->x, y);
}

void ComposedModel::gather(std::size_t part, const TrialBlock& block, const double* rows, double* to) const {
    const std::size_t count = padded(block.trials);
    for (std::size_t i = 0; i < places_[part].size(); ++i) {
        const Place& place = places_[part][i];
        const double* from = (place.linked ? rows : block.inputs) + place.index * block.stride;
        std::copy_n(from, count, to + i * block.stride);
    }
}

void ComposedModel::settle(std::size_t part, const TrialBlock& whole, double* rows) const {
    for (const UsedOutput& used : used_[part]) {
        const double* y = rows + (first_row_[part] + used.output) * whole.stride;
        for (std::size_t t = 0; t < whole.trials; ++t)
            if (!std::isfinite(y[t])) whole.valid[t] = 0;
    }
    const auto first =
        std::find_if(whole.valid, whole.valid + whole.trials, [](std::uint8_t v) { return v != 0; });
    const auto good = static_cast<std::size_t>(first - whole.valid);
    if (good == whole.trials) return;
    for (const UsedOutput& used : used_[part]) {
        double* y = rows + (first_row_[part] + used.output) * whole.stride;
        for (std::size_t t = 0; t < whole.trials; ++t)
            y[t] = unwrapped(used, whole.valid[t] != 0 ? y[t] : y[good]);
        std::fill(y + whole.trials, y + padded(whole.trials), y[whole.trials - 1]);
    }
}

void ComposedModel::evaluate_block(const TrialBlock& block) const {
    BorrowedMemory memory;
    memory->rows.resize((rows_ + most_inputs_) * block.stride);
    memory->flags.resize(block.stride);
    double* const rows = memory->rows.data();
    double* const x = rows + rows_ * block.stride;
    std::fill_n(block.valid, block.trials, std::uint8_t{1});
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        const bool is_last = p + 1 == parts_.size();
        gather(p, block, rows, x);
        std::fill(memory->flags.begin(), memory->flags.end(), std::uint8_t{1});
        parts_[p].model->evaluate_block({x, is_last ? block.outputs : rows + first_row_[p] * block.stride,
                                         memory->flags.data(), block.stride, block.trials});
        for (std::size_t t = 0; t < block.trials; ++t)
            if (memory->flags[t] == 0) block.valid[t] = 0;
        if (!is_last) settle(p, block, rows);
        if (std::none_of(block.valid, block.valid + block.trials, [](std::uint8_t v) { return v != 0; }))
            return;
    }
}

bool ComposedModel::sensitivities(std::span<const double> x, SensitivityRows& rows) const {
    std::vector<double> values(rows_), of_part;
    if (!evaluate_upstream(x, values, of_part)) return false;
    SensitivityRows total(rows_), own;
    RowSum sum(x.size());
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        of_part.resize(places_[p].size());
        gather(p, x, values, of_part);
        if (!parts_[p].model->sensitivities(of_part, own)) return false;
        const auto total_of = [&](std::size_t j) {
            for (const Sensitivity& s : own[j]) {
                const Place& place = places_[p][s.input];
                if (place.linked)
                    sum.add(total[place.index], s.coefficient);
                else
                    sum.add(place.index, s.coefficient);
            }
            return sum.take();
        };
        if (p + 1 < parts_.size()) {
            for (const UsedOutput& used : used_[p])
                total[first_row_[p] + used.output] = total_of(used.output);
        } else {
            rows.assign(own.size(), {});
            for (std::size_t j = 0; j < own.size(); ++j) rows[j] = total_of(j);
        }
    }
    return true;
}

bool ComposedModel::jacobian(std::span<const double> x, Eigen::MatrixXd& jacobian) const {
    SensitivityRows rows;
    if (!sensitivities(x, rows)) return false;
    set_dense(rows, x.size(), jacobian);
    return true;
}

void ComposedModel::place_in_chain(LayoutPoint& point) const {
    if (!point.inputs) return;
    std::array<std::size_t, 3> inputs{}, links{};
    std::size_t linked = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Place& place = places_.back()[(*point.inputs)[k]];
        linked += place.linked;
        inputs[k] = place.index;
        links[k] = place.link;
    }
    point.inputs.reset();
    if (linked == 0) point.inputs = inputs;
    if (linked == 3) point.links = links;  // no inputs of the chain; their uncertainty comes from upstream
}

Layout ComposedModel::layout(std::span<const double> x) const {
    std::vector<double> rows(rows_), of_last;
    if (!evaluate_upstream(x, rows, of_last)) return {};
    Layout layout = last().model->layout(of_last);
    for (LayoutPoint& point : layout.points) place_in_chain(point);
    return layout;
}

std::unique_ptr<ComposedModel> linked_quantities(std::vector<ChainPart> parts) {
    ChainPart& last = parts.back();
    InputSet linked;
    for (ModelLink& link : last.links) {
        InputQuantity quantity = last.inputs.quantities[link.input];
        quantity.shares.clear();
        link.input = linked.quantities.size();
        linked.quantities.push_back(std::move(quantity));
    }
    last.model = std::make_shared<PassedOn>(linked);
    last.inputs = std::move(linked);
    return std::make_unique<ComposedModel>(std::move(parts));
}

}  // namespace covaria
