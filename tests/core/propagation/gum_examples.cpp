// Reads tests/data/gum_examples.json.
#include "gum_examples.h"

#include <fstream>
#include <stdexcept>

#include "test_models.h"

namespace covaria::test {
namespace {

nlohmann::json read_examples() {
    std::ifstream file(COVARIA_SOURCE_DIR "/tests/data/gum_examples.json");
    if (!file) throw std::runtime_error("tests/data/gum_examples.json is missing");
    return nlohmann::json::parse(file);
}

Distribution distribution_of(const nlohmann::json& d) {
    const std::string type = d.at("type");
    const auto number = [&d](const char* key) { return d.at(key).get<double>(); };
    if (type == "normal") return Distribution::of(Normal{number("mean"), number("std")});
    if (type == "rect") return Distribution::of(Rectangular{number("a"), number("b")});
    if (type == "t") return Distribution::of(StudentT{number("mean"), number("scale"), number("nu")});
    if (type == "arcsine") return Distribution::of(Arcsine{number("a"), number("b")});
    if (type == "ctrap") return Distribution::of(CurvilinearTrapezoid{number("a"), number("b"), number("d")});
    throw std::runtime_error("unknown distribution " + type);
}

}  // namespace

const nlohmann::json& gum_example(const std::string& id) {
    static const nlohmann::json all = read_examples();
    for (const auto& example : all.at("examples"))
        if (example.at("id") == id) return example;
    throw std::runtime_error("no example " + id);
}

InputSet example_inputs(const nlohmann::json& example) {
    InputSet inputs;
    for (const auto& input : example.at("inputs")) {
        const bool stated = input.contains("dof") && input["dof"].is_number();
        const Distribution distribution = input.contains("dist")
                                              ? distribution_of(input["dist"])
                                              : Distribution::of(Normal{input.at("x"), input.at("u")});
        add_quantity(inputs, input.at("name"), distribution, stated ? input["dof"].get<double>() : infinity);
    }
    for (const auto& r : example.at("correlation"))
        inputs.correlations.push_back({inputs.find(r[0]), inputs.find(r[1]), r[2].get<double>()});
    return inputs;
}

}  // namespace covaria::test
