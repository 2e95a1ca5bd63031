#include "core/writers/dcc_xml.h"

#include <algorithm>
#include <sstream>

#include "core/readers/entry_texts.h"

namespace covaria {

namespace {

void add_content(pugi::xml_node parent, const std::string& text) {
    add_text(parent, "dcc:content", text).append_attribute("lang") = "en";
}

}  // namespace

std::string xml_line(const std::string& text) {
    std::string line = plain_line(text);
    for (const char* none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})  // the code points U+FFFE and U+FFFF
        for (std::size_t at = line.find(none); at != std::string::npos; at = line.find(none, at))
            line.replace(at, 3, "?");
    return line;
}

pugi::xml_node add_text(pugi::xml_node parent, const char* element, const std::string& text) {
    pugi::xml_node node = parent.append_child(element);
    node.append_child(pugi::node_pcdata).set_value(text.c_str());
    return node;
}

void add_name(pugi::xml_node parent, const std::string& name) {
    add_content(parent.append_child("dcc:name"), name);
}

void add_contents(pugi::xml_node parent, const std::string& lines) {
    std::istringstream in(lines);
    for (std::string line; std::getline(in, line);)
        if (const std::string plain = xml_line(line); !plain.empty()) add_content(parent, plain);
}

std::string text_of(const pugi::xml_document& document) {
    std::ostringstream out;
    document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
    return out.str();
}

}  // namespace covaria
