// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/files/support_files.h"

#include <QDialog>

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace codewheel {

class InlineMessage;

// Help > Collect for support: shows what will be given away, each file with its size and a preview, lets the
// user leave files out, and saves the rest as one zip.
class SupportDialog : public QDialog
{
    Q_OBJECT

public:
    SupportDialog(std::vector<SupportFile> files, QWidget *parent);

    // Asks where to save. If that fails, the dialog stays and says why.
    void askWhere();
    bool saveTo(const QString &path);

Q_SIGNALS:
    void saved(const QString &path);

private:
    QTreeWidget *makeList();
    void layOutParts(QWidget *buttons);
    std::vector<ZipEntry> chosen() const;
    void showChosen();
    void look();

    const std::vector<SupportFile> m_files;
    QPlainTextEdit *m_note;
    QTreeWidget *m_list; // parallel to m_files
    QPlainTextEdit *m_content;
    QLabel *m_total;
    InlineMessage *m_message;
    QPushButton *m_save = nullptr;
};

} // namespace codewheel
