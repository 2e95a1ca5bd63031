#include "core/readers/unstated_units.h"

#include <algorithm>

#include "core/base/in_quotes.h"
#include "core/setup/message_text.h"

namespace covaria {

Unit unstated_unit(const ReadChoice& choice, const std::string& key, const std::string& title,
                   const Unit& otherwise, Proposals& proposals) {
    const auto stated = choice.units.find(key);
    const Unit unit = stated == choice.units.end() ? otherwise : stated->second;
    const bool listed = std::any_of(proposals.unstated.begin(), proposals.unstated.end(),
                                    [&](const UnstatedUnit& u) { return u.key == key; });
    if (!listed) proposals.unstated.push_back({key, title, unit});
    return unit;
}

Result<void> check_stated_units(const ReadChoice& choice, const Proposals& proposals) {
    for (const auto& [key, unit] : choice.units) {
        std::vector<std::string> keys;
        for (const UnstatedUnit& unstated : proposals.unstated) keys.push_back(unstated.key);
        if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
        return fail(ErrorCode::usage,
                    tell<"no unit can be stated for %1%2">(
                        in_quotes(key), (keys.empty() ? ": the file states all its units"
                                                      : did_you_mean(key, keys) +
                                                            "; the file states none for " + listed(keys))));
    }
    return {};
}

}  // namespace covaria
