// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/help.h"

#include "app/window/main_window.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDockWidget>
#include <QMap>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace codewheel {
namespace {

constexpr int lettersInLine = 64;
constexpr int height = 480; // of the list, in the smallest window as well; the rest is scrolled to

// Where a key works: nothing for the whole window, else the name of a panel or page.
QString viewOf(const QAction &action)
{
    if (action.shortcutContext() == Qt::WindowShortcut || action.shortcutContext() == Qt::ApplicationShortcut)
        return {};
    for (const QObject *each = action.parent(); each != nullptr; each = each->parent())
        if (const auto *dock = qobject_cast<const QDockWidget *>(each))
            return dock->windowTitle();
    const auto *view = qobject_cast<const QWidget *>(action.parent());
    return view == nullptr || view->accessibleName().isEmpty() ? MainWindow::tr("Pages in the middle")
                                                               : view->accessibleName();
}

QString keysHtml(const QMainWindow &window)
{
    QMap<QString, QStringList> rows; // by view
    for (const QAction *action : window.findChildren<QAction *>())
        if (!action->shortcut().isEmpty())
            rows[viewOf(*action)].append(
                QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                    .arg(action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped(),
                         action->text().remove(u'&').toHtmlEscaped()));
    QString html = MainWindow::tr("<p>Space or a click toggles a bit, the arrows move.</p>");
    for (auto [view, keys] : rows.asKeyValueRange()) {
        keys.removeDuplicates();
        const QString title = view.isEmpty() ? MainWindow::tr("The whole window") : view;
        html +=
            QStringLiteral("<h4>%1</h4><table>%2</table>").arg(title.toHtmlEscaped(), keys.join(QString()));
    }
    return html;
}

} // namespace

// Beside the window, not before it: a tool window leaves the keys of its parent at work, ALARM STOP among
// them.
void showKeys(QMainWindow &window)
{
    auto *dialog = window.findChild<QDialog *>(QStringLiteral("keys"));
    if (dialog == nullptr) {
        dialog = new QDialog(&window, Qt::Tool);
        dialog->setObjectName(QStringLiteral("keys"));
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->setWindowTitle(MainWindow::tr("Keys"));
        auto *page = describe(new QTextBrowser(dialog), MainWindow::tr("Keys"),
                              MainWindow::tr("All keys, by the part of the window in which they work"));
        page->setFrameShape(QFrame::NoFrame);
        page->setHtml(keysHtml(window));
        auto *rows = new QVBoxLayout(dialog);
        rows->setContentsMargins(grid::margin, grid::margin, grid::margin, grid::margin);
        rows->addWidget(page);
        dialog->resize(lettersInLine * dialog->fontMetrics().averageCharWidth(), height);
    }
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
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
