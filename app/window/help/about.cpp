// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help/about.h"

#include "app/window/main_window.h"
#include "widgets/help/help_topic.h"
#include "widgets/look/grid.h"

#include <QApplication>
#include <QMessageBox>

namespace codewheel {

void showAbout(QMainWindow &window)
{
    QMessageBox box(
        QMessageBox::NoIcon, MainWindow::tr("About Codewheel"),
        MainWindow::tr(
            "<h3>Codewheel %1</h3><p>Sets up, watches and diagnoses absolute encoders on INTERBUS.</p>"
            "<p>Free software under the GNU General Public License, version 3 or later. It comes without any "
            "warranty.</p>")
            .arg(QApplication::applicationVersion()),
        QMessageBox::Ok, &window);
    setHelpTopic(box, "README.md");
    box.setIconPixmap(QApplication::windowIcon().pixmap(grid::largeIcon));
    box.exec();
}

} // namespace codewheel
