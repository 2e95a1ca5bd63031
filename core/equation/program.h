// Equations compiled to a flat list of instructions over registers.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/temperature.h"
#include "core/base/unit.h"
#include "core/equation/operations.h"
#include "core/equation/parser.h"

namespace covaria::equation {

/// y = operation(a, b, c): indices of registers.
struct Instruction {
    Operation operation = Operation::constant;
    int y = 0, a = 0, b = 0, c = 0;
    double value = 0.0;  ///< n of an integer power
};

/// A system r(u) = 0 solved by Newton's method in every trial.
struct NewtonSystem {
    std::vector<int> unknowns;  ///< registers that get the solution
    std::vector<int> starts;
    std::vector<int> residuals;
    std::vector<int> jacobian;        ///< dr_i/du_j, row by row; -1: zero
    std::size_t first = 0, last = 0;  ///< instructions that compute residuals and Jacobian
    int scratch = 0;                  ///< first of `scratch_registers()` registers of its own
    std::size_t size() const { return unknowns.size(); }
    std::size_t scratch_registers() const { return 2 * size() + 4; }
};

/// Instructions first ... last - 1, or a system.
struct Step {
    std::size_t first = 0, last = 0;
    int system = -1;
};

struct Program {
    struct Constant {
        int at;
        double value;
    };
    struct Input {
        int at;
        std::size_t quantity;
    };
    std::size_t registers = 0;
    std::vector<Constant> constants;
    std::vector<Input> inputs;
    std::vector<Instruction> instructions;
    std::vector<Place> places;  ///< place of each instruction in the text
    std::vector<NewtonSystem> systems;
    std::vector<Step> steps;
    std::vector<int> outputs;  ///< registers
};

/// A quantity that the equations may refer to.
struct KnownSymbol {
    std::string name;
    Unit unit;
};

/// A definition that is wanted as output; its unit, if known, must fit.
struct WantedOutput {
    std::string name;
    std::optional<Unit> unit;
};

struct CompiledOutput {
    Unit unit = {};  ///< the wanted one, else that of the first quantity of that dimension, else coherent
    TemperatureKind temperature = TemperatureKind::by_unit;
    bool on_circle = false;  ///< an angle that is the same after a full turn
};

struct Compiled {
    Program program;
    std::vector<CompiledOutput> outputs;
};

/// Orders the statements, checks the dimensions and compiles. Plane angle counts as a number here (the radian
/// is one in the SI). Every mistake is reported with its place; then the result must not be used. Symbols
/// that are neither known nor defined are reported too.
Compiled compile(const ParsedText& parsed, std::span<const KnownSymbol> symbols,
                 std::span<const WantedOutput> outputs, TextProblems& problems);

}  // namespace covaria::equation
