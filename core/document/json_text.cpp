// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace ew {

using nlohmann::json;

namespace {

// Rough heap cost of a node of the tree (64-bit, with the allocator's overhead).
constexpr std::size_t kValueCost = 24;
constexpr std::size_t kArrayCost = 48;
constexpr std::size_t kObjectCost = 64;
constexpr std::size_t kKeyCost = 96;

/// Builds the tree from parse events, so that the limits hold while it grows.
class TreeBuilder {
  public:
    using number_integer_t = json::number_integer_t;
    using number_unsigned_t = json::number_unsigned_t;
    using number_float_t = json::number_float_t;
    using string_t = json::string_t;
    using binary_t = json::binary_t;

    explicit TreeBuilder(const JsonLimits& limits) : limits_(limits) {}

    bool null() { return place(json(nullptr), 0); }
    bool boolean(bool b) { return place(json(b), 0); }
    bool number_integer(number_integer_t n) { return place(json(n), 0); }
    bool number_unsigned(number_unsigned_t n) { return place(json(n), 0); }
    bool number_float(number_float_t n, const string_t&) { return place(json(n), 0); }
    bool string(string_t& s) {
        const std::size_t size = s.size();
        return place(json(std::move(s)), size + kArrayCost);
    }
    bool binary(binary_t&) { return stop(Errc::Syntax, "binary data is not allowed"); }

    bool start_object(std::size_t) { return open(json(json::value_t::object), kObjectCost); }
    bool end_object() { return close(); }
    bool start_array(std::size_t) { return open(json(json::value_t::array), kArrayCost); }
    bool end_array() { return close(); }

    bool key(string_t& k) {
        json& object = *stack_.back();
        if (!charge(kKeyCost + k.size())) return false;
        const auto [it, isNew] = object.get_ref<json::object_t&>().try_emplace(k, nullptr);
        if (!isNew)
            return stop(Errc::Syntax, "the key " + nameQuoted(k) + " comes twice in one object");
        slot_ = &it->second;
        return true;
    }

    bool parse_error(std::size_t position, const std::string&, const json::exception& problem) {
        constexpr int kOutOfRange = 406;
        if (problem.id == kOutOfRange) {
            return stop(Errc::BadValue, "a number before byte " + std::to_string(position) +
                                            " is beyond the range of numbers");
        }
        return stop(Errc::Syntax, "not valid JSON at byte " + std::to_string(position));
    }

    json root;
    Error error{Errc::Syntax, "not valid JSON", {}};

  private:
    bool stop(Errc code, std::string message) {
        error = Error{code, std::move(message), {}};
        return false;
    }

    bool charge(std::size_t bytes) {
        cost_ += bytes;
        if (cost_ <= limits_.maxTreeBytes) return true;
        return stop(Errc::TooLarge, "the file holds too many values");
    }

    json* put(json&& value) {
        if (stack_.empty()) {
            root = std::move(value);
            return &root;
        }
        json& parent = *stack_.back();
        if (parent.is_array()) {
            auto& items = parent.get_ref<json::array_t&>();
            items.push_back(std::move(value));
            return &items.back();
        }
        *slot_ = std::move(value);
        return slot_;
    }

    bool place(json&& value, std::size_t extra) {
        if (!charge(kValueCost + extra)) return false;
        put(std::move(value));
        return true;
    }

    bool open(json&& value, std::size_t extra) {
        if (static_cast<int>(stack_.size()) >= limits_.maxDepth) {
            return stop(Errc::TooDeep,
                        "nested deeper than " + std::to_string(limits_.maxDepth) + " levels");
        }
        if (!charge(kValueCost + extra)) return false;
        stack_.push_back(put(std::move(value)));
        return true;
    }

    bool close() {
        stack_.pop_back();
        return true;
    }

    const JsonLimits& limits_;
    std::vector<json*> stack_;  // stays valid: a parent does not grow while a child is open
    json* slot_ = nullptr;
    std::size_t cost_ = 0;
};

std::string typeWord(const json& value) {
    switch (value.type()) {
        case json::value_t::null:
            return "null";
        case json::value_t::object:
            return "an object";
        case json::value_t::array:
            return "a list";
        case json::value_t::string:
            return "a text";
        case json::value_t::boolean:
            return "true or false";
        default:
            return "a number";
    }
}

[[noreturn]] void throwType(const json& value, const std::string& place, const char* wanted) {
    throwRead(Errc::WrongType, place + " must be " + wanted + ", not " + typeWord(value));
}

}  // namespace

