// SPDX-License-Identifier: MIT
#include "core/transfer/cache_file.h"

#include "core/transfer/cache_key.h"
#include "core/transfer/content_hash.h"
#include "core/transfer/operator_arrays.h"
#include "core/transfer/operators_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <istream>
#include <vector>

namespace soffit::transfer {
namespace {

constexpr std::array<char, 8> kMagic = {'S', 'O', 'F', 'F', 'B', 'A', 'K', 'E'};
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint64_t kAlignment = 64;

struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t byte_order = kByteOrder;
  std::uint32_t version = kBakeVersion;
  std::array<char, 32> key{};
  std::uint64_t file_size = 0;
  std::uint64_t block_count = 0;
  std::uint64_t table_hash = 0;
  std::uint64_t own_hash = 0;  ///< of everything above
};
static_assert(is_packed<Header, 80>);

using BlockName = std::array<char, 32>;  // longer names are cut off

struct TableEntry {
  BlockName name{};
  std::uint64_t offset = 0;
  std::uint64_t size = 0;         ///< bytes
  std::uint64_t record_size = 0;  ///< bytes
  std::uint64_t hash = 0;
};
static_assert(is_packed<TableEntry, 64>);

template <class T>
std::span<const std::byte> bytesOf(const T& record) {
  return std::as_bytes(std::span(&record, 1));
}

std::uint64_t ownHash(const Header& header) {
  return hash64(bytesOf(header).first(sizeof(Header) - sizeof header.own_hash));
}

constexpr std::uint64_t aligned(std::uint64_t offset) {
  return (offset + kAlignment - 1) / kAlignment * kAlignment;
}

BlockName blockName(std::string_view name) {
  BlockName out{};
  assert(name.size() < out.size());
  name = name.substr(0, out.size() - 1);
  std::ranges::copy(name, out.begin());
  return out;
}

std::size_t blockCount() {
  const Operators none;
  const Records records;
  std::size_t count = 0;
  forEachArray(none, records, [&](std::string_view, const auto&) { ++count; });
  return count;
}

std::uint64_t firstOffset() {
  return aligned(sizeof(Header) + blockCount() * sizeof(TableEntry));
}

std::vector<TableEntry> makeTable(const Operators& operators, const Records& records) {
  std::vector<TableEntry> table;
  std::uint64_t offset = firstOffset();
  forEachArray(operators, records, [&](std::string_view name, const auto& array) {
    const auto bytes = std::as_bytes(std::span(array));
    table.push_back({blockName(name), offset, bytes.size(), sizeof(array[0]), hash64(bytes)});
    offset = aligned(offset + bytes.size());
  });
  return table;
}

std::uint64_t endOf(const std::vector<TableEntry>& table) {
  return aligned(table.back().offset + table.back().size);
}

bool readInto(std::istream& in, std::span<std::byte> bytes) {
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return in.gcount() == static_cast<std::streamsize>(bytes.size());
}

std::string readHeader(std::istream& in, std::uint64_t size, std::string_view key, Header& header) {
  if (size < sizeof(Header) || !readInto(in, std::as_writable_bytes(std::span(&header, 1)))) {
    return "it ends too early";
  }
  if (header.magic != kMagic) return "it is no bake of Soffit's";
  if (header.byte_order != kByteOrder) return "it comes from a machine with another byte order";
  if (header.version != kBakeVersion) {
    return fmt::format("it has version {} instead of {}", header.version, kBakeVersion);
  }
  if (header.own_hash != ownHash(header)) return "its header has changed";
  if (std::string_view(header.key.data(), header.key.size()) != key)
    return "it belongs to another scene";
  if (header.file_size != size)
    return fmt::format("it has {} bytes instead of {}", size, header.file_size);
  if (header.block_count != blockCount() || size < firstOffset()) return "its header has changed";
  return {};
}

/// Reads block after block; the first trouble ends it.
class BlockReader {
 public:
  BlockReader(std::istream& in, std::uint64_t size, const std::vector<TableEntry>& table)
      : in_(in), size_(size), table_(table), offset_(firstOffset()) {}

