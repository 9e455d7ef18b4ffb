// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/value_field.h"

#include "widgets/input/form_focus.h"
#include "widgets/look/layouts.h"
#include "widgets/parameters/value_input.h"

#include <QComboBox>
#include <QKeyEvent>

namespace codewheel {
namespace {

// What was taken is undone by the project from here on, not letter by letter.
void forgetTyping(QLineEdit &field)
{
    const int cursor = field.cursorPosition();
    const bool isSelected = field.hasSelectedText();
    field.setText(QString(field.text()));
    if (isSelected)
        field.selectAll();
    else
        field.setCursorPosition(cursor);
}

} // namespace

ValueField::ValueField(const ParameterDescription &parameter, const QString &ifEmpty, QWidget *parent)
    : QWidget(parent)
    , m_input(makeValueInput(parameter, ifEmpty, this))
{
    m_input->setObjectName(parameterKey(parameter.parameter));
    layOutRow(this, {m_input}, {.margins = QMargins()});
    setFocusProxy(m_input);
    if (auto *number = qobject_cast<ValueInput *>(m_input)) {
        m_input->installEventFilter(this);
        connect(number, &QLineEdit::textEdited, this, [this] { m_isTyped = true; });
        connect(number, &QLineEdit::textChanged, this, [this] {
            Q_EMIT typed();
            if (!std::exchange(m_isTyped, false))
                takeTyped();
        });
        connect(number, &QLineEdit::returnPressed, this, [this] {
            takeTyped();
            Q_EMIT entered();
        });
        new FormFocus(*number, [this] { takeTyped(); });
    } else {
        connect(static_cast<QComboBox *>(m_input), &QComboBox::currentIndexChanged, this,
                &ValueField::edited);
    }
}

// The focus lost in the destructor must not count as leaving the field.
ValueField::~ValueField()
{
    m_input->disconnect(this);
}

void ValueField::setValue(const std::optional<Value> &value)
{
    const QSignalBlocker quiet(this);
    setInputValue(*m_input, value);
    if (const auto *number = qobject_cast<ValueInput *>(m_input))
        m_taken = number->text();
}

// The field handles Esc if something was typed; otherwise its surroundings do.
bool ValueField::eventFilter(QObject *input, QEvent *event)
{
    auto *number = qobject_cast<ValueInput *>(input);
    const bool gives = number != nullptr && event->type() == QEvent::KeyPress &&
                       static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape && number->text() != m_taken;
    if (!gives)
        return QWidget::eventFilter(input, event);
    number->setText(QString(m_taken));
    number->selectAll();
    return true;
}

void ValueField::takeTyped()
{
    auto *number = qobject_cast<ValueInput *>(m_input);
    if (number == nullptr)
        return;
    const QString text = number->text();
    if (!value() || signalsBlocked() || text == m_taken)
        return;
    m_taken = text;
    forgetTyping(*number);
    Q_EMIT edited();
}

bool ValueField::isBeingTyped() const
{
    const auto *number = qobject_cast<ValueInput *>(m_input);
    return number != nullptr && number->text() != m_taken;
}

Result<std::optional<Value>> ValueField::value() const
{
    return inputValue(*m_input);
}

} // namespace codewheel
