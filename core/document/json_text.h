// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace ew {

/// What a JSON text may cost before it is refused.
struct JsonLimits {
    std::size_t maxBytes = 64U << 20U;       ///< of the text
    std::size_t maxTreeBytes = 768U << 20U;  ///< of the parsed tree, estimated while parsing
    int maxDepth = 32;                       ///< nested objects and arrays
};

/// Parses JSON text strictly: limits are checked while reading, before anything is built beyond
/// them; a key that comes twice in one object and a number beyond double range are refused.
/// Errors: TooLarge, TooDeep, Syntax, BadValue (a number beyond range); messages name the byte.
Result<nlohmann::json> parseJson(std::string_view text, const JsonLimits& limits);

/// Thrown by the readers below and caught at the border of the reader that uses them; it never
/// leaves the document room.
struct ReadError {
    Error error;
};

[[noreturn]] void throwRead(Errc code, std::string message);

/// Strict access to one JSON object. Every message begins with the place, e.g.
/// `step 3 (stroke): the key "at" is missing`.
class ObjectReader {
  public:
    /// Throws ReadError (WrongType) where the value is no object.
    ObjectReader(const nlohmann::json& value, std::string place);

    /// Throws UnknownKey where the object has any other key.
    void allowOnly(std::initializer_list<std::string_view> keys) const;
    /// The value of a key, or nullptr.
    const nlohmann::json* find(const char* key) const;
    /// The value of a key; throws MissingKey.
    const nlohmann::json& require(const char* key) const;

    const std::string& place() const { return place_; }
    /// `place: "key"`, the start of a message about a key.
    std::string at(const char* key) const;

  private:
    const nlohmann::json& object_;
    std::string place_;
};

// Each throws ReadError (WrongType or BadValue) whose message begins with `place`.
double readNumber(const nlohmann::json& value, const std::string& place);
int readInt(const nlohmann::json& value, const std::string& place, int least, int most);
const std::string& readString(const nlohmann::json& value, const std::string& place);
const nlohmann::json::array_t& readArray(const nlohmann::json& value, const std::string& place);
Vec2 readVec2(const nlohmann::json& value, const std::string& place);
Vec3 readVec3(const nlohmann::json& value, const std::string& place);

/// The shortest text that reads back to the same double, to the bit (-0.0 included). Finite only.
std::string numberText(double value);
/// A JSON string literal; bytes that are no UTF-8 become U+FFFD.
std::string jsonQuoted(std::string_view text);
/// The same for a message: a name that goes on and on is cut off.
std::string nameQuoted(std::string_view name);
/// "[x, y]" and "[x, y, z]".
std::string vecText(const Vec2& v);
std::string vecText(const Vec3& v);

}  // namespace ew
