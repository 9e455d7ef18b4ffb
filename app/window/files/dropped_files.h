// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace codewheel {

// The kind of a file by its content, whatever its name.
enum class FileKind : std::uint8_t {
    project,
    cams,
    sequence,
    device,
    recording,
    faultPlan,
    ofProgram,
    other,
    notReadable
};
FileKind fileKind(const QString &path);

// Files dropped onto the window: determines what they are. The window decides what to do with them.
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
