// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/position_input.h"

#include "encoder/hex.h"
#include "widgets/look/fonts.h"
#include "widgets/look/icons.h"
#include "widgets/look/roles.h"

#include <QAction>
#include <QValidator>

namespace codewheel {
namespace {

class GoodPosition final : public QValidator
{
public:
    explicit GoodPosition(PositionInput &input)
        : QValidator(&input)
        , m_input(input)
    {}

    State validate(QString &, int &) const override { return m_input.value() ? Acceptable : Intermediate; }

private:
    const PositionInput &m_input;
};

} // namespace

PositionInput::PositionInput(std::int64_t least, std::int64_t largest, Complaint complaint, QWidget *parent)
    : QLineEdit(parent)
    , m_least(least)
    , m_largest(largest)
    , m_complaint(std::move(complaint))
    , m_mark(addAction(lineIcon(Icon::fault, Role::fault), QLineEdit::LeadingPosition))
{
    setFont(numberFont());
    setAlignment(Qt::AlignRight);
    setValidator(new GoodPosition(*this));
    m_mark->setVisible(false);
    connect(this, &QLineEdit::textChanged, this, &PositionInput::showCheck);
}

std::optional<std::int64_t> PositionInput::value() const
{
    const auto position = parseNumber(text());
    return position && *position >= m_least && *position <= m_largest ? position : std::nullopt;
}

void PositionInput::showCheck()
{
    const auto number = parseNumber(text());
    const RefusalArgument given =
        number ? RefusalArgument(*number)
               : RefusalArgument(text().trimmed().isEmpty() ? tr("nothing") : text().trimmed());
    const bool isUntouched = text().isEmpty() && !isModified();
    const QString wrong = value() || isUntouched ? QString() : m_complaint(given);
    m_mark->setVisible(!wrong.isEmpty());
    m_mark->setToolTip(wrong);
    setAccessibleDescription(wrong);
    Q_EMIT inputChecked(wrong);
}

} // namespace codewheel
