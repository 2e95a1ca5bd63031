// GUM Workbench (.smu): model and quantities of a budget.
#include <cctype>
#include <map>

#include "core/base/in_quotes.h"
#include "core/base/text_places.h"
#include "core/base/utf8.h"
#include "core/readers/entry_texts.h"
#include "core/readers/formats.h"
#include "core/readers/stated_budget.h"
#include "core/readers/text_encoding.h"
#include "core/readers/unstated_units.h"
#include "core/readers/xml_text.h"
#include "core/setup/message_text.h"

namespace covaria {

namespace {

constexpr std::size_t most_smu_lines = 100'000;

struct IniValue {
    std::string text;
    int line = 0;
};
struct IniSection {
    int line = 0;
    std::map<std::string, IniValue> values = {};
    const IniValue* find(const std::string& key) const {
        const auto found = values.find(key);
        return found == values.end() ? nullptr : &found->second;
    }
    std::string text(const std::string& key) const {
        const IniValue* value = find(key);
        return value ? value->text : std::string();
    }
};
using IniFile = std::map<std::string, IniSection>;

std::string trimmed_blanks(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
    return begin == std::string_view::npos ? std::string() : std::string(text.substr(begin, end - begin + 1));
}

Result<IniFile> parse_ini(std::string_view text) {
    IniFile file;
    IniSection* section = nullptr;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string line = trimmed_blanks(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() == ';') continue;
        if (static_cast<std::size_t>(number) > most_smu_lines)
            return refused_at(number, tell<"more than %1 lines are not read">(most_smu_lines));
        if (line.front() == '[') {
            if (line.back() != ']')
                return refused_at(number, 1, tell<"the name of a section is not closed by ']'">());
            const auto [at, added] = file.try_emplace(line.substr(1, line.size() - 2));
            if (!added) return refused_at(number, 1, tell<"the section %1 stands twice">(plain_name(line)));
            section = &at->second;
            section->line = number;
            continue;
        }
        const std::size_t sign = line.find('=');
        if (sign == std::string::npos || !section)
            return refused_at(number, 1, tell<"neither a section [...] nor a line name=value of one">());
        std::string value = trimmed_blanks(std::string_view(line).substr(sign + 1));
        if (value.size() >= 2 && value.front() == '\'' && value.back() == '\'')
            value = value.substr(1, value.size() - 2);
        section->values[trimmed_blanks(std::string_view(line).substr(0, sign))] = {utf8_of_windows(value),
                                                                                   number};
    }
    return file;
}

/// The text with plain names, "delta_m_X" of "\delta\m_X_": names between backslashes are Greek letters, and
/// '_' begins and ends an index.
std::string plain_names(std::string_view text) {
    std::string plain;
    const auto is_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    for (std::size_t at = 0; at < text.size();) {
        if (!is_name(text[at]) && text[at] != '\\') {
            plain += text[at++];
            continue;
        }
        std::string name;
        while (at < text.size() && (is_name(text[at]) || text[at] == '\\')) {
            const bool index = text[at] == '_' || text[at] == '\\';
            if (!index)
                name += text[at];
            else if (!name.empty() && name.back() != '_')
                name += '_';
            ++at;
        }
        while (!name.empty() && name.back() == '_') name.pop_back();
        plain += name;
    }
    return plain;
}

/// The line without remarks in braces, and without the semicolon at its end.
std::string without_remarks(const std::string& line) {
    std::string plain;
    int depth = 0;
    for (const char c : line) {
        depth += c == '{';
        if (depth == 0) plain += c;
        depth -= c == '}' && depth > 0;
    }
    while (!plain.empty() && (plain.back() == ';' || plain.back() == ' ')) plain.pop_back();
    return plain;
}

class SmuReader {
public:
    SmuReader(const IniFile& file, const ReadChoice& choice) : file_(file), choice_(choice) {
        proposals_.title = without_ending(choice.file_name);
    }

