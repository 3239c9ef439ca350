// SPDX-License-Identifier: MIT
#include "ui/main_window/light_marks.h"

#include "core/design/contours.h"
#include "core/design/specks.h"
#include "ui/document/text.h"
#include "ui/widgets/quantity.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace soffit::ui {
namespace {

/// A point of a plane's grid, (0, 0) the first cell's centre.
dvec3 placeOn(const scene::WorkPlane& plane, const dvec2& at) {
  return plane.origin + plane.u * ((at.x + 0.5) / plane.nu) + plane.v * ((at.y + 0.5) / plane.nv);
}

void addValues(const scene::WorkPlane& plane, std::span<const float> lux, LuxMarks& marks) {
  for (int j = 0; j < plane.nv; ++j) {
    for (int i = 0; i < plane.nu; ++i) {
      const auto at = static_cast<std::size_t>(j * plane.nu + i);
      marks.numbers.push_back({placeOn(plane, dvec2(i, j)), static_cast<double>(lux[at]),
                               gridRank(i, j, plane.nu, plane.nv)});
    }
  }
}

void addLines(const scene::WorkPlane& plane, std::span<const float> lux,
              const std::vector<double>& levels, LuxMarks& marks) {
  const std::vector<double> values(lux.begin(), lux.end());
  for (const double level : levels) {
    for (const design::Contour& contour : design::withoutSpecks(
             design::contoursAt(values, plane.nu, plane.nv, level), values, plane.nu, level)) {
      LuxMarks::Line line;
      line.closed = contour.closed;
      line.level = level;
      for (const dvec2& point : contour.points) line.points.push_back(placeOn(plane, point));
      marks.lines.push_back(std::move(line));
    }
  }
}

std::string freeName(const std::vector<io::Probe>& probes) {
  for (std::size_t i = probes.size() + 1;; ++i) {
    std::string name = toStd(LightMarks::tr("Probe %1").arg(i));
    if (std::ranges::find(probes, name, &io::Probe::name) == probes.end()) return name;
  }
}

}  // namespace

LightMarks::LightMarks(Document& document, Relighting& relighting, LiveReadings& readings,
                       Workspace& workspace)
    : document_(document),
      relighting_(relighting),
      readings_(readings),
      workspace_(workspace),
      probes_(document.probes()) {
  workspace_.probes->setDocument(&document_);
  connect(&readings_, &LiveReadings::changed, this, &LightMarks::refresh);
  connect(&relighting_, &Relighting::frameChanged, this, [this] {
    workspace_.probes->setFrame(relighting_.frame());
    readCut();
    refresh();
  });
  connect(workspace_.view, &ViewPanel::lookChanged, this, &LightMarks::refresh);
  connect(&document_, &Document::probesChanged, this, [this] {
    probes_ = document_.probes();
    refresh();
  });
  connect(workspace_.probes, &ProbesPanel::chosenChanged, this, &LightMarks::refresh);
  ViewInput& input = workspace_.area->input();
  connect(&input, &ViewInput::pointed, this, [this](const PointedAt& at) {
    pointed_ = at.surface;
    workspace_.area->legend().setReading(at.surface ? std::optional(at.surface->lux)
                                                    : std::nullopt);
  });
  connect(&input, &ViewInput::left, this, [this] {
    pointed_.reset();
    workspace_.area->legend().setReading(std::nullopt);
  });
  connect(&workspace_.area->profile(), &ProfileChart::closeRequested, this,
          [this] { setCut(std::nullopt); });
  connect(&workspace_.area->grid(), &ViewGrid::shownChanged, this, [this] {
    addViews();
    refresh();
  });
  addViews();
  refresh();
}

void LightMarks::addViews() {
  ViewGrid& views = workspace_.area->grid();
  while (drags_.size() < views.count()) {
    const std::size_t i = drags_.size();
    SceneView& view = views.pane(i).view();
    drags_.push_back(std::make_unique<ProbeDrag>(view));
    ProbeDrag* drag = drags_.back().get();
    connect(drag, &ProbeDrag::chosen, this,
            [this](std::size_t probe) { workspace_.probes->choose(static_cast<int>(probe)); });
    connect(drag, &ProbeDrag::moved, this, &LightMarks::moveProbe);
    connect(drag, &ProbeDrag::finished, this, [this] { endMove(true); });
    connect(drag, &ProbeDrag::canceled, this, [this] { endMove(false); });
    // In a drag the views that are only looked at follow when there is time, numbers and all.
    connect(&view, &SceneView::lightShown, this, [this, i] {
      if (document_.previewing() && !isUsed(i)) showMarks(i);
    });
  }
}

/// The first speaks for the legend, the active one is worked in.
bool LightMarks::isUsed(std::size_t view) const {
  ViewGrid& views = workspace_.area->grid();
  return view == 0 || &views.pane(view) == &views.active();
}

void LightMarks::showMarks(std::size_t view) {
  const auto& layout = workspace_.area->grid().pane(view).layout();
  workspace_.area->marks(view).setMarks(marksOf(layout.value_or(document_.layout())));
}

