// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/settings/folder_rows.h"

#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/icons.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QGridLayout>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QUrl>

namespace codewheel {
namespace {

// A folder in which nothing has been kept does not exist yet: use the nearest one that does.
QString nearestFolder(const QString &path)
{
    QDir folder(path);
    while (!folder.exists() && folder.cdUp()) {
    }
    return folder.absolutePath();
}

} // namespace

FolderRows::FolderRows(const std::vector<KeptFolder> &folders, QWidget *parent)
    : QWidget(parent)
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins({});
    grid->setSpacing(grid::unit);
    grid->setColumnStretch(0, 1);
    const auto button = [this](Icon icon, const QString &name, const QString &tip) {
        auto *its = describe(new QToolButton(this), name, tip);
        its->setIcon(lineIcon(icon));
        its->setAutoRaise(true);
        its->setFocusPolicy(Qt::TabFocus);
        return its;
    };
    for (const KeptFolder &folder : folders) {
        const QString shown = QDir::toNativeSeparators(folder.path);
        auto *title = new QLabel(folder.what, this);
        auto *path = describe(new QLineEdit(shown, this), folder.what, shown);
        path->setReadOnly(true);
        path->setCursorPosition(0);
        auto *open = button(Icon::open, tr("Open folder: %1").arg(folder.what),
                            tr("Opens the folder in the file manager"));
        auto *copy = button(Icon::copy, tr("Copy path: %1").arg(folder.what), tr("Copies the path"));
        connect(open, &QToolButton::clicked, this, [path = folder.path] {
            QDesktopServices::openUrl(QUrl::fromLocalFile(nearestFolder(path)));
        });
        connect(copy, &QToolButton::clicked, this, [shown] { QGuiApplication::clipboard()->setText(shown); });
        const int row = grid->rowCount();
        grid->addWidget(title, row, 0, 1, 3);
        grid->addWidget(path, row + 1, 0);
        grid->addWidget(open, row + 1, 1);
        grid->addWidget(copy, row + 1, 2);
    }
}

} // namespace codewheel
