// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/files/dropped_files.h"

#include "journal/open_file.h"
#include "project/file_access.h"

#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QRegularExpression>
#include <QUrl>
#include <QWidget>

namespace codewheel {
namespace {

constexpr qint64 largestDropped = 50'000'000; // bytes, more than any file of the program

QStringList localFiles(const QMimeData &data)
{
    QStringList files;
    for (const QUrl &url : data.urls())
        if (url.isLocalFile())
            files << url.toLocalFile();
    return files;
}

bool holds(const QByteArray &text, const char *pattern)
{
    return QRegularExpression(QString::fromLatin1(pattern)).match(QString::fromUtf8(text)).hasMatch();
}

// Any other one is refused when it is opened. One that this program has open must not be opened here.
bool isDatabase(const QString &path)
{
    static constexpr QByteArrayView mark("SQLite format 3");
    const auto beginning = OpenFile::beginning(OpenFile::turn(), path, mark.size());
    const bool isNamedSo = QFileInfo(path).suffix() == QStringLiteral("cwrec");
    return isNamedSo || (beginning && *beginning == mark);
}

} // namespace

// Looks only at its marks: whoever opens it says what is wrong with the rest, and where.
FileKind fileKind(const QString &path)
{
    if (isDatabase(path))
        return FileKind::recording;
    const auto text = readWholeFile(path, largestDropped);
    if (!text)
        return FileKind::notReadable;
    const auto isFormat = [&](const char *name) {
        return holds(*text, (QByteArray(R"("format"\s*:\s*"codewheel-)") + name + '"').constData());
    };
    if (isFormat("project"))
        return FileKind::project;
    if (isFormat("cams"))
        return FileKind::cams;
    if (isFormat("sequence"))
        return FileKind::sequence;
    if (isFormat("faults"))
        return FileKind::faultPlan;
    if (isFormat("[a-z-]+"))
        return FileKind::ofProgram;
    if (holds(*text, R"("vendor"\s*:)") && holds(*text, R"("profile"\s*:)"))
        return FileKind::device;
    return QFileInfo(path).suffix() == QStringLiteral("codewheel") ? FileKind::project : FileKind::other;
}

DroppedFiles::DroppedFiles(QWidget &window)
    : QObject(&window)
{
    window.setAcceptDrops(true);
    window.installEventFilter(this);
}

bool DroppedFiles::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() != QEvent::DragEnter && event->type() != QEvent::Drop)
        return QObject::eventFilter(watched, event);
    auto *drop = static_cast<QDropEvent *>(event);
    const QStringList paths = localFiles(*drop->mimeData());
    if (paths.isEmpty())
        return QObject::eventFilter(watched, event);
    drop->setDropAction(Qt::CopyAction); // the file stays where it is
    drop->accept();
    if (event->type() == QEvent::Drop) // questions come once the other program has been released
        QMetaObject::invokeMethod(
            this, [this, paths] { take(paths); }, Qt::QueuedConnection);
    return true;
}

void DroppedFiles::take(const QStringList &paths)
{
    const QString name = QFileInfo(paths.front()).fileName();
    if (paths.size() > 1) {
        Q_EMIT refused(
            tr("%n files were dropped. Drop one at a time.", nullptr, static_cast<int>(paths.size())));
        return;
    }
    const FileKind kind = fileKind(paths.front());
    if (kind == FileKind::notReadable)
        Q_EMIT refused(tr("%1 cannot be read.").arg(name));
    else if (kind == FileKind::ofProgram)
        Q_EMIT refused(tr("%1 is a Codewheel file, but not one that can be opened by dropping it. Projects, "
                          "cams, sequences, fault plans, device descriptions and recordings can.")
                           .arg(name));
    else if (kind == FileKind::other)
        Q_EMIT refused(tr("%1 cannot be dropped here. Projects, cams, sequences, fault plans, device "
                          "descriptions and recordings can.")
                           .arg(name));
    else
        Q_EMIT dropped(kind, paths.front());
}

} // namespace codewheel
