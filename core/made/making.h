// Common ground of making assets and making analyses; internal to core/made.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/guarded.h"
#include "core/made/made_entry.h"
#include "core/project/entry_graph.h"

namespace covaria::making {

using Uses = std::vector<std::shared_ptr<const MadeEntry>>;

/// Whether they are the same as before. A missing one may have other words now: it never stays.
bool stay(const Uses& uses, const Uses& before);

/// Adds references that lead back to the entry, with their way, to the problems of its set-up.
void refuse_circles(const Project& project, const std::vector<EntryReference>& references,
                    Problems& problems);
/// Adds references to what does not exist, has errors of its own, or does not offer what is wanted.
void check_uses(const Project& project, const std::vector<EntryReference>& references, const Uses& uses,
                Problems& problems);

/// The result of `make`; an exception is a problem of the set-up that it was made of.
template <class Make>
auto made_or_problem(const std::string& path, Problems& problems, Make&& make) {
    auto made = guarded(make);
    if (!made) problems.error(path, made.error().message);
    return made ? *std::move(made) : std::invoke_result_t<Make>{};
}

}  // namespace covaria::making
