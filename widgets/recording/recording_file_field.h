// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/input/form_fields.h"
#include "widgets/input/input_mark.h"

#include <QLineEdit>

class QLabel;

namespace codewheel {

// The file of a recording that is to be made: says at once where it cannot be.
class RecordingFileField : public QWidget, public FormField
{
    Q_OBJECT

public:
    explicit RecordingFileField(QWidget *parent);

    QLineEdit &line() { return *m_line; }
    QString file() const; // in full, with a suffix
    // A name that is not taken, in that folder.
    void propose(const QString &folder, const QDateTime &now);
    QString complaint() const; // a sentence; empty: it can be made there
    QString takeTyped() override { return complaint(); }

Q_SIGNALS:
    void changed();

private:
    void check();
    void browse();

    QString m_folder; // of a name without one
    QLineEdit *m_line;
    InputMark m_mark;
    QLabel *m_wrong;
};

} // namespace codewheel
