// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QLineEdit>
#include <QPointer>
#include <QStyledItemDelegate>

#include <functional>

namespace codewheel {

// Fields in the cells of a table. Refused input is not taken and its field stays open, marked, to be
// corrected, whatever else in the table is clicked; Esc restores the previous value. What is being typed
// while the focus goes to another page or panel waits, until it comes back to this one.
class CheckedDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    // What is wrong with the text for this cell; empty: nothing is.
    using Complaint = std::function<QString(const QModelIndex &index, const QString &text)>;

    explicit CheckedDelegate(QObject *parent = nullptr);
    // For text fields made by Qt.
    CheckedDelegate(Complaint complaint, QObject *parent);

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;
    void destroyEditor(QWidget *editor, const QModelIndex &index) const override;

Q_SIGNALS:
    // A sentence while what is typed is bad; empty when it is good or given up.
    void inputChecked(const QString &wrong) const;

protected:
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    bool isHeldOff(QEvent::Type type) const;
    void takeWaiting(QLineEdit &field);

    Complaint m_complaint;
    QPointer<QLineEdit> m_open;  // the field that was opened last
    QPointer<QLineEdit> m_taken; // until it is gone
};

} // namespace codewheel
