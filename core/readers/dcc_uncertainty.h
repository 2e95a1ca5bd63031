// The statement of uncertainty of a value in D-SI, in any version.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/readers/stated_quantities.h"

namespace covaria {

/// Elements of a list as texts, "1.5 2.5", where one may stand for all.
struct TextList {
    std::vector<std::string> items;
    explicit TextList(const std::string& text);
    bool fits(std::size_t n) const { return items.empty() || items.size() == 1 || items.size() == n; }
    std::string at(std::size_t i) const {
        return items.empty() ? "" : items.size() == 1 ? items[0] : items.at(i);
    }
};

/// The element that states an uncertainty of each value; names of lists end in XMLList.
struct DccStatement {
    pugi::xml_node node;  ///< empty where nothing is stated
    TextList expanded{""}, factor{""}, probability{""}, standard{""}, distribution{""};
    bool interval = false;
    bool fits(std::size_t n) const;
};
/// The statement of a real value or of a list of them.
DccStatement dcc_statement_of(const pugi::xml_node& value);

/// Gives the quantity the i-th uncertainty; returns remarks on the parts that are not taken over. Error:
/// figures that are no numbers or out of range.
Result<std::vector<std::string>> state_uncertainty(const DccStatement& statement, std::size_t i,
                                                   StatedQuantity& quantity);

}  // namespace covaria
