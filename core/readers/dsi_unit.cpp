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

/// "\tothe{-2}" -> "tothe" and "-2".
struct Command {
    std::string_view name, argument;
};

Result<std::vector<Command>> commands_of(std::string_view text) {
    std::vector<Command> commands;
    while (!text.empty()) {
        if (text.front() != '\\') return fail(ErrorCode::bad_input, "it does not begin with \\");
        const std::size_t end = std::min(text.find_first_of("\\{ ", 1), text.size());
        Command command{text.substr(1, end - 1), {}};
        text.remove_prefix(end);
        if (!text.empty() && text.front() == '{') {
            const std::size_t close = text.find('}');
            if (close == std::string_view::npos) return fail(ErrorCode::bad_input, "a brace is not closed");
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

/// Sums powers of the same symbol: what others write as kg*kg^-1 is the unit one.
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
        return fail(ErrorCode::bad_input, "its power '" + std::string(argument) + "' is no small integer");
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
            return fail(ErrorCode::bad_input, "'\\" + std::string(command.name) + "' is not known");
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
    if (!prefix.empty() || per || commands.empty()) return fail(ErrorCode::bad_input, "it ends too early");
    return typed_unit(factors);
}

}  // namespace

Result<Unit> unit_of_dsi(const std::string& text) {
    const auto commands = commands_of(text);
    const auto typed = commands ? typed_text(*commands) : fail(commands.error());
    auto unit = typed ? Unit::parse(*typed) : fail(typed.error());
    if (!unit) return fail(ErrorCode::bad_input, "the unit " + in_quotes(text) + ": " + unit.error().message);
    return unit;
}

}  // namespace covaria
