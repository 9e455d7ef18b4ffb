// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <chrono>

namespace codewheel {

// A lock between programs on the folder of a file, so that only one replaces what is there; held for moments.
// It leaves no file behind, and the system releases it however a program ends.
class FolderLock
{
public:
    static constexpr std::chrono::seconds longestWait{5};

    // Waits for others.
    explicit FolderLock(const QString &file);
    FolderLock(const FolderLock &) = delete;
    FolderLock &operator=(const FolderLock &) = delete;
    ~FolderLock();

    // Another program still has it. If the file system supports no locks nobody can have one.
    bool isRefused() const { return m_isRefused; }

private:
    int m_folder = -1;
    bool m_isRefused = false;
};

} // namespace codewheel
