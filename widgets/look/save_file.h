// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QFileDialog;
class QWidget;

namespace codewheel {

// Files that the user names to be saved, the same in all views. A name typed without a suffix gets that of
// the chosen filter, "Tables (*.csv)", before the dialog looks whether such a file is there and asks.
void setSaveFilters(QFileDialog &dialog, const QStringList &filters);

// Asks where to save; proposed: a name, or a path. Empty: the user gave up.
QString askSaveFile(QWidget *parent, const QString &title, const QString &proposed,
                    const QStringList &filters);

} // namespace codewheel
