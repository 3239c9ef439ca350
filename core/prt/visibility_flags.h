// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace soffit::prt {

/// What the shadow pass finds out (Fujita & Kanai 2004): one bit per receiver and direction, 1
/// where something stands in the way. Directions below the receiver's geometric horizon are 0 and
/// mean nothing: no light of theirs is ever received.
class VisibilityFlags {
 public:
  VisibilityFlags() = default;
  VisibilityFlags(std::size_t receivers, std::size_t directions)
      : receivers_(receivers),
        directions_(directions),
        words_((directions + 63) / 64),
        bits_(receivers * words_, 0) {}

  /// What the flags of a bake will take, without glass; known before it.
  static std::uint64_t predictBytes(std::uint64_t receivers, std::uint64_t directions) {
    return receivers * ((directions + 63) / 64) * sizeof(std::uint64_t);
  }

  [[nodiscard]] std::size_t receivers() const { return receivers_; }
  [[nodiscard]] std::size_t directions() const { return directions_; }
  [[nodiscard]] std::uint64_t bytes() const {
    return bits_.size() * sizeof(std::uint64_t) + dimmed_.size() * sizeof(Dimmed) +
           first_dimmed_.size() * sizeof(std::uint32_t);
  }

  [[nodiscard]] bool blocked(std::size_t receiver, std::size_t direction) const {
    return (bits_[receiver * words_ + direction / 64] >> (direction % 64) & 1U) != 0;
  }
  [[nodiscard]] std::size_t countBlocked(std::size_t receiver) const {
    std::size_t count = 0;
    for (const std::uint64_t w : words(receiver)) count += static_cast<unsigned>(std::popcount(w));
    return count;
  }
  [[nodiscard]] std::span<std::uint64_t> words(std::size_t receiver) {
    return {bits_.data() + receiver * words_, words_};
  }
  [[nodiscard]] std::span<const std::uint64_t> words(std::size_t receiver) const {
    return {bits_.data() + receiver * words_, words_};
  }
  void setBlocked(std::size_t receiver, std::size_t direction, bool blocked) {
    std::uint64_t& word = bits_[receiver * words_ + direction / 64];
    const std::uint64_t bit = std::uint64_t{1} << (direction % 64);
    word = blocked ? word | bit : word & ~bit;
  }

  /// A direction in which sheets of glass let a share of the light pass.
  struct Dimmed {
    std::uint32_t direction = 0;
    float share = 1.0F;
    bool operator==(const Dimmed&) const = default;
  };
  /// Those of a receiver, by direction, whether blocked farther on or not. Few, or none at all.
  [[nodiscard]] std::span<const Dimmed> dimmed(std::size_t receiver) const {
    if (first_dimmed_.empty()) return {};
    return {dimmed_.data() + first_dimmed_[receiver],
            first_dimmed_[receiver + 1] - first_dimmed_[receiver]};
  }
  /// first: per receiver into `all`, one more at the end; both empty without glass.
  void setDimmed(std::vector<std::uint32_t> first, std::vector<Dimmed> all) {
    first_dimmed_ = std::move(first);
    dimmed_ = std::move(all);
  }
  [[nodiscard]] std::span<const std::uint32_t> firstDimmed() const { return first_dimmed_; }
  [[nodiscard]] std::span<const Dimmed> allDimmed() const { return dimmed_; }

  bool operator==(const VisibilityFlags&) const = default;

 private:
  std::size_t receivers_ = 0;
  std::size_t directions_ = 0;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> bits_;
  std::vector<std::uint32_t> first_dimmed_;
  std::vector<Dimmed> dimmed_;
};

}  // namespace soffit::prt
