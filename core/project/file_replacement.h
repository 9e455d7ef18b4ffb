// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "vocabulary/refusal.h"

#include <QSaveFile>

#include <optional>

namespace codewheel {

// A file being written beside the one it replaces, piece by piece, so that a large one needs no memory. Until
// replace() nothing can be seen of it, and without it nothing is left. What fits into memory is saved with
// replaceFile() (project/file_access.h).
class FileReplacement : public QIODevice
{
    Q_OBJECT

public:
    explicit FileReplacement(const QString &path);

    QString path() const { return m_file.fileName(); }
    // From here on it can be written to. Refused as bad input: fileNotWritten. Anything but a regular file,
    // such as a device, a pipe, a socket or a loop of links, is not replaced; a link is followed.
    Result<void> begin();
    // Everything written is on the disk: fileNotWritten, with the first failure since begin(), such as a full
    // disk.
    Result<void> bringToDisk();
    // Written to the disk and put in its place in one step: fileNotWritten, leaving what was there.
    Result<void> replace();

protected:
    qint64 readData(char * /*bytes*/, qint64 /*largest*/) override { return -1; }
    qint64 writeData(const char *bytes, qint64 count) override;

private:
    Result<void> noteFailure(const QString &reason);

    QSaveFile m_file;
    std::optional<Refusal> m_failure;
};

} // namespace codewheel
