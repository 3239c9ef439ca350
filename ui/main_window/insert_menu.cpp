// SPDX-License-Identifier: MIT
// The Insert menu: luminaires of all kinds, from files, from the building, drawn.
#include "ui/actions/actions.h"
#include "ui/actions/file_dialogs.h"
#include "ui/document/text.h"
#include "ui/jobs/library_index.h"
#include "ui/jobs/mesh_import.h"
#include "ui/main_window/main_window.h"
#include "ui/panels/luminaire_text.h"
#include "ui/viewport/drawing_polygon.h"
#include "ui/viewport/making_luminous.h"
#include "ui/viewport/placing.h"

#include <QFileDialog>
#include <QMenuBar>

namespace soffit::ui {

void MainWindow::place(const LuminaireType& type) {
  if (session_ == nullptr) return;
  workspace_.area->grid().endTools();
  ViewPane& pane = workspace_.area->grid().working();
  pane.input().setTool(
      std::make_unique<Placing>(session_->document(), pane.view(), type, pane.input().snapRules()));
}

void MainWindow::placeFromPhotometry() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Photometric file"), {},
                                                    tr("Photometry (*.ies *.IES *.ldt *.LDT)"));
  if (path.isEmpty()) return;
  const auto entry = readLibraryEntry(path);
  if (entry) {
    place(entry->type);
  } else {
    showError(this, tr("The file was not read"), messageOf(entry.error()));
  }
}

void MainWindow::placeFromMesh() {
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Mesh"), {}, tr("Models (*.obj *.OBJ *.ply *.stl *.glb *.gltf)"));
  if (path.isEmpty()) return;
  auto* job = new MeshImport(path, this);
  connect(job, &MeshImport::finished, this, [this, job] {
    place(job->type());
    job->deleteLater();
  });
  connect(job, &MeshImport::failed, this, [this, job](const QString& message) {
    showError(this, tr("The mesh was not read"), message);
    job->deleteLater();
  });
}

void MainWindow::makeInsertMenu() {
  QMenu& menu = named(menuBar()->addMenu(tr("&Insert")), "Insert");
  for (const LuminaireType& type : builtInTypes()) {
    forProject(addEntry(menu, {type.name, {}, describeType(type), type.id}, this,
                        [this, type] { place(type); }));
  }
  connect(workspace_.library, &LibraryPanel::chosen, this, &MainWindow::place);
  menu.addSeparator();
  forProject(addEntry(menu,
                      {tr("From a &photometric file\u2026"), {}, {}, "From a photometric file"},
                      this, [this] { placeFromPhotometry(); }));
  forProject(addEntry(
      menu, {tr("From a &mesh file\u2026"), {}, tr("OBJ and other models"), "From a mesh file"},
      this, [this] { placeFromMesh(); }));
  const auto addTool = [&](const ActionText& text, const auto& make) {
    forProject(addEntry(menu, text, this, [this, make] {
      workspace_.area->grid().endTools();
      workspace_.area->grid().working().input().setTool(make());
    }));
  };
  addTool({tr("Make &luminous"),
           {},
           tr("Click a part of the building that is to give light"),
           "Make luminous"},
          [this] {
            return std::make_unique<MakingLuminous>(session_->document(),
                                                    workspace_.area->grid().working().view());
          });
  addTool({tr("&Draw a luminaire"), {}, tr("Corner by corner, on the ceiling"), "Draw a luminaire"},
          [this] {
            return std::make_unique<DrawingPolygon>(session_->document(),
                                                    workspace_.area->grid().working().view());
          });
}

}  // namespace soffit::ui
