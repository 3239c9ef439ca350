// SPDX-License-Identifier: MIT
#include "core/prt/flags_file.h"

#include "core/transfer/content_hash.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace soffit::prt {
namespace {

constexpr std::uint64_t kMagic = 0x31304741'4c465250ULL;  // "PRFLAG01"

struct Header {
  std::uint64_t magic = kMagic;
  FlagsKey key{};
  std::uint64_t receivers = 0;
  std::uint64_t directions = 0;
  std::uint64_t dimmed = 0;
  std::uint64_t has_glass = 0;
  std::uint64_t checksum = 0;  ///< of all that follows
};

std::vector<std::byte> bodyOf(const VisibilityFlags& flags) {
  std::vector<std::byte> body;
  const auto add = [&body](const auto& items) {
    const auto bytes = std::as_bytes(std::span(items));
    body.insert(body.end(), bytes.begin(), bytes.end());
  };
  for (std::size_t i = 0; i < flags.receivers(); ++i) add(flags.words(i));
  add(flags.firstDimmed());
  add(flags.allDimmed());
  return body;
}

/// The next items of a body; its length has been checked.
template <class T>
std::vector<T> take(std::span<const std::byte>& body, std::size_t count) {
  std::vector<T> items(count);
  const std::span<std::byte> to = std::as_writable_bytes(std::span(items));
  std::copy(body.begin(), body.begin() + static_cast<std::ptrdiff_t>(to.size()), to.begin());
  body = body.subspan(to.size());
  return items;
}

bool sensible(const std::vector<std::uint32_t>& first,
              const std::vector<VisibilityFlags::Dimmed>& dimmed, std::uint64_t directions) {
  if (first.empty()) return dimmed.empty();
  bool fine = first.front() == 0 && first.back() == dimmed.size();
  for (std::size_t i = 1; i < first.size(); ++i) fine = fine && first[i - 1] <= first[i];
  for (const auto& d : dimmed) {
    fine = fine && d.direction < directions && d.share >= 0.0F && d.share <= 1.0F;
  }
  return fine;
}

}  // namespace

bool writeFlags(const VisibilityFlags& flags, const FlagsKey& key, std::ostream& out) {
  const std::vector<std::byte> body = bodyOf(flags);
  Header header;
  header.key = key;
  header.receivers = flags.receivers();
  header.directions = flags.directions();
  header.dimmed = flags.allDimmed().size();
  header.has_glass = flags.firstDimmed().empty() ? 0 : 1;
  header.checksum = transfer::hash64(body);
  out.write(reinterpret_cast<const char*>(&header), sizeof(header));
  out.write(reinterpret_cast<const char*>(body.data()), static_cast<std::streamsize>(body.size()));
  return out.good();
}

Result<VisibilityFlags> readFlags(std::istream& in, std::uint64_t size, const FlagsKey& key,
                                  const std::string& place) {
  const auto refuse = [&place](const std::string& what) {
    return Error{place, what, "Bake again."};
  };
  Header header;
  if (size < sizeof(header) || !in.read(reinterpret_cast<char*>(&header), sizeof(header))) {
    return refuse("too short for visibility flags");
  }
  if (header.magic != kMagic) return refuse("not a file of visibility flags of this version");
  if (header.key != key) return refuse("the flags are those of another scene");
  const std::uint64_t rest = size - sizeof(header);
  const std::uint64_t words = header.directions / 64 + (header.directions % 64 != 0 ? 1 : 0);
  const bool possible = header.has_glass <= 1 && header.directions <= (1ULL << 32U) &&
                        header.receivers <= rest && header.dimmed <= rest &&
                        (words == 0 || header.receivers <= rest / words);
  const std::uint64_t wanted = !possible
                                   ? 0
                                   : 8 * header.receivers * words +
                                         (header.has_glass != 0 ? 4 * (header.receivers + 1) : 0) +
                                         sizeof(VisibilityFlags::Dimmed) * header.dimmed;
  if (!possible || wanted != rest) return refuse("its length does not fit its header");
  std::vector<std::byte> body(rest);
  in.read(reinterpret_cast<char*>(body.data()), static_cast<std::streamsize>(rest));
  if (!in || transfer::hash64(body) != header.checksum) return refuse("damaged");
  VisibilityFlags flags(header.receivers, header.directions);
  std::span<const std::byte> left(body);
  for (std::size_t i = 0; i < flags.receivers(); ++i) {
    const auto row = take<std::uint64_t>(left, words);
    std::copy(row.begin(), row.end(), flags.words(i).begin());
  }
  auto first = take<std::uint32_t>(left, header.has_glass != 0 ? header.receivers + 1 : 0);
  auto dimmed = take<VisibilityFlags::Dimmed>(left, header.dimmed);
  if (!sensible(first, dimmed, header.directions)) return refuse("its lists of glass are damaged");
  flags.setDimmed(std::move(first), std::move(dimmed));
  return flags;
}

}  // namespace soffit::prt
