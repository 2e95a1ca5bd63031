// The elements of a Digital Calibration Certificate that occur everywhere: names, texts.
#pragma once

#include <pugixml.hpp>
#include <string>

namespace covaria {

/// As one line of an XML text: what XML cannot have is left out, no blanks at its ends.
std::string xml_line(const std::string& text);
/// <element>text</element>
pugi::xml_node add_text(pugi::xml_node parent, const char* element, const std::string& text);
/// <dcc:name> in English.
void add_name(pugi::xml_node parent, const std::string& name);
/// A <dcc:content> for each line that is not blank, in English.
void add_contents(pugi::xml_node parent, const std::string& lines);
/// With an element on each line.
std::string text_of(const pugi::xml_document& document);

}  // namespace covaria
