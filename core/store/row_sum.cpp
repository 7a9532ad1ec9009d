// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/row_sum.h"

#include <bit>

namespace ew {

namespace {

class Sum {
  public:
    void add(std::string_view bytes) {
        addNumber(bytes.size());
        for (const char c : bytes) addByte(static_cast<unsigned char>(c));
    }
    void addNumber(std::uint64_t n) {
        constexpr unsigned kBits = 8;
        for (unsigned i = 0; i < sizeof(n); ++i) addByte((n >> (kBits * i)) & 0xffU);
    }
    std::int64_t value() const { return std::bit_cast<std::int64_t>(sum_); }

  private:
    void addByte(std::uint64_t byte) {
        constexpr std::uint64_t kPrime = 0x100000001b3U;
        sum_ = (sum_ ^ byte) * kPrime;
    }
    std::uint64_t sum_ = 0xcbf29ce484222325U;
};

}  // namespace

std::int64_t rowSum(std::string_view table, const Row& row) {
    Sum sum;
    sum.add(table);
    for (const Field& field : row) {
        sum.addNumber(field.index());
        if (const auto* n = std::get_if<std::int64_t>(&field)) {
            sum.addNumber(std::bit_cast<std::uint64_t>(*n));
        } else if (const auto* x = std::get_if<double>(&field)) {
            sum.addNumber(std::bit_cast<std::uint64_t>(*x));
        } else if (const auto* text = std::get_if<std::string>(&field)) {
            sum.add(*text);
        } else if (const auto* bytes = std::get_if<Bytes>(&field)) {
            sum.add(bytes->data);
        }
    }
    return sum.value();
}

}  // namespace ew
