// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMimeData;
class QWidget;

namespace codewheel {

// Of what kind a file is, by what it holds, whatever its name is.
enum class FileKind : std::uint8_t { project, cams, sequence, device, ofProgram, other, notReadable };
FileKind fileKind(const QString &path);

// Files that are dropped onto the window: tells what they are. What becomes of them is up to the window.
class DroppedFiles : public QObject
{
    Q_OBJECT

public:
    explicit DroppedFiles(QWidget &window);

Q_SIGNALS:
    void dropped(codewheel::FileKind kind, const QString &path);
    void refused(const QString &sentence);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void take(const QStringList &paths);
};

} // namespace codewheel
