// The kinds of input that are fuzzed, and the damage that is done to them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace covaria::fuzz {

using Json = nlohmann::ordered_json;

/// Marsaglia's xorshift64: the same inputs on every machine. Input n of a seed needs none before it.
class Noise {
public:
    Noise(std::uint64_t seed, std::uint64_t input)
        : state_((seed + 1) * 0x9E3779B97F4A7C15 ^ (input + 1) * 0xBF58476D1CE4E5B9) {
        for (int i = 0; i < 8; ++i) next();
    }
    std::uint64_t next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 7;
        state_ ^= state_ << 17;
        return state_;
    }
    std::size_t below(std::size_t limit) { return limit == 0 ? 0 : static_cast<std::size_t>(next() % limit); }
    bool chance(std::size_t one_in) { return below(one_in) == 0; }
    template <class Items>
    const auto& pick(const Items& items) {
        return *(std::begin(items) + static_cast<std::ptrdiff_t>(below(std::size(items))));
    }

private:
    std::uint64_t state_;
};

/// Changes bytes: flips, cuts, repeats, swaps and puts in words of `words`.
std::string damaged_text(std::string text, const std::vector<std::string>& words, Noise& noise);
/// Changes values: other numbers, texts and kinds, rows and keys left out, repeated and swapped.
void damage(Json& document, Noise& noise);

/// The fate of one input.
struct Outcome {
    bool accepted = false;
    bool evaluated = false;
    std::string complaint = {};  ///< a fault of the program: an error without a place, a defect that was met
};

/// One kind of input.
class Kind {
public:
    virtual ~Kind() = default;
    virtual std::string make(Noise& noise) = 0;
    virtual Outcome run(const std::string& input) = 0;
};

std::string file_text(const std::filesystem::path& file);
std::unique_ptr<Kind> project_kind();
std::unique_ptr<Kind> equation_kind();
std::unique_ptr<Kind> csv_kind();
std::unique_ptr<Kind> urdf_kind();
std::unique_ptr<Kind> stl_kind();
std::unique_ptr<Kind> reader_kind();

}  // namespace covaria::fuzz
