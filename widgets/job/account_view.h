// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report.h"

#include <QWidget>

class QPlainTextEdit;
class QPushButton;

namespace codewheel {

class InlineMessage;

// What was written where, to be read, copied, and saved as text or HTML.
class AccountView : public QWidget
{
    Q_OBJECT

public:
    explicit AccountView(QWidget *parent = nullptr);

    void show(const Report &report, const QString &fileName); // without its suffix
    // HTML if the name ends so, else text. False: it could not be written, and the view says why.
    bool saveTo(const QString &path);

Q_SIGNALS:
    void saved(const QString &path);

private:
    void saveAs();
    void copy();

    Report m_report;
    QString m_fileName;
    QPlainTextEdit *m_text;
    QPushButton *m_save;
    QPushButton *m_copy;
    InlineMessage *m_message;
};

} // namespace codewheel
