// SPDX-License-Identifier: MIT
#pragma once

#include "ui/jobs/relighting.h"

#include <QObject>
#include <QStringList>

#include <map>

namespace soffit::ui {

/// The light of layouts that are not in the view: to compare with, for their thumbnails, and so
/// that going to the next one takes no time. Computed one by one while nothing else is to do.
class OtherLights : public QObject {
  Q_OBJECT

 public:
  OtherLights(Document& document, Relighting& relighting, QObject* parent = nullptr);

  /// Which layouts are wanted, the most urgent first; empty names are the base.
  void setWanted(const QStringList& layouts);
  /// The newest light of a layout, the view's own included; null before there is any.
  [[nodiscard]] LightFramePtr frame(const QString& layout) const;
  /// Whether it is the light of what the document says now.
  [[nodiscard]] bool isCurrent(const QString& layout) const;
  /// The luminaires of any layout of the document.
  [[nodiscard]] std::vector<light::Luminaire> luminairesOf(const QString& layout) const;

 Q_SIGNALS:
  void ready(const QString& layout);

 private:
  struct Known {
    LightFramePtr frame;
    std::vector<light::Luminaire> luminaires;
  };
  void keepShown();
  void requestNext();
  void take();

  Document& document_;
  Relighting& relighting_;
  QStringList wanted_;
  std::map<QString, Known> known_;
  QString asked_;  ///< the layout under way
  std::vector<light::Luminaire> asked_luminaires_;
  bool under_way_ = false;
};

}  // namespace soffit::ui
