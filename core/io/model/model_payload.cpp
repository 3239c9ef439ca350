// SPDX-License-Identifier: MIT
#include "core/io/model/model_payload.h"

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace soffit::io {
namespace {

// Both directions go through one list of members (visit), so they cannot disagree.

class Writer {
 public:
  template <class T>
  void value(const T& v) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
  }
  void text(const std::string& s) {
    value(std::uint64_t{s.size()});
    bytes.append(s);
  }
  template <class T>
  void array(const std::vector<T>& items) {
    static_assert(std::is_trivially_copyable_v<T>);
    value(std::uint64_t{items.size()});
    bytes.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(T));
  }
  template <class T, class F>
  void list(const std::vector<T>& items, const F& each) {
    value(std::uint64_t{items.size()});
    for (const T& item : items) each(item);
  }

  std::string bytes;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  void value(T& v) {
    take(&v, sizeof v);
  }
  void text(std::string& s) {
    const std::uint64_t size = count(1);
    s.assign(rest_.substr(0, size));
    rest_.remove_prefix(size);
  }
  template <class T>
  void array(std::vector<T>& items) {
    items.resize(count(sizeof(T)));
    take(items.data(), items.size() * sizeof(T));
  }
  template <class T, class F>
  void list(std::vector<T>& items, const F& each) {
    items.resize(count(1));
    for (T& item : items) each(item);
  }
  [[nodiscard]] bool whole() const { return good_ && rest_.empty(); }

 private:
  // A number of items that the rest can hold; 0 once anything is wrong.
  std::uint64_t count(std::size_t item_size) {
    std::uint64_t n = 0;
    value(n);
    if (n > rest_.size() / item_size) good_ = false;
    return good_ ? n : 0;
  }
  void take(void* to, std::size_t size) {
    if (size > rest_.size()) good_ = false;
    if (!good_ || size == 0) return;
    std::memcpy(to, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  std::string_view rest_;
  bool good_ = true;
};

template <class Archive, class Raw>
void visitRaw(Archive& archive, Raw& raw) {
  archive.array(raw.positions);
  archive.array(raw.normals);
  archive.array(raw.uvs);
  archive.array(raw.triangles);
  archive.array(raw.material_of);
  archive.array(raw.object_of);
  archive.list(raw.materials, [&](auto& s) { archive.text(s); });
  archive.list(raw.objects, [&](auto& s) { archive.text(s); });
}

template <class Archive, class Material>
void visitMaterial(Archive& archive, Material& m) {
  archive.text(m.name);
  archive.value(m.diffuse);
  archive.value(m.specular);
  archive.value(m.roughness);
  archive.text(m.diffuse_map);
  archive.text(m.normal_map);
  archive.text(m.roughness_map);
  archive.value(m.glass);
}

template <class Archive, class Model>
void visitModel(Archive& archive, Model& model) {
  archive.list(model.materials, [&](auto& m) { visitMaterial(archive, m); });
  archive.list(model.embedded_textures, [&](auto& e) {
    archive.text(e.path);
    archive.array(e.bytes);
  });
  archive.value(model.points);
  archive.value(model.lines);
  archive.value(model.lights);
  archive.value(model.cameras);
  archive.list(model.warnings, [&](auto& s) { archive.text(s); });
}

}  // namespace

std::string toBytes(const Result<ModelPayload>& payload) {
  Writer writer;
  writer.value(payload.ok());
  if (!payload) {
    writer.text(payload.error().place);
    writer.text(payload.error().what);
    writer.text(payload.error().hint);
    return std::move(writer.bytes);
  }
  visitRaw(writer, payload->raw);
  visitModel(writer, payload->model);
  writer.list(payload->model.side_files, [&](const auto& path) { writer.text(path.string()); });
  // std::vector<bool> has no bytes of its own.
  writer.array(std::vector<char>(payload->model.described.begin(), payload->model.described.end()));
  return std::move(writer.bytes);
}

std::optional<Result<ModelPayload>> payloadFromBytes(std::string_view bytes) {
  Reader reader(bytes);
  bool ok = false;
  reader.value(ok);
  if (!ok) {
    Error error;
    reader.text(error.place);
    reader.text(error.what);
    reader.text(error.hint);
    if (!reader.whole()) return std::nullopt;
    return error;
  }
  ModelPayload payload;
  visitRaw(reader, payload.raw);
  visitModel(reader, payload.model);
  reader.list(payload.model.side_files, [&](auto& path) {
    std::string text;
    reader.text(text);
    path = text;
  });
  std::vector<char> described;
  reader.array(described);
  payload.model.described.assign(described.begin(), described.end());
  if (!reader.whole()) return std::nullopt;
  return payload;
}

}  // namespace soffit::io