Result<json> parseJson(std::string_view text, const JsonLimits& limits) {
    if (text.size() > limits.maxBytes) {
        return fail(Errc::TooLarge,
                    "larger than " + std::to_string(limits.maxBytes >> 20U) + " MiB");
    }
    TreeBuilder builder(limits);
    if (!json::sax_parse(text.begin(), text.end(), &builder)) return fail(builder.error);
    return std::move(builder.root);
}

void throwRead(Errc code, std::string message) { throw ReadError{{code, std::move(message), {}}}; }

ObjectReader::ObjectReader(const json& value, std::string place)
    : object_(value), place_(std::move(place)) {
    if (!value.is_object()) throwType(value, place_, "an object");
}

void ObjectReader::allowOnly(std::initializer_list<std::string_view> keys) const {
    for (const auto& [key, value] : object_.items()) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
            throwRead(Errc::UnknownKey, place_ + ": unknown key " + nameQuoted(key));
        }
    }
}

const json* ObjectReader::find(const char* key) const {
    const auto it = object_.find(key);
    return it == object_.end() ? nullptr : &*it;
}

const json& ObjectReader::require(const char* key) const {
    const json* value = find(key);
    if (value == nullptr) {
        throwRead(Errc::MissingKey, place_ + ": the key \"" + key + "\" is missing");
    }
    return *value;
}

std::string ObjectReader::at(const char* key) const { return place_ + ": \"" + key + "\""; }

double readNumber(const json& value, const std::string& place) {
    if (!value.is_number()) throwType(value, place, "a number");
    return value.get<double>();
}

int readInt(const json& value, const std::string& place, int least, int most) {
    if (!value.is_number_integer()) throwType(value, place, "a whole number");
    const bool tooBig = value.is_number_unsigned() &&
                        value.get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX);
    const std::int64_t n = tooBig ? INT64_MAX : value.get<std::int64_t>();
    if (n < least || n > most) {
        throwRead(Errc::BadValue,
                  place + " must be from " + std::to_string(least) + " to " + std::to_string(most));
    }
    return static_cast<int>(n);
}

const std::string& readString(const json& value, const std::string& place) {
    if (!value.is_string()) throwType(value, place, "a text");
    return value.get_ref<const std::string&>();
}

const json::array_t& readArray(const json& value, const std::string& place) {
    if (!value.is_array()) throwType(value, place, "a list");
    return value.get_ref<const json::array_t&>();
}

namespace {

template <int N>
Eigen::Matrix<double, N, 1> readVec(const json& value, const std::string& place) {
    const json::array_t& items = readArray(value, place);
    if (items.size() != N) {
        throwRead(Errc::BadValue, place + " must be a list of " + std::to_string(N) + " numbers");
    }
    Eigen::Matrix<double, N, 1> v;
    for (int i = 0; i < N; ++i) {
        v[i] = readNumber(items[static_cast<std::size_t>(i)], place + "/" + std::to_string(i));
    }
    return v;
}

}  // namespace

Vec2 readVec2(const json& value, const std::string& place) { return readVec<2>(value, place); }
Vec3 readVec3(const json& value, const std::string& place) { return readVec<3>(value, place); }

std::string numberText(double value) {
    // As an integer token "-0" would read back without its sign.
    if (value == 0.0 && std::signbit(value)) return "-0.0";
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), end.ptr};
}

std::string jsonQuoted(std::string_view text) {
    return json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string nameQuoted(std::string_view name) {
    constexpr std::size_t kMostBytes = 80;
    if (name.size() <= kMostBytes) return jsonQuoted(name);
    std::size_t end = kMostBytes;
    const auto inCharacter = [&](std::size_t i) { return (name[i] & 0xC0) == 0x80; };
    while (end > 0 && inCharacter(end)) --end;
    return jsonQuoted(std::string(name.substr(0, end)) + "...");
}

std::string vecText(const Vec2& v) {
    return "[" + numberText(v.x()) + ", " + numberText(v.y()) + "]";
}

std::string vecText(const Vec3& v) {
    return "[" + numberText(v.x()) + ", " + numberText(v.y()) + ", " + numberText(v.z()) + "]";
}

}  // namespace ew
