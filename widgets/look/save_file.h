// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QFileDialog;
class QWidget;

namespace codewheel {

// Saving to a file that the user names, the same in all views. A name typed without a suffix gets that of the
// chosen filter, "Tables (*.csv)", before the dialog checks whether that file exists.
void setSaveFilters(QFileDialog &dialog, const QStringList &filters);

// Asks where to save; proposed: a name or a path. Empty: cancelled.
QString askSaveFile(QWidget *parent, const QString &title, const QString &proposed,
                    const QStringList &filters, const char *helpTopic = nullptr);

// Asks for a folder in which to save; `proposed`: where to begin. Empty: cancelled.
QString askFolder(QWidget *parent, const QString &title, const QString &proposed, const char *helpTopic);

} // namespace codewheel
