// SPDX-License-Identifier: MIT
#include "ui/actions/about_dialog.h"

#include "core/color/library.h"
#include "core/geometry/library.h"
#include "core/io/image/library.h"
#include "core/io/model/library.h"
#include "core/io/project/libraries.h"
#include "core/transfer/libraries.h"
#include "ui/document/text.h"
#include "ui/viewport/vtk_library.h"
#include "ui/widgets/shared_files.h"

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QFile>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSysInfo>
#include <QTabWidget>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <glm/detail/setup.hpp>

namespace soffit::ui {
namespace {

constexpr QSize kSize(520, 520);

QString compiler() {
#ifdef __clang__
  return QStringLiteral("Clang " __clang_version__);
#else
  return QStringLiteral("GCC " __VERSION__);
#endif
}

QString toTable(const std::vector<Library>& libraries) {
  QString rows;
  for (const Library& library : libraries) {
    rows += QStringLiteral("<tr><td>%1</td><td>%2</td><td>%3</td></tr>")
                .arg(toQt(library.name).toHtmlEscaped(), toQt(library.version).toHtmlEscaped(),
                     toQt(library.licence).toHtmlEscaped());
  }
  return rows;
}

/// The same without markup, for a mail or an issue.
QString toPlain(const std::vector<Library>& libraries) {
  QString text =
      QStringLiteral("Soffit %1\n%2, Qt %3\n%4, %5\n\n")
          .arg(QApplication::applicationVersion(), compiler(), QString::fromLatin1(QT_VERSION_STR),
               QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture());
  for (const Library& library : libraries) {
    text += QStringLiteral("%1 %2 (%3)\n")
                .arg(toQt(library.name), toQt(library.version), toQt(library.licence));
  }
  return text;
}

QString ownLicence() {
  QFile file(sharedFolder(QStringLiteral("LICENSE")));
  if (!file.open(QIODevice::ReadOnly)) return QStringLiteral("SPDX-License-Identifier: MIT");
  return QString::fromUtf8(file.readAll());
}

}  // namespace

std::vector<Library> usedLibraries() {
  std::vector<Library> all{{"Qt", qVersion(), "LGPL-3.0-only"},
                           viewLibrary(),
                           geometry::rayLibrary(),
                           color::colorLibrary(),
                           io::imageLibrary(),
                           io::modelLibrary(),
                           threadLibrary()};
  for (const auto& more : {transfer::libraries(), io::textLibraries()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  const QString glm = QStringLiteral("%1.%2.%3.%4")
                          .arg(GLM_VERSION_MAJOR)
                          .arg(GLM_VERSION_MINOR)
                          .arg(GLM_VERSION_PATCH)
                          .arg(GLM_VERSION_REVISION);
  all.push_back({"GLM", toStd(glm), "MIT"});
  return all;
}

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("about"));
  setWindowTitle(tr("About Soffit"));
  setAttribute(Qt::WA_DeleteOnClose);
  const std::vector<Library> libraries = usedLibraries();
  auto* title = new QLabel(
      QStringLiteral("<span style='font-size: x-large; font-weight: 600'>Soffit %1</span><br>%2")
          .arg(QApplication::applicationVersion().toHtmlEscaped(),
               tr("Interactive, converged light for indoor architecture")));
  title->setTextInteractionFlags(Qt::TextSelectableByMouse);
  title->setWordWrap(true);
  auto* versions = new QTextBrowser;
  versions->setHtml(
      QStringLiteral(
          "<p>%1<br>%2</p><table cellspacing='0' cellpadding='4'><tr><th align='left'>%3</th>"
          "<th align='left'>%4</th><th align='left'>%5</th></tr>%6</table><p>%7</p>")
          .arg(tr("Built with %1 for Qt %2")
                   .arg(compiler().toHtmlEscaped(), QString::fromLatin1(QT_VERSION_STR)),
               tr("Running on %1, %2")
                   .arg(QSysInfo::prettyProductName().toHtmlEscaped(),
                        QSysInfo::currentCpuArchitecture()),
               tr("Library"), tr("Version"), tr("Licence"), toTable(libraries),
               tr("The libraries are those of the system; the texts of their licences lie there, "
                  "in Debian in /usr/share/doc.")));
  auto* licence = new QPlainTextEdit(ownLicence());
  licence->setReadOnly(true);
  licence->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  auto* tabs = new QTabWidget;
  tabs->addTab(versions, tr("&Versions"));
  tabs->addTab(licence, tr("&Licence of Soffit"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  QPushButton* copy = buttons->addButton(tr("&Copy the versions"), QDialogButtonBox::ActionRole);
  connect(copy, &QPushButton::clicked, this,
          [libraries] { QApplication::clipboard()->setText(toPlain(libraries)); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* box = new QVBoxLayout(this);
  box->setSpacing(10);
  box->addWidget(title);
  box->addWidget(tabs);
  box->addWidget(buttons);
  resize(kSize);
}

}  // namespace soffit::ui
