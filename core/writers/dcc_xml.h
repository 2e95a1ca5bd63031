// The elements of a Digital Calibration Certificate that occur everywhere: names, texts.
#pragma once

#include <pugixml.hpp>
#include <string>

namespace covaria {

/// The text as one line of an XML text: signs that XML cannot have are left out, and blanks at its ends.
std::string xml_line(const std::string& text);
/// Adds <element>text</element>.
pugi::xml_node add_text(pugi::xml_node parent, const char* element, const std::string& text);
/// Adds <dcc:name> in English.
void add_name(pugi::xml_node parent, const std::string& name);
/// Adds a <dcc:content> for each line that is not blank, in English.
void add_contents(pugi::xml_node parent, const std::string& lines);
/// The text of a document with an element on each line.
std::string text_of(const pugi::xml_document& document);

}  // namespace covaria
