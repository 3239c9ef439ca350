// SPDX-License-Identifier: MIT
#include "ui/panels/verify_panel.h"

#include "ui/document/text.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QShortcut>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <array>

namespace soffit::ui {
namespace {

constexpr std::array kErrors{0.02, 0.01, 0.005, 0.002};
constexpr std::size_t kUsualError = 1;
constexpr std::array kMinutes{1, 3, 10, 30, 60};
constexpr int kUsualMinutes = 1;

enum Column { kWhere, kPoints, kMean, kRms, kBias, kP95, kNoise, kColumns };

QString percent(double share, int decimals = 2) {
  return QLocale().toString(100.0 * share, 'f', decimals);
}

}  // namespace

VerifyPanel::VerifyPanel(QWidget* parent)
    : QWidget(parent),
      error_(new QComboBox),
      limit_(new QComboBox),
      alone_(new QCheckBox(tr("Selected alone too"))),
      run_(new QToolButton),
      map_(new QCheckBox(tr("In the view"))),
      copy_(new QToolButton),
      state_(new QLabel),
      figures_(new QTreeWidget) {
  for (const double error : kErrors) {
    error_->addItem(tr("%1 %").arg(QLocale().toString(100.0 * error)), error);
  }
  error_->setCurrentIndex(static_cast<int>(kUsualError));
  error_->setToolTip(
      tr("Standard error of the reference at every point. Half of it takes four times as long."));
  error_->setAccessibleName(tr("Standard error of the reference"));
  for (const int minutes : kMinutes) {
    limit_->addItem(tr("%1 min").arg(minutes), 60.0 * minutes);
  }
  limit_->setCurrentIndex(kUsualMinutes);
  limit_->setToolTip(tr("After this time what the reference has reached counts"));
  limit_->setAccessibleName(tr("Time limit"));
  alone_->setToolTip(
      tr("The light of the selected luminaire is checked apart from all others too, "
         "against its own mean"));
  run_->setObjectName(QStringLiteral("verify_run"));
  map_->setToolTip(
      tr("A disc at every point: blue is too dark, orange too bright, hollow within "
         "twice the reference's own noise"));
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("The figures as text for a spreadsheet"));
  state_->setWordWrap(true);
  figures_->setObjectName(QStringLiteral("verify_figures"));
  figures_->setRootIsDecorated(true);
  figures_->setUniformRowHeights(true);
  figures_->setAlternatingRowColors(true);
  figures_->setFrameShape(QFrame::NoFrame);
  figures_->setHeaderLabels({tr("Where"), tr("Points"), tr("Mean lx"), tr("RMS %"), tr("Bias %"),
                             tr("P95 %"), tr("Noise %")});
  const QString hints[] = {
      tr("Points drawn from all lit surfaces, and the points of the work planes"),
      {},
      tr("Of the reference"),
      tr("Root mean square error over the mean; the reference's noise is taken out"),
      tr("Mean error over the mean; positive: computed values are too high"),
      tr("95 % of the points are nearer than this, each relative to its own value (at least 5 % of "
         "the mean); the reference's noise included"),
      tr("Standard error of the reference over the mean")};
  for (int c = 0; c < kColumns; ++c) {
    figures_->headerItem()->setToolTip(c, hints[c]);
    if (c != kWhere) figures_->headerItem()->setTextAlignment(c, Qt::AlignRight);
  }
  figures_->header()->setStretchLastSection(false);
  figures_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  figures_->header()->setSectionResizeMode(kWhere, QHeaderView::Stretch);

