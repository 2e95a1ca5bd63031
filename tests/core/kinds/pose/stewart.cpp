// Assets for tests of models.
#include "tests/core/kinds/pose/stewart.h"

#include <stdexcept>

#include "core/kinds/registries.h"

namespace covaria::stewart {

AssetLibrary library_of(const std::string& kind, const Setup& s) {
    const AssetDescriptor* d = find_asset_kind(kind);
    Problems problems;
    check_setup(d->schema, s, problems);
    std::shared_ptr<const Asset> asset;
    if (!problems.has_errors()) asset = d->create(SetupReader(d->schema, s), {}, problems);
    if (!asset)
        throw std::runtime_error(problems.items().front().path + ": " +
                                 problems.items().front().message.english());
    AssetLibrary library;
    library.add("a", {"the " + kind, d, asset});
    return library;
}

}  // namespace covaria::stewart
