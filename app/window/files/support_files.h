// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/files/zip_file.h"

#include <QStringList>

#include <vector>

namespace codewheel {

class MessageModel;
class Plant;
class ProjectDocument;
class TraceView;

// A file for support: what it contains, in the user's language.
struct SupportFile
{
    ZipEntry file;
    QString what;
};

struct SupportSources
{
    const ProjectDocument &project;
    const Plant &plant;
    const MessageModel &messages;
    const TraceView &traces;
};

// Everything of use to support, as of now: the project with unsaved changes, the newest messages, the traces,
// versions, adapters and buses. Names of the user, the computer and the home folder are removed.
std::vector<SupportFile> supportFiles(const SupportSources &sources);

} // namespace codewheel
