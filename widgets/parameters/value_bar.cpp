// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/value_bar.h"

#include "vocabulary/refusal_text.h"
#include "widgets/look/describe.h"
#include "widgets/look/grid.h"
#include "widgets/look/wrapped_label.h"
#include "widgets/parameters/value_input.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QPushButton>

namespace codewheel {

ValueBar::ValueBar(QWidget *parent)
    : QWidget(parent)
    , m_name(new QLabel(this))
    , m_take(named(new QPushButton(this), "takeValue"))
    , m_cancel(new QPushButton(tr("Cancel"), this))
    , m_wrong(wrappedLabel(this))
{
    m_take->hide(); // until it is known what it does
    m_cancel->setToolTip(tr("Leaves everything unchanged (Esc)"));
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, grid::unit, 0, 0);
    layout->addWidget(m_name, 0, 0, 1, 3);
    layout->addWidget(m_take, 1, 1);
    layout->addWidget(m_cancel, 1, 2);
    layout->addWidget(m_wrong, 2, 0, 1, 3);
    layout->setColumnStretch(0, 1);
    connect(m_take, &QPushButton::clicked, this, &ValueBar::answer);
    connect(m_cancel, &QPushButton::clicked, this, &QWidget::hide);
    hide();
}

void ValueBar::ask(Question question, const std::optional<Value> &value)
{
    delete m_input;
    m_question = std::move(question);
    m_input = makeValueInput(m_question.parameter, m_question.ifEmpty, this);
    m_input->setObjectName(QStringLiteral("toldValue"));
    setInputValue(*m_input, value);
    m_name->setText(m_question.label);
    m_name->setBuddy(m_input);
    m_take->setText(m_question.button);
    m_take->setToolTip(m_question.toolTip);
    m_take->show();
    static_cast<QGridLayout *>(layout())->addWidget(m_input, 1, 0);
    setTabOrder(m_input, m_take);
    if (auto *number = qobject_cast<ValueInput *>(m_input))
        connect(number, &ValueInput::inputChecked, this, &ValueBar::checkInput);
    checkInput();
    show();
    m_input->setFocus();
}

void ValueBar::checkInput()
{
    const auto value = inputValue(*m_input);
    m_wrong->setText(value ? QString() : refusalText(value.error()));
    m_wrong->setVisible(!value);
    m_take->setEnabled(value && (*value || m_question.mayBeEmpty));
}

void ValueBar::answer()
{
    const auto value = inputValue(*m_input);
    if (!value || !(*value || m_question.mayBeEmpty))
        return;
    hide();
    m_question.answered(*value);
}

void ValueBar::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        answer();
        break;
    case Qt::Key_Escape:
        hide();
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace codewheel
