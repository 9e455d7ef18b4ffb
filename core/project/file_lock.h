// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace codewheel {

// A lock between programs, held as long as the object lives. The system releases it however a program ends,
// so none is ever left behind; the empty file may be.
class FileLock
{
public:
    FileLock() = default;
    // Takes the lock if nobody has it; see isHeld().
    explicit FileLock(const QString &path);
    FileLock(FileLock &&other) noexcept;
    FileLock &operator=(FileLock &&other) noexcept;
    ~FileLock();

    bool isHeld() const { return m_file >= 0; }

private:
    int m_file = -1;
};

} // namespace codewheel
