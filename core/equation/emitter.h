// Builds a program value by value: constants are computed at once, values that occur twice are kept once.
#pragma once

#include <map>
#include <optional>
#include <tuple>

#include "core/equation/dimensions.h"
#include "core/equation/program.h"

namespace covaria::equation {

class Emitter {
public:
    explicit Emitter(Program& program) : program_(program) {}

    int constant(double value, const Kind& kind = {});
    int input(std::size_t quantity, const Kind& kind);
    int unknown(const Kind& kind);
    /// The register with the result; `kind` is that of the result.
    int operation(Operation operation, int a, int b = -1, int c = -1, const Kind& kind = {},
                  double value = 0.0);
    /// a^b with the exponent as cheap and exact as it can be.
    int power(int a, int b, const Kind& kind = {});

    /// Sets the place of the instructions that follow.
    void set_place(const Place& place) { place_ = place; }

    const Kind& kind(int at) const { return kinds_[static_cast<std::size_t>(at)]; }
    std::optional<double> value(int at) const { return values_[static_cast<std::size_t>(at)]; }

    /// Between these two, instructions are those of a system: later ones do not refer to them, but for the
    /// unknowns. `end_system` returns the index of the first of them.
    void begin_system();
    void end_system(NewtonSystem system);
    /// Ends the program; to be called once, behind the last operation.
    void finish();

private:
    using Key = std::tuple<Operation, int, int, int, double>;
    using Known = std::map<Key, int>;
    int new_register(const Kind& kind, std::optional<double> value);

    Program& program_;
    std::vector<Kind> kinds_;
    std::vector<std::optional<double>> values_;
    std::map<std::pair<double, std::array<double, 12>>, int> constants_;
    std::map<std::size_t, int> inputs_;
    Known known_, known_in_system_;
    Place place_;
    bool in_system_ = false;
    std::size_t step_begin_ = 0;
    std::size_t system_begin_ = 0;
};

}  // namespace covaria::equation
