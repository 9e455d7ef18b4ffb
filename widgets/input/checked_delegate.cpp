// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/input/checked_delegate.h"

#include "widgets/input/form_focus.h"
#include "widgets/input/input_mark.h"

#include <QAbstractItemView>
#include <QApplication>
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

CheckedDelegate::CheckedDelegate(QObject *parent)
    : CheckedDelegate(Complaint(), parent)
{}

CheckedDelegate::CheckedDelegate(Complaint complaint, QObject *parent)
    : QStyledItemDelegate(parent)
    , m_complaint(std::move(complaint))
{
    // Before the view closes it.
    connect(this, &QAbstractItemDelegate::closeEditor, this,
            [this](QWidget *editor) { m_taken = qobject_cast<QLineEdit *>(editor); });
}

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

// Its complaint is dropped with it.
void CheckedDelegate::destroyEditor(QWidget *editor, const QModelIndex &index) const
{
    Q_EMIT inputChecked({});
    QStyledItemDelegate::destroyEditor(editor, index);
}

bool CheckedDelegate::eventFilter(QObject *object, QEvent *event)
{
    if (qobject_cast<QAbstractItemView *>(object) || qobject_cast<QAbstractItemView *>(object->parent()))
        return isHeldOff(event->type());
    auto *field = qobject_cast<QLineEdit *>(object);
    if (event->type() == QEvent::Show && field != nullptr) {
        m_open = field;
        field->parent()->installEventFilter(this);
        field->parent()->parent()->installEventFilter(this);
        new FormFocus(*field, [this, field] { takeWaiting(*field); });
    }
    if (event->type() == QEvent::FocusOut && field != nullptr) {
        if (field->window()->isHidden()) // it closes with its window, rather than being left
            return true;
        if (!field->hasAcceptableInput())
            return false;
        if (field->isModified() && !isInSameForm(*field, QApplication::focusWidget()))
            return false; // it waits: Qt would take it for whatever is chosen elsewhere
    }
    return QStyledItemDelegate::eventFilter(object, event);
}

// The focus has come back to its form. Closing a field that has the focus moves it, and would take it again.
void CheckedDelegate::takeWaiting(QLineEdit &field)
{
    if (m_taken == &field || !field.isVisible() || !field.hasAcceptableInput())
        return;
    m_taken = &field;
    Q_EMIT commitData(&field);
    Q_EMIT closeEditor(&field);
}

// The view would close the field for another cell, and what was typed would be lost.
bool CheckedDelegate::isHeldOff(QEvent::Type type) const
{
    const bool choosesAnother =
        type == QEvent::MouseButtonPress || type == QEvent::MouseButtonDblClick || type == QEvent::KeyPress;
    if (!choosesAnother || !m_open || m_open->hasAcceptableInput())
        return false;
    m_open->setFocus();
    return true;
}

} // namespace codewheel
