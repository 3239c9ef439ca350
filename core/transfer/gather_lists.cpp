// SPDX-License-Identifier: MIT
#include "core/transfer/gather_lists.h"

#include "core/transfer/texels.h"

#include <algorithm>
#include <cassert>

namespace soffit::transfer {
namespace {

using Entry = GatherLists::Entry;

constexpr std::uint32_t kNone = 15;  // the code of no rays

/// The entries of one page, and groups of them.
class PageEntries {
 public:
  /// As few of kRays as the greedy choice takes, which is exact because the smallest is 1.
  void add(std::uint32_t place, std::size_t rays) {
    for (std::uint32_t code = kNone; code-- > 0;) {
      const auto count = static_cast<std::size_t>(GatherLists::kRays[code]);
      for (; rays >= count; rays -= count) {
        (code == 0 ? single_ : mixed_).push_back(static_cast<Entry>(place << 4U | code));
      }
    }
  }

  /// Moves whole groups of single rays to one list, the rest, filled up, to the other.
  void moveTo(std::vector<Entry>& single, std::vector<Entry>& mixed) {
    const std::size_t whole = single_.size() / GatherLists::kGroup * GatherLists::kGroup;
    const auto rest = single_.begin() + static_cast<std::ptrdiff_t>(whole);
    mixed_.insert(mixed_.end(), rest, single_.end());
    while (mixed_.size() % GatherLists::kGroup != 0) {
      mixed_.push_back(static_cast<Entry>(mixed_.back() | kNone));
    }
    single.insert(single.end(), single_.begin(), rest);
    mixed.insert(mixed.end(), mixed_.begin(), mixed_.end());
    single_.clear();
    mixed_.clear();
  }

 private:
  std::vector<Entry> single_;
  std::vector<Entry> mixed_;
};

}  // namespace

void GatherLists::append(std::span<std::uint32_t> slots) {
  std::sort(slots.begin(), slots.end());
  PageEntries of_page;
  std::vector<Entry> mixed;
  std::vector<std::uint16_t> mixed_pages;
  List list;
  list.first_group = static_cast<std::uint32_t>(pages.size());
  list.scale = slots.empty() ? 0.0F : 1.0F / static_cast<float>(slots.size());
  for (std::size_t i = 0; i < slots.size() && slots[i] != kNoTexel;) {
    const std::uint32_t page = slots[i] / kPage;
    assert(page <= 0xffffU);
    while (i < slots.size() && slots[i] != kNoTexel && slots[i] / kPage == page) {
      const std::size_t begin = i;
      while (i < slots.size() && slots[i] == slots[begin]) ++i;
      of_page.add(slots[begin] % kPage, i - begin);
    }
    of_page.moveTo(entries, mixed);
    pages.resize(entries.size() / kGroup, static_cast<std::uint16_t>(page));
    mixed_pages.resize(mixed.size() / kGroup, static_cast<std::uint16_t>(page));
  }
  list.single = static_cast<std::uint32_t>(pages.size()) - list.first_group;
  list.mixed = static_cast<std::uint32_t>(mixed_pages.size());
  entries.insert(entries.end(), mixed.begin(), mixed.end());
  pages.insert(pages.end(), mixed_pages.begin(), mixed_pages.end());
  lists.push_back(list);
}

void GatherLists::append(const GatherLists& other) {
  const auto shift = static_cast<std::uint32_t>(pages.size());
  entries.insert(entries.end(), other.entries.begin(), other.entries.end());
  pages.insert(pages.end(), other.pages.begin(), other.pages.end());
  for (List l : other.lists) {
    l.first_group += shift;
    lists.push_back(l);
  }
}

}  // namespace soffit::transfer