  template <class T>
  void operator()(std::string_view name, std::vector<T>& array) {
    if (!trouble_.empty()) return;
    const TableEntry& entry = table_[next_++];
    // Sizes are checked against the file's before anything is allocated.
    if (entry.name != blockName(name) || entry.offset != offset_ ||
        entry.record_size != sizeof(T) || entry.size % sizeof(T) != 0 || offset_ > size_ ||
        entry.size > size_ - offset_) {
      trouble_ = fmt::format("its table is wrong at '{}'", name);
      return;
    }
    array.resize(static_cast<std::size_t>(entry.size / sizeof(T)));
    in_.seekg(static_cast<std::streamoff>(offset_));
    if (!readInto(in_, std::as_writable_bytes(std::span(array)))) {
      trouble_ = "it ends too early";
    } else if (hash64(std::as_bytes(std::span(array))) != entry.hash) {
      trouble_ = fmt::format("its block '{}' has changed", name);
    }
    offset_ = aligned(offset_ + entry.size);
  }

  /// After the last block.
  [[nodiscard]] std::string trouble() const {
    if (trouble_.empty() && offset_ != size_) return "its blocks do not fill it";
    return trouble_;
  }

 private:
  std::istream& in_;
  std::uint64_t size_;
  const std::vector<TableEntry>& table_;
  std::uint64_t offset_;
  std::size_t next_ = 0;
  std::string trouble_;
};

std::string readBlocks(std::istream& in, std::uint64_t size, const Header& header,
                       Operators& operators) {
  std::vector<TableEntry> table(blockCount());
  const auto bytes = std::as_writable_bytes(std::span(table));
  if (!readInto(in, bytes)) return "it ends too early";
  if (hash64(bytes) != header.table_hash) return "its table has changed";
  Records records;
  BlockReader reader(in, size, table);
  forEachArray(operators, records, reader);
  std::string trouble = reader.trouble();
  if (!trouble.empty()) return trouble;
  trouble = applyRecords(records, operators);
  if (trouble.empty()) trouble = inconsistency(operators);
  return trouble.empty() ? trouble : fmt::format("its {} do not fit together", trouble);
}

}  // namespace

bool writeOperators(const Operators& operators, std::string_view key, const ByteSink& sink) {
  const Records records = recordsOf(operators);
  const std::vector<TableEntry> table = makeTable(operators, records);
  Header header;
  assert(key.size() == header.key.size());
  std::copy_n(key.begin(), std::min(key.size(), header.key.size()), header.key.begin());
  header.file_size = endOf(table);
  header.block_count = table.size();
  header.table_hash = hash64(std::as_bytes(std::span(table)));
  header.own_hash = ownHash(header);
  constexpr std::array<std::byte, kAlignment> kZeros{};
  const auto padTo64 = [&](std::uint64_t end) {
    const std::uint64_t count = aligned(end) - end;
    return count == 0 || sink(std::span(kZeros).first(static_cast<std::size_t>(count)));
  };
  bool good = sink(bytesOf(header)) && sink(std::as_bytes(std::span(table))) &&
              padTo64(sizeof(Header) + table.size() * sizeof(TableEntry));
  std::size_t block = 0;
  forEachArray(operators, records, [&](std::string_view, const auto& array) {
    const TableEntry& entry = table[block++];
    if (good && entry.size > 0) good = sink(std::as_bytes(std::span(array)));
    good = good && padTo64(entry.offset + entry.size);
  });
  return good;
}

ReadOperators readOperators(std::istream& in, std::uint64_t size, std::string_view key) {
  Header header;
  ReadOperators out;
  out.trouble = readHeader(in, size, key, header);
  if (!out.trouble.empty()) return out;
  auto operators = std::make_shared<Operators>();
  out.trouble = readBlocks(in, size, header, *operators);
  if (out.trouble.empty()) out.operators = std::move(operators);
  return out;
}

}  // namespace soffit::transfer
