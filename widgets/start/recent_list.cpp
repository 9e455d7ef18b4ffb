// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/start/recent_list.h"

#include "widgets/look/on_event.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>

#include <algorithm>

namespace codewheel {

QString whyNotOpened(RecentFile::State state)
{
    switch (state) {
    case RecentFile::State::missing:
        return RecentList::tr("it is not there any more");
    case RecentFile::State::notReadable:
        return RecentList::tr("it may not be read");
    case RecentFile::State::silent:
        return RecentList::tr("its folder does not answer");
    case RecentFile::State::unknown:
    case RecentFile::State::there:
        break;
    }
    return {};
}

RecentList::RecentList(QWidget *parent)
    : QListWidget(parent)
{
    setTextElideMode(Qt::ElideMiddle);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setTabKeyNavigation(false);
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem *item) { open(row(item)); });
    onEvent(this, {QEvent::PaletteChange}, [this] {
        for (int row = 0; row < count(); ++row)
            show(*item(row), m_files[static_cast<std::size_t>(row)]);
    });
}

void RecentList::setFiles(const std::vector<RecentFile> &files)
{
    if (files == m_files)
        return;
    const int before = std::max(0, currentRow());
    while (count() > static_cast<int>(files.size()))
        delete takeItem(count() - 1);
    while (count() < static_cast<int>(files.size()))
        addItem(QString());
    m_files = files;
    for (int row = 0; row < count(); ++row)
        show(*item(row), files[static_cast<std::size_t>(row)]);
    setCurrentRow(std::min(before, count() - 1));
    updateGeometry();
}

// Screen readers read the text of a cell, so it includes the reason. Only the form of the path is examined:
// the disk may not answer.
void RecentList::show(QListWidgetItem &item, const RecentFile &file)
{
    const QFileInfo path(file.path);
    const QString folder = QDir::toNativeSeparators(path.path());
    const QString why = whyNotOpened(file.state);
    item.setText(path.fileName() + u'\n' + (why.isEmpty() ? folder : tr("%1: %2").arg(folder, why)));
    item.setToolTip(why.isEmpty() ? QDir::toNativeSeparators(file.path)
                                  : tr("%1: %2").arg(QDir::toNativeSeparators(file.path), why));
    item.setForeground(why.isEmpty() ? QBrush() : palette().brush(QPalette::Disabled, QPalette::Text));
}

void RecentList::open(int row)
{
    if (row < 0)
        return;
    const RecentFile &file = m_files[static_cast<std::size_t>(row)];
    if (file.canBeOpened())
        Q_EMIT openRequested(QString(file.path));
}

void RecentList::removeCurrent()
{
    if (currentRow() >= 0)
        Q_EMIT removeRequested(QString(m_files[static_cast<std::size_t>(currentRow())].path));
}

void RecentList::keyPressEvent(QKeyEvent *event)
{
    if (event->matches(QKeySequence::Delete))
        removeCurrent();
    else
        QListWidget::keyPressEvent(event);
}

void RecentList::contextMenuEvent(QContextMenuEvent *event)
{
    const int chosen =
        event->reason() == QContextMenuEvent::Keyboard ? currentRow() : indexAt(event->pos()).row();
    if (chosen < 0)
        return;
    setCurrentRow(chosen);
    const RecentFile file = m_files[static_cast<std::size_t>(chosen)];
    QMenu menu;
    QAction *toOpen = menu.addAction(tr("&Open"));
    toOpen->setEnabled(file.canBeOpened());
    QAction *toCopy = menu.addAction(tr("&Copy path"));
    QAction *toRemove = menu.addAction(tr("&Remove from the list"));
    const QPoint where = event->reason() == QContextMenuEvent::Keyboard
                             ? viewport()->mapToGlobal(visualItemRect(item(chosen)).bottomLeft())
                             : event->globalPos();
    const QAction *asked = menu.exec(where);
    if (asked == toOpen)
        open(chosen);
    else if (asked == toCopy)
        QGuiApplication::clipboard()->setText(QDir::toNativeSeparators(file.path));
    else if (asked == toRemove)
        removeCurrent();
}

QSize RecentList::sizeHint() const
{
    int height = 2 * frameWidth();
    for (int row = 0; row < count(); ++row)
        height += sizeHintForRow(row);
    return {QListWidget::sizeHint().width(), height};
}

QSize RecentList::minimumSizeHint() const
{
    return {10 * fontMetrics().averageCharWidth(), sizeHint().height()};
}

} // namespace codewheel
