#include "core/made/examples.h"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"

namespace covaria {
namespace {

/// First sentence of the first line; the full stop after an initial ("M. C. Porath") ends nothing.
std::string first_sentence(const std::string& text) {
    const std::string line = text.substr(0, text.find('\n'));
    const auto is_letter = [&](std::size_t at) {
        return std::isalpha(static_cast<unsigned char>(line[at])) != 0;
    };
    for (std::size_t at = line.find(". "); at != std::string::npos; at = line.find(". ", at + 1)) {
        const bool after_initial = at > 0 && std::isupper(static_cast<unsigned char>(line[at - 1])) != 0 &&
                                   (at == 1 || !is_letter(at - 2));
        if (!after_initial) return line.substr(0, at + 1);
    }
    return line;
}

}  // namespace

std::vector<Example> shipped_examples(const std::string& subfolder) {
    std::vector<Example> examples;
    std::error_code unreadable;
    const std::filesystem::path folder = data_directory() / "projects" / subfolder;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
        if (entry.path().extension() != ".covaria") continue;
        const LoadedProject loaded = load_project(entry.path());
        if (loaded.problems.has_errors()) continue;
        std::filesystem::path picture = entry.path();
        examples.push_back({entry.path(), loaded.project.title, first_sentence(loaded.project.notes),
                            picture.replace_extension(".png")});
    }
    std::ranges::sort(examples, {}, &Example::file);
    return examples;
}

}  // namespace covaria
