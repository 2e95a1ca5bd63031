// The texts of a scene, and a language by which one can tell which of them went through it.
#pragma once

#include <string>
#include <vector>

#include "core/text/document_language.h"
#include "viz/scene/scene.h"

namespace covaria::test {

/// Words after a mark; numbers with a comma.
inline DocumentLanguage marking_language() {
    return {"xx", {","}, [](const std::string& english) { return "#" + english; }};
}

/// Caption, legend, title of the map; without names and numbers.
inline std::vector<std::string> words_of(const Scene& scene) {
    std::vector<std::string> texts;
    if (!scene.caption.empty()) texts.push_back(scene.caption);
    for (const LegendLine& line : scene.legend) texts.push_back(to_unicode(line.text));
    return texts;
}

inline std::string joined(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += text + "\n";
    return all;
}

}  // namespace covaria::test
