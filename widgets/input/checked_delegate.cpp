// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/checked_delegate.h"

#include "widgets/input/input_mark.h"

#include <QEvent>
#include <QLineEdit>
#include <QPersistentModelIndex>
#include <QValidator>

#include <memory>

namespace codewheel {
namespace {

class GoodText final : public QValidator
{
public:
    GoodText(std::function<QString(const QString &)> complaint, QObject *parent)
        : QValidator(parent)
        , m_complaint(std::move(complaint))
    {}

    State validate(QString &text, int &) const override
    {
        return m_complaint(text).isEmpty() ? Acceptable : Intermediate;
    }

private:
    std::function<QString(const QString &)> m_complaint;
};

} // namespace

CheckedDelegate::CheckedDelegate(Complaint complaint, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_complaint(std::move(complaint))
{}

QWidget *CheckedDelegate::createEditor(QWidget *parent, const QStyleOptionViewItem &option,
                                       const QModelIndex &index) const
{
    QWidget *editor = QStyledItemDelegate::createEditor(parent, option, index);
    auto *field = qobject_cast<QLineEdit *>(editor);
    if (field == nullptr || !m_complaint)
        return editor;
    const auto complaint = [this, cell = QPersistentModelIndex(index)](const QString &text) {
        return cell.isValid() ? m_complaint(cell, text) : QString();
    };
    field->setValidator(new GoodText(complaint, field));
    auto mark = std::make_shared<InputMark>(*field);
    connect(field, &QLineEdit::textEdited, this, [this, mark, complaint](const QString &text) {
        const QString wrong = complaint(text);
        mark->show(wrong);
        Q_EMIT inputChecked(wrong);
    });
    return editor;
}

// What was wrong in it is given up with it.
void CheckedDelegate::destroyEditor(QWidget *editor, const QModelIndex &index) const
{
    Q_EMIT inputChecked({});
    QStyledItemDelegate::destroyEditor(editor, index);
}

bool CheckedDelegate::eventFilter(QObject *editor, QEvent *event)
{
    const auto *field = qobject_cast<QLineEdit *>(editor);
    if (event->type() == QEvent::FocusOut && field != nullptr) {
        if (field->window()->isHidden()) // it goes with its window, and is not left
            return true;
        if (!field->hasAcceptableInput())
            return false;
    }
    return QStyledItemDelegate::eventFilter(editor, event);
}

} // namespace codewheel
