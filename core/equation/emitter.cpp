#include "core/equation/emitter.h"

#include <cmath>

#include "core/equation/evaluate.h"

namespace covaria::equation {

namespace {

constexpr double largest_integer_power = 64.0;

}  // namespace

int Emitter::new_register(const Kind& kind, std::optional<double> value) {
    kinds_.push_back(kind);
    values_.push_back(value);
    return static_cast<int>(program_.registers++);
}

int Emitter::constant(double value, const Kind& kind) {
    std::array<double, 12> key{};
    std::copy(kind.exponents.begin(), kind.exponents.end(), key.begin());
    key[8] = (kind.any ? 1.0 : 0.0) + (kind.condition ? 2.0 : 0.0) + (std::signbit(value) ? 4.0 : 0.0);
    if (std::isnan(value)) key[8] += 8.0;
    if (kind.zeros) key[8] += kind.zeros->of_a_sum ? 32.0 : 16.0, key[9] = kind.zeros->count;
    key[10] = kind.readings;
    key[11] = kind.on_circle ? 1.0 : 0.0;
    const auto [known, is_new] = constants_.try_emplace({std::isnan(value) ? 0.0 : value, key}, 0);
    if (is_new) {
        known->second = new_register(kind, value);
        program_.constants.push_back({known->second, value});
    }
    return known->second;
}

int Emitter::input(std::size_t quantity, const Kind& kind) {
    const auto [known, is_new] = inputs_.try_emplace(quantity, 0);
    if (is_new) {
        known->second = new_register(kind, std::nullopt);
        program_.inputs.push_back({known->second, quantity});
    }
    return known->second;
}

int Emitter::unknown(const Kind& kind) {
    return new_register(kind, std::nullopt);
}

int Emitter::operation(Operation operation, int a, int b, int c, const Kind& kind, double value) {
    const auto known_value = [&](int at) { return at < 0 ? std::optional<double>(0.0) : this->value(at); };
    if (known_value(a) && known_value(b) && known_value(c))
        return constant(evaluated(operation, *known_value(a), *known_value(b), *known_value(c), value), kind);
    // The other branch of a decided 'if' plays no part.
    if (operation == Operation::select && known_value(a)) return *known_value(a) != 0.0 ? b : c;
    const Key key{operation, a, b, c, value};
    if (const auto found = known_.find(key); found != known_.end()) return found->second;
    Known& known = in_system_ ? known_in_system_ : known_;
    const auto [found, is_new] = known.try_emplace(key, 0);
    if (is_new) {
        found->second = new_register(kind, std::nullopt);
        program_.instructions.push_back(
            {operation, found->second, std::max(a, 0), std::max(b, 0), std::max(c, 0), value});
        program_.places.push_back(place_);
    }
    return found->second;
}

int Emitter::power(int a, int b, const Kind& kind) {
    const std::optional<double> exponent = value(b);
    if (!exponent || value(a)) return operation(Operation::power, a, b, -1, kind);
    if (*exponent == 0.5) return operation(Operation::square_root, a, -1, -1, kind);
    if (*exponent == 2.0) return operation(Operation::multiply, a, a, -1, kind);
    if (*exponent == std::round(*exponent) && std::abs(*exponent) <= largest_integer_power)
        return operation(Operation::integer_power, a, -1, -1, kind, *exponent);
    return operation(Operation::power, a, b, -1, kind);
}

void Emitter::begin_system() {
    system_begin_ = program_.instructions.size();
    if (step_begin_ < system_begin_) program_.steps.push_back({step_begin_, system_begin_, -1});
    in_system_ = true;
    known_in_system_.clear();
}

void Emitter::end_system(NewtonSystem system) {
    system.first = system_begin_;
    system.last = step_begin_ = program_.instructions.size();
    system.scratch = static_cast<int>(program_.registers);
    for (std::size_t i = 0; i < system.scratch_registers(); ++i) new_register({}, std::nullopt);
    program_.steps.push_back({0, 0, static_cast<int>(program_.systems.size())});
    program_.systems.push_back(std::move(system));
    in_system_ = false;
}

void Emitter::finish() {
    if (step_begin_ < program_.instructions.size())
        program_.steps.push_back({step_begin_, program_.instructions.size(), -1});
    step_begin_ = program_.instructions.size();
}

}  // namespace covaria::equation