    Result<Proposals> read() {
        read_title();
        if (auto done = read_components(); !done) return fail(done.error());
        if (auto done = read_model(); !done) return fail(done.error());
        if (budget_.quantities.empty())
            return refused_at(1, tell<"no quantity with a value and an uncertainty">());
        budget_.id = id_of(proposals_.title, "budget");
        budget_.name = proposals_.title.empty() ? "Budget" : proposals_.title;
        proposals_.found.insert(proposals_.found.begin(),
                                std::to_string(budget_.quantities.size()) + " quantities, " +
                                    std::to_string(budget_.results.size()) + " results");
        name_what_is_left();
        proposals_.analyses.push_back(analysis_of(budget_));
        for (StatedOutcome& outcome : proposals_.outcomes) outcome.analysis = budget_.id;
        return std::move(proposals_);
    }

private:
    const IniSection* section(const std::string& name) const {
        const auto found = file_.find(name);
        return found == file_.end() ? nullptr : &found->second;
    }

    /// The values of the keys Key[1] ... Key[n].
    static std::vector<IniValue> list(const IniSection& section, const std::string& key) {
        std::vector<IniValue> values;
        while (const IniValue* value = section.find(key + "[" + std::to_string(values.size() + 1) + "]"))
            values.push_back(*value);
        return values;
    }

    void read_title() {
        const IniSection* title = section("Title");
        if (!title) return;
        if (const std::string name = plain_name(title->text("Title")); !name.empty()) proposals_.title = name;
        for (const IniValue& line : list(*title, "Description"))
            budget_.notes += (budget_.notes.empty() ? "" : "\n") + plain_line(line.text);
    }

    Result<void> read_model() {
        const IniSection* model = section("Model");
        const std::vector<IniValue> lines = model ? list(*model, "Model") : std::vector<IniValue>();
        if (lines.empty())
            return refused_at(model ? model->line : 1, tell<"the file has no equation (Model[1]=)">());
        for (const IniValue& line : lines) {
            const std::string equation = plain_names(without_remarks(line.text));
            if (equation.empty()) continue;
            if (equation.find("log(") != std::string::npos || equation.find("LOG(") != std::string::npos)
                return refused_at(
                    line.line, tell<"log may be the natural or the decimal logarithm: write ln or log10">());
            if (const Message complaint = equation_complaint(equation); !complaint.empty())
                return refused_at(line.line, in_quotes(plain_name(equation)) + ": " + complaint);
            budget_.equations += (budget_.equations.empty() ? "" : "\n") + equation;
        }
        return {};
    }

    Result<void> read_components() {
        const IniSection* names = section("Components");
        if (!names)
            return refused_at(1, tell<"no file of GUM Workbench: the section [Components] is missing">());
        const std::vector<IniValue> all = list(*names, "Comp");
        for (std::size_t i = 0; i < all.size() && i < most_stated_quantities; ++i) {
            const IniSection* part = section("COMP " + std::to_string(i + 1));
            if (!part) return refused_at(all[i].line, tell<"the section [COMP %1] is missing">(i + 1));
            if (auto done = read_component(plain_names(plain_name(all[i].text)), *part); !done) return done;
        }
        if (all.size() > most_stated_quantities)
            return refused_at(names->line,
                              tell<"more than %1 quantities are not read">(most_stated_quantities));
        return {};
    }

    Result<std::optional<double>> number(const IniSection& part, const char* key) const {
        const IniValue* value = part.find(key);
        if (!value || value->text.empty()) return std::optional<double>();
        const auto read = number_in_text(value->text);
        if (!read)
            return refused_at(value->line, tell<"%1 %2 is no number">(std::string(key),
                                                                      in_quotes(plain_name(value->text))));
        return read;
    }

    Result<double> required(const IniSection& part, const char* key) const {
        const auto value = number(part, key);
        if (!value) return fail(value.error());
        if (!*value) return refused_at(part.line, tell<"%1= is missing">(std::string(key)));
        return **value;
    }

    Result<Unit> unit_of(const IniSection& part, const std::string& symbol) {
        const IniValue* value = part.find("Unit");
        if (!value || value->text.empty())
            return unstated_unit(choice_, symbol, plain_name(part.text("Definition")), Unit(), proposals_);
        if (value->text == "-") return Unit();
        const auto unit = Unit::parse(value->text);
        if (!unit) return refused_at(value->line, unit.error().message);
        return *unit;
    }

