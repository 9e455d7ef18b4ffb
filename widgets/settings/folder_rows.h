// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include <vector>

namespace codewheel {

// What is kept, and where.
struct KeptFolder
{
    QString what;
    QString path;
};

// Folders, each of which can be opened, or its path copied.
class FolderRows : public QWidget
{
    Q_OBJECT

public:
    explicit FolderRows(const std::vector<KeptFolder> &folders, QWidget *parent = nullptr);
};

} // namespace codewheel
