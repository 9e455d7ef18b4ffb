// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/cams/position_input.h"

#include "widgets/input/decimal_text.h"
#include "widgets/look/fonts.h"

#include <QLocale>
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
    , m_mark(*this)
{
    setFont(numberFont());
    setAlignment(Qt::AlignRight);
    setValidator(new GoodPosition(*this));
    connect(this, &QLineEdit::textChanged, this, &PositionInput::showCheck);
}

std::optional<std::int64_t> PositionInput::value() const
{
    const auto position = readWhole(text());
    return position && *position >= m_least && *position <= m_largest ? std::optional(*position)
                                                                      : std::nullopt;
}

QString PositionInput::complaint() const
{
    const bool isEmpty = text().trimmed().isEmpty();
    if (value() || (isEmpty && !isModified()))
        return {};
    const auto number = readWhole(text());
    if (!number && !isEmpty)
        return number.error();
    return m_complaint(number ? RefusalArgument(*number) : RefusalArgument(tr("nothing")));
}

void PositionInput::showCheck()
{
    const QString wrong = complaint();
    m_mark.show(wrong);
    Q_EMIT inputChecked(wrong);
}

} // namespace codewheel
