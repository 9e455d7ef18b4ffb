// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

#include <functional>

namespace codewheel {

// Fields in the cells of a table. What is refused is not taken and its field stays open, with its mark, to be
// corrected; Esc gives the value before.
class CheckedDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    // What is wrong with the text for this cell; empty: nothing.
    using Complaint = std::function<QString(const QModelIndex &index, const QString &text)>;

    using QStyledItemDelegate::QStyledItemDelegate;
    // For fields that are made by Qt, of text.
    CheckedDelegate(Complaint complaint, QObject *parent);

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                          const QModelIndex &index) const override;
    void destroyEditor(QWidget *editor, const QModelIndex &index) const override;

Q_SIGNALS:
    // A sentence while what is typed is bad; empty when it is good or given up.
    void inputChecked(const QString &wrong) const;

protected:
    bool eventFilter(QObject *editor, QEvent *event) override;

private:
    Complaint m_complaint;
};

} // namespace codewheel
