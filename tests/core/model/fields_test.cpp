// Fields declared once and bound to members: schema, reading and places agree.
#include "core/setup/fields.h"

#include <gtest/gtest.h>

#include "core/model/offered.h"

namespace covaria::fields_test {
namespace {

struct Lamp : Capability {
    static constexpr const char* capability = "light";
    double candela = 7.0;
};
struct Plug : Capability {
    static constexpr const char* capability = "current";
    static constexpr const char* lacking = "has no plug";
};
struct LampAsset : Asset, Lamp {
    LampAsset() { offer(*this); }
};
struct DarkAsset : Asset {};

enum class Way { near, far };

struct Stated {
    struct Row {
        std::string name;
        std::optional<double> u;
        Way way = Way::near;
        Eigen::Vector3d p = Eigen::Vector3d::Zero();
        bool held = false;
    };
    double length = 0.0;
    int count = 0;
    Way way = Way::near;
    double only_far = -1.0;
    Unit unit;
    std::optional<double> extra;
    Offered<Lamp> lamp;
    std::vector<Row> rows;
};

const std::vector<ChoiceOf<Way>> ways{{Way::near, "near", "close by"}, {Way::far, "far", "far away"}};

Columns<Stated::Row> columns() {
    const Unit mm = Unit::of("mm");
    return Columns<Stated::Row>()
        .add(&Stated::Row::name, {.key = "name", .title = "name"})
        .add(&Stated::Row::u, {.key = "u", .title = "u", .unit = mm, .optional = true})
        .choice(&Stated::Row::way, "way", "way", "h", ways, {.optional = true})
        .each(&Stated::Row::p, std::array{ColumnSpec{.key = "x", .title = "x", .unit = mm},
                                          ColumnSpec{.key = "y", .title = "y", .unit = mm},
                                          ColumnSpec{.key = "z", .title = "z", .unit = mm}})
        .add(&Stated::Row::held, {.key = "held", .title = "held"});
}

Fields<Stated> declared() {
    Fields<Stated> fields;
    fields.add(&Stated::length, "length", "Length", "h", {.unit = Unit::of("mm")})
        .add(&Stated::count, "n", "Count", "h", {.default_value = Quantity{3.0, Unit{}}})
        .choice(&Stated::way, "way", "Way", "h", ways, Way::near)
        .add(&Stated::only_far, "far", "Far", "h", {.default_value = Quantity{4.0, Unit{}}})
        .add(&Stated::unit, "unit", "Unit", "h", {.default_value = std::string("1")})
        .add(&Stated::extra, "extra", "Extra", "h", {.optional = true})
        .add(&Stated::lamp, "lamp", "Lamp", "h", {.optional = true})
        .table(&Stated::rows, "table", "Table", "h", columns(), {.optional = true})
        .shown_where(&Stated::way, {Way::far}, &Stated::only_far);
    return fields;
}

struct FieldsTest : testing::Test {
    Stated read() {
        check_setup(schema, setup, problems);
        EXPECT_FALSE(problems.has_errors())
            << (problems.items().empty() ? "" : problems.items()[0].message.english());
        return fields.read(SetupReader(schema, setup), assets, problems);
    }
    Fields<Stated> fields = declared();
    SetupSchema schema = fields.schema();
    covaria::Setup setup{{{"length", Quantity{20.0, Unit::of("cm")}}}};
    AssetLibrary assets;
    Problems problems;
};

TEST_F(FieldsTest, TheKindOfAFieldFollowsFromItsMember) {
    const FieldKind kinds[] = {FieldKind::number, FieldKind::integer, FieldKind::choice,    FieldKind::number,
                               FieldKind::text,   FieldKind::number,  FieldKind::reference, FieldKind::table};
    ASSERT_EQ(schema.fields().size(), std::size(kinds));
    for (std::size_t i = 0; i < std::size(kinds); ++i) EXPECT_EQ(schema.fields()[i].kind, kinds[i]) << i;
    EXPECT_EQ(schema.find("lamp")->capabilities, std::vector<std::string>{"light"});
    EXPECT_EQ(schema.find("way")->choices[1].title, "far away");
    EXPECT_EQ(std::get<std::string>(schema.find("way")->default_value), "near");
    EXPECT_EQ(schema.find("far")->shown_if->values, std::vector<std::string>{"far"});
    EXPECT_EQ(schema.find("table")->columns[3].key, "x");
    EXPECT_EQ(schema.find("table")->columns[6].kind, FieldKind::flag);
}

TEST_F(FieldsTest, ReadsWhatIsGivenInSiAndElseTheDefaults) {
    const Stated plain = read();
    EXPECT_DOUBLE_EQ(plain.length, 0.2);
    EXPECT_EQ(plain.count, 3);
    EXPECT_EQ(plain.only_far, 4.0);
    EXPECT_FALSE(plain.extra || plain.lamp);
    setup.values["extra"] = Quantity{2.0, Unit{}};
    setup.values["n"] = Quantity{8.0, Unit{}};
    setup.values["unit"] = std::string("mm");
    setup.values["far"] = Quantity{5.0, Unit{}};
    EXPECT_EQ(read().only_far, 4.0) << "what is not shown is not used";
    setup.values["way"] = std::string("far");
    const Stated given = read();
    EXPECT_EQ(given.extra, 2.0);
    EXPECT_EQ(given.count, 8);
    EXPECT_EQ(given.unit, Unit::of("mm"));
    EXPECT_EQ(given.way, Way::far);
    EXPECT_EQ(given.only_far, 5.0);
}

TEST_F(FieldsTest, RowsAreStructs) {
    const Unit um = Unit::of("um"), one;
    setup.values["table"] = SetupTable{{one, um, one, um, um, um, one},
                                       {{std::string("a"), 5.0, std::string("far"), 1e6, 2e6, 3e6, true},
                                        {std::string("b"), {}, {}, 0.0, 0.0, 1e6}}};
    const Stated given = read();
    ASSERT_EQ(given.rows.size(), 2u);
    EXPECT_EQ(given.rows[0].name, "a");
    EXPECT_NEAR(*given.rows[0].u, 5e-6, 1e-20);
    EXPECT_EQ(given.rows[0].way, Way::far);
    EXPECT_NEAR((given.rows[0].p - Eigen::Vector3d(1.0, 2.0, 3.0)).norm(), 0.0, 1e-15);
    EXPECT_TRUE(given.rows[0].held);
    EXPECT_FALSE(given.rows[1].u || given.rows[1].held);
    EXPECT_EQ(given.rows[1].way, Way::near);
}

TEST_F(FieldsTest, PlacesAreThoseOfTheFile) {
    EXPECT_EQ(fields.place(&Stated::count), "/n");
    EXPECT_EQ(fields.place(&Stated::rows, 2), "/table/rows/2");
    EXPECT_EQ(fields.place(&Stated::rows, 2, &Stated::Row::u), "/table/rows/2/u");
    setup.values["unit"] = std::string("cubits");
    read();
    ASSERT_EQ(problems.items().size(), 1u);
    EXPECT_EQ(problems.items()[0].path, "/unit");
    struct Other {
        int undeclared = 0;
    };
    EXPECT_THROW((void)Fields<Other>().place(&Other::undeclared), std::logic_error);
}

TEST_F(FieldsTest, AReferenceIsTheCapability) {
    assets.add("one", {.name = "desk lamp", .asset = std::make_shared<LampAsset>()});
    assets.add("dark", {.name = "", .asset = std::make_shared<DarkAsset>()});
    setup.values["lamp"] = std::string("one");
    const Stated given = read();
    ASSERT_TRUE(given.lamp);
    EXPECT_EQ(given.lamp->candela, 7.0);
    EXPECT_EQ(given.lamp.id, "one");
    EXPECT_EQ(given.lamp.name, "desk lamp");
    for (const std::string id : {"dark", "nobody"}) {
        problems = {};
        setup.values["lamp"] = id;
        EXPECT_FALSE(read().lamp);
        ASSERT_EQ(problems.items().size(), 1u);
        EXPECT_EQ(problems.items()[0].path, "/lamp");
        EXPECT_EQ(problems.items()[0].message.english(), "'" + id + "' does not offer 'light'");
    }
}

struct Spread {
    std::array<double, 2> u{};
    bool shared = false;
    double only_shared = 0.0;
};

Fields<Spread> spread_fields() {
    const auto figure = [](const char* key) {
        return FieldSpec{.key = key, .title = key, .help = "h", .unit = Unit::of("mm"), .optional = true};
    };
    return Fields<Spread>()
        .section("Spread")
        .each(&Spread::u, std::array{figure("u_x"), figure("u_y")})
        .choice(&Spread::shared, "shared", "Shared", "h",
                {{false, "alone", "alone"}, {true, "all", "by all"}}, false)
        .add(&Spread::only_shared, "weight", "Weight", "h", {.default_value = Quantity{2.0, Unit{}}})
        .shown_where(&Spread::shared, {true}, &Spread::only_shared);
}

struct Whole {
    struct Row {
        std::string name;
        Spread spread;
    };
    bool given = true;
    Spread spread;
    Offered<Plug> plug;
    std::vector<Row> rows;
};

Fields<Whole> whole_fields() {
    const auto column = [](const char* key) { return ColumnSpec{.key = key, .title = key}; };
    return Fields<Whole>()
        .section("All")
        .add(&Whole::given, "given", "Given", "h", {.default_value = true})
        .part(&Whole::spread, spread_fields())
        .add(&Whole::plug, "plug", "Plug", "h", {.optional = true})
        .table(&Whole::rows, "rows", "Rows", "h",
               Columns<Whole::Row>()
                   .add(&Whole::Row::name, "name", "name", "h")
                   .part(&Whole::Row::spread,
                         Columns<Spread>().each(&Spread::u, std::array{column("p"), column("q")})),
               {.optional = true})
        .shown_where(&Whole::given, {true}, &Whole::spread);
}

TEST(Columns, AlikeByAxis) {
    const auto columns =
        by_axis({"u_x", "u_y", "u_z"}, "Along *.", {.unit = Unit::of("mm"), .optional = true});
    EXPECT_EQ(columns[1].key, "u_y");
    EXPECT_EQ(columns[1].title, "u_y");
    EXPECT_EQ(columns[1].help, "Along y.");
    EXPECT_EQ(columns[2].unit, Unit::of("mm"));
    EXPECT_TRUE(columns[2].optional);
    EXPECT_EQ(by_axis(zyx_angles, "Of all.", {})[2].help, "Of all.");
}

struct Pairs {
    std::array<double, 2> u{};
    std::array<bool, 2> common{};
    Referred asset;
};

// Elements of two arrays in turn, and a reference whose field says what is to be offered.
Fields<Pairs> pair_fields() {
    Fields<Pairs> fields;
    for (std::size_t i = 0; i < 2; ++i)
        fields
            .element(&Pairs::u, i,
                     {.key = "u_" + std::to_string(i),
                      .title = "u",
                      .help = "h",
                      .unit = Unit::of("mm"),
                      .default_value = Quantity{1.0 + static_cast<double>(i), Unit::of("mm")}})
            .element(
                &Pairs::common, i,
                {.key = "common_" + std::to_string(i), .title = "c", .help = "h", .default_value = i == 1});
    return fields.add(&Pairs::asset, {.key = "asset",
                                      .title = "a",
                                      .help = "h",
                                      .optional = true,
                                      .capabilities = {Lamp::capability, Plug::capability}});
}

TEST(Fields, ElementsOfArraysInTurn) {
    const SetupSchema schema = pair_fields().schema();
    EXPECT_EQ(schema.keys(), (std::vector<std::string>{"u_0", "common_0", "u_1", "common_1", "asset"}));
    EXPECT_EQ(schema.fields()[3].kind, FieldKind::flag);
    covaria::Setup setup;
    setup.values["u_0"] = Quantity{5.0, Unit::of("um")};
    Problems problems;
    const Pairs read = pair_fields().read(SetupReader(schema, setup), {}, problems);
    EXPECT_TRUE(problems.empty());
    EXPECT_DOUBLE_EQ(read.u[0], 5e-6);
    EXPECT_DOUBLE_EQ(read.u[1], 2e-3);
    EXPECT_FALSE(read.common[0]);
    EXPECT_TRUE(read.common[1]);
    EXPECT_EQ(pair_fields().key(&Pairs::asset), "asset");
}

TEST(Fields, ReferToWhatOffersOneOfSeveral) {
    const SetupSchema schema = pair_fields().schema();
    EXPECT_EQ(schema.fields()[4].kind, FieldKind::reference);
    EXPECT_EQ(schema.fields()[4].capabilities, (std::vector<std::string>{"light", "current"}));
    AssetLibrary assets;
    assets.add("lamp", {"Big lamp", nullptr, std::make_shared<LampAsset>()});
    assets.add("broken", {"", nullptr, nullptr});
    covaria::Setup setup;
    Problems problems;
    for (const auto& [id, name, made] : {std::tuple{"lamp", "Big lamp", true}, {"broken", "broken", false}}) {
        setup.values["asset"] = std::string(id);
        const Pairs read = pair_fields().read(SetupReader(schema, setup), assets, problems);
        EXPECT_EQ(read.asset.id, id);
        EXPECT_EQ(read.asset.name, name);
        EXPECT_EQ(read.asset.asset != nullptr, made);
    }
    EXPECT_TRUE(problems.empty());
}

TEST(PartsOfFields, AreFieldsOfTheWhole) {
    const SetupSchema schema = whole_fields().schema();
    EXPECT_EQ(schema.keys(),
              (std::vector<std::string>{"given", "u_x", "u_y", "shared", "weight", "plug", "rows"}));
    EXPECT_EQ(schema.find("given")->section, "All");
    for (const char* const key : {"u_x", "u_y", "weight"}) EXPECT_EQ(schema.find(key)->section, "Spread");
    EXPECT_EQ(schema.find("plug")->section, "All");
    EXPECT_EQ(schema.find("u_x")->shown_if->key, "given");
    EXPECT_EQ(schema.find("u_y")->shown_if->values, std::vector<std::string>{"true"});
    EXPECT_EQ(schema.find("weight")->shown_if->key, "shared") << "its own condition stays";
    EXPECT_EQ(schema.find("weight")->shown_if->values, std::vector<std::string>{"all"}) << "the choice's key";
    EXPECT_EQ(schema.find("rows")->columns[2].key, "q");
}

TEST(PartsOfFields, AreReadIntoTheirStruct) {
    const Unit mm = Unit::of("mm"), one;
    const SetupSchema schema = whole_fields().schema();
    const covaria::Setup setup{{{"u_y", Quantity{3.0, mm}},
                                {"shared", std::string("all")},
                                {"plug", std::string("nobody")},
                                {"rows", SetupTable{{one, one, one}, {{std::string("a"), 5.0, 6.0}}}}}};
    Problems problems;
    check_setup(schema, setup, problems);
    EXPECT_TRUE(problems.items().empty());
    const Whole read = whole_fields().read(SetupReader(schema, setup), {}, problems);
    EXPECT_EQ(read.spread.u[0], 0.0);
    EXPECT_DOUBLE_EQ(read.spread.u[1], 3e-3);
    EXPECT_TRUE(read.spread.shared);
    EXPECT_EQ(read.spread.only_shared, 2.0);
    ASSERT_EQ(read.rows.size(), 1u);
    EXPECT_EQ(read.rows[0].spread.u, (std::array{5.0, 6.0}));
    ASSERT_EQ(problems.items().size(), 1u);
    EXPECT_EQ(problems.items()[0].message.english(), "'nobody' has no plug");
}

}  // namespace
}  // namespace covaria::fields_test
