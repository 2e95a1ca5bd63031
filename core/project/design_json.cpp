// Designs to and from JSON.
#include "core/project/design_json.h"

#include "core/project/options_json.h"
#include "core/project/setup_json.h"
#include "core/project/study_json_parts.h"

namespace covaria {

namespace {

using Style = JsonWriter::Style;

constexpr std::array<Word<DesignObjective>, 4> objectives{
    {{DesignObjective::largest, "largest"},
     {DesignObjective::mean, "mean"},
     {DesignObjective::root_mean_square, "root-mean-square"},
     {DesignObjective::cost, "cost"}}};

constexpr std::array<Word<PriceLaw>, 3> price_laws{
    {{PriceLaw::inverse, "inverse"}, {PriceLaw::repeats, "repeats"}, {PriceLaw::logarithmic, "logarithmic"}}};

DesignReduction read_reduction(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a reduction of a design", problems);
    DesignReduction reduction;
    reduction.number.asset = reader.text("asset");
    reduction.number.target = reader.text("target", true);
    reduction.number.from = reader.number("least").value_or(reduction.number.from);
    reduction.price = reader.number("price", true).value_or(reduction.price);
    read_word(reader, "law", price_laws, reduction.law);
    reader.refuse_unknown_keys();
    return reduction;
}

void write_reduction(JsonWriter& out, const DesignReduction& reduction) {
    const DesignReduction defaults;
    out.begin_object(Style::one_line);
    if (!reduction.number.asset.empty()) out.member("asset", reduction.number.asset);
    out.member("target", reduction.number.target);
    out.key("least");
    out.finite_number(reduction.number.from);
    out.key("price");
    out.finite_number(reduction.price);
    if (reduction.law != defaults.law) out.member("law", key_of(price_laws, reduction.law));
    out.end();
}

DesignVariable read_variable(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a variable of a design", problems);
    DesignVariable variable;
    read_varied_number(reader, variable.number);
    variable.tolerance = reader.number("tolerance").value_or(0.0);
    reader.refuse_unknown_keys();
    return variable;
}

void write_variable(JsonWriter& out, const DesignVariable& variable) {
    out.begin_object(Style::one_line);
    write_varied_number(out, variable.number);
    if (variable.tolerance != 0.0) {
        out.key("tolerance");
        out.finite_number(variable.tolerance);
    }
    out.end();
}

double read_number(const Json& value, const std::string& path, Problems& problems) {
    if (value.is_number()) return value.get<double>();
    problems.error(path, "a number is needed here; it is " + json_words(value));
    return 0.0;
}

std::size_t read_row(const Json& value, const std::string& path, Problems& problems) {
    std::size_t row = 0;
    take_count(read_number(value, path, problems), "fixed", path, problems, row);
    return row;
}

DesignChoice read_choice(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "the choice of a design", problems);
    DesignChoice choice;
    choice.asset = reader.text("asset");
    choice.table = reader.text("table", true);
    const auto keep = reader.number("keep", true);
    if (keep) take_count(*keep, "keep", reader.path_of("keep"), problems, choice.keep);
    read_list(reader, "fixed", choice.fixed, read_row);
    choice.candidates = reader.text("candidates");
    read_list(reader, "prices", choice.prices, read_number);
    reader.refuse_unknown_keys();
    return choice;
}

void write_choice(JsonWriter& out, const DesignChoice& choice) {
    out.begin_object(Style::one_line);
    if (!choice.asset.empty()) out.member("asset", choice.asset);
    out.member("table", choice.table);
    out.key("keep");
    out.integer(choice.keep);
    write_list(out, "fixed", choice.fixed, [](JsonWriter& to, std::size_t row) { to.integer(row); });
    if (!choice.candidates.empty()) out.member("candidates", choice.candidates);
    write_list(out, "prices", choice.prices, [](JsonWriter& to, double price) { to.finite_number(price); });
    out.end();
}

std::array<double, 3> read_corner(ObjectReader& reader, const std::string& key) {
    std::vector<double> numbers;
    read_list(reader, key, numbers, read_number);
    if (numbers.size() != 3)
        reader.problems().error(reader.path_of(key), "'" + key + "' of a box has three numbers: x, y, z");
    numbers.resize(3);
    return {numbers[0], numbers[1], numbers[2]};
}

DesignBox read_box(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a box of a design", problems);
    DesignBox box;
    box.name = reader.text("name");
    box.from = read_corner(reader, "from");
    box.to = read_corner(reader, "to");
    const std::string unit = reader.text("unit", true);
    if (!unit.empty()) box.unit = unit_from(unit, reader.path_of("unit"), problems);
    reader.refuse_unknown_keys();
    return box;
}

void write_box(JsonWriter& out, const DesignBox& box) {
    out.begin_object(Style::one_line);
    if (!box.name.empty()) out.member("name", box.name);
    for (const auto& [key, corner] : {std::pair{"from", box.from}, {"to", box.to}}) {
        out.key(key);
        out.begin_list();
        for (const double coordinate : corner) out.finite_number(coordinate);
        out.end();
    }
    out.member("unit", box.unit.text());
    out.end();
}

void read_search(ObjectReader& reader, Design& design) {
    read_count(reader, "starts", design.starts);
    const std::string seed = reader.text("seed");
    if (const auto number = seed_from(seed))
        design.seed = *number;
    else if (!seed.empty())
        reader.problems().error(reader.path_of("seed"),
                                std::string("'seed' must be ") + seed_words + "; it is '" + seed + "'");
    read_count(reader, "mostEvaluations", design.most_evaluations);
    read_count(reader, "trials", design.trials);
}

template <class Count>
void write_count(JsonWriter& out, const char* key, Count count, Count otherwise) {
    if (count == otherwise) return;
    out.key(key);
    out.integer(count);
}

}  // namespace

