// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/result.h"
#include "core/io/project/json.h"
#include "core/math/vec.h"

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Reading values out of JSON with errors that say where (internal to io_project).
namespace soffit::io {

/// Collects what is found while a document is read: the first error counts, warnings all do.
/// Readers go on after an error with defaults; the caller asks for it at the end.
class Report {
 public:
  explicit Report(std::string file) : file_(std::move(file)) {}

  void fail(std::string_view path, std::string what, std::string hint);
  /// The fault of a file that is named at `path`.
  void failAt(std::string_view path, const Error& fault);
  void warn(std::string_view path, std::string_view what);
  /// A key that the format does not know: kept, with a warning; an error when --set made it.
  void unknownKey(std::string_view path);

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] const Error& error() const { return *error_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  [[nodiscard]] const std::string& file() const { return file_; }

  void markSet(std::string path) { set_paths_.insert(std::move(path)); }
  [[nodiscard]] bool isSet(std::string_view path) const;

 private:
  std::string file_;
  std::optional<Error> error_;
  std::vector<std::string> warnings_;
  std::set<std::string, std::less<>> set_paths_;
};

/// Reads one JSON object member by member; members that nobody asked for are unknown keys.
class ObjectReader {
 public:
  /// `value` must outlive the reader. Fails when it is no object.
  ObjectReader(const Json& value, std::string path, Report& report);
  ~ObjectReader();  ///< reports the unknown keys
  ObjectReader(const ObjectReader&) = delete;
  ObjectReader& operator=(const ObjectReader&) = delete;

  /// The member, null when absent; it is known from now on.
  const Json* get(std::string_view key);
  [[nodiscard]] std::string pathOf(std::string_view key) const;
  [[nodiscard]] const std::string& path() const { return path_; }

  /// Each reads a member into `target` if it is there and of the right kind; fails otherwise.
  void read(std::string_view key, double& target);
  void read(std::string_view key, int& target);
  void read(std::string_view key, bool& target);
  void read(std::string_view key, std::string& target);
  void read(std::string_view key, dvec3& target);
  void read(std::string_view key, dvec2& target);
  template <class T>
  void read(std::string_view key, std::optional<T>& target) {
    if (get(key) == nullptr) return;
    T value{};
    read(key, value);
    target = value;
  }
  /// Fails when the member is absent.
  void require(std::string_view key, std::string_view example);

 private:
  const Json& value_;
  std::string path_;
  Report& report_;
  std::set<std::string, std::less<>> known_;
};

/// Numbers of a JSON array of exactly `count`; nothing and a failure otherwise.
std::optional<std::vector<double>> readNumbers(const Json& value, std::size_t count,
                                               std::string_view path, Report& report);

/// One number; nothing and a failure otherwise.
std::optional<double> readNumber(const Json& value, std::string_view path, Report& report);

/// "parent.key", or "key" at the top.
std::string joinPath(std::string_view parent, std::string_view key);

/// "list.NAME" for an element with a name, else "list[index]".
std::string elementPath(std::string_view list, std::size_t index, const Json& element);

}  // namespace soffit::io
