// Capability of an asset for a model: an interface of its own, found by its type and listed nowhere.
#pragma once

namespace covaria {

/// Base of the interfaces that models ask for (`offers<SensorSource>(asset)`, core/model/asset.h). Each has a
/// constant `capability`: the word that descriptors, reference fields and messages have for it.
class Capability {
public:
    virtual ~Capability() = default;
    Capability() = default;
    Capability(const Capability&) = default;
    Capability& operator=(const Capability&) = default;
};

}  // namespace covaria
