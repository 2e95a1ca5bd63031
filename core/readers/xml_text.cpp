#include "core/readers/xml_text.h"

#include "core/project/csv_reader.h"

namespace covaria {

Result<XmlText> XmlText::parse(const std::string& text) {
    if (text.size() > largest_xml)
        return refused_at(1, tell<"XML of more than %1 MB is not read">(largest_xml / 1'000'000));
    XmlText xml(text);
    const pugi::xml_parse_result parsed =
        xml.document_.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_doctype);
    for (const pugi::xml_node& node : xml.document_.children())
        if (node.type() == pugi::node_doctype)
            return xml.refused(
                node, tell<"a document type declaration: files that declare entities are not read">());
    if (!parsed)
        return refused_at(xml.places_.line(parsed.offset), xml.places_.column(parsed.offset),
                          tell<"not readable as XML: %1">(parsed.description()));
    return xml;
}

std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child_called(const pugi::xml_node& node, std::string_view name) {
    for (const pugi::xml_node& child : node.children())
        if (local_name(child) == name) return child;
    return {};
}

std::string trimmed_text(const pugi::xml_node& node) {
    const std::string_view text = node.child_value();
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t begin = text.find_first_not_of(blanks), end = text.find_last_not_of(blanks);
    return begin == std::string_view::npos ? std::string() : std::string(text.substr(begin, end - begin + 1));
}

std::string text_of_child(const pugi::xml_node& node, std::string_view name) {
    return trimmed_text(child_called(node, name));
}

std::optional<double> number_in_text(std::string text) {
    return csv_number(std::move(text), false);
}

pugi::xml_node next_element(const pugi::xml_node& node, const pugi::xml_node& top, bool skip) {
    if (!skip && node.first_child()) return node.first_child();
    for (pugi::xml_node at = node; at && at != top; at = at.parent())
        if (const pugi::xml_node next = at.next_sibling()) return next;
    return {};
}

}  // namespace covaria
