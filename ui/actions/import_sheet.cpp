// SPDX-License-Identifier: MIT
#include "ui/actions/import_sheet.h"

#include "ui/document/text.h"
#include "ui/widgets/quantity.h"
#include "ui/widgets/size_preview.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QStandardPaths>
#include <QVBoxLayout>

#include <algorithm>

namespace soffit::ui {
namespace {

/// Outside of these a building's unit is hardly right, m.
constexpr double kLeast = 1.0;
constexpr double kMost = 500.0;

/// In a folder of its own, for the model's files come with it.
QString suggestedPlace(const QString& model) {
  const QString stem = QFileInfo(model).completeBaseName();
  const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
  QString name = stem;
  for (int i = 2; QFileInfo::exists(documents.filePath(name)); ++i) {
    name = stem + QLatin1Char(' ') + QString::number(i);
  }
  return documents.filePath(name + QLatin1Char('/') + stem + QStringLiteral(".soffit"));
}

}  // namespace

ImportSheet::ImportSheet(const QString& model, const QString& open_project, QWidget* parent)
    : QDialog(parent),
      model_(model),
      unit_(new QComboBox),
      up_(new QComboBox),
      preview_(new SizePreview),
      facts_(new QLabel),
      to_new_(new QRadioButton(tr("A new project"))),
      to_open_(new QRadioButton(tr("The open project, %1").arg(open_project))),
      place_(new QLineEdit(QDir::toNativeSeparators(suggestedPlace(model)))),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel)) {
  setWindowTitle(tr("Import %1").arg(QFileInfo(model).fileName()));
  const std::pair<QString, double> units[] = {{tr("Metres"), 1.0},
                                              {tr("Centimetres"), 0.01},
                                              {tr("Millimetres"), 0.001},
                                              {tr("Feet"), 0.3048},
                                              {tr("Inches"), 0.0254}};
  for (const auto& [name, factor] : units) unit_->addItem(name, factor);
  unit_->setToolTip(
      tr("What one unit of the file is; files that state their unit are in metres already"));
  up_->addItem(tr("As the file says"), QString());
  up_->addItem(tr("Z"), QStringLiteral("z"));
  up_->addItem(tr("Y"), QStringLiteral("y"));
  facts_->setWordWrap(true);
  facts_->setMinimumHeight(2 * fontMetrics().lineSpacing());
  facts_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  to_open_->setVisible(!open_project.isEmpty());
  (open_project.isEmpty() ? to_new_ : to_open_)->setChecked(true);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("Import"));

  auto* form = new QFormLayout;
  form->addRow(tr("Unit"), unit_);
  form->addRow(tr("Up axis"), up_);
  auto* browse = new QPushButton(tr("Choose\u2026"));
  auto* place = new QHBoxLayout;
  place->addWidget(place_, 1);
  place->addWidget(browse);
  if (open_project.isEmpty()) {
    to_open_->setParent(this);
    form->addRow(tr("Into"), to_new_);
  } else {
    form->addRow(tr("Into"), to_open_);
    form->addRow(QString(), to_new_);
  }
  form->addRow(QString(), place);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(preview_, 1);
  layout->addWidget(facts_);
  layout->addLayout(form);
  layout->addWidget(buttons_);
  resize(520, 480);

  connect(unit_, &QComboBox::currentIndexChanged, this, &ImportSheet::showSize);
  connect(up_, &QComboBox::currentIndexChanged, this, &ImportSheet::measure);
  connect(to_new_, &QRadioButton::toggled, this, &ImportSheet::updateButtons);
  connect(place_, &QLineEdit::textChanged, this, &ImportSheet::updateButtons);
  connect(browse, &QPushButton::clicked, this, &ImportSheet::browse);
  connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  measure();
}

ImportSheet::~ImportSheet() {
  stop_.request_stop();
}

double ImportSheet::unit() const {
  return unit_->currentData().toDouble();
}

std::optional<char> ImportSheet::up() const {
  const QString axis = up_->currentData().toString();
  return axis.isEmpty() ? std::nullopt : std::optional(axis.front().toLatin1());
}

bool ImportSheet::toOpenProject() const {
  return to_open_->isChecked();
}

QString ImportSheet::newProject() const {
  QString path = QDir::fromNativeSeparators(place_->text().trimmed());
  if (!path.endsWith(QLatin1String(".soffit"))) path += QStringLiteral(".soffit");
  return path;
}

std::optional<dvec3> ImportSheet::size() const {
  const auto known = known_.find(up());
  if (known == known_.end() || !known->second) return std::nullopt;
  return unit() * known->second->size_m;
}

void ImportSheet::measure() {
  if (!known_.contains(up())) {
    io::ImportChoices choices;
    choices.up = up();
    choices.job = Job{nullptr, stop_.get_token()};
    background_.run([this, model = toPath(model_), choices]() -> Background::End {
      auto size = io::measureModel(model, choices);
      return [this, size = std::move(size), up = choices.up] {
        known_.insert_or_assign(up, size);
        showSize();
      };
    });
  }
  showSize();
}

void ImportSheet::showSize() {
  const auto known = known_.find(up());
  if (known == known_.end()) {
    preview_->setSize(std::nullopt, tr("Reading the model\u2026"));
    facts_->clear();
  } else if (!known->second) {
    preview_->setSize(std::nullopt, messageOf(known->second.error()));
    facts_->clear();
  } else {
    io::ModelSize size = *known->second;
    size.size_m *= unit();
    preview_->setSize(size.size_m);
    QString text = tr("%L1 triangles, %L2 materials, %3 \u00d7 %4 m in plan, %5 m high")
                       .arg(size.triangles)
                       .arg(size.materials)
                       .arg(formatNumber(size.size_m.x, 2), formatNumber(size.size_m.y, 2),
                            formatNumber(size.size_m.z, 2));
    const double longest = std::max({size.size_m.x, size.size_m.y, size.size_m.z});
    if (longest < kLeast || longest > kMost) {
      text += QLatin1Char('\n') + tr("Unusual for a building: is the unit right?");
    }
    facts_->setText(text);
  }
  updateButtons();
}

void ImportSheet::browse() {
  const QString path = QFileDialog::getSaveFileName(this, tr("The new project"), newProject(),
                                                    tr("Soffit projects (*.soffit)"));
  if (path.isEmpty()) return;
  to_new_->setChecked(true);
  place_->setText(QDir::toNativeSeparators(path));
}

void ImportSheet::updateButtons() {
  const bool placed = toOpenProject() || !place_->text().trimmed().isEmpty();
  place_->setEnabled(!toOpenProject());
  buttons_->button(QDialogButtonBox::Ok)->setEnabled(placed && size().has_value());
}

}  // namespace soffit::ui
