// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/window/support_files.h"

#include <QDialog>

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace codewheel {

class InlineMessage;

// Help > Collect for support: what will be given away, each file with its size and to be looked at, with what
// is not to be in it left out, and then saved as one zip.
class SupportDialog : public QDialog
{
    Q_OBJECT

public:
    SupportDialog(std::vector<SupportFile> files, QWidget *parent);

    // Asks where. The dialog stays when it could not be saved, and says why.
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
    QTreeWidget *m_list; // rows as m_files
    QPlainTextEdit *m_content;
    QLabel *m_total;
    InlineMessage *m_message;
    QPushButton *m_save = nullptr;
};

} // namespace codewheel
