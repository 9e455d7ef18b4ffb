// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "project/file_lock.h"
#include "project/project.h"
#include "vocabulary/refusal.h"

namespace codewheel {

// Keeps unsaved edits in case the program ends without asking. One object for the document of each running
// program; they share a folder and do not see each other's. Used by the window.
class Recovery
{
public:
    // The folder need not exist; it is created when there is something to keep.
    explicit Recovery(QString folder);

    // Writes down the project, with the file it belongs to (empty: never saved), the mark of what was read
    // from there or saved there (projectMark()), and the time. Nothing is written if nothing changed since
    // the last time. Refused: fileNotWritten.
    Result<void> keep(const Project &project, const QString &path, const QDateTime &at,
                      const QByteArray &mark = {});
    // There is nothing to recover: it was saved, or is not wanted.
    void drop();

private:
    Result<void> begin();

    QString m_folder;
    QString m_file; // empty: nothing kept yet
    FileLock m_lock;
    QByteArray m_kept;
    QString m_keptFor;
};

// What a program that ended without asking left behind. As long as the object lives, no other program offers
// it; what is not dropped is there again at the next start.
class LeftProject
{
public:
    const QString &path() const { return m_path; }    // the file it belongs to; empty: none
    const QByteArray &mark() const { return m_mark; } // of what its file held; empty: not known
    const QDateTime &keptAt() const { return m_at; }  // invalid if it cannot be read
    // Refused as by loadProject().
    Result<Project> load() const;
    void drop();

private:
    friend std::vector<LeftProject> leftProjects(const QString &folder);
    LeftProject(QString file, FileLock lock);

    QString m_file;
    FileLock m_lock;
    QString m_path;
    QByteArray m_mark;
    QDateTime m_at;
};

// To be called at start; the newest first.
std::vector<LeftProject> leftProjects(const QString &folder);

} // namespace codewheel
