// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help.h"

#include "app/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QMessageBox>

namespace codewheel {

void showKeys(QMainWindow &window)
{
    QStringList rows;
    for (const QAction *action : window.findChildren<QAction *>())
        if (!action->shortcut().isEmpty())
            rows.append(QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                            .arg(action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped(),
                                 action->text().remove(u'&').toHtmlEscaped()));
    rows.removeDuplicates();
    QMessageBox::information(&window, MainWindow::tr("Keys"),
                             MainWindow::tr("<p>Space or a click toggles a bit, the arrows move.</p>") +
                                 QStringLiteral("<table>%1</table>").arg(rows.join(QString())));
}

void showAbout(QMainWindow &window)
{
    QMessageBox::about(
        &window, MainWindow::tr("About Codewheel"),
        MainWindow::tr(
            "<h3>Codewheel %1</h3><p>Sets up, watches and diagnoses absolute encoders on INTERBUS.</p>"
            "<p>Free software under the GNU General Public License, version 3 or later. It comes without any "
            "warranty.</p>")
            .arg(QApplication::applicationVersion()));
}

} // namespace codewheel
