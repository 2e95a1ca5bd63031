// XML of others: parsed without entities, with the places of its elements.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text_places.h"

namespace covaria {

/// The most bytes of a text: the nodes of short elements take twenty times as much.
inline constexpr std::size_t largest_xml = 40'000'000;

class XmlText {
public:
    /// Parses a text. Error with line and column: no XML; too large; a document type declaration, whose
    /// entities are never expanded.
    static Result<XmlText> parse(const std::string& text);

    pugi::xml_node root() const { return document_.document_element(); }
    int line(const pugi::xml_node& node) const { return places_.line(node.offset_debug()); }
    int column(const pugi::xml_node& node) const { return places_.column(node.offset_debug()); }
    tl::unexpected<Error> refused(const pugi::xml_node& node, const Message& message) const {
        return refused_at(line(node), column(node), message);
    }

private:
    explicit XmlText(std::string_view text) : places_(text) {}
    pugi::xml_document document_;
    TextPlaces places_;
};

/// The name without its prefix: "dcc:result" is "result".
std::string_view local_name(const pugi::xml_node& node);
/// The first child of that local name; empty if there is none.
pugi::xml_node child_called(const pugi::xml_node& node, std::string_view name);
/// The text of the first child of that name, trimmed.
std::string text_of_child(const pugi::xml_node& node, std::string_view name);
std::string trimmed_text(const pugi::xml_node& node);
/// The finite number in a text; empty where it is none.
std::optional<double> number_in_text(std::string text);
/// The next element in the order of the text that is within `top`; without the children of this one if `skip`
/// is set.
pugi::xml_node next_element(const pugi::xml_node& node, const pugi::xml_node& top, bool skip);

}  // namespace covaria
