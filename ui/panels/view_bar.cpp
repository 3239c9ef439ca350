// SPDX-License-Identifier: MIT
#include "ui/panels/view_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

namespace soffit::ui {
namespace {

constexpr double kStep = 0.1;  // m

QString nameOfLayout(const QString& layout) {
  return layout.isEmpty() ? ViewBar::tr("Base") : layout;
}

/// A name is no mnemonic.
QString plain(QString name) {
  return name.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

}  // namespace

ViewBar::ViewBar(QWidget* parent)
    : QFrame(parent),
      view_(new QToolButton),
      cut_label_(new QLabel),
      cut_(new QuantityBox(Dimension::length)) {
  setObjectName(QStringLiteral("view_bar"));
  setAutoFillBackground(true);
  setFrameShape(QFrame::StyledPanel);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(3, 2, 3, 2);
  row->setSpacing(6);
  view_->setPopupMode(QToolButton::InstantPopup);
  view_->setAutoRaise(true);
  view_->setToolTip(tr("What this view shows"));
  view_->setMenu(new QMenu(view_));
  row->addWidget(view_);
  cut_label_->setContentsMargins(4, 0, 0, 0);
  row->addWidget(cut_label_);
  cut_->setAccessibleName(tr("Place of the cut"));
  cut_->setRange(-1e5, 1e5);
  cut_->setSteps(kStep, 2);
  row->addWidget(cut_);
  connect(view_->menu(), &QMenu::aboutToShow, this, &ViewBar::fillMenu);
  connect(cut_, &QuantityBox::edited, this, &ViewBar::cutChosen);
  setView(StandardView::perspective, std::nullopt);
}

void ViewBar::fillMenu() {
  QMenu& menu = *view_->menu();
  menu.clear();
  for (const StandardView view : kStandardViews) {
    menu.addAction(nameOf(view), this, [this, view] { Q_EMIT viewChosen(view); });
  }
  if (!cameras_.isEmpty()) menu.addSection(tr("Cameras"));
  for (const QString& name : cameras_) {
    menu.addAction(plain(name), this, [this, name] { Q_EMIT cameraChosen(name); });
  }
  if (layouts_.isEmpty()) return;
  menu.addSection(tr("Layout"));
  const auto add = [&](const QString& text, const std::optional<QString>& layout) {
    QAction* action =
        menu.addAction(plain(text), this, [this, layout] { Q_EMIT layoutChosen(layout); });
    action->setCheckable(true);
    action->setChecked(layout == layout_);
  };
  add(tr("The one that is edited"), std::nullopt);
  for (const QString& name : layouts_) add(nameOfLayout(name), name);
}

void ViewBar::setLayouts(const QStringList& names) {
  layouts_ = names;
}

void ViewBar::setLayout(const std::optional<QString>& layout) {
  layout_ = layout;
  showText();
}

void ViewBar::showText() {
  view_->setText(layout_ ? tr("%1 \u2013 %2").arg(nameOf(shown_), plain(nameOfLayout(*layout_)))
                         : nameOf(shown_));
  adjustSize();
}

void ViewBar::setCameras(const QStringList& names) {
  cameras_ = names;
}

void ViewBar::setView(StandardView view, std::optional<double> cut) {
  shown_ = view;
  cut_label_->setVisible(cut.has_value());
  cut_->setVisible(cut.has_value());
  if (cut) {
    const bool plan = view == StandardView::plan;
    const QString axis = plan               ? QStringLiteral("z")
                         : isSideways(view) ? QStringLiteral("x")
                                            : QStringLiteral("y");
    cut_label_->setText(tr("Cut at %1").arg(axis));
    cut_->setToolTip(tr("Where the building is cut open; Ctrl and the wheel move it, too"));
    cut_->setValue(cut);
  }
  showText();
}

}  // namespace soffit::ui
