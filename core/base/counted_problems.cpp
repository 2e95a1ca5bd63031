#include "core/base/counted_problems.h"

#include <algorithm>
#include <map>

namespace covaria {

namespace {

// The path with row numbers left out. The number of an asset or analysis tells kinds apart.
std::string kind_of(const Problem& problem) {
    std::string kind = (problem.severity == Severity::error ? "e" : "w") + problem.file + ":";
    const std::string& path = problem.path;
    for (std::size_t at = 0; at < path.size();) {
        const std::size_t end = std::min(path.find('/', at + 1), path.size());
        const bool number = end > at + 1 && path.find_first_not_of("0123456789-", at + 1) >= end;
        const bool entry = kind.ends_with("/assets") || kind.ends_with("/analyses");
        if (number && !entry)
            kind += "/#";
        else
            kind.append(path, at, end - at);
        at = end;
    }
    return kind;
}

struct Kind {
    std::size_t found = 0;
    Problem next = {};  ///< the first that is not listed
};

}  // namespace

Message counted_words(std::size_t more) {
    return tell<"and %1 more like these">(more);
}

void count_beyond_a_hundred(Problems& problems) {
    std::map<std::string, Kind> kinds;
    Problems listed;
    for (Problem& problem : problems.items()) {
        Kind& kind = kinds[kind_of(problem)];
        if (++kind.found <= most_of_a_kind)
            listed.add(std::move(problem));
        else if (kind.found == most_of_a_kind + 1)
            kind.next = std::move(problem);
    }
    for (auto& [name, kind] : kinds) {
        if (kind.found <= most_of_a_kind) continue;
        kind.next.message = counted_words(kind.found - most_of_a_kind);
        listed.add(std::move(kind.next));
    }
    problems = std::move(listed);
}

}  // namespace covaria