LightMarks::~LightMarks() {
  workspace_.probes->setDocument(nullptr);
  workspace_.area->legend().setReading(std::nullopt);
  const std::size_t count = workspace_.area->grid().count();
  for (std::size_t i = 0; i < count; ++i) workspace_.area->marks(i).setMarks({});
  workspace_.area->profile().hide();
}

void LightMarks::pinProbe() {
  if (!pointed_) return;
  std::vector<io::Probe> probes = document_.probes();
  probes.push_back({freeName(probes), pointed_->position, dvec3(pointed_->normal)});
  const int last = static_cast<int>(probes.size()) - 1;
  document_.editProbes(tr("Pin probe"), std::move(probes));
  workspace_.probes->choose(last);
}

void LightMarks::drawProfile() {
  ViewPane& pane = workspace_.area->active();
  auto tool = std::make_unique<DrawingProfile>(pane.view());
  connect(tool.get(), &DrawingProfile::cutChanged, this,
          [this](const ProfileCut& cut) { setCut(cut); });
  pane.input().setTool(std::move(tool));
}

void LightMarks::setCut(const std::optional<ProfileCut>& cut) {
  cut_ = cut;
  workspace_.area->profile().setVisible(cut.has_value());
  readCut();
  refresh();
}

void LightMarks::readCut() {
  const LightFramePtr& frame = relighting_.frame();
  if (!cut_ || frame == nullptr) return;
  workspace_.area->profile().setPoints(profileOf(*cut_, *frame, *document_.scene()));
}

void LightMarks::moveProbe(std::size_t probe, const SurfaceReading& to) {
  if (probe >= probes_.size()) return;
  probes_[probe].position = to.position;
  probes_[probe].normal = dvec3(to.normal);
  workspace_.probes->setPlaces(probes_);
  refresh();
}

void LightMarks::endMove(bool keep) {
  if (keep) {
    document_.editProbes(tr("Move probe"), probes_);
    return;
  }
  probes_ = document_.probes();
  workspace_.probes->setPlaces(probes_);
  refresh();
}

void LightMarks::addPlanes(const LayoutReading& reading, LuxMarks& marks) const {
  const PlaneLook look = workspace_.view->planeLook();
  std::size_t first = 0;
  for (const scene::WorkPlane& plane : document_.scene()->work_planes) {
    const auto count = static_cast<std::size_t>(plane.nu) * static_cast<std::size_t>(plane.nv);
    // Readings of another grid are under way.
    if (first + count > reading.points.size()) return;
    const std::span lux = std::span(reading.points).subspan(first, count);
    first += count;
    if (look.values) addValues(plane, lux, marks);
    addLines(plane, lux, look.levels, marks);
    marks.borders.push_back({plane.origin, plane.origin + plane.u, plane.origin + plane.u + plane.v,
                             plane.origin + plane.v});
  }
}

void LightMarks::addProbes(LuxMarks& marks) const {
  const LightFramePtr& frame = relighting_.frame();
  const int chosen = workspace_.probes->chosen();
  for (std::size_t i = 0; i < probes_.size(); ++i) {
    const auto light =
        frame == nullptr ? std::nullopt : readProbe(*frame, *document_.scene(), probes_[i]);
    const QString reading =
        light ? tr("%1 %2   %3 cd/m\u00b2")
                    .arg(formatReading(light->lux, Dimension::illuminance),
                         unitOf(Dimension::illuminance))
                    .arg(light->luminance, 0, light->luminance >= 100.0 ? 'f' : 'g',
                         light->luminance >= 100.0 ? 0 : 3)
              : tr("no light here");
    marks.pins.push_back(
        {probes_[i].position, toQt(probes_[i].name), reading, static_cast<int>(i) == chosen});
  }
}

LuxMarks LightMarks::marksOf(const QString& layout) const {
  LuxMarks marks;
  marks.scale = workspace_.view->scale();
  const ReadingsPtr& readings = readings_.readings();
  if (readings != nullptr && workspace_.view->planeLook().any()) {
    const auto found = std::ranges::find(readings->layouts, toStd(layout), &LayoutReading::layout);
    if (found != readings->layouts.end()) addPlanes(*found, marks);
  }
  if (layout != document_.layout()) return marks;
  addProbes(marks);
  if (cut_) marks.cuts.push_back({cut_->from, cut_->to});
  return marks;
}

void LightMarks::refresh() {
  std::vector<dvec3> pins;
  for (const io::Probe& probe : probes_) pins.push_back(probe.position);
  ViewGrid& views = workspace_.area->grid();
  for (std::size_t i = 0; i < views.count(); ++i) {
    const auto& layout = views.pane(i).layout();
    const bool own = !layout || *layout == document_.layout();
    drags_[i]->setPins(own ? pins : std::vector<dvec3>{});
    if (!document_.previewing() || isUsed(i)) showMarks(i);
  }
}

}  // namespace soffit::ui
