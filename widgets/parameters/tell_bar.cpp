// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/parameters/tell_bar.h"

#include "encoder/refusal_text.h"
#include "widgets/look/grid.h"
#include "widgets/parameters/value_input.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>

namespace codewheel {

TellBar::TellBar(QWidget *parent)
    : QWidget(parent)
    , m_name(new QLabel(this))
    , m_tell(new QPushButton(tr("&Tell"), this))
    , m_cancel(new QPushButton(tr("Cancel"), this))
    , m_wrong(new QLabel(this))
{
    m_tell->setToolTip(
        tr("Takes the value as known by telling; nothing is sent. An empty field takes it back."));
    m_cancel->setToolTip(tr("Leaves what is known as it is (Esc)"));
    m_wrong->setWordWrap(true);
    auto *layout = new QGridLayout(this);
    layout->setContentsMargins(0, grid::unit, 0, 0);
    layout->addWidget(m_name, 0, 0, 1, 3);
    layout->addWidget(m_tell, 1, 1);
    layout->addWidget(m_cancel, 1, 2);
    layout->addWidget(m_wrong, 2, 0, 1, 3);
    layout->setColumnStretch(0, 1);
    connect(m_tell, &QPushButton::clicked, this, &TellBar::tell);
    connect(m_cancel, &QPushButton::clicked, this, &QWidget::hide);
    hide();
}

void TellBar::ask(const ParameterDescription &parameter, std::optional<std::int64_t> known)
{
    delete m_input;
    m_parameter = parameter.parameter;
    m_input = makeValueInput(parameter, tr("unknown"), this);
    m_input->setObjectName(QStringLiteral("toldValue"));
    setInputValue(*m_input, known);
    m_name->setText(tr("%1: the encoder has", "parameter name").arg(parameterName(m_parameter)));
    m_name->setBuddy(m_input);
    m_wrong->hide();
    m_tell->setEnabled(true);
    static_cast<QGridLayout *>(layout())->addWidget(m_input, 1, 0);
    setTabOrder(m_input, m_tell);
    if (auto *number = qobject_cast<NumberInput *>(m_input))
        connect(number, &NumberInput::inputChecked, this, [this](const QString &wrong) {
            m_wrong->setText(wrong);
            m_wrong->setVisible(!wrong.isEmpty());
            m_tell->setEnabled(wrong.isEmpty());
        });
    show();
    m_input->setFocus();
}

void TellBar::tell()
{
    if (const auto value = inputValue(*m_input)) {
        hide();
        Q_EMIT told(m_parameter, *value);
    }
}

void TellBar::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        tell();
        break;
    case Qt::Key_Escape:
        hide();
        break;
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace codewheel
