// The text of equations as statements: definitions and systems to be solved.
//
//     R = V/I * cos(phi)                          definition; names without one are quantities
//     d = L - 50 [mm]                             a number with its unit
//     z = if(x > 0 [mm], x, 0)                    condition
//     solve f = 0.02: 1/sqrt(f) = -2*log10(k/3.7 + 2.51/(Re*sqrt(f)))
//     solve a = 1, b = 2: a + b = s and a*b = p   unknowns with starting values, as many equations
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/unit.h"
#include "core/equation/operations.h"
#include "core/equation/place.h"

namespace covaria::equation {

/// Most unknowns that are solved together: a step of Newton's method takes a third of the cube of their
/// number in each trial, 20 microseconds for 40.
inline constexpr std::size_t most_unknowns = 40;

/// A node of an expression, after its operands: lists of nodes need no recursion to be walked.
struct Node {
    Operation operation = Operation::constant;
    int a = -1, b = -1, c = -1;  ///< operands: indices of nodes
    double value = 0.0;          ///< value of a constant, SI; n of an integer power
    Unit unit = {};              ///< unit of a constant, as written
    std::string text = {};       ///< name of a symbol; digits of a constant
    Place place = {};            ///< place of the whole expression
    Place sign = {};             ///< place of the operator or the function's name
};

struct Definition {
    std::string name;
    Place place;
    int root = -1;  ///< node of the expression; of the starting value for an unknown
};

struct Residual {
    int left = -1, right = -1;
    Place place;
};

/// A definition, or unknowns with the equations they solve.
struct Statement {
    std::vector<Definition> defined;  ///< one, or the unknowns
    std::vector<Residual> equations;  ///< empty for a definition
    std::size_t first_node = 0, last_node = 0;
    std::size_t first_of_equations = 0;  ///< nodes from here on are those of the equations
    bool is_system() const { return !equations.empty(); }
};

struct ParsedText {
    std::vector<Node> nodes;
    std::vector<Statement> statements;
    const Definition* find(std::string_view name) const;
};

/// Reads as much as can be read; every mistake is reported with its place.
ParsedText parse(std::string_view text, TextProblems& problems);

struct SymbolUse {
    std::string name;
    Place place;  ///< place of the first use
};
/// Names that are used and not defined, in order of appearance.
std::vector<SymbolUse> free_symbols(const ParsedText& parsed);

}  // namespace covaria::equation
