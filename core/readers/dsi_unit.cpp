#include "core/readers/dsi_unit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/in_quotes.h"

namespace covaria {

namespace {

using NamePair = std::pair<std::string_view, std::string_view>;

constexpr std::array<NamePair, 24> prefixes{
    {{"deca", "da"}, {"hecto", "h"}, {"kilo", "k"},  {"mega", "M"},  {"giga", "G"},  {"tera", "T"},
     {"peta", "P"},  {"exa", "E"},   {"zetta", "Z"}, {"yotta", "Y"}, {"ronna", "R"}, {"quetta", "Q"},
     {"deci", "d"},  {"centi", "c"}, {"milli", "m"}, {"micro", "u"}, {"nano", "n"},  {"pico", "p"},
     {"femto", "f"}, {"atto", "a"},  {"zepto", "z"}, {"yocto", "y"}, {"ronto", "r"}, {"quecto", "q"}}};

constexpr std::array<NamePair, 50> unit_names{{{"one", "1"},
                                               {"percent", "%"},
                                               {"ppm", "ppm"},
                                               {"metre", "m"},
                                               {"kilogram", "kg"},
                                               {"gram", "g"},
                                               {"second", "s"},
                                               {"ampere", "A"},
                                               {"kelvin", "K"},
                                               {"mole", "mol"},
                                               {"candela", "cd"},
                                               {"radian", "rad"},
                                               {"steradian", "sr"},
                                               {"hertz", "Hz"},
                                               {"newton", "N"},
                                               {"pascal", "Pa"},
                                               {"joule", "J"},
                                               {"watt", "W"},
                                               {"coulomb", "C"},
                                               {"volt", "V"},
                                               {"farad", "F"},
                                               {"ohm", "Ohm"},
                                               {"siemens", "S"},
                                               {"weber", "Wb"},
                                               {"tesla", "T"},
                                               {"henry", "H"},
                                               {"degreecelsius", "degC"},
                                               {"degreeCelsius", "degC"},
                                               {"celsius", "degC"},
                                               {"lumen", "lm"},
                                               {"lux", "lx"},
                                               {"becquerel", "Bq"},
                                               {"gray", "Gy"},
                                               {"sievert", "Sv"},
                                               {"katal", "kat"},
                                               {"minute", "min"},
                                               {"hour", "h"},
                                               {"day", "d"},
                                               {"degree", "deg"},
                                               {"arcminute", "arcmin"},
                                               {"arcsecond", "arcsec"},
                                               {"gon", "gon"},
                                               {"hectare", "ha"},
                                               {"litre", "L"},
                                               {"tonne", "t"},
                                               {"electronvolt", "eV"},
                                               {"dalton", "Da"},
                                               {"astronomicalunit", "au"},
                                               {"bar", "bar"},
                                               {"mmHg", "mmHg"}}};

template <std::size_t N>
std::string_view symbol_in(const std::array<NamePair, N>& names, std::string_view name) {
    for (const NamePair& pair : names)
        if (pair.first == name) return pair.second;
    return {};
}

/// A command and its argument: "tothe" and "-2" of "\tothe{-2}".
struct Command {
    std::string_view name, argument;
};

Result<std::vector<Command>> commands_of(std::string_view text) {
    std::vector<Command> commands;
    while (!text.empty()) {
        if (text.front() != '\\') return fail(ErrorCode::bad_input, tell<"it does not begin with \\">());
        const std::size_t end = std::min(text.find_first_of("\\{ ", 1), text.size());
        Command command{text.substr(1, end - 1), {}};
        text.remove_prefix(end);
        if (!text.empty() && text.front() == '{') {
            const std::size_t close = text.find('}');
            if (close == std::string_view::npos)
                return fail(ErrorCode::bad_input, tell<"a brace is not closed">());
            command.argument = text.substr(1, close - 1);
            text.remove_prefix(close + 1);
        }
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        commands.push_back(command);
    }
    return commands;
}

struct Factor {
    std::string symbol;
    int power = 1;
};

std::string typed_unit(const std::vector<Factor>& factors) {
    std::string above, below;
    for (const Factor& factor : factors) {
        if (factor.power == 0 || factor.symbol == "1") continue;
        std::string& side = factor.power > 0 ? above : below;
        side += (side.empty() ? "" : "*") + factor.symbol;
        if (std::abs(factor.power) > 1) side += "^" + std::to_string(std::abs(factor.power));
    }
    if (below.empty()) return above.empty() ? "1" : above;
    return (above.empty() ? "1" : above) + "/" +
           (below.find('*') == std::string::npos ? below : "(" + below + ")");
}

/// Adds a factor, whose power is summed with that of the same symbol: a product that others write as kg*kg^-1
/// is the unit one.
void add_factor(std::vector<Factor>& factors, Factor factor) {
    for (Factor& known : factors)
        if (known.symbol == factor.symbol) {
            known.power += factor.power;
            return;
        }
    factors.push_back(std::move(factor));
}

Result<int> power_in(std::string_view argument) {
    int power = 0;
    const auto [end, status] = std::from_chars(argument.data(), argument.data() + argument.size(), power);
    if (status != std::errc{} || end != argument.data() + argument.size() || std::abs(power) > 9)
        return fail(ErrorCode::bad_input, tell<"its power '%1' is no small integer">(std::string(argument)));
    return power;
}

Result<std::string> typed_text(const std::vector<Command>& commands) {
    std::vector<Factor> factors;
    std::string prefix;
    bool per = false;
    for (std::size_t i = 0; i < commands.size(); ++i) {
        const Command& command = commands[i];
        if (command.name == "per") {
            per = true;
            continue;
        }
        if (const auto symbol = symbol_in(prefixes, command.name); !symbol.empty() && prefix.empty()) {
            prefix = symbol;
            continue;
        }
        const auto symbol = symbol_in(unit_names, command.name);
        if (symbol.empty())
            return fail(ErrorCode::bad_input, tell<"'\\%1' is not known">(std::string(command.name)));
        Factor factor{prefix + std::string(symbol), 1};
        prefix.clear();
        if (i + 1 < commands.size() && commands[i + 1].name == "tothe") {
            const auto power = power_in(commands[++i].argument);
            if (!power) return fail(power.error());
            factor.power = *power;
        }
        if (std::exchange(per, false)) factor.power = -factor.power;
        add_factor(factors, std::move(factor));
    }
    if (!prefix.empty() || per || commands.empty())
        return fail(ErrorCode::bad_input, tell<"it ends too early">());
    return typed_unit(factors);
}

/// The name "\\name" of a symbol with or without a prefix; empty where the D-SI has none.
std::string dsi_name(std::string_view symbol) {
    for (const NamePair& unit : unit_names)
        if (unit.second == symbol) return "\\" + std::string(unit.first);
    for (const NamePair& prefix : prefixes)
        if (symbol.starts_with(prefix.second))
            for (const NamePair& unit : unit_names)
                if (unit.second == symbol.substr(prefix.second.size()))
                    return "\\" + std::string(prefix.first) + "\\" + std::string(unit.first);
    return {};
}

std::string to_the(int power) {
    return power == 1 ? "" : "\\tothe{" + std::to_string(power) + "}";
}

/// The D-SI text of a unit as `Unit` writes it: factors with powers between '*', blanks and '/', the latter
/// for one factor or a parenthesis. It is empty where a factor has no name. Callers read it back, so that
/// nothing depends on this grammar.
std::string dsi_text_of(std::string_view text) {
    std::string out;
    bool below = false, in_parenthesis = false;
    while (!text.empty()) {
        const char c = text.front();
        if (c == '/') below = true;
        if (c == '(') in_parenthesis = true;
        if (c == ')') in_parenthesis = below = false;
        if (std::string_view("/()* ").find(c) != std::string_view::npos) {
            text.remove_prefix(1);
            continue;
        }
        const std::string_view factor = text.substr(0, text.find_first_of("/()* "));
        text.remove_prefix(factor.size());
        const std::size_t end = std::min(factor.find_first_of("^0123456789-"), factor.size());
        std::string_view digits = factor.substr(end);
        if (digits.starts_with('^')) digits.remove_prefix(1);
        const auto power = digits.empty() ? Result<int>(1) : power_in(digits);
        if (factor == "1") continue;
        const std::string name = dsi_name(factor.substr(0, end));
        if (name.empty() || !power) return {};
        out += name + to_the(below ? -*power : *power);
        if (!in_parenthesis) below = false;
    }
    return out.empty() ? "\\one" : out;
}

/// The D-SI text of the coherent SI unit of a dimension.
std::string dsi_text_of(const Dimension& dimension) {
    constexpr std::array<const char*, 8> base{"\\metre",  "\\kilogram", "\\second",  "\\ampere",
                                              "\\kelvin", "\\mole",     "\\candela", "\\radian"};
    std::string out;
    for (std::size_t i = 0; i < base.size(); ++i)
        if (const int power = dimension.exponents[i]; power != 0) out += base[i] + to_the(power);
    return out.empty() ? "\\one" : out;
}

}  // namespace

DsiUnit dsi_unit_for(const Unit& unit) {
    DsiUnit named{dsi_text_of(unit.text()), unit};
    const auto back = unit_of_dsi(named.text);
    if (back && back->dimension() == unit.dimension() && back->to_si(1.0) == unit.to_si(1.0) &&
        back->interval_to_si(1.0) == unit.interval_to_si(1.0))
        return named;
    const std::string coherent = dsi_text_of(unit.dimension());
    return {coherent, unit_of_dsi(coherent).value()};
}

std::string dsi_product(const DsiUnit& a, const DsiUnit& b) {
    const std::string of_a = dsi_unit_for(a.unit.interval()).text,
                      of_b = dsi_unit_for(b.unit.interval()).text;
    if (of_a == "\\one") return of_b;
    if (of_b == "\\one") return of_a;
    const auto commands = commands_of(of_a);
    const bool simple = commands && std::count_if(commands->begin(), commands->end(), [](const Command& c) {
                                        return symbol_in(prefixes, c.name).empty();
                                    }) == 1;
    return of_a == of_b && simple ? of_a + "\\tothe{2}" : of_a + of_b;
}

Result<Unit> unit_of_dsi(const std::string& text) {
    const auto commands = commands_of(text);
    const auto typed = commands ? typed_text(*commands) : fail(commands.error());
    auto unit = typed ? Unit::parse(*typed) : fail(typed.error());
    if (!unit)
        return fail(ErrorCode::bad_input, tell<"the unit %1: %2">(in_quotes(text), unit.error().message));
    return unit;
}

}  // namespace covaria
