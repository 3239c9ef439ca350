// SPDX-License-Identifier: MIT
#include "ui/panels/quality_panel.h"

#include "core/scene/demand.h"
#include "ui/document/core_words.h"
#include "ui/document/text.h"
#include "ui/panels/advanced_quality.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>
#include <array>

namespace soffit::ui {
namespace {

constexpr std::array kPresets{"draft", "interactive", "final"};
constexpr std::size_t kStages = 6;
constexpr std::uint64_t kRaysAvoided = 64;  ///< per point, as `soffit bench` counts them

QString sentence(const std::string& text) {
  QString out = coreWords(text);
  if (!out.isEmpty()) out[0] = out[0].toUpper();
  return out;
}

std::array<double, kStages + 1> stagesOf(const relight::StageTimes& t) {
  return {t.direct, t.first_bounce, t.nodes, t.gather, t.sweep, t.interpolate, t.total()};
}

}  // namespace

QualityPanel::QualityPanel(QWidget* parent)
    : QWidget(parent), preset_(new QComboBox), own_(new QLabel), figures_(new QTreeWidget) {
  preset_->addItem(tr("Draft: quick to precompute"), QString::fromLatin1(kPresets[0]));
  preset_->addItem(tr("Interactive"), QString::fromLatin1(kPresets[1]));
  preset_->addItem(tr("Final: finer, slower to update"), QString::fromLatin1(kPresets[2]));
  // The names do not widen the dock; the list that opens has room for them.
  preset_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  preset_->setMinimumContentsLength(8);
  preset_->view()->setMinimumWidth(preset_->view()->sizeHintForColumn(0) + 24);
  preset_->setToolTip(
      tr("How finely light is precomputed. Another quality is precomputed in the background."));
  own_->setWordWrap(true);
  figures_->setObjectName(QStringLiteral("quality_figures"));
  figures_->setColumnCount(2);
  figures_->setHeaderHidden(true);
  figures_->setSelectionMode(QAbstractItemView::NoSelection);
  figures_->setFrameShape(QFrame::NoFrame);
  figures_->header()->setStretchLastSection(false);
  figures_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  figures_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  const auto section = [&](const QString& title) {
    auto* item = new QTreeWidgetItem(figures_, QStringList(title));
    QFont bold = item->font(0);
    bold.setBold(true);
    item->setFont(0, bold);
    item->setFirstColumnSpanned(true);
    item->setExpanded(true);
    return item;
  };
  update_ = section(tr("Last move of a luminaire"));
  row(update_, tr("Direct light"), tr("In closed form times visibility, at every point"));
  row(update_, tr("First reflection"), tr("From every point, by precomputed rays"));
  row(update_, tr("All further reflections"), tr("Solved to a residual, not counted in bounces"));
  row(update_, tr("Gathering them"), tr("From patches to where light differs"));
  row(update_, tr("From point to point"),
      tr("All reflections once more between all points, for what patches are too coarse for"));
  row(update_, tr("All points"), tr("Interpolated with precomputed weights"));
  row(update_, tr("Together"), {});
  visibility_ = section(tr("Shadows of the last move"));
  row(visibility_, tr("Rays traced"),
      tr("None: what hides a light is found from the shapes between it and the point, in closed "
         "form"));
  row(visibility_, tr("Rays avoided"),
      tr("That 64 shadow rays for each lit point would have taken"));
  row(visibility_, tr("Points computed"), tr("The others lie behind the light, or it behind them"));
  row(visibility_, tr("Groups of points skipped"), tr("Turned away from the light as a whole"));
  row(visibility_, tr("Groups that nothing can shade"),
      tr("Empty between them and the light: no test at all"));
  transport_ = section(tr("Light transport"));
  row(transport_, tr("Points"), tr("Where light is computed and sent on"));
  row(transport_, tr("Gather points"), tr("Of these, where rays were traced for all the others"));
  row(transport_, tr("Memory"), {});
  row(transport_, tr("State"), {});
  row(transport_, tr("Light from outside"),
      tr("Found exactly at rest; mixed from smooth skies while a slider is held"));
  row(transport_, tr("Reflections"),
      tr("Pictures of the lit room from these places, made anew with every light"));
  row(transport_, tr("Sky in hand"),
      tr("Memory of the graphics processor and time per step of the slider, where it adds up the "
         "light of the sky"));
  needed_ = section(tr("Computed"));
  skipped_ = section(tr("Not needed here"));
  auto* advanced = new QToolButton;
  advanced->setText(tr("Advanced\u2026"));
  advanced->setToolTip(tr("Every single setting, and the methods of the founding papers"));
  advanced->setObjectName(QStringLiteral("advanced_quality"));
  connect(advanced, &QToolButton::clicked, this, &QualityPanel::openAdvanced);
  auto* form = new QFormLayout(this);
  auto* quality_row = new QHBoxLayout;
  quality_row->addWidget(preset_, 1);
  quality_row->addWidget(advanced);
  form->addRow(tr("Quality"), quality_row);
  form->addRow(own_);
  form->addRow(figures_);
  connect(preset_, &QComboBox::activated, this,
          [this] { choose(preset_->currentData().toString()); });
  setDocument(nullptr);
}

QTreeWidgetItem* QualityPanel::row(QTreeWidgetItem* section, const QString& what,
                                   const QString& hint) {
  auto* item = new QTreeWidgetItem(section, QStringList(what));
  item->setToolTip(0, hint);
  item->setTextAlignment(1, Qt::AlignRight);
  return item;
}

void QualityPanel::setDocument(Document* document) {
  if (document_ != nullptr) document_->disconnect(this);
  document_ = document;
  setEnabled(document != nullptr);
  for (QTreeWidgetItem* section : {update_, visibility_, transport_}) {
    for (int i = 0; i < section->childCount(); ++i) {
      section->child(i)->setText(1, QStringLiteral("\u2013"));
    }
  }
  if (document == nullptr) return;
  connect(document, &Document::sceneChanged, this, &QualityPanel::showProject);
  connect(document, &Document::layoutChanged, this, &QualityPanel::showProject);
  showProject();
}

void QualityPanel::showProject() {
  if (document_ == nullptr || document_->previewing()) return;
  const scene::Quality& quality = document_->scene()->quality;
  preset_->setCurrentIndex(std::max(0, preset_->findData(toQt(quality.preset))));
  QStringList own;
  for (const auto& [name, value] : quality.methods) {
    own.append(QStringLiteral("%1 = %2").arg(toQt(name), toQt(value)));
  }
  for (const auto& [name, value] : quality.settings) {
    own.append(QStringLiteral("%1 = %2").arg(toQt(name)).arg(value));
  }
  own_->setVisible(!own.isEmpty());
  own_->setText(tr("With the project's own %1").arg(own.join(QStringLiteral(", "))));
  scene::Scene shown = *document_->scene();
  shown.luminaires = document_->luminaires();
  const scene::Demand demand = scene::demandOf(shown);
  qDeleteAll(needed_->takeChildren());
  qDeleteAll(skipped_->takeChildren());
  for (const std::string& what : demand.needed) {
    auto* item = new QTreeWidgetItem(needed_, QStringList(sentence(what)));
    item->setFirstColumnSpanned(true);
  }
  for (const scene::Demand::Skip& skip : demand.skipped) {
    auto* item = new QTreeWidgetItem(skipped_, QStringList(QStringLiteral("%1: %2").arg(
                                                   sentence(skip.what), coreWords(skip.why))));
    item->setToolTip(0, item->text(0));
    item->setFirstColumnSpanned(true);
  }
}

void QualityPanel::setQuality(const scene::Quality& quality) {
  if (document_ == nullptr) return;
  scene::Scene next = *document_->scene();
  next.quality = quality;
  document_->edit(tr("Quality"), std::move(next));
}

void QualityPanel::openAdvanced() {
  if (document_ == nullptr) return;
  auto* dialog = new AdvancedQuality(document_->scene()->quality, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { setQuality(dialog->quality()); });
  dialog->open();
}

void QualityPanel::choose(const QString& preset) {
  if (document_ == nullptr) return;
  scene::Quality quality = document_->scene()->quality;
  quality.preset = toStd(preset);
  setQuality(quality);
}

void QualityPanel::showSky(const SkyEvaluation::Figures& figures) {
  using Where = SkyEvaluation::Figures::Where;
  if (figures.where == Where::nowhere) return;  // the last step's stay
  const QLocale locale;
  transport_->child(6)->setText(
      1, figures.where == Where::refused
             ? tr("by the processor")
             : tr("%1 MB, %2 ms")
                   .arg(locale.toString(static_cast<double>(figures.bytes) / 1e6, 'f', 1))
                   .arg(locale.toString(figures.milliseconds, 'f', 1)));
}

void QualityPanel::showFrame(const LightFrame& frame) {
  const QLocale locale;
  // What was only mixed again has no times: the last move's stay.
  if (frame.times.total() > 0.0) {
    const auto stages = stagesOf(frame.times);
    for (std::size_t i = 0; i < stages.size(); ++i) {
      update_->child(static_cast<int>(i))
          ->setText(1, tr("%1 ms").arg(locale.toString(stages[i], 'f', 1)));
    }
    const light::DirectCounts& counts = frame.counts;
    const std::uint64_t rows[] = {0, kRaysAvoided * counts.points, counts.points,
                                  counts.clusters_culled, counts.clusters_clear};
    for (int i = 0; i < visibility_->childCount(); ++i) {
      visibility_->child(i)->setText(1, locale.toString(static_cast<qulonglong>(rows[i])));
    }
  }
  const transfer::Operators& op = frame.solver->operators();
  transport_->child(0)->setText(1,
                                locale.toString(static_cast<qulonglong>(op.texels.texelCount())));
  transport_->child(1)->setText(1, locale.toString(static_cast<qulonglong>(op.lists.lists.size())));
  transport_->child(2)->setText(
      1, tr("%1 MB").arg(locale.toString(static_cast<double>(op.bytes()) / 1e6, 'f', 1)));
  transport_->child(3)->setText(1, op.coarse ? tr("coarse, being refined") : tr("complete"));
  transport_->child(4)->setText(1, !frame.complete            ? tr("being computed")
                                   : frame.outside == nullptr ? tr("none")
                                                              : tr("complete"));
  transport_->child(5)->setText(1, frame.reflections == nullptr
                                       ? tr("none")
                                       : tr("%1 places, %2 ms")
                                             .arg(frame.reflections->probes().size())
                                             .arg(locale.toString(frame.reflections_ms, 'f', 1)));
}

}  // namespace soffit::ui