    Result<void> read_component(const std::string& symbol, const IniSection& part) {
        const auto unit = unit_of(part, symbol);
        if (!unit) return fail(unit.error());
        const std::string type = part.text("Type"), name = plain_name(part.text("Definition"));
        if (type == "Result") return add_result({symbol, name, *unit}, part);
        const auto value = required(part, "Vnom");
        if (!value) return fail(value.error());
        NotedQuantity quantity{.symbol = symbol, .name = name, .value = *value, .unit = *unit};
        NotedComponent c{.name = name, .unit = unit->interval()};
        if (unit->interval().dimension() == unit->dimension() && !unit->has_offset()) c.unit = *unit;
        const auto figure = [&](const char* key, std::optional<double>& into) -> Result<void> {
            const auto read = required(part, key);
            if (!read) return fail(read.error());
            into = *read;
            return {};
        };
        Result<void> done;
        if (type == "TypBNormal") {
            c.statement = "certificate-k";
            done = figure("Uexp", c.a);
            if (done) done = figure("Fcov", c.b);
        } else if (type == "TypBRectang") {
            c.statement = "rectangular";
            done = figure("Hlim", c.a);
        } else if (type == "TypAPooled") {
            c.statement = "standard";
            done = figure("Ustd", c.a);
        } else {
            const IniValue* place = part.find("Type");
            return refused_at(place ? place->line : part.line,
                              tell<"quantities of type %1 are not known; those that are: Result, TypBNormal, "
                                   "TypBRectang, TypAPooled">(in_quotes(plain_name(type))));
        }
        if (!done) return done;
        const auto nu = number(part, "Neff");
        if (!nu) return fail(nu.error());
        if (*nu && **nu > 0.0 && **nu < 1e6) c.degrees_of_freedom = *nu;
        for (const IniValue& line : list(part, "Description"))
            c.source += (c.source.empty() ? "" : " ") + plain_line(line.text);
        c.source = plain_name(c.source);
        quantity.components.push_back(std::move(c));
        budget_.quantities.push_back(std::move(quantity));
        return {};
    }

    Result<void> add_result(NotedResult result, const IniSection& part) {
        StatedOutcome outcome{.symbol = result.symbol, .unit = result.unit.value_or(Unit())};
        for (const auto& [key, into] : {std::pair("Vnom", &outcome.value), std::pair("Ustd", &outcome.u),
                                        std::pair("Fcov", &outcome.k)}) {
            const auto read = number(part, key);
            if (!read) return fail(read.error());
            *into = *read;
        }
        proposals_.outcomes.push_back(std::move(outcome));
        std::string stated;
        for (const char* key : {"Vnom", "Ustd", "Neff", "Fcov"})
            if (const std::string text = plain_name(part.text(key)); !text.empty())
                stated += (stated.empty() ? "" : ", ") + std::string(key) + " = " + text;
        if (!stated.empty())
            proposals_.found.push_back(tell<"result %1 as the file states it: %2">(result.symbol, stated));
        budget_.results.push_back(std::move(result));
        return {};
    }

    void name_what_is_left() {
        for (const auto& [name, part] : file_)
            if (name != "Header" && name != "Title" && name != "Model" && name != "Components" &&
                !name.starts_with("COMP "))
                proposals_.leave_out(part.line, tell<"section [%1]">(plain_name(name)));
    }

    const IniFile& file_;
    const ReadChoice& choice_;
    Proposals proposals_;
    StatedBudget budget_;
};

Recognition recognise_smu(std::string_view beginning, const std::string&) {
    return beginning.find("Format=SMU") != std::string_view::npos ? Recognition::certain : Recognition::no;
}

Result<Proposals> read_smu(const std::string& text, const ReadChoice& choice) {
    const auto file = parse_ini(without_byte_order_mark(text));
    if (!file) return fail(file.error());
    return SmuReader(*file, choice).read();
}

}  // namespace

Reader gum_workbench_reader() {
    return {.name = "gum-workbench",
            .title = "GUM Workbench",
            .pattern = "*.smu",
            .takes = "model, quantities with their uncertainties -> measurement equation",
            .recognise = recognise_smu,
            .read = read_smu};
}

}  // namespace covaria
