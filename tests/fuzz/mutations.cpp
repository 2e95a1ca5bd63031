#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/fuzz/fuzz.h"

namespace covaria::fuzz {

namespace {

const std::vector<double> numbers{0.0,
                                  -0.0,
                                  1.0,
                                  -1.0,
                                  2.0,
                                  0.5,
                                  1e-9,
                                  1e-30,
                                  1e-160,
                                  1e-308,
                                  5e-324,
                                  1e6,
                                  1e15,
                                  1e30,
                                  1e60,
                                  1e99,
                                  1e101,
                                  1e155,
                                  1e160,
                                  1e300,
                                  1e308,
                                  -1e160,
                                  -1e308,
                                  90.0,
                                  180.0,
                                  -90.0,
                                  3.1415926535897931,
                                  1.5707963267948966,
                                  2147483647.0,
                                  2147483648.0,
                                  1e19,
                                  0.95,
                                  1.0000000000000002};
const std::vector<std::string> texts{
    "",     " ",    "x",     "y",      "-1", "1e5",      "a b",  "\xCE\xB1", "\xE5\xB7\xA6",
    "=1+1", "../x", "/",     "m",      "mm", "kg*m/s^2", "degC", "rad",      "1",
    "true", "<b>",  "a_1,2", "normal", "\t", "\n",       "x.1"};

void number_damage(Json& value, Noise& noise) {
    const double now = value.get<double>();
    switch (noise.below(6)) {
        case 0:
            value = -now;
            break;
        case 1:
            value = now * 1e3;
            break;
        case 2:
            value = now * 1e-6;
            break;
        case 3:
            value = now + 1.0;
            break;
        default:
            value = noise.pick(numbers);
            break;
    }
}

void list_damage(Json& list, Noise& noise) {
    const auto at = [&] { return list.begin() + static_cast<std::ptrdiff_t>(noise.below(list.size())); };
    switch (noise.below(5)) {
        case 0:
            list.erase(at());
            break;
        case 1:
            list.push_back(Json(*at()));
            break;
        case 2:
            std::swap(*at(), *at());
            break;
        case 3:
            *at() = Json(*at());
            break;
        default:
            list = Json::array();
            break;
    }
}

void object_damage(Json& object, Noise& noise) {
    auto member = object.begin();
    std::advance(member, static_cast<std::ptrdiff_t>(noise.below(object.size())));
    switch (noise.below(4)) {
        case 0:
            object.erase(member.key());
            break;
        case 1:
            object[noise.pick(texts)] = Json(member.value());
            break;
        case 2:
            member.value() = nullptr;
            break;
        default:
            std::swap(member.value(), object.begin().value());
            break;
    }
}

void other_kind(Json& value, Noise& noise) {
    switch (noise.below(6)) {
        case 0:
            value = noise.pick(numbers);
            break;
        case 1:
            value = noise.pick(texts);
            break;
        case 2:
            value = nullptr;
            break;
        case 3:
            value = noise.chance(2);
            break;
        case 4:
            value = Json::array();
            break;
        default:
            value = Json::object();
            break;
    }
}

void collect(Json& value, std::vector<Json*>& all) {
    all.push_back(&value);
    if (value.is_structured())
        for (auto& inner : value) collect(inner, all);
}

}  // namespace

void damage(Json& document, Noise& noise) {
    for (std::size_t count = 1 + noise.below(3); count > 0; --count) {
        std::vector<Json*> all;
        collect(document, all);
        Json& value = *noise.pick(all);
        if (noise.chance(12))
            other_kind(value, noise);
        else if (value.is_number())
            number_damage(value, noise);
        else if (value.is_boolean())
            value = !value.get<bool>();
        else if (value.is_string()) {
            const Json& other = *noise.pick(all);
            value = other.is_string() && !noise.chance(3) ? Json(other) : Json(noise.pick(texts));
        } else if (value.is_array() && !value.empty())
            list_damage(value, noise);
        else if (value.is_object() && !value.empty())
            object_damage(value, noise);
    }
}

std::string damaged_text(std::string text, const std::vector<std::string>& words, Noise& noise) {
    for (std::size_t count = 1 + noise.below(4); count > 0; --count) {
        const std::size_t at = noise.below(text.size() + 1), length = noise.below(noise.chance(8) ? 200 : 8);
        switch (noise.below(6)) {
            case 0:
                if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << noise.below(8)));
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(noise.below(text.size() + 1), length));
                break;
            case 3:
                if (at < text.size()) text[at] = static_cast<char>(noise.below(256));
                break;
            default:
                text.insert(at, noise.pick(words));
                break;
        }
    }
    return text;
}

std::string file_text(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

}  // namespace covaria::fuzz