const char* key_of(DesignObjective objective) {
    return key_of(objectives, objective);
}

const char* key_of(PriceLaw law) {
    return key_of(price_laws, law);
}

Design design_from_json(const Json& value, const std::string& path, Problems& problems) {
    ObjectReader reader(value, path, "a design", problems);
    Design design;
    design.id = reader.text("id", true);
    design.name = reader.text("name");
    read_list(reader, "variables", design.variables, read_variable);
    if (const Json* choice = reader.find("choose"))
        design.choose = read_choice(*choice, reader.path_of("choose"), problems);
    read_list(reader, "reductions", design.reductions, read_reduction);
    read_list(reader, "outputs", design.outputs, read_study_output);
    read_word(reader, "objective", objectives, design.objective);
    design.least_distance = reader.quantity("leastDistance");
    read_list(reader, "keepOut", design.keep_out, read_box);
    read_list(reader, "hiddenBy", design.hidden_by, read_box);
    read_search(reader, design);
    reader.refuse_unknown_keys();
    return design;
}

void write_design(JsonWriter& out, const Design& design) {
    const Design defaults;
    out.begin_object();
    out.member("id", design.id);
    if (!design.name.empty()) out.member("name", design.name);
    write_list(out, "variables", design.variables, write_variable);
    if (design.choose) {
        out.key("choose");
        write_choice(out, *design.choose);
    }
    write_list(out, "reductions", design.reductions, write_reduction);
    write_list(out, "outputs", design.outputs, write_study_output);
    if (design.objective != defaults.objective) out.member("objective", key_of(design.objective));
    if (design.least_distance) {
        out.key("leastDistance");
        write_quantity(out, *design.least_distance);
    }
    write_list(out, "keepOut", design.keep_out, write_box);
    write_list(out, "hiddenBy", design.hidden_by, write_box);
    write_count(out, "starts", design.starts, defaults.starts);
    if (design.seed != defaults.seed) out.member("seed", std::to_string(design.seed));
    write_count(out, "mostEvaluations", design.most_evaluations, defaults.most_evaluations);
    write_count(out, "trials", design.trials, defaults.trials);
    out.end();
}

}  // namespace covaria
