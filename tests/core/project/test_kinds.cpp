#include "tests/core/project/test_kinds.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/kinds/registries.h"

namespace covaria {

namespace {

class Nothing : public Asset {};

// y = gain * (a + b + c), z = a - b.
class SumModel : public MeasurementModel {
public:
    explicit SumModel(double gain) : gain_(gain) {
        const Unit mm = Unit::of("mm");
        const auto shared = inputs_.add({"temperature", "temperature", mm, Distribution::normal(1e-6)});
        for (const char* symbol : {"a", "b", "c"}) {
            const std::size_t index = inputs_.add(
                {symbol, std::string("length ") + symbol, mm, 0.1},
                {{std::string(symbol) + ".calibration", "calibration", mm, Distribution::normal(2e-6)}});
            if (symbol != std::string("c")) inputs_.quantities[index].shares.push_back({shared, 1.0});
        }
    }
    const InputSet& inputs() const override { return inputs_; }
    const std::vector<OutputQuantity>& outputs() const override { return outputs_; }
    bool evaluate(std::span<const double> x, std::span<double> y) const override {
        y[0] = gain_ * (x[0] + x[1] + x[2]);
        y[1] = x[0] - x[1];
        return true;
    }
    Layout layout(std::span<const double>) const override { return {}; }

private:
    double gain_;
    InputSet inputs_;
    std::vector<OutputQuantity> outputs_{{"y", "sum", Unit::of("mm"), "lengths"},
                                         {"z", "difference", Unit::of("mm"), "lengths"}};
};

std::vector<ColumnSpec> point_columns() {
    return {
        {"name", "name", FieldKind::text},
        {"x", "x", FieldKind::number, Unit::of("mm"), {-1.0, 1.0}},
        {"y", "y", FieldKind::number, Unit::of("mm")},
        {"u", "u_p", FieldKind::number, Unit::of("um"), {0.0}, true},
        {"count", "number of readings", FieldKind::integer, {}, {1.0}, true},
        {"used", "used", FieldKind::flag, {}, {}, true},
        {"role", "role", FieldKind::choice, {}, {}, true, {{"nest", "a nest"}, {"support", "a support"}}}};
}

SetupSchema block_schema() {
    const Unit mm = Unit::of("mm");
    FieldSpec length{"length", "length of the block", FieldKind::number, "Its length.", mm};
    length.range = {0.0, 10.0, true};
    FieldSpec deviation{"temperature_deviation", "temperature deviation", FieldKind::number, "From 20 degC.",
                        Unit::of("K")};
    deviation.optional = true;
    FieldSpec rounds{"rounds", "number of rounds", FieldKind::integer, "How many.", {}, {1.0, 100.0}};
    rounds.default_value = Quantity{3.0};
    FieldSpec freedom{"freedom", "degrees of freedom", FieldKind::number, "Of the certificate.", {}, {0.0}};
    freedom.default_value = Quantity{infinity};
    FieldSpec material{"material", "material", FieldKind::choice, "What it is made of."};
    material.default_value = std::string("steel");
    material.choices = {{"steel", "steel"}, {"aluminium", "aluminium"}};
    FieldSpec remark{"remark", "remark", FieldKind::text, "Anything."};
    remark.optional = true;
    FieldSpec hardened{"hardened", "hardened", FieldKind::flag, "Whether it is."};
    hardened.default_value = false;
    FieldSpec hardness{"hardness", "hardness", FieldKind::number, "If hardened."};
    hardness.shown_if = Condition{"hardened", {"true"}};
    FieldSpec pose{"pose", "pose of the block", FieldKind::pose, "Where it is."};
    pose.optional = true;
    FieldSpec points{"points", "points", FieldKind::table, "Its points."};
    points.columns = point_columns();
    points.min_rows = 2;
    FieldSpec readings{"readings", "readings", FieldKind::table, "What was read."};
    readings.columns = {{"point", "point", FieldKind::text}, {"value", "reading", FieldKind::number, mm}};
    readings.optional = true;
    return SetupSchema(
        {length, deviation, rounds, freedom, material, remark, hardened, hardness, pose, points, readings});
}

SetupSchema clamp_schema() {
    FieldSpec block{"block", "clamped block", FieldKind::reference, "What it holds."};
    return SetupSchema({block});
}

SetupSchema sum_schema() {
    FieldSpec block{"block", "block", FieldKind::reference, "The block."};
    block.capabilities = {"point-uncertainty"};
    FieldSpec clamp{"clamp", "clamp", FieldKind::reference, "The clamp."};
    clamp.optional = true;
    FieldSpec gain{"gain", "gain", FieldKind::number, "The gain."};
    gain.default_value = Quantity{1.0};
    return SetupSchema({block, clamp, gain});
}

double number(const SetupReader& reader, const std::string& key) {
    return std::get<Quantity>(value_of(*reader.schema().find(key), reader.setup())).si();
}

AssetDescriptor asset_kind(const std::string& kind, SetupSchema schema,
                           std::vector<std::string> capabilities) {
    AssetDescriptor descriptor;
    descriptor.kind = descriptor.title = kind;
    descriptor.schema = std::move(schema);
    descriptor.capabilities = std::move(capabilities);
    descriptor.create = [kind](const SetupReader& reader, const AssetLibrary&, Problems& problems) {
        if (kind == "block" && number(reader, "rounds") == 1.0)
            problems.warning("/rounds", "one round does not say how well it repeats");
        return std::make_unique<Nothing>();
    };
    return descriptor;
}

ModelDescriptor sum_model() {
    ModelDescriptor descriptor;
    descriptor.id = descriptor.title = "sum";
    descriptor.schema = sum_schema();
    descriptor.create = [](const SetupReader& reader, const AssetLibrary&,
                           Problems& problems) -> std::unique_ptr<MeasurementModel> {
        if (number(reader, "gain") == 0.0) {
            problems.error("/gain", tell<"a gain of zero measures nothing">());
            return nullptr;
        }
        return std::make_unique<SumModel>(number(reader, "gain"));
    };
    return descriptor;
}

}  // namespace

const std::vector<AssetDescriptor>& asset_registry() {
    static const std::vector<AssetDescriptor> kinds{
        asset_kind("block", block_schema(), {"point-uncertainty"}), asset_kind("clamp", clamp_schema(), {})};
    return kinds;
}

const AssetDescriptor* find_asset_kind(const std::string& kind) {
    for (const AssetDescriptor& known : asset_registry())
        if (known.kind == kind) return &known;
    return nullptr;
}

const std::vector<ModelDescriptor>& model_registry() {
    static const std::vector<ModelDescriptor> models{sum_model()};
    return models;
}

const ModelDescriptor* find_model(const std::string& id) {
    for (const ModelDescriptor& known : model_registry())
        if (known.id == id) return &known;
    return nullptr;
}

namespace test {

const char* const whole_project = R"json({
  "format": "covaria",
  "schemaVersion": 2,
  "title": "Block \"A\" of 5 µm",
  "notes": "first line\nsecond line",
  "assets": [
    {
      "id": "block-1",
      "kind": "block",
      "name": "the block",
      "notes": "certificate 7",
      "setup": {
        "length": {"value": 688, "unit": "mm"},
        "temperature_deviation": {"value": 0.7, "unit": "K"},
        "rounds": 5,
        "freedom": null,
        "material": "aluminium",
        "remark": "",
        "hardened": true,
        "hardness": {"value": 62.5, "unit": "%"},
        "pose": {"position": [0, 0, 1175], "lengthUnit": "mm", "angles": [0, 0, -90], "angleUnit": "deg"},
        "points": {
          "columns": ["name", "x [mm]", "y [um]", "u [um]", "used"],
          "rows": [
            ["b1", -344, 196000, 0.066, true],
            ["b2", 1e-07, 12345678.9, null, false],
            ["b3", 0, 1.5e+16, null, null]
          ]
        },
        "readings": {
          "columns": ["point", "value [mm]"],
          "rows": []
        }
      }
    },
    {
      "id": "clamp_2",
      "kind": "clamp",
      "setup": {
        "block": "block-1"
      }
    }
  ],
  "analyses": [
    {
      "id": "sum-1",
      "model": "sum",
      "name": "the sum",
      "setup": {
        "block": "block-1",
        "clamp": "clamp_2",
        "gain": 2
      },
      "inputs": [
        {
          "symbol": "a",
          "estimate": {"value": 12.5, "unit": "mm"},
          "components": [
            {"name": "certificate", "distribution": "normal", "parameters": {"mean": 0, "standard_deviation": 3}, "unit": "um", "origin": "certificate 7"},
            {"name": "repeatability", "distribution": "student-t", "parameters": {"mean": 0, "scale": 0.5, "degrees_of_freedom": 9}, "unit": "um", "type": "A", "degreesOfFreedom": 9},
            {"distribution": "discrete", "parameters": {"values": [-1, 1], "probabilities": [0.5, 0.5]}, "unit": "um", "degreesOfFreedom": null}
          ],
          "combination": "quadrature"
        },
        {"symbol": "c", "components": [], "combination": "arithmetic"},
        {"symbol": "b.calibration", "held": true}
      ],
      "correlations": [
        {"first": "a.edit1", "second": "b.calibration", "coefficient": 0.25}
      ],
      "options": {
        "method": "adaptive",
        "trials": 200000,
        "seed": "18446744073709551615",
        "coverageProbability": 0.99,
        "coverageFactor": 2,
        "secondOrder": true,
        "oneAtATimeTrials": 1000,
        "significantDigits": 1,
        "tolerance": 1e-07,
        "minimumBatches": 20,
        "maximumTrials": 50000000
      },
      "requirements": [
        {"group": "lengths", "symbol": "y", "targetUncertainty": {"value": 0.05, "unit": "mm"}},
        {"group": "lengths", "symbol": "z"}
      ]
    }
  ]
}
)json";

LoadedProject parse(const std::string& text) {
    return parse_project(text, std::filesystem::path(COVARIA_SOURCE_DIR) / "tests/data/projects",
                         "test.covaria");
}

std::string changed(const std::string& from, const std::string& to) {
    std::string text = whole_project;
    const auto at = text.find(from);
    if (at == std::string::npos) {
        ADD_FAILURE() << "the test's project has no '" << from << "'";
        return text;
    }
    return text.replace(at, from.size(), to);
}

Problem problem_with(const Problems& problems, const std::string& words) {
    std::string all = "no such problem; there are:";
    for (const Problem& problem : problems.items()) {
        if (problem.message.english().find(words) != std::string::npos) return problem;
        all += "\n  " + problem.path + ": " + problem.message.english();
    }
    return {Severity::warning, "", all, "", -1};
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

void put_bytes(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace test

}  // namespace covaria
