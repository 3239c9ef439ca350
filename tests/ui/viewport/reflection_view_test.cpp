// SPDX-License-Identifier: MIT
#include "core/render/mip_map.h"
#include "core/render/picture.h"
#include "tests/ui/viewport/cornell_view.h"
#include "ui/jobs/live_reflections.h"
#include "ui/viewport/still_renderer.h"

#include <algorithm>
#include <cmath>

namespace soffit::ui {

/// Reflections in the viewport against render::LitProbes on the CPU.
class ReflectionViewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    // Everything shines, as sharply and as strongly as materials differ.
    lit_ = std::make_unique<Lit>(lightCornell([](scene::Scene& scene) {
      double roughness = 0.1;
      for (scene::Material& m : scene.materials) {
        m.specular = 0.3 * roughness;
        m.roughness = std::min(roughness, 1.0);
        roughness += 0.2;
      }
      addRoughnessMap(scene);
    }));
    auto with = std::make_shared<LightFrame>(*lit_->frame);
    LiveReflections reflections;
    const auto scene = std::make_shared<const scene::Scene>(lit_->project.scene);
    QVERIFY(reflections.lacks(*with->solver, *scene));
    reflections.make(with->solver, scene, {});
    QVERIFY(!reflections.lacks(*with->solver, *scene));
    reflections.addTo(*with);
    QVERIFY(with->reflections != nullptr);
    QVERIFY(!with->reflections->probes().empty());
    with_ = std::move(with);
  }

  void pixelsEqualTheProcessorsWithinOneCodeValue() {
    const std::vector<vec3> plain = pictureOf(lit_->frame);
    const std::vector<vec3> shown = pictureOf(with_);
    QCOMPARE(shown.size(), std::size_t{kWidth * kHeight});
    render::Film found(kWidth, kHeight);
    render::Film expected(kWidth, kHeight);
    double reflected = 0.0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        // readLinear()'s rows go upward.
        const std::size_t at =
            static_cast<std::size_t>(kHeight - 1 - y) * kWidth + static_cast<std::size_t>(x);
        const std::size_t to = found.at(x, y);
        found.radiance[to] = shown[at];
        const vec3 added = reflectionAt({x + 0.5, y + 0.5});
        expected.radiance[to] = plain[at] + added;
        reflected += static_cast<double>(added.y);
      }
    }
    QVERIFY2(reflected / (kWidth * kHeight) > 0.5, qPrintable(QString::number(reflected)));
    const auto a = render::developPicture(found, {.exposure_ev = 1.5});
    const auto b = render::developPicture(expected, {.exposure_ev = 1.5});
    QVERIFY(a.ok() && b.ok());
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < a->pixels.size(); ++i) {
      const auto code = [](float v) { return std::lround(255.0F * v); };
      unlike += std::abs(code(a->pixels[i]) - code(b->pixels[i])) > 1 ? 1 : 0;
    }
    // Where an edge runs through a pixel's very middle, or a map's texels part.
    QVERIFY2(unlike < a->pixels.size() / 500, qPrintable(QString::number(unlike)));
  }

  void aStillHasThemToo() {
    CornellView scene(*lit_);
    QVERIFY(scene.show(with_));
    Shot shot;
    shot.pixels = {kWidth, kHeight};
    shot.samples = 1;
    const auto still = scene.view->still(shot);
    QVERIFY(still.has_value());
    const QImage live = scene.view->picture(shot.pixels, false, 1);
    StillRenderer renderer;
    const auto drawn = renderer.render(*still, {});
    QVERIFY(drawn.ok());
    int most = 0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const QRgb p = drawn->image.pixel(x, y);
        const QRgb q = live.pixel(x, y);
        most = std::max({most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                         std::abs(qBlue(p) - qBlue(q))});
      }
    }
    QVERIFY2(most <= 1, qPrintable(QString::number(most)));
  }

  void noneOnceTheMaterialsAreMatt() {
    CornellView scene(*lit_);
    QVERIFY(scene.show(with_));
    auto matt = std::make_shared<scene::Scene>(lit_->project.scene);
    for (scene::Material& m : matt->materials) m.specular = 0.0;
    auto frame = std::make_shared<LightFrame>(*lit_->frame);
    frame->solver = frame->solver->repainted(matt->materials);
    LiveReflections reflections;
    reflections.make(frame->solver, matt, {});
    reflections.addTo(*frame);
    QCOMPARE(frame->reflections, std::shared_ptr<const render::LitProbes>());
    const std::vector<vec3> plain = pictureOf(lit_->frame);
    scene.view->setScene(matt);
    scene.view->setFrame(frame);
    (void)scene.view->picture({kWidth, kHeight}, false, 1);
    const std::vector<vec3> now = scene.view->readLinear();
    QCOMPARE(now.size(), plain.size());
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < now.size(); ++i) {
      unlike += glm::length(now[i] - plain[i]) > 2e-3F * glm::length(plain[i]) + 1e-3F ? 1 : 0;
    }
    QVERIFY2(unlike < now.size() / 1000, qPrintable(QString::number(unlike)));
  }

 private:
  /// From 45 to 100 % of the roughness in stripes, on two of three materials; u and v are metres.
  static void addRoughnessMap(scene::Scene& scene) {
    geometry::Mesh mesh = *scene.mesh;
    mesh.uvs.clear();
    for (const vec3& p : mesh.positions) mesh.uvs.emplace_back(p.x + p.z, p.y - 0.5F * p.z);
    scene.mesh = std::make_shared<const geometry::Mesh>(std::move(mesh));
    const auto map = std::make_shared<const scene::Image>(scene::Image{
        2, 2, 3, {0.0F, 0.45F, 0.0F, 0.0F, 0.8F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.6F, 0.0F}});
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      if (i % 3 != 0) scene.materials[i].roughness_image = map;
    }
  }
  /// Green of the map where the ray has met the mesh.
  static float roughnessShare(const geometry::Mesh& mesh, const geometry::Hit& hit,
                              const scene::Image& map) {
    const uvec3& t = mesh.triangles[hit.triangle];
    const vec2 uv =
        (1.0F - hit.u - hit.v) * mesh.uvs[t.x] + hit.u * mesh.uvs[t.y] + hit.v * mesh.uvs[t.z];
    return render::MipMap(map).at(uv, 1.0F).y;
  }

  static constexpr int kWidth = 640;
  static constexpr int kHeight = 400;

  std::vector<vec3> pictureOf(const LightFramePtr& frame) {
    CornellView scene(*lit_);
    if (!scene.show(frame)) return {};
    (void)scene.view->picture({kWidth, kHeight}, false, 1);
    camera_ = scene.view->viewCamera();
    return scene.view->readLinear();
  }

  [[nodiscard]] vec3 reflectionAt(const dvec2& pixel) const {
    const relight::Solver& solver = *with_->solver;
    const geometry::Mesh& mesh = *solver.scene().mesh;
    const dvec2 size(kWidth, kHeight);
    geometry::Ray ray;
    ray.origin = vec3(camera_.position - mesh.origin);
    ray.direction = vec3(camera_.rayThrough(pixel, size));
    const geometry::Hit hit = solver.scene().caster.closest(ray);
    if (!hit.valid()) return vec3(0.0F);
    for (const light::Emitter& e : with_->emitters) {
      if (e.bounds.distanceSquared(ray.origin + hit.t * ray.direction) < 1e-4F) return vec3(0.0F);
    }
    const scene::Material& m = lit_->project.scene.materials[mesh.material_of[hit.triangle]];
    vec3 normal = solver.scene().normals[hit.triangle];
    if (glm::dot(normal, ray.direction) > 0.0F) normal = -normal;
    float alpha = static_cast<float>(m.roughness * m.roughness);
    if (m.roughness_image != nullptr) {
      const float share = roughnessShare(mesh, hit, *m.roughness_image);
      alpha *= share * share;
    }
    return with_->reflections->reflected(
        {ray.origin + hit.t * ray.direction, normal, -ray.direction},
        static_cast<float>(m.specular), alpha);
  }

  std::unique_ptr<Lit> lit_;
  LightFramePtr with_;
  ViewCamera camera_;
};

}  // namespace soffit::ui

int main(int argc, char** argv) {
  soffit::ui::wantOpenGl();
  QApplication app(argc, argv);
  soffit::ui::ReflectionViewTest test;
  return QTest::qExec(&test, argc, argv);
}

#include "reflection_view_test.moc"
