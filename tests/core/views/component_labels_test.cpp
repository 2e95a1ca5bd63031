// Names of components of uncertainty beside each other.
#include "core/views/component_labels.h"

#include <gtest/gtest.h>

#include "core/text/symbol.h"

namespace covaria::component_labels_test {
namespace {

BudgetComponent shared(const std::string& id, const std::string& owner) {
    BudgetComponent component;
    component.id = id;
    component.name = Message::declared("scale");
    component.owner = owner;
    component.quantities = {"d_1", "d_2"};
    return component;
}

std::vector<std::string> labels_of(const std::vector<BudgetComponent>& components) {
    std::vector<const BudgetComponent*> given;
    for (const BudgetComponent& component : components) given.push_back(&component);
    std::vector<std::string> words;
    for (const Text& label : component_labels(given, DocumentLanguage{})) words.push_back(to_unicode(label));
    return words;
}

using Labels = std::vector<std::string>;

TEST(ComponentLabels, SayWhoseTheyAreByNameWhereTheyAreAlike) {
    EXPECT_EQ(labels_of({shared("tracker-1.scale", "Tracker north")}), Labels{"scale"});
    EXPECT_EQ(
        labels_of({shared("tracker-1.scale", "Tracker north"), shared("tracker-2.scale", "Tracker south")}),
        (Labels{"Tracker north: scale", "Tracker south: scale"}));
}

TEST(ComponentLabels, OwnersOfOneNameAreToldApartById) {
    EXPECT_EQ(labels_of({shared("one.scale", "Tracker"), shared("two.scale", "Tracker")}),
              (Labels{"one: scale", "two: scale"}));
    EXPECT_EQ(labels_of({shared("one.scale", ""), shared("two.scale", "")}),
              (Labels{"one: scale", "two: scale"}));
}

}  // namespace
}  // namespace covaria::component_labels_test
