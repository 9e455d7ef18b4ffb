// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "encoder/refusal.h"

#include <QSaveFile>

#include <optional>

namespace codewheel {

// A file in the making beside the one whose place it takes, written piece by piece, so that a large one needs
// no memory. Until replace() nothing is to be seen of it, and without it nothing is left. What fits into
// memory is saved with replaceFile() (project/file_access.h).
class FileReplacement : public QIODevice
{
    Q_OBJECT

public:
    explicit FileReplacement(const QString &path);

    QString path() const { return m_file.fileName(); }
    // From here on it can be written to. Refused as bad input: fileNotWritten. What is no file, such as a
    // device, a pipe, a socket or a loop of links, is not replaced; a link is followed.
    Result<void> begin();
    // All that was written is on the disk: fileNotWritten, with the first failure since begin(), such as a
    // disk without room.
    Result<void> bringToDisk();
    // Brought to the disk, and put in its place in one step: fileNotWritten, with what was there as it was.
    Result<void> replace();

protected:
    qint64 readData(char *bytes, qint64 largest) override;
    qint64 writeData(const char *bytes, qint64 count) override;

private:
    Result<void> noteFailure(const QString &reason);

    QSaveFile m_file;
    std::optional<Refusal> m_failure;
};

} // namespace codewheel