  auto* row = new QHBoxLayout;
  row->addWidget(run_);
  row->addWidget(new QLabel(tr("to")));
  row->addWidget(error_);
  row->addWidget(new QLabel(tr("within")));
  row->addWidget(limit_);
  row->addWidget(alone_);
  row->addStretch(1);
  row->addWidget(map_);
  row->addWidget(copy_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(6);
  layout->addLayout(row);
  layout->addWidget(state_);
  layout->addWidget(figures_, 1);

  connect(run_, &QToolButton::clicked, this, [this] {
    if (verification_ == nullptr) return;
    if (verification_->state() == Verification::State::idle) {
      start();
    } else {
      verification_->cancel();
    }
  });
  const auto copy = [this] { QGuiApplication::clipboard()->setText(text()); };
  connect(copy_, &QToolButton::clicked, this, copy);
  auto* keys = new QShortcut(QKeySequence::Copy, figures_);
  keys->setContext(Qt::WidgetWithChildrenShortcut);
  connect(keys, &QShortcut::activated, this, copy);
  connect(map_, &QCheckBox::toggled, this, &VerifyPanel::mapWantedChanged);
  setVerification(nullptr);
}

void VerifyPanel::setVerification(Verification* verification, Document* document) {
  if (verification_ != nullptr) verification_->disconnect(this);
  verification_ = verification;
  document_ = document;
  setEnabled(verification != nullptr);
  if (verification != nullptr) {
    connect(verification, &Verification::changed, this, &VerifyPanel::showState);
    connect(verification, &Verification::stopped, this, [this](const QString& why) {
      if (!why.isEmpty()) state_->setText(why);
    });
  }
  showState();
}

void VerifyPanel::start() {
  if (verification_ == nullptr) return;
  VerifyWish wish;
  wish.error = error_->currentData().toDouble();
  wish.time_limit_s = limit_->currentData().toDouble();
  if (alone_->isChecked() && document_ != nullptr && !document_->selection().isEmpty()) {
    wish.luminaire = document_->selection().front();
  }
  verification_->start(wish);
}

bool VerifyPanel::mapWanted() const {
  return map_->isChecked();
}

void VerifyPanel::setMapWanted(bool wanted) {
  map_->setChecked(wanted);
}

void VerifyPanel::showState() {
  const bool idle = verification_ == nullptr || verification_->state() == Verification::State::idle;
  run_->setText(idle ? tr("Verify") : tr("Stop"));
  run_->setToolTip(idle ? tr("Traces paths until every point is known, and compares")
                        : tr("Gives the verification up"));
  for (QWidget* choice : {static_cast<QWidget*>(error_), static_cast<QWidget*>(limit_),
                          static_cast<QWidget*>(alone_)}) {
    choice->setEnabled(idle);
  }
  const VerifiedLightPtr result = verification_ == nullptr ? nullptr : verification_->result();
  if (result != shown_) {
    shown_ = result;
    showFigures();
  }
  copy_->setEnabled(result != nullptr);
  map_->setEnabled(result != nullptr);
  if (!idle) {
    state_->setText(verification_->state() == Verification::State::waiting
                        ? tr("Waits for the final light\u2026")
                        : tr("The reference runs; work on, but any change of the light ends it"));
  } else if (result == nullptr) {
    state_->setText(
        tr("Not verified yet. An independent path tracer computes the same light, "
           "and the two are compared."));
  } else {
    const QString took =
        tr("%1 s, %2 million rays")
            .arg(QLocale().toString(result->seconds, 'f', 0))
            .arg(QLocale().toString(static_cast<double>(result->report.rays) / 1e6, 'f', 0));
    const QString noisy =
        result->report.reached
            ? QString()
            : tr(" The time ended before every point was known that well: see the noise.");
    state_->setText((verification_->isVerified()
                         ? tr("<b>Verified</b>: the figures are of the light that is shown (%1).")
                         : tr("The light changed since: the figures are of an earlier state (%1)."))
                        .arg(took) +
                    noisy);
  }
}

QTreeWidgetItem* VerifyPanel::addRow(QTreeWidgetItem* parent, const QString& name,
                                     const design::ErrorFigures& f) {
  auto* item = parent == nullptr ? new QTreeWidgetItem(figures_) : new QTreeWidgetItem(parent);
  const QLocale locale;
  const QString texts[] = {name,
                           locale.toString(static_cast<qulonglong>(f.receivers)),
                           locale.toString(f.mean_lux, 'f', f.mean_lux < 100.0 ? 1 : 0),
                           percent(f.rms),
                           percent(f.bias),
                           percent(f.p95, 1),
                           percent(f.reference_stderr)};
  for (int c = 0; c < kColumns; ++c) {
    item->setText(c, texts[c]);
    if (c != kWhere) item->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
  }
  return item;
}

void VerifyPanel::addRows(QTreeWidgetItem* parent, const design::LightErrors& errors) {
  if (errors.work_planes) {
    QTreeWidgetItem* all = addRow(parent, tr("Work planes"), *errors.work_planes);
    if (errors.planes.size() > 1) {
      for (const auto& plane : errors.planes) addRow(all, toQt(plane.name), plane.figures);
      all->setExpanded(true);
    }
  }
  QTreeWidgetItem* surfaces = addRow(parent, tr("All lit surfaces"), errors.receivers);
  for (const auto& room : errors.zones) addRow(surfaces, toQt(room.name), room.figures);
}

void VerifyPanel::showFigures() {
  figures_->clear();
  if (shown_ == nullptr) return;
  addRows(nullptr, shown_->report.total);
  if (!shown_->report.luminaire) return;
  auto* alone =
      new QTreeWidgetItem(figures_, {tr("%1 alone").arg(toQt(shown_->report.luminaire->name))});
  addRows(alone, shown_->report.luminaire->alone);
  alone->setExpanded(true);
}

QString VerifyPanel::text() const {
  QStringList lines;
  const auto line = [&](const QTreeWidgetItem* item) {
    QStringList cells;
    for (int c = 0; c < kColumns; ++c) cells.append(item->text(c));
    lines.append(cells.join(QLatin1Char('\t')));
  };
  line(figures_->headerItem());
  for (QTreeWidgetItemIterator at(figures_); *at != nullptr; ++at) line(*at);
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

}  // namespace soffit::ui
